// Corners that meet corners: nothing is held that cannot be, and nothing falls that is held.
#include "dynamic_relaxation/corner_choice.hpp"

#include "dynamic_relaxation/relaxation_study.hpp"
#include "relaxation_scenes.hpp"
#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

using namespace relaxation_scenes;

PlanePoint<> at(double angle, double distance) {
    return distance * PlanePoint<>(std::cos(degrees(angle)), std::sin(degrees(angle)));
}

// A face of 60 deg, 12 m high, and a plane that comes out at its toe.
RelaxationStudy toe(const SlopeCut& plane, double friction, std::vector<SectionPoint> in_front) {
    RelaxationSlope slope{};
    std::vector<SectionPoint> outline{{-15, -8}, {35, -8}, {35, 12}, {12 / std::tan(degrees(60)), 12}, {0, 0}};
    outline.insert(outline.end(), in_front.begin(), in_front.end());
    slope.geometry = testing::section(std::move(outline), {plane});
    slope.geometry.intact_joint = "intact";
    slope.rock = {{"rock", 2600}};
    RelaxationJoint open{};
    open.friction_angle = friction;
    RelaxationJoint intact{};
    intact.friction_angle = degrees(45);
    intact.bond = RelaxationBond{20e9, 8e9, 5e6, 5e6, degrees(45), {}};
    slope.joint = {{"joint", {}, open}, {"intact", {}, intact}};
    slope.frame = SlopeFrame{FrameSides::all_around, 5, {}, "joint"};
    RelaxationStudy study{};
    study.model.scene = slope;
    RelaxationNumerics settings{};
    settings.stop = RelaxationStop::onset;
    study.settings = settings;
    return study;
}

SlopeCut plane_from(double dip, double begin) {
    const PlanePoint<> from = at(dip, begin);
    const PlanePoint<> to = at(dip, 60);
    return testing::cut("plane", testing::line({{from.x(), from.y()}, {to.x(), to.y()}}));
}

SlopeCut plane_through(double dip, SectionPoint point) {
    JointSetCut set = testing::joint_set(degrees(dip), 100);
    set.through = point;
    return testing::cut("plane", set);
}

// tan(friction) at which the wedge above the plane moves: with its tip over the level ground and the upper end of its
// base down the plane, for the toe cannot go down into the ground in front. Equilibrium of forces and, about the toe,
// moments of a rigid block.
double limit(double dip) {
    const double base = 12 / std::sin(degrees(dip));
    const double centroid = 12 * (1 / std::tan(degrees(dip)) + 1 / std::tan(degrees(60))) / 3;
    const double above = centroid / base;  // normal force on the plane, of the weight
    double low = 0;
    double high = 2;
    for (int halving = 0; halving < 60; ++halving) {
        const double friction = (low + high) / 2;
        const double toe = 1 - above * (std::cos(degrees(dip)) + friction * std::sin(degrees(dip)));
        const double driving = above * (std::sin(degrees(dip)) - friction * std::cos(degrees(dip)));
        (driving > friction * toe ? low : high) = friction;
    }
    return std::atan(low);
}

TEST(Toe, SlidesAndStandsTheSameHoweverItsPlaneIsDrawn) {
    for (const double dip : {20.0, 35.0, 50.0}) {
        const std::vector<std::pair<std::string, SlopeCut>> drawings{
            {"from the toe", plane_from(dip, 0)},
            {"on below the ground", plane_from(dip, -8)},
            {"through the section", plane_from(dip, -40)},
            {"a set", plane_through(dip, {0, 0})},
            {"a set by another point", plane_through(dip, {2, 2 * std::tan(degrees(dip))})}};
        for (const auto& [name, plane] : drawings) {
            // deg; what joints of finite stiffness cost is 0.03.
            for (const double beyond : {-3.0, -0.1, 0.1, 3.0}) {
                EXPECT_EQ(run(toe(plane, limit(dip) + degrees(beyond), {{-15, 0}})).result.outcome,
                          beyond > 0 ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset)
                    << name << ", " << dip << ", " << beyond;
            }
        }
    }
}

TEST(Toe, SlidesHoweverItIsLoaded) {
    for (const RelaxationStart start :
         {RelaxationStart::preloaded, RelaxationStart::dropped, RelaxationStart::ramped}) {
        for (const double begin : {0.0, -40.0}) {
            RelaxationStudy study = toe(plane_from(35, begin), degrees(10), {{-15, 0}});
            study.settings->start = start;
            if (start == RelaxationStart::ramped) {
                study.settings->ramp_time = 0.2;
            }
            EXPECT_EQ(run(study).result.outcome, RelaxationOutcome::onset) << begin << ", " << word_of(start);
        }
    }
}

// Where the plane comes out in the face, above the toe, nothing is in its way.
TEST(Toe, AboveTheGroundHoldsByFrictionAlone) {
    for (const double beyond : {-0.1, 0.1}) {
        EXPECT_EQ(run(toe(plane_through(35, {0, 0.2}), degrees(35 + beyond), {{-15, 0}})).result.outcome,
                  beyond > 0 ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset);
    }
}

TEST(Toe, AgainstAWallIsHeld) {
    for (const double begin : {0.0, -8.0}) {
        EXPECT_EQ(run(toe(plane_from(35, begin), degrees(10), {{0, 6}, {-15, 6}})).result.outcome,
                  RelaxationOutcome::equilibrium)
            << begin;
    }
}

}  // namespace
}  // namespace delabole
