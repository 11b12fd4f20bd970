// Root of a continuous function between two points where it has opposite signs.
#pragma once

#include <cmath>
#include <optional>

namespace delabole {

struct RootBracket {
    double lower;
    double upper;
    double lower_value;  // of the opposite sign to upper_value, both finite
    double upper_value;
};

// Illinois variant of regula falsi, with a bisection whenever a step has not reduced the bracket to half its length
// within three steps: superlinear on smooth functions, never slower than a third of bisection's speed. Stops when the
// bracket is shorter than `tolerance` (> 0), which then bounds the error of the root, or when |function| <=
// value_tolerance. Returns nothing where the function is not finite at a trial point. Source: Dowell & Jarratt, BIT 11
// (1971) 168-174.
template <class Function>
std::optional<double> bracketed_root(const Function& function, RootBracket bracket, double tolerance,
                                     double value_tolerance = 0) {
    auto [a, b, value_a, value_b] = bracket;
    int steps_since_halving = 0;
    double halved_width = std::abs(b - a);
    int kept_side = 0;
    double weight_a = value_a;
    double weight_b = value_b;
    while (std::abs(b - a) > tolerance) {
        double trial = b - weight_b * (b - a) / (weight_b - weight_a);
        const double middle = a + 0.5 * (b - a);
        const bool outside = !((trial > std::fmin(a, b)) && (trial < std::fmax(a, b)));
        if (outside || steps_since_halving >= 3) {
            trial = middle;
        }
        if (trial == a || trial == b) {
            break;  // the ends are neighbouring numbers: the bracket cannot shrink
        }
        const double value = function(trial);
        if (!std::isfinite(value)) {
            return std::nullopt;
        }
        if (std::abs(value) <= value_tolerance) {
            return trial;
        }
        if ((value > 0) == (value_b > 0)) {
            b = trial;
            value_b = weight_b = value;
            weight_a = kept_side == -1 ? 0.5 * weight_a : value_a;
            kept_side = -1;
        } else {
            a = trial;
            value_a = weight_a = value;
            weight_b = kept_side == 1 ? 0.5 * weight_b : value_b;
            kept_side = 1;
        }
        if (std::abs(b - a) <= 0.5 * halved_width) {
            halved_width = std::abs(b - a);
            steps_since_halving = 0;
        } else {
            ++steps_since_halving;
        }
    }
    return std::abs(value_a) < std::abs(value_b) ? a : b;
}

}  // namespace delabole
