#include "geometry/polygon.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_dec_float.hpp>

#include <cmath>
#include <limits>
#include <random>

namespace {

using delabole::area_properties;
using delabole::AreaProperties;
using delabole::clip;
using delabole::crosses_itself;
using delabole::HalfPlane;
using delabole::PlanePoint;
using delabole::Polygon;
using delabole::split;
using delabole::SplitPolygon;
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

// Star-shaped polygons around a centre, anticlockwise, not convex in general.
template <class Function>
void for_random_polygons(Function function) {
    std::mt19937 generator(41);
    std::uniform_real_distribution<double> coordinate(-20, 20);
    std::uniform_real_distribution<double> radius(0.5, 12);
    std::uniform_int_distribution<int> vertices(3, 11);
    for (int repeat = 0; repeat < 500; ++repeat) {
        const int count = vertices(generator);
        const PlanePoint<> centre(coordinate(generator), coordinate(generator));
        Polygon<> polygon;
        for (int index = 0; index < count; ++index) {
            const double angle = 6.283185307179586 * index / count;
            const double distance = radius(generator);
            polygon.emplace_back(centre.x() + distance * std::cos(angle), centre.y() + distance * std::sin(angle));
        }
        function(polygon, HalfPlane<>{{coordinate(generator), coordinate(generator)},
                                      {coordinate(generator), coordinate(generator)}});
    }
}

TEST(AreaProperties, OfARectangle) {
    const AreaProperties<> section = area_properties<double>({{2, 1}, {8, 1}, {8, 5}, {2, 5}});
    EXPECT_EQ(section.area, 24);
    EXPECT_EQ(section.centroid, PlanePoint<>(5, 3));
    EXPECT_EQ(section.polar_second_moment, 24 * (36 + 16) / 12.0);
}

TEST(AreaProperties, ChangeSignWithTheSenseOfTheWalk) {
    const AreaProperties<> section = area_properties<double>({{2, 5}, {8, 5}, {8, 1}, {2, 1}});
    EXPECT_EQ(section.area, -24);
    EXPECT_EQ(section.centroid, PlanePoint<>(5, 3));
    EXPECT_EQ(section.polar_second_moment, -24 * (36 + 16) / 12.0);
}

TEST(AreaProperties, WithoutAreaTheCentroidIsTheMeanOfTheVertices) {
    const AreaProperties<> line = area_properties<double>({{1, 1}, {2, 2}, {6, 6}});
    EXPECT_EQ(line.area, 0);
    EXPECT_EQ(line.centroid, PlanePoint<>(3, 3));
    EXPECT_EQ(area_properties<double>({}).area, 0);
}

// A sliver of one micrometre a kilometre away: its vertices are rounded to 1e-13 m, the width to 1e-7 of itself.
TEST(AreaProperties, OfASliverFarAway) {
    const AreaProperties<> sliver = area_properties<double>({{1000, 1000}, {1010, 1000}, {1010, 1000 + 1e-6}});
    EXPECT_NEAR(sliver.area, 5e-6, 5e-6 * 1e-6);
    EXPECT_NEAR(sliver.centroid.x(), 1000 + 20.0 / 3, 1e-12);
}

TEST(AreaProperties, AgreeWithFiftyDigits) {
    for_random_polygons([](const Polygon<>& polygon, const HalfPlane<>&) {
        Polygon<Wide> wide;
        for (const PlanePoint<>& point : polygon) {
            wide.emplace_back(Wide(point.x()), Wide(point.y()));
        }
        const AreaProperties<> section = area_properties(polygon);
        const AreaProperties<Wide> exact = area_properties(wide);
        // Eleven terms of up to 24 m squared, some cancelling, each rounded a few times.
        EXPECT_NEAR(section.area, static_cast<double>(exact.area), 1e4 * epsilon);
        EXPECT_NEAR(section.polar_second_moment, static_cast<double>(exact.polar_second_moment), 1e7 * epsilon);
        EXPECT_NEAR(section.centroid.y() * section.area, static_cast<double>(Wide(exact.centroid.y() * exact.area)),
                    1e6 * epsilon);
    });
}

// What is cut apart must add up: area, first moment and, by the parallel axis theorem, second moment.
TEST(Split, LosesNothing) {
    int cut = 0;
    for_random_polygons([&](const Polygon<>& polygon, const HalfPlane<>& line) {
        const SplitPolygon<> parts = split(polygon, line);
        const AreaProperties<> whole = area_properties(polygon);
        const AreaProperties<> left = area_properties(parts.left);
        const AreaProperties<> right = area_properties(parts.right);
        EXPECT_GE(left.area, 0);
        EXPECT_GE(right.area, 0);
        cut += left.area > 0 && right.area > 0 ? 1 : 0;
        EXPECT_NEAR(left.area + right.area, whole.area, 1e4 * epsilon);  // as in the comparison with fifty digits
        const PlanePoint<> moment = left.area * left.centroid + right.area * right.centroid;
        EXPECT_NEAR((moment - whole.area * whole.centroid).norm(), 0, 1e6 * epsilon);
        const auto about_whole = [&](const AreaProperties<>& part) {
            return part.polar_second_moment + part.area * (part.centroid - whole.centroid).squaredNorm();
        };
        EXPECT_NEAR(about_whole(left) + about_whole(right), whole.polar_second_moment, 1e7 * epsilon);
    });
    EXPECT_GT(cut, 100);  // the lines do meet the polygons
}

TEST(Split, LineThroughVerticesGivesThemToBothParts) {
    const SplitPolygon<> parts = split<double>({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, {{0, 0}, {2, 2}});
    EXPECT_EQ(area_properties(parts.left).area, 2);
    EXPECT_EQ(area_properties(parts.right).area, 2);
    EXPECT_EQ(parts.left.size(), 3U);
    EXPECT_EQ(parts.right.size(), 3U);
}

TEST(CrossesItself, WhereEdgesCrossButNotWhereTheyTouch) {
    EXPECT_TRUE(crosses_itself({{0, 0}, {2, 2}, {2, 0}, {0, 2}}));
    EXPECT_TRUE(crosses_itself({{0, 1}, {-0.6, -0.8}, {1, 0.3}, {-1, 0.3}, {0.6, -0.8}}));
    EXPECT_FALSE(crosses_itself({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 0}})) << "closed";
    EXPECT_FALSE(crosses_itself({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}})) << "an hourglass";
    EXPECT_FALSE(crosses_itself({{0, 0}, {1, 0.2}, {2, 0}, {1, 2}})) << "a dart";
    EXPECT_FALSE(crosses_itself({}));
}

TEST(Clip, TouchingLineLeavesNothingOrAll) {
    const Polygon<> square = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    EXPECT_TRUE(clip<double>(square, {{0, 5}, {0, 0}}).size() == 4U);
    EXPECT_TRUE(clip<double>(square, {{0, 0}, {0, 5}}).empty());
    EXPECT_TRUE(clip<double>({}, {{0, 0}, {0, 5}}).empty());
}

}  // namespace
