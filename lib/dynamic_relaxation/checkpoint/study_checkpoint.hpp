// A study under way as bytes: what a killed `delabole run` goes on from. See checkpoint.hpp for the envelope.
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

// Any bytes may come in; what is returned fits the study. Refused unless all that the answers depend on is as it was.
RestoredProgress restore_checkpoint(std::string_view bytes, const RelaxationStudy& study, KeepFrames frames);

}  // namespace delabole
