#include "dynamic_relaxation/contact/contact_sweep.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"
#include "numerics/lanes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstring>
#include <optional>
#include <utility>

namespace delabole {

namespace {

// Leaves an open contact alone until its blocks have moved half as far as it is open: the corner may be farther from
// the other block's centroid than that block's own corners are, but not twice as far.
DELABOLE_INLINED void note_opening(const ContactSweep& sweep, std::size_t index, double open_by) {
    const ContactBlocks& contact = sweep.contact[index];
    sweep.open_until[index] =
        open_by > 0 ? sweep.travelled[contact.block] + sweep.travelled[contact.other] + open_by / 2 : not_open;
}

// Each row holds the members in the order in which bodies.hpp and contacts.hpp declare them.
static_assert(sizeof(Motion) == 8 * sizeof(double) && sizeof(EdgeEnds) == sizeof(Motion) &&
              sizeof(JointLaw) == sizeof(Motion));

template <IsLanes Lanes>
DELABOLE_INLINED MotionOf<Lanes> gather_motion(const Rows<Lanes>& rows) {
    const std::array<Lanes, 8> of = gather_eight<Lanes>(rows);
    return {of[0], of[1], of[2], of[3], of[4], of[5], of[6], of[7]};
}

template <IsLanes Lanes>
DELABOLE_INLINED EdgeEndsOf<Lanes> gather_ends(const Rows<Lanes>& rows) {
    const std::array<Lanes, 8> of = gather_eight<Lanes>(rows);
    return {of[0], of[1], of[2], of[3], of[4], of[5], of[6], of[7]};
}

// In most groups all contacts have the same law.
template <IsLanes Lanes>
DELABOLE_INLINED JointLawOf<Lanes> gather_joint(const ContactSweep& sweep, const ContactBlocks* contact) {
    unsigned differ = 0;
    for (std::size_t lane = 1; lane < lane_count<Lanes>; ++lane) {
        differ |= contact[lane].joint ^ contact[0].joint;
    }
    const JointLaw& joint = sweep.joint[contact[0].joint];
    if (differ == 0) {
        const auto all = [](double number) __attribute__((always_inline)) {
            return Lanes{} + number;
        };
        return {all(joint.normal_stiffness), all(joint.shear_stiffness),  all(joint.normal_dashpot),
                all(joint.shear_dashpot),    all(joint.friction),         all(joint.residual_friction),
                all(joint.cohesion),         all(joint.residual_cohesion)};
    }
    Rows<Lanes> rows;
    for (std::size_t lane = 0; lane < lane_count<Lanes>; ++lane) {
        rows[lane] = &sweep.joint[contact[lane].joint].normal_stiffness;
    }
    const std::array<Lanes, 8> of = gather_eight<Lanes>(rows);
    return {of[0], of[1], of[2], of[3], of[4], of[5], of[6], of[7]};
}

// Sweeps as many contacts in a row as there are lanes, all of one group.
template <IsLanes Lanes>
struct Part {
    std::size_t first;
    const ContactBlocks* contact;
    const ContactShapeOf<NumberGroup>& shape;
    ContactNumbersOf<NumberGroup>& numbers;
    ContactFlagsOf<FlagGroup>& flags;
    ForceOnCorner* force;

    DELABOLE_INLINED Part(const ContactSweep& sweep, std::size_t index)
        : first(index),
          contact(sweep.contact + index),
          shape(sweep.shape[index / packed_size]),
          numbers(sweep.numbers[index / packed_size]),
          flags(sweep.flags[index / packed_size]),
          force(sweep.force + index) {}

