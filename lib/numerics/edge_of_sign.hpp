// The point at which a function of one variable changes sign, to the last bit: for margins of stability, which may be
// zero over a range, jump, or have no finite value on one side.
#pragma once

#include <algorithm>
#include <cmath>

namespace delabole {

// Bracket in which a function changes from not positive to positive, in either direction.
struct SignBracket {
    double lower, upper;
    double at_lower, at_upper;
    bool found = false;
};

// Regula falsi with halved weights (Illinois); bisection if that does not shrink the bracket, or if a value is zero (a
// margin may be zero over a range, whose end is sought) or infinite. The result is exact to the last bit. The function
// bracketed_root of the fits does not serve here: it stops at any zero and treats a value that is not finite as a gap.
template <class Function>
double edge_in(Function& function, SignBracket bracket) {
    const auto positive_above = bracket.at_upper > 0;
    int last_side = 0;
    double weight_lower = bracket.at_lower;
    double weight_upper = bracket.at_upper;
    for (int count = 0; count < 200; ++count) {
        const double width = bracket.upper - bracket.lower;
        if (!(width > 1e-15 * (1 + std::abs(bracket.lower)))) {
            break;
        }
        double middle = (bracket.lower + bracket.upper) / 2;
        const double product = weight_lower * weight_upper;
        if (product < 0 && std::isfinite(weight_lower) && std::isfinite(weight_upper) && count % 4 != 3) {
            const double secant = bracket.upper - width * weight_upper / (weight_upper - weight_lower);
            // The step stays a few bits away from the ends, so that the far end moves too.
            const double least = 4e-16 * (1 + std::abs(secant));
            middle = std::clamp(secant, bracket.lower + least, bracket.upper - least);
        }
        if (!(middle > bracket.lower && middle < bracket.upper)) {
            break;
        }
        const double value = function(middle);
        if ((value > 0) == positive_above) {
            bracket.upper = middle;
            weight_upper = value;
            weight_lower = last_side > 0 ? weight_lower / 2 : weight_lower;
            last_side = 1;
        } else {
            bracket.lower = middle;
            weight_lower = value;
            weight_upper = last_side < 0 ? weight_upper / 2 : weight_upper;
            last_side = -1;
        }
    }
    return positive_above ? bracket.lower : bracket.upper;
}

}  // namespace delabole
