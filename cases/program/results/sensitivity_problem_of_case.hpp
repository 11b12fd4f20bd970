// From a case's [sensitivity] section to a study of its model.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "fitting/sensitivity/sensitivity_problem.hpp"

#include <cstdint>
#include <optional>

namespace delabole {

// The case needs a [sensitivity] section. Throws CaseError with everything that check_study() finds, at its place.
SensitivityProblem sensitivity_problem_of(const CaseFile& file, int threads, std::optional<std::uint64_t> seed);

}  // namespace delabole
