// A case that reads well and yet describes a slope that cannot be: which of its values is to blame, and for what.
#pragma once

#include "cases/program/case/case_file.hpp"

#include <string_view>

namespace delabole {

// The complaint about a failed check (the name of a PlaneFailureCheck), at the place of the value that broke it and
// with the limit that it broke, where the model can tell. Values not in the case, such as those of a critical search,
// are not blamed.
Problem impossible(const CaseFile& file, std::string_view failure);

// impossible_cases.csv when the program was built.
extern const std::string_view impossible_cases;

// All that can be said against a case before it is run, which is what `delabole check` says: the model has the last
// word, then [fit] and [sensitivity]. Throws CaseError where there is something.
void refuse_impossible(const CaseFile& file);

}  // namespace delabole
