#include "fitting/probability/estimate.hpp"

#include "fitting/work/parallel.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>

namespace delabole {

double chi_square_quantile(double probability, double degrees_of_freedom) {
    if (!(probability > 0 && probability < 1 && degrees_of_freedom > 0)) {
        throw std::invalid_argument("chi_square_quantile: needs 0 < probability < 1 and degrees_of_freedom > 0");
    }
    return gsl_cdf_chisq_Pinv(probability, degrees_of_freedom);
}

std::vector<std::vector<double>> sobol_points(std::size_t dimension, std::size_t count) {
    if (dimension == 0) {
        return {{}};
    }
    if (dimension > 40) {
        throw std::invalid_argument("sobol_points: " + std::to_string(dimension) + " dimensions, at most 40");
    }
    const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> generator(
        gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(dimension)), &gsl_qrng_free);
    if (!generator) {
        throw std::bad_alloc();
    }
    std::vector<std::vector<double>> points(count, std::vector<double>(dimension));
    for (std::vector<double>& point : points) {
        gsl_qrng_get(generator.get(), point.data());
    }
    return points;
}

namespace {

constexpr double tail = 0.025;

}  // namespace

std::vector<double> sorted_together(const std::vector<std::vector<double>>& columns) {
    std::vector<double> all;
    for (const std::vector<double>& column : columns) {
        all.insert(all.end(), column.begin(), column.end());
    }
    std::ranges::sort(all);
    return all;
}

double sorted_quantile(std::span<const double> sorted, double share) {
    const double place = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    if (below + 1 >= sorted.size()) {
        return sorted.back();
    }
    return std::lerp(sorted[below], sorted[below + 1], place - static_cast<double>(below));
}

Interval wilson_interval(double hits, double trials) {
    const double z = gsl_cdf_ugaussian_Qinv(tail);
    const double share = hits / trials;
    const double weight = z * z / trials;
    const double centre = (share + weight / 2) / (1 + weight);
    const double half = z / (1 + weight) * std::sqrt(share * (1 - share) / trials + weight / (4 * trials));
    // At these two ends the formula is exact; the rounding of its terms is avoided.
    return {hits == 0 ? 0 : centre - half, hits == trials ? 1 : centre + half};
}

Estimate mean_of_replicates(std::span<const double> replicates) {
    if (replicates.size() < 2) {
        throw std::invalid_argument("mean_of_replicates: needs at least two");
    }
    const auto count = static_cast<double>(replicates.size());
    double mean = 0;
    for (const double value : replicates) {
        mean += value / count;
    }
    double squares = 0;
    for (const double value : replicates) {
        squares += (value - mean) * (value - mean);
    }
    const double half = gsl_cdf_tdist_Qinv(tail, count - 1) * std::sqrt(squares / (count * (count - 1)));
    return {mean, {mean - half, mean + half}};
}

std::vector<Interval> bootstrap_intervals(std::size_t items, std::size_t statistics, int repetitions,
                                          const CountedRandom& random, int threads, const WeightedStatistics& of) {
    const auto count = static_cast<std::size_t>(repetitions);
    std::vector<std::vector<double>> drawn(statistics, std::vector<double>(count));
    run_tasks(count, threads, [&](std::size_t repetition) {
        std::vector<unsigned> times(items, 0);
        for (std::size_t draw = 0; draw < items; ++draw) {
            ++times[random.below(items, draw, static_cast<std::uint32_t>(repetition))];
        }
        const std::vector<double> values = of(times);
        for (std::size_t statistic = 0; statistic < statistics; ++statistic) {
            drawn[statistic][repetition] = values[statistic];
        }
    });
    std::vector<Interval> intervals;
    for (std::vector<double>& values : drawn) {
        std::sort(values.begin(), values.end());
        intervals.push_back({sorted_quantile(values, tail), sorted_quantile(values, 1 - tail)});
    }
    return intervals;
}

}  // namespace delabole
