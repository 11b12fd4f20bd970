// Back-analysis of a failure: several mechanisms against the same evidence.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/search/minimise.hpp"
#include "fitting/work/progress.hpp"

namespace delabole {

// For each mechanism: minima of the misfit from many starts, identifiability, profile likelihoods with and without
// priors (copies where there are none), FS = 1 loci, misfit map, comparison with each observation; then the ranking.
// The result does not depend on the number of threads. Without free parameters the mechanism is evaluated as it is.
//
// A mechanism without a valid point and a search that did not converge are statuses. After a stop request the result
// holds what was finished. Throws std::invalid_argument with every sentence of check_problem, and whatever a model's
// `predict` throws.
FitResult fit(const FitProblem& problem, const FitProgressCallback& progress = {}, StopFlag stop = nullptr);

}  // namespace delabole
