// The force between a corner and an edge.
//
//   normal   spring in compression, w k_n overlap (Fig 5.4(a)); the tensile strength of a joint is that of its bonds
//            (bonds.hpp)
//   shear    spring over the displacement since first touch, w k_s shear, at most w (normal spring) tan(friction) +
//            cohesion (Fig 5.4(b)); with a peak, the residual angle and cohesion once it has slipped or opened
//            (Fig 5.4(c))
//   dashpots in parallel with both; in shear none acts while sliding (5.2.2), and none pulls the corner back
//
// w is the weight near an edge's end (contacts.hpp). Springs and dashpots are kept apart: a dashpot's force never
// enters the memory of the shear spring, as it did in the thesis's program.
#pragma once

#include "dynamic_relaxation/contact/contact_transition.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"
#include "numerics/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace delabole {

// The place of a corner over an edge, and its motion. Number: double, or lanes for many contacts at once.
template <class Number>
struct ContactPositionOf {
    Number normal_x;
    Number normal_y;
    Number gap;
    Number slide;     // along the edge, since the initial geometry
    Number position;  // along the edge from its start
    Number arm_x;     // from the block's centroid to the corner
    Number arm_y;
    Number other_arm_x;  // from the other's centroid to the corner
    Number other_arm_y;
    Number turn_sine;  // of the rotation of the corner's block against the edge's, since the initial geometry
    Number turn_versine;

    [[gnu::always_inline]] Number along_x() const { return -normal_y; }
    [[gnu::always_inline]] Number along_y() const { return normal_x; }
};

using ContactPosition = ContactPositionOf<double>;

template <class Number>
DELABOLE_INLINED ContactPositionOf<Number> locate(const ContactShapeOf<Number>& contact, const MotionOf<Number>& block,
                                                  const MotionOf<Number>& other) {
    // The order of the sums avoids negations.
    const Number back_x = block.versine * contact.arm_x + block.sine * contact.arm_y;
    const Number turned_y = block.sine * contact.arm_x - block.versine * contact.arm_y;
    const Number carried_back_x = other.versine * contact.other_arm_x + other.sine * contact.other_arm_y;
    const Number carried_y = other.sine * contact.other_arm_x - other.versine * contact.other_arm_y;
    // Vector from the place to which the other block has carried the corner's initial position to the corner itself.
    // Only changes are added up, so that the overlap keeps its digits however far away the origin is.
    const Number change_x = (block.x - other.x) + (carried_back_x - back_x);
    const Number change_y = (block.y - other.y) + (turned_y - carried_y);
    const Number along_x = contact.along_x - (other.versine * contact.along_x + other.sine * contact.along_y);
    const Number along_y = contact.along_y - (other.versine * contact.along_y - other.sine * contact.along_x);
    ContactPositionOf<Number> at;
    at.normal_x = along_y;
    at.normal_y = -along_x;
    at.gap = contact.gap + (along_y * change_x - along_x * change_y);
    at.slide = along_x * change_x + along_y * change_y;
    at.position = contact.from_start + at.slide;
    at.arm_x = contact.arm_x - back_x;
    at.arm_y = contact.arm_y + turned_y;
    at.other_arm_x = contact.other_arm_x - carried_back_x + change_x;
    at.other_arm_y = contact.other_arm_y + carried_y + change_y;
    at.turn_sine = (block.sine - other.sine) + (block.versine * other.sine - block.sine * other.versine);
    at.turn_versine = (block.versine + other.versine) - (block.versine * other.versine + block.sine * other.sine);
    return at;
}

DELABOLE_INLINED ContactPosition locate(const RelaxationContact& contact, const Motion& block, const Motion& other) {
    return locate<double>(contact, block, other);
}

// Place of the corner at the rival of its edge: the overlap, and the distance along the rival from their common end.
template <class Number>
struct RivalPlace {
    Number overlap;
    Number along;
};

