// Finds faults of a back-analysis before it starts.
#pragma once

#include "fitting/posterior/fit_problem.hpp"

#include <string>
#include <vector>

namespace delabole {

// One sentence for each fault, naming mechanism or observation, value and the inequality it breaks: unknown or repeated
// parameter names, bounds that are reversed, not finite or outside the input's range, standard deviations that are not
// positive, values that are not finite, a profile of fewer than two distinct points, settings outside their range, a
// model without `predict`. A quantity that no mechanism predicts is no fault: it is reported as unexplained. Empty when
// fit() can start.
std::vector<std::string> check_problem(const FitProblem& problem);

}  // namespace delabole