    DELABOLE_INLINED std::size_t place() const { return lane_count<Lanes> == packed_size ? 0 : first % packed_size; }
    DELABOLE_INLINED Lanes of(const NumberGroup& group) const { return load_lanes<Lanes>(group.data() + place()); }
    DELABOLE_INLINED void keep(const Lanes& lanes, NumberGroup& group) const {
        store_lanes<Lanes>(lanes, group.data() + place());
    }
    DELABOLE_INLINED unsigned of(const FlagGroup& group) const {
        std::uint64_t bytes = 0;
        std::memcpy(&bytes, group.data() + place(), lane_count<Lanes>);
        return bits_of(bytes);
    }
    DELABOLE_INLINED void keep(unsigned lanes, FlagGroup& group) const {
        const std::uint64_t bytes = bytes_of(lanes);
        std::memcpy(group.data() + place(), &bytes, lane_count<Lanes>);
    }
    DELABOLE_INLINED ContactShapeOf<Lanes> gather_shape() const {
        return {of(shape.arm_x),   of(shape.arm_y), of(shape.other_arm_x), of(shape.other_arm_y), of(shape.along_x),
                of(shape.along_y), of(shape.gap),   of(shape.from_start),  of(shape.to_end)};
    }
};

template <IsLanes Lanes>
DELABOLE_INLINED EdgeEndsOf<Lanes> ends_of(const ContactSweep& sweep, const Part<Lanes>& part) {
    Rows<Lanes> rows;
    for (std::size_t lane = 0; lane < lane_count<Lanes>; ++lane) {
        rows[lane] = &sweep.ends[part.contact[lane].ends].start_weight;
    }
    return gather_ends<Lanes>(rows);
}

// The work that the contacts of a part require, one bit for each contact.
struct Duty {
    unsigned bear = 0;       // touching contacts whose blocks have moved
    unsigned may_begin = 0;  // contacts that do not touch but may do so now, and whose blocks have moved
    bool wake = false;       // some contact cannot be left open
};

template <IsLanes Lanes>
DELABOLE_INLINED Duty duty_of(const ContactSweep& sweep, const Part<Lanes>& part) {
    const unsigned touching = part.of(part.flags.touching);
    if (touching == all_lanes<Lanes> && sweep.moved == nullptr) {
        return {all_lanes<Lanes>, 0, true};
    }
    unsigned may_touch = 0;
    for (unsigned left = all_lanes<Lanes> & ~touching; left != 0; left &= left - 1) {
        const auto lane = static_cast<unsigned>(std::countr_zero(left));
        may_touch |= sweep.stays_open(part.first + lane) ? 0 : 1U << lane;
    }
    unsigned concerned = 0;
    for (unsigned lane = 0; lane < lane_count<Lanes>; ++lane) {
        concerned |= sweep.concerned(part.first + lane) ? 1U << lane : 0;
    }
    return {touching & concerned, may_touch & concerned, (touching | may_touch) != 0};
}

DELABOLE_INLINED bool touches(const ContactSweep& sweep, std::size_t index) {
    return sweep.flags[index / packed_size].touching[index % packed_size];
}

DELABOLE_INLINED RelaxationContact contact_of(const ContactSweep& sweep, std::size_t index) {
    return {sweep.contact[index], sweep.corner[index],
            taken_from(sweep.shape[index / packed_size], index % packed_size)};
}

DELABOLE_INLINED ContactMemoryOf<double> memory_of(const ContactSweep& sweep, std::size_t index) {
    return {taken_from(sweep.numbers[index / packed_size], index % packed_size),
            taken_from(sweep.flags[index / packed_size], index % packed_size)};
}

DELABOLE_INLINED void keep_memory(const ContactSweep& sweep, std::size_t index, const ContactMemoryOf<double>& memory) {
    put_into<ContactNumbersOf>(sweep.numbers[index / packed_size], index % packed_size, memory);
    put_into<ContactFlagsOf>(sweep.flags[index / packed_size], index % packed_size, memory);
}

// Leaves contacts that do not yet touch in the same state as advance_contact does.
template <IsLanes Lanes>
DELABOLE_INLINED void stay_open(const ContactSweep& sweep, std::size_t first, unsigned which, const Lanes& gap) {
    for (; which != 0; which &= which - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(which));
        sweep.force[first + lane] = {};
        note_opening(sweep, first + lane, gap[lane]);
    }
}

// Leaves a contact that opens in the same state as advance_contact does.
void open_up(const ContactSweep& sweep, std::size_t index, double weight, double damping, bool beneath) {
    ContactMemoryOf<double> memory = memory_of(sweep, index);
    let_go(sweep.joint[sweep.contact[index].joint], weight, damping, beneath, memory);
    keep_memory(sweep, index, memory);
    sweep.force[index] = {};
    sweep.open_until[index] = not_open;
}

// Contacts no longer apart that take something over if their twin touches when they are evaluated.
struct AfterTwin {
    unsigned at_once = 0;  // the twin is evaluated after them in the same part
    unsigned later = 0;    // the twin is evaluated before them
};

template <IsLanes Lanes>
DELABOLE_INLINED AfterTwin after_twin(const ContactSweep& sweep, const Part<Lanes>& part, unsigned meeting) {
    AfterTwin after;
    for (unsigned left = meeting; left != 0; left &= left - 1) {
        const unsigned lane = left & -left;
        const std::uint32_t twin = part.contact[std::countr_zero(left)].twin;
        if (twin == no_twin) {
            continue;
        }
        const unsigned of_twin = twin - part.first < lane_count<Lanes> ? 1U << (twin - part.first) : 0;
        const bool touching = touches(sweep, twin);
        if (touching && of_twin > lane) {
            after.at_once |= lane;
        } else if (touching || ((meeting & of_twin) != 0 && of_twin < lane)) {
            after.later |= lane;
        }
    }
    return after;
}

// Contacts below the edge's line but without weight, past the edge's end or deeper than on its rival. One by one they
// would begin to bear and be let go, which changes nothing if springs and dashpots hold nothing. (Without a rival they
// would become `beneath`.) In a moving mass they are a quarter of all contacts evaluated.
template <IsLanes Lanes>
DELABOLE_INLINED unsigned stay_weightless(const Part<Lanes>& part, const EdgeEndsOf<Lanes>& ends, const Lanes& weight) {
    const ContactFlagsOf<FlagGroup>& is = part.flags;
    const unsigned cannot = ~part.of(is.broken) | part.of(is.touching) | part.of(is.sliding) | part.of(is.beneath) |
                            part.of(is.yields) | part.of(is.insists);
    return ~cannot & bits((weight == 0.0) & (ends.rival != 0.0) & (part.of(part.numbers.shear) == 0.0) &
                          (part.of(part.numbers.normal_drag) == 0.0) & (part.of(part.numbers.shear_drag) == 0.0));
}

// Evaluates the contacts of a part at once, except those that take something over. Returns the contacts that are left.
// `meanwhile`, called once, is independent of them, as only forces of this part change: the processor runs it alongside
// their formulas while it waits for data.
template <IsLanes Lanes, class Meanwhile>
DELABOLE_INLINED unsigned evaluate_together(const ContactSweep& sweep, const Part<Lanes>& part, const Duty& duty,
                                            const Meanwhile& meanwhile) {
    Rows<Lanes> blocks;
    Rows<Lanes> others;
    for (std::size_t lane = 0; lane < lane_count<Lanes>; ++lane) {
        blocks[lane] = &sweep.motion[part.contact[lane].block].x;
        others[lane] = &sweep.motion[part.contact[lane].other].x;
    }
    const ContactShapeOf<Lanes> shape = part.gather_shape();
    const MotionOf<Lanes> block = gather_motion<Lanes>(blocks);
    const MotionOf<Lanes> other = gather_motion<Lanes>(others);
    const ContactPositionOf<Lanes> at = locate<Lanes>(shape, block, other);
    meanwhile();
    const unsigned apart = bits(at.gap >= 0.0);
    if (const unsigned open = duty.may_begin & apart; open != 0) {
        stay_open(sweep, part.first, open, at.gap);
        part.keep(part.of(part.flags.beneath) & ~open, part.flags.beneath);
    }
    const unsigned meeting = duty.may_begin & ~apart;
    if ((duty.bear | meeting) == 0) {
        return 0;
    }
    const EdgeEndsOf<Lanes> ends = ends_of<Lanes>(sweep, part);
    const Lanes weight = contact_weight<Lanes>(ends, shape.to_end, at, mask_of<Lanes>(part.of(part.flags.insists)));
    unsigned begin = 0;
    unsigned one_by_one = 0;
    if (meeting != 0) {
        const unsigned weightless = stay_weightless<Lanes>(part, ends, weight) & meeting;
        stay_open(sweep, part.first, weightless, at.gap);
        const unsigned may_bear = meeting & ~weightless;
        const unsigned yields = part.of(part.flags.yields) & may_bear;
        const unsigned takes = yields == 0 ? 0 : yields & bits(takes_over<Lanes>(ends, shape.to_end, at));
        const AfterTwin after = after_twin<Lanes>(sweep, part, (may_bear & ~yields) | takes);
        one_by_one = (takes | after.later) & ~after.at_once;
        // These contacts are evaluated before the values that they take over change below.
        for (unsigned left = after.at_once; left != 0; left &= left - 1) {
            evaluate_contact(sweep, part.first + static_cast<std::size_t>(std::countr_zero(left)));
        }
        const unsigned together = may_bear & ~one_by_one & ~after.at_once;
        begin = together & over_edge({.touching = 0,
                                      .beneath = part.of(part.flags.beneath),
                                      .yields = yields,
                                      .apart = 0,
                                      .handed_over = 0,
                                      .taken_over = 0});
        stay_open(sweep, part.first, together & ~begin, at.gap);
    }
    const unsigned over = duty.bear | begin;
    if (over == 0) {
        return one_by_one;
    }
    const JointLawOf<Lanes> joint = gather_joint<Lanes>(sweep, part.contact);
    const unsigned broken = part.of(part.flags.broken);
    const unsigned bearing = bearing_of(over, apart, bits(weight == 0.0));
    const unsigned opening = over & ~bearing;
    const ContactVelocity<Lanes> velocity = velocity_of<Lanes>(at, block, other);
    ContactNumbersOf<NumberGroup>& kept = part.numbers;
    const ContactMemoryOf<Lanes> before{
        {part.of(kept.shear), part.of(kept.place), part.of(kept.damping), part.of(kept.normal_drag),
         part.of(kept.shear_drag), part.of(kept.slip), part.of(kept.friction)},
        {{}, {}, mask_of<Lanes>(broken), {}, {}, {}, {}}};
    ContactMemoryOf<Lanes> memory = before;
    const double half_step = sweep.step / 2;
    const Lanes damping = damping_until_now<Lanes>(memory, velocity, half_step);
    const Lanes force_before = joint.shear_stiffness * absolute(memory.shear);
    memory.shear += at.slide - memory.place;
    if (begin != 0) {
        memory.shear = select(mask_of<Lanes>(begin), Lanes{}, memory.shear);
    }
    const ForceOnCornerOf<Lanes> force =
        bear<Lanes>(joint, at, velocity, weight, force_before, damping, half_step, memory);
    const auto which = mask_of<Lanes>(bearing);
    const auto keep = [&](const Lanes& now, const Lanes& then, NumberGroup& group) __attribute__((always_inline)) {
        part.keep(select(which, now, then), group);
    };
    keep(memory.shear, before.shear, kept.shear);
    keep(memory.place, before.place, kept.place);
    keep(memory.damping, before.damping, kept.damping);
    keep(memory.normal_drag, before.normal_drag, kept.normal_drag);
    keep(memory.shear_drag, before.shear_drag, kept.shear_drag);
    const unsigned sliding = bits(memory.sliding) & bearing;
    const unsigned slid = part.of(part.flags.sliding);
    if ((sliding | begin | (slid & bearing)) != 0) {
        keep(memory.slip, before.slip, kept.slip);
        keep(memory.friction, before.friction, kept.friction);
        part.keep(broken | sliding, part.flags.broken);
        part.keep((slid & ~bearing) | sliding, part.flags.sliding);
        part.keep(part.of(part.flags.touching) | begin, part.flags.touching);
        for (unsigned left = begin; left != 0; left &= left - 1) {
            sweep.open_until[part.first + static_cast<std::size_t>(std::countr_zero(left))] = not_open;
        }
    }
    const FourOf<Lanes> forces = transposed<Lanes>(force.x, force.y, force.moment, force.other_moment);
    if (bearing == all_lanes<Lanes>) {
        for (std::size_t lane = 0; lane < lane_count<Lanes>; ++lane) {
            store_row<Lanes>(forces, lane, &part.force[lane].x);
        }
    } else {
        for (std::size_t lane = 0; lane < lane_count<Lanes>; ++lane) {
            if ((bearing >> lane & 1U) != 0) {
                store_row<Lanes>(forces, lane, &part.force[lane].x);
            }
        }
    }
    if (opening != 0) {
        const unsigned beneath = ~apart & bits(ends.rival == 0.0);
        for (unsigned left = opening; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            open_up(sweep, part.first + lane, weight[lane], damping[lane], (beneath >> lane & 1U) != 0);
        }
    }
    return one_by_one;
}

// Prefetches into the nearest cache. Past the end it has no effect.
DELABOLE_INLINED void fetch_ahead(const ContactSweep& sweep, std::size_t index) {
    constexpr std::size_t ahead = 2 * packed_size;
    const auto fetch = [](const auto* first, std::size_t bytes) __attribute__((always_inline)) {
        constexpr std::size_t line = 64;
        for (std::size_t at = 0; at < bytes; at += line) {
            __builtin_prefetch(reinterpret_cast<const char*>(first) + at);
        }
    };
    const std::size_t group = (index + ahead) / packed_size;
    fetch(sweep.contact + index + ahead, packed_size * sizeof(ContactBlocks));
    fetch(sweep.shape + group, sizeof(*sweep.shape));
    fetch(sweep.numbers + group, sizeof(*sweep.numbers));
}

// `after` is called for each contact that may have a force, in order. For the contacts of a part it is called while the
// next part is evaluated, because sums of forces on the same block wait for each other.
template <IsLanes Lanes, class AfterOne>
DELABOLE_INLINED std::size_t go_through(const ContactSweep& sweep, std::size_t begin, std::size_t end,
                                        const AfterOne& after) {
    std::size_t count = 0;
    std::size_t index = begin;
    const auto one_by_one_up_to = [&](std::size_t stop) __attribute__((always_inline)) {
        for (; index < stop; ++index) {
            if (sweep.stays_open(index)) {
                continue;
            }
            if (sweep.concerned(index)) {
                evaluate_contact(sweep, index);
                ++count;
            }
            after(index);
        }
    };
    constexpr std::size_t lanes = lane_count<Lanes>;
    constexpr auto none = static_cast<std::size_t>(-1);
    const auto after_part = [&](std::size_t first) __attribute__((always_inline)) {
        if (first != none) {
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                after(first + lane);
            }
        }
    };
    std::size_t evaluated = none;
    one_by_one_up_to(std::min((begin + lanes - 1) / lanes * lanes, end));
    for (; index + lanes <= end; index += lanes) {
        if (index % packed_size == 0) {
            fetch_ahead(sweep, index);
        }
        const Part<Lanes> part(sweep, index);
        const Duty duty = duty_of<Lanes>(sweep, part);
        if (!duty.wake) {
            continue;
        }
        unsigned left = duty.bear | duty.may_begin;
        count += static_cast<std::size_t>(std::popcount(left));
        const std::size_t before = std::exchange(evaluated, index);
        const auto after_before = [&after_part, before ]() __attribute__((always_inline)) {
            after_part(before);
        };
        if (left != 0) {
            left = evaluate_together<Lanes>(sweep, part, duty, after_before);
        } else {
            after_before();
        }
        for (; left != 0; left &= left - 1) {
            evaluate_contact(sweep, index + static_cast<std::size_t>(std::countr_zero(left)));
        }
    }
    after_part(evaluated);
    one_by_one_up_to(end);
    return count;
}

