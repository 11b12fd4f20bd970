// Contacts and blocks that are evaluated many at a time give the same bits as one by one.
#include "dynamic_relaxation/blocks/block_sweep.hpp"
#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/contact_sweep.hpp"
#include "tests/support/brick_pack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

constexpr double stiffness = 1e9;
constexpr double step = 1e-4;

// The joints of the wall have every property that contacts can have.
RelaxationScene wall() {
    RelaxationScene scene = brick_pack_scene({5, 7, 1e5, 0.6, 0.2});
    scene.material = {{stiffness, stiffness / 2, 0.6, 0.4, 2e4, 0, {}, 5e3}};
    return scene;
}

template <class Array>
bool same_bytes(const Array& one, const Array& other) {
    return one.size() == other.size() &&
           std::memcmp(one.data(), other.data(), one.size() * sizeof(typename Array::value_type)) == 0;
}

// Structs are compared member by member, since their padding means nothing.
bool same_memory(const ContactList& one, const ContactList& other) {
    for (std::size_t index = 0; index < one.memory.size(); ++index) {
        const auto bits = [](const ContactMemory& memory) {
            const std::array<double, 7> numbers{memory.shear,      memory.place, memory.damping, memory.normal_drag,
                                                memory.shear_drag, memory.slip,  memory.friction};
            return std::pair(numbers, std::array{memory.touching, memory.sliding, memory.broken, memory.beneath,
                                                 memory.yields, memory.insists, memory.tried});
        };
        const auto [numbers, flags] = bits(one.memory[index]);
        const auto [other_numbers, other_flags] = bits(other.memory[index]);
        if (!same_bytes(numbers, other_numbers) || flags != other_flags) {
            return false;
        }
    }
    return true;
}

class Shaken : public ::testing::Test {
  protected:
    Shaken() : displacement(bodies.size(), 0), motion(bodies.size()), moved(bodies.size(), 1) {}

    // Blocks move by about as much as makes joints slip, open and close again; every fifth time so far that corners
    // come past the ends of edges, every tenth time deep into other blocks.
    void shake() {
        ++shakes;
        const double reach = shakes % 10 == 0 ? 1.0 : shakes % 5 == 0 ? 4e-3 : 2e-5;
        std::uniform_real_distribution<double> some(-1, 1);
        for (std::size_t block = 0; block < bodies.size(); ++block) {
            moved[block] = bodies.fixed[block] == 0 && some(random) > all_move ? 1 : 0;
            if (moved[block] == 0) {
                continue;
            }
            Motion& at = motion[block];
            at.vx = reach * some(random) / step;
            at.vy = reach * (some(random) - 0.5) / step;
            at.spin = reach * some(random) / step;
            const auto nearer = [](double place) { return place / 2; };
            at.x = nearer(at.x) + at.vx * step;
            at.y = nearer(at.y) + at.vy * step;
            at.set_angle(nearer(at.angle) + at.spin * step);
            displacement[block] += 10 * reach;
        }
    }

    // A bond does not heal: some rounds begin with whole ones, with some corners beneath, and with some on trial.
    void renew() {
        list = find_contacts(scene, bodies, motion, std::vector<char>(bodies.size(), 0), {0.01, 0.2, true, {}}, {});
        for (std::size_t index = 0; index < list.contact.size(); index += 11) {
            ContactMemory memory = list.memory[index];
            memory.touching = false;
            memory.beneath = true;
            list.memory.set(index, memory);
        }
        for (std::size_t index = 5; index < list.contact.size(); index += 13) {
            ContactMemory memory = list.memory[index];
            memory.yields = index % 2 == 0;
            memory.touching = memory.touching && !memory.yields;
            memory.insists = memory.tried = !memory.yields;
            list.memory.set(index, memory);
        }
    }

    std::mt19937 random{7};
    int shakes = 0;
    double all_move = -1;  // the farther above -1, the more blocks stand still
    RelaxationScene scene = wall();
    Bodies bodies = make_bodies(scene);
    std::vector<double> displacement;
    std::vector<Motion> motion;
    std::vector<char> moved;
    ContactList list =
        find_contacts(scene, bodies, motion, std::vector<char>(bodies.size(), 0), {0.01, 0.2, true, {}}, {});
};

class ContactLoops : public Shaken, public ::testing::WithParamInterface<ContactLoop> {};

