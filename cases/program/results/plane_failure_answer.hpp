// The answer to a case of plane failure.
#pragma once

#include "plane_failure/plane_failure.hpp"
#include "plane_failure/required.hpp"

#include <optional>
#include <vector>

namespace delabole {

struct PlaneFailureAnswer {
    ResolvedStudy resolved;
    PlaneFailureResult result{};                // the rest is empty unless its check is valid
    std::vector<Required> required{};           // in the order of the study
    std::optional<OptimumBolt> optimum_bolt{};  // where there is a bolt
};

}  // namespace delabole
