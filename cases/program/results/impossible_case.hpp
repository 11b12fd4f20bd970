// Cases that can be read but describe an impossible slope: which value is the cause, and why.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <string_view>

namespace delabole {

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
