// Rows of blocks on a plane: the thesis's formulas, the modes and what governs, equilibrium of every answer, extremes.
#include "limit_equilibrium/block_row/block_row.hpp"
#include "limit_equilibrium/block_row/block_row_search.hpp"
#include "limit_equilibrium/block_row/closed_forms.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <string>

namespace delabole {
namespace {

// Closed forms of some dozen operations.
constexpr double rounding = 1e-13;

BlockRow equal_row(int count, double slenderness, double interface_friction, double base_friction) {
    BlockRow row{};
    row.base = {degrees(1), degrees(base_friction)};
    row.interface = {degrees(interface_friction)};
    row.block.assign(static_cast<std::size_t>(count), {slenderness, 1, WeightOfBlock{1}, {}, {}});
    return row;
}

double tangent(double angle) {
    return std::tan(degrees(angle));
}

const RowModeSummary& mode_of(const BlockRowResult& result, const std::string& roles) {
    return *std::ranges::find(result.mode, roles, &RowModeSummary::roles);
}

TEST(BlockRow, OneBlockIsASingleBlock) {
    EXPECT_NEAR(analyse(equal_row(1, 3, 20, 30)).answer.critical_tilt, std::atan(1.0 / 3), rounding);
    EXPECT_NEAR(analyse(equal_row(1, 3, 20, 10)).answer.critical_tilt, degrees(10), rounding);
}

// Eq. (8) at a/b = 3, phi = psi = 20: verification deck, three decimals.
TEST(BlockRow, TwoBlocksForward) {
    const BlockRowResult result = analyse(equal_row(2, 3, 20, 20));
    EXPECT_EQ(result.answer.mode_in_contact, "FP");
    EXPECT_NEAR(result.answer.critical_tilt_in_contact / degrees(1), 18.629, 5e-4);
    // If the blocks are free, the upper one does not affect the lower one.
    EXPECT_EQ(result.answer.mode, "P0");
    EXPECT_NEAR(result.answer.critical_tilt, std::atan(1.0 / 3), rounding);
}

// Three modes for two blocks, five for three, seven for four: the counts of the thesis.
TEST(BlockRow, CountsOfTheLostFigure) {
    for (const int count : {2, 3, 4}) {
        std::set<std::string> whole;
        for (const RowModeSummary& mode : analyse(equal_row(count, 3, 20, 20)).mode) {
            if (mode.roles.find_first_not_of("FPB") == std::string::npos) {
                whole.insert(mode.roles);
            }
        }
        EXPECT_EQ(whole.size(), static_cast<std::size_t>(2 * count - 1));
    }
}

// (11): both toes slide (FB), from the equality of the thrusts.
double two_blocks_equal_thrusts(double w1, double w2, double mu, double c) {
    const double m = mu * c;
    return (w1 * c * (1 + m) - w2 * c * (1 - m)) / (w1 * (1 + m) + w2 * (1 - m));
}

TEST(BlockRow, UnequalWeightsAreEquations7And10And11) {
    BlockRow row = equal_row(2, 9, 35, 25);
    row.block[0].mass = WeightOfBlock{1.3};
    const BlockRowResult result = analyse(row);
    const double mu = tangent(35);
    const double c = tangent(25);
    const auto tilt = [&](const char* roles) { return std::tan(mode_of(result, roles).critical_tilt); };
    EXPECT_NEAR(tilt("FP"), closed_form::two_blocks_forward(9.0, 1.0, 1.3, 1.0, mu, c), rounding);
    EXPECT_NEAR(tilt("PB"), closed_form::two_blocks_backward(9.0, 1.0, 1.3, 1.0, mu, c), rounding);
    const RowModeSummary& both = mode_of(result, "FB");
    EXPECT_EQ(both.admissibility, RowModeCheck::over_determined);
    EXPECT_NEAR(std::tan(both.critical_tilt), tilt("FP"), rounding);
    EXPECT_NEAR(std::tan(both.second_critical_tilt), two_blocks_equal_thrusts(1.3, 1.0, mu, c), rounding);
}

TEST(BlockRow, ThreeAndFourBlocksAgainstTheClosedForms) {
    const double mu = tangent(25);
    const double c = tangent(35);
    const BlockRowResult three = analyse(equal_row(3, 5, 25, 35));
    const auto tilt = [](const BlockRowResult& result, const char* roles) {
        return std::tan(mode_of(result, roles).critical_tilt);
    };
    EXPECT_NEAR(tilt(three, "FFP"), closed_form::three_blocks_two_forward(5.0, 1.0, mu, c), rounding);
    EXPECT_NEAR(tilt(three, "FPB"), closed_form::three_blocks_forward_backward(5.0, 1.0, mu, c), rounding);
    EXPECT_NEAR(tilt(three, "PBB"), closed_form::three_blocks_two_backward(5.0, 1.0, mu, c), rounding);
    const BlockRowResult four = analyse(equal_row(4, 5, 25, 35));
    EXPECT_NEAR(tilt(four, "FFPB"), closed_form::four_blocks_two_forward_one_backward(5.0, 1.0, mu, c), rounding);
    for (int forward = 0; forward < 4; ++forward) {
        const std::string roles = std::string(static_cast<std::size_t>(forward), 'F') + "P" +
                                  std::string(static_cast<std::size_t>(3 - forward), 'B');
        EXPECT_NEAR(tilt(four, roles.c_str()), closed_form::equal_blocks(forward, 3 - forward, 5.0, 1.0, mu, c),
                    rounding);
    }
}

// Eq. (17) gives a tilt only where mu c exceeds a third.
TEST(BlockRow, Equation17) {
    const BlockRowResult result = analyse(equal_row(3, 5, 40, 35));
    EXPECT_NEAR(std::tan(mode_of(result, "FBB").second_critical_tilt),
                closed_form::three_blocks_equal_thrusts(tangent(40), tangent(35)), rounding);
    const double m = tangent(40) * tangent(35);
    EXPECT_NEAR(closed_form::three_blocks_equal_thrusts(tangent(40), tangent(35)), tangent(35) * (3 * m - 1) / (3 - m),
                rounding);
}

// The printed (14) = (8) denies a third block its effect; (18) and (19) differ by the sign of one term.
TEST(BlockRow, PrintedAgainstDerived) {
    const double mu = tangent(20);
    EXPECT_GT(closed_form::three_blocks_two_forward(3.0, 1.0, mu, mu),
              closed_form::two_equal_blocks_forward(3.0, 1.0, mu, mu) * 1.008);
    const double m = mu * mu;
    const double denominator_18 = 2 * (1 - m) * (3 * (1 - m) * (2 + m) + mu * (2 + 4 * m));
    const double numerator = closed_form::four_blocks_printed(3.0, 1.0, mu, mu) * denominator_18;
    const double denominator_19 = denominator_18 + 8 * mu * (1 - m) * (1 - m);
    EXPECT_NEAR(closed_form::four_blocks_one_friction_printed(3.0, 1.0, mu), numerator / denominator_19, rounding);
    // Neither formula gives the mode that it is meant for.
    const double right = closed_form::four_blocks_two_forward_one_backward(3.0, 1.0, mu, mu);
    EXPECT_GT(std::abs(closed_form::four_blocks_printed(3.0, 1.0, mu, mu) / right - 1), 0.01);
    EXPECT_GT(std::abs(closed_form::four_blocks_one_friction_printed(3.0, 1.0, mu) / right - 1), 0.01);
}

// If c = b / a there is no thrust, and every block is by itself, whatever phi.
TEST(BlockRow, MetastableAtTheBaseFrictionOfTheSingleBlock) {
    for (const int count : {2, 3, 4, 7, 16}) {
        for (const double phi : {0.0, 10.0, 35.0, 60.0}) {
            BlockRow row = equal_row(count, 3, phi, 0);
            row.base.friction_angle = std::atan(1.0 / 3);
            const BlockRowResult result = analyse(row);
            EXPECT_NEAR(result.answer.critical_tilt, std::atan(1.0 / 3), rounding);
            EXPECT_NEAR(result.answer.critical_tilt_in_contact, std::atan(1.0 / 3), rounding);
        }
    }
}

// Two equal blocks pressed together, phi + psi < 90 deg: the least of psi, (8) and (10), as the bound by linear
// programming has it; but for blocks so flat that the thrust of (8) or (10) would have to act above their top.
TEST(BlockRow, TwoEqualBlocksInContact) {
    RandomProblem random(11);
    for (int count = 0; count < 10000; ++count) {
        const double slenderness = random.logarithmic(1, 100);
        const double phi = random.uniform(0, 60);
        const double psi = random.uniform(0, std::min(89.0 - phi, 80.0));
        const double mu = tangent(phi);
        const double c = tangent(psi);
        double least = std::min(c, closed_form::two_equal_blocks_forward(slenderness, 1.0, mu, c));
        const double backward = closed_form::two_blocks_backward(slenderness, 1.0, 1.0, 1.0, mu, c);
        if (backward > 0) {
            least = std::min(least, backward);
        }
        const BlockRowResult result = analyse(equal_row(2, slenderness, phi, psi));
        ASSERT_EQ(result.check, BlockRowCheck::valid);
        // m up to 1 - 0.02 loses two digits
        EXPECT_NEAR(std::tan(result.answer.critical_tilt_in_contact) / least, 1, 1e-11)
            << slenderness << " " << phi << " " << psi << " " << result.answer.mode_in_contact;
    }
}

// In contact the third block helps, then the lowest block can no longer be held and more blocks add nothing.
TEST(BlockRow, WhatFurtherBlocksAdd) {
    const double mu = tangent(20);
    const double c = tangent(30);
    const auto in_contact = [](int count) {
        return std::tan(analyse(equal_row(count, 3, 20, 30)).answer.critical_tilt_in_contact);
    };
    EXPECT_GT(in_contact(2), 1.0 / 3);
    EXPECT_GT(in_contact(3), in_contact(2));
    const double held = closed_form::three_blocks_two_forward(3.0, 1.0, mu, c);
    for (const int count : {3, 4, 5, 9, 16, 17, 40}) {
        EXPECT_NEAR(in_contact(count), held, rounding) << count;
    }
    // Tall blocks reach that limit later: a/b = 9, phi 35 deg, at five blocks.
    const auto tall = [](int count) {
        return std::tan(analyse(equal_row(count, 9, 35, 30)).answer.critical_tilt_in_contact);
    };
    EXPECT_LT(tall(4), tall(5) * 0.99);
    EXPECT_NEAR(tall(5), closed_form::three_blocks_two_forward(9.0, 1.0, tangent(35), c), rounding);
    EXPECT_NEAR(tall(8), tall(5), rounding);
}

// Figs 4.7, 4.8 with equal weights: verification deck, two decimals. The formula is where (7) meets (10).
TEST(BlockRow, BoundaryBetweenForwardAndBackward) {
    const auto boundary = [](double phi, double share) {
        return std::atan(closed_form::boundary_base_friction(9.0, 1.0, share, tangent(phi)));
    };
    EXPECT_NEAR(boundary(35, 0.5) / degrees(1), 24.60, 5e-3);
    EXPECT_NEAR(boundary(20, 0.5) / degrees(1), 31.42, 5e-3);
    for (const double share : {0.2, 0.49, 0.7}) {
        const double mu = tangent(35);
        const double c = std::tan(boundary(35, share));
        EXPECT_NEAR(closed_form::two_blocks_forward(9.0, 1.0, share, 1 - share, mu, c),
                    closed_form::two_blocks_backward(9.0, 1.0, share, 1 - share, mu, c), rounding);
        EXPECT_NEAR(closed_form::weight_share_at_boundary(9.0, 1.0, mu, c), share, rounding);
    }
}

// Printed 25.3 and 32.6 deg ask for the same weight ratio of the two blocks within what a tenth of a degree means.
TEST(BlockRow, WeightRatioBehindThePrintedBoundaries) {
    const auto ratio = [](double phi, double psi) {
        const double share = closed_form::weight_share_at_boundary(9.0, 1.0, tangent(phi), tangent(psi));
        return share / (1 - share);
    };
    EXPECT_NEAR(ratio(35, 25.3), 0.9614, 5e-5);
    EXPECT_NEAR(ratio(20, 32.6), 0.9620, 5e-5);
}

// Thesis 4.2, case 4, Fig 3.5: a more slender lower block falls away alone; a more slender upper one has to push.
TEST(BlockRow, UnequalBlocks) {
    BlockRow row = equal_row(2, 3, 20, 30);
    row.block[0].height = 5;
    EXPECT_EQ(analyse(row).answer.mode, "P0");
    EXPECT_NEAR(analyse(row).answer.critical_tilt, std::atan(0.2), rounding);
    std::swap(row.block[0], row.block[1]);
    EXPECT_GT(analyse(row).answer.critical_tilt, std::atan(0.2));
    // Over a neighbour of almost no height the block falls by itself, but for pushing that neighbour.
    row.block[0].height = 1e-9;
    row.block[0].mass = WeightOfBlock{1e-9};
    EXPECT_NEAR(analyse(row).answer.critical_tilt, std::atan(0.2), 1e-8);
}

TEST(BlockRow, StateAtTheInclination) {
    BlockRow row = equal_row(2, 3, 20, 30);
    const auto state = [&](double inclination) {
        row.base.inclination = degrees(inclination);
        return analyse(row).answer.state;
    };
    EXPECT_EQ(state(18), RowState::stands);
    EXPECT_EQ(state(19), RowState::stands_if_pressed);
    EXPECT_EQ(state(21), RowState::topples);
    row.base.friction_angle = degrees(10);
    EXPECT_EQ(state(9), RowState::stands);
    EXPECT_EQ(state(11), RowState::slides);
}

// phi + psi = 90 deg and beyond: no block is pushed forward.
TEST(BlockRow, LocksAtNinetyDegrees) {
    EXPECT_NE(mode_of(analyse(equal_row(2, 3, 49, 40.9)), "FP").admissibility, RowModeCheck::locked);
    EXPECT_EQ(mode_of(analyse(equal_row(2, 3, 49, 41.1)), "FP").admissibility, RowModeCheck::locked);
    // At 45 + 45 deg rounding leaves 1 - mu c at a unit in the last place: (8) tends to tan(tilt) = c there.
    EXPECT_NEAR(mode_of(analyse(equal_row(2, 3, 45, 45)), "FP").critical_tilt, degrees(45), 1e-12);
}

BlockRow random_row(RandomProblem& random, int most) {
    BlockRow row{};
    row.base = {degrees(random.uniform(0, 89)), degrees(random.uniform(0, 89.9))};
    row.interface = {degrees(random.uniform(0, 89.9))};
    if (random.chance(0.5)) {
        row.base.friction_angle = degrees(random.uniform(10, 44));
        row.interface.friction_angle = degrees(random.uniform(10, 44));
    }
    for (int count = 1 + random.pick(most); count > 0; --count) {
        const double width = random.logarithmic(1e-3, 1e3) * (random.chance(0.8) ? 0 : 1) + random.uniform(1, 3);
        RowBlock block{width * random.logarithmic(0.05, 100), width, UnitWeightOfBlock{25e3}, {}, {}};
        if (random.chance(0.2)) {
            block.base_friction_angle = degrees(random.uniform(0, 89.9));
        }
        if (random.chance(0.2)) {
            block.interface_friction_angle = degrees(random.uniform(0, 89.9));
        }
        row.block.push_back(block);
    }
    return row;
}

// Force and moment balance of every moving block from the printed forces alone, and the laws of contact.
void expect_equilibrium(const BlockRow& row, const BlockRowResult& result) {
    const std::vector<RowMember<double>> members = row_members(row);
    const double sine = std::sin(result.answer.critical_tilt);
    const double cosine = std::cos(result.answer.critical_tilt);
    double largest = 0;
    for (const RowBlockForces& forces : result.block) {
        largest = std::max({largest, forces.thrust, forces.normal_force});
    }
    // Sums of a handful of terms up to the largest force, heights recovered by a division.
    const double slack = 1e-9 * largest;
    for (std::size_t index = 0; index < members.size() && result.answer.mode[index] != '0'; ++index) {
        const RowMember<double>& member = members[index];
        const RowBlockForces& own = result.block[index];
        const RowBlockForces below = index > 0 ? result.block[index - 1] : RowBlockForces{};
        const double down_dip = member.weight * sine + own.thrust - below.thrust - own.base_shear;
        const double into_base = member.weight * cosine + own.shear - below.shear - own.normal_force;
        const double moment = member.weight * (member.height * sine - member.width * cosine) / 2 +
                              own.thrust * own.thrust_height - own.shear * member.width -
                              below.thrust * below.thrust_height + own.normal_force * own.base_position;
        ASSERT_NEAR(down_dip, 0, slack);
        ASSERT_NEAR(into_base, 0, slack);
        ASSERT_NEAR(moment, 0, slack * (member.width + member.height)) << result.answer.mode << " " << index;
        ASSERT_GE(own.thrust, -slack);
        ASSERT_GE(own.normal_force, -slack);
        ASSERT_LE(std::abs(own.base_shear),
                  member.base_friction * own.normal_force + slack * (1 + member.base_friction));
        ASSERT_LE(std::abs(own.shear),
                  member.interface_friction * own.thrust + slack * (1 + member.interface_friction));
        if (own.thrust > 1e-6 * largest) {
            ASSERT_GE(own.thrust_height, -1e-3 * member.height);
            ASSERT_LE(own.thrust_height, member.contact + 1e-3 * member.height);
        }
        if (own.normal_force > 1e-6 * largest) {
            ASSERT_GE(own.base_position, -1e-3 * member.width);
            ASSERT_LE(own.base_position, 1.001 * member.width);
        }
    }
}

TEST(BlockRow, EveryAnswerIsInEquilibrium) {
    RandomProblem random(3);
    int answered = 0;
    int unanswered = 0;
    for (int count = 0; count < 10000; ++count) {
        const BlockRow row = random_row(random, 5);
        const BlockRowResult result = analyse(row);
        if (result.check == BlockRowCheck::no_admissible_mode) {
            ++unanswered;
            continue;
        }
        ASSERT_EQ(result.check, BlockRowCheck::valid);
        for_each_number(result, [](double value, const FieldInfo&) { ASSERT_TRUE(std::isfinite(value)); });
        ASSERT_LE(result.answer.critical_tilt, result.answer.critical_tilt_in_contact + 1e-9);
        if (result.answer.search == RowSearchKind::upper_bound) {
            ASSERT_TRUE(result.block.empty());
        } else {
            ++answered;
            expect_equilibrium(row, result);
        }
    }
    EXPECT_GT(answered, 7000);
    std::cout << "by a mode " << answered << ", by no means " << unanswered << "\n";
    // Friction near 90 deg beside blocks a million times heavier, which linear programming does not resolve either.
    EXPECT_LT(unanswered, 100);
}

// Unequal blocks of usual friction that have no admissible mode among those examined, two that gave no answer at all:
// the bound by linear programming stands in, and says so.
TEST(BlockRow, WithoutAModeTheBoundIsTheAnswer) {
    RandomProblem random(11);
    int bounded = 0;
    for (int count = 0; count < 500; ++count) {
        BlockRow row{};
        row.base = {degrees(1), degrees(random.uniform(10, 40))};
        row.interface = {degrees(random.uniform(10, 40))};
        const int blocks = count < 450 ? 3 + random.pick(3) : 7 + random.pick(34);
        double alone = row.base.friction_angle;
        for (int block = 0; block < blocks; ++block) {
            const double width = random.uniform(1, 3);
            const double height = width * random.uniform(1, 8);
            row.block.push_back({height, width, UnitWeightOfBlock{25e3}, {}, {}});
            alone = std::min(alone, std::atan(width / height));
        }
        BlockRowResult result = analyse(row);
        ASSERT_EQ(result.check, BlockRowCheck::valid);
        if (result.answer.search != RowSearchKind::upper_bound) {
            continue;
        }
        ++bounded;
        const double bound = result.answer.critical_tilt;
        EXPECT_GT(bound, alone - 1e-9);
        const auto state_at = [&](double inclination) {
            row.base.inclination = inclination;
            return analyse(row).answer.state;
        };
        EXPECT_EQ(state_at(alone * 0.999), RowState::stands);
        if (bound > alone * 1.002) {
            EXPECT_EQ(state_at(alone * 1.001), RowState::stands_if_pressed);
        }
        const RowState beyond = state_at(bound * 1.001);
        EXPECT_NE(beyond, RowState::stands);
        EXPECT_NE(beyond, RowState::stands_if_pressed);
    }
    EXPECT_GT(bounded, 20);
}

// All lengths and all weights by powers of two: the very same tilts.
TEST(BlockRow, Similarity) {
    RandomProblem random(5);
    for (int count = 0; count < 1000; ++count) {
        const BlockRow row = random_row(random, 5);
        BlockRow larger = row;
        for (RowBlock& block : larger.block) {
            block.height *= 4;
            block.width *= 4;
        }
        const BlockRowResult small = analyse(row);
        const BlockRowResult large = analyse(larger);
        EXPECT_EQ(small.check, large.check);
        EXPECT_EQ(small.answer.mode, large.answer.mode);
        EXPECT_EQ(small.answer.critical_tilt, large.answer.critical_tilt);
    }
}

// The two searches are different programs: where the long one applies to short rows it finds the same tilt in contact.
TEST(BlockRow, LongRowsOfEqualBlocks) {
    for (const double slenderness : {0.05, 1.0, 3.0, 9.0, 100.0}) {
        for (const double psi : {5.0, 30.0, 60.0}) {
            const BlockRowResult exact = analyse(equal_row(16, slenderness, 25, psi));
            for (const int count : {17, 100, 10000}) {
                const BlockRowResult bounded = analyse(equal_row(count, slenderness, 25, psi));
                ASSERT_EQ(bounded.check, BlockRowCheck::valid) << slenderness << " " << psi;
                EXPECT_EQ(bounded.answer.search, RowSearchKind::bounded);
                EXPECT_NEAR(bounded.answer.critical_tilt, exact.answer.critical_tilt, rounding);
            }
        }
    }
}

TEST(BlockRow, BadInputIsNamed) {
    EXPECT_EQ(analyse(equal_row(0, 3, 20, 20)).check, BlockRowCheck::no_blocks);
    EXPECT_EQ(analyse(equal_row(2, -3, 20, 20)).check, BlockRowCheck::input_out_of_range);
    EXPECT_EQ(analyse(equal_row(2, 3, 90, 20)).check, BlockRowCheck::input_out_of_range);
    EXPECT_EQ(analyse(equal_row(100001, 3, 20, 20)).check, BlockRowCheck::too_many_blocks);
}

TEST(BlockRow, PredictsThroughTheInterface) {
    const ModelInterface model = model_interface(equal_row(2, 3, 20, 30));
    const auto friction = std::ranges::find(model.inputs, "base.friction_angle", &Quantity::name);
    ASSERT_NE(friction, model.inputs.end());
    ASSERT_EQ(model.outputs.size(), 2U);
    const std::vector<Assignment> assignments = {
        {static_cast<std::size_t>(friction - model.inputs.begin()), degrees(20)}};
    const Prediction prediction = model.predict(assignments);
    ASSERT_EQ(prediction.outputs.size(), 2U);
    EXPECT_EQ(prediction.outputs[1], analyse(equal_row(2, 3, 20, 20)).answer.critical_tilt_in_contact);
}

}  // namespace
}  // namespace delabole
