// A block on an incline: Ashby's criteria, the rigid body's onset of motion, loads, extremes.
#include "limit_equilibrium/block_row/single_block.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace delabole {
namespace {

// Chains of a dozen operations.
constexpr double rounding = 1e-13;

SingleBlock block(double height, double width, double inclination, double friction) {
    return {{height, width, 25e3}, {degrees(inclination), degrees(friction), 0}, {}, {}};
}

TEST(SingleBlock, AshbysCriteria) {
    for (const double friction : {5.0, 20.0, 60.0}) {
        const SingleBlockResult result = analyse(block(3, 1, 15, friction));
        ASSERT_EQ(result.check, SingleBlockCheck::valid);
        EXPECT_NEAR(result.critical_sliding_inclination, degrees(friction), rounding);
        EXPECT_NEAR(result.critical_toppling_inclination, std::atan(1.0 / 3), rounding);
        EXPECT_NEAR(result.factor_of_safety, std::tan(degrees(friction)) / std::tan(degrees(15)), rounding);
        EXPECT_NEAR(result.overturning_factor, 1 / (3 * std::tan(degrees(15))), rounding);
    }
    EXPECT_EQ(analyse(block(3, 1, 15, 20)).static_mode, BlockMotion::stable);
    EXPECT_EQ(analyse(block(3, 1, 19, 20)).static_mode, BlockMotion::topples);
    EXPECT_EQ(analyse(block(3, 1, 15, 10)).static_mode, BlockMotion::slides);
    EXPECT_EQ(analyse(block(3, 1, 25, 20)).static_mode, BlockMotion::slides_and_topples);
}

// Verification deck: width over height a third. The printed angles have three decimals.
TEST(SingleBlock, ToppleOnlyAgainstSlideAndTopple) {
    const double slenderness = degrees(18.435);
    const auto boundary = [&](double inclination) {
        return toe_slip_friction_angle(degrees(inclination), slenderness) / degrees(1);
    };
    EXPECT_NEAR(boundary(25), 20.083, 5e-4);
    EXPECT_NEAR(boundary(30), 21.364, 5e-4);
    EXPECT_NEAR(boundary(45), 25.560, 5e-4);
}

// The accelerations of each contact, tried one by one, must find the closed boundary.
TEST(SingleBlock, OnsetChangesAtTheClosedBoundaries) {
    const double slenderness = std::atan(1.0 / 3) / degrees(1);
    for (const double inclination : {20.0, 25.0, 30.0, 45.0, 70.0, 89.0}) {
        const double boundary = toe_slip_friction_angle(degrees(inclination), degrees(slenderness)) / degrees(1);
        EXPECT_EQ(analyse(block(3, 1, inclination, boundary + 1e-9)).onset_mode, BlockMotion::topples);
        EXPECT_EQ(analyse(block(3, 1, inclination, boundary - 1e-9)).onset_mode, BlockMotion::slides_and_topples);
        EXPECT_EQ(analyse(block(3, 1, inclination, slenderness + 1e-9)).onset_mode, BlockMotion::slides_and_topples);
        // Below it slides and never topples, though the static chart says that it does both.
        const SingleBlockResult flat = analyse(block(3, 1, inclination, slenderness - 1e-9));
        EXPECT_EQ(flat.onset_mode, BlockMotion::slides);
        EXPECT_EQ(flat.static_mode, BlockMotion::slides_and_topples);
    }
}

TEST(SingleBlock, AccelerationsOfTextbookMotions) {
    const SingleBlockResult sliding = analyse(block(1, 2, 30, 20));
    EXPECT_NEAR(sliding.toe_acceleration, std::sin(degrees(30)) - std::tan(degrees(20)) * std::cos(degrees(30)),
                rounding);
    // A rod-like block on a rough level plane, tipped by its inclination: 3 g sin / (2 L) for width to zero.
    const SingleBlockResult rod = analyse(block(1, 1e-9, 30, 89));
    EXPECT_EQ(rod.onset_mode, BlockMotion::topples);
    EXPECT_NEAR(rod.angular_acceleration, 1.5 * std::sin(degrees(30)), 1e-8);  // width over height is 1e-9
}

// An earthquake is a turn of gravity: k_h = tan(d) with k_v = 0 acts as a tilt by d and a weight larger by 1 / cos(d).
TEST(SingleBlock, EarthquakeIsATilt) {
    SingleBlock shaken = block(3, 2, 10, 25);
    shaken.seismic = SeismicLoad<>{std::tan(degrees(12)), 0};
    const SingleBlockResult tilted = analyse(block(3, 2, 22, 25));
    const SingleBlockResult result = analyse(shaken);
    EXPECT_NEAR(result.factor_of_safety, tilted.factor_of_safety, rounding);
    EXPECT_NEAR(result.overturning_factor, tilted.overturning_factor, rounding);
    EXPECT_NEAR(result.critical_sliding_inclination, degrees(25 - 12), rounding);
    EXPECT_NEAR(result.critical_toppling_inclination, std::atan(2.0 / 3) - degrees(12), rounding);
}

TEST(SingleBlock, CohesionHoldsUntilTheBaseOpens) {
    SingleBlock glued = block(1, 2, 40, 10);
    const double driving = 50e3 * std::sin(degrees(40));
    const double friction = 50e3 * std::cos(degrees(40)) * std::tan(degrees(10));
    glued.base.cohesion = (driving - friction) / 2 * 1.0001;
    EXPECT_EQ(analyse(glued).onset_mode, BlockMotion::stable);
    EXPECT_NEAR(analyse(glued).factor_of_safety, 1, 1e-4);
    glued.base.cohesion *= 0.999;
    EXPECT_EQ(analyse(glued).onset_mode, BlockMotion::slides);
    EXPECT_LT(analyse(glued).critical_sliding_inclination, degrees(40));
}

// Water of one depth on both sides on a level base gives no net push, and its pressure lifts the whole base.
TEST(SingleBlock, WaterOnBothSidesOnlyLifts) {
    SingleBlock drowned = block(2, 1, 0, 30);
    drowned.water = BlockWater{10e3, 1.5, 1.5};
    const SingleBlockResult result = analyse(drowned);
    EXPECT_NEAR(result.driving_force, 0, rounding);
    EXPECT_NEAR(result.normal_force, 50e3 - 15e3, 1e-8);  // forces of 1e5
    EXPECT_NEAR(result.reaction_position, 0.5, rounding);
    EXPECT_EQ(result.onset_mode, BlockMotion::stable);
    // By hand for water behind only: push 11.25 kN at 0.5 m, uplift 7.5 kN at two thirds of the base.
    drowned.water->depth_in_front.reset();
    const SingleBlockResult pushed = analyse(drowned);
    EXPECT_NEAR(pushed.overturning_factor, 25e3 / (11.25e3 * 0.5 + 7.5e3 * 2 / 3), rounding);
    EXPECT_NEAR(pushed.factor_of_safety, std::tan(degrees(30)) * 42.5 / 11.25, rounding);
    drowned.water->depth_behind = 2.1;
    EXPECT_EQ(analyse(drowned).check, SingleBlockCheck::water_above_block);
}

TEST(SingleBlock, HeavyUpliftLiftsOff) {
    SingleBlock light = block(2, 1, 0, 30);
    light.block.unit_weight = 1e3;
    light.water = BlockWater{10e3, 2, 2.0};
    EXPECT_EQ(analyse(light).onset_mode, BlockMotion::lifts_off);
    EXPECT_EQ(analyse(light).static_mode, BlockMotion::lifts_off);
    // Whatever its cohesion is.
    light.base.cohesion = 1e6;
    EXPECT_EQ(analyse(light).factor_of_safety, 0);
    EXPECT_EQ(analyse(light).overturning_factor, 0);
}

TEST(SingleBlock, BadInputIsNamed) {
    EXPECT_EQ(analyse(block(-1, 1, 10, 10)).check, SingleBlockCheck::input_out_of_range);
    EXPECT_EQ(analyse(block(1, 1, 90, 10)).check, SingleBlockCheck::input_out_of_range);
    EXPECT_EQ(analyse(block(1, 1, std::nan(""), 10)).check, SingleBlockCheck::input_out_of_range);
}

// Similar blocks behave alike, and a block rests exactly where both static criteria say so. Nothing is NaN.
TEST(SingleBlock, InvariantsOverTheExtremes) {
    RandomProblem random(7);
    for (int count = 0; count < 10000; ++count) {
        SingleBlock problem = block(1, 1, 0, 0);
        problem.block.width = random.logarithmic(1e-3, 1e3);
        problem.block.height = problem.block.width * random.logarithmic(0.05, 100);
        problem.base.inclination = degrees(random.uniform(0, 89.9));
        problem.base.friction_angle = degrees(random.uniform(0, 89.9));
        if (random.chance(0.3)) {
            problem.base.cohesion = 25e3 * problem.block.height * random.uniform(0, 1);
        }
        if (random.chance(0.3)) {
            problem.seismic = SeismicLoad<>{random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5)};
        }
        if (random.chance(0.3)) {
            problem.water = BlockWater{9810, problem.block.height * random.uniform(0, 1), {}};
        }
        const SingleBlockResult result = analyse(problem);
        ASSERT_EQ(result.check, SingleBlockCheck::valid);
        for_each_number(result, [](double value, const FieldInfo&) { ASSERT_FALSE(std::isnan(value)); });
        if (!problem.seismic && !problem.water) {
            EXPECT_EQ(result.onset_mode == BlockMotion::stable, result.static_mode == BlockMotion::stable) << count;
        }
        SingleBlock larger = problem;
        larger.block.height *= 8;
        larger.block.width *= 8;
        larger.base.cohesion *= 8;
        if (larger.water) {
            larger.water->depth_behind *= 8;
        }
        const SingleBlockResult scaled = analyse(larger);
        EXPECT_EQ(scaled.onset_mode, result.onset_mode);
        EXPECT_EQ(scaled.angular_acceleration, result.angular_acceleration);  // powers of two are exact
        SingleBlock heavier = problem;
        heavier.block.unit_weight *= 4;
        heavier.base.cohesion *= 4;
        if (heavier.water) {
            heavier.water->unit_weight *= 4;
        }
        const SingleBlockResult weighed = analyse(heavier);
        EXPECT_EQ(weighed.onset_mode, result.onset_mode);
        EXPECT_EQ(weighed.static_mode, result.static_mode);
        EXPECT_EQ(weighed.angular_acceleration, result.angular_acceleration);
    }
}

TEST(SingleBlock, PredictsThroughTheInterface) {
    const ModelInterface model = model_interface(block(3, 1, 15, 20));
    const auto friction = std::ranges::find(model.inputs, "base.friction_angle", &Quantity::name);
    const auto critical = std::ranges::find(model.outputs, "critical_sliding_inclination", &Quantity::name);
    ASSERT_NE(friction, model.inputs.end());
    ASSERT_NE(critical, model.outputs.end());
    const std::vector<Assignment> assignments = {
        {static_cast<std::size_t>(friction - model.inputs.begin()), degrees(33)}};
    const Prediction prediction = model.predict(assignments);
    ASSERT_EQ(prediction.failure, "");
    EXPECT_NEAR(prediction.outputs[static_cast<std::size_t>(critical - model.outputs.begin())], degrees(33), rounding);
    const std::vector<Assignment> bad = {{assignments[0].input, -1}};
    EXPECT_EQ(model.predict(bad).failure, "input_out_of_range");
}

}  // namespace
}  // namespace delabole