template <class Number>
DELABOLE_INLINED RivalPlace<Number> place_at_rival(const EdgeEndsOf<Number>& ends, const Number& length_to_end,
                                                   const ContactPositionOf<Number>& at) {
    const Number overlap = -at.gap;
    const auto at_start = ends.rival > Number{};
    const Number t = select(at_start, at.position, length_to_end - at.slide);
    Number sine = ends.rival_sine;
    Number cosine = ends.rival_cosine;
    const auto turns = absolute(ends.rival) > Number{} + 1.0;
    if (any(turns)) {
        const Number turn = select(turns, select(at_start, at.turn_sine, Number{} - at.turn_sine), Number{});
        const Number versine = select(turns, at.turn_versine, Number{});
        sine = ends.rival_sine - (versine * ends.rival_sine - turn * ends.rival_cosine);
        cosine = ends.rival_cosine - (versine * ends.rival_cosine + turn * ends.rival_sine);
    }
    return {t * sine - overlap * cosine, t * cosine + overlap * sine};
}

// In a trial an edge bears until it is this many times as deep as its rival (corner_choice.hpp).
constexpr double deepest_in_trial = 64;

template <class Number>
DELABOLE_INLINED Number contact_weight(const EdgeEndsOf<Number>& ends, const Number& length_to_end,
                                       const ContactPositionOf<Number>& at, const MaskOf<Number>& insists) {
    const Number overlap = -at.gap;
    // The rise is 1 for a weight that begins at -0.5, 0.5 for one that begins at 0.5, and least for one that begins
    // at 1.
    const auto rise_from = [](const auto& least) { return 0.75 - 0.5 * least; };
    // A ramp is no steeper than the overlap allows, because a weight that changes faster acts as a stiffer spring. At
    // an end where a corner does not bear, it begins to bear at half its overlap from that end: a point can stand on a
    // point. Where no overlap reaches the least rise, nothing has to be divided.
    const bool deep = any(overlap * ends.inverse_blend > rise_from(1.0));
    const auto ramp = [&](const Number& depth, const Number& rise) {
        return deep ? select(depth * ends.inverse_blend > rise, rise / depth, ends.inverse_blend) : ends.inverse_blend;
    };
    const Number to_end = length_to_end - at.slide;
    const Number at_start = ends.start_weight + at.position * ramp(overlap, rise_from(ends.start_weight));
    const Number at_end = ends.end_weight + to_end * ramp(overlap, rise_from(ends.end_weight));
    Number weight = lesser(at_start, at_end);
    const auto has_rival = ends.rival != Number{};
    if (any(has_rival)) {
        const auto [other_overlap, other_along] = place_at_rival<Number>(ends, length_to_end, at);
        const Number half = Number{} + 0.5;
        Number against =
            half + ramp(lesser(overlap, other_overlap), half) * greater(other_overlap - overlap, -other_along);
        const auto alone = ends.alone > Number{};
        if (any(alone)) {
            // The weight is proportional to the overlap over the rival: where the blocks are apart there, they do not
            // overlap.
            const Number one = Number{} + 1.0;
            const Number deepest = select(insists, other_overlap * deepest_in_trial, other_overlap);
            const Number both = select(overlap > deepest, Number{}, other_overlap * ramp(overlap, one));
            against = select(alone, both, against);
        }
        weight = lesser(weight, select(has_rival, against, weight));
    }
    return lesser(greater(weight, Number{}), Number{} + 1.0);
}

inline double contact_weight(const EdgeEnds& ends, const RelaxationContact& contact, const ContactPosition& at,
                             bool insists) {
    return contact_weight<double>(ends, contact.to_end, at, insists);
}

// Whether a contact that yields in a trial bears again.
template <class Number>
DELABOLE_INLINED auto takes_over(const EdgeEndsOf<Number>& ends, const Number& length_to_end,
                                 const ContactPositionOf<Number>& at) {
    return place_at_rival<Number>(ends, length_to_end, at).overlap > -at.gap * deepest_in_trial;
}

inline bool takes_over(const EdgeEnds& ends, const RelaxationContact& contact, const ContactPosition& at) {
    return takes_over<double>(ends, contact.to_end, at);
}

// The speeds at which a corner leaves its edge and moves along it, m/s.
template <class Number>
struct ContactVelocity {
    Number opening;
    Number shearing;
};

