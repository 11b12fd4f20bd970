// Properties of any slope on a stepped base: the crack, cables, other methods with the same limit, ends of ranges.
#include "limit_equilibrium/stepped_base/stepped_base.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace delabole {
namespace {

SteppedBase<> dry_blocks(double joint_dip, std::vector<ColumnBlock<>> blocks, double friction_angle) {
    SteppedBase<> problem{};
    problem.scene.columns = BlockColumns<>{joint_dip, std::move(blocks)};
    problem.scene.rock.unit_weight = 25e3;
    problem.scene.water = Dry{};
    problem.joints.friction_angle = friction_angle;
    problem.bases = {friction_angle, 0};
    return problem;
}

// Goodman & Bray (1976), as in stepped_base_test.
SteppedBase<> goodman_bray(double friction) {
    std::vector<ColumnBlock<>> blocks;
    for (int n = 1; n <= 16; ++n) {
        blocks.push_back({n <= 10 ? 4.0 * n : 40 - 6.0 * (n - 10), 10, 1, std::nullopt});
    }
    return dry_blocks(degrees(60), blocks, std::atan(friction));
}

// The thesis (4.4, Appendix A) goes from the toe up by the most that each column can bear from above, the smaller of
// eqs. 20 and 21; in limiting equilibrium the column below the crack can bear just nothing. This does not use the
// library's recursion. The result is positive where there is friction to spare.
double bearing_at_crack(double friction) {
    constexpr std::array<double, 8> heights = {1, 2, 3, 4, 3.1, 2.2, 1.3, 0.4};
    constexpr double rise = 1.5;  // TI
    constexpr double fall = 0.4;  // TD
    constexpr int crest = 4;
    const double dip = degrees(21.8);
    double bearing = 0;
    for (int n = 1; n <= 5; ++n) {  // the fifth is the last one higher than cot(21.8 deg)
        const double y = heights[static_cast<std::size_t>(n - 1)];
        const double below = n == 1 ? 0 : n <= crest ? y - rise : y;
        const double above = n < crest ? y : y - fall;
        const double topple = (bearing * below + y / 2 * (std::cos(dip) - y * std::sin(dip))) / (above - friction);
        const double slide = bearing + y * (friction * std::cos(dip) - std::sin(dip)) / (1 - friction * friction);
        bearing = std::min(topple, slide);
        if (bearing < 0) {
            return bearing;
        }
    }
    return bearing;
}

TEST(SteppedBaseProperties, TheThesissWayFromTheToeUpHasTheSameLimit) {
    double lower = 0.5;
    double upper = 0.95;
    ASSERT_LT(bearing_at_crack(lower), 0);
    ASSERT_GT(bearing_at_crack(upper), 0);
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = (lower + upper) / 2;
        (bearing_at_crack(middle) < 0 ? lower : upper) = middle;
    }
    std::vector<ColumnBlock<>> blocks;
    for (const double height : {1.0, 2.0, 3.0, 4.0, 3.1, 2.2, 1.3, 0.4}) {
        blocks.push_back({height, 1, 0.5, std::nullopt});
    }
    const SteppedBase<> problem = dry_blocks(degrees(90 - 21.8), blocks, degrees(40));
    const Limit limit = limiting_friction_angle(make_columns(problem.scene), 0);
    ASSERT_EQ(limit.state, LimitState::found);
    EXPECT_NEAR(limit.value, std::atan(lower), 1e-13);  // two recursions of some ten roundings each
}

// Thesis 4.4: the crack opens above the highest column with height > width cot(base dip), whatever the geometry, as
// long as the bases are flatter than their friction.
TEST(SteppedBaseProperties, CrackOpensAboveTheHighestColumnThatTopplesByItself) {
    std::mt19937_64 generator(5);
    const auto uniform = [&](double lower, double upper) {
        return lower + (upper - lower) * static_cast<double>(generator() >> 11U) * 0x1p-53;
    };
    int cracks = 0;
    for (int round = 0; round < 500; ++round) {
        const double base_dip = degrees(uniform(5, 30));
        const int count = 2 + static_cast<int>(uniform(0, 14));
        std::vector<ColumnBlock<>> blocks;
        int expected = 0;
        for (int n = 1; n <= count; ++n) {
            const double width = uniform(0.5, 2);
            const double height = uniform(0.3, 8);
            blocks.push_back({height, width, uniform(0, 0.3), std::nullopt});
            expected = height * std::tan(base_dip) > width ? n : expected;
        }
        const SteppedBase<> problem = dry_blocks(degrees(90) - base_dip, blocks, degrees(uniform(31, 44)));
        const ColumnSlope<> slope = make_columns(problem.scene);
        ASSERT_EQ(slope.check, ColumnCheck::valid);
        const std::vector<ColumnResult> columns = column_results(slope, strength_of(problem));
        int moving = 0;
        for (const ColumnResult& column : columns) {
            moving = column.mode != ColumnMode::stays ? column.number : moving;
        }
        if (expected > 1) {  // the first has no neighbour below whose force would show it
            ++cracks;
            EXPECT_EQ(moving, expected) << round;
        }
    }
    EXPECT_GT(cracks, 300);
}

