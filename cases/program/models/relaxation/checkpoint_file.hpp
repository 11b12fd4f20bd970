// Checkpoints of dynamic relaxation on disk.
#pragma once

#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <filesystem>
#include <string>

namespace delabole {

// Writes the file with write_file_atomically and creates its folder if it is missing: a run that is killed at any
// moment leaves the old checkpoint or the new one. Throws OutputError if that is impossible.
void write_checkpoint(const std::filesystem::path& path, const RelaxationStudy& study, KeepFrames frames,
                      const StudyProgress& progress);

// Removes the checkpoint, and what runs that were killed while writing it have left.
void remove_checkpoint(const std::filesystem::path& path);

struct KeptProgress {
    StudyProgress progress = {};  // empty if no checkpoint was found
    bool found = false;
    std::string refusal = {};  // the fault of the file at this path; empty if it has none or does not exist
    bool of_other = false;     // the file holds work of another case or version, which must not be lost
};

// Reads the file and restores the progress as restore_checkpoint does.
KeptProgress read_checkpoint(const std::filesystem::path& path, const RelaxationStudy& study, KeepFrames frames);

}  // namespace delabole