TEST_P(ContactLoops, GiveTheSameBitsAsOneByOne) {
    ContactList one_by_one;
    struct {
        std::size_t sliding, opened, bearing, begun, taken_over, taken_before, beneath, weightless, stay_weightless,
            rivals, left_open;
    } seen{};
    for (int round = 0; round < 400; ++round) {
        if (round % 20 == 0) {
            renew();
            one_by_one = list;
        }
        all_move = round % 2 == 0 ? -1 : 0.2;
        shake();
        const char* const all = round % 2 == 0 ? nullptr : moved.data();
        std::vector<BlockForce> sum(bodies.size());
        const std::size_t count = GetParam().evaluate_and_sum(sweep_of(motion, displacement, all, step, list), 0,
                                                              list.contact.size(), sum.data());

        std::size_t expected = 0;
        std::vector<BlockForce> expected_sum(bodies.size());
        const ContactSweep alone = sweep_of(motion, displacement, all, step, one_by_one);
        for (std::size_t index = 0; index < one_by_one.contact.size(); ++index) {
            const RelaxationContact contact = one_by_one.contact[index];
            if (!alone.stays_open(index) && alone.concerned(index)) {
                const ContactMemory before = one_by_one.memory[index];
                const bool twin_touches = contact.twin != no_twin && one_by_one.memory[contact.twin].touching;
                evaluate_contact(alone, index);
                ++expected;
                const ContactMemory after = one_by_one.memory[index];
                const bool apart = locate(contact, motion[contact.block], motion[contact.other]).gap >= 0;
                seen.opened += before.touching && !after.touching ? 1 : 0;
                seen.weightless += before.touching && !after.touching && !apart ? 1 : 0;
                seen.stay_weightless +=
                    before.broken && !before.touching && !before.beneath && !after.touching && !after.beneath && !apart
                        ? 1
                        : 0;
                seen.begun += !before.touching && after.touching ? 1 : 0;
                seen.taken_over += !before.touching && after.touching && after.shear != 0 && !after.sliding ? 1 : 0;
                // The twin is evaluated later, or at the same time where contacts are taken together.
                seen.taken_before += !before.touching && after.touching && twin_touches && contact.twin > index &&
                                             contact.twin / 4 == index / 4
                                         ? 1
                                         : 0;
                seen.beneath += before.beneath && after.beneath ? 1 : 0;
                seen.sliding += after.sliding ? 1 : 0;
                seen.bearing += before.touching && after.touching ? 1 : 0;
                seen.rivals += after.touching && one_by_one.law_of(contact).rival != 0 ? 1 : 0;
            }
            expected_sum[contact.block] += one_by_one.force[index].on_block();
            expected_sum[contact.other] += one_by_one.force[index].on_other();
        }
        for (std::size_t first = 0; first + packed_size <= list.contact.size(); first += packed_size) {
            bool left_open = true;
            for (std::size_t index = first; index < first + packed_size; ++index) {
                left_open = left_open && alone.stays_open(index);
            }
            seen.left_open += left_open ? 1 : 0;
        }
        ASSERT_EQ(count, expected) << round;
        ASSERT_TRUE(same_memory(list, one_by_one)) << round;
        ASSERT_TRUE(same_bytes(list.force, one_by_one.force)) << round;
        ASSERT_TRUE(same_bytes(list.open_until, one_by_one.open_until)) << round;
        for (std::size_t block = 0; block < bodies.size(); ++block) {
            ASSERT_EQ(sum[block].x, expected_sum[block].x) << round;
            ASSERT_EQ(sum[block].y, expected_sum[block].y) << round;
            ASSERT_EQ(sum[block].moment, expected_sum[block].moment) << round;
        }
    }
    // Everything that the test is about has happened often.
    EXPECT_GT(seen.sliding, 1000U);
    EXPECT_GT(seen.opened, 1000U);
    EXPECT_GT(seen.bearing, 10000U);
    EXPECT_GT(seen.begun, 1000U);
    EXPECT_GT(seen.taken_over, 10U);
    EXPECT_GT(seen.taken_before, 10U);
    EXPECT_GT(seen.beneath, 100U);
    EXPECT_GT(seen.weightless, 100U);
    EXPECT_GT(seen.stay_weightless, 100U);
    EXPECT_GT(seen.rivals, 1000U);
    EXPECT_GT(seen.left_open, 10U);
}