// `at`: of a corner or of the middle of a face.
template <class Number, class Position>
DELABOLE_INLINED ContactVelocity<Number> velocity_of(const Position& at, const MotionOf<Number>& block,
                                                     const MotionOf<Number>& other) {
    const Number x = (block.vx - other.vx) - (block.spin * at.arm_y - other.spin * at.other_arm_y);
    const Number y = (block.vy - other.vy) + (block.spin * at.arm_x - other.spin * at.other_arm_x);
    return {at.normal_x * x + at.normal_y * y, at.along_x() * x + at.along_y() * y};
}

// Force of a corner that bears: it slips as far as its strength requires, and its dashpots act. The shear spring has
// already followed the corner. `damping`: energy dissipated so far, including the drags of the last step up to now.
template <class Number>
DELABOLE_INLINED ForceOnCornerOf<Number> bear(const JointLawOf<Number>& law, const ContactPositionOf<Number>& at,
                                              const ContactVelocity<Number>& velocity, const Number& weight,
                                              const Number& force_before, const Number& damping,
                                              const double& half_step, ContactMemoryOf<Number>& memory) {
    memory.place = at.slide;
    const Number overlap = -at.gap;
    const Number pressing = law.normal_stiffness * overlap;
    const Number residual = pressing * law.residual_friction + law.residual_cohesion;
    const Number strength = shear_strength<Number>(law, pressing, memory.broken);
    const Number held_by_spring = -law.shear_stiffness * memory.shear;
    memory.sliding = slips(held_by_spring, strength);
    const Number held_with_dashpot = law.shear_dashpot * velocity.shearing;
    Number shear = held_by_spring - held_with_dashpot;
    Number shear_drag = -weight * held_with_dashpot;
    if (any(memory.sliding)) {
        const Number held = with_sign(residual, held_by_spring);
        const Number slipped = (held - held_by_spring) / law.shear_stiffness;
        // The first slip also releases what the spring held beyond the residual strength.
        const Number mean_force = (lesser(select(memory.broken, force_before, strength), strength) + residual) * 0.5;
        memory.friction =
            select(memory.sliding, memory.friction + weight * mean_force * absolute(slipped), memory.friction);
        memory.slip = select(memory.sliding, memory.slip + slipped, memory.slip);
        memory.shear = select(memory.sliding, memory.shear - slipped, memory.shear);
        shear = select(memory.sliding, held, shear);
        shear_drag = select(memory.sliding, Number{}, shear_drag);
        memory.broken = memory.broken | memory.sliding;
    }
    const Number damped = greater(pressing - law.normal_dashpot * velocity.opening, Number{});
    memory.normal_drag = weight * (damped - pressing);
    memory.shear_drag = shear_drag;
    memory.damping = damping - half_step * (memory.normal_drag * velocity.opening + shear_drag * velocity.shearing);
    ForceOnCornerOf<Number> force;
    force.x = weight * (at.normal_x * damped + at.along_x() * shear);
    force.y = weight * (at.normal_y * damped + at.along_y() * shear);
    force.moment = at.arm_x * force.y - at.arm_y * force.x;
    force.other_moment = at.other_arm_y * force.x - at.other_arm_x * force.y;
    return force;
}

// Energy dissipated until now, where both drags have acted since the last step. A drag acts from half a step before its
// force is evaluated to half a step after: the energy balance takes half of its work with each of the two velocities.
template <class Number>
DELABOLE_INLINED Number damping_until_now(const ContactNumbersOf<Number>& memory,
                                          const ContactVelocity<Number>& velocity, const double& half_step) {
    return memory.damping - half_step * (memory.normal_drag * velocity.opening + memory.shear_drag * velocity.shearing);
}

// Ends the contact of a corner that leaves its edge. The energy of its springs is lost; in the shear spring it is large
// where friction is high. `beneath`: the corner is below the edge's line, having left past the edge's end.
DELABOLE_INLINED void let_go(const JointLaw& law, double weight, double damping, bool beneath,
                             ContactMemoryOf<double>& memory) {
    memory.friction += weight * law.shear_stiffness * memory.shear * memory.shear / 2;
    memory.shear = 0;
    memory.damping = damping;
    memory.normal_drag = memory.shear_drag = 0;
    memory.touching = memory.sliding = memory.yields = false;
    memory.insists = memory.insists && weight > 0;
    memory.broken = true;
    memory.beneath = beneath;
}

