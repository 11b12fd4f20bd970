#include "cases/program/thesis/chapter_2/rank_correlation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace delabole {

namespace {

// Ties have the mean of their ranks.
std::vector<double> ranks_of(const std::vector<double>& values) {
    std::vector<double> ranks;
    for (const double value : values) {
        double rank = 0.5;
        for (const double other : values) {
            rank += other < value ? 1 : other == value ? 0.5 : 0;
        }
        ranks.push_back(rank);
    }
    return ranks;
}

double correlation(const std::vector<double>& one, const std::vector<double>& other) {
    const auto count = static_cast<double>(one.size());
    double mean_one = 0;
    double mean_other = 0;
    for (std::size_t index = 0; index < one.size(); ++index) {
        mean_one += one[index] / count;
        mean_other += other[index] / count;
    }
    double product = 0;
    double square_one = 0;
    double square_other = 0;
    for (std::size_t index = 0; index < one.size(); ++index) {
        product += (one[index] - mean_one) * (other[index] - mean_other);
        square_one += (one[index] - mean_one) * (one[index] - mean_one);
        square_other += (other[index] - mean_other) * (other[index] - mean_other);
    }
    return square_one > 0 && square_other > 0 ? product / std::sqrt(square_one * square_other) : 0;
}

}  // namespace

RankCorrelation rank_correlation(const std::vector<double>& parameter, const std::vector<double>& response) {
    const std::vector<double> first = ranks_of(parameter);
    std::vector<double> second = ranks_of(response);
    const double found = correlation(first, second);
    std::ranges::sort(second);
    double all = 0;
    double as_strong = 0;
    std::vector<std::size_t> order(second.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    do {
        std::vector<double> shuffled(order.size());
        std::ranges::transform(order, shuffled.begin(), [&](std::size_t index) { return second[index]; });
        constexpr double rounding = 1e-12;
        as_strong += std::abs(correlation(first, shuffled)) >= std::abs(found) - rounding ? 1 : 0;
        ++all;
    } while (std::ranges::next_permutation(order).found);
    return {found, as_strong / all};
}

}  // namespace delabole
