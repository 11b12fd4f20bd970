// Tests what has failed and what is left standing, for a slope whose blocks are placed by the test.
#include "dynamic_relaxation/study/post_failure.hpp"

#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace delabole {
namespace {

using testing::joint_set;

constexpr double fallen = 50;  // m, a block of 1 m that has gone by so much has failed but for 1e-9

RelaxationStudy study_of(std::vector<SectionPoint> outline, double spacing, double friction) {
    RelaxationSlope slope{};
    slope.geometry = testing::section(std::move(outline), {{"upright", "upright", joint_set(degrees(90), spacing)},
                                                           {"level", "level", joint_set(0, spacing)}});
    slope.rock = {{"slate", 2700}};
    RelaxationJoint joint{};
    joint.friction_angle = friction;
    slope.joint = {{"upright", {}, joint}, {"level", {}, joint}};
    slope.frame = SlopeFrame{FrameSides::below_and_behind, 1, {}, "level"};
    RelaxationStudy study{};
    study.model.scene = slope;
    return study;
}

// The wall is 10 m long and 6 m high, with an upright face, in blocks of 1 m.
class Wall : public ::testing::Test {
  protected:
    explicit Wall(double scale = 1)
        : scene(relaxation_scene(
              study_of({{0, 0}, {10 * scale, 0}, {10 * scale, 6 * scale}, {0, 6 * scale}}, scale, degrees(30)))),
          bodies(make_bodies(scene)),
          start(bodies.size()),
          now(bodies.size()),
          removed(bodies.size(), 0) {}

    // Moves the blocks whose centre is in the rectangle.
    void move(double left, double bottom, double right, double top, const std::function<void(std::size_t)>& change) {
        for (std::size_t block = 0; block < bodies.size(); ++block) {
            const PlanePoint<>& centre = bodies.centroid[block];
            if (bodies.fixed[block] == 0 && centre.x() > left && centre.x() < right && centre.y() > bottom &&
                centre.y() < top) {
                change(block);
            }
        }
    }
    void shift(double left, double bottom, double right, double top, double x, double y) {
        move(left, bottom, right, top, [&](std::size_t block) {
            now[block].x += x;
            now[block].y += y;
        });
    }
    PostFailure survey(const PostFailureRequest& request = {}) const {
        return post_failure({bodies, start, now, removed, joints}, request);
    }
    static double level_at(const Polyline& line, double x) {
        return std::find_if(line.begin(), line.end(), [&](const Point& point) { return point.x() > x; })->y();
    }

