// The re-created program of the thesis's Appendix B: equations of motion, thresholds, and why it blew out.
#include "cases/program/thesis/hocking/chapter_5.hpp"
#include "parameters/fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace delabole {
namespace {

HockingResult computed(const Chapter5Run& run) {
    return run_hocking(make_blocks(run.columns), run.settings);
}

HockingSettings settings(double friction, int cycles) {
    HockingSettings made;
    made.time_step = 1e-4;
    made.damping = 0.5;
    made.stiffness = 6e6;
    made.density = plaster_density;
    made.gravity = 9.81;
    made.joints = made.bases = {degrees(friction), degrees(friction)};
    made.cycles = cycles;
    made.failure_rotation = made.stop_rotation = degrees(60);
    made.settled_speed = 1e-6;
    made.blow_out_force = 1e3;
    return made;
}

HockingColumns single(double slenderness, double inclination) {
    HockingColumns columns;
    columns.heights = {slenderness * inch};
    columns.width = inch;
    columns.dip = degrees(inclination);
    columns.base = HockingBase::one_block;
    columns.base_height = inch;
    columns.downhill_bases = columns.uphill_bases = 30;
    return columns;
}

// A cube cannot topple at 25 deg.
TEST(Hocking, FreeSlideFollowsTheEquationOfMotion) {
    const HockingSettings run_settings = settings(10, 1000);
    const HockingResult result = run_hocking(make_blocks(single(1, 25)), run_settings);
    const Point down(-std::cos(degrees(25)), -std::sin(degrees(25)));
    const auto travelled = [&](int print) {
        return (result.prints[static_cast<std::size_t>(print)].blocks[0].centroid - result.prints[0].blocks[0].centroid)
            .dot(down);
    };
    const double acceleration = 9.81 * (std::sin(degrees(25)) - std::tan(degrees(10)) * std::cos(degrees(25)));
    // The second difference between cycles 500 and 1000 removes the speed that the start left. Ripples of the normal
    // spring are 1e-6 m, over an increase of 6 mm.
    const double time = 500 * 1e-4;
    const double measured = (travelled(10) - 2 * travelled(5) + travelled(0)) / (time * time);
    EXPECT_NEAR(measured / acceleration, 1, 5e-3);
    EXPECT_EQ(result.prints[5].blocks[0].sliding, BaseSliding::forward);
}

// A column on its toe, without sliding: speed gained follows from height lost.
TEST(Hocking, FreeRotationKeepsItsEnergy) {
    const HockingSettings run_settings = settings(60, 1200);
    const HockingResult result = run_hocking(make_blocks(single(3, 25)), run_settings);
    const double width = inch;
    const double height = 3 * inch;
    const double about_toe = (width * width + height * height) / 3;  // moment of inertia per mass
    const auto kinetic = [&](const HockingBlockState& state) {
        return 0.5 * about_toe * state.angular_velocity * state.angular_velocity;
    };
    const HockingBlockState& early = result.prints[3].blocks[0];
    const HockingBlockState& late = result.prints.back().blocks[0];
    ASSERT_GT(late.angle, degrees(10));
    const double lost = 9.81 * (early.centroid.y() - late.centroid.y());
    // Velocity and position are known half a step apart: the work of the weight over that distance, g v step / 2 with v
    // = 0.1 m/s at the end, is 0.3 % of the energy gained.
    EXPECT_NEAR((kinetic(late) - kinetic(early)) / lost, 1, 3e-3);
}

// Cycles "stabilized" of 5.3.1 A. Print edits are 100 cycles apart, and the last swings take 100 to 200 cycles.
TEST(Hocking, SingleBlockComesToRestWhenPrinted) {
    for (const Chapter5Run& one : chapter_5_runs("fixed_inclination")) {
        SCOPED_TRACE(one.name);
        const HockingResult result = computed(one);
        if (!one.printed_settled) {
            EXPECT_EQ(result.outcome, HockingOutcome::fails);
            continue;
        }
        ASSERT_EQ(result.outcome, HockingOutcome::stands);
        const SettledCycles settled = settled_cycles(result);
        EXPECT_NEAR(settled.x, one.printed_settled->x, 100);
        EXPECT_NEAR(settled.y, one.printed_settled->y, 300);
    }
}

// In metres the springs give way by 40 times as much of the width, and the printed 18 deg cannot stand.
TEST(Hocking, BlocksOfAMetreDoNotReproduceTheThesis) {
    Chapter5Run metres = chapter_5_runs("fixed_inclination")[2];
    metres.columns.heights = {3};
    metres.columns.width = 1;
    metres.columns.base_height = 3;
    EXPECT_NE(computed(metres).outcome, HockingOutcome::stands);
}

// 5.3.1 B: the base turned in small increments gives all printed outcomes; gravity turned reaches the static limit.
TEST(Hocking, TiltedSingleBlock) {
    for (const Chapter5Run& one : chapter_5_runs("single_tilting", TiltedPart::base)) {
        EXPECT_EQ(computed(one).outcome == HockingOutcome::stands, one.printed == HockingOutcome::stands) << one.name;
    }
    for (const Chapter5Run& one : chapter_5_runs("single_tilting", TiltedPart::gravity)) {
        EXPECT_EQ(computed(one).outcome, HockingOutcome::stands) << one.name;
    }
}

// 5.3.2 B: all printed outcomes.
TEST(Hocking, TiltedTwoBlocks) {
    for (const Chapter5Run& one : chapter_5_runs("double_tilting", TiltedPart::base)) {
        EXPECT_EQ(computed(one).outcome == HockingOutcome::stands, one.printed == HockingOutcome::stands) << one.name;
    }
}

TEST(Hocking, TwoBlocksStandAsPrinted) {
    const std::vector<Chapter5Run> runs = chapter_5_runs("double_fixed");
    EXPECT_EQ(computed(runs[0]).outcome, HockingOutcome::stands);
    EXPECT_EQ(computed(runs[1]).outcome, HockingOutcome::fails);
    const std::vector<Chapter5Run> stiffness = chapter_5_runs("stiffness");
    EXPECT_EQ(computed(stiffness[0]).outcome, HockingOutcome::stands);
    EXPECT_EQ(computed(stiffness[1]).outcome, HockingOutcome::fails);
}

// Cycle 677. The blocks rock forward together, and the raised uphill foot of block 1 rests against the side of block 2
// close to its toe. As they pass atan(1/7), that place passes below the centroid of block 2, and the listing's guard
// moves the crossing point of the side from just left of the vertical to 1e-5 m right of it, past the toe: the base is
// found instead of the side. The slot of that corner and that neighbour holds the distance from one axis; the distance
// from the other axis is subtracted from it, and the dashpot takes half of height less width for the movement of one
// cycle.
TEST(Hocking, BlowOutIsADifferenceOfOverlapsOfTwoFaces) {
    Chapter5Run one = chapter_5_runs("blow_out").front();
    one.settings.print_interval = 1;
    const HockingResult result = computed(one);
    ASSERT_EQ(result.outcome, HockingOutcome::blows_out);
    ASSERT_TRUE(result.blow_out.has_value());
    // Unknown density and start may move it by some cycles.
    EXPECT_NEAR(*result.blow_out_cycle, 677, 10);
    const HockingFaceChange& change = *result.blow_out;
    EXPECT_EQ(change.block, 0);
    EXPECT_EQ(change.neighbour, 1);
    EXPECT_EQ(change.from, HockingFace::positive_side);
    EXPECT_EQ(change.to, HockingFace::negative_end);

    // In the cycle before, a corner is within the guard and left of the vertical, and the toe lies between.
    const std::vector<HockingBlock> blocks = make_blocks(one.columns);
    const HockingPrint& before = result.prints[static_cast<std::size_t>(change.cycle) - 1];
    const double centroid = before.blocks[1].centroid.x();
    const double foot = corners_of(blocks[0], before.blocks[0])[2].x() - centroid;
    const double toe = corners_of(blocks[1], before.blocks[1])[3].x() - centroid;
    EXPECT_LT(std::abs(foot), one.settings.crossing_guard);
    EXPECT_LT(foot, toe);
    EXPECT_LT(toe, one.settings.crossing_guard);
    EXPECT_NEAR(one.columns.dip + before.blocks[1].angle, std::atan(1.0 / 7), degrees(0.01));

    const double half_width = one.columns.width / 2;
    const double half_height = one.columns.heights[0] / 2;
    // Nothing special happens: an overlap below W / k = 4e-6 m, and a foot risen by width times 0.13 deg, 6e-5 m.
    EXPECT_GT(half_width - change.stored_position, 0);
    EXPECT_LT(half_width - change.stored_position, 4e-6);
    EXPECT_GT(half_height - change.new_position, 0);
    EXPECT_LT(half_height - change.new_position, 1e-4);
    const double jump = change.stored_position - change.new_position;
    EXPECT_NEAR(jump, half_width - half_height, 1e-4);
    const double mass = one.columns.width * one.columns.heights[0] * one.settings.density;
    const double dashpot = one.settings.damping * 2 * std::sqrt(one.settings.stiffness * mass) / one.settings.time_step;
    EXPECT_NEAR(change.dashpot_force / (dashpot * jump), 1, 1e-12);  // a product of three factors
    const double weight = 2 * mass * 9.81;
    EXPECT_LT(before.largest_force, 10 * weight);
    EXPECT_GT(std::abs(change.dashpot_force), 1e4 * weight);
}

TEST(Hocking, WithoutTheGuardOrWithSlotsPerFaceNothingBlowsOut) {
    const Chapter5Run listed = chapter_5_runs("blow_out").front();
    Chapter5Run unguarded = listed;
    unguarded.settings.crossing_guard = 0;
    Chapter5Run per_face = listed;
    per_face.settings.slot_memory = HockingSlotMemory::per_face;
    const std::vector<HockingBlock> blocks = make_blocks(listed.columns);
    int blown_out = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        const std::vector<HockingBlock> start = perturbed(blocks, 1e-7, seed);
        blown_out += run_hocking(start, listed.settings).blow_out_cycle ? 1 : 0;
        EXPECT_FALSE(run_hocking(start, unguarded.settings).blow_out_cycle.has_value());
        EXPECT_FALSE(run_hocking(start, per_face.settings).blow_out_cycle.has_value());
    }
    EXPECT_GT(blown_out, 10);
}

