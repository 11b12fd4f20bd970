// The result of a run of dynamic relaxation.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"
#include "dynamic_relaxation/scene/settings.hpp"
#include "dynamic_relaxation/step/state.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace delabole {

enum class RelaxationOutcome {
    undecided,            // neither at rest nor failed when time ran out
    equilibrium,          // unbalanced forces and kinetic energy have decayed
    held_by_corners,      // at rest, but without forces of corners on corners blocks would move (corner_choice.hpp)
    onset,                // blocks moved past the threshold of onset; the run was told to stop there
    collapse,             // blocks moved past the threshold of collapse
    overlap_too_large,    // of a contact, or of the outlines of two blocks: one has penetrated the other
    energy_not_balanced,  // at the end, the energy balance lacks more than `most_energy_lacking`
    motion_not_finite,
    interrupted,
    scene_not_valid,
};

inline bool is_failure(RelaxationOutcome outcome) {
    return outcome == RelaxationOutcome::onset || outcome == RelaxationOutcome::collapse;
}

// Share of the energy converted, and stored in springs at the start, that a run's energy balance may lack for its
// outcome to be accepted: several times what impacts lose. A smaller energy than lifts the blocks by this number of
// their settlements cannot move them: blocks that only stand convert no more than that.
constexpr double most_energy_lacking = 0.1;
constexpr double settlements_lacking = 10;

enum class BlockMovement {
    stays,
    slides_forward,
    slides_backward,
    rotates,
    slides_forward_and_rotates,
    slides_backward_and_rotates,
    moves,            // otherwise: on blocks that are not fixed, or falling
    held_by_corners,  // at rest, but would move without forces of corners on corners
    fixed,
    removed,  // by a schedule
    left,     // below the elevation at which blocks that have left the slope are removed
};

constexpr bool has_failed(BlockMovement movement) {
    return movement != BlockMovement::stays && movement != BlockMovement::fixed && movement != BlockMovement::removed;
}

constexpr bool is_gone(BlockMovement movement) {
    return movement == BlockMovement::removed || movement == BlockMovement::left;
}

struct BlockOutcome {
    // Judged against the thresholds of onset, or, after onset, against a tenth of the farthest motion if that is less:
    // a run that ends with the first block beyond its threshold thus shows which others have begun to move with it.
    BlockMovement movement = BlockMovement::stays;
    // Since the start; if all fixed blocks move as one, relative to them.
    double rotation = 0;      // rad, anticlockwise: towards -x for a block that topples out of the slope
    double displacement = 0;  // m, of the centroid
    // m, plastic slip over the most upward face of a fixed block, of the corner that slips farthest; negative: forward,
    // towards -x. Accuracy: a block that rotates over a corner changes corners, and so this value, within fifty steps.
    double base_slip = 0;
    static constexpr auto fields() {
        return FieldTable{section<&BlockOutcome::movement>("how it has moved"),
                          number<&BlockOutcome::rotation>(Dimension::angle, "anticlockwise, out of the slope"),
                          number<&BlockOutcome::displacement>(Dimension::length, "of the centroid"),
                          number<&BlockOutcome::base_slip>(Dimension::length, "over its base, forward negative")};
    }
};

struct BoltOutcome {
    double force = 0;    // N/m
    double yielded = 0;  // m
    static constexpr auto fields() {
        return FieldTable{number<&BoltOutcome::force>(Dimension::force_per_length, "tension, where it is greatest"),
                          number<&BoltOutcome::yielded>(Dimension::length, "by which it has stretched for good")};
    }
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
    std::uint64_t pair_checks = 0;  // checks of pairs of blocks for contacts
    std::uint64_t contacts_evaluated = 0;
    double step = 0;  // s, the last one
};

struct RelaxationResult {
    RelaxationOutcome outcome = RelaxationOutcome::scene_not_valid;
    SceneFault fault = {};                  // set if the scene is not valid
    double time = 0;                        // s of model time
    double tilt = 0;                        // rad, of gravity at the end
    double tilt_of_base = 0;                // rad, against gravity: `tilt` plus the rotation of a moved base
    std::optional<double> onset_time = {};  // s
    std::optional<FirstCrack> first_crack = {};
    std::size_t broken_bonds = 0;
    std::optional<StartBalance> start_balance = {};  // absent if the start was not preloaded
    double unbalanced_ratio = 0;                     // recent greatest unbalanced force over the block's weight
    EnergyBalance energy_balance = {};
    std::optional<ContactName> deepest = {};
    std::optional<BlockOverlap> overlap = {};  // the greatest share measured, every 5000 steps and at the end
    RelaxationCost cost = {};
    std::vector<BlockOutcome> block = {};
    std::vector<BoltOutcome> bolt = {};

    // The blocks rest, but not as drawn, or no forces hold them there (failed_at_rest.hpp).
    bool failed_at_rest() const { return onset_time == 0.0; }
};

// Extremes over all free blocks; if all fixed blocks move as one, relative to them.
struct MotionExtremes {
    double rotation = 0;      // rad
    double displacement = 0;  // of the centroid, in radii of the block

    // More than 1: beyond the thresholds of onset.
    double in_thresholds(const RelaxationSettings& settings) const {
        return std::max(rotation / settings.onset_rotation, displacement / settings.onset_slide);
    }
};

// Motion of so many thresholds of onset is failure, even if it slows down. Blocks that have been pushed, or that jam
// only after they have leaned, may pass a single threshold and come to rest.
inline constexpr double far_beyond_onset = 2;

// Since all blocks were at `origin`.
MotionExtremes farthest_motion(const Bodies& bodies, const RelaxationState& state, const std::vector<Motion>& origin);

// Records the slip of a contact over an upward fixed face for its free block, if it has precedence over the recorded
// one. `up`: a unit vector against gravity.
void note_base_slip(const Bodies& bodies, const std::vector<Motion>& motion, const RelaxationContact& contact,
                    const ContactMemory& memory, const PlanePoint<>& up, std::vector<SlipOverFace>& noted);

// Adds the slip of contacts since the last call to `base_slip`.
void account_for_base_slip(const Bodies& bodies, const PlanePoint<>& up, RelaxationState& state);

std::vector<BlockOutcome> block_outcomes(const Bodies& bodies, const PlanePoint<>& up, const RelaxationState& state,
                                         const RelaxationSettings& settings);

std::optional<ContactName> deepest_contact(const Bodies& bodies, const RelaxationState& state);

}  // namespace delabole
