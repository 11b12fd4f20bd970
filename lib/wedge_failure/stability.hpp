// Balance of forces on a wedge and its factor of safety.
//
// The notation is that of geometry.hpp. Active forces, R: weight, inertia, loads, active bolts and water,
//     R = W (0, 0, -1) + k W e + U1 a1 + U2 a2 - V t + loads + active bolts,
// t the crack's normal out of the wedge, U and V mean pressure times area. Passive bolts P press on the planes and
// resist, but do not determine the direction in which the wedge moves.
//
// Contact (Hoek & Bray 1981, appendix 2: complete solution). With c = a1 . a2 the normal forces that hold the wedge
// across the line of intersection are
//     N1 = -(R . a1 - c R . a2) / (1 - c^2),   N2 = -(R . a2 - c R . a1) / (1 - c^2).
//   both N >= 0: it slides along the line i on both planes;
//   N2 < 0 and R . a1 < 0: it slides on plane 1 alone, along r = R - (R . a1) a1, because r . a2 = -(1 - c^2) N2 > 0
//     means that it leaves plane 2; for plane 2 alone with 1 and 2 exchanged;
//   otherwise it is lifted off both planes, and the factor of safety is 0.
// Exactly one of these cases applies. With s the direction of sliding,
//     FS = (tau1 A1 + tau2 A2 - P . s) / (R . s),
// tau from the mean normal stress of R + P on each plane that carries load. FS is infinite if R . s is not positive.
//
// Moments are left out: a wedge may rotate about an edge before it slides. The far wall of the crack carries no load,
// which is on the safe side.
//
// Accuracy: sums may cancel; the absolute error of each force is a few units in the last place of the sum of the
// magnitudes of its terms, over 1 - c^2 if both planes carry load.
#pragma once

#include "kinematics/criteria.hpp"
#include "strength/shear_strength.hpp"
#include "wedge_failure/geometry.hpp"

#include <limits>

