#include "kinematics/orientation.hpp"
#include "kinematics/joint_set.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace delabole {
namespace {

// A few roundings of angles up to 2 pi.
constexpr double rounding = 1e-14;

void expect_direction(const Direction& actual, const Direction& expected) {
    EXPECT_NEAR((actual - expected).norm(), 0, rounding);
}

TEST(Orientation, DirectionsByHand) {
    const double half = std::sqrt(0.5);
    // The plane dips 45 deg to the east: its normal leans east, the dip vector goes east and down.
    expect_direction(upward_normal({degrees(45), degrees(90)}), {half, 0, half});
    expect_direction(dip_vector({degrees(45), degrees(90)}), {half, 0, -half});
    // One plane is vertical and dips north, the other is level.
    expect_direction(upward_normal({degrees(90), 0}), {0, 1, 0});
    expect_direction(upward_normal({0, degrees(77)}), {0, 0, 1});
    // The line plunges 30 deg towards 210.
    expect_direction(direction_of({degrees(30), degrees(210)}), {-std::sqrt(3) / 4, -0.75, -0.5});
}

TEST(Orientation, ComesBackFromItsNormalAndItsLine) {
    for (int dip = 1; dip <= 90; ++dip) {
        for (int azimuth = 0; azimuth < 360; azimuth += 7) {
            const Orientation plane{degrees(dip), degrees(azimuth)};
            const Orientation back = plane_with_normal(3 * upward_normal(plane));
            EXPECT_NEAR(back.dip, plane.dip, rounding);
            // The normal of a vertical plane has no upper end.
            if (dip < 90) {
                EXPECT_NEAR(azimuth_difference(back.dip_direction, plane.dip_direction), 0, 30 * rounding);
                const Orientation turned = plane_with_normal(-upward_normal(plane));
                EXPECT_NEAR(turned.dip, plane.dip, rounding);
                const LineOrientation line = line_along(-dip_vector(plane));
                EXPECT_NEAR(line.plunge, plane.dip, rounding);
                // Near vertical the azimuth is the direction of a short horizontal part.
                EXPECT_NEAR(azimuth_difference(line.trend, plane.dip_direction), 0, 60 * rounding);
            }
        }
    }
    EXPECT_EQ(line_along({0, 0, 1}).plunge, degrees(90));
    EXPECT_FALSE(std::signbit(line_along({1, 0, 0}).plunge));
}

TEST(Orientation, AzimuthsWrapAtNorth) {
    EXPECT_NEAR(azimuth_difference(degrees(350), degrees(20)), degrees(30), rounding);
    EXPECT_NEAR(azimuth_difference(degrees(20), degrees(350)), degrees(-30), rounding);
    EXPECT_EQ(wrapped_azimuth(degrees(360)), 0);
    EXPECT_NEAR(wrapped_azimuth(degrees(-10)), degrees(350), rounding);
    EXPECT_EQ(wrapped_azimuth(-1e-300), 0);
}

// tan 60 cos 60 = 0.866: 40.893 deg.
TEST(Orientation, ApparentDipByHand) {
    EXPECT_NEAR(apparent_dip({degrees(60), degrees(100)}, degrees(160)), std::atan(std::sqrt(3) / 2), rounding);
    EXPECT_NEAR(apparent_dip({degrees(60), degrees(100)}, degrees(190)), 0, rounding);
    EXPECT_NEAR(apparent_dip({degrees(60), degrees(100)}, degrees(280)), degrees(-60), rounding);
}

// 50/150 and 60/250: normals (0.38302, -0.66341, 0.64279) and (-0.81380, -0.29620, 0.50000); their cross product
// (-0.14131, -0.71461, -0.65334) trends 180 + atan(0.14131 / 0.71461) = 191.186 deg and plunges
// atan(0.65334 / 0.72845) = 41.888 deg. Printed digits bound the difference.
TEST(Orientation, IntersectionByHand) {
    const auto line = intersection({degrees(50), degrees(150)}, {degrees(60), degrees(250)});
    ASSERT_TRUE(line);
    EXPECT_NEAR(line->trend / degrees(1), 191.186, 2e-3);
    EXPECT_NEAR(line->plunge / degrees(1), 41.888, 2e-3);
}

TEST(Orientation, IntersectionLiesInBothPlanesWhicheverComesFirst) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    for (int trial = 0; trial < 1000; ++trial) {
        const Orientation first{degrees(90) * share(random), degrees(360) * share(random)};
        const Orientation second{degrees(90) * share(random), degrees(360) * share(random)};
        const auto line = intersection(first, second);
        const auto swapped = intersection(second, first);
        ASSERT_TRUE(line && swapped);
        // The cross product of nearly parallel normals loses digits; none of the thousand pairs is nearer than 1e-3.
        EXPECT_NEAR(direction_of(*line).dot(upward_normal(first)), 0, 1e-12);
        EXPECT_NEAR(direction_of(*line).dot(upward_normal(second)), 0, 1e-12);
        EXPECT_NEAR((direction_of(*line) - direction_of(*swapped)).norm(), 0, 1e-12);
    }
    EXPECT_FALSE(intersection({degrees(70), degrees(100)}, {degrees(70), degrees(100)}));
    EXPECT_FALSE(intersection({0, degrees(10)}, {0, degrees(200)}));
    EXPECT_FALSE(intersection({degrees(90), degrees(10)}, {degrees(90), degrees(190)}));
}

JointSet scattered(double dip, double azimuth, double concentration) {
    return {"set", MeanOrientation{degrees(dip), degrees(azimuth), concentration}};
}

