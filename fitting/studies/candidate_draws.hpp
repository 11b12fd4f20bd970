// The candidates of a back-analysis, asked of the posteriors that it found.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "fitting/studies/information.hpp"
#include "fitting/work/progress.hpp"

#include <vector>

namespace delabole {

// Draws of a posterior at which candidates are predicted: errors of reductions are then about a hundredth. Of a costly
// model, where each is an evaluation, fewer have to do.
inline constexpr std::size_t most_draws = 2000;
inline constexpr std::size_t most_costly_draws = 256;

// Draws of each mechanism with a posterior, in the order of the result; probabilities from the evidence, field evidence
// included, all mechanisms equally likely beforehand. An input that is not free is known already.
std::vector<MechanismDraws> draws_for_candidates(const FitProblem& problem, const FitResult& result,
                                                 ProgressMeter& progress);

// How much each candidate of the problem would tell. Empty without candidates or without posteriors, and once a stop is
// requested. The result depends neither on threads nor on ranks.
std::vector<CandidateInformation> information_of(const FitProblem& problem, const FitResult& result,
                                                 const FitProgressCallback& progress = {}, StopFlag stop = nullptr);

}  // namespace delabole
