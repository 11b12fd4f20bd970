// Limit equilibrium of flexural toppling has the right limits, balance and order.
#include "limit_equilibrium/columns/flexural_toppling.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace delabole {
namespace {

constexpr double unit_weight = 26000;

FlexuralSlope slope_of(std::vector<double> heights, double tensile_strength) {
    FlexuralSlope slope{degrees(30), unit_weight, degrees(25), tensile_strength, 1e7, degrees(35), 0.8, {}};
    for (const double height : heights) {
        slope.column.push_back({1, height});
    }
    return slope;
}

TEST(FlexuralToppling, OneColumnIsACantileverUnderItsWeight) {
    for (const double height : {5.0, 12.0, 40.0}) {
        const FlexuralSlope slope = slope_of({height}, 1e5);
        // Section modulus t^2 / 6, moment of the transverse weight, and the weight along the column.
        const double weight = unit_weight * height;
        const double stress = 6 * weight * height * std::sin(slope.base_dip) / 2 - weight * std::cos(slope.base_dip);
        EXPECT_NEAR(analyse(slope).required_tensile_strength, stress, 1e-12 * stress);
        EXPECT_NEAR(analyse(slope).factor_of_safety, 1e5 / stress, 1e-12);
    }
}

TEST(FlexuralToppling, WithoutTensileStrengthIsGoodmanAndBrays) {
    FlexuralSlope slope = slope_of({3, 6, 9, 7, 5, 3}, 0);
    slope.contact_height = 1;
    const double friction = std::tan(slope.joint_friction_angle);
    const double sine = std::sin(slope.base_dip);
    const double cosine = std::cos(slope.base_dip);
    const FlexuralStability stability = analyse(slope);
    double push = 0;
    for (std::size_t index = slope.column.size(); index-- > 0;) {
        const double height = slope.column[index].height;
        const double above =
            index + 1 < slope.column.size() ? std::min(height, slope.column[index + 1].height) : height;
        const double below = index > 0 ? std::min(height, slope.column[index - 1].height) : height;
        // Goodman & Bray (1976): turning about the lower corner of the foot.
        push = std::max(0.0, (push * (above - friction) + unit_weight * height / 2 * (height * sine - cosine)) / below);
        EXPECT_NEAR(stability.column[index].push, push, 1e-12 * unit_weight * height) << index;
    }
    EXPECT_GT(push, 0);
    EXPECT_EQ(stability.factor_of_safety, 0);
}

// A tall column above two short ones: friction cannot hold it by more than what presses its foot.
TEST(FlexuralToppling, FrictionPullsNoFootOutOfTheRock) {
    FlexuralSlope slope = slope_of({1, 1, 10}, 0);
    slope.unit_weight = 25000;
    slope.joint_friction_angle = degrees(45);
    slope.contact_height = 1;
    const double half_sine = std::sin(slope.base_dip) / 2;
    const double half_cosine = std::cos(slope.base_dip) / 2;
    const FlexuralStability stability = analyse(slope);
    // Turning about lower edges, at contacts 1 m high: push and friction, in kN/m.
    const double tall = 250 * (10 * half_sine - half_cosine);
    const double friction_of_tall = 250 * 2 * half_cosine;
    const double middle = 25 * (half_sine - half_cosine) + tall - friction_of_tall;
    const double friction_of_middle = 25 * 2 * half_cosine + friction_of_tall;
    const double toe = 25 * (half_sine - half_cosine) + middle - friction_of_middle;
    EXPECT_NEAR(stability.column[2].push, 1e3 * tall, 1e-6);
    EXPECT_NEAR(stability.column[1].push, 1e3 * middle, 1e-6);
    EXPECT_NEAR(stability.toe_push, 1e3 * toe, 1e-6);
    EXPECT_GT(stability.toe_push, 50e3);
    EXPECT_EQ(stability.factor_of_safety, 0);
}

// With all the friction on its face that its weight allows, the column slides on a foot that bears nothing.
TEST(FlexuralToppling, ASlidingColumnIsHeldUpByNoMoreThanItsWeight) {
    FlexuralSlope slope = slope_of({10}, 0);
    slope.base_dip = degrees(60);
    slope.cohesion = 0;
    for (const double friction : {45.0, 60.0}) {
        slope.joint_friction_angle = degrees(friction);
        slope.friction_angle = degrees(40);
        const FlexuralStability stability = analyse(slope);
        EXPECT_EQ(stability.column[0].mode, FlexuralMode::shears);
        EXPECT_NEAR(stability.toe_push, 10 * unit_weight * std::sin(degrees(60)), 1e-6);
        EXPECT_NEAR(stability.column[0].normal, 0, 1e-6);
    }
}

TEST(FlexuralToppling, NoFootIsPulledByMoreThanItsStrength) {
    std::mt19937_64 random(7);
    int torn = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const auto between = [&](double low, double high) {
            return std::uniform_real_distribution<double>(low, high)(random);
        };
        FlexuralSlope slope = slope_of({}, trial % 3 == 0 ? 0 : between(0, 2e5));
        slope.base_dip = degrees(between(10, 60));
        slope.joint_friction_angle = degrees(between(5, 45));
        for (int column = 0; column < 5; ++column) {
            slope.column.push_back({between(0.5, 1), between(2, 15)});
        }
        double before = std::numeric_limits<double>::infinity();
        for (const double factor : {1.0, 1.5, 3.0}) {
            FlexuralSlope stronger = slope;
            stronger.tensile_strength *= factor;
            const FlexuralStability stability = analyse(stronger);
            for (std::size_t index = 0; index < slope.column.size(); ++index) {
                const double most = stronger.tensile_strength * slope.column[index].width;
                const double rounding = 1e-9 * unit_weight * 15 * 15;
                EXPECT_GE(stability.column[index].normal, -most - rounding);
                torn += stability.column[index].normal < -0.999 * most && most > 0 ? 1 : 0;
            }
            EXPECT_LE(stability.toe_push, before * (1 + 1e-9)) << "more strength, no more push";
            before = stability.toe_push;
        }
    }
    EXPECT_GT(torn, 50);
}

