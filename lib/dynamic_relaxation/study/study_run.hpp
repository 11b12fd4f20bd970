// Start, checks and continuation of the runs of a study and of its searches.
#pragma once

#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <functional>

namespace delabole {

// Uses as many threads as speed up the run.
RelaxationSettings settings_for(const RelaxationStudy& study, const StudyWork& work, const RelaxationScene& scene);

// Runs to the end, or until the watch returns false, and returns whether the end was reached. The calls of `seen` do
// not depend on where a run was stopped: a state is seen once, before the step that leaves it.
bool go_on(Simulation& simulation, const StudyWork& work, const std::function<bool(double)>& watch,
           const std::function<void()>& keep, const std::function<void()>& seen);

// The run of the study as it stands now, if it ended here: without history and frames.
RelaxationRun ended_at(const RelaxationStudy& study, const Simulation& simulation);

// The state with displacements since the initial geometry instead of since the static solve at the start.
inline RelaxationState since_initial_geometry(RelaxationState state) {
    state.origin.assign(state.motion.size(), {});
    return state;
}

// Whether blocks are drawn lying on each other, so that they rest where they begin or fail.
bool is_drawn_in_contact(const RelaxationStudy& study);

// Whether blocks came to rest, but beyond the threshold of onset, in rotation far beyond, from where they began: the
// state at rest `begun_at`, or else the initial geometry. A static solve lets them creep as long as their balance
// improves, for instance until they lean on rock in front. False where something carries them along.
bool rests_beyond_onset(const Simulation& simulation, const RelaxationState* begun_at = nullptr);

// Whether statics finds no forces that hold the blocks in the initial geometry (`lacks_forces`), if it has to be asked:
// the run has no verdict, or they came to rest after motion by which they may have jammed.
bool cannot_stand(const Simulation& simulation);

// The run of a study with `retrogression`.
RelaxationRun run_in_stages(const RelaxationStudy& study, const StudyWork& work, StudyProgress& progress);

}  // namespace delabole
