// A study in progress as bytes, from which an interrupted `delabole run` continues. See checkpoint.hpp for the
// envelope.
#pragma once

#include "dynamic_relaxation/checkpoint/checkpoint_bytes.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <string>
#include <string_view>

namespace delabole {

std::string checkpoint_of(const RelaxationStudy& study, KeepFrames frames, const StudyProgress& progress);

struct RestoredProgress {
    CheckpointCheck check = CheckpointCheck::not_a_checkpoint;
    StudyProgress progress = {};  // empty unless ok
};

// Reads bytes of any origin; returned progress fits the study. Refused unless everything that the answers depend on is
// unchanged.
RestoredProgress restore_checkpoint(std::string_view bytes, const RelaxationStudy& study, KeepFrames frames);

}  // namespace delabole