// The closed form of column 1 against a root found through the whole model.
TEST(SteppedBaseProperties, CableInTheToeColumnAgreesWithTheFactorOfSafetyItGives) {
    const SteppedBase<> problem = goodman_bray(0.65);
    for (const double factor : {0.95, 1.0, 1.2}) {
        for (const double plunge : {-40.0, -10.0, 0.0, 4.0, 25.0, 55.0}) {
            for (const double height : {0.5, 2.0, 3.9}) {
                const CableForce cable = required_cable(problem, {1, degrees(plunge), height, factor});
                ASSERT_EQ(cable.state, CableState::found) << plunge << ' ' << height;
                SteppedBase<> anchored = problem;
                anchored.scene.bolt.push_back({1, cable.force, degrees(plunge), height});
                const ColumnSlope<> slope = make_columns(anchored.scene);
                // Roundings of forces of 10 MN/m, against margins of which 1 MN/m is a per cent of safety.
                EXPECT_NEAR(factor_of_safety(slope, strength_of(anchored)).value, factor, 1e-12);
                // The force is not a newton more than needed.
                anchored.scene.bolt.front().force = cable.force * (1 - 1e-6);
                EXPECT_GT(toe_force(make_columns(anchored.scene), strength_of(anchored), factor), 0);
            }
        }
    }
}

// A cable presses the column on its base as well as holding it back: against sliding the least force is the one whose
// direction makes the angle of friction with the base, the same optimum as for bolts in plane failure.
TEST(SteppedBaseProperties, CheapestCableAgainstSlidingPlungesByFrictionLessBaseDip) {
    const SteppedBase<> problem = goodman_bray(0.65);  // column 1 slides
    const double optimum = std::atan(0.65) - degrees(30);
    const auto force = [&](double plunge) { return required_cable(problem, {1, plunge, 3.9, 1}).force; };
    const double least = force(optimum);
    for (const double off : {0.5, 2.0, 8.0}) {
        EXPECT_LT(least, force(optimum + degrees(off)));
        EXPECT_LT(least, force(optimum - degrees(off)));
    }
}

TEST(SteppedBaseProperties, BasesThatCannotGiveTheirReactionAreCounted) {
    // All bases of published examples can give their reactions.
    const SteppedBaseResult sound = analyse(goodman_bray(0.7855));
    ASSERT_EQ(sound.check, ColumnCheck::valid);
    EXPECT_EQ(sound.inadmissible_count, 0);
    // A slender column toppling on a low neighbour: the push at the neighbour's top is several times its weight, and
    // the friction of that push would lift the column.
    const SteppedBase<> lifted = dry_blocks(
        degrees(60), {{3, 3, 0, std::nullopt}, {1, 3, 0, std::nullopt}, {9, 1, 0, std::nullopt}}, degrees(50));
    const ColumnSlope<> slope = make_columns(lifted.scene);
    ASSERT_EQ(slope.check, ColumnCheck::valid);
    const ColumnResult tall = column_results(slope, strength_of(lifted)).back();
    EXPECT_EQ(tall.mode, ColumnMode::topples);
    EXPECT_LT(tall.normal_reaction, 0);
    EXPECT_FALSE(tall.base_friction_holds);
    // The same column on less rough joints is pushed up its base: friction is exceeded the other way.
    const ColumnResult pushed = column_results(slope, {0.1, 0.65, 0}).back();
    EXPECT_GT(pushed.normal_reaction, 0);
    EXPECT_LT(pushed.shear_reaction, -0.65 * pushed.normal_reaction);
    EXPECT_FALSE(pushed.base_friction_holds);
}

