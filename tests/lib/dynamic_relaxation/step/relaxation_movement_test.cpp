// A run reports for each block how it has moved, and how far it has slipped over fixed ones.
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

using namespace relaxation_scenes;

// The motion is in true time and goes on whatever happens.
RelaxationSettings for_so_long(double duration) {
    RelaxationSettings settings;
    settings.local_damping = 0;
    settings.duration = duration;
    settings.stop_at_equilibrium = false;
    settings.collapse_displacement = settings.collapse_rotation = 100;
    return settings;
}

// Returns the displacement since the start of a corner of block 0.
PlanePoint<> way_of(const RelaxationScene& scene, const RelaxationSettings& settings, const PlanePoint<>& corner) {
    Motion first;
    Motion last;
    relax(scene, settings, [&](const Simulation& simulation) {
        first = simulation.state().origin[0];
        last = simulation.state().motion[0];
        return true;
    });
    const PlanePoint<> arm = corner - area_properties(scene.block[0].outline).centroid;
    return last.turned(arm) - first.turned(arm) + PlanePoint<>(last.x - first.x, last.y - first.y);
}

TEST(BaseSlip, IsTheWayOfTheToeOfABlockThatTurnsOverIt) {
    OnPlane plane;
    plane.height_to_width = 3;
    plane.tilt = degrees(40);
    plane.friction = degrees(20);
    const RelaxationScene scene = scene_of(plane);
    const double way = way_of(scene, for_so_long(0.6), {0, 0}).x();
    const BlockOutcome outcome = relax(scene, for_so_long(0.6)).block[0];
    EXPECT_EQ(outcome.movement, BlockMovement::slides_forward_and_rotates);
    ASSERT_LT(way, -0.4);
    // Slip is a step late, at 1.5 m/s some 0.4 mm, and before the block turns both corners slip.
    EXPECT_NEAR(outcome.base_slip, way, 2e-3 * std::abs(way));
}

TEST(BaseSlip, IsTheSameWithAThirdCornerBelow) {
    OnPlane plane;
    plane.tilt = degrees(30);
    plane.friction = degrees(10);
    RelaxationScene scene = scene_of(plane);
    scene.block[0].outline = {{0, 0}, {0.5, -1e-10}, {1, 0}, {1, 1}, {0, 1}};
    const BlockOutcome outcome = relax(scene, for_so_long(0.4)).block[0];
    const double way =
        gravity * (std::sin(plane.tilt) - std::tan(plane.friction) * std::cos(plane.tilt)) * 0.4 * 0.4 / 2;
    // The springs are stretched first, and slip is a step late.
    EXPECT_NEAR(outcome.base_slip, -way, 3e-3 * way);
    EXPECT_EQ(outcome.movement, BlockMovement::slides_forward);
}

TEST(BaseSlip, IsThatOverTheFaceBelow) {
    OnPlane plane;
    plane.friction = degrees(1);
    RelaxationScene scene = scene_of(plane);
    scene.block.push_back(fixed_block(rectangle(1, 0, 1, 3)));
    scene.force = {{0, {0.5, 0.5}, {plane.weight(), 3 * plane.weight()}}};  // up along the wall
    const BlockOutcome outcome = relax(scene, for_so_long(0.3)).block[0];
    EXPECT_GT(outcome.displacement, 0.3);
    EXPECT_NEAR(outcome.base_slip, 0, 1e-4);  // the block slips a little while it leaves the base
    EXPECT_EQ(outcome.movement, BlockMovement::moves);
}

TEST(BlockMovement, OfABlockOnOneThatSlides) {
    OnPlane plane;
    plane.height_to_width = 0.5;
    plane.tilt = degrees(25);
    RelaxationScene scene = scene_of(plane);
    scene.block.insert(scene.block.begin() + 1, {rectangle(0.1, 0.5, 0.8, 0.3), plane.density});
    scene.material.push_back(joint(plane.stiffness(), degrees(10)));
    scene.block[0].joint = {1, 0, 0, 0};
    const RelaxationResult result = relax(scene, for_so_long(0.4));
    EXPECT_EQ(result.block[0].movement, BlockMovement::slides_forward);
    EXPECT_EQ(result.block[1].movement, BlockMovement::moves);
    EXPECT_EQ(result.block[1].base_slip, 0);
    EXPECT_EQ(result.block[2].movement, BlockMovement::fixed);
}

