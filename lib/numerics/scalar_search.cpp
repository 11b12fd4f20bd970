#include "numerics/scalar_search.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_roots.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace delabole {

namespace {

using Function = std::function<double(double)>;

// At a value that is not finite GSL ends the process, through a global handler that is not changed here. Such a value
// is therefore reported to GSL as a root, and to the caller as a failure.
struct GuardedFunction {
    const Function& function;
    bool finite = true;
};

double call(double x, void* guarded) {
    GuardedFunction& guard = *static_cast<GuardedFunction*>(guarded);
    const double value = guard.function(x);
    guard.finite = guard.finite && std::isfinite(value);
    return guard.finite ? value : 0;
}

constexpr int iteration_limit = 200;  // Brent's worst case is bisection: 60 halvings exhaust a double

// The farthest valid point between a valid and an invalid one.
double edge_of_validity(const Function& function, double valid, double invalid) {
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = valid + (invalid - valid) / 2;
        (std::isfinite(function(middle)) ? valid : invalid) = middle;
    }
    return valid;
}

// Returns nothing if the function has no value at some point of the search.
std::optional<double> refine_root(const Function& function, double lower, double upper) {
    const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
        gsl_root_fsolver_alloc(gsl_root_fsolver_brent), gsl_root_fsolver_free);
    GuardedFunction guard{function};
    gsl_function wrapped{&call, &guard};
    gsl_root_fsolver_set(solver.get(), &wrapped, lower, upper);
    double root = std::numeric_limits<double>::quiet_NaN();
    for (int iteration = 0; iteration < iteration_limit && guard.finite; ++iteration) {
        if (gsl_root_fsolver_iterate(solver.get()) != GSL_SUCCESS) {
            break;
        }
        const double a = gsl_root_fsolver_x_lower(solver.get());
        const double b = gsl_root_fsolver_x_upper(solver.get());
        // With steps this small Brent's method has converged, although the far end of its bracket may lag behind.
        const double last_root = std::exchange(root, gsl_root_fsolver_root(solver.get()));
        const double resolution = 2 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
        if (b - a <= resolution || std::abs(root - last_root) <= resolution) {
            break;
        }
    }
    return guard.finite ? std::optional(gsl_root_fsolver_root(solver.get())) : std::nullopt;
}

// Whether the function jumps over zero between two points: over a step a hundredth as long it changes by as much. The
// steps are small enough for steep functions, and large enough for the rounding of values.
bool jumps(const Function& value, double root, double lower, double upper) {
    const double step = 1e7 * std::numeric_limits<double>::epsilon() * std::max(std::abs(lower), std::abs(upper));
    const auto change = [&](double length) {
        return std::abs(value(std::min(upper, root + length)) - value(std::max(lower, root - length)));
    };
    const double change_nearby = change(step / 100);
    const double least = std::min(std::abs(value(lower)), std::abs(value(upper)));
    return change_nearby > change(step) / 2 && change_nearby > 1e-6 * least;
}

// Last point before values rise again, from `lower_value` at `from` towards `to`: the foot of a jump.
double foot_of_jump(const Function& value, double from, double lower_value, double to) {
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = from + (to - from) / 2;
        const double middle_value = value(middle);
        if (middle_value <= lower_value) {
            from = middle;
            lower_value = middle_value;
        } else {
            to = middle;
        }
    }
    return from;
}

// Returns the lowest of all points evaluated in a search by values only.
double golden_section(const Function& value, double lower, double upper) {
    const double ratio = (std::sqrt(5.0) - 1) / 2;
    double lowest = lower;
    double lowest_value = std::numeric_limits<double>::infinity();
    const auto look = [&](double x) {
        const double found = value(x);
        if (found < lowest_value) {
            lowest = x;
            lowest_value = found;
        }
        return found;
    };
    double left = upper - ratio * (upper - lower);
    double right = lower + ratio * (upper - lower);
    double left_value = look(left);
    double right_value = look(right);
    for (int step = 0; step < 75; ++step) {  // 0.618^75 exhausts a double
        if (left_value <= right_value) {
            upper = right;
            right = left;
            right_value = left_value;
            left = upper - ratio * (upper - lower);
            left_value = look(left);
        } else {
            lower = left;
            left = right;
            left_value = right_value;
            right = lower + ratio * (upper - lower);
            right_value = look(right);
        }
    }
    return lowest;
}

}  // namespace

