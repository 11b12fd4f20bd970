// Bolts between moving blocks: what they hold, when they yield, and that nothing of them is lost.
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include "dynamic_relaxation/checkpoint/checkpoint.hpp"
#include "dynamic_relaxation/scene/bolts.hpp"
#include "dynamic_relaxation/step/history.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/study/strength_bound.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

using namespace relaxation_scenes;

OnPlane steep() {
    OnPlane plane;
    plane.height_to_width = 0.5;
    plane.friction = degrees(20);
    plane.tilt = degrees(40);
    return plane;
}

// The bolt is normal to the plane and tensioned to its capacity: it exerts a constant force.
RelaxationScene pressed(double force) {
    RelaxationScene scene = scene_of(steep());
    scene.bolt = {{0, 0, 1, {0.5, 0.5}, {0.5, -0.5}, 1e6, force, force}};
    return scene;
}

// W sin a = tan f (W cos a + P).
TEST(Bolts, TensionPressesABlockOnItsPlane) {
    const OnPlane plane = steep();
    const double least = plane.weight() * (std::sin(plane.tilt) / std::tan(plane.friction) - std::cos(plane.tilt));
    expect_threshold([&](double part) { return pressed(least / part); }, "pressed by a bolt");
}

// A block on a smooth plane hangs on an untensioned bolt along it, from a wall behind.
RelaxationScene hanging(double stiffness, double capacity) {
    OnPlane plane = steep();
    plane.friction = 0;
    RelaxationScene scene = scene_of(plane);
    scene.block.push_back(fixed_block(rectangle(3, 0, 1, 2)));
    scene.bolt = {{0, 0, 2, {0, 0.25}, {3.5, 0.25}, stiffness, 0, capacity}};
    return scene;
}

TEST(Bolts, ABlockHangsOnABar) {
    const OnPlane plane = steep();
    const double force = plane.weight() * std::sin(plane.tilt);
    // The bolt is so stiff that the block moves by less than onset, a hundredth of its radius.
    const double stiffness = force / 1e-3;
    RelaxationSettings settings;
    const RelaxationResult at_rest = relax(hanging(stiffness, 10 * force), settings);
    ASSERT_EQ(at_rest.outcome, RelaxationOutcome::equilibrium);
    EXPECT_NEAR(at_rest.bolt[0].force / force, 1, 1e-6);  // the balance of a static start
    settings.start = RelaxationStart::dropped;
    const RelaxationResult result = relax(hanging(stiffness, 10 * force), settings);
    ASSERT_EQ(result.outcome, RelaxationOutcome::equilibrium);
    ASSERT_EQ(result.bolt.size(), 1U);
    // The tolerance is what counts as rest, with room for the last of the swing.
    EXPECT_NEAR(result.bolt[0].force / force, 1, 1e-4);
    EXPECT_EQ(result.bolt[0].yielded, 0);
    EXPECT_NEAR(result.block[0].displacement, 1e-3, 1e-6);
    EXPECT_LT(energy_error(result, 1e-3 * density * gravity), 0.01);
}

// Statics counts a bolt as any tension up to its capacity. One that the block would shorten holds nothing.
TEST(Bolts, StaticsLetsThemPullAndNotPush) {
    const OnPlane plane = steep();
    const double force = plane.weight() * std::sin(plane.tilt);
    EXPECT_FALSE(mechanism_of_statics(hanging(1e8, 1.01 * force)));
    EXPECT_TRUE(mechanism_of_statics(hanging(1e8, 0.99 * force)));
    RelaxationScene shortened = hanging(1e8, 10 * force);
    shortened.block.back() = fixed_block(rectangle(-4, 0, 1, 2));
    shortened.bolt = {{0, 0, 2, {0, 0.25}, {-3.5, 0.25}, 1e8, 0, 10 * force}};
    EXPECT_TRUE(mechanism_of_statics(shortened));
}

