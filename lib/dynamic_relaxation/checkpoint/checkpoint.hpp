// A run's state as bytes, from which it continues bit for bit as if it had never been stopped.
//
// The bytes are the same on every machine and for equal states: numbers in a fixed order, low byte first, no padding.
//   8 bytes  mark of a checkpoint
//   8        version of the format
//   8        hash of scene and settings
//   8        length of the state
//            state: members in their order, vectors after their length
//   8        checksum (FNV-1a, 64 bits) of all before it
#pragma once

#include "dynamic_relaxation/checkpoint/checkpoint_bytes.hpp"
#include "dynamic_relaxation/scene/settings.hpp"
#include "dynamic_relaxation/step/state.hpp"

#include <string>
#include <string_view>

namespace delabole {

struct RestoredState {
    CheckpointCheck check = CheckpointCheck::not_a_checkpoint;
    RelaxationState state = {};  // empty unless ok
};

std::string checkpoint_of(const RelaxationScene& scene, const RelaxationSettings& settings,
                          const RelaxationState& state);

// Reads bytes of any origin. They are refused unless `scene` and `settings` are those of the checkpoint; duration, most
// steps and number of threads may differ, because they do not change what a step does. One altered byte is always
// detected, several except with a probability of 2^-64; a returned state fits the scene, so that all its indices are
// valid.
RestoredState restore_checkpoint(std::string_view bytes, const RelaxationScene& scene,
                                 const RelaxationSettings& settings);

// Whether the lists of a state of any origin are those of the scene.
bool fits(const RelaxationState& state, const RelaxationScene& scene);

}  // namespace delabole
