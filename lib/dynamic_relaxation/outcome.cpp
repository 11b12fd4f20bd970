#include "dynamic_relaxation/outcome.hpp"

#include "dynamic_relaxation/contact_law.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

struct Shift {
    double rotation;
    double displacement;
};

Shift shift_of(const Bodies& bodies, const RelaxationState& state, std::size_t block) {
    const Motion& now = state.motion[block];
    const Motion& then = state.origin[block];
    const PlanePoint<> change(now.x - then.x, now.y - then.y);
    if (!bodies.turned_base) {
        return {now.angle - then.angle, change.norm()};
    }
    const Motion& base_now = state.motion[*bodies.turned_base];
    const Motion& base_then = state.origin[*bodies.turned_base];
    Motion turn;
    turn.set_angle(base_now.angle - base_then.angle);
    const PlanePoint<> arm = bodies.centroid[block] - bodies.centroid[*bodies.turned_base] +
                             PlanePoint<>(then.x - base_then.x, then.y - base_then.y);
    const PlanePoint<> carried = PlanePoint<>(base_now.x - base_then.x, base_now.y - base_then.y) + turn.turned_by(arm);
    return {now.angle - then.angle - turn.angle, (change - carried).norm()};
}

BlockMovement movement_of(const BlockOutcome& outcome, double radius, const RelaxationSettings& settings) {
    const bool rotates = std::abs(outcome.rotation) > settings.onset_rotation;
    const bool slides = std::abs(outcome.base_slip) > settings.onset_slide * radius;
    if (rotates) {
        return slides ? BlockMovement::slides_and_rotates : BlockMovement::rotates;
    }
    if (!slides) {
        return BlockMovement::stays;
    }
    return outcome.base_slip < 0 ? BlockMovement::slides_forward : BlockMovement::slides_backward;
}

}  // namespace

MotionExtremes farthest_motion(const Bodies& bodies, const RelaxationState& state) {
    MotionExtremes farthest;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (bodies.fixed[block] == 0 && state.removed[block] == 0) {
            const Shift shift = shift_of(bodies, state, block);
            farthest.rotation = std::max(farthest.rotation, std::abs(shift.rotation));
            farthest.displacement = std::max(farthest.displacement, shift.displacement / bodies.radius[block]);
        }
    }
    return farthest;
}

void add_base_slip(const Bodies& bodies, const std::vector<Motion>& motion, const RelaxationContact& contact,
                   const ContactMemory& memory, std::vector<double>& base_slip) {
    const bool block_fixed = bodies.fixed[contact.block] != 0;
    if (memory.slip == 0 || block_fixed == (bodies.fixed[contact.other] != 0)) {
        return;
    }
    // Slip is counted along the edge, of the corner's block against the other.
    const double forward = motion[contact.other].turned({contact.along_x, contact.along_y}).x();
    const double slip = (block_fixed ? -1 : 1) * memory.slip * (forward < 0 ? -1 : 1);
    // Both corners of a base slip alike; each contact stands for half of it.
    base_slip[block_fixed ? contact.other : contact.block] += slip / 2;
}

std::vector<BlockOutcome> block_outcomes(const Bodies& bodies, const RelaxationState& state,
                                         const RelaxationSettings& settings) {
    std::vector<double> slip = state.base_slip;
    for (std::size_t index = 0; index < state.contacts.contact.size(); ++index) {
        add_base_slip(bodies, state.motion, state.contacts.contact[index], state.contacts.memory[index], slip);
    }
    std::vector<BlockOutcome> outcomes(bodies.size());
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        BlockOutcome& outcome = outcomes[block];
        const Shift shift = shift_of(bodies, state, block);
        outcome.rotation = shift.rotation;
        outcome.displacement = shift.displacement;
        outcome.base_slip = slip[block];
        if (state.removed[block] != 0) {
            outcome.movement = BlockMovement::removed;
        } else if (bodies.fixed[block] != 0) {
            outcome.movement = BlockMovement::fixed;
        } else {
            outcome.movement = movement_of(outcome, bodies.radius[block], settings);
        }
    }
    return outcomes;
}

std::optional<ContactName> deepest_contact(const Bodies& bodies, const RelaxationState& state) {
    std::optional<ContactName> deepest;
    for (std::size_t index = 0; index < state.contacts.contact.size(); ++index) {
        const RelaxationContact contact = state.contacts.contact[index];
        const ContactPosition at = locate(contact, state.motion[contact.block], state.motion[contact.other]);
        if (!state.contacts.memory[index].beneath && contact_weight(state.contacts.law_of(contact), contact, at) > 0 &&
            -at.gap > (deepest ? deepest->overlap : 0)) {
            deepest = ContactName{contact.block, contact.corner - bodies.range[contact.block].begin, contact.other,
                                  contact.edge - bodies.range[contact.other].begin, -at.gap};
        }
    }
    return deepest;
}

}  // namespace delabole
