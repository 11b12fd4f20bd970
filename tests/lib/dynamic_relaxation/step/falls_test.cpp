// Blocks that meet others at speed: none goes through, energy is kept, and what has gone wrong is never an outcome that
// can be believed.
#include "tests/support/falls.hpp"

#include "parameters/fields.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

using falls::density;
using falls::fixed_block;
using falls::gravity;
using falls::Kind;
using falls::rectangle;

// Springs at their limit of overlap stop the run; between two checks they may be a little deeper.
constexpr double limit_and_a_little = 0.06;

falls::Fall block_from_20_m(double angle) {
    falls::Fall fall;
    const double stiffness = 1e6 * density * gravity * 0.5;
    fall.scene.material = {{stiffness, stiffness, degrees(30)}};
    fall.scene.block = {{falls::at_height(rectangle(-0.5, -0.25, 1, 0.5), angle, 19.5), density},
                        fixed_block(rectangle(-60, -4, 120, 4))};
    fall.start.resize(2);
    fall.duration = 4;
    return fall;
}

// At 24, 156 and eight other angles of 180 the block went through the floor, 4 m thick: it turned so far between two
// checks of its contacts that other corners came down than those that had been listed.
TEST(Falls, NoBlockGoesThroughTheFloorWhateverItsAngle) {
    for (int angle = 0; angle < 180; angle += 12) {
        const falls::Fall fall = block_from_20_m(degrees(angle));
        const auto landing = falls::land(fall, falls::settings_of(fall));
        ASSERT_TRUE(landing);
        EXPECT_TRUE(landing->ended()) << angle;
        EXPECT_LT(landing->deepest, 0.02) << angle;  // a fall of 20 m presses a corner in by 0.4 % of the short edge
        EXPECT_LT(std::abs(landing->result.energy_balance.residual_share()), 0.02) << angle;
    }
}

// These are the first of each kind; falls_bench runs thousands. Some shots at 50 m/s and heaps, whose small polygons
// meet springs made for the largest, press their springs beyond the limit of overlap and must say so.
TEST(Falls, OfAllKindsStayOutOfEachOtherAndKeepEnergy) {
    struct Count {
        Kind kind;
        unsigned runs;
        unsigned stopped_at_most;
    };
    for (const Count& count :
         {Count{Kind::drop, 100, 0}, Count{Kind::shot, 100, 3}, Count{Kind::slide, 60, 0}, Count{Kind::heap, 3, 1}}) {
        unsigned stopped = 0;
        unsigned ran = 0;
        for (unsigned seed = 0; seed < count.runs; ++seed) {
            const falls::Fall fall = falls::fall_of(count.kind, seed);
            const auto landing = falls::land(fall, falls::settings_of(fall));
            if (!landing) {
                continue;
            }
            ++ran;
            if (landing->result.outcome == RelaxationOutcome::overlap_too_large) {
                ++stopped;
                continue;
            }
            EXPECT_TRUE(landing->ended()) << seed;
            EXPECT_LT(landing->deepest, limit_and_a_little) << static_cast<int>(count.kind) << " " << seed;
            EXPECT_LT(std::abs(landing->result.energy_balance.residual_share()), 0.025)
                << static_cast<int>(count.kind) << " " << seed;
        }
        EXPECT_GT(ran, count.runs / 2) << static_cast<int>(count.kind);
        EXPECT_LE(stopped, count.stopped_at_most) << static_cast<int>(count.kind);
    }
}

// Springs so soft that a sharp wedge sinks in by more than the limit: the run is stopped, the wedge not let through.
TEST(Falls, SoftJointsStopTheRunInsteadOfLettingBlocksThrough) {
    unsigned stopped = 0;
    for (unsigned seed = 0; seed < 150; ++seed) {
        const falls::Fall fall = falls::fall_of(Kind::drop, seed, 1e3);
        const auto landing = falls::land(fall, falls::settings_of(fall));
        ASSERT_TRUE(landing);
        if (landing->result.outcome == RelaxationOutcome::overlap_too_large) {
            ++stopped;
            continue;
        }
        EXPECT_TRUE(landing->ended()) << seed;
        EXPECT_LT(landing->deepest, limit_and_a_little) << seed;
    }
    EXPECT_GT(stopped, 10U);
    EXPECT_LT(stopped, 150U);
}

TEST(Falls, ThinPlatesEitherBounceOrStopTheRun) {
    for (const double thickness : {5e-4, 1e-3, 5e-3}) {
        for (const double height : {0.02, 0.5, 2.0}) {
            falls::Fall fall = block_from_20_m(0);
            fall.scene.block[0].outline =
                falls::at_height(rectangle(-0.5, -thickness / 2, 1, thickness), degrees(17), height);
            const double stiffness = 1e6 * density * gravity * thickness;
            fall.scene.material = {{stiffness, stiffness, degrees(30)}};
            fall.duration = std::sqrt(2 * height / gravity) + 0.2;
            const auto landing = falls::land(fall, falls::settings_of(fall));
            ASSERT_TRUE(landing);
            if (landing->result.outcome != RelaxationOutcome::overlap_too_large) {
                EXPECT_TRUE(landing->ended()) << thickness << " " << height;
                EXPECT_LT(landing->deepest, limit_and_a_little) << thickness << " " << height;
            }
        }
    }
}