// Where corners meet exactly no face is the right one, and the shared slot alone makes the run blow out.
TEST(Hocking, CornersThatMeetExactlyBlowOutWithoutTheGuardToo) {
    Chapter5Run one = chapter_5_runs("blow_out").front();
    one.settings.crossing_guard = 0;
    one.columns.coordinate_unit = 0;
    one.settings.cycles = 200;
    int blown_out = 0;
    for (int step = -50; step <= 50; ++step) {
        one.columns.dip = std::atan(1.0 / 7) + step * degrees(0.01);
        one.settings.slot_memory = HockingSlotMemory::per_neighbour;
        blown_out += computed(one).blow_out_cycle ? 1 : 0;
        one.settings.slot_memory = HockingSlotMemory::per_face;
        EXPECT_FALSE(computed(one).blow_out_cycle.has_value());
    }
    EXPECT_GT(blown_out, 5);
}

// 5.3.3: histories are chaotic, but the first block goes down and the last one up.
TEST(Hocking, FlankBlocksSlideAsPrinted) {
    std::vector<Chapter5Run> runs = chapter_5_runs("triple");
    const std::vector<Chapter5Run> four = chapter_5_runs("quadruple");
    runs.insert(runs.end(), four.begin(), four.end());
    for (const Chapter5Run& one : runs) {
        SCOPED_TRACE(one.name);
        const std::size_t columns = one.columns.heights.size();
        const std::vector<SlidingTotals> totals = count_sliding(computed(one), columns, one.first_print);
        EXPECT_GT(totals.front().forward, 5 * totals.front().backward);
        EXPECT_GE(totals.back().backward, totals.back().forward);
    }
}

