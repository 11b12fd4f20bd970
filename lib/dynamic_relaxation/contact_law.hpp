// The force between a corner and an edge.
//
//   normal   spring in compression, w k_n overlap; with tensile strength, in tension too until that is reached
//   (Fig 5.4(a)) shear    spring over the displacement since first touch, w k_s shear, at most w (normal spring)
//   tan(friction) + cohesion
//            (Fig 5.4(b)); with a peak, the residual angle once it has slipped or opened (Fig 5.4(c))
//   dashpots in parallel with both, none in shear while sliding (5.2.2), and none that would pull the corner back
//
// w is the weight near an edge's end (contacts.hpp). Springs and dashpots are kept apart: a dashpot's force never
// enters the memory of the shear spring, as it did in the thesis's program.
#pragma once

#include "dynamic_relaxation/contacts.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

// Where a corner is over an edge, and how it moves.
struct ContactPosition {
    double normal_x;
    double normal_y;
    double gap;
    double slide;     // along the edge, since the drawing
    double position;  // along the edge from its start
    double arm_x;     // from the block's centroid to the corner
    double arm_y;
    double other_arm_x;  // from the other's centroid to the corner
    double other_arm_y;

    double along_x() const { return -normal_y; }
    double along_y() const { return normal_x; }
};

[[gnu::always_inline]] inline ContactPosition locate(const RelaxationContact& contact, const Motion& block,
                                                     const Motion& other) {
    // Sums are so ordered that nothing has to be negated.
    const double back_x = block.versine * contact.arm.x() + block.sine * contact.arm.y();
    const double turned_y = block.sine * contact.arm.x() - block.versine * contact.arm.y();
    const double carried_back_x = other.versine * contact.other_arm.x() + other.sine * contact.other_arm.y();
    const double carried_y = other.sine * contact.other_arm.x() - other.versine * contact.other_arm.y();
    // From where the other block has carried the corner's place in the drawing to the corner. Only changes are added
    // up: the overlap keeps its digits however far away the origin is.
    const double change_x = (block.x - other.x) + (carried_back_x - back_x);
    const double change_y = (block.y - other.y) + (turned_y - carried_y);
    const double along_x = contact.along.x() - (other.versine * contact.along.x() + other.sine * contact.along.y());
    const double along_y = contact.along.y() - (other.versine * contact.along.y() - other.sine * contact.along.x());
    ContactPosition at;
    at.normal_x = along_y;
    at.normal_y = -along_x;
    at.gap = contact.gap + (along_y * change_x - along_x * change_y);
    at.slide = along_x * change_x + along_y * change_y;
    at.position = contact.from_start + at.slide;
    at.arm_x = contact.arm.x() - back_x;
    at.arm_y = contact.arm.y() + turned_y;
    at.other_arm_x = contact.other_arm.x() - carried_back_x + change_x;
    at.other_arm_y = contact.other_arm.y() + carried_y + change_y;
    return at;
}

inline double contact_weight(const ContactLaw& law, const RelaxationContact& contact, const ContactPosition& at) {
    const double overlap = -at.gap;
    // A ramp is no steeper than the overlap allows: a weight that changed faster would be a stiffer spring. Where a
    // corner does not bear at an end, it begins to bear half as far from it as it is deep: a point on a point holds.
    const auto ramp = [&](double depth, double rise) {
        return depth * law.inverse_blend > rise ? rise / depth : law.inverse_blend;
    };
    // 1 for a weight that begins at -0.5, and 0.5 for one that begins at 0.5.
    const auto rise_from = [](double least) { return 0.75 - 0.5 * least; };
    const double to_end = contact.to_end - at.slide;
    const double at_start = law.start_weight + at.position * ramp(overlap, rise_from(law.start_weight));
    const double at_end = law.end_weight + to_end * ramp(overlap, rise_from(law.end_weight));
    double weight = std::min(at_start, at_end);
    if (law.rival != 0) {
        // With t the way from the common end, the rival's overlap and the way along it.
        const double t = law.rival > 0 ? at.position : to_end;
        const double other_overlap = t * law.rival_sine - overlap * law.rival_cosine;
        const double other_way = t * law.rival_cosine + overlap * law.rival_sine;
        weight = std::min(
            weight, 0.5 + ramp(std::min(overlap, other_overlap), 0.5) * std::max(other_overlap - overlap, -other_way));
    }
    return std::min(std::max(weight, 0.0), 1.0);
}

