#include "cases/program/thesis/chapter_2/chapter_2.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

RankCorrelation rank_correlation(const std::vector<double>& parameter, const std::vector<double>& response) {
    const auto changes = [](const std::vector<double>& values) {
        return std::ranges::adjacent_find(values, std::ranges::not_equal_to{}) != values.end();
    };
    if (!changes(parameter) || !changes(response)) {
        return {0, 1};
    }
    const std::size_t count = parameter.size();
    std::vector<double> ranks(2 * count);
    const double value = gsl_stats_spearman(parameter.data(), 1, response.data(), 1, count, ranks.data());
    const double freedom = static_cast<double>(count) - 2;
    const double unexplained = std::max(1 - value * value, std::numeric_limits<double>::min());
    return {value, 2 * gsl_cdf_tdist_Q(std::abs(value) * std::sqrt(freedom / unexplained), freedom)};
}

}  // namespace delabole