// The contacts do not know of the overlap, as when a program has put a block there.
TEST(Audit, BlockInsideAnotherIsNoOutcome) {
    const falls::Fall fall = block_from_20_m(0);
    RelaxationSettings settings = falls::settings_of(fall);
    settings.duration = 0.05;
    Simulation simulation(fall.scene, settings);
    RelaxationState state = simulation.state();
    state.motion[0].y = -21;
    Simulation inside(fall.scene, settings, state);
    while (inside.running()) {
        inside.step();
    }
    const RelaxationResult result = inside.result();
    EXPECT_EQ(result.outcome, RelaxationOutcome::overlap_too_large);
    ASSERT_TRUE(result.overlap);
    EXPECT_NEAR(result.overlap->area, 0.5, 1e-12);  // all of the block
}

TEST(Audit, EnergyThatIsNotThereIsNoOutcome) {
    const falls::Fall fall = block_from_20_m(degrees(10));
    const RelaxationSettings settings = falls::settings_of(fall);
    const auto outcome_with = [&](double share) {
        Simulation simulation(fall.scene, settings);
        RelaxationState state = simulation.state();
        // This is a share of the work of the fall, 19.5 m and what the block lies down by. The turnover is twice that.
        state.energy_balance.applied += share * 0.5 * density * gravity * 19.5;
        Simulation run(fall.scene, settings, state);
        while (run.running()) {
            run.step();
        }
        return run.outcome();
    };
    EXPECT_NE(outcome_with(0), RelaxationOutcome::energy_not_balanced);
    EXPECT_NE(outcome_with(0.1), RelaxationOutcome::energy_not_balanced);
    EXPECT_EQ(outcome_with(0.4), RelaxationOutcome::energy_not_balanced);
    EXPECT_EQ(outcome_with(-0.4), RelaxationOutcome::energy_not_balanced);
}

TEST(Overlap, IsTheCommonArea) {
    RelaxationScene scene;
    scene.block = {{rectangle(0, 0, 2, 1), density}, {rectangle(3, 0, 1, 1), density}};
    const Bodies bodies = make_bodies(scene);
    std::vector<Motion> motion(2);
    const std::vector<char> removed(2, 0);
    EXPECT_FALSE(greatest_overlap(bodies, motion, removed));
    motion[1].x = -1;  // face on face
    EXPECT_FALSE(greatest_overlap(bodies, motion, removed));
    motion[1].x = -1.25;
    motion[1].y = 0.5;
    const auto corner = greatest_overlap(bodies, motion, removed);
    ASSERT_TRUE(corner);
    EXPECT_NEAR(corner->area, 0.25 * 0.5, 1e-15);
    EXPECT_NEAR(corner->depth, 0.25, 1e-15);
    EXPECT_NEAR(corner->share, 0.25, 1e-15);
    // The block is turned by 45 deg in the middle of the other, and cut off above and below.
    motion[1].x = -2.5;
    motion[1].y = 0;
    motion[1].set_angle(degrees(45));
    const auto diamond = greatest_overlap(bodies, motion, removed);
    ASSERT_TRUE(diamond);
    const double tip = std::sqrt(0.5) - 0.5;
    EXPECT_NEAR(diamond->area, 1 - 2 * tip * tip, 1e-14);
    EXPECT_FALSE(greatest_overlap(bodies, motion, {0, 1}));
}

// Standing blocks stay where they are at the greatest step fraction allowed, with any damping. From 0.9 on they
// trembled, and without damping thirteen of them collapsed at 0.95.
TEST(StepFraction, StandsAtItsGreatestWithAnyDamping) {
    for (const double local : {0.0, 0.2, 0.5, 0.8}) {
        for (const double viscous : {0.0, 0.2, 1.0, 2.0}) {
            for (const double height : {1.0, 3.0}) {
                RelaxationScene scene;
                for (int column = 0; column < 13; ++column) {
                    scene.block.push_back({rectangle(column, 0, 1, height), density});
                }
                scene.block.push_back(fixed_block(rectangle(-10, -2, 40, 2)));
                const double stiffness = 1e6 * density * gravity * height;
                scene.material = {{stiffness, stiffness, degrees(30)}};
                scene.gravity.tilt = scene.gravity.final_tilt = degrees(5);
                RelaxationSettings settings;
                settings.step_fraction = 0.8;
                settings.local_damping = local;
                settings.viscous_damping = viscous;
                settings.stop_at_equilibrium = false;
                settings.duration = 1e9;
                settings.most_steps = 3000;
                const RelaxationResult result = relax(scene, settings);
                EXPECT_TRUE(result.outcome == RelaxationOutcome::undecided ||
                            result.outcome == RelaxationOutcome::equilibrium)
                    << local << " " << viscous << " " << height;
                // The bound, J/m, is that of a fall by the settlement; what is not damped goes on swinging.
                const double weight = density * gravity * height;
                EXPECT_LT(result.energy_balance.kinetic, 13 * weight * weight / stiffness)
                    << local << " " << viscous << " " << height;
            }
        }
    }
}

}  // namespace
}  // namespace delabole
