#include "dynamic_relaxation/contact_sweep.hpp"

#include "dynamic_relaxation/contact_law.hpp"
#include "dynamic_relaxation/lanes.hpp"

#include <bit>

namespace delabole {

namespace {

// Leaves alone what is open by so much until its blocks have come half as far: the corner may be farther from the other
// block's centroid than that block's own corners are, but not twice as far.
DELABOLE_INLINED void note_opening(const ContactSweep& sweep, std::size_t index, double open_by) {
    const RelaxationContact& contact = sweep.contact[index];
    sweep.open_until[index] =
        open_by > 0 ? sweep.way[contact.block] + sweep.way[contact.other] + open_by / 2 : not_open;
}

// Numbers are gathered as late as can be: there are more of them than registers. Rows are members in the order in which
// bodies.hpp and contacts.hpp declare them.

DELABOLE_INLINED void gather_pose(const Rows& rows, MotionOf<Lanes>& motion) {
    const FourLanes four = gather_four(rows, 0);
    motion.x = four[0];
    motion.y = four[1];
    motion.sine = four[2];
    motion.versine = four[3];
}

DELABOLE_INLINED void gather_velocity(const Rows& rows, MotionOf<Lanes>& motion) {
    const FourLanes four = gather_four(rows, 4);
    motion.vx = four[0];
    motion.vy = four[1];
    motion.spin = four[2];
}

DELABOLE_INLINED ContactShape<Lanes> gather_shape(const Rows& rows) {
    const FourLanes one = gather_four(rows, 0);
    const FourLanes two = gather_four(rows, 4);
    return {one[0], one[1], one[2], one[3], two[0], two[1], two[2], two[3], gather(rows, 8)};
}

DELABOLE_INLINED void gather_weighing(const Rows& rows, ContactLawOf<Lanes>& law) {
    const FourLanes one = gather_four(rows, 0);
    law.start_weight = one[0];
    law.end_weight = one[1];
    law.inverse_blend = one[2];
    law.rival = one[3];
    const FourLanes two = gather_four(rows, 4);
    law.rival_sine = two[0];
    law.rival_cosine = two[1];
    law.normal_stiffness = two[2];
    law.shear_stiffness = two[3];
}

DELABOLE_INLINED void gather_strength(const Rows& rows, ContactLawOf<Lanes>& law) {
    const FourLanes four = gather_four(rows, 8);
    law.normal_dashpot = four[0];
    law.shear_dashpot = four[1];
    law.friction = four[2];
    law.residual_friction = four[3];
    law.cohesion = gather(rows, 12);
}

DELABOLE_INLINED void gather_memory(const Rows& rows, ContactMemoryOf<Lanes>& memory) {
    const FourLanes one = gather_four(rows, 0);
    memory.shear = one[0];
    memory.place = one[1];
    memory.damping = one[2];
    const FourLanes two = gather_four(rows, 4);
    memory.normal_drag = two[0];
    memory.shear_drag = two[1];
    memory.slip = two[2];
    memory.friction = two[3];
}

// What four contacts in a row have to do. A bit for each.
struct Duty {
    unsigned wake = 0;   // those that cannot be left open
    unsigned bear = 0;   // of these, those that touch and whose blocks have moved
    unsigned alone = 0;  // of these, those whose blocks have moved and that may begin to touch
};

DELABOLE_INLINED Duty duty_of_four(const ContactSweep& sweep, std::size_t first) {
    const bool all_touch = sweep.memory[first].touching && sweep.memory[first + 1].touching &&
                           sweep.memory[first + 2].touching && sweep.memory[first + 3].touching;
    if (all_touch && sweep.moved == nullptr) {
        return {all_lanes, all_lanes, 0};
    }
    Duty duty;
    const auto look_at = [&](unsigned lane) __attribute__((always_inline)) {
        const std::size_t index = first + lane;
        if (sweep.stays_open(index)) {
            return;
        }
        duty.wake |= 1U << lane;
        if (sweep.concerned(index)) {
            (sweep.memory[index].touching ? duty.bear : duty.alone) |= 1U << lane;
        }
    };
    look_at(0);
    look_at(1);
    look_at(2);
    look_at(3);
    return duty;
}

// As advance_contact leaves a contact that does not touch yet.
DELABOLE_INLINED void stay_open(const ContactSweep& sweep, std::size_t index, double gap) {
    sweep.memory[index].beneath = false;
    sweep.force[index] = {};
    note_opening(sweep, index, gap);
}

// Whether a contact that begins to touch may take over from one of the four, whose order counts then.
bool may_take_over(const ContactSweep& sweep, std::size_t first, unsigned alone) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        const std::uint32_t twin = sweep.contact[first + lane].twin;
        if ((alone >> lane & 1U) != 0 && twin != no_twin && twin - first < lane_count) {
            return true;
        }
    }
    return false;
}

