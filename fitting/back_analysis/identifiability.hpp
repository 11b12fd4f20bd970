// What the data can tell about the parameters near the best point.
//
// J_ij = change of residual i (in standard deviations) per range of parameter j, by central differences with a step of
// 1e-4 of the range, moved inside the bounds where the best point is closer to one than that. A second step four times
// as long must agree within 1 % of the larger of 1 and the column's length, otherwise the status says so. Where the
// model fails on one side the difference is one-sided. Truncation: about 1e-8 times the third derivative per range.
// Where the model is fitted through a surrogate and its run at the best point has no answer or a data misfit whose root
// is off the surrogate's by more than 2 (twice the scatter where that is more than 1), that is all the status says.
// Source: Press et al., Numerical Recipes, 15.4 (singular values of the design matrix).
#pragma once

#include "fitting/back_analysis/search.hpp"
#include "fitting/mechanism/fit_result.hpp"

#include <span>

namespace delabole {

// The evaluations, but for that run, are added to the account. `best` needs a valid misfit.
// `scatter`: of runs that ought to be alike, standard deviations of data; meaningful where there is a surrogate.
Identifiability identify(const Search& search, std::span<const double> best, EvaluationCount& account,
                         double scatter = 0);

}  // namespace delabole
