// Turns a case's [fit] section into a back-analysis of its models, and [sensitivity] into a study of its model.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/sensitivity/sensitivity_problem.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

// Throws CaseError if the case has no section of this name, one of those that `init` can show.
void require_section(bool given, const CaseFile& file, const std::string& section);

// The case needs a [fit] section. Throws CaseError with every name that the mechanisms' models do not have.
FitProblem fit_problem_of(const CaseFile& file, int threads, std::optional<std::uint64_t> seed);

// Removes the mechanisms whose model is costly, unless there are no others. Returns their names.
std::vector<std::string> leave_out_costly(CaseFit& fit);

// Keeps only the mechanisms of these names, in the order of the case. Throws UsageError for an unknown name.
void leave_mechanisms(CaseFit& fit, const std::vector<std::string>& names);

// The case needs a [sensitivity] section. Throws CaseError with every fault that check_study() finds, at its place.
SensitivityProblem sensitivity_problem_of(const CaseFile& file, int threads, std::optional<std::uint64_t> seed);

}  // namespace delabole
