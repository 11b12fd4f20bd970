// Input of plane failure: slope, failure plane, crack, strength, water and loads.
//
// Section, per metre run. Origin at the toe, x into the slope, y up. The face rises from the toe to the crest, an
// optional bench follows, then the upper surface. The failure plane dips out of the slope; it daylights at the toe
// unless `daylight_height` is given. Sliding is towards -x.
#pragma once

#include "parameters/fields.hpp"
#include "parameters/lengths.hpp"
#include "strength/strength.hpp"
#include "support/bolt_pattern.hpp"
#include "water/water.hpp"

#include <optional>
#include <variant>
#include <vector>

namespace delabole {

template <class T = double>
struct Bench {
    T width;
    T dip;
    static constexpr auto fields() {
        return FieldTable{number<&Bench::width>(Dimension::length, extent_range(), "horizontal width from the crest"),
                          number<&Bench::dip>(Dimension::angle, within(degrees(-60), degrees(89)),
                                              "inclination, positive rising into the slope")};
    }
};

template <class T = double>
struct SlopeSection {
    T height;
    T face_dip;
    T upper_surface_dip;
    std::optional<Bench<T>> bench;
    std::optional<T> toe_elevation;
    static constexpr auto fields() {
        return FieldTable{
            number<&SlopeSection::height>(Dimension::length, extent_range(), "vertical height, toe to crest"),
            number<&SlopeSection::face_dip>(Dimension::angle, left_open(0, degrees(90)), "dip of the face"),
            number<&SlopeSection::upper_surface_dip>(
                Dimension::angle, within(degrees(-60), degrees(89)),
                "inclination of the ground behind the crest (behind the bench, if there is one), positive rising"),
            section<&SlopeSection::bench>("bench between crest and upper surface; absent: none"),
            number<&SlopeSection::toe_elevation>(Dimension::length, position_range(),
                                                 "elevation of the toe; needed only where elevations are given")};
    }
};

template <class T = double>
struct FailurePlane {
    T dip;
    std::optional<T> daylight_height;
    static constexpr auto fields() {
        return FieldTable{
            number<&FailurePlane::dip>(Dimension::angle, between(0, degrees(90)), "dip of the failure plane"),
            number<&FailurePlane::daylight_height>(
                Dimension::length, distance_range(),
                "height above the toe at which the plane meets the face; absent: at the toe")};
    }
};

template <class T = double>
struct CrackAtDistance {
    T distance_behind_crest;
    static constexpr auto fields() {
        return FieldTable{number<&CrackAtDistance::distance_behind_crest>(
            Dimension::length, position_range(), "horizontal distance from crest to crack top; negative in the face")};
    }
};

template <class T = double>
struct CrackOfDepth {
    T depth;
    static constexpr auto fields() {
        return FieldTable{number<&CrackOfDepth::depth>(Dimension::length, distance_range(),
                                                       "vertical depth of a crack whose top lies behind the crest")};
    }
};

// The z of Hoek & Bray's closed forms; for a crack in the face this is not the depth of the crack itself.
template <class T = double>
struct CrackBaseBelowCrest {
    T base_below_crest;
    static constexpr auto fields() {
        return FieldTable{number<&CrackBaseBelowCrest::base_below_crest>(
            Dimension::length, position_range(), "vertical distance from crest level down to the bottom of the crack")};
    }
};

template <class T = double>
struct CrackBaseElevation {
    T base_elevation;
    static constexpr auto fields() {
        return FieldTable{number<&CrackBaseElevation::base_elevation>(
            Dimension::length, position_range(),
            "elevation of the bottom of the crack, in the datum of slope.toe_elevation")};
    }
};

template <class T = double>
using CrackPosition = std::variant<CrackAtDistance<T>, CrackOfDepth<T>, CrackBaseBelowCrest<T>, CrackBaseElevation<T>>;

template <class T = double>
struct TensionCrack {
    T dip;
    CrackPosition<T> position;
    static constexpr auto fields() {
        return FieldTable{
            number<&TensionCrack::dip>(Dimension::angle, between(0, degrees(150)),
                                       "dip of the crack, 90 deg vertical, below 90 deg dipping like the plane"),
            inlined(&TensionCrack::position, "where the crack is")};
    }
};

template <class T = double>
struct Rock {
    T unit_weight;
    static constexpr auto fields() {
        return FieldTable{
            number<&Rock::unit_weight>(Dimension::unit_weight, more_than(0), "unit weight of the rock mass")};
    }
};

template <class T = double>
struct TensionCutoff {
    T tensile_strength;
    static constexpr auto fields() {
        return FieldTable{number<&TensionCutoff::tensile_strength>(
            Dimension::stress, at_least(0), "normal tension that the plane bears; under more the mass lifts off")};
    }
};

template <class T = double>
struct SeismicLoad {
    T horizontal_coefficient;
    T vertical_coefficient;
    static constexpr auto fields() {
        return FieldTable{
            number<&SeismicLoad::horizontal_coefficient>(within(-5, 5),
                                                         "inertia force over weight, positive out of the slope"),
            number<&SeismicLoad::vertical_coefficient>(within(-5, 5), "inertia force over weight, positive downwards")};
    }
};

// Vertical pressure on the ground behind the crest; only its part on the sliding mass acts.
template <class T = double>
struct Surcharge {
    T pressure;
    T from_distance;
    T to_distance;
    static constexpr auto fields() {
        return FieldTable{
            number<&Surcharge::pressure>(Dimension::stress, "vertical force per horizontal area, positive downwards"),
            number<&Surcharge::from_distance>(Dimension::length, distance_range(),
                                              "horizontal distance behind the crest where it begins"),
            number<&Surcharge::to_distance>(Dimension::length, distance_range(),
                                            "horizontal distance behind the crest where it ends")};
    }
};

// A line load on the ground behind the crest; it acts only if it stands on the sliding mass.
template <class T = double>
struct LineLoad {
    T force;
    T plunge;
    T distance_behind_crest;
    static constexpr auto fields() {
        return FieldTable{number<&LineLoad::force>(Dimension::force_per_length, at_least(0), "force"),
                          number<&LineLoad::plunge>(
                              Dimension::angle, within(degrees(-90), degrees(270)),
                              "direction below the horizontal, measured from into-the-slope; 90 deg is vertical"),
                          number<&LineLoad::distance_behind_crest>(Dimension::length, distance_range(),
                                                                   "horizontal distance behind the crest")};
    }
};

template <class Bolts>
constexpr auto bolt_action_field() {
    return section<&Bolts::action>(
        "active: tensioned, reduces the driving force; passive: mobilised by movement, adds to resistance");
}

template <class T = double>
struct Bolt {
    T force;
    T plunge;
    T head_height;
    BoltAction action;
    static constexpr auto fields() {
        return FieldTable{
            number<&Bolt::force>(Dimension::force_per_length, at_least(0), "tension"),
            number<&Bolt::plunge>(Dimension::angle, within(degrees(-90), degrees(90)),
                                  "direction below the horizontal, into the slope; negative: inclined upwards"),
            number<&Bolt::head_height>(
                Dimension::length, distance_range(),
                "height of its head on the face above the toe; from there it has to run through the moving mass into "
                "the rock behind"),
            bolt_action_field<Bolt>()};
    }
};

// Rows of bolts from the face through the plane or the crack.
template <class T = double>
struct PlaneSupport {
    BoltPattern<T> pattern;
    BoltAction action;
    static constexpr auto fields() {
        return FieldTable{inlined(&PlaneSupport::pattern, "the bolts"), bolt_action_field<PlaneSupport>()};
    }
};

template <class T = double>
struct PlaneFailure {
    SlopeSection<T> slope;
    FailurePlane<T> failure_plane;
    std::optional<TensionCrack<T>> tension_crack;
    Rock<T> rock;
    StrengthLaw<T> strength;
    std::optional<TensionCutoff<T>> tension_cutoff;
    Water<T> water;
    std::optional<Pond<T>> pond;
    std::optional<SeismicLoad<T>> seismic;
    std::vector<Surcharge<T>> surcharge;
    std::vector<LineLoad<T>> line_load;
    std::vector<Bolt<T>> bolt;
    std::vector<PlaneSupport<T>> support;

    static constexpr std::string_view kind = "plane_failure";
    static constexpr auto fields() {
        return FieldTable{section<&PlaneFailure::slope>("the ground surface"),
                          section<&PlaneFailure::failure_plane>("the surface on which the mass slides"),
                          section<&PlaneFailure::tension_crack>("crack that cuts the mass off; absent: none"),
                          section<&PlaneFailure::rock>("the rock mass"),
                          section<&PlaneFailure::strength>("shear strength of the failure plane"),
                          section<&PlaneFailure::tension_cutoff>(
                              "normal tension that the plane bears; absent: none, so that a mass lifts off where "
                              "loads pull it away from the plane"),
                          section<&PlaneFailure::water>("water pressure in the crack and on the plane"),
                          section<&PlaneFailure::pond>("standing water in front of the face; absent: none"),
                          section<&PlaneFailure::seismic>("pseudo-static earthquake load; absent: none"),
                          section<&PlaneFailure::surcharge>("strip loads behind the crest"),
                          section<&PlaneFailure::line_load>("line loads behind the crest"),
                          section<&PlaneFailure::bolt>("bolts and cables through the plane"),
                          section<&PlaneFailure::support>("patterns of bolts: rows, spacing, length, capacity")};
    }
};

}  // namespace delabole
