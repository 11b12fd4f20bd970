// What a run of dynamic relaxation found.
#pragma once

#include "dynamic_relaxation/scene.hpp"
#include "dynamic_relaxation/settings.hpp"
#include "dynamic_relaxation/state.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace delabole {

enum class RelaxationOutcome {
    undecided,    // neither at rest nor failed when time ran out
    equilibrium,  // unbalanced forces and kinetic energy have died away
    onset,        // blocks moved past the threshold of onset; the run was told to stop there
    collapse,     // blocks moved past the threshold of collapse
    overlap_too_large,
    motion_not_finite,
    interrupted,
    scene_not_valid,
};

constexpr std::array<std::string_view, 8> enum_names(RelaxationOutcome) {
    return {"undecided",         "equilibrium",       "onset",       "collapse",
            "overlap_too_large", "motion_not_finite", "interrupted", "scene_not_valid"};
}

enum class BlockMovement { stays, slides_forward, slides_backward, rotates, slides_and_rotates, fixed, removed };

constexpr std::array<std::string_view, 7> enum_names(BlockMovement) {
    return {"stays", "slides_forward", "slides_backward", "rotates", "slides_and_rotates", "fixed", "removed"};
}

struct BlockOutcome {
    BlockMovement movement = BlockMovement::stays;
    // Since the start; where a base turns, as seen from it.
    double rotation = 0;      // rad, anticlockwise: towards -x for a block that topples out of the slope
    double displacement = 0;  // m, of the centroid
    double base_slip = 0;     // m, over fixed blocks; negative: forward, towards -x
};

// The contact with the greatest overlap.
struct ContactName {
    std::size_t block = 0;
    std::size_t corner = 0;  // of the block's outline
    std::size_t other = 0;
    std::size_t edge = 0;  // of the other's outline
    double overlap = 0;    // m
};

struct RelaxationCost {
    std::uint64_t steps = 0;
    std::uint64_t looks = 0;  // at pairs of blocks, for contacts
    std::uint64_t contacts_evaluated = 0;
    double step = 0;  // s, the last one
};

struct RelaxationResult {
    RelaxationOutcome outcome = RelaxationOutcome::scene_not_valid;
    SceneFault fault = {};                  // where the scene is not valid
    double time = 0;                        // s of model time
    double tilt = 0;                        // rad, of gravity at the end
    std::optional<double> onset_time = {};  // s
    std::optional<FirstCrack> first_crack = {};
    std::size_t broken_bonds = 0;
    std::optional<StartBalance> start_balance = {};  // absent where nothing was preloaded
    double unbalanced_ratio = 0;                     // greatest unbalanced force over the block's weight of late
    EnergyLedger ledger = {};
    std::optional<ContactName> deepest = {};
    RelaxationCost cost = {};
    std::vector<BlockOutcome> block = {};
};

// Of all free blocks, since the start; where a base turns, as seen from it.
struct MotionExtremes {
    double rotation = 0;      // rad
    double displacement = 0;  // of the centroid, in radii of the block
};

MotionExtremes farthest_motion(const Bodies& bodies, const RelaxationState& state);

// Adds what a contact has slipped over a fixed block to what its free block has.
void add_base_slip(const Bodies& bodies, const std::vector<Motion>& motion, const RelaxationContact& contact,
                   const ContactMemory& memory, std::vector<double>& base_slip);

std::vector<BlockOutcome> block_outcomes(const Bodies& bodies, const RelaxationState& state,
                                         const RelaxationSettings& settings);

std::optional<ContactName> deepest_contact(const Bodies& bodies, const RelaxationState& state);

}  // namespace delabole
