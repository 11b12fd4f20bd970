#include "cases/program/thesis/chapter_2/chapter_2.hpp"

#include "cases/program/thesis/thesis_tables.hpp"
#include "numerics/scalar_search.hpp"

#include <limits>

namespace delabole {

namespace {

constexpr double water_unit_weight = 9810;

// Completes the problem of the case by values that are not printed, and changes others.
PlaneFailure<> problem(double unit_weight, double z, double cohesion) {
    static const PlaneFailure<> printed =
        std::get<PlaneFailureStudy<>>(built_in_case("plane_failure", "fig_2_8").model).model;
    PlaneFailure<> slope = printed;
    std::get<CrackBaseBelowCrest<>>(slope.tension_crack->position).base_below_crest = z;
    slope.rock.unit_weight = unit_weight;
    std::get<SteppedSurface<>>(slope.strength).cohesion = cohesion;
    return slope;
}

PlaneFailure<> filled(FilledFraction reading, double unit_weight, double z, double cohesion, double fraction) {
    PlaneFailure<> slope = problem(unit_weight, z, cohesion);
    if (reading == FilledFraction::of_z_below_crest) {
        slope.water = CrackAndBaseWater<>{water_unit_weight, WaterDepth<>{fraction * z}};
    } else {
        slope.water = CrackAndBaseWater<>{water_unit_weight, FilledRatio<>{fraction}};
    }
    return slope;
}

}  // namespace

Fig28Solution solve_fig_2_8(FilledFraction reading, double unit_weight) {
    const double height = problem(unit_weight, 0, 0).slope.height;
    const auto excess = [&](double z) {
        const FactorOfSafety result = factor_of_safety(filled(reading, unit_weight, z, fig_2_8_cohesion, 2.0 / 3.0));
        return result.check == PlaneFailureCheck::valid ? result.value - 1 : std::numeric_limits<double>::quiet_NaN();
    };
    std::vector<double> candidates;
    constexpr int points = 400;
    for (int index = 1; index < points; ++index) {
        candidates.push_back(height * index / points);
    }
    Fig28Solution solution{reading, unit_weight, find_root(excess, candidates).position, 0, {}};
    if (solution.z) {
        solution.factor_half_full = factor_of_safety(filled(reading, unit_weight, *solution.z, 0, 0.5)).value;
        solution.state = analyse(filled(reading, unit_weight, *solution.z, fig_2_8_cohesion, 2.0 / 3.0));
    }
    return solution;
}

Polyline fig_2_8_curve(FilledFraction reading, double unit_weight, double z, double cohesion) {
    Polyline curve;
    constexpr int points = 101;
    for (int index = 0; index < points; ++index) {
        const double fraction = static_cast<double>(index) / (points - 1);
        const FactorOfSafety result = factor_of_safety(filled(reading, unit_weight, z, cohesion, fraction));
        if (result.check == PlaneFailureCheck::valid) {
            curve.emplace_back(fraction, result.value);
        }
    }
    return curve;
}

}  // namespace delabole
