// Start, checks and continuation of the runs of a study and of its searches.
#pragma once

#include "dynamic_relaxation/study/failed_at_rest.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <atomic>
#include <functional>
#include <optional>

namespace delabole {

// Uses as many threads as speed up the run.
RelaxationSettings settings_for(const RelaxationStudy& study, const StudyWork& work, const RelaxationScene& scene);

// A run from its start, whose static solve `stop` ends early, or from a state in which one was left.
Simulation begun_or_resumed(const RelaxationScene& scene, const RelaxationSettings& settings,
                            std::optional<RelaxationState> state, const std::atomic<bool>* stop);

// Runs to the end, or until the watch returns false, and returns whether the end was reached. The calls of `seen` do
// not depend on where a run was stopped: a state is seen once, before the step that leaves it.
bool go_on(Simulation& simulation, const StudyWork& work, const std::function<bool(double)>& watch,
           const std::function<void()>& keep, const std::function<void()>& seen);

// The run of the study as it stands now, if it ended here: without history and frames.
RelaxationRun ended_at(const RelaxationStudy& study, const Simulation& simulation);

InitialContact initial_contact(const RelaxationStudy& study);

// The run of a study with `retrogression`.
RelaxationRun run_in_stages(const RelaxationStudy& study, const StudyWork& work, StudyProgress& progress);

}  // namespace delabole