// Fuzzing found infinity over infinity: the bases are steeper than their friction, and joints so rough that pushing
// frees the columns: none can be held, and the toe column is pushed without bound.
TEST(SteppedBaseProperties, OfAPushWithoutBoundAreNumbers) {
    const SteppedBase<> steep = dry_blocks(
        degrees(30), {{0.4, 1, 0, std::nullopt}, {0.4, 1, 0, std::nullopt}, {0.4, 1, 0, std::nullopt}}, degrees(50));
    const ColumnSlope<> slope = make_columns(steep.scene);
    ASSERT_EQ(slope.check, ColumnCheck::valid);
    const ColumnStrength<> strength{std::tan(degrees(50)), 1, 0};
    const ColumnResult toe = column_results(slope, strength).front();
    EXPECT_EQ(toe.upper_force, std::numeric_limits<double>::infinity());
    EXPECT_EQ(toe.normal_reaction, std::numeric_limits<double>::infinity());
    EXPECT_DOUBLE_EQ(toe.friction_ratio, 1 / std::tan(degrees(50)));
    EXPECT_DOUBLE_EQ(toe.reaction_position, 1 - 0.4 / std::tan(degrees(50)));
    EXPECT_TRUE(toe.base_friction_holds);  // 50 and 45 deg are more than 90
    // A tall column that leans over a low neighbour, on smooth joints: the push has no friction.
    const SteppedBase<> tall = dry_blocks(
        degrees(60), {{1, 3, 0, std::nullopt}, {1, 3, 1, std::nullopt}, {9, 1, 0, std::nullopt}}, degrees(30));
    const ColumnSlope<> leaning = make_columns(tall.scene);
    ASSERT_EQ(leaning.check, ColumnCheck::valid);
    const std::vector<ColumnResult> columns = column_results(leaning, {0, 1, 0});
    EXPECT_EQ(columns.front().upper_force, std::numeric_limits<double>::infinity());
    EXPECT_EQ(columns.front().friction_ratio, std::numeric_limits<double>::infinity());
    EXPECT_FALSE(columns.front().base_friction_holds);
    for (const ColumnResult& column : columns) {
        EXPECT_FALSE(std::isnan(column.normal_reaction)) << column.number;
        EXPECT_FALSE(std::isnan(column.reaction_position)) << column.number;
    }
}

TEST(SteppedBaseProperties, EndsOfTheRangesOfStrength) {
    SteppedBase<> problem = goodman_bray(0.65);
    problem.joints.friction_angle = 0;
    problem.bases = {0, 0};
    EXPECT_EQ(analyse(problem).limit, LimitState::fails_at_any_strength);  // there is no strength to divide
    problem.bases.cohesion = 1e9;
    EXPECT_EQ(analyse(problem).limit, LimitState::fails_at_any_strength);  // columns topple on frictionless joints
    problem.joints.friction_angle = degrees(89.9);
    problem.bases = {degrees(89.9), 0};
    const SteppedBaseResult strong = analyse(problem);
    EXPECT_EQ(strong.limit, LimitState::found);
    // The limit is the same as with any other equal friction.
    EXPECT_NEAR(strong.factor_of_safety * std::tan(degrees(38.1512)) / std::tan(degrees(89.9)), 1, 2e-6);
    // Level bases, low columns: nothing drives them.
    const SteppedBase<> level = dry_blocks(degrees(90), {{1, 1, 0, std::nullopt}, {2, 1, 0, std::nullopt}}, 0.5);
    const SteppedBaseResult still = analyse(level);
    EXPECT_EQ(still.limit, LimitState::holds_at_any_strength);
    EXPECT_EQ(still.uppermost_moving, 0);
    // Columns of no height weigh nothing and move nothing.
    const SteppedBase<> flat = dry_blocks(degrees(60), {{0, 1, 0, std::nullopt}, {0, 1, 0, std::nullopt}}, 0.5);
    const SteppedBaseResult nothing = analyse(flat);
    ASSERT_EQ(nothing.check, ColumnCheck::valid);
    EXPECT_EQ(nothing.weight, 0);
    EXPECT_EQ(nothing.limit, LimitState::holds_at_any_strength);
    EXPECT_EQ(nothing.inadmissible_count, 0);
    problem.joints.friction_angle = degrees(90);
    EXPECT_EQ(analyse(problem).check, ColumnCheck::input_out_of_range);
}

}  // namespace
}  // namespace delabole
