// The answer to a case of columns on a stepped base.
#pragma once

#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"

#include <optional>
#include <string>
#include <vector>

namespace delabole {

// Columns in one state, and by what the strength was divided for it.
struct ColumnState {
    std::vector<ColumnResult> columns{};
    double factor = 1;
    std::string name{};  // of the state, in words
};

struct SteppedBaseAnswer {
    ResolvedSteppedBase resolved;
    SteppedBaseResult result{};  // the rest is empty unless its check is valid
    ColumnSlope<> slope{};
    ColumnState as_given{};
    ColumnState limiting{};                       // as given where there is no limiting equilibrium
    std::vector<Required> required{};             // in the order of the study
    std::vector<CableForce> required_cable{};     // likewise
    std::optional<BoundState> bound{};            // where it is asked for and can be afforded
    std::optional<BoundState> bound_of_blocks{};  // likewise
};

}  // namespace delabole
