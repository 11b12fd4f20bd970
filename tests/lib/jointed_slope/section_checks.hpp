// Checks that every section cut into blocks has to pass.
#pragma once

#include "jointed_slope/jointed_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace delabole::testing {

inline double area_of(const JointedSection& made, MeshIndex rock = no_index) {
    double sum = 0;
    for (const SlopeBlock& block : made.block) {
        sum += rock == no_index || block.rock == rock ? area_properties(outline_of(made, block)).area : 0;
    }
    return sum;
}

inline double area_of(const std::vector<SectionPoint>& points) {
    Polygon<> outline;
    for (const SectionPoint& point : points) {
        outline.emplace_back(point.x, point.y);
    }
    return std::abs(area_properties(outline).area);
}

// Convex blocks that meet edge on edge, with the same joint from both sides.
inline void expect_exact_contact(const JointedSection& made) {
    std::map<std::pair<MeshIndex, MeshIndex>, MeshIndex> joint_of_edge;
    for (const SlopeBlock& block : made.block) {
        const std::size_t count = block.vertex.size();
        ASSERT_GE(count, 3U);
        ASSERT_EQ(block.joint.size(), count);
        for (std::size_t edge = 0; edge < count; ++edge) {
            const MeshIndex a = block.vertex[edge];
            const MeshIndex b = block.vertex[(edge + 1) % count];
            const MeshIndex c = block.vertex[(edge + 2) % count];
            EXPECT_TRUE(joint_of_edge.try_emplace({a, b}, block.joint[edge]).second) << "two blocks on one side";
            // Dynamic relaxation takes a corner for straight down to this sine.
            EXPECT_GT(sine_of_turn(made.vertex[a], made.vertex[b], made.vertex[c]), -1e-9);
            EXPECT_GE((made.vertex[b] - made.vertex[a]).norm(), 0.99 * made.snap_distance);
        }
        EXPECT_GT(area_properties(outline_of(made, block)).area, 0);
    }
    for (const auto& [ends, joint] : joint_of_edge) {
        const auto other = joint_of_edge.find({ends.second, ends.first});
        EXPECT_EQ(other == joint_of_edge.end(), joint == free_surface);
        EXPECT_TRUE(other == joint_of_edge.end() || other->second == joint);
    }
}

inline void expect_fills(const JointedSection& made, const std::vector<SectionPoint>& outline) {
    ASSERT_EQ(made.check, SlopeCheck::valid) << word_of(made.check);
    expect_exact_contact(made);
    EXPECT_NEAR((area_of(made) + made.crushed_area) / area_of(outline), 1, 1e-12);
}

inline std::vector<std::pair<double, double>> sorted_vertices(const JointedSection& made, double sign = 1) {
    std::vector<std::pair<double, double>> points;
    for (const PlanePoint<>& point : made.vertex) {
        points.emplace_back(sign * point.x(), point.y());
    }
    std::sort(points.begin(), points.end());
    return points;
}

}  // namespace delabole::testing
