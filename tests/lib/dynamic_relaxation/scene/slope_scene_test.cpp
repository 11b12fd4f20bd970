#include "dynamic_relaxation/scene/slope_scene.hpp"

#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace delabole {
namespace {

using testing::cut;
using testing::joint_of_friction;
using testing::joint_set;
using testing::line;
using testing::square;

RelaxationSlope slope_of(std::vector<SectionPoint> outline, std::vector<SlopeCut> cuts) {
    RelaxationSlope slope{};
    slope.geometry = testing::section(std::move(outline), std::move(cuts));
    slope.rock = {{"slate", 2700}, {"gouge", 2000}};
    slope.joint = {{"joint", {}, joint_of_friction(30)},
                   {"intact", {}, joint_of_friction(60)},
                   {"base", {}, joint_of_friction(40)}};
    slope.geometry.intact_joint = "intact";
    return slope;
}

std::vector<SlopeCut> bricks() {
    return {cut("upright", joint_set(degrees(90), 2, 1)), cut("level", joint_set(0, 2, 1))};
}

TEST(SlopeScene, FrameHoldsTheSidesAsked) {
    RelaxationSlope slope = slope_of(square(6), bricks());
    slope.frame = SlopeFrame{FrameSides::below, 1, 4, "base"};
    const SlopeScene below = slope_scene(slope);
    slope.frame->sides = FrameSides::all_around;
    const SlopeScene around = slope_scene(slope);
    ASSERT_EQ(below.check, SlopeCheck::valid);
    EXPECT_EQ(around.block.size(), below.block.size() + 2);
    const auto last = below.block.back();
    EXPECT_TRUE(last.fixed);
    EXPECT_EQ(area_properties(last.outline).area, 14);
    // The lowest row stands on the joint of the frame, the others stand on their own joints.
    const RelaxationBlock& lowest = below.block.front();
    EXPECT_EQ(std::count(lowest.joint.begin(), lowest.joint.end(), 2U), 1);
    // The first block is the one in the corner.
    EXPECT_EQ(std::count(around.block.front().joint.begin(), around.block.front().joint.end(), 2U), 2);
    RelaxationStudy study{};
    study.model.scene = slope;
    EXPECT_EQ(check(study).check, SceneCheck::valid);
}

// A side off the upright by less than the snap distance is made upright: a gap before the frame would let blocks move.
TEST(SlopeScene, FrameTouchesASideThatIsNotQuiteUpright) {
    RelaxationSlope slope = slope_of({{0, 0}, {5.997, 0}, {6, 6}, {0, 6}}, bricks());
    slope.frame = SlopeFrame{FrameSides::below_and_behind, 1, {}, "base"};
    const SlopeScene near = slope_scene(slope);
    EXPECT_GT(near.section.snap_distance, 0.003);
    EXPECT_EQ(near.beside_frame, 0);
    slope.geometry.outline[1].x = 6;
    const SlopeScene upright = slope_scene(slope);
    ASSERT_EQ(near.block.size(), upright.block.size());
    for (std::size_t block = 0; block < near.block.size(); ++block) {
        EXPECT_EQ(near.block[block].outline, upright.block[block].outline);
    }
    // One that is farther off is told: the upper rows lean on the frame, the others on nothing.
    slope.geometry.outline[1].x = 5.9;
    slope.geometry.outline.insert(slope.geometry.outline.begin() + 2, {6, 3});
    EXPECT_NEAR(slope_scene(slope).beside_frame, std::hypot(0.1, 3), 1e-12);
}

TEST(SlopeScene, FrameNeedsAnEdge) {
    RelaxationSlope slope = slope_of({{0, 0}, {10, 1}, {10, 6}, {3, 6}}, bricks());
    slope.frame = SlopeFrame{FrameSides::below, 1, {}, "base"};
    EXPECT_EQ(slope_scene(slope).check, SlopeCheck::frame_without_edge);
}

TEST(SlopeScene, AreasFixAndRemoveTheirBlocks) {
    RelaxationSlope slope = slope_of(square(6), bricks());
    slope.fixed = {{{{-1, -1}, {7, -1}, {7, 1}, {-1, 1}}}};
    slope.stage = {{1.5, {{-1, 5}, {7, 5}, {7, 7}, {-1, 7}}}, {3, {{-1, 3}, {1, 3}, {1, 5}, {-1, 5}}}};
    const SlopeScene scene = slope_scene(slope);
    ASSERT_EQ(scene.check, SlopeCheck::valid);
    // The joints are at 1, 3 and 5 both ways: four rows of four.
    ASSERT_EQ(scene.block.size(), 16U);
    for (std::size_t block = 0; block < 16; ++block) {
        EXPECT_EQ(scene.block[block].fixed, block >= 12) << "fixed blocks are counted last";
    }
    EXPECT_EQ(std::count_if(scene.removal.begin(), scene.removal.end(),
                            [](const Removal& removal) { return removal.time == 1.5; }),
              4);
    EXPECT_EQ(scene.removal.size(), 5U);
    slope.stage[1].vertex = {{20, 3}, {21, 3}, {21, 5}};
    EXPECT_EQ(slope_scene(slope).check, SlopeCheck::area_without_block);
}

TEST(SlopeScene, CornersOfNeighboursAreNoCornersOfABlock) {
    JointSetCut cross = joint_set(0, 2);
    cross.staggered_by = "upright";
    cross.stagger_share = 0.5;
    const SlopeScene scene =
        slope_scene(slope_of(square(6), {cut("upright", joint_set(degrees(90), 2)), cut("cross", cross)}));
    for (const RelaxationBlock& block : scene.block) {
        EXPECT_EQ(block.outline.size(), 4U);
    }
}

TEST(SlopeScene, DividedRockNeedsAJoint) {
    RelaxationSlope slope = slope_of({{0, 0}, {10, 0}, {10, 6}, {6, 6}, {6, 3}, {0, 3}}, {});
    EXPECT_EQ(slope_scene(slope).check, SlopeCheck::valid);
    slope.geometry.intact_joint.reset();
    EXPECT_EQ(slope_scene(slope).check, SlopeCheck::intact_joint_missing);
}

RelaxationStudy daylighting_slope(double friction) {
    // Joints at 40 deg that daylight in a face of 60 deg, cut up by steep ones.
    RelaxationSlope slope =
        slope_of({{0, 0}, {14, 0}, {14, 8}, {4.6, 8}},
                 {cut("sliding", joint_set(degrees(40), 2, -0.5)), cut("steep", joint_set(degrees(-80), 3))});
    slope.joint[0].strength = joint_of_friction(friction);
    slope.frame = SlopeFrame{FrameSides::below_and_behind, 1, 5, "base"};
    RelaxationStudy study{};
    study.model.scene = slope;
    RelaxationNumerics settings{};
    settings.stiffness_ratio = 1e5;
    settings.stop = RelaxationStop::onset;
    settings.duration = 5;
    study.settings = settings;
    return study;
}

TEST(SlopeScene, SlopeSlidesWhereItsJointsAreSteeperThanTheirFriction) {
    EXPECT_EQ(run(daylighting_slope(30)).result.outcome, RelaxationOutcome::onset);
    EXPECT_EQ(run(daylighting_slope(50)).result.outcome, RelaxationOutcome::equilibrium);
}

TEST(SlopeScene, JointThatComesOutOfAFaceAtAnAcuteAngleHoldsByFrictionAlone) {
    // A joint at 50 deg below the edge of a face at 60 deg: where it comes out, the corners of both blocks coincide,
    // and none may catch on the other block's face.
    for (const double friction : {49.9, 50.1}) {
        for (const double ratio : {1e5, 1e7}) {
            const PlanePoint<> up_dip(std::cos(degrees(50)), std::sin(degrees(50)));
            RelaxationSlope slope = slope_of({{0, 0}, {14, 0}, {14, 8}, {4.6, 8}},
                                             {cut("joint", line({{1.5 - up_dip.x(), 2.6 - up_dip.y()},
                                                                 {1.5 + 10 * up_dip.x(), 2.6 + 10 * up_dip.y()}}))});
            slope.joint[0].strength = joint_of_friction(friction);
            slope.frame = SlopeFrame{FrameSides::below_and_behind, 1, 5, "base"};
            RelaxationStudy study{};
            study.model.scene = slope;
            RelaxationNumerics settings{};
            settings.stiffness_ratio = ratio;
            settings.stop = RelaxationStop::onset;
            settings.duration = 5;
            study.settings = settings;
            EXPECT_EQ(run(study).result.outcome,
                      friction < 50 ? RelaxationOutcome::onset : RelaxationOutcome::equilibrium)
                << friction << ' ' << ratio;
        }
    }
}

TEST(SlopeScene, ExcavationOfTheToeLetsTheSlopeDown) {
    // A block before the foot of a sliding mass holds it by its weight and friction until it is taken away.
    RelaxationStudy study = daylighting_slope(30);
    auto& slope = std::get<RelaxationSlope>(study.model.scene);
    slope.geometry.outline = {{-6, 0}, {14, 0}, {14, 8}, {-6, 8}};
    slope.frame->sides = FrameSides::all_around;
    const RelaxationOutcome before = run(study).result.outcome;
    EXPECT_EQ(before, RelaxationOutcome::equilibrium);
    slope.stage = {{0.2, {{-7, -1}, {0, 0}, {4.6, 8}, {4.6, 9}, {-7, 9}}}};
    study.settings->stop = RelaxationStop::collapse;
    study.settings->collapse_displacement = 0.02;
    EXPECT_EQ(run(study).result.outcome, RelaxationOutcome::collapse);
}

TEST(SlopeScene, PredictionsOfOtherSpacingsHaveTheSameOutputs) {
    const RelaxationStudy study = daylighting_slope(50);
    const ModelInterface model = model_interface(study);
    const auto spacing = std::find_if(model.inputs.begin(), model.inputs.end(),
                                      [](const Quantity& input) { return input.name == "scene.cut[1].trace.spacing"; });
    ASSERT_NE(spacing, model.inputs.end());
    const auto index = static_cast<std::size_t>(spacing - model.inputs.begin());
    const Prediction coarse = model.predict(std::vector<Assignment>{{index, 4.0}});
    const Prediction fine = model.predict(std::vector<Assignment>{{index, 2.0}});
    EXPECT_EQ(coarse.failure, "");
    EXPECT_EQ(coarse.outputs.size(), model.outputs.size());
    EXPECT_EQ(fine.outputs.size(), model.outputs.size());
    EXPECT_GT(length(coarse.profile), 0);
}

TEST(SlopeScene, DurationIsAnAnswerWhereItWasAskedFor) {
    RelaxationStudy study = daylighting_slope(10);
    study.settings->stop = RelaxationStop::equilibrium;
    study.settings->onset_slide = 1e3;
    study.settings->collapse_displacement = 1e3;
    study.settings->duration = 0.3;
    EXPECT_TRUE(run(study).unfinished());
    EXPECT_EQ(model_interface(study).predict({}).failure, "undecided");
    study.settings->stop = RelaxationStop::duration;
    const RelaxationRun made = run(study);
    EXPECT_EQ(made.result.outcome, RelaxationOutcome::undecided);
    EXPECT_FALSE(made.unfinished());
    EXPECT_EQ(model_interface(study).predict({}).failure, "");
    study = daylighting_slope(70);
    study.settings->stop = RelaxationStop::duration;
    EXPECT_EQ(run(study).result.outcome, RelaxationOutcome::equilibrium);
}

TEST(SlopeScene, ThatCannotBeCutHasNoBlocksAndNoBonds) {
    RelaxationStudy study{};
    RelaxationSlope slope = slope_of(square(6), bricks());
    slope.joint[0].strength.bond = BondMaterial{1e9, 4e8, 1e5, 1e5, degrees(30), {}};
    slope.geometry.cut[0].joint = "no such joint";
    study.model.scene = slope;
    EXPECT_EQ(number_of_blocks(study), 0U);
    const RelaxationScene scene = relaxation_scene(study);
    EXPECT_TRUE(scene.block.empty());
    EXPECT_TRUE(scene.bond.empty());
    EXPECT_FALSE(model_interface(study).outputs.empty());
}

TEST(RelaxationScene, BlocksAreCountedWithoutTheirScene) {
    const auto expect_counted = [](auto kind) {
        RelaxationStudy study{};
        study.model.scene = std::move(kind);
        EXPECT_GT(number_of_blocks(study), 0U);
        EXPECT_EQ(number_of_blocks(study), relaxation_scene(study).block.size());
    };
    RelaxationRow row{};
    row.block = {{1, 3, {}}, {1, 4, {}}};
    expect_counted(row);
    RelaxationColumns columns{};
    columns.block = {{1, 3, 1, {}}, {1, 4, 1, {}}};
    expect_counted(columns);
    RelaxationPolygons polygons{};
    polygons.block.resize(3);
    expect_counted(polygons);
    expect_counted(slope_of(square(6), bricks()));
}

}  // namespace
}  // namespace delabole
