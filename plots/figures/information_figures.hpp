// What a next measurement would tell, and how well a back-analysis finds known parameters again.
#pragma once

#include "fitting/studies/information.hpp"
#include "fitting/studies/recovery.hpp"
#include "plots/drawing/figure.hpp"

#include <vector>

namespace delabole {

// Expected reduction of the standard deviation of each parameter by each candidate, over mechanisms, with two standard
// errors either way; the candidate that tells most on top.
Figure information_figure(const std::vector<CandidateInformation>& candidates);

// How often the truth had each rank among the draws, a bar for a tenth of the ranks, with the band in which 95 % of the
// bars of uniform ranks lie. One parameter of a recovery that has some.
Figure rank_figure(const MechanismRecovery& recovery, const ParameterRecovery& parameter);

// Shares of the 68 and 95 % intervals that held the truth, with their 95 % intervals.
Figure coverage_figure(const MechanismRecovery& recovery);

}  // namespace delabole
