// Answers to cases that consist of more than one result of the library.
#pragma once

#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/required.hpp"

#include <optional>
#include <string>
#include <vector>

namespace delabole {

struct PlaneFailureAnswer {
    ResolvedStudy resolved;
    PlaneFailureResult result{};                // the other members are empty unless its check is valid
    std::vector<Required> required{};           // in the order of the study's requests
    std::optional<OptimumBolt> optimum_bolt{};  // if there is a bolt
};

// Columns in one state, and the factor by which the strength was divided to reach it.
struct ColumnState {
    std::vector<ColumnResult> columns{};
    double factor = 1;
    std::string name{};  // of the state, for reports
};

struct SteppedBaseAnswer {
    ResolvedSteppedBase resolved;
    SteppedBaseResult result{};  // the other members are empty unless its check is valid
    ColumnSlope<> slope{};
    ColumnState as_given{};
    ColumnState limiting{};                       // as given if there is no limiting equilibrium
    std::vector<Required> required{};             // in the order of the study's requests
    std::vector<CableForce> required_cable{};     // in the order of the study's requests
    std::optional<BoundState> bound{};            // if it is asked for and not too large to compute
    std::optional<BoundState> bound_of_blocks{};  // if it is asked for and not too large to compute
};

struct RelaxationStudyAnswer {
    std::optional<SlopeScene> slope{};  // if joints cut the scene from a slope
    RelaxationRun run{};                // at the case's own values; its result tells whether there is an answer
    // The next two are set if a critical value is asked for and the run was not interrupted.
    std::optional<CriticalPlan> plan{};
    std::optional<CriticalAnswer> critical{};
    std::optional<OtherPath> other_path{};         // whether the value found holds on another one, if that was tried
    std::optional<double> fails_if_softer{};       // value at which the blocks fail with softer joints already
    std::optional<double> bound_of_statics{};      // greatest factor of safety, if a bound exists
    std::optional<EnsemblePrediction> ensemble{};  // if one is asked for and its first run has an answer

    bool has_means() const { return ensemble && ensemble->failure.empty(); }
};

}  // namespace delabole
