// Which planes carry a wedge, against block theory by brute force and against Hocking's test.
#include "kinematics/criteria.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

namespace delabole {
namespace {

// Block theory (Goodman & Shi 1985), by brute force: of the four blocks between two planes, the finite one behind face
// and upper surface, and how it moves under its weight.
struct Block {
    bool finite;
    SlidingContact contact;
};

Block block_of(const SlopeOrientation& slope, const Orientation& first, const Orientation& second, double first_side,
               double second_side) {
    const Direction sides[] = {first_side * upward_normal(first), second_side * upward_normal(second)};
    const Direction constraints[] = {sides[0], sides[1], -upward_normal({slope.face_dip, slope.face_dip_direction}),
                                     -upward_normal(slope.upper_surface.value_or(Orientation{0, 0}))};
    // A cone of half-spaces without a line in it is more than its apex if one of its edges is: edges are crosses.
    bool finite = true;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < i; ++j) {
            for (const double sign : {1.0, -1.0}) {
                const Direction edge = sign * constraints[i].cross(constraints[j]);
                bool within_all = true;
                for (const Direction& constraint : constraints) {
                    within_all = within_all && edge.dot(constraint) >= -1e-12;
                }
                finite = finite && !within_all;
            }
        }
    }
    const Direction weight(0, 0, -1);
    if (weight.dot(sides[0]) < 0 && dip_vector(first).dot(sides[1]) > 0) {
        return {finite, SlidingContact::first_plane};
    }
    if (weight.dot(sides[1]) < 0 && dip_vector(second).dot(sides[0]) > 0) {
        return {finite, SlidingContact::second_plane};
    }
    return {finite, SlidingContact::both_planes};
}

struct BlockTheoryCount {
    int finite = 0;
    int on_one_plane = 0;
};

// Face, upper surface up to the given dip in any direction, and two planes, all random.
BlockTheoryCount compare_with_block_theory(std::uint64_t seed, double steepest_upper_surface) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> share(0, 1);
    const auto plane_between = [&](double flattest, double steepest) {
        const double dip = degrees(flattest + (steepest - flattest) * share(random));
        return Orientation{dip, degrees(360) * share(random)};
    };
    BlockTheoryCount count;
    for (int trial = 0; trial < 20000; ++trial) {
        const Orientation face_plane = plane_between(20, 89);
        SlopeOrientation slope{face_plane.dip, face_plane.dip_direction, {}};
        if (steepest_upper_surface > 0) {
            // Flatter than the face: the crest stays convex.
            slope.upper_surface = plane_between(0, std::min(steepest_upper_surface, slope.face_dip / degrees(1)));
        }
        const Orientation first = plane_between(1, 89);
        const Orientation second = plane_between(1, 89);
        const WedgeVerdict verdict = wedge_sliding(slope, first, second, 0);
        int finite_blocks = 0;
        for (const double first_side : {1.0, -1.0}) {
            for (const double second_side : {1.0, -1.0}) {
                const Block block = block_of(slope, first, second, first_side, second_side);
                if (!block.finite) {
                    continue;
                }
                ++finite_blocks;
                if (verdict.feasibility == Feasibility::feasible) {
                    EXPECT_EQ(verdict.contact, block.contact) << trial;
                }
            }
        }
        // Where the line leaves through the face and is cut off behind the crest there is one finite block, else none;
        // but a sloping upper surface may be where it leaves, and then it does not daylight in the face.
        const std::optional<LineOrientation> line = intersection(first, second);
        const bool leaves_above = line && slope.upper_surface &&
                                  direction_of(*line).dot(upward_normal(*slope.upper_surface)) > 0 &&
                                  direction_of(*line).dot(upward_normal(face_plane)) < 0;
        EXPECT_EQ(finite_blocks, verdict.feasibility == Feasibility::feasible || leaves_above ? 1 : 0) << trial;
        EXPECT_EQ(verdict.contact == SlidingContact::none, verdict.feasibility != Feasibility::feasible) << trial;
        count.finite += verdict.feasibility == Feasibility::feasible ? 1 : 0;
        count.on_one_plane +=
            verdict.feasibility == Feasibility::feasible && verdict.contact != SlidingContact::both_planes ? 1 : 0;
    }
    return count;
}

TEST(WedgeSliding, IsBlockTheoryBehindLevelGround) {
    const BlockTheoryCount count = compare_with_block_theory(12, 0);
    EXPECT_GT(count.finite, 1000);
    EXPECT_GT(count.on_one_plane, 200);
}

TEST(WedgeSliding, IsBlockTheoryBehindSlopingGround) {
    const BlockTheoryCount count = compare_with_block_theory(13, 60);
    EXPECT_GT(count.finite, 1000);
    EXPECT_GT(count.on_one_plane, 200);
}

// Hocking (1976), as printed, for level ground.
TEST(WedgeSliding, OnOnePlaneWhereHockingsTestSaysSo) {
    std::mt19937_64 random(14);
    std::uniform_real_distribution<double> share(0, 1);
    const auto between = [](double azimuth, double from, double to) {
        const double whole = azimuth_difference(from, to);
        const double part = azimuth_difference(from, azimuth);
        return part * whole > 0 && std::abs(part) < std::abs(whole);
    };
    int compared = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const double face_direction = degrees(360) * share(random);
        const SlopeOrientation slope{degrees(20 + 69 * share(random)), face_direction, {}};
        const Orientation first{degrees(1 + 88 * share(random)), degrees(360) * share(random)};
        const Orientation second{degrees(1 + 88 * share(random)), degrees(360) * share(random)};
        const WedgeVerdict verdict = wedge_sliding(slope, first, second, 0);
        if (verdict.feasibility != Feasibility::feasible) {
            continue;
        }
        ++compared;
        const double trend = intersection(first, second)->trend;
        const bool on_first = between(first.dip_direction, trend, face_direction);
        const bool on_second = between(second.dip_direction, trend, face_direction);
        const bool first_nearer = std::abs(azimuth_difference(first.dip_direction, face_direction)) <
                                  std::abs(azimuth_difference(second.dip_direction, face_direction));
        const SlidingContact expected = on_first && (first_nearer || !on_second) ? SlidingContact::first_plane
                                        : on_second                              ? SlidingContact::second_plane
                                                                                 : SlidingContact::both_planes;
        EXPECT_EQ(verdict.contact, expected) << trial;
    }
    EXPECT_GT(compared, 1000);
}

}  // namespace
}  // namespace delabole
