// Force balance of the sliding mass and its factor of safety.
//
//     FS = (tau(N / A) A + passive bolts) / S, not below 0
//     N = W (1 + k_v) cos p - W k_h sin p - U - V cos(t - p) + F cos(f - p) + loads and bolts normal to the plane
//     S = W (1 + k_v) sin p + W k_h cos p + V sin(t - p) - F sin(f - p) + loads and active bolts down the plane
//
// W weight, U water force on the base, V in the crack, F of the pond on the face; p, t, f the dips of plane, crack and
// face; A the base length. With Coulomb strength, a vertical crack and no other loads this is Hoek & Bray's equation as
// printed in the thesis, 2.3.2 (c). If S is not positive, no force drives the mass: FS is infinite. If N / A is a
// tension beyond the tensile strength, 0 unless it is given, the mass lifts off: FS is 0, whatever S and passive bolts.
//
// Accuracy: N and S are sums that may cancel; their absolute error is a few units in the last place of the sum of the
// magnitudes of their terms.
#pragma once

#include "plane_failure/bolts_in_ground.hpp"
#include "plane_failure/water_force.hpp"
#include "strength/shear_strength.hpp"

#include <limits>

namespace delabole {

template <class T>
struct Stability {
    T factor_of_safety;
    T weight;
    T normal_force;     // effective, on the base
    T driving_force;    // down the plane
    T resisting_force;  // strength of the base plus passive bolts
    bool lifted;        // off the base, which bears no such tension
};

namespace detail {

// A force by its components into the slope and upwards.
template <class T>
struct Force {
    T x;
    T y;
};

template <class T>
Force<T> plunging_force(const T& magnitude, const T& plunge) {
    const SineCosine<T> direction = sine_cosine(plunge);
    return {T(magnitude * direction.cosine), T(-magnitude * direction.sine)};
}

template <class T>
T into_plane(const Force<T>& force, const SineCosine<T>& plane) {
    return T(force.x * plane.sine - force.y * plane.cosine);
}

template <class T>
T down_plane(const Force<T>& force, const SineCosine<T>& plane) {
    return T(-force.x * plane.cosine - force.y * plane.sine);
}

// Horizontal length of a surcharge that lies on the mass.
template <class T>
T loaded_length(const Surcharge<T>& surcharge, const Wedge<T>& wedge) {
    const T mass_end = wedge.crack_top_x - wedge.crest_x;
    const T end = surcharge.to_distance < mass_end ? surcharge.to_distance : mass_end;
    return end > surcharge.from_distance ? T(end - surcharge.from_distance) : T(0);
}

template <class T>
bool stands_on_mass(const LineLoad<T>& load, const Wedge<T>& wedge) {
    return load.distance_behind_crest <= wedge.crack_top_x - wedge.crest_x;
}

// Length along the bolt from its head on the face to the plane, or to the crack behind it; negative if it meets
// neither.
template <class T>
T length_in_mass(const Wedge<T>& wedge, const T& head_height, const T& plunge) {
    const SineCosine<T> bolt = sine_cosine(plunge);
    const T y = head_height - wedge.daylight_height;
    const T x = y * wedge.face.cosine / wedge.face.sine;
    const T towards_plane = bolt.cosine * wedge.plane.sine + bolt.sine * wedge.plane.cosine;
    if (!(y >= 0)) {
        return T(-1);
    }
    if (towards_plane > 0) {
        const T to_plane = (y * wedge.plane.cosine - x * wedge.plane.sine) / towards_plane;
        const T along =
            (x + to_plane * bolt.cosine) * wedge.plane.cosine + (y - to_plane * bolt.sine) * wedge.plane.sine;
        if (along <= wedge.base_length) {
            return to_plane;
        }
    }
    const T towards_crack = bolt.cosine * wedge.crack.sine + bolt.sine * wedge.crack.cosine;
    if (!(wedge.crack_length > 0) || !(towards_crack > 0)) {
        return T(-1);
    }
    return T(((wedge.base_top_x - x) * wedge.crack.sine - (wedge.base_top_height() - y) * wedge.crack.cosine) /
             towards_crack);
}

}  // namespace detail

// Calls visit(bolt) for the single bolts, then for each row of a pattern with the force of that row. The force is zero
// where the bolt does not run from the moving mass through the ground into the rock behind it.
template <class T, class Visit>
void for_each_bolt(const PlaneFailure<T>& problem, const Wedge<T>& wedge, Visit&& visit) {
    for (Bolt<T> bolt : problem.bolt) {
        const T through = detail::length_in_mass(wedge, bolt.head_height, bolt.plunge);
        if (!(through >= 0) || !(through <= length_in_ground(problem.slope, bolt.head_height, bolt.plunge))) {
            bolt.force = T(0);
        }
        visit(bolt);
    }
    for (const PlaneSupport<T>& support : problem.support) {
        for (int row = 0; T(row) < support.pattern.rows; ++row) {
            const T height = support.pattern.head_height(row);
            const T through = detail::length_in_mass(wedge, height, support.pattern.plunge);
            const T in_ground = length_in_ground(problem.slope, height, support.pattern.plunge);
            visit(Bolt<T>{force_of_row(support.pattern, through, in_ground), support.pattern.plunge, height,
                          support.action});
        }
    }
}

template <class T>
PlaneFailureCheck balance_forces(const PlaneFailure<T>& problem, const Wedge<T>& wedge, const WaterForces<T>& water,
                                 Stability<T>& result) {
    using detail::Force;
    if (!friction_below_90_degrees(problem.strength)) {
        return PlaneFailureCheck::friction_not_below_90_deg;
    }
    const SineCosine<T>& plane = wedge.plane;
    result.weight = problem.rock.unit_weight * wedge.area;
    const T cosine_crack_minus_plane = wedge.crack.sine * plane.sine + wedge.crack.cosine * plane.cosine;
    T normal = result.weight * plane.cosine - water.base.force - water.crack.force * cosine_crack_minus_plane;
    T driving = result.weight * plane.sine + water.crack.force * wedge.sine_crack_minus_plane;
    const auto apply = [&](const Force<T>& force) {
        normal += detail::into_plane(force, plane);
        driving += detail::down_plane(force, plane);
    };
    if (problem.seismic) {
        apply({T(-problem.seismic->horizontal_coefficient * result.weight),
               T(-problem.seismic->vertical_coefficient * result.weight)});
    }
    if (problem.pond) {
        // The components are not used here, because they cancel on a plane nearly parallel to the face.
        normal += water.face.force * (wedge.face.sine * plane.sine + wedge.face.cosine * plane.cosine);
        driving -= water.face.force * wedge.sine_face_minus_plane;
    }
    for (const Surcharge<T>& surcharge : problem.surcharge) {
        apply({T(0), T(-surcharge.pressure * detail::loaded_length(surcharge, wedge))});
    }
    for (const LineLoad<T>& load : problem.line_load) {
        if (detail::stands_on_mass(load, wedge)) {
            apply(detail::plunging_force(load.force, load.plunge));
        }
    }
    T passive = T(0);
    bool heads_on_face = true;
    for_each_bolt(problem, wedge, [&](const Bolt<T>& bolt) {
        heads_on_face = heads_on_face && bolt.head_height <= problem.slope.height;
        const Force<T> force = detail::plunging_force(bolt.force, bolt.plunge);
        normal += detail::into_plane(force, plane);
        if (bolt.action == BoltAction::active) {
            driving += detail::down_plane(force, plane);
        } else {
            passive -= detail::down_plane(force, plane);
        }
    });
    if (!heads_on_face) {
        return PlaneFailureCheck::bolt_head_above_crest;
    }
    const T normal_stress = normal / wedge.base_length;
    result.lifted = normal_stress < -(problem.tension_cutoff ? problem.tension_cutoff->tensile_strength : T(0));
    result.normal_force = normal;
    result.driving_force = driving;
    const T resisting =
        result.lifted ? T(0) : T(passive + shear_strength(problem.strength, normal_stress) * wedge.base_length);
    // A passive bolt that sliding would shorten reduces the resistance, but not below zero.
    result.resisting_force = resisting < 0 ? T(0) : resisting;
    result.factor_of_safety = result.lifted  ? T(0)
                              : driving <= 0 ? T(std::numeric_limits<double>::infinity())
                                             : T(result.resisting_force / driving);
    const bool is_number = result.factor_of_safety >= 0 || result.factor_of_safety < 0;
    return is_number ? PlaneFailureCheck::valid : PlaneFailureCheck::input_out_of_range;
}

// If `check` is not valid the other members are unspecified.
template <class T>
struct Equilibrium {
    PlaneFailureCheck check;
    Wedge<T> wedge;
    WaterForces<T> water;
    Stability<T> stability;
};

template <class T>
Equilibrium<T> evaluate(const PlaneFailure<T>& problem) {
    Equilibrium<T> result;
    result.check = make_wedge(problem, result.wedge);
    if (result.check == PlaneFailureCheck::valid) {
        result.check = water_forces(problem, result.wedge, result.water);
    }
    if (result.check == PlaneFailureCheck::valid) {
        result.check = balance_forces(problem, result.wedge, result.water, result.stability);
    }
    return result;
}

}  // namespace delabole
