#include "geometry/polyline.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace {

using delabole::length;
using delabole::Point;
using delabole::Polyline;
using delabole::resample;
using delabole::rms_distance;
using delabole::signed_distance;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// The profile left at Delabole, roughly: lower stepped face, bench, upper face, crest (metres).
Polyline rock_face() {
    return {{0, 0}, {25, 23}, {31, 23.5}, {47, 69}, {80, 69}};
}

Polyline reversed(Polyline line) {
    std::ranges::reverse(line);
    return line;
}

// Random chains of three to nine points in a box of 100 m, always the same ones.
template <class Function>
void for_random_chains(Function function) {
    std::mt19937 generator(1967);
    std::uniform_real_distribution<double> coordinate(-50, 50);
    std::uniform_int_distribution<int> vertices(3, 9);
    for (int repeat = 0; repeat < 200; ++repeat) {
        Polyline line(static_cast<std::size_t>(vertices(generator)));
        for (Point& vertex : line) {
            vertex = {coordinate(generator), coordinate(generator)};
        }
        function(line, Point{coordinate(generator), coordinate(generator)});
    }
}

TEST(PolylineLength, AddsSegments) {
    EXPECT_EQ(length({{0, 0}, {3, 4}}), 5);
    EXPECT_EQ(length({{0, 0}, {3, 4}, {3, 4}, {3, 16}}), 17);
}

TEST(PolylineLength, IsZeroBelowTwoPoints) {
    EXPECT_EQ(length({}), 0);
    EXPECT_EQ(length({{7, 7}}), 0);
}

TEST(SignedDistance, IsPositiveToTheLeftOfTheWalk) {
    const Polyline along_x = {{0, 0}, {10, 0}};
    EXPECT_EQ(signed_distance(along_x, {4, 3}), 3);
    EXPECT_EQ(signed_distance(along_x, {4, -3}), -3);
    EXPECT_EQ(signed_distance(reversed(along_x), {4, 3}), -3);
}

TEST(SignedDistance, BeyondAnEndIsMeasuredToTheEnd) {
    const Polyline along_x = {{0, 0}, {10, 0}};
    EXPECT_EQ(signed_distance(along_x, {13, 4}), 5);
    EXPECT_EQ(signed_distance(along_x, {-3, -4}), -5);
}

TEST(SignedDistance, IsZeroOnTheChain) {
    for (const Point& vertex : rock_face()) {
        EXPECT_EQ(signed_distance(rock_face(), vertex), 0);
    }
    EXPECT_EQ(signed_distance({{0, 0}, {10, 0}}, {5, 0}), 0);
}

// A right-angled corner, walked east then north: outside it the nearest point is the vertex of both segments, and a
// point beyond the corner can lie to the left of one segment's line and to the right of the other's.
TEST(SignedDistance, OutsideACornerHasTheSideOfTheCorner) {
    const Polyline corner = {{0, 0}, {10, 0}, {10, 10}};
    EXPECT_EQ(signed_distance(corner, {13, -4}), -5);
    EXPECT_EQ(signed_distance(corner, {14, -3}), -5);
    EXPECT_EQ(signed_distance(corner, {7, 4}), 3);
    const Polyline sharp = {{0, 0}, {10, 0}, {0, 1}};  // turns left by more than 90 degrees
    EXPECT_LT(signed_distance(sharp, {11, 0.5}), 0);
    EXPECT_LT(signed_distance(sharp, {11, -0.5}), 0);
    EXPECT_GT(signed_distance(sharp, {5, 0.25}), 0);
}

TEST(SignedDistance, IgnoresRepeatedPoints) {
    const Polyline repeated = {{0, 0}, {0, 0}, {10, 0}, {10, 0}, {10, 10}, {10, 10}};
    const Polyline plain = {{0, 0}, {10, 0}, {10, 10}};
    for (const Point& point : {Point{4, 3}, Point{13, -4}, Point{-1, 1}, Point{12, 12}}) {
        EXPECT_EQ(signed_distance(repeated, point), signed_distance(plain, point));
    }
}

TEST(SignedDistance, IsNaNWithoutASegment) {
    EXPECT_TRUE(std::isnan(signed_distance({}, {1, 1})));
    EXPECT_TRUE(std::isnan(signed_distance({{0, 0}}, {1, 1})));
    EXPECT_TRUE(std::isnan(signed_distance({{2, 3}, {2, 3}}, {1, 1})));
}

// No point of the chain may be nearer than the distance given, and one must be as near: compared with points so dense
// that the nearest of them is at most half a spacing s from the true foot, where sqrt(d2 + (s/2)2) - d <= s/2.
TEST(SignedDistance, AgreesWithTheNearestOfManyPoints) {
    for_random_chains([](const Polyline& line, const Point& point) {
        const double distance = std::abs(signed_distance(line, point));
        double nearest = std::numeric_limits<double>::infinity();
        const std::size_t count = 4000;
        for (const Point& sample : resample(line, count)) {
            nearest = std::min(nearest, (sample - point).norm());
        }
        // Up to nine vertices are cut off between samples, each by no more than a spacing.
        const double spacing = length(line) / static_cast<double>(count - 1);
        // Coordinates of 100 m carry round-off of some epsilon * 100 m.
        EXPECT_GE(nearest, distance - 1e3 * epsilon);
        EXPECT_LE(nearest, distance + spacing);
    });
}