template <IsLanes Lanes>
DELABOLE_INLINED std::size_t evaluate(const ContactSweep& sweep, std::size_t begin, std::size_t end) {
    return go_through<Lanes>(sweep, begin, end, [](std::size_t /*index*/) __attribute__((always_inline)){});
}

template <IsLanes Lanes>
DELABOLE_INLINED std::size_t evaluate_and_sum(const ContactSweep& sweep, std::size_t begin, std::size_t end,
                                              BlockForce* sum) {
    return go_through<Lanes>(
        sweep, begin, end, [&](std::size_t index) __attribute__((always_inline)) {
            const ContactBlocks& contact = sweep.contact[index];
            const FourLanes force = load_lanes<FourLanes>(&sweep.force[index].x);
            double* const own = &sum[contact.block].x;
            store_lanes<FourLanes>(load_lanes<FourLanes>(own) + force, own);
            double* const other = &sum[contact.other].x;
            store_lanes<FourLanes>(load_lanes<FourLanes>(other) + opposite(force), other);
        });
}

#define DELABOLE_CONTACT_LOOP(name, Lanes, target)                                                     \
    target std::size_t evaluate_##name(ContactSweep sweep, std::size_t begin, std::size_t end) {       \
        return evaluate<Lanes>(sweep, begin, end);                                                     \
    }                                                                                                  \
    target std::size_t evaluate_and_sum_##name(ContactSweep sweep, std::size_t begin, std::size_t end, \
                                               BlockForce* sum) {                                      \
        return evaluate_and_sum<Lanes>(sweep, begin, end, sum);                                        \
    }                                                                                                  \
    constexpr ContactLoop name##_loop{#name, evaluate_##name, evaluate_and_sum_##name};