TEST(FlexuralToppling, EveryColumnIsInBalanceAtItsStrength) {
    const FlexuralSlope slope = slope_of({4, 8, 14, 18, 15, 12, 9, 5}, 3e5);
    const FlexuralStability stability = analyse(slope);
    int bending = 0;
    for (std::size_t index = 0; index < slope.column.size(); ++index) {
        const FlexuralColumnState& state = stability.column[index];
        const double fibre = 6 * state.moment - state.normal;
        if (state.mode == FlexuralMode::bends) {
            ++bending;
            EXPECT_NEAR(fibre, slope.tensile_strength, 1e-9 * slope.tensile_strength) << index;
        } else if (state.mode == FlexuralMode::stands) {
            // The stress is below one strength or the other.
            EXPECT_TRUE(fibre <= slope.tensile_strength || 2 * state.moment <= state.normal) << index;
        }
    }
    EXPECT_GT(bending, 2);
    FlexuralSlope critical = slope;
    critical.tensile_strength = stability.required_tensile_strength;
    EXPECT_EQ(analyse(critical).toe_push, 0);
    critical.tensile_strength *= 1 - 1e-9;
    EXPECT_GT(analyse(critical).toe_push, 0);
}

TEST(FlexuralToppling, FrictionBetweenColumnsHelps) {
    double before = std::numeric_limits<double>::infinity();
    for (const double friction : {0.0, 10.0, 20.0, 30.0, 40.0}) {
        FlexuralSlope slope = slope_of({4, 8, 14, 18, 15, 12, 9, 5}, 3e5);
        slope.joint_friction_angle = degrees(friction);
        const double required = analyse(slope).required_tensile_strength;
        EXPECT_LT(required, before) << friction;
        before = required;
    }
}

// All lengths times L: stresses too.
TEST(FlexuralToppling, IsSimilarAtEveryScale) {
    const FlexuralSlope slope = slope_of({4, 8, 14, 18, 15, 12, 9, 5}, 3e5);
    FlexuralSlope model = slope;
    constexpr double scale = 1.0 / 256;
    for (FlexuralColumn& column : model.column) {
        column.width *= scale;
        column.height *= scale;
    }
    model.cohesion *= scale;
    model.tensile_strength *= scale;
    EXPECT_DOUBLE_EQ(analyse(model).factor_of_safety, analyse(slope).factor_of_safety);
}

TEST(FlexuralToppling, ColumnsAreShearedOffWeakFeet) {
    FlexuralSlope slope = slope_of({4, 8, 14, 18, 15, 12, 9, 5}, 1e9);
    slope.cohesion = 0;
    slope.friction_angle = degrees(20);
    const FlexuralStability stability = analyse(slope);
    EXPECT_EQ(stability.column.front().mode, FlexuralMode::shears);
    EXPECT_EQ(stability.factor_of_safety, 0);
    EXPECT_TRUE(std::isinf(stability.required_tensile_strength));
    // Each column needs what its weight lacks on the plane: the pushes add up.
    double weight = 0;
    for (const FlexuralColumn& column : slope.column) {
        weight += unit_weight * column.height;
    }
    const double lacking =
        weight * (std::sin(slope.base_dip) - std::tan(slope.friction_angle) * std::cos(slope.base_dip));
    EXPECT_NEAR(stability.toe_push,
                lacking / (1 - std::tan(slope.friction_angle) * std::tan(slope.joint_friction_angle)), 1e-12 * weight);
}

TEST(FlexuralToppling, RefusesWhatItCannotMean) {
    EXPECT_EQ(analyse(slope_of({}, 1e5)).check, FlexuralCheck::no_columns);
    EXPECT_EQ(analyse(slope_of({4, -1}, 1e5)).check, FlexuralCheck::input_out_of_range);
    EXPECT_EQ(analyse(slope_of({4, 2}, -1)).check, FlexuralCheck::input_out_of_range);
    EXPECT_EQ(analyse(slope_of({4, std::nan("")}, 1e5)).check, FlexuralCheck::input_out_of_range);
}

}  // namespace
}  // namespace delabole
