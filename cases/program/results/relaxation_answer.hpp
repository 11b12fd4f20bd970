// The answer to a case of dynamic relaxation.
#pragma once

#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <optional>

namespace delabole {

struct RelaxationStudyAnswer {
    std::optional<SlopeScene> slope{};  // where the scene is one that joints cut
    RelaxationRun run{};                // at the case's own values; its result says whether
                                        // there is an answer
    // Where a critical value is asked for and the run was not interrupted.
    std::optional<CriticalPlan> plan{};
    std::optional<CriticalAnswer> critical{};
    std::optional<double> bound_of_statics{};  // greatest factor of safety, where it can be bounded
    std::optional<Prediction> mean{};          // of the ensemble, where one is asked for and the first has an answer
};

}  // namespace delabole
