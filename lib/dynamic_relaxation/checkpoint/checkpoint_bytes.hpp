// The bytes of checkpoints in an envelope that tells whether they arrived whole (see checkpoint.hpp).
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
    other_version,  // of the format; also where just those bytes are damaged
    other_scene,    // or other settings
    damaged,        // cut short, lengthened or altered
};

// `hash` tells what the body depends on: it must be the same at opening.
std::string seal_checkpoint(std::uint64_t hash, std::string_view body);

// Mark, version, hash and length stand before the body.
inline constexpr std::size_t checkpoint_header_size = 32;

// Whether the rest of a file is worth reading, by its first bytes, as many as the header has, and its size.
// Never other_scene.
CheckpointCheck check_beginning(std::string_view beginning, std::uint64_t size);

struct OpenedCheckpoint {
    CheckpointCheck check = CheckpointCheck::not_a_checkpoint;
    std::string_view body = {};  // of the sealed bytes; empty unless ok
};

OpenedCheckpoint open_checkpoint(std::string_view sealed, std::uint64_t hash);

}  // namespace delabole
