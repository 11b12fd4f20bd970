// From a case's [fit] section to a back-analysis of its models.
#pragma once

#include "cases/case_file.hpp"
#include "fitting/fit_problem.hpp"

#include <cstdint>
#include <optional>

namespace delabole {

// The case needs a [fit] section. Throws CaseError with every name that does not fit the mechanisms' models.
FitProblem fit_problem_of(const CaseFile& file, int threads, std::optional<std::uint64_t> seed);

}  // namespace delabole