// Two threads may share a group of contacts.
TEST_P(ContactLoops, GiveTheSameBitsPartByPart) {
    ContactList in_parts;
    for (int round = 0; round < 100; ++round) {
        if (round % 20 == 0) {
            renew();
            in_parts = list;
        }
        all_move = round % 2 == 0 ? -1 : 0.2;
        shake();
        const char* const all = round % 2 == 0 ? nullptr : moved.data();
        std::vector<BlockForce> sum(bodies.size());
        const std::size_t count = GetParam().evaluate_and_sum(sweep_of(motion, displacement, all, step, list), 0,
                                                              list.contact.size(), sum.data());
        std::vector<BlockForce> sum_in_parts(bodies.size());
        std::size_t count_in_parts = 0;
        std::size_t begin = 0;
        while (begin < list.contact.size()) {
            std::size_t end = std::min(begin + 5 + random() % 50, list.contact.size());
            // Pairs of blocks stay together.
            while (end < list.contact.size() &&
                   list.contact.blocks()[end].pair() == list.contact.blocks()[end - 1].pair()) {
                ++end;
            }
            const ContactSweep sweep = sweep_of(motion, displacement, all, step, in_parts);
            count_in_parts += round % 3 == 0 ? GetParam().evaluate(sweep, begin, end)
                                             : GetParam().evaluate_and_sum(sweep, begin, end, sum_in_parts.data());
            begin = end;
        }
        ASSERT_EQ(count, count_in_parts) << round;
        ASSERT_TRUE(same_memory(list, in_parts)) << round;
        ASSERT_TRUE(same_bytes(list.force, in_parts.force)) << round;
        ASSERT_TRUE(same_bytes(list.open_until, in_parts.open_until)) << round;
        if (round % 3 != 0) {
            ASSERT_TRUE(same_bytes(sum, sum_in_parts)) << round;
        }
    }
}

