// The misfit over the plane of the first two free parameters.
#pragma once

#include "fitting/back_analysis/search.hpp"
#include "fitting/mechanism/fit_result.hpp"

#include <optional>
#include <span>

namespace delabole {

// `count` equally spaced values, both ends of the interval included; count >= 2.
std::vector<double> grid(const Interval& range, int count);

// Nothing with fewer than two free parameters. `best` and its misfit with priors are those of the fit; the evaluations
// are added to the account.
std::optional<MisfitMap> map_misfit(const Search& search, std::span<const double> best, double misfit,
                                    EvaluationCount& account);

}  // namespace delabole
