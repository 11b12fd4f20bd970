// Shear strength of a joint: shear stress at failure as a function of effective normal stress, both in Pa.
//
// Linear laws (Coulomb, stepped surface) are written tau = c + sigma tan(phi); the others are curved and are evaluated
// at the mean effective normal stress of the surface, as plane-failure analysis needs one stress per surface.
//
// Sources: Patton (1966); Barton & Choubey (1977), Barton & Bandis (1990); power curve after Hoek (1983) in a
// dimensionless form; stepped surface phi_e = phi + i, thesis section 2.3.2 (c).
#pragma once

#include "parameters/fields.hpp"

#include <string_view>
#include <variant>

namespace delabole {

template <class T = double>
struct Coulomb {
    T cohesion;
    T friction_angle;

    static constexpr std::string_view kind = "coulomb";
    static constexpr auto fields() {
        return FieldTable{
            number<&Coulomb::cohesion>(Dimension::stress, at_least(0), "apparent cohesion"),
            number<&Coulomb::friction_angle>(Dimension::angle, within(0, degrees(89.9)), "angle of friction")};
    }
};

// A surface stepped or rough at angle i to its mean plane: friction angle phi_e = phi + i on the mean plane.
template <class T = double>
struct SteppedSurface {
    T cohesion;
    T friction_angle;
    T roughness_angle;

    static constexpr std::string_view kind = "stepped_surface";
    static constexpr auto fields() {
        return FieldTable{
            number<&SteppedSurface::cohesion>(Dimension::stress, at_least(0), "apparent cohesion"),
            number<&SteppedSurface::friction_angle>(Dimension::angle, within(0, degrees(89.9)),
                                                    "angle of friction of the steps themselves"),
            number<&SteppedSurface::roughness_angle>(
                Dimension::angle, within(0, degrees(89.9)),
                "angle i between the steps and the mean plane; friction_angle + roughness_angle must stay below 90 "
                "deg")};
    }
};

// Patton: riding over asperities at phi + i up to a transition stress, shearing through them at phi above it, with the
// cohesion intercept that makes the envelope continuous.
template <class T = double>
struct PattonBilinear {
    T friction_angle;
    T roughness_angle;
    T transition_stress;

    static constexpr std::string_view kind = "patton_bilinear";
    static constexpr auto fields() {
        return FieldTable{number<&PattonBilinear::friction_angle>(Dimension::angle, within(0, degrees(89.9)),
                                                                  "angle of friction once asperities are sheared"),
                          number<&PattonBilinear::roughness_angle>(
                              Dimension::angle, within(0, degrees(89.9)),
                              "asperity angle i; friction_angle + roughness_angle must stay below 90 deg"),
                          number<&PattonBilinear::transition_stress>(Dimension::stress, at_least(0),
                                                                     "normal stress at which asperities shear")};
    }
};

// tau = sigma tan(phi_r + JRC log10(JCS / sigma)), with the angle limited to 70 deg, as Barton (1976) advises for low
// stress, and to phi_r above sigma = JCS.
template <class T = double>
struct BartonBandis {
    T residual_friction_angle;
    T joint_roughness_coefficient;
    T joint_wall_strength;

    static constexpr std::string_view kind = "barton_bandis";
    static constexpr auto fields() {
        return FieldTable{
            number<&BartonBandis::residual_friction_angle>(Dimension::angle, within(0, degrees(70)),
                                                           "residual angle of friction"),
            number<&BartonBandis::joint_roughness_coefficient>(within(0, 20), "JRC at the scale of the surface"),
            number<&BartonBandis::joint_wall_strength>(Dimension::stress, more_than(0),
                                                       "JCS at the scale of the surface")};
    }
};

// tau = c + a p ((sigma + d) / p)^b, p a reference stress that makes a and b dimensionless.
template <class T = double>
struct PowerCurve {
    T coefficient;
    T exponent;
    T reference_stress;
    T stress_offset;
    T cohesion;

    static constexpr std::string_view kind = "power_curve";
    static constexpr auto fields() {
        return FieldTable{
            number<&PowerCurve::coefficient>(at_least(0), "multiplier a"),
            number<&PowerCurve::exponent>(within(0.01, 1), "exponent b"),
            number<&PowerCurve::reference_stress>(Dimension::stress, more_than(0),
                                                  "stress p by which stresses are divided before the power is taken"),
            number<&PowerCurve::stress_offset>(Dimension::stress, at_least(0), "stress d added to the normal stress"),
            number<&PowerCurve::cohesion>(Dimension::stress, at_least(0), "cohesion added to the curve")};
    }
};

template <class T = double>
using StrengthLaw = std::variant<Coulomb<T>, SteppedSurface<T>, PattonBilinear<T>, BartonBandis<T>, PowerCurve<T>>;

}  // namespace delabole