// A non-finite block affects no other lane.
TEST_P(ContactLoops, GiveTheSameBitsBesideABlockThatIsLost) {
    for (const double lost : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        renew();
        ContactList one_by_one = list;
        for (int round = 0; round < 20; ++round) {
            shake();
            std::vector<Motion> with_lost = motion;
            with_lost[12].x = lost;
            GetParam().evaluate(sweep_of(with_lost, displacement, nullptr, step, list), 0, list.contact.size());
            const ContactSweep alone = sweep_of(with_lost, displacement, nullptr, step, one_by_one);
            for (std::size_t index = 0; index < one_by_one.contact.size(); ++index) {
                if (!alone.stays_open(index)) {
                    evaluate_contact(alone, index);
                }
            }
            for (std::size_t index = 0; index < list.contact.size(); ++index) {
                const ContactBlocks& blocks = list.contact.blocks()[index];
                const ContactMemory one = list.memory[index];
                const ContactMemory other = one_by_one.memory[index];
                const auto flags = [](const ContactMemory& memory) {
                    return std::array{memory.touching, memory.sliding, memory.broken, memory.beneath, memory.yields};
                };
                ASSERT_EQ(flags(one), flags(other)) << lost << " " << round;
                if (blocks.block != 12 && blocks.other != 12) {
                    ASSERT_EQ(one.shear, other.shear);
                    ASSERT_EQ(list.force[index].moment, one_by_one.force[index].moment);
                }
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(, ContactLoops, ::testing::ValuesIn(contact_loops().begin(), contact_loops().end()),
                         [](const ::testing::TestParamInfo<ContactLoop>& loop) {
                             return std::string(loop.param.name);
                         });

TEST_F(Shaken, BlocksMoveTheSameFourAtATimeAsOneByOne) {
    BlockScales scales;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        scales.inverse_radius.push_back(1 / bodies.radius[block]);
        scales.inverse_weight.push_back(1 / (10 * bodies.mass[block]));
        scales.rest_speed.push_back(1e-6);
        // Some blocks go farther in a step, and some do not.
        scales.unnoticed.push_back(1e-4);
    }
    std::uniform_real_distribution<double> some(-1, 1);
    std::vector<BlockForce> forces(bodies.size());
    std::vector<BlockForce> loads(bodies.size());
    std::vector<std::uint32_t> at_rest(bodies.size(), 3);
    shake();
    // This block is at rest until its load wakes it.
    constexpr std::size_t resting = 15;
    at_rest[resting] = 4;
    motion[resting].vx = motion[resting].vy = motion[resting].spin = 0;
    // One block has turned by more than a hundredth of a radian, and two do not turn.
    motion[3].set_angle(0.5);
    motion[4].spin = motion[9].spin = 0;
    std::vector<Motion> one_by_one = motion;
    std::vector<double> displacement_one_by_one = displacement;
    std::vector<std::uint32_t> at_rest_one_by_one = at_rest;
    NoticedMotion noticed;
    noticed.resize(bodies.size());
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        noticed.notice(block, motion[block]);
    }
    NoticedMotion noticed_one_by_one = noticed;
    std::size_t times_noticed = 0;
    const auto sweep = [&](std::vector<Motion>& moving, std::vector<double>& displacements,
                           std::vector<std::uint32_t>& rests, NoticedMotion& noticing) {
        return BlockSweep{
            bodies, scales, bodies.fixed.data(), forces.data(),        forces.data(), loads.data(), 0.3, step, step,
            1e-6,   4,      moving.data(),       displacements.data(), rests.data(),  noticing};
    };
    for (int round = 0; round < 50; ++round) {
        for (std::size_t block = 0; block < bodies.size(); ++block) {
            const double scale = 1e4 * (block % 5 == 0 ? 0 : some(random));
            forces[block] = {scale * some(random), scale * some(random), block == 4 ? 0 : scale * some(random)};
            loads[block] = {0, block == resting && round < 25 ? 0 : -1e3, 0};
        }
        const NoticedMotion before = noticed;
        const StepSums sums = move_blocks(sweep(motion, displacement, at_rest, noticed), 0, bodies.size());
        StepSums expected;
        for (std::size_t block = 0; block < bodies.size(); ++block) {
            const StepSums own = move_blocks(
                sweep(one_by_one, displacement_one_by_one, at_rest_one_by_one, noticed_one_by_one), block, block + 1);
            expected.fastest = std::max(expected.fastest, own.fastest);
            expected.applied += own.applied;
            expected.damped += own.damped;
            expected.unbalanced = std::max(expected.unbalanced, own.unbalanced);
        }
        ASSERT_TRUE(same_bytes(motion, one_by_one)) << round;
        ASSERT_TRUE(same_bytes(displacement, displacement_one_by_one)) << round;
        ASSERT_TRUE(same_bytes(at_rest, at_rest_one_by_one)) << round;
        ASSERT_EQ(noticed.moved, noticed_one_by_one.moved) << round;
        EXPECT_EQ(noticed.moved[resting] != 0 || at_rest[resting] < 4, round >= 25) << round;
        for (std::size_t block = 0; block < bodies.size(); ++block) {
            const double come = std::abs(motion[block].x - before.x[block]) +
                                std::abs(motion[block].y - before.y[block]) +
                                std::abs(motion[block].angle - before.angle[block]) * bodies.radius[block];
            const bool is_noticed = !(come <= scales.unnoticed[block]);
            ASSERT_EQ(noticed.moved[block] != 0, is_noticed) << round << ", block " << block;
            const auto expect_pose = [&](double x, double y, double angle) {
                ASSERT_EQ(noticed.x[block], x);
                ASSERT_EQ(noticed.y[block], y);
                ASSERT_EQ(noticed.angle[block], angle);
                ASSERT_EQ(noticed_one_by_one.x[block], x);
                ASSERT_EQ(noticed_one_by_one.y[block], y);
                ASSERT_EQ(noticed_one_by_one.angle[block], angle);
            };
            if (is_noticed) {
                expect_pose(motion[block].x, motion[block].y, motion[block].angle);
                ++times_noticed;
            } else {
                expect_pose(before.x[block], before.y[block], before.angle[block]);
            }
        }
        EXPECT_EQ(sums.unbalanced, expected.unbalanced);
        EXPECT_EQ(sums.fastest, expected.fastest);
        // Forty terms are added in another order.
        const double rounding = 40 * std::numeric_limits<double>::epsilon() * std::abs(expected.damped);
        EXPECT_NEAR(sums.damped, expected.damped, rounding);
        EXPECT_GT(expected.damped, 0);
        EXPECT_NEAR(sums.applied, expected.applied, 1e-12 * (1 + std::abs(expected.applied)));
    }
    EXPECT_GT(times_noticed, 5 * bodies.size());
    EXPECT_LT(times_noticed, 45 * bodies.size());
    // A value that is not finite is noticed.
    for (const std::size_t block : {6U, 7U}) {
        motion[block].vx = one_by_one[block].vx = std::numeric_limits<double>::quiet_NaN();
    }
    move_blocks(sweep(motion, displacement, at_rest, noticed), 4, 8);
    move_blocks(sweep(one_by_one, displacement_one_by_one, at_rest_one_by_one, noticed_one_by_one), 6, 7);
    EXPECT_EQ(noticed.moved[6], 1);
    EXPECT_EQ(noticed.moved[7], 1);
    EXPECT_EQ(noticed_one_by_one.moved[6], 1);
}

}  // namespace
}  // namespace delabole