// Onset is when the first block passes its threshold; others may have begun to move with it.
TEST(BlockMovement, AtOnsetThoseThatHaveSetOutAreNamed) {
    OnPlane plane;
    plane.tilt = degrees(25);
    plane.friction = degrees(20);
    RelaxationScene scene = scene_of(plane);
    scene.block.insert(scene.block.begin() + 1, {rectangle(2, 0, 1, 1), plane.density});
    scene.block[1].joint = {1, 1, 1, 1};
    scene.block[2].joint = {2, 2, 2, 2};
    scene.material.push_back(joint(plane.stiffness(), degrees(24)));
    scene.material.push_back(joint(plane.stiffness(), degrees(30)));
    RelaxationSettings settings = for_so_long(10);
    settings.stop_at_onset = true;
    const RelaxationResult result = relax(scene, settings);
    ASSERT_EQ(result.outcome, RelaxationOutcome::onset);
    EXPECT_LT(std::abs(result.block[1].base_slip), settings.onset_slide * std::sqrt(0.5));
    EXPECT_EQ(result.block[0].movement, BlockMovement::slides_forward);
    EXPECT_EQ(result.block[1].movement, BlockMovement::slides_forward);
}

// A base that accelerates by far less than friction can transmit carries its block along for metres.
TEST(BlockMovement, IsSeenFromABaseThatMoves) {
    OnPlane plane;
    RelaxationScene scene = scene_of(plane);
    scene.motion = {{1, {{0, {0, 0}}, {4, {1, 0}}}}};
    RelaxationSettings settings;
    settings.duration = 5;
    settings.stop_at_equilibrium = false;
    const RelaxationResult result = relax(scene, settings);
    // From the fourth second on the base moves evenly.
    EXPECT_EQ(result.outcome, RelaxationOutcome::equilibrium);
    EXPECT_FALSE(result.onset_time);
    EXPECT_EQ(result.block[0].movement, BlockMovement::stays);
    EXPECT_LT(result.block[0].displacement, 1e-4);  // the springs give way

    // The base accelerates by more than friction can transmit: g tan(30 deg) = 5.66 m/s2.
    scene.motion = {{1, {{0, {0, 0}}, {4, {40, 0}}}}};
    settings.stop_at_onset = true;
    const RelaxationResult left = relax(scene, settings);
    EXPECT_EQ(left.outcome, RelaxationOutcome::onset);
    EXPECT_LT(left.block[0].base_slip, 0);
}

TEST(EnergyOfRemoval, IsBookedWithTheBlock) {
    OnPlane plane;
    plane.tilt = degrees(45);
    RelaxationScene scene = scene_of(plane);
    RelaxationBlock left_behind = scene.block[0];
    for (PlanePoint<>& corner : left_behind.outline) {
        corner.x() += 2;
    }
    scene.block.push_back(left_behind);
    scene.removal = {{0, 0.2}};
    const RelaxationResult result = relax(scene, for_so_long(0.3));
    ASSERT_GT(result.energy_balance.kinetic_damping, 0.1 * result.energy_balance.applied);
    EXPECT_NEAR(result.energy_balance.residual_share(), 0, 1e-3);  // work of the last half step
}

// A run that goes on whatever happens is judged by how it ends: these runs were all "undecided" once.
TEST(OutcomeAtTheEnd, IsEquilibriumOrOnsetUnderEveryStop) {
    OnPlane plane;
    plane.tilt = degrees(10);
    const RelaxationSettings settings = for_so_long(1);
    EXPECT_EQ(relax(scene_of(plane), settings).outcome, RelaxationOutcome::equilibrium);
    plane.tilt = degrees(40);
    RelaxationResult slides = relax(scene_of(plane), settings);
    EXPECT_EQ(slides.outcome, RelaxationOutcome::onset);
    EXPECT_EQ(slides.block[0].movement, BlockMovement::slides_forward);
    RelaxationSettings short_run = settings;
    short_run.stop_at_equilibrium = true;
    EXPECT_EQ(relax(scene_of(plane), short_run).outcome, RelaxationOutcome::onset);
    // The block has not passed the thresholds, and yet is not in balance.
    short_run.duration = 0.01;
    EXPECT_EQ(relax(scene_of(plane), short_run).outcome, RelaxationOutcome::undecided);
}

}  // namespace
}  // namespace delabole
