#include "dynamic_relaxation/step/outcome.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace delabole {

namespace {

struct Shift {
    double rotation;
    double displacement;
};

Shift shift_of(const Bodies& bodies, const std::vector<Motion>& motion, const std::vector<Motion>& origin,
               std::size_t block) {
    const Motion& now = motion[block];
    const Motion& then = origin[block];
    const PlanePoint<> change(now.x - then.x, now.y - then.y);
    if (!bodies.moved_base) {
        return {now.angle - then.angle, change.norm()};
    }
    const Motion& base_now = motion[*bodies.moved_base];
    const Motion& base_then = origin[*bodies.moved_base];
    Motion turn;
    turn.set_angle(base_now.angle - base_then.angle);
    const PlanePoint<> arm = bodies.centroid[block] - bodies.centroid[*bodies.moved_base] +
                             PlanePoint<>(then.x - base_then.x, then.y - base_then.y);
    const PlanePoint<> carried = PlanePoint<>(base_now.x - base_then.x, base_now.y - base_then.y) + turn.turned_by(arm);
    return {now.angle - then.angle - turn.angle, (change - carried).norm()};
}

// A block that has moved farther than these counts as moved.
struct Thresholds {
    double rotation;  // rad
    double slide;     // of the block's radius
};

Thresholds thresholds_of(const Bodies& bodies, const RelaxationState& state, const RelaxationSettings& settings) {
    constexpr double share_of_farthest = 0.1;
    double share = 1;
    if (state.onset_time >= 0) {
        share = std::clamp(share_of_farthest * farthest_motion(bodies, state, state.origin).in_thresholds(settings),
                           share_of_farthest, 1.0);
    }
    return {share * settings.onset_rotation, share * settings.onset_slide};
}

BlockMovement movement_of(const BlockOutcome& outcome, double radius, const Thresholds& thresholds) {
    const bool rotates = std::abs(outcome.rotation) > thresholds.rotation;
    if (std::abs(outcome.base_slip) <= thresholds.slide * radius) {
        return rotates                                            ? BlockMovement::rotates
               : outcome.displacement > thresholds.slide * radius ? BlockMovement::moves
                                                                  : BlockMovement::stays;
    }
    if (outcome.base_slip < 0) {
        return rotates ? BlockMovement::slides_forward_and_rotates : BlockMovement::slides_forward;
    }
    return rotates ? BlockMovement::slides_backward_and_rotates : BlockMovement::slides_backward;
}

// Whether the first face points more upward, and upward at all; of equally inclined faces, the one whose corner has
// slipped farther comes first.
bool goes_before(const SlipOverFace& one, const SlipOverFace& other) {
    constexpr double alike = 1e-6;
    if (one.upward <= alike) {
        return false;
    }
    const double difference = one.upward - other.upward;
    return std::abs(difference) > alike ? difference > 0 : std::abs(one.slip) > std::abs(other.slip);
}

bool is_base_contact(const Bodies& bodies, const ContactBlocks& contact) {
    return (bodies.fixed[contact.block] != 0) != (bodies.fixed[contact.other] != 0);
}

void for_each_base_contact(const Bodies& bodies, const RelaxationState& state, const auto& visit) {
    const std::span<const ContactBlocks> contacts = state.contacts.contact.blocks();
    for (std::size_t index = 0; index < contacts.size(); ++index) {
        if (is_base_contact(bodies, contacts[index])) {
            visit(index);
        }
    }
}

}  // namespace

MotionExtremes farthest_motion(const Bodies& bodies, const RelaxationState& state, const std::vector<Motion>& origin) {
    MotionExtremes farthest;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (bodies.fixed[block] == 0 && state.removed[block] == 0) {
            const Shift shift = shift_of(bodies, state.motion, origin, block);
            farthest.rotation = std::max(farthest.rotation, std::abs(shift.rotation));
            farthest.displacement = std::max(farthest.displacement, shift.displacement / bodies.radius[block]);
        }
    }
    return farthest;
}

void note_base_slip(const Bodies& bodies, const std::vector<Motion>& motion, const RelaxationContact& contact,
                    const ContactMemory& memory, const PlanePoint<>& up, std::vector<SlipOverFace>& noted) {
    if (!is_base_contact(bodies, contact) || (!memory.touching && memory.slip == 0)) {
        return;
    }
    // Slip is measured along the edge, of the corner's block relative to the other.
    const bool block_fixed = bodies.fixed[contact.block] != 0;
    const PlanePoint<> along = motion[contact.other].turned({contact.along_x, contact.along_y});
    const PlanePoint<> outward(along.y(), -along.x());
    const SlipOverFace slip{(block_fixed ? -1 : 1) * outward.dot(up),
                            (block_fixed ? -1 : 1) * memory.slip * (along.x() < 0 ? -1 : 1)};
    SlipOverFace& of_block = noted[block_fixed ? contact.other : contact.block];
    if (goes_before(slip, of_block)) {
        of_block = slip;
    }
}

void account_for_base_slip(const Bodies& bodies, const PlanePoint<>& up, RelaxationState& state) {
    for_each_base_contact(bodies, state, [&](std::size_t index) {
        note_base_slip(bodies, state.motion, state.contacts.contact[index], state.contacts.memory[index], up,
                       state.dropped_slip);
        state.contacts.memory.numbers()[index / packed_size].slip[index % packed_size] = 0;
    });
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        state.base_slip[block] += state.dropped_slip[block].slip;
        state.dropped_slip[block] = {};
    }
}

std::vector<BlockOutcome> block_outcomes(const Bodies& bodies, const PlanePoint<>& up, const RelaxationState& state,
                                         const RelaxationSettings& settings) {
    std::vector<SlipOverFace> since = state.dropped_slip;
    for_each_base_contact(bodies, state, [&](std::size_t index) {
        note_base_slip(bodies, state.motion, state.contacts.contact[index], state.contacts.memory[index], up, since);
    });
    const Thresholds thresholds = thresholds_of(bodies, state, settings);
    std::vector<BlockOutcome> outcomes(bodies.size());
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        BlockOutcome& outcome = outcomes[block];
        const Shift shift = shift_of(bodies, state.motion, state.origin, block);
        outcome.rotation = shift.rotation;
        outcome.displacement = shift.displacement;
        outcome.base_slip = state.base_slip[block] + since[block].slip;
        if (state.removed[block] != 0) {
            outcome.movement = state.removed[block] == has_left ? BlockMovement::left : BlockMovement::removed;
        } else if (bodies.fixed[block] != 0) {
            outcome.movement = BlockMovement::fixed;
        } else if (!state.held_by_corners.empty() && state.held_by_corners[block] != 0) {
            outcome.movement = BlockMovement::held_by_corners;
        } else {
            outcome.movement = movement_of(outcome, bodies.radius[block], thresholds);
        }
    }
    return outcomes;
}

std::optional<ContactName> deepest_contact(const Bodies& bodies, const RelaxationState& state) {
    std::optional<ContactName> deepest;
    for (std::size_t index = 0; index < state.contacts.contact.size(); ++index) {
        const auto [contact, law, memory, at] = contact_now(state.contacts, index, state.motion);
        if (!memory.beneath && !memory.yields && contact_weight(law, contact, at, memory.insists) > 0 &&
            -at.gap > (deepest ? deepest->overlap : 0)) {
            deepest = ContactName{contact.block, contact.corner - bodies.range[contact.block].begin, contact.other,
                                  contact.edge - bodies.range[contact.other].begin, -at.gap};
        }
    }
    return deepest;
}

}  // namespace delabole
