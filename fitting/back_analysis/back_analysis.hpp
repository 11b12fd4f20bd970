// Back-analysis of a failure: several mechanisms are compared with the same evidence.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/search/minimise.hpp"
#include "fitting/work/progress.hpp"

namespace delabole {

// Finds, for each mechanism, the minima of the misfit from many starts, identifiability, profile likelihoods with and
// without priors (copies if there are none), FS = 1 loci, the misfit map and the comparison with each observation, and
// then ranks the mechanisms. The result does not depend on the number of threads. A mechanism without free parameters
// is evaluated as it is.
//
// A mechanism without a valid point and a search that did not converge are reported by status. After a stop request the
// result holds what was finished. Throws std::invalid_argument with every sentence of check_problem, and whatever a
// model's `predict` throws.
FitResult fit(const FitProblem& problem, const FitProgressCallback& progress = {}, StopFlag stop = nullptr);

}  // namespace delabole
