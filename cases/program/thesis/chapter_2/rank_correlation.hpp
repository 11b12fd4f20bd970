// Whether one quantity rises or falls with another, of a few values (Spearman 1904).
#pragma once

#include <vector>

namespace delabole {

struct RankCorrelation {
    double value;         // -1 to 1; 0 where either does not change
    double significance;  // share of all orders of the responses whose correlation is as strong, either way
};

// Ties have the mean of their ranks. Both as long, at least two; exact, so that the cost is the factorial of their
// number: at most nine.
RankCorrelation rank_correlation(const std::vector<double>& parameter, const std::vector<double>& response);

}  // namespace delabole
