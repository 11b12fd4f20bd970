// Turns a case's [fit] section into a back-analysis of its models, and [sensitivity] into a study of its model; and
// says of cases that can be read but describe an impossible slope which value is the cause, and why.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/sensitivity/sensitivity_problem.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
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

// The complaint about a failed check (the name of a PlaneFailureCheck), with the place of the value that caused it and,
// if the model knows it, the limit that it violates. Values that are not in the case, such as those of a critical
// search, are not reported.
Problem impossible(const CaseFile& file, std::string_view failure);

// The text of impossible_cases.csv, embedded in the program.
extern const std::string_view impossible_cases;

// All checks of a case before it is run, which `delabole check` makes: those of the model, then those of [fit] and
// [sensitivity]. Throws CaseError if any of them fails.
void refuse_impossible(const CaseFile& file);

}  // namespace delabole