// Those of four contacts in a row that go on bearing and those that stay open, at once. Returns which they were.
DELABOLE_INLINED unsigned evaluate_together(const ContactSweep& sweep, std::size_t first, const Duty& duty) {
    const RelaxationContact* const contact = sweep.contact + first;
    ContactMemory* const kept = sweep.memory + first;
    ForceOnCorner* const force_of = sweep.force + first;
    const auto motion_of = [&](std::uint32_t block) __attribute__((always_inline)) {
        return &sweep.motion[block].x;
    };
    const auto law_of = [&](std::size_t lane) __attribute__((always_inline)) {
        return &sweep.law[contact[lane].law].start_weight;
    };
    const Rows blocks{motion_of(contact[0].block), motion_of(contact[1].block), motion_of(contact[2].block),
                      motion_of(contact[3].block)};
    const Rows others{motion_of(contact[0].other), motion_of(contact[1].other), motion_of(contact[2].other),
                      motion_of(contact[3].other)};
    const Rows laws{law_of(0), law_of(1), law_of(2), law_of(3)};
    const Rows memories{&kept[0].shear, &kept[1].shear, &kept[2].shear, &kept[3].shear};
    const ContactShape<Lanes> shape =
        gather_shape({contact[0].arm.data(), contact[1].arm.data(), contact[2].arm.data(), contact[3].arm.data()});
    MotionOf<Lanes> block;
    MotionOf<Lanes> other;
    gather_pose(blocks, block);
    gather_pose(others, other);
    const ContactPositionOf<Lanes> at = locate<Lanes>(shape, block, other);
    const unsigned apart = bits(at.gap >= 0.0);
    const unsigned open = duty.alone & apart;
    if (duty.alone != open && may_take_over(sweep, first, duty.alone & ~apart)) {
        return 0;
    }
    for (std::size_t lane = 0; open >> lane != 0; ++lane) {
        if ((open >> lane & 1U) != 0) {
            stay_open(sweep, first + lane, at.gap[lane]);
        }
    }
    ContactLawOf<Lanes> law;
    gather_weighing(laws, law);
    const Lanes weight = contact_weight<Lanes>(law, shape.to_end, at);
    const unsigned bearing = duty.bear & ~apart & ~bits(weight == 0.0);
    if (bearing == 0) {
        return open;
    }
    gather_velocity(blocks, block);
    gather_velocity(others, other);
    const ContactVelocity<Lanes> velocity = velocity_of<Lanes>(at, block, other);
    ContactMemoryOf<Lanes> memory;
    gather_memory(memories, memory);
    const auto broken = [&](std::size_t lane) __attribute__((always_inline)) {
        return kept[lane].broken ? -1 : 0;
    };
    memory.broken = LaneMask{broken(0), broken(1), broken(2), broken(3)};
    const double half_step = sweep.step / 2;
    const Lanes damping = damping_until_now<Lanes>(memory, velocity, half_step);
    const Lanes force_before = law.shear_stiffness * absolute(memory.shear);
    memory.shear += at.slide - memory.place;
    gather_strength(laws, law);
    const ForceOnCornerOf<Lanes> force =
        bear<Lanes>(law, at, velocity, weight, force_before, damping, half_step, memory);
    const FourLanes forces = transposed(force.x, force.y, force.moment, force.other_moment);
    const FourLanes first_half = transposed(memory.shear, memory.place, memory.damping, memory.overlap);
    const FourLanes second_half = transposed(memory.normal_drag, memory.shear_drag, memory.slip, memory.friction);
    const unsigned sliding = bits(memory.sliding);
    const auto keep = [&](std::size_t lane) __attribute__((always_inline)) {
        store_lanes(forces[lane], &force_of[lane].x);
        store_lanes(first_half[lane], &kept[lane].shear);
        store_lanes(second_half[lane], &kept[lane].normal_drag);
        kept[lane].sliding = (sliding >> lane & 1U) != 0;
        kept[lane].broken = kept[lane].broken || kept[lane].sliding;
    };
    if (bearing == all_lanes && sliding == 0) {
        const auto keep_held = [&](std::size_t lane) __attribute__((always_inline)) {
            store_lanes(forces[lane], &force_of[lane].x);
            store_lanes(first_half[lane], &kept[lane].shear);
            store_lanes(second_half[lane], &kept[lane].normal_drag);
            kept[lane].sliding = false;
        };
        keep_held(0);
        keep_held(1);
        keep_held(2);
        keep_held(3);
    } else {
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            if ((bearing >> lane & 1U) != 0) {
                keep(lane);
            }
        }
    }
    return bearing | open;
}