// A contact that begins to touch reads this from its touching twin.
struct TwinThatTouches {
    double overlap;  // decides whether the contact takes over
    double shear;    // taken over by a corner that came along the edge, but not by one that came down on it
};

// A corner that came beneath its edge bears once its twin touches and is about as deep.
inline bool twin_hands_over(double overlap, double overlap_of_twin) {
    return overlap <= 1.5 * overlap_of_twin;
}

// Advances the memory by one step and returns the force at its end. Velocities are those that led here, half a step
// ago. `twin` is set if the contact's twin touches. `open_by`, m: set to the distance from the edge if the corner is
// not touching and apart from the edge; otherwise left unchanged.
DELABOLE_INLINED ForceOnCorner advance_contact(const ContactLaw& law, const RelaxationContact& contact,
                                               const std::optional<TwinThatTouches>& twin, const Motion& block,
                                               const Motion& other, double step, ContactMemoryOf<double>& memory,
                                               double& open_by) {
    const ContactPosition at = locate(contact, block, other);
    const double overlap = -at.gap;
    const bool apart = overlap <= 0;
    if (!memory.touching && apart) {
        memory.beneath = false;
        open_by = at.gap;
        return {};
    }
    if (!holds_of_one(over_edge({.touching = memory.touching,
                                 .beneath = memory.beneath,
                                 .yields = memory.yields,
                                 .apart = apart,
                                 .handed_over = twin && twin_hands_over(overlap, twin->overlap),
                                 .taken_over = memory.yields && takes_over(law, contact, at)}))) {
        return {};
    }
    if (!memory.touching) {
        memory.beneath = memory.yields = false;
    }
    const ContactVelocity<double> velocity = velocity_of<double>(at, block, other);
    const double damping = damping_until_now<double>(memory, velocity, step / 2);
    const double weight = contact_weight(law, contact, at, memory.insists);
    if (!holds_of_one(bearing_of(1, apart, weight == 0))) {
        let_go(law, weight, damping, !apart && law.rival == 0, memory);
        return {};
    }
    const double force_before = law.shear_stiffness * std::abs(memory.shear);
    if (!memory.touching) {
        memory.touching = true;
        // As a corner comes along the edge, its weight grows from zero while that of its twin falls: by taking over the
        // twin's shear it keeps the sum. A corner that comes down on the edge has its weight at once: its spring begins
        // unstrained, as it would otherwise hold energy that no work has supplied.
        const bool came_down = overlap + velocity.opening * step <= 0;
        memory.shear = twin && !came_down ? twin->shear : 0;
    } else {
        memory.shear += at.slide - memory.place;
    }
    return bear<double>(law, at, velocity, weight, force_before, damping, step / 2, memory);
}

// A contact of a list as it is now, in loops that are not part of each step.
struct ContactNow {
    RelaxationContact contact;
    ContactLaw law;
    ContactMemory memory;
    ContactPosition at;
};

inline ContactNow contact_now(const ContactList& list, std::size_t index, const std::vector<Motion>& motion) {
    const RelaxationContact contact = list.contact[index];
    return {contact, list.law_of(contact), list.memory[index],
            locate(contact, motion[contact.block], motion[contact.other])};
}

// Energy of both springs, J/m.
inline double elastic_energy(const ContactLaw& law, const RelaxationContact& contact, const ContactMemory& memory,
                             const ContactPosition& at) {
    if (!memory.touching) {
        return 0;
    }
    const double overlap = std::max(-at.gap, 0.0);  // none at an end that has just lifted off (bonds.hpp)
    return contact_weight(law, contact, at, memory.insists) *
           (law.normal_stiffness * overlap * overlap + law.shear_stiffness * memory.shear * memory.shear) / 2;
}

}  // namespace delabole