TEST(JointSet, MeanOfRangesThroughNorth) {
    const Orientation mean =
        mean_orientation({"set", OrientationRange{degrees(70), degrees(90), degrees(350), degrees(20)}});
    EXPECT_NEAR(mean.dip, degrees(80), rounding);
    EXPECT_NEAR(mean.dip_direction, degrees(5), rounding);
}

TEST(JointSet, SamplesOfARangeFillItEvenly) {
    const JointSet set{"set", OrientationRange{degrees(20), degrees(30), degrees(350), degrees(20)}};
    constexpr std::size_t count = 20000;
    double dips = 0;
    double azimuths = 0;
    double flat = 0;
    for (const Orientation& plane : sampled_planes(set, count, 7, 0)) {
        const double azimuth = azimuth_difference(degrees(350), plane.dip_direction);
        ASSERT_GE(plane.dip, degrees(20));
        ASSERT_LE(plane.dip, degrees(30));
        ASSERT_GE(azimuth, -rounding);
        ASSERT_LE(azimuth, degrees(30) + rounding);
        dips += plane.dip / count;
        azimuths += azimuth / count;
        flat += plane.dip < degrees(22) ? 1.0 / count : 0;
    }
    // Four standard errors: width / sqrt(12 count), and sqrt(0.2 * 0.8 / count) of the share.
    EXPECT_NEAR(dips, degrees(25), 4 * degrees(10) / std::sqrt(12.0 * count));
    EXPECT_NEAR(azimuths, degrees(15), 4 * degrees(30) / std::sqrt(12.0 * count));
    EXPECT_NEAR(flat, 0.2, 4 * std::sqrt(0.16 / count));
}

TEST(JointSet, FisherSamplesGiveBackMeanAndConcentration) {
    constexpr std::size_t count = 20000;
    for (const double concentration : {20.0, 100.0, 5000.0, 1e9}) {
        for (const double dip : {0.0, 3.0, 45.0, 90.0}) {
            const auto planes = sampled_planes(scattered(dip, 355, concentration), count, 11, 3);
            const OrientationStatistics found = orientation_statistics(planes);
            // The mean pole errs by sqrt(2 / (K N)) or so, the estimate of K by K / sqrt(N): four of each.
            const Direction mean = upward_normal({degrees(dip), degrees(355)});
            const double angle = mean.cross(upward_normal(found.mean)).norm();
            EXPECT_LT(angle, 4 * std::sqrt(2 / (concentration * count))) << concentration << ' ' << dip;
            EXPECT_NEAR(found.concentration / concentration, 1, 4 / std::sqrt(count)) << concentration << ' ' << dip;
        }
    }
}

// For K = 1 the mean of cos t about the mean direction is coth 1 - 1 = 0.31304; axial samples cannot tell t from
// 180 deg - t, so the mean of |cos t| is compared: integral of c K cosh(K c) / sinh K over c from 0 to 1
// = 1 + (1 - cosh 1) / sinh 1 = 0.53788.
TEST(JointSet, WideScatterFollowsFishersDistribution) {
    constexpr std::size_t count = 40000;
    const Direction mean = upward_normal({degrees(50), degrees(120)});
    double sum = 0;
    for (const Orientation& plane : sampled_planes(scattered(50, 120, 1), count, 5, 0)) {
        sum += std::abs(upward_normal(plane).dot(mean)) / count;
    }
    // |cos t| varies by less than 0.3: four standard errors.
    EXPECT_NEAR(sum, 1 + (1 - std::cosh(1)) / std::sinh(1), 4 * 0.3 / std::sqrt(count));
}

TEST(JointSet, SamplesDependOnSeedAndStreamOnly) {
    const JointSet set = scattered(50, 120, 40);
    const auto planes = sampled_planes(set, 100, 1967, 2);
    const auto again = sampled_planes(set, 200, 1967, 2);
    const auto other_stream = sampled_planes(set, 100, 1967, 3);
    const auto other_seed = sampled_planes(set, 100, 1968, 2);
    for (std::size_t index = 0; index < planes.size(); ++index) {
        EXPECT_EQ(planes[index].dip, again[index].dip);
        EXPECT_EQ(planes[index].dip_direction, again[index].dip_direction);
        EXPECT_NE(planes[index].dip, other_stream[index].dip);
        EXPECT_NE(planes[index].dip, other_seed[index].dip);
    }
}

TEST(JointSet, WithoutScatterEverySampleIsTheMean) {
    const JointSet set{"set", MeanOrientation{degrees(85), degrees(282.5), {}}};
    const auto planes = sampled_planes(set, 50, 1, 0);
    const OrientationStatistics found = orientation_statistics(planes);
    EXPECT_NEAR(found.mean.dip, degrees(85), rounding);
    EXPECT_NEAR(found.mean.dip_direction, degrees(282.5), 30 * rounding);
    EXPECT_EQ(found.concentration, std::numeric_limits<double>::infinity());
    EXPECT_EQ(found.angular_standard_deviation, 0);
}

// Poles of one set on both sides of the primitive: dips of 85 deg to 100 and of 87 deg to 280 are 8 deg apart and have
// the middle 89 deg to 100.
TEST(JointSet, SteepPlanesDippingBothWaysAreOneSet) {
    const OrientationStatistics found =
        orientation_statistics({{degrees(85), degrees(100)}, {degrees(87), degrees(280)}});
    EXPECT_NEAR(found.mean.dip, degrees(89), 1e-12);
    EXPECT_NEAR(found.mean.dip_direction, degrees(100), 1e-12);
    EXPECT_NEAR(found.angular_standard_deviation, degrees(4), 1e-12);
}

}  // namespace
}  // namespace delabole
