// The predictions of candidate measurements at draws of the posteriors that a back-analysis found.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "fitting/studies/information.hpp"
#include "fitting/work/progress.hpp"

#include <vector>

namespace delabole {

// Greatest number of draws of a posterior at which candidates are predicted, which gives reductions to about a
// hundredth. For a costly model, where each prediction is a run, there are fewer.
inline constexpr std::size_t most_draws = 2000;
inline constexpr std::size_t most_costly_draws = 256;

// Draws of each mechanism with a posterior, in the order of the result. The probabilities follow from the evidence,
// including field evidence, with all mechanisms equally likely beforehand. An input that is not free counts as known.
std::vector<MechanismDraws> draws_for_candidates(const FitProblem& problem, const FitResult& result,
                                                 ProgressMeter& progress);

// The expected information of each candidate of the problem. Empty without candidates, without posteriors, or once a
// stop is requested. The result depends neither on threads nor on ranks.
std::vector<CandidateInformation> information_of(const FitProblem& problem, const FitResult& result,
                                                 const FitProgressCallback& progress = {}, StopFlag stop = nullptr);

}  // namespace delabole
