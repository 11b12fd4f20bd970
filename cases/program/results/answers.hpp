// Answers of models to their cases that hold more than one result of the library.
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
    PlaneFailureResult result{};                // the rest is empty unless its check is valid
    std::vector<Required> required{};           // in the order of the study
    std::optional<OptimumBolt> optimum_bolt{};  // where there is a bolt
};

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

struct RelaxationStudyAnswer {
    std::optional<SlopeScene> slope{};  // where the scene is one that joints cut
    RelaxationRun run{};                // at the case's own values; its result says whether
                                        // there is an answer
    // These two are set where a critical value is asked for and the run was not interrupted.
    std::optional<CriticalPlan> plan{};
    std::optional<CriticalAnswer> critical{};
    std::optional<double> bound_of_statics{};  // greatest factor of safety, where it can be bounded
    std::optional<Prediction> mean{};          // of the ensemble, where one is asked for and the first has an answer
};

}  // namespace delabole
