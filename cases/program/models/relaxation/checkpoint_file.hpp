// Checkpoints of dynamic relaxation on the disk.
#pragma once

#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <filesystem>
#include <string>

namespace delabole {

// Does what write_file_atomically does, in a folder that is created where it is missing: a run killed at any moment
// leaves the old checkpoint or the new one. OutputError where that is impossible.
void write_checkpoint(const std::filesystem::path& path, const RelaxationStudy& study, KeepFrames frames,
                      const StudyProgress& progress);

// Removes the checkpoint with what runs that were killed while they wrote it have left.
void remove_checkpoint(const std::filesystem::path& path);

struct KeptProgress {
    StudyProgress progress = {};  // empty unless found
    bool found = false;
    std::string refusal = {};  // what is wrong with what stands there; empty: nothing, or nothing stands there
    bool of_other = false;     // what stands there is work of another case or of another version, not to be lost
};

// See restore_checkpoint.
KeptProgress read_checkpoint(const std::filesystem::path& path, const RelaxationStudy& study, KeepFrames frames);

}  // namespace delabole