    RelaxationScene scene;
    Bodies bodies;
    std::vector<Motion> start;
    std::vector<Motion> now;
    std::vector<char> removed;
    std::vector<std::string> joints = {"upright", "level"};
};

class LargeWall : public Wall {
  protected:
    LargeWall() : Wall(4) {}
};

// The ground is sampled at a thousand places along it.
constexpr double station = 10.0 / 1000;
constexpr double rounding = 1e-9;

TEST_F(Wall, HasNotFailedAtFirst) {
    const PostFailure found = survey();
    EXPECT_EQ(found.answer.failed_area, 0);
    EXPECT_EQ(found.answer.failed_width, 0);
    EXPECT_TRUE(found.crack.empty());
    EXPECT_EQ(found.answer.near_face.horizontal, 0);
    EXPECT_EQ(found.answer.backward_rotation, 0);
    EXPECT_NEAR(found.crest.x(), 0, rounding);
    EXPECT_NEAR(found.crest.y(), 6, rounding);
    EXPECT_EQ(found.ground, found.left_standing);
    EXPECT_NEAR(found.answer.top_level, 6, rounding);
    for (const CrestJoint& joint : found.answer.joint) {
        EXPECT_EQ(joint.open, 0);
        EXPECT_EQ(joint.farthest, 0);
    }
}

TEST_F(Wall, LeavesAStepWhereBlocksHaveFallen) {
    shift(0, 2, 3, 6, -fallen, -fallen);
    const PostFailure found = survey();
    EXPECT_NEAR(found.answer.failed_area, 12, 1e-6);
    EXPECT_NEAR(found.answer.failed_width, 3, station);
    EXPECT_NEAR(level_at(found.left_standing, 1.5), 2, 1e-6);
    EXPECT_NEAR(level_at(found.left_standing, 4.5), 6, rounding);
    EXPECT_NEAR(found.answer.foot_level, 2, 1e-6);
    EXPECT_NEAR(found.answer.knee_level, 2, 1e-6);
    EXPECT_NEAR(found.answer.top_level, 6, rounding);
    EXPECT_NEAR(found.answer.lower_angle, 0, 1e-6);
    // The ground rises by four metres within one station.
    EXPECT_NEAR(found.answer.upper_angle, std::atan2(4, station), 1e-3);
}

// The steps are one block each: 45 deg from the toe up to 3 m, upright above.
TEST_F(Wall, LowerSurfaceIsThatOfItsSteps) {
    for (int step = 0; step < 3; ++step) {
        shift(step, step, step + 1, 6, -fallen, -fallen);
    }
    const PostFailure found = survey();
    EXPECT_NEAR(found.answer.failed_area, 6 + 5 + 4, 1e-6);
    EXPECT_NEAR(found.answer.foot_level, 0, 1e-6);
    EXPECT_NEAR(found.answer.knee_level, 2, 1e-6);
    // The surface goes from (0, 0) to the inner end of the third step, (3, 2).
    EXPECT_NEAR(found.answer.lower_angle, std::atan2(2, 3), 0.01);
    EXPECT_GT(found.answer.upper_angle, degrees(80));
    // From the line through (0, 0) and (3, 2) the corners in between lie, in units of 1 / sqrt(13), at -2, 1, -1 and 2.
    const auto end_to_end = [](double from, double to) { return (from * from + from * to + to * to) / 3; };
    const double squares =
        end_to_end(0, -2) + end_to_end(-2, 1) + end_to_end(1, -1) + end_to_end(-1, 2) + end_to_end(2, 0);
    // The corners lie up to a station off.
    EXPECT_NEAR(found.answer.lower_roughness, std::sqrt(squares / 5 / 13), 2 * station);
    EXPECT_NEAR(found.answer.upper_roughness, 0, station);
}

// The upper surface leaves one upright joint for the next, the lower one is a plane.
TEST_F(Wall, UpperSurfaceOfTwoJointsIsRough) {
    shift(0, 1, 5, 6, -fallen, -fallen);
    shift(5, 4, 6, 6, -fallen, -fallen);
    const PostFailure found = survey();
    EXPECT_NEAR(found.answer.knee_level, 1, 1e-6);
    EXPECT_NEAR(found.answer.lower_roughness, 0, station);
    // From the line through (5, 1) and (6, 6), in units of 1 / sqrt(26): 3 m up to 3, 1 m back to -2, 2 m up to 0.
    const double squares = 3 * 9.0 / 3 + 1 * (9.0 - 6 + 4) / 3 + 2 * 4.0 / 3;
    EXPECT_NEAR(found.answer.upper_roughness, std::sqrt(squares / 6 / 26), 2 * station);
}

// A rectangle that turns about a corner has a quarter of its kinetic energy in rotation; one that slides has none.
TEST_F(Wall, ToldByEnergyBlocksTurnOrSlide) {
    shift(0, 5, 1, 6, -0.01, 0);
    EXPECT_EQ(survey().answer.rotation_share, 0);
    now = start;
    const double turn = 1e-4;
    move(0, 5, 1, 6, [&](std::size_t block) {
        now[block].set_angle(turn);
        // The centre lies half a metre behind and above the corner.
        now[block].x = -turn / 2;
        now[block].y = turn / 2;
    });
    EXPECT_NEAR(survey().answer.rotation_share, 0.25, rounding);
}

TEST_F(Wall, NamesAndMeasuresCracks) {
    shift(0, 0, 2, 6, -0.07, 0);
    shift(2, 0, 4, 6, -0.02, -0.03);
    move(2, 5, 4, 6, [&](std::size_t block) { now[block].set_angle(-0.004); });
    const PostFailure found = survey();
    ASSERT_EQ(found.crack.size(), 2U);
    EXPECT_NEAR(found.crack[0].position, 2, rounding);
    // Turned clockwise by 0.004 the upper corner moves away from the slope by half that.
    EXPECT_NEAR(found.crack[0].opening, 0.05 + 0.002, 2e-4);
    EXPECT_NEAR(found.crack[1].position, 4, rounding);
    EXPECT_NEAR(found.crack[1].opening, 0.02 - 0.002, 2e-4);
    EXPECT_NEAR(std::abs(found.crack[0].dip), degrees(90), 1e-9);
    EXPECT_EQ(found.answer.joint[0].joint, "upright");
    // The joint counts its openings of 5.2 and 1.8 limits by their shares.
    EXPECT_NEAR(found.answer.joint[0].open, 2, 0.1);
    EXPECT_NEAR(found.answer.joint[0].opening, 0.07, 1e-3);
    EXPECT_NEAR(found.answer.joint[0].farthest, 4, rounding);
    EXPECT_EQ(found.answer.joint[1].open, 0);
    EXPECT_NEAR(found.answer.near_face.horizontal, -0.07, rounding);
    EXPECT_NEAR(found.answer.between_cracks.horizontal, -0.02, rounding);
    EXPECT_NEAR(found.answer.between_cracks.vertical, -0.03, rounding);
    EXPECT_NEAR(found.answer.between_cracks.rotation, -0.004, rounding);
    EXPECT_NEAR(found.answer.backward_rotation, 0.004, rounding);
    // Nothing has moved far enough to count as failed: these are the shares of 0.07 and 0.036 m at a limit of 0.25.
    EXPECT_LT(found.answer.failed_area, 12 * std::pow(0.07 / 0.25, 4) + 12 * std::pow(0.04 / 0.25, 4));
}

TEST_F(Wall, FailsSmoothly) {
    double before = 0;
    for (int step = 1; step <= 100; ++step) {
        shift(0, 3, 1, 6, -0.01, 0);
        const double area = survey().answer.failed_area;
        EXPECT_GT(area, before);
        // The share rises by at most (4 / limit) (3/5)^(3/4) (5/8)^2, about 4.3 per metre, of 3 m2.
        EXPECT_LT(area - before, 3 * 4.5 * 0.01);
        before = area;
    }
    EXPECT_NEAR(before, 3, 3 * 0.005);  // share of four limits
    PostFailureRequest twice{};
    twice.moved_share = 1;
    EXPECT_NEAR(survey(twice).answer.failed_area, 1.5, 1e-6);  // the displacement is at the limit
}

TEST_F(Wall, ExcavationIsNoFailure) {
    move(0, 4, 2, 6, [&](std::size_t block) { removed[block] = 1; });
    shift(0, 4, 2, 6, -fallen, -fallen);
    const PostFailure found = survey();
    EXPECT_EQ(found.answer.failed_area, 0);
    EXPECT_NEAR(level_at(found.ground, 1), 4, rounding);
    EXPECT_TRUE(found.crack.empty());
}

TEST_F(LargeWall, MeasuresInItsOwnSize) {
    shift(0, 8, 12, 24, -1, 0);
    const PostFailure found = survey();
    // The displacement is a quarter of a block of 4 m: its share is one half.
    EXPECT_NEAR(found.answer.failed_area, 12 * 16 / 2.0, 1e-9);
    ASSERT_EQ(found.crack.size(), 1U);
    EXPECT_NEAR(found.crack[0].position, 12, rounding);
    EXPECT_NEAR(found.crack[0].opening, 1, rounding);
}

// A run and the loops over models get the same numbers.
TEST(PostFailure, IsAmongTheNamedNumbersOfASlope) {
    // Tilted by more than its friction angle the wall slides out over its level joints.
    RelaxationStudy study = study_of({{0, 0}, {4, 0}, {4, 2}, {0, 2}}, 1, degrees(20));
    std::get<RelaxationSlope>(study.model.scene).tilt = degrees(25);
    RelaxationNumerics numerics{};
    numerics.quality = RelaxationQuality::draft;
    numerics.start = RelaxationStart::ramped;
    numerics.stop = RelaxationStop::collapse;
    study.settings = numerics;
    const RelaxationRun made = run(study);
    ASSERT_EQ(made.result.outcome, RelaxationOutcome::collapse);
    ASSERT_TRUE(made.post_failure.has_value());
    EXPECT_GT(made.post_failure->answer.failed_area, 1);
    EXPECT_LT(made.post_failure->answer.near_face.horizontal, 0);
    const ModelInterface model = model_interface(study);
    const auto named = std::ranges::find(model.outputs, "post_failure.failed_area", &Quantity::name);
    ASSERT_NE(named, model.outputs.end());
    const Prediction prediction = model.predict({});
    ASSERT_EQ(prediction.outputs.size(), model.outputs.size());
    EXPECT_EQ(prediction.outputs[static_cast<std::size_t>(named - model.outputs.begin())],
              made.post_failure->answer.failed_area);
    EXPECT_EQ(prediction.profile, made.post_failure->left_standing);
}

}  // namespace
}  // namespace delabole
