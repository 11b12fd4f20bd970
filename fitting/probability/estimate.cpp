#include "fitting/probability/estimate.hpp"

#include "fitting/work/parallel.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace delabole {

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
    // The ends that the formula gives exactly, but for rounding.
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