void evaluate_marked(const ContactSweep& sweep, std::size_t first, unsigned marked) {
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        if ((marked >> lane & 1U) != 0) {
            evaluate_contact(sweep, first + lane);
        }
    }
}

// Into the nearest cache, before they are wanted: of each array what four contacts take, in lines of 64 bytes. Past the
// end it does nothing.
DELABOLE_INLINED void fetch_ahead(const ContactSweep& sweep, std::size_t index) {
    constexpr std::size_t ahead = 4 * lane_count;
    const auto fetch = [&](const auto* first) __attribute__((always_inline)) {
        constexpr std::size_t line = 64;
        const auto* const bytes = reinterpret_cast<const char*>(first + index + ahead);
        for (std::size_t at = 0; at < lane_count * sizeof(*first); at += line) {
            __builtin_prefetch(bytes + at);
        }
    };
    fetch(sweep.contact);
    fetch(sweep.memory);
    fetch(sweep.force);
}

// `after`: what is done with each contact that may have a force, in their order.
template <class AfterOne>
DELABOLE_INLINED std::size_t go_through(const ContactSweep& sweep, std::size_t begin, std::size_t end,
                                        const AfterOne& after) {
    std::size_t count = 0;
    std::size_t index = begin;
    for (; index + lane_count <= end; index += lane_count) {
        fetch_ahead(sweep, index);
        const Duty duty = duty_of_four(sweep, index);
        if (duty.wake == 0) {
            continue;
        }
        unsigned left = duty.bear | duty.alone;
        count += static_cast<std::size_t>(std::popcount(left));
        if (duty.bear != 0) {
            left &= ~evaluate_together(sweep, index, duty);
        }
        if (left != 0) {
            evaluate_marked(sweep, index, left);
        }
        after(index);
        after(index + 1);
        after(index + 2);
        after(index + 3);
    }
    for (; index < end; ++index) {
        if (sweep.stays_open(index)) {
            continue;
        }
        if (sweep.concerned(index)) {
            evaluate_contact(sweep, index);
            ++count;
        }
        after(index);
    }
    return count;
}

}  // namespace

void evaluate_contact(const ContactSweep& sweep, std::size_t index) {
    const RelaxationContact& contact = sweep.contact[index];
    double open_by = 0;
    sweep.force[index] = advance_contact(sweep.law[contact.law], contact, sweep.memory[index], sweep.memory,
                                         sweep.motion[contact.block], sweep.motion[contact.other], sweep.step, open_by);
    note_opening(sweep, index, open_by);
}

DELABOLE_FOR_EACH_PROCESSOR
std::size_t evaluate_contacts(ContactSweep sweep, std::size_t begin, std::size_t end) {
    return go_through(sweep, begin, end, [](std::size_t /*index*/) __attribute__((always_inline)){});
}

DELABOLE_FOR_EACH_PROCESSOR
std::size_t evaluate_and_sum_contacts(ContactSweep sweep, std::size_t begin, std::size_t end, BlockForce* sum) {
    return go_through(
        sweep, begin, end, [&](std::size_t index) __attribute__((always_inline)) {
            const RelaxationContact& contact = sweep.contact[index];
            const Lanes force = load_lanes(&sweep.force[index].x);
            double* const own = &sum[contact.block].x;
            store_lanes(load_lanes(own) + force, own);
            double* const other = &sum[contact.other].x;
            store_lanes(load_lanes(other) + opposite(force), other);
        });
}

}  // namespace delabole
