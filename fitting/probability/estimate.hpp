// Numbers estimated from samples, with their errors; chi-square levels and low-discrepancy points (GSL).
#pragma once

#include "fitting/probability/counted_random.hpp"
#include "parameters/fields.hpp"

#include <cstddef>
#include <functional>
#include <span>
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

struct Estimate {
    double value = 0;
    Interval interval_95 = {0, 0};
};

// The values of all columns, ascending.
std::vector<double> sorted_together(const std::vector<std::vector<double>>& columns);
// Value below which a share of the numbers lies: linear between order statistics (type 7 of R. J. Hyndman & Y. Fan, The
// American Statistician 50 (1996) 361-365). The numbers have to be sorted and at least one; 0 <= share <= 1.
double sorted_quantile(std::span<const double> sorted, double share);

// 95 % interval of a probability of which `hits` of `trials` independent trials spoke; trials > 0. Source: E. B.
// Wilson, J. American Statistical Association 22 (1927) 209-212.
Interval wilson_interval(double hits, double trials);

// Mean of independent, equally good estimates and the 95 % interval that their spread gives, by Student's t; needs at
// least two.
Estimate mean_of_replicates(std::span<const double> replicates);

// Percentile interval of a statistic over resampled items: statistic(number of times that each item is drawn). Numbers
// are counted from the seed; repetitions >= 2. Source: B. Efron & R. J. Tibshirani, An introduction to the bootstrap
// (1993), chapter 13.
using WeightedStatistics = std::function<std::vector<double>(std::span<const unsigned> times)>;
std::vector<Interval> bootstrap_intervals(std::size_t items, std::size_t statistics, int repetitions,
                                          const CountedRandom& random, int threads, const WeightedStatistics& of);

}  // namespace delabole
