#include "plane_failure/required.hpp"

#include "plane_failure/dual.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/scalar_search.hpp"
#include "plane_failure/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

constexpr int linear_points = 257;
constexpr int points_per_decade = 12;
constexpr int decades = 12;  // above and below one SI unit

std::vector<double> candidates(const Interval& range, double present) {
    std::vector<double> values;
    if (std::isfinite(range.lower) && std::isfinite(range.upper)) {
        for (int index = 0; index < linear_points; ++index) {
            values.push_back(range.lower + (range.upper - range.lower) * index / (linear_points - 1));
        }
    } else {
        const double bound = std::isfinite(range.lower) ? range.lower : std::isfinite(range.upper) ? range.upper : 0;
        // About the present value too where nothing is bounded: an elevation has answers only in a short interval far
        // from zero.
        std::vector<double> origins = {bound};
        if (std::isinf(range.lower) && std::isinf(range.upper)) {
            origins.push_back(present);
        }
        for (const double origin : origins) {
            values.push_back(origin);
            for (int step = -decades * points_per_decade; step <= decades * points_per_decade; ++step) {
                const double distance = std::pow(10.0, static_cast<double>(step) / points_per_decade);
                values.push_back(origin + distance);
                values.push_back(origin - distance);
            }
        }
    }
    values.push_back(present);
    std::erase_if(values, [&](double value) { return !range.contains(value); });
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

}  // namespace

Required required_value(const PlaneFailure<>& problem, const std::string& parameter, double target) {
    constexpr double missing = std::numeric_limits<double>::quiet_NaN();
    PlaneFailure<> varied = problem;
    double* number = nullptr;
    FieldInfo field;
    for_each_named_number(varied, [&](const std::string& path, const FieldInfo& info, double& value) {
        if (path == parameter) {
            number = &value;
            field = info;
        }
    });
    if (number == nullptr) {
        return {RequiredStatus::unknown_parameter, 0, Dimension::ratio, 0, 0};
    }
    const double present = *number;
    const auto excess = [&](double value) {
        if (!field.range.contains(value)) {
            return missing;
        }
        *number = value;
        const FactorOfSafety result = factor_of_safety(varied);
        return result.check == PlaneFailureCheck::valid ? result.value - target : missing;
    };
    const ScalarRoot root = find_root(excess, candidates(field.range, present));
    const RequiredStatus status = !root.position           ? RequiredStatus::never_reached
                                  : root.sign_changes == 1 ? RequiredStatus::found
                                                           : RequiredStatus::several;
    return {status, root.position.value_or(0.0), field.dimension, root.lowest + target, root.highest + target};
}

OptimumBolt optimum_bolt_plunge(const PlaneFailure<>& problem) {
    if (problem.bolt.empty()) {
        return {0, 0};
    }
    PlaneFailure<Dual> dual = with_scalar<PlaneFailure<Dual>>(problem);
    for_each_number(dual, [](Dual& number, const FieldInfo&) { number = constant(number.value()); });
    const auto factor = [&](double plunge) {
        dual.bolt.front().plunge = variable(plunge);
        const Equilibrium<Dual> forces = evaluate(dual);
        return forces.check == PlaneFailureCheck::valid ? forces.stability.factor_of_safety
                                                        : constant(-std::numeric_limits<double>::infinity());
    };
    const ScalarMinimum minimum = minimise_scalar([&](double plunge) { return -factor(plunge).value(); },
                                                  [&](double plunge) { return -factor(plunge).derivatives()(0); },
                                                  -problem.failure_plane.dip, degrees(90), 37);
    const bool found = minimum.value < std::numeric_limits<double>::infinity();
    return found ? OptimumBolt{minimum.position, -minimum.value} : OptimumBolt{0, 0};
}

}  // namespace delabole
