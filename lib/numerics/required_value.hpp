// The value of one input at which the factor of safety takes a given value: friction, cohesion, water level, bolt force
// ...
#pragma once

#include "numerics/scalar_search.hpp"
#include "parameters/fields.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

enum class RequiredStatus { found, several, never_reached, always_exceeded, unknown_parameter };

struct Required {
    RequiredStatus status;
    double value;  // SI, meaningful if found or several (then the smallest)
    Dimension dimension;
    // Over the range searched, for the message if the target is never reached; infinite if nothing fails; plus and
    // minus infinity if the problem has no answer at all.
    double lowest_factor_of_safety;
    double highest_factor_of_safety;
    bool rises = false;               // the factor of safety, as the input grows beyond the value
    std::optional<double> jump = {};  // SI, where the factor jumps over the target
};

// Points at which to search for the root: the range of a field, or geometrically over 24 decades of distance from its
// bound (without a bound, from zero and from the present value). A bound of 1e5 or more is ignored.
std::vector<double> search_points(const Interval& range, double present);

// Searches the range of the input's field; the inputs of `also` take the same value. `factor_of_safety(problem)` gives
// NaN if the problem has no answer (water above the crack, ...): such values are left out. Accuracy: full double
// precision of the root, if the function is monotonic between neighbouring search points. A factor that jumps over the
// target does not reach it.
template <Described Problem, class FactorOfSafety>
Required find_required_value(const Problem& problem, const std::string& parameter, const std::vector<std::string>& also,
                             double target, const FactorOfSafety& factor_of_safety) {
    Problem varied = problem;
    double* number = nullptr;
    std::vector<double*> others;
    FieldInfo field;
    for_each_named_number(varied, [&](const std::string& path, const FieldInfo& info, double& value) {
        if (path == parameter) {
            number = &value;
            field = info;
        } else if (std::ranges::find(also, path) != also.end()) {
            others.push_back(&value);
        }
    });
    if (number == nullptr || others.size() != also.size()) {
        return {RequiredStatus::unknown_parameter, 0, Dimension::ratio, 0, 0};
    }
    const double present = *number;
    constexpr double beyond_all = 1e15;  // an infinite factor is above every target
    const auto excess = [&](double value) {
        if (!field.range.contains(value)) {
            return std::numeric_limits<double>::quiet_NaN();
        }
        *number = value;
        for (double* other : others) {
            *other = value;
        }
        return std::min(factor_of_safety(varied), beyond_all) - target;
    };
    const ScalarRoot root = find_root(excess, search_points(field.range, present));
    const bool exceeded = root.lowest > 0 && std::isfinite(root.lowest);
    const RequiredStatus status = !root.position
                                      ? (exceeded ? RequiredStatus::always_exceeded : RequiredStatus::never_reached)
                                  : root.sign_changes == 1 ? RequiredStatus::found
                                                           : RequiredStatus::several;
    const auto factor = [&](double above_target) {
        return above_target + target < beyond_all ? above_target + target : std::numeric_limits<double>::infinity();
    };
    return {
        status,   root.position.value_or(0.0), field.dimension, factor(root.lowest), factor(root.highest), root.rises,
        root.jump};
}

}  // namespace delabole
