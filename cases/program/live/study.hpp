// The studies of a case on the page: the probability of failure of its [sensitivity], the fitted ranges of its [fit].
#pragma once

#include "cases/program/case/case_file.hpp"
#include "fitting/posterior/fit_problem.hpp"

#include <optional>
#include <string>
#include <vector>

namespace delabole {

// Whether the case has something to study whose model is not costly.
bool has_study(const CaseFile& file, const std::optional<FitProblem>& fit);

// Sentences as `delabole sensitivity` (samples alone) and `delabole fit` print them of these inputs. What takes longer
// than some seconds is stopped, and a sentence says so. Uncertain and fitted inputs keep their distributions, priors
// and bounds, whatever the page has made of their values.
std::vector<std::string> studied(const CaseFile& file, const std::optional<FitProblem>& fit);

}  // namespace delabole