// The bolt is weaker than the pull on it: it stretches on at its capacity, and the rest pulls the block down.
TEST(Bolts, AWeakBarYields) {
    const OnPlane plane = steep();
    const double force = plane.weight() * std::sin(plane.tilt);
    RelaxationSettings settings = unlimited(0.5);
    settings.start = RelaxationStart::dropped;
    settings.viscous_damping = settings.local_damping = 0;
    const RelaxationResult result = relax(hanging(1e8, force / 2), settings);
    EXPECT_EQ(result.bolt[0].force, force / 2);
    const double way = gravity * std::sin(plane.tilt) / 2 * 0.5 * 0.5 / 2;
    EXPECT_NEAR(result.block[0].displacement / way, 1, 0.01);  // it held a little longer while it was elastic
    EXPECT_NEAR(result.bolt[0].yielded / way, 1, 0.01);
    RelaxationScene uphill = hanging(1e8, force / 2);
    uphill.gravity.tilt = uphill.gravity.final_tilt = -plane.tilt;
    EXPECT_EQ(relax(uphill, settings).bolt[0].force, 0) << "a bolt pulls, it does not push";
}

// A frame shows a bolt from the point of the moved block to the wall, with its force: at first whole, then yielded.
TEST(Bolts, FramesShowWhereTheyAreAndWhatTheyBear) {
    const OnPlane plane = steep();
    const double force = plane.weight() * std::sin(plane.tilt) / 2;
    RelaxationSettings settings = unlimited(0.5);
    settings.start = RelaxationStart::dropped;
    Simulation simulation(hanging(1e8, force), settings);
    MotionRecord record;
    while (simulation.running()) {
        record.record(simulation);
        simulation.step();
    }
    record.add_last(simulation);
    const BoltPull first = record.frame.front().bolt.at(0);
    EXPECT_EQ(first.force, 0) << "the bolt is put in without tension";
    EXPECT_EQ(first.yielded, 0);
    const BoltPull last = record.frame.back().bolt.at(0);
    EXPECT_EQ(last.force, force);
    EXPECT_GT(last.yielded, 0);
    EXPECT_TRUE(last.holds);
    EXPECT_NEAR(last.at.x(), record.frame.back().motion[0].x, 1e-12);  // its end is at x = 0 in the drawing
    EXPECT_EQ(last.other_at, PlanePoint<>(3.5, 0.25)) << "the wall is fixed";
}

TEST(Bolts, GoOnFromACheckpoint) {
    const RelaxationScene scene = hanging(1e8, 1e4);
    RelaxationSettings settings = unlimited(0.2);
    settings.start = RelaxationStart::dropped;
    Simulation whole(scene, settings);
    while (whole.state().time < 0.1) {
        whole.step();
    }
    const RestoredState restored = restore_checkpoint(checkpoint_of(scene, settings, whole.state()), scene, settings);
    ASSERT_EQ(restored.check, CheckpointCheck::ok);
    Simulation resumed(scene, settings, restored.state);
    while (whole.running()) {
        whole.step();
        resumed.step();
    }
    EXPECT_GT(whole.state().bolt[0].yielded, 0);
    EXPECT_EQ(resumed.state().bolt[0].yielded, whole.state().bolt[0].yielded);
    EXPECT_EQ(resumed.result().energy_balance.applied, whole.result().energy_balance.applied);
}

// A bolt does not make a run unstable, however stiff it is beside the joints.
TEST(Bolts, StiffOnesShortenTheStep) {
    RelaxationSettings settings = unlimited(0.01);
    const RelaxationResult soft = relax(hanging(1e6, 1e9), settings);
    const RelaxationResult stiff = relax(hanging(1e3 * steep().stiffness(), 1e9), settings);
    EXPECT_LT(stiff.cost.step, soft.cost.step / 10);
    EXPECT_LT(energy_error(stiff, 1e-3 * density * gravity), 0.02);
}

// Three blocks side by side, 1 m wide each.
RelaxationScene row() {
    RelaxationScene scene;
    for (int block = 0; block < 3; ++block) {
        scene.block.push_back({rectangle(block, 0, 1, 1), density});
    }
    scene.block.push_back(fixed_block(rectangle(0, -1, 3, 1)));
    scene.material = {joint(1e9, degrees(30))};
    return scene;
}

