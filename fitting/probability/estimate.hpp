// Numbers estimated from samples, with their errors; quantiles of chi-square and points of the Sobol sequence (GSL).
#pragma once

#include "fitting/probability/counted_random.hpp"
#include "parameters/fields.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace delabole {

// Probability that a normal variable lies within one standard deviation of its mean, called "68 %" in reports.
inline constexpr double probability_68 = 0.6826894921370859;
inline constexpr double probability_95 = 0.95;

// Quantile of a chi-square variable for a probability in (0, 1); degrees_of_freedom > 0. Accuracy: GSL's inverse,
// relative 1e-9 or better. Source: GSL manual, gsl_cdf_chisq_Pinv.
double chi_square_quantile(double probability, double degrees_of_freedom);

// First `count` points of the Sobol sequence in the open unit box; the first is its centre. Throws
// std::invalid_argument for dimension > 40, the greatest that GSL tabulates. For dimension 0 a single point without
// coordinates.
std::vector<std::vector<double>> sobol_points(std::size_t dimension, std::size_t count);

struct Estimate {
    double value = 0;
    Interval interval_95 = {0, 0};
};

// The values of all columns in one, ascending.
std::vector<double> sorted_together(const std::vector<std::vector<double>>& columns);
// Value below which the given share of the numbers lies: linear between order statistics (type 7 of R. J. Hyndman & Y.
// Fan, The American Statistician 50 (1996) 361-365). There has to be at least one number, and they have to be sorted; 0
// <= share <= 1.
double sorted_quantile(std::span<const double> sorted, double share);

// 95 % interval of a probability, given `hits` in `trials` independent trials; trials > 0. Source: E. B. Wilson, J.
// American Statistical Association 22 (1927) 209-212.
Interval wilson_interval(double hits, double trials);

// Mean of independent, equally accurate estimates and the 95 % interval from their spread, by Student's t; needs at
// least two.
Estimate mean_of_replicates(std::span<const double> replicates);

// Percentile intervals of statistics over resampled items: statistics(number of times that each item is drawn). Random
// numbers follow from the seed; repetitions >= 2. Source: B. Efron & R. J. Tibshirani, An introduction to the bootstrap
// (1993), chapter 13.
using WeightedStatistics = std::function<std::vector<double>(std::span<const unsigned> times)>;
std::vector<Interval> bootstrap_intervals(std::size_t items, std::size_t statistics, int repetitions,
                                          const CountedRandom& random, int threads, const WeightedStatistics& of);

}  // namespace delabole