namespace delabole {

struct WedgePressures {
    double plane_1;
    double plane_2;
    double crack;
};

// Mean pressures; parameters.hpp describes how fissures fill. The geometry is that of the problem.
inline WedgePressures mean_pressures(const WedgeFailure& problem, const WedgeGeometry& wedge) {
    if (const auto* filled = std::get_if<FilledFissures>(&problem.water)) {
        const double depth = problem.tension_crack ? wedge.crack_depth : wedge.line_top.z() / 2;
        const double mean = filled->unit_weight * filled->filled_ratio * depth / 3;
        return {mean, mean, problem.tension_crack ? mean : 0};
    }
    if (const auto* given = std::get_if<MeanPressures>(&problem.water)) {
        return {given->plane_1, given->plane_2, given->tension_crack.value_or(0)};
    }
    return {0, 0, 0};
}

struct WedgeStability {
    SlidingContact contact;
    double factor_of_safety;
    Direction sliding;  // unit vector; zero if the wedge is lifted off
    double weight;
    double water_force_1;
    double water_force_2;
    double crack_water_force;
    double normal_force_1;  // effective; 0 on a plane that carries no load
    double normal_force_2;
    double driving_force;    // R . s; if the wedge is lifted off, the magnitude of R
    double resisting_force;  // strength of the planes and passive bolts
};

namespace detail {

struct WedgeForces {
    Direction active;
    Direction passive;
};

inline WedgeForces forces_on(const WedgeFailure& problem, const WedgeGeometry& wedge, const WedgeStability& result) {
    WedgeForces forces{Direction(0, 0, -result.weight), Direction::Zero()};
    forces.active += result.water_force_1 * wedge.inner_1 + result.water_force_2 * wedge.inner_2 -
                     result.crack_water_force * wedge.crack_normal;
    if (problem.seismic) {
        const WedgeSeismicLoad& load = *problem.seismic;
        const double trend = load.trend ? *load.trend : std::atan2(wedge.line.x(), wedge.line.y());
        forces.active += load.coefficient * result.weight * direction_of({load.plunge.value_or(0), trend});
    }
    for (const WedgeLoad& load : problem.load) {
        forces.active += load.force * direction_of({load.plunge, load.trend});
    }
    for (const WedgeBolt& bolt : problem.bolt) {
        (bolt.action == BoltAction::active ? forces.active : forces.passive) +=
            bolt.force * direction_of({bolt.plunge, bolt.trend});
    }
    return forces;
}

// The normal forces that hold a force across the line of intersection.
inline std::pair<double, double> both_normal_forces(const WedgeGeometry& wedge, const Direction& force) {
    const double cosine = wedge.inner_1.dot(wedge.inner_2);
    const Direction axis = wedge.inner_1.cross(wedge.inner_2);
    const double on_1 = force.dot(wedge.inner_1);
    const double on_2 = force.dot(wedge.inner_2);
    const double sine_squared = axis.dot(axis);  // 1 - c^2 without its cancellation
    return {(cosine * on_2 - on_1) / sine_squared, (cosine * on_1 - on_2) / sine_squared};
}

}  // namespace detail

inline WedgeFailureCheck balance_forces(const WedgeFailure& problem, const WedgeGeometry& wedge,
                                        WedgeStability& result) {
    if (!friction_below_90_degrees(problem.plane_1.strength) || !friction_below_90_degrees(problem.plane_2.strength)) {
        return WedgeFailureCheck::friction_not_below_90_deg;
    }
    const auto* given = std::get_if<MeanPressures>(&problem.water);
    if (given != nullptr && given->tension_crack && !problem.tension_crack) {
        return WedgeFailureCheck::water_needs_crack;
    }
    const WedgePressures pressures = mean_pressures(problem, wedge);
    result.weight = problem.rock.unit_weight * wedge.volume;
    result.water_force_1 = pressures.plane_1 * wedge.area_1;
    result.water_force_2 = pressures.plane_2 * wedge.area_2;
    result.crack_water_force = pressures.crack * wedge.crack_area;
    const detail::WedgeForces forces = detail::forces_on(problem, wedge, result);

    const auto [both_1, both_2] = detail::both_normal_forces(wedge, forces.active);
    const Direction total = forces.active + forces.passive;
    result.normal_force_1 = result.normal_force_2 = 0;
    result.sliding = Direction::Zero();
    const auto slide_on = [&](const Direction& inner, SlidingContact contact, double& normal_force) {
        const Direction along = forces.active - forces.active.dot(inner) * inner;
        result.contact = contact;
        result.sliding = along / along.norm();
        normal_force = -total.dot(inner);
    };
    if (both_1 >= 0 && both_2 >= 0) {
        result.contact = SlidingContact::both_planes;
        result.sliding = wedge.line;
        std::tie(result.normal_force_1, result.normal_force_2) = detail::both_normal_forces(wedge, total);
    } else if (both_2 < 0 && forces.active.dot(wedge.inner_1) < 0) {
        slide_on(wedge.inner_1, SlidingContact::first_plane, result.normal_force_1);
    } else if (both_1 < 0 && forces.active.dot(wedge.inner_2) < 0) {
        slide_on(wedge.inner_2, SlidingContact::second_plane, result.normal_force_2);
    } else {
        result.contact = SlidingContact::none;
        result.driving_force = forces.active.norm();
        result.resisting_force = result.factor_of_safety = 0;
        return result.driving_force >= 0 ? WedgeFailureCheck::valid : WedgeFailureCheck::input_out_of_range;
    }
    double resisting = -forces.passive.dot(result.sliding);
    if (result.contact != SlidingContact::second_plane) {
        resisting += wedge.area_1 * shear_strength(problem.plane_1.strength, result.normal_force_1 / wedge.area_1);
    }
    if (result.contact != SlidingContact::first_plane) {
        resisting += wedge.area_2 * shear_strength(problem.plane_2.strength, result.normal_force_2 / wedge.area_2);
    }
    // A passive bolt that sliding would shorten reduces the resistance, but not below zero.
    result.resisting_force = resisting < 0 ? 0 : resisting;
    result.driving_force = forces.active.dot(result.sliding);
    result.factor_of_safety = result.driving_force <= 0 ? std::numeric_limits<double>::infinity()
                                                        : result.resisting_force / result.driving_force;
    return result.factor_of_safety >= 0 ? WedgeFailureCheck::valid : WedgeFailureCheck::input_out_of_range;
}

// Geometry and forces; if `check` is not valid the other members are unspecified.
struct WedgeEquilibrium {
    WedgeFailureCheck check;
    WedgeGeometry wedge;
    WedgeStability stability;
};

inline WedgeEquilibrium evaluate(const WedgeFailure& problem) {
    WedgeEquilibrium result;
    result.check = make_geometry(problem, result.wedge);
    if (result.check == WedgeFailureCheck::valid) {
        result.check = balance_forces(problem, result.wedge, result.stability);
    }
    return result;
}

}  // namespace delabole