// Advances the memory by one step and gives the force at its end. Velocities are those that led here, half a step ago.
// `memories`: of all contacts, among them the twin's. `open_by`, m: how far the corner is from touching, where it has
// not touched before; else it is left alone.
// Called once in the innermost loop: a result that goes through memory there costs a third more.
[[gnu::always_inline]] inline ForceOnCorner advance_contact(const ContactLaw& law, const RelaxationContact& contact,
                                                            ContactMemory& memory, const ContactMemory* memories,
                                                            const Motion& block, const Motion& other, double step,
                                                            double& open_by) {
    const ContactPosition at = locate(contact, block, other);
    const double overlap = -at.gap;
    if (!memory.touching) {
        if (overlap <= 0) {
            memory.beneath = false;
            open_by = at.gap;
            return {};
        }
        // A twin hands over where both are about as deep.
        const ContactMemory* twin = contact.twin == no_twin ? nullptr : memories + contact.twin;
        if (memory.beneath && (twin == nullptr || !twin->touching || overlap > 1.5 * twin->overlap)) {
            return {};
        }
        memory.beneath = false;
    }
    const double velocity_x = (block.vx - other.vx) - (block.spin * at.arm_y - other.spin * at.other_arm_y);
    const double velocity_y = (block.vy - other.vy) + (block.spin * at.arm_x - other.spin * at.other_arm_x);
    const double opening = at.normal_x * velocity_x + at.normal_y * velocity_y;
    const double shearing = at.along_x() * velocity_x + at.along_y() * velocity_y;
    // A drag acts half a step on both sides of its moment: the books count half with each velocity.
    const double half_step = step / 2;
    const double damping = memory.damping - half_step * (memory.normal_drag * opening + memory.shear_drag * shearing);
    const bool bonded = law.tension > 0 && !memory.broken;
    const double weight = contact_weight(law, contact, at);
    const auto open = [&] {
        // What the springs held is lost: of the shear spring much, where friction is great.
        memory.friction += weight * law.shear_stiffness * memory.shear * memory.shear / 2;
        memory.touching = memory.sliding = false;
        memory.broken = true;
        memory.shear = 0;
        memory.damping = damping;
        memory.normal_drag = memory.shear_drag = 0;
    };
    if (weight == 0 || (overlap <= 0 && !bonded)) {
        open();
        memory.beneath = overlap > 0 && law.rival == 0;
        return {};
    }
    const double force_before = law.shear_stiffness * std::abs(memory.shear);
    if (!memory.touching) {
        memory.touching = true;
        const bool taken_over = contact.twin != no_twin && memories[contact.twin].touching;
        memory.shear = taken_over ? memories[contact.twin].shear : 0;
    } else {
        memory.shear += at.slide - memory.place;
    }
    memory.place = at.slide;
    memory.overlap = overlap;
    double normal = law.normal_stiffness * overlap;
    if (normal < -law.tension) {
        memory.friction += weight * normal * overlap / 2;
        open();
        return {};
    }
    double shear = -law.shear_stiffness * memory.shear;
    const double pressing = std::max(normal, 0.0);
    const double residual = pressing * law.residual_friction;
    const double strength = memory.broken ? residual : pressing * law.friction + law.cohesion;
    memory.sliding = std::abs(shear) > strength;
    double shear_drag = 0;
    if (memory.sliding) {
        const double held = std::copysign(residual, shear);
        const double slipped = (held - shear) / law.shear_stiffness;
        // A first slip also sets free what the spring held beyond the residual strength.
        const double mean_force =
            (memory.broken ? std::min(force_before, strength) + residual : strength + residual) / 2;
        memory.friction += weight * mean_force * std::abs(slipped);
        memory.broken = true;
        memory.slip += slipped;
        memory.shear -= slipped;
        shear = held;
    } else {
        shear_drag = -weight * law.shear_dashpot * shearing;
        shear -= law.shear_dashpot * shearing;
    }
    const double damped = std::max(normal - law.normal_dashpot * opening, std::min(normal, 0.0));
    const double normal_drag = weight * (damped - normal);
    memory.normal_drag = normal_drag;
    memory.shear_drag = shear_drag;
    memory.damping = damping - half_step * (normal_drag * opening + shear_drag * shearing);
    normal = damped;
    ForceOnCorner force;
    force.x = weight * (at.normal_x * normal + at.along_x() * shear);
    force.y = weight * (at.normal_y * normal + at.along_y() * shear);
    force.moment = at.arm_x * force.y - at.arm_y * force.x;
    force.other_moment = at.other_arm_y * force.x - at.other_arm_x * force.y;
    return force;
}

// J/m, in both springs.
inline double elastic_energy(const ContactLaw& law, const RelaxationContact& contact, const ContactMemory& memory,
                             const Motion& block, const Motion& other) {
    if (!memory.touching) {
        return 0;
    }
    const ContactPosition at = locate(contact, block, other);
    return contact_weight(law, contact, at) *
           (law.normal_stiffness * at.gap * at.gap + law.shear_stiffness * memory.shear * memory.shear) / 2;
}

}  // namespace delabole
