// The curve in the plane of two parameters on which the factor of safety is 1.
#pragma once

#include "fitting/back_analysis/search.hpp"
#include "fitting/mechanism/fit_result.hpp"

#include <span>
#include <vector>

namespace delabole {

// One locus for each pair of free parameters on which the output "factor_of_safety" depends, the others at `best`; none
// when the model lacks that output. The plane is scanned along the parameter that moves the factor of safety more: for
// each of map_points values of the other, changes of sign of FS - 1 between 17 equally spaced values are closed in by
// bracketing to 1e-10 of the range. Roots that pair up within one sixteenth of the range are missed, and so is a jump
// across 1 (no root there). The evaluations are added to the account.
std::vector<FailureLocus> trace_failure_loci(const Search& search, std::span<const double> best,
                                             EvaluationCount& account);

}  // namespace delabole
