// Expectation of a function of a standard normal variable.
#pragma once

#include <cmath>

namespace delabole {

// Trapezium rule with step h = 1 / 8 over [-9, 9], at whose ends the weight has fallen to 1e-18. For analytic functions
// the error is exp(-2 pi^2 / h^2), far below rounding; a bounded jump in the second derivative, as at the mode of a
// triangular distribution, adds an error of about h^3 / 12 of the jump. Source: L. N. Trefethen & J. A. C. Weideman,
// SIAM Review 56 (2014) 385-458, section 5.
inline constexpr int normal_nodes = 145;

constexpr double normal_node(int index) {
    constexpr int middle = normal_nodes / 2;
    return (index - middle) / 8.0;
}

inline double normal_weight(int index) {
    constexpr double step_over_root_two_pi = 0.125 * 0.39894228040143267794;
    const double node = normal_node(index);
    return step_over_root_two_pi * std::exp(-node * node / 2);
}

template <class Function>
double normal_integral(const Function& function) {
    double sum = 0;
    for (int index = 0; index < normal_nodes; ++index) {
        sum += normal_weight(index) * function(normal_node(index));
    }
    return sum;
}

}  // namespace delabole