TEST(SignedDistance, ChangesSignWhenTheWalkIsReversed) {
    for_random_chains([](const Polyline& line, const Point& point) {
        // The foot is found from the other end of each segment: a few roundings at 100 m.
        EXPECT_NEAR(signed_distance(reversed(line), point), -signed_distance(line, point), 1e3 * epsilon);
    });
}

TEST(SignedDistance, FollowsRotationShiftAndScale) {
    const Eigen::Rotation2Dd rotation(0.7);
    const Point shift(12, -31);
    constexpr double scale = 3.25;
    for_random_chains([&](const Polyline& line, const Point& point) {
        const auto moved = [&](const Point& original) -> Point { return scale * (rotation * original) + shift; };
        Polyline moved_line;
        for (const Point& vertex : line) {
            moved_line.push_back(moved(vertex));
        }
        // Coordinates reach 300 m after the move, and each carries a few roundings: 300 epsilon times a handful.
        EXPECT_NEAR(signed_distance(moved_line, moved(point)), scale * signed_distance(line, point), 3e3 * epsilon);
    });
}

TEST(Resample, KeepsTheEndsExactly) {
    for (const std::size_t count : {2U, 3U, 7U, 100U}) {
        const Polyline points = resample(rock_face(), count);
        ASSERT_EQ(points.size(), count);
        EXPECT_EQ(points.front(), rock_face().front());
        EXPECT_EQ(points.back(), rock_face().back());
    }
}

TEST(Resample, SpacesPointsEquallyAlongTheChain) {
    const Polyline points = resample({{0, 0}, {3, 0}, {3, 3}, {9, 3}}, 5);  // length 12, so every 3 m
    const Polyline expected = {{0, 0}, {3, 0}, {3, 3}, {6, 3}, {9, 3}};
    ASSERT_EQ(points.size(), expected.size());
    for (std::size_t index = 0; index < points.size(); ++index) {
        EXPECT_EQ(points[index], expected[index]) << index;
    }
}

TEST(Resample, StepsAlongASlopingSegmentAreEqual) {
    const Polyline line = {{0, 0}, {25, 23}};
    const Polyline points = resample(line, 11);
    const double step = length(line) / 10;
    for (std::size_t index = 1; index < points.size(); ++index) {
        // Differences of coordinates up to 25 m, each rounded once or twice.
        EXPECT_NEAR((points[index] - points[index - 1]).norm(), step, 100 * epsilon) << index;
    }
}

TEST(Resample, StaysOnTheChain) {
    for_random_chains([](const Polyline& line, const Point&) {
        for (const Point& point : resample(line, 33)) {
            EXPECT_NEAR(signed_distance(line, point), 0, 1e3 * epsilon);
        }
    });
}

TEST(Resample, PassesOverRepeatedPoints) {
    const Polyline points = resample({{0, 0}, {0, 0}, {2, 0}, {2, 0}, {4, 0}, {4, 0}}, 5);
    ASSERT_EQ(points.size(), 5U);
    for (std::size_t index = 0; index < points.size(); ++index) {
        EXPECT_EQ(points[index], Point(static_cast<double>(index), 0));
    }
}

TEST(Resample, IsEmptyWhereItHasNoMeaning) {
    EXPECT_TRUE(resample(rock_face(), 0).empty());
    EXPECT_TRUE(resample(rock_face(), 1).empty());
    EXPECT_TRUE(resample({}, 5).empty());
    EXPECT_TRUE(resample({{1, 1}}, 5).empty());
    EXPECT_TRUE(resample({{1, 1}, {1, 1}}, 5).empty());
}

TEST(RmsDistance, OfEqualStepsIsTheirDepthOverRootThree) {
    // The distance from the line through the inner corners rises and falls evenly between 0 and the depth of a step.
    const Polyline stairs = {{0, 0}, {3, 0}, {3, 4}, {6, 4}, {6, 8}};
    const double depth = 3.0 * 4 / 5;
    EXPECT_NEAR(rms_distance(stairs, stairs.front(), stairs.back()), depth / std::sqrt(3), 8 * epsilon);
    EXPECT_NEAR(rms_distance(reversed(stairs), stairs.front(), stairs.back()), depth / std::sqrt(3), 8 * epsilon);
}

TEST(RmsDistance, IsZeroOnTheLineAndWhereThereIsNone) {
    EXPECT_EQ(rms_distance(Polyline{{0, 0}, {1, 0}, {4, 0}}, {0, 0}, {4, 0}), 0);
    EXPECT_EQ(rms_distance(Polyline{}, {0, 0}, {4, 0}), 0);
    EXPECT_EQ(rms_distance(Polyline{{2, 3}}, {0, 0}, {4, 0}), 0);
    EXPECT_EQ(rms_distance(Polyline{{0, 0}, {1, 1}}, {2, 2}, {2, 2}), 0);
}

}  // namespace
