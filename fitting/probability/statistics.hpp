// Chi-square levels and low-discrepancy points (GSL).
#pragma once

#include <cstddef>
#include <vector>

namespace delabole {

// Probability within one standard deviation of a normal variable: what "68 %" stands for.
inline constexpr double probability_68 = 0.6826894921370859;
inline constexpr double probability_95 = 0.95;

// Value that a chi-square variable stays under with the given probability in (0, 1); degrees_of_freedom > 0.
// Accuracy: GSL's inverse, relative 1e-9 or better. Source: GSL manual, gsl_cdf_chisq_Pinv.
double chi_square_quantile(double probability, double degrees_of_freedom);

// First `count` points of the Sobol sequence in the open unit box; the first is its centre. dimension <= 40, the most
// that GSL tabulates, otherwise std::invalid_argument. One point without coordinates for dimension 0.
std::vector<std::vector<double>> sobol_points(std::size_t dimension, std::size_t count);

}  // namespace delabole
