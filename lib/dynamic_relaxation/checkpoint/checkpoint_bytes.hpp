// The bytes of checkpoints in an envelope that shows whether they are complete (see checkpoint.hpp).
#pragma once

#include "dynamic_relaxation/checkpoint/checkpoint_members.hpp"
#include "numerics/archive.hpp"
#include "numerics/fnv_1a.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace delabole {

template <>
inline constexpr bool is_put_together<ContactArray> = true;
template <>
inline constexpr bool is_put_together<MemoryArray> = true;

enum class CheckpointCheck {
    ok,
    not_a_checkpoint,
    other_version,  // of the format; also if exactly these bytes are damaged
    other_scene,    // or other settings
    damaged,        // cut short, lengthened or altered
};

// `hash` identifies what the body depends on: it must be the same when the checkpoint is opened.
std::string seal_checkpoint(std::uint64_t hash, std::string_view body);

// The header before the body holds mark, version, hash and length.
inline constexpr std::size_t checkpoint_header_size = 32;

// Judges from the first bytes of a file, as many as the header has, and from its size whether the rest is worth
// reading. Never returns other_scene.
CheckpointCheck check_beginning(std::string_view beginning, std::uint64_t size);

struct OpenedCheckpoint {
    CheckpointCheck check = CheckpointCheck::not_a_checkpoint;
    std::string_view body = {};  // of the sealed bytes; empty unless ok
};

OpenedCheckpoint open_checkpoint(std::string_view sealed, std::uint64_t hash);

}  // namespace delabole
