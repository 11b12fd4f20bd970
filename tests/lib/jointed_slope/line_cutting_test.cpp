#include "tests/lib/jointed_slope/section_checks.hpp"
#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

using testing::cut;
using testing::cut_in_one_rock;
using testing::expect_fills;
using testing::joint_set;
using testing::line;
using testing::one_joint;
using testing::section;
using testing::sorted_vertices;
using testing::square;

// Areas of the blocks, smallest first.
std::vector<double> areas_of(const JointedSection& made) {
    std::vector<double> areas;
    for (const SlopeBlock& block : made.block) {
        areas.push_back(area_properties(outline_of(made, block)).area);
    }
    std::sort(areas.begin(), areas.end());
    return areas;
}

TEST(LineCutting, LinesThatMeetInsideABlockCutABlockOut) {
    // A plane from the left side and a crack from the top part a corner of 36 m2 from the square, whose rest is not
    // convex.
    const auto cut_by = [](std::vector<std::vector<SectionPoint>> lines) {
        std::vector<SlopeCut> cuts;
        for (std::vector<SectionPoint>& points : lines) {
            cuts.push_back(cut("line" + std::to_string(cuts.size()), line(std::move(points))));
        }
        return cut_in_one_rock(section(square(10), cuts));
    };
    const SectionPoint side{-1, 4. / 3};
    const SectionPoint past_side{9, 8};  // 3 m beyond the foot of the crack at (6, 6)
    for (const JointedSection& made :
         {cut_by({{side, {6, 6}}, {{6, 6}, {6, 11}}}), cut_by({{{6, 6}, {6, 11}}, {side, {6, 6}}}),
          cut_by({{{6, 6}, side}, {{6, 11}, {6, 6}}}), cut_by({{side, past_side}, {{6, 6}, {6, 11}}}),
          cut_by({{side, {6, 6}}, {{6, 5.5}, {6, 11}}}), cut_by({{side, past_side}, {{6, 5.5}, {6, 11}}}),
          cut_by({{{6, 3}, {6, 11}}, {side, past_side}}), cut_by({{side, {6, 6}, {6, 11}}})}) {
        expect_fills(made, square(10));
        const std::vector<double> areas = areas_of(made);
        ASSERT_EQ(areas.size(), 3U);
        EXPECT_NEAR(areas[1], 36, 1e-9);  // the rest is divided at the foot of the crack, since blocks are convex
        EXPECT_EQ(made.intact_edges, 1U);
    }
    // The mirrored section is the same to the last bit.
    const auto mirrored = [](std::vector<SectionPoint> points) {
        for (SectionPoint& point : points) {
            point.x = -point.x;
        }
        return points;
    };
    const JointedSection one = cut_by({{side, past_side}, {{6, 5.5}, {6, 11}}});
    const JointedSection other =
        cut_in_one_rock(section(mirrored(square(10)), {cut("plane", line(mirrored({side, past_side}))),
                                                       cut("crack", line(mirrored({{6, 5.5}, {6, 11}})))}));
    EXPECT_EQ(sorted_vertices(one), sorted_vertices(other, -1));
    // One joint is drawn in two parts, end to end or one past the other.
    for (const double end : {4.0, 4.5}) {
        const JointedSection made = cut_by({{{-1, 5}, {end, 5}}, {{4, 5}, {11, 5}}});
        expect_fills(made, square(10));
        EXPECT_EQ(areas_of(made), (std::vector<double>{50, 50}));
    }
}

TEST(LineCutting, LineEndsOnAJointThatIsCutLater) {
    const SlopeCut plane = cut("plane", line({{-1, 4. / 3}, {6, 6}}));
    const SlopeCut crack = cut("crack", line({{6, -1}, {6, 11}}));
    const SlopeCut set = cut("set", joint_set(degrees(90), 6));
    for (const SlopeCut& later : {crack, set}) {
        const JointedSection made = cut_in_one_rock(section(square(10), {plane, later}));
        const JointedSection other = cut_in_one_rock(section(square(10), {later, plane}));
        expect_fills(made, square(10));
        EXPECT_EQ(made.block.size(), 3U);
        EXPECT_EQ(sorted_vertices(made), sorted_vertices(other));
        EXPECT_EQ(made.cut[0].dropped, 0U);
    }
}

// A joint of a set is the same joint as a line, wherever it ends, and in whatever order they are cut.
TEST(LineCutting, JointsOfSetsThatMeetInsideABlockCutABlockOut) {
    const JointSetCut plane_set = one_joint(std::atan(2. / 3), {0, 2}, {{-5, -5}, {6.1, -5}, {6.1, 15}, {-5, 15}});
    const JointSetCut crack_set = one_joint(degrees(90), {6, 0}, {{-5, 5.7}, {15, 5.7}, {15, 15}, {-5, 15}});
    const SlopeCut plane_line = cut("plane", line({{-3, 0}, {6.1, 2 + 6.1 * 2 / 3}}));
    const SlopeCut crack_line = cut("crack", line({{6, 5.7}, {6, 11}}));
    const JointedSection lines = cut_in_one_rock(section(square(10), {plane_line, crack_line}));
    ASSERT_GT(lines.block.size(), 1U);
    for (const SlopeCut& plane : {plane_line, cut("plane", plane_set)}) {
        for (const SlopeCut& crack : {crack_line, cut("crack", crack_set)}) {
            for (const std::vector<SlopeCut>& cuts : {std::vector{plane, crack}, std::vector{crack, plane}}) {
                const JointedSection made = cut_in_one_rock(section(square(10), cuts));
                expect_fills(made, square(10));
                EXPECT_EQ(areas_of(made).size(), areas_of(lines).size());
                EXPECT_NEAR(areas_of(made).front(), areas_of(lines).front(), 0.05);  // points snap to corners
                EXPECT_GT(made.cut[0].made, 0U);
                EXPECT_GT(made.cut[1].made, 0U);
            }
        }
    }
}

// Joints that cross but part no block leave none of the divisions that were tried there.
TEST(LineCutting, JointsThatCrossInsideABlockAloneCutNothing) {
    const std::vector<SectionPoint> middle{{3, 3}, {7, 3}, {7, 7}, {3, 7}};
    const auto few = [&](double dip, double spacing) {
        JointSetCut set = one_joint(dip, {5, 5}, middle);
        set.spacing = spacing;
        return set;
    };
    const JointedSection one =
        cut_in_one_rock(section(square(10), {cut("a", few(degrees(20), 200)), cut("b", few(degrees(-60), 200))}));
    EXPECT_EQ(one.block.size(), 1U);
    EXPECT_EQ(one.intact_edges, 0U);
    const JointedSection two =
        cut_in_one_rock(section(square(10), {cut("a", few(degrees(20), 200)), cut("b", few(degrees(-60), 2.5))}));
    EXPECT_EQ(two.block.size(), 1U);
    EXPECT_EQ(two.intact_edges, 0U);
}

TEST(LineCutting, LinesThatMissEachOtherOrEndInRockCutNothing) {
    // The lines end 5 cm apart, with a snap distance of 1 mm.
    const JointedSection made = cut_in_one_rock(section(
        square(10), {cut("plane", line({{-1, 4. / 3}, {6, 6}})), cut("crack", line({{6.05, 6.1}, {6.05, 11}}))}));
    EXPECT_EQ(made.block.size(), 1U);
    EXPECT_EQ(made.cut[0].dropped, 1U);
    EXPECT_EQ(made.cut[1].dropped, 1U);
}

}  // namespace
}  // namespace delabole