TEST(Bolts, AreCutWhereTheyCrossJoints) {
    const RelaxationScene scene = row();
    RelaxationBolt bolt{0, 0.5, {0, 2.5, 2, 1e8, 2e5, {}, {}, {}}};
    const std::vector<BoltSegment> whole = bolt_segments(scene, bolt, 0);
    ASSERT_EQ(whole.size(), 1U);
    EXPECT_EQ(whole[0].block, 0U);
    EXPECT_EQ(whole[0].other, 2U);
    EXPECT_DOUBLE_EQ(whole[0].stiffness, 1e8 / 2.5 / 2);
    EXPECT_DOUBLE_EQ(whole[0].capacity, 1e5);
    bolt.bar.free_length_at_joints = 0.2;
    const std::vector<BoltSegment> grouted = bolt_segments(scene, bolt, 0);
    ASSERT_EQ(grouted.size(), 2U);
    for (std::size_t index = 0; index < 2; ++index) {
        EXPECT_EQ(grouted[index].block, index);
        EXPECT_EQ(grouted[index].other, index + 1);
        EXPECT_NEAR(grouted[index].at.x(), static_cast<double>(index) + 0.9, 1e-12);
        EXPECT_NEAR(grouted[index].stiffness, 1e8 / 0.2 / 2, 1e-3);  // rounding of where the joint is
        EXPECT_DOUBLE_EQ(grouted[index].capacity, 1e5);
    }
    // 1 m from its head plate and grout hold 130 kN, 0.5 m from its end the grout 50 kN, each for 2 m of slope.
    bolt.bar.grout = Grout<double>{1e5, 3e4};
    bolt.bar.pretension = 6e4;
    const std::vector<BoltSegment> held = bolt_segments(scene, bolt, 0);
    EXPECT_DOUBLE_EQ(held[0].capacity, 6.5e4);
    EXPECT_DOUBLE_EQ(held[0].pretension, 3e4);
    EXPECT_DOUBLE_EQ(held[1].capacity, 2.5e4);
    EXPECT_DOUBLE_EQ(held[1].pretension, 2.5e4);
}

TEST(Bolts, OutsideTheBlocksAreRefused) {
    for (const RelaxationBolt& bolt :
         {RelaxationBolt{-1, 0.5, {0, 2.5, 1, 1e8, 1e5, {}, {}, {}}},    // head in the air
          RelaxationBolt{0, 0.5, {0, 4, 1, 1e8, 1e5, {}, {}, {}}},       // end in the air
          RelaxationBolt{0, 0.5, {0, 0.5, 1, 1e8, 1e5, {}, {}, {}}}}) {  // crosses no joint
        RelaxationScene scene = row();
        scene.bolt = bolt_segments(scene, bolt, 0);
        EXPECT_EQ(check_scene(scene).check, SceneCheck::bolt_outside_blocks);
    }
}

// A face from (0, 0) to (6, 12): at a height of 6 m it stands at 3 m.
TEST(Bolts, ARowOfOneIsTheSameSingleBolt) {
    const BoltBar bar{degrees(10), 8, 2, 1e8, 2e5, 1e4, {}, {}};
    Relaxation single;
    single.scene = RelaxationSlope{};
    std::get<RelaxationSlope>(single.scene).geometry.outline = {{0, 0}, {20, 0}, {20, 12}, {6, 12}};
    Relaxation rows = single;
    single.bolt = {{3, 6, bar}};
    rows.support = {{1, 6, 2, bar}};
    const std::vector<RelaxationBolt> one = all_bolts(rows);
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0].head_x, 3);
    EXPECT_EQ(one[0].head_y, 6);
    const RelaxationScene scene = row();
    const auto at_row = [&](RelaxationBolt bolt) {
        bolt.head_x = 0;  // on the face of the blocks there
        bolt.head_y = 0.5;
        bolt.bar.plunge = 0;
        bolt.bar.length = 2.5;
        return bolt_segments(scene, bolt, 0).at(0);
    };
    EXPECT_EQ(at_row(one[0]).stiffness, at_row(all_bolts(single).at(0)).stiffness);
    EXPECT_EQ(at_row(one[0]).pretension, at_row(all_bolts(single).at(0)).pretension);
    EXPECT_EQ(at_row(one[0]).capacity, at_row(all_bolts(single).at(0)).capacity);
    rows.support[0].rows = 4;  // the fourth would begin on the crest, the fifth above it
    EXPECT_EQ(all_bolts(rows).at(3).head_x, 6);
    rows.support[0].rows = 5;
    EXPECT_FALSE(std::isfinite(all_bolts(rows).at(4).head_x));
    EXPECT_EQ(bolt_segments(scene, all_bolts(rows).at(4), 4).at(0).block, static_cast<std::size_t>(-1));
}

}  // namespace
}  // namespace delabole
