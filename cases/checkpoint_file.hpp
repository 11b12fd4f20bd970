// Checkpoints of dynamic relaxation on the disk.
#pragma once

#include "dynamic_relaxation/settings.hpp"
#include "dynamic_relaxation/state.hpp"

#include <filesystem>

namespace delabole {

// As write_file_atomically: a run killed at any moment leaves the old checkpoint or the new one. OutputError where that
// is impossible.
void write_checkpoint(const std::filesystem::path& path, const RelaxationScene& scene,
                      const RelaxationSettings& settings, const RelaxationState& state);

// CaseError, with the file's name, where there is none to be read or none of this scene and these settings (see
// restore_checkpoint).
RelaxationState read_checkpoint(const std::filesystem::path& path, const RelaxationScene& scene,
                                const RelaxationSettings& settings);

}  // namespace delabole