DELABOLE_CONTACT_LOOP(any_processor, FourLanes, )
#ifdef DELABOLE_PROCESSORS_DIFFER
DELABOLE_CONTACT_LOOP(avx2, FourLanes, __attribute__((target("avx2"))))
DELABOLE_CONTACT_LOOP(avx512, EightLanes, __attribute__((target("arch=x86-64-v4"))))

constexpr std::array all_loops{avx512_loop, avx2_loop, any_processor_loop};

std::size_t first_that_runs() {
    if (__builtin_cpu_supports("x86-64-v4") != 0) {
        return 0;
    }
    return __builtin_cpu_supports("avx2") != 0 ? 1 : 2;
}
#else
constexpr std::array all_loops{any_processor_loop};

std::size_t first_that_runs() {
    return 0;
}
#endif

}  // namespace

std::span<const ContactLoop> contact_loops() {
    static const std::size_t first = first_that_runs();
    return std::span(all_loops).subspan(first);
}

ContactSweep sweep_of(const std::vector<Motion>& motion, const std::vector<double>& travelled, const char* moved,
                      double step, ContactList& list) {
    return {motion.data(),
            travelled.data(),
            moved,
            step,
            list.contact.blocks().data(),
            list.contact.corners().data(),
            list.contact.shapes(),
            list.ends.data(),
            list.joint.data(),
            list.memory.numbers(),
            list.memory.flags(),
            list.force.data(),
            list.open_until.data()};
}

void evaluate_contact(const ContactSweep& sweep, std::size_t index) {
    const RelaxationContact contact = contact_of(sweep, index);
    ContactMemoryOf<double> memory = memory_of(sweep, index);
    std::optional<TwinThatTouches> twin;
    if (!memory.touching && contact.twin != no_twin && touches(sweep, contact.twin)) {
        const RelaxationContact other = contact_of(sweep, contact.twin);
        twin = TwinThatTouches{-locate(other, sweep.motion[other.block], sweep.motion[other.other]).gap,
                               sweep.numbers[contact.twin / packed_size].shear[contact.twin % packed_size]};
    }
    double open_by = 0;
    sweep.force[index] =
        advance_contact({sweep.ends[contact.ends], sweep.joint[contact.joint]}, contact, twin,
                        sweep.motion[contact.block], sweep.motion[contact.other], sweep.step, memory, open_by);
    keep_memory(sweep, index, memory);
    note_opening(sweep, index, open_by);
}

}  // namespace delabole
