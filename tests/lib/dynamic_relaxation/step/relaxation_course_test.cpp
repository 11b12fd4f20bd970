// How runs begin, what drives and damps them: prescribed motion, removal, consolidation, starts, masses.
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include "dynamic_relaxation/scene/scenes.hpp"
#include "tests/support/brick_pack.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace delabole {
namespace {

using namespace relaxation_scenes;

TEST(PrescribedMotion, CarriesABlockByFriction) {
    const OnPlane plane = flat(20);
    const double friction = gravity * std::tan(plane.friction);
    for (const double share : {0.5, 0.95, 1.5}) {
        for (const double sense : {-1.0, 1.0}) {
            RelaxationScene scene = scene_of(plane);
            const double acceleration = sense * share * friction;
            PrescribedMotion motion{1, {{0, {0, 0}}, {10, {10 * acceleration, 0}}}};
            scene.motion = {motion};
            RelaxationSettings settings = unlimited(0.5);
            settings.local_damping = 0;  // it would hold the block back against the drawing
            const RelaxationResult result = relax(scene, settings);
            const double expected = sense * std::min(share, 1.0) * friction * result.time * result.time / 2;
            Simulation simulation(scene, settings);
            while (simulation.running()) {
                simulation.step();
            }
            // Shear springs stretch first, by some 1e-6 of the width; the base's velocity is that of the step's start.
            EXPECT_NEAR(simulation.state().motion[0].x, expected, 0.002 * std::abs(expected)) << share;
            EXPECT_LT(energy_error(result, 0), 0.02) << share;
        }
    }
}

TEST(PrescribedMotion, TurningTheBaseFindsTheAngleOfFriction) {
    expect_threshold(
        [](double part) {
            RelaxationScene scene = scene_of(flat(20));
            PrescribedMotion motion{1, {}};
            motion.angular_velocity = degrees(20);  // slow: w^2 b / g is 0.01
            motion.duration = part * 20 / 20;
            scene.motion = {motion};
            return scene;
        },
        "turned base");
}

// It makes no difference for a tilted frame whether it or gravity has turned.
TEST(PrescribedMotion, BlocksOnATurnedBaseAreSeenFromIt) {
    const double tilt = degrees(15);
    const auto run = [&](bool base_turns) {
        RelaxationScene scene = scene_of(flat(20));
        if (base_turns) {
            PrescribedMotion motion{1, {}};
            motion.angular_velocity = degrees(2);
            motion.duration = tilt / motion.angular_velocity;
            scene.motion = {motion};
        } else {
            scene.gravity.rate = degrees(2);
            scene.gravity.final_tilt = tilt;
        }
        RelaxationSettings settings;
        settings.local_damping = 0.2;
        return relax(scene, settings);
    };
    const RelaxationResult base = run(true);
    const RelaxationResult gravity_turned = run(false);
    EXPECT_EQ(base.outcome, RelaxationOutcome::equilibrium);
    EXPECT_EQ(base.block[0].movement, BlockMovement::stays);
    // The base starts to turn at once, which lifts the block by some 3e-5 of its width. In fixed axes it moves by 0.18.
    EXPECT_NEAR(base.block[0].rotation, gravity_turned.block[0].rotation, 1e-4);
    EXPECT_NEAR(base.block[0].displacement, gravity_turned.block[0].displacement, 1e-4);
}

TEST(Removal, OfASupportLetsABlockFall) {
    RelaxationScene scene = scene_of({});
    scene.block[0] = {rectangle(0, 0, 1, 1), density};
    scene.block.push_back({rectangle(0.1, 1, 0.8, 1), density});
    scene.removal = {{0, 0.25}};
    RelaxationSettings settings = unlimited(0.55);
    settings.local_damping = 0;
    const RelaxationResult result = relax(scene, settings);
    EXPECT_EQ(result.block[0].movement, BlockMovement::removed);
    const double fall = result.time - 0.25;
    // The moment of removal is that of the next step, 1e-4 s later at most.
    EXPECT_NEAR(result.block[2].displacement, gravity * fall * fall / 2, 2e-3 * result.block[2].displacement);
    EXPECT_NEAR(result.block[2].rotation, 0, 1e-9);
    EXPECT_LT(energy_error(result, 0), 0.02);
    // The block lands and comes to rest, a block's height lower.
    settings = RelaxationSettings();
    settings.collapse_displacement = settings.collapse_rotation = 100;
    const RelaxationResult lands = relax(scene, settings);
    EXPECT_EQ(lands.outcome, RelaxationOutcome::equilibrium);
    EXPECT_NEAR(lands.block[2].displacement, 1, 1e-5);
    EXPECT_LT(energy_error(lands, 0), 0.02);
}

TEST(Consolidation, HeldBlocksGoWhenReleased) {
    for (const double tilt : {15.0, 25.0}) {
        RelaxationScene scene;
        scene.block = {{rectangle(0, 0, 1, 1), density}, {rectangle(1, 0, 1, 1), density}};
        scene.block[0].held_at_first = true;
        scene.block.push_back(fixed_block(rectangle(-3, -1, 8, 1)));
        scene.material = {joint(1e6 * density * gravity, degrees(20))};
        scene.gravity.tilt = scene.gravity.final_tilt = degrees(tilt);
        RelaxationSettings settings = until_onset();
        settings.consolidation_time = 0.4;
        double moved_while_held = 0;
        const RelaxationResult result = relax(scene, settings, [&](const Simulation& simulation) {
            const RelaxationState& state = simulation.state();
            if (state.time <= settings.consolidation_time) {
                const Motion& held = state.motion[0];
                moved_while_held =
                    std::max(moved_while_held, std::abs(held.x) + std::abs(held.y) + std::abs(held.angle));
                // The block that leans on it has moved no more than the springs give way.
                EXPECT_LT(std::abs(state.motion[1].x), 1e-4);
            }
            return true;
        });
        EXPECT_EQ(moved_while_held, 0);
        EXPECT_GE(result.time, settings.consolidation_time);
        EXPECT_EQ(result.outcome, tilt > 20 ? RelaxationOutcome::onset : RelaxationOutcome::equilibrium) << tilt;
    }
}

TEST(Start, RampedAndDroppedSettleWherePreloadedStarts) {
    OnPlane plane;
    plane.height_to_width = 2;
    plane.friction = degrees(40);
    plane.tilt = degrees(10);
    plane.stiffness_ratio = 1e4;
    const auto settled = [&](RelaxationStart start) {
        RelaxationSettings settings;
        settings.start = start;
        settings.ramp_time = 0.5;
        settings.equilibrium_ratio = 1e-8;
        Simulation simulation(scene_of(plane), settings);
        while (simulation.running()) {
            simulation.step();
        }
        EXPECT_EQ(simulation.outcome(), RelaxationOutcome::equilibrium);
        return simulation.state().motion[0];
    };
    const Motion preloaded = settled(RelaxationStart::preloaded);
    const double settlement = plane.width / plane.stiffness_ratio;
    ASSERT_LT(preloaded.y, -0.4 * settlement);
    for (const auto start : {RelaxationStart::ramped, RelaxationStart::dropped}) {
        const Motion other = settled(start);
        // The start is unbalanced by 1e-8 of the weight or less, over springs of which none has slipped.
        EXPECT_NEAR(other.y, preloaded.y, 1e-6 * settlement);
        EXPECT_NEAR(other.angle, preloaded.angle, 1e-6 * settlement);
        if (start == RelaxationStart::ramped) {
            // Corners that are hardly pressed yet slip a little as the first loads come.
            EXPECT_NEAR(other.x, preloaded.x, 1e-3 * settlement);
        }
    }
}

TEST(Start, TellsHowFarFromBalanceItIs) {
    OnPlane plane;
    plane.height_to_width = 2;
    plane.friction = degrees(30);
    plane.tilt = degrees(10);
    RelaxationSettings settings;
    const RelaxationResult stands = relax(scene_of(plane), settings);
    ASSERT_TRUE(stands.start_balance);
    EXPECT_LE(stands.start_balance->unbalanced_ratio, settings.equilibrium_ratio / 10);
    // The least unbalance is what friction lacks along the plane, over the weight; pressed harder than by its weight,
    // the block lacks a little less, at a right angle to the greatest force of the plane.
    plane.tilt = degrees(31);
    const double lacking = std::sin(plane.tilt) - std::cos(plane.tilt) * std::tan(plane.friction);
    const RelaxationResult slides = relax(scene_of(plane), settings);
    ASSERT_TRUE(slides.start_balance);
    EXPECT_GT(slides.start_balance->unbalanced_ratio, lacking * std::cos(plane.friction));
    EXPECT_LT(slides.start_balance->unbalanced_ratio, 0.1);  // it is 1 where nothing carries the block
    settings.start = RelaxationStart::dropped;
    EXPECT_FALSE(relax(scene_of(plane), settings).start_balance);
}

TEST(Start, OfAThousandBricksFindsTheirBalance) {
    RelaxationSettings settings;
    settings.duration = 1e-6;
    const RelaxationResult result = relax(brick_pack_scene({22, 45, 1e5, degrees(40), degrees(20)}), settings);
    ASSERT_TRUE(result.start_balance);
    EXPECT_FALSE(result.start_balance->cut_short);
    EXPECT_LE(result.start_balance->unbalanced_ratio, settings.equilibrium_ratio / 10);
}

TEST(EnergyBalance, LacksNothingWhereOnlyRoundingIsTurnedOver) {
    EnergyBalance balance;
    EXPECT_EQ(balance.residual_share(), 0);
    balance.elastic_at_start = 1;
    balance.applied = 1e-14;
    balance.elastic = -1e-12;
    EXPECT_EQ(balance.residual_share(), 0);
    balance.elastic = -1e-8;
    EXPECT_GT(balance.residual_share(), 0.9);
    balance.applied = 10;
    balance.friction = 9;
    balance.elastic = 0;
    EXPECT_DOUBLE_EQ(balance.residual_share(), 1.0 / 19);
}

TEST(KineticDamping, FindsTheSameThreshold) {
    OnPlane plane;
    plane.height_to_width = 3;
    plane.friction = degrees(60);
    RelaxationSettings settings = until_onset();
    settings.local_damping = 0;
    settings.kinetic_damping = true;
    const double law = 1 / 3.0 - std::sqrt(1 + 1 / 9.0) / plane.stiffness_ratio;
    for (const auto start : {RelaxationStart::preloaded, RelaxationStart::ramped}) {
        settings.start = start;
        settings.ramp_time = 1;
        for (const bool fails : {false, true}) {
            plane.tilt = std::atan((fails ? 1.005 : 0.995) * law);
            const RelaxationResult result = relax(scene_of(plane), settings);
            EXPECT_EQ(result.outcome, fails ? RelaxationOutcome::onset : RelaxationOutcome::equilibrium);
            EXPECT_LT(energy_error(result, 1e-6 * plane.weight()), 0.02);
        }
    }
}

// Columns of Appendix A, 0.4 to 4 m high: limiting friction 41.14 deg.
TEST(MassScaling, DecidesTheSameInFewerSteps) {
    StandingBlocks columns;
    for (const double height : {1.0, 2.0, 3.0, 4.0, 3.1, 2.2, 1.3, 0.4}) {
        columns.block.push_back({1, height, 0.5});
    }
    columns.density = density;
    columns.tilt = degrees(21.8);
    const double stiffness = stiffness_of_ratio(1e6, columns.block[3], density, gravity);
    for (const double friction : {40.6, 41.7}) {
        columns.interface = columns.base = {stiffness, stiffness, degrees(friction)};
        RelaxationSettings settings = until_onset();
        const RelaxationResult own = relax(column_scene(columns), settings);
        settings.mass_scaling = true;
        const RelaxationResult scaled = relax(column_scene(columns), settings);
        EXPECT_EQ(own.outcome, friction < 41 ? RelaxationOutcome::onset : RelaxationOutcome::equilibrium);
        EXPECT_EQ(scaled.outcome, own.outcome);
        // The stable step goes with the root of the lightest block's inertia, a tenth of the heaviest's.
        EXPECT_GT(scaled.cost.step, 1.8 * own.cost.step);
        EXPECT_LT(energy_error(scaled, 1e-6 * density * gravity), 0.02);
    }
}

// Pushed at 4 m/s2 for so long, a block five times as high as it is wide leans by 0.0130 rad, damped as it is, and
// falls back on its heel (the equation of motion about its toe); or it topples.
TEST(Onset, IsNotALeanFromWhichABlockFallsBack) {
    for (const double pushed : {0.18, 0.6}) {
        OnPlane plane;
        plane.height_to_width = 5;
        plane.friction = degrees(60);
        RelaxationScene scene = scene_of(plane);
        scene.shaking = {{0, {4, 0}}, {pushed, {4, 0}}, {pushed + 1e-3, {0, 0}}};
        Simulation simulation(scene, until_onset());
        double farthest = 0;
        while (simulation.running()) {
            simulation.step();
            farthest = std::max(farthest, std::abs(simulation.state().motion[0].angle));
        }
        EXPECT_GT(farthest, simulation.settings().onset_rotation) << pushed;
        EXPECT_LT(farthest, 2.1 * simulation.settings().onset_rotation) << pushed;
        EXPECT_EQ(simulation.outcome(), pushed < 0.5 ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset);
        EXPECT_EQ(simulation.result().onset_time.has_value(), pushed > 0.5);
    }
}

TEST(MassScaling, LeavesEqualBlocksAlone) {
    OnPlane plane;
    plane.height_to_width = 3;
    plane.friction = degrees(40);
    plane.tilt = degrees(25);
    RelaxationSettings settings;
    const RelaxationResult own = relax(scene_of(plane), settings);
    settings.mass_scaling = true;
    const RelaxationResult scaled = relax(scene_of(plane), settings);
    EXPECT_EQ(own.outcome, RelaxationOutcome::collapse);
    EXPECT_EQ(scaled.time, own.time);
    EXPECT_EQ(scaled.block[0].rotation, own.block[0].rotation);
}

}  // namespace
}  // namespace delabole