// A shift of the last bit parts the histories of four blocks: totals, not cycles, can be compared.
TEST(Hocking, HistoriesAreChaotic) {
    const Chapter5Run one = chapter_5_runs("quadruple")[0];
    const std::vector<HockingBlock> blocks = make_blocks(one.columns);
    const HockingResult first = run_hocking(blocks, one.settings);
    const HockingResult second = run_hocking(perturbed(blocks, 1e-15, 1), one.settings);
    const auto angle = [](const HockingResult& result) { return result.prints.back().blocks[1].angle; };
    EXPECT_GT(std::abs(angle(first) - angle(second)), 1e-6);
    // The same start gives the same bits.
    const HockingResult again = run_hocking(blocks, one.settings);
    EXPECT_EQ(angle(first), angle(again));
}

// The stored numbers fit into words of the requested length, and otherwise the block moves as before.
TEST(Hocking, ShorterWordsCutWhatIsStored) {
    const HockingSettings full = settings(20, 200);
    HockingSettings cut = full;
    cut.significand_bits = 24;
    const std::vector<HockingBlock> blocks = make_blocks(single(3, 17));
    const Point of_full = run_hocking(blocks, full).prints.back().blocks.front().centroid;
    const HockingResult computed = run_hocking(blocks, cut);
    const Point of_cut = computed.prints.back().blocks.front().centroid;
    EXPECT_EQ(of_cut.x(), static_cast<double>(static_cast<float>(of_cut.x())));
    EXPECT_NE(of_full.x(), static_cast<double>(static_cast<float>(of_full.x())));
    // 200 cycles, each cut by up to 2^-23 of some hundredths of a metre.
    EXPECT_NEAR(of_cut.x(), of_full.x(), 200 * 0.05 * std::pow(2, -23));
    cut.significand_bits = 54;
    EXPECT_EQ(run_hocking(blocks, cut).outcome, HockingOutcome::impossible_input);
}

