#include "cases/program/thesis/chapter_2/chapter_2.hpp"

#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace delabole {

namespace {

double correlation(const std::vector<double>& one, const std::vector<double>& other) {
    const auto changes = [](const std::vector<double>& values) {
        return std::ranges::adjacent_find(values, std::ranges::not_equal_to{}) != values.end();
    };
    std::vector<double> ranks(2 * one.size());
    return changes(one) && changes(other) ? gsl_stats_spearman(one.data(), 1, other.data(), 1, one.size(), ranks.data())
                                          : 0;
}

}  // namespace

RankCorrelation rank_correlation(const std::vector<double>& parameter, const std::vector<double>& response) {
    std::vector<double> second = response;
    const double found = correlation(parameter, response);
    std::ranges::sort(second);
    double all = 0;
    double as_strong = 0;
    std::vector<std::size_t> order(second.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
        std::vector<double> shuffled(order.size());
        std::ranges::transform(order, shuffled.begin(), [&](std::size_t index) { return second[index]; });
        constexpr double rounding = 1e-12;
        as_strong += std::abs(correlation(parameter, shuffled)) >= std::abs(found) - rounding ? 1 : 0;
        ++all;
    } while (std::ranges::next_permutation(order).found);
    return {found, as_strong / all};
}

}  // namespace delabole