ScalarMinimum minimise_scalar(const Function& value, const Function& slope, double lower, double upper, int points) {
    const auto position = [&](int index) {
        return lower + (upper - lower) * static_cast<double>(index) / static_cast<double>(points - 1);
    };
    constexpr double none = std::numeric_limits<double>::infinity();
    int best = 0;
    double best_value = none;
    double before_best = none;
    double after_best = none;
    double last_value = none;
    for (int index = 0; index < points; ++index) {
        const double scanned = value(position(index));
        if (index == best + 1) {
            after_best = scanned;
        }
        if (scanned < best_value) {
            best = index;
            best_value = scanned;
            before_best = last_value;
        }
        last_value = scanned;
    }
    const double start = position(best);
    if (!std::isfinite(best_value)) {
        return {start, best_value, true};
    }
    const double best_slope = slope(start);
    if (best_slope == 0 || !std::isfinite(best_slope)) {
        return {start, best_value, false};
    }
    const bool falls_to_lower = best_slope > 0;
    if (best == (falls_to_lower ? 0 : points - 1)) {
        return {start, best_value, true};
    }
    double end = position(falls_to_lower ? best - 1 : best + 1);
    const bool at_edge = !std::isfinite(falls_to_lower ? before_best : after_best);
    if (at_edge) {
        end = edge_of_validity(value, start, end);
    }
    const double end_slope = slope(end);
    const bool turns = std::isfinite(end_slope) && (end_slope > 0) != (best_slope > 0);
    const auto [left, right] = std::minmax(start, end);
    const std::optional<double> root = turns ? refine_root(slope, left, right) : std::nullopt;
    ScalarMinimum minimum{end, 0, at_edge && !turns};
    if (root) {
        minimum.position = *root;
    } else if (turns || !std::isfinite(end_slope)) {
        minimum.position = golden_section(value, left, right);  // derivatives do not lead to the minimum
    } else if (!at_edge) {
        minimum.position = foot_of_jump(value, start, best_value, end);
    }
    minimum.value = value(minimum.position);
    return minimum.value <= best_value ? minimum : ScalarMinimum{start, best_value, false};
}

ScalarRoot find_root(const Function& function, const std::vector<double>& candidates) {
    ScalarRoot result{
        std::nullopt, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0, false,
        std::nullopt};
    bool have_last = false;
    double last = 0;
    double last_value = 0;
    const auto visit = [&](double x, double value) {
        result.lowest = std::min(result.lowest, value);
        result.highest = std::max(result.highest, value);
        if (value == 0 || (have_last && (value > 0) != (last_value > 0) && last_value != 0)) {
            std::optional<double> root = value == 0 ? x : refine_root(function, last, x);
            if (root && value != 0 && jumps(function, *root, last, x)) {
                result.jump = result.jump.value_or(*root);
                root.reset();
            }
            result.sign_changes += root ? 1 : 0;
            if (root && !result.position) {
                result.position = root;
                result.rises = value > last_value || !have_last;
            }
        }
        have_last = true;
        last = x;
        last_value = value;
    };
    bool was_valid = false;
    for (std::size_t index = 0; index < candidates.size(); ++index) {
        const double x = candidates[index];
        const double value = function(x);
        const bool valid = std::isfinite(value);
        if (index > 0 && valid != was_valid) {
            const double edge = valid ? edge_of_validity(function, x, candidates[index - 1])
                                      : edge_of_validity(function, candidates[index - 1], x);
            if (valid) {
                have_last = false;  // no value in between: a change of sign across the gap is not a root
            }
            if (edge != last || !have_last) {
                visit(edge, function(edge));
            }
        }
        if (valid && !(have_last && x == last)) {
            visit(x, value);
        }
        was_valid = valid;
    }
    return result;
}

}  // namespace delabole