TEST(Hocking, ColumnsOnASteppedBase) {
    for (const Chapter5Run& one : chapter_5_runs("stepped_base")) {
        SCOPED_TRACE(one.name);
        const HockingResult result = computed(one);
        const auto rotation = [&](std::size_t column) { return result.prints.back().blocks[column].angle; };
        if (one.printed == HockingOutcome::stands) {
            EXPECT_EQ(result.outcome, HockingOutcome::stands);
            continue;
        }
        EXPECT_EQ(result.outcome, HockingOutcome::fails);
        // Columns 2 to 5 topple by some degrees, the others only turn as far as the springs give way.
        for (const std::size_t column : {1U, 2U, 3U, 4U}) {
            EXPECT_GT(rotation(column), degrees(1.5));
        }
        for (const std::size_t column : {0U, 5U, 6U, 7U}) {
            EXPECT_LT(std::abs(rotation(column)), degrees(0.1));
        }
    }
}

TEST(Hocking, ColumnsOnAPlaneBase) {
    const HockingResult result = computed(chapter_5_runs("plane_base").front());
    const auto& blocks = result.prints.back().blocks;
    EXPECT_LT(std::abs(blocks[0].angle), degrees(0.1));
    EXPECT_LT(blocks[0].centroid.x() - result.prints[0].blocks[0].centroid.x(), -0.1 * inch);
    for (std::size_t column = 1; column <= 6; ++column) {
        EXPECT_GT(blocks[column].angle, degrees(5));
    }
    for (const std::size_t column : {7U, 8U}) {
        EXPECT_LT(std::abs(blocks[column].angle), degrees(0.1));
    }
}

TEST(Hocking, RefusesImpossibleInput) {
    const std::vector<HockingBlock> blocks = make_blocks(single(3, 10));
    const auto outcome = [&](auto change) {
        HockingSettings changed = settings(20, 10);
        change(changed);
        return run_hocking(blocks, changed).outcome;
    };
    EXPECT_NE(outcome([](HockingSettings&) {}), HockingOutcome::impossible_input);
    EXPECT_EQ(outcome([](HockingSettings& s) { s.stiffness = 0; }), HockingOutcome::impossible_input);
    EXPECT_EQ(outcome([](HockingSettings& s) { s.time_step = std::nan(""); }), HockingOutcome::impossible_input);
    EXPECT_EQ(outcome([](HockingSettings& s) { s.density = -1; }), HockingOutcome::impossible_input);
    EXPECT_EQ(outcome([](HockingSettings& s) { s.print_interval = 0; }), HockingOutcome::impossible_input);
    std::vector<HockingBlock> lost = blocks;
    lost[0].neighbours.below = 7;
    EXPECT_EQ(run_hocking(lost, settings(20, 10)).outcome, HockingOutcome::impossible_input);
    std::vector<HockingBlock> flat = blocks;
    flat[0].height = 0;
    EXPECT_EQ(run_hocking(flat, settings(20, 10)).outcome, HockingOutcome::impossible_input);
}

}  // namespace
}  // namespace delabole
