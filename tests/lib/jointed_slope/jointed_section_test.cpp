#include "jointed_slope/jointed_section.hpp"

#include "tests/lib/jointed_slope/section_checks.hpp"
#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace delabole {
namespace {

using testing::area_of;
using testing::benched_slope;
using testing::cut;
using testing::cut_in_one_rock;
using testing::expect_exact_contact;
using testing::expect_fills;
using testing::joint_set;
using testing::line;
using testing::section;
using testing::sorted_vertices;
using testing::square;
using testing::three_sets;

TEST(JointedSection, BlocksFillTheOutline) {
    expect_fills(cut_in_one_rock(section(benched_slope(), three_sets())), benched_slope());
}

TEST(JointedSection, SquareIsCutIntoSquares) {
    const JointedSection made = cut_in_one_rock(
        section(square(10), {cut("upright", joint_set(degrees(90), 1, 0.5)), cut("level", joint_set(0, 1, 0.5))}));
    // Joints at 0.5, 1.5, ... 9.5.
    EXPECT_EQ(made.block.size(), 11U * 11U);
    EXPECT_EQ(made.cut[0].made, 10U);
    EXPECT_EQ(made.cut[1].made, 11U * 10U);
    EXPECT_EQ(made.slivers_merged + made.slivers_crushed + made.slivers_kept, 0U);
    expect_fills(made, square(10));
}

TEST(JointedSection, JointAlongAFaceCutsNothingOff) {
    for (const double off : {0.0, 1e-13, -1e-13, 1e-4, -1e-4}) {
        const JointedSection made = cut_in_one_rock(
            section(square(10), {cut("upright", joint_set(degrees(90), 1, off)), cut("level", joint_set(0, 1, off))}));
        EXPECT_EQ(made.block.size(), 100U) << off;
        expect_fills(made, square(10));
    }
    // The joints are turned by less than the snap distance over the section's length.
    const JointedSection turned =
        cut_in_one_rock(section(square(10), {cut("upright", joint_set(degrees(90) - 1e-5, 1))}));
    EXPECT_EQ(turned.block.size(), 10U);
    expect_fills(turned, square(10));
}

TEST(JointedSection, SpacingLargerThanTheSlopeCutsNothing) {
    const JointedSection made = cut_in_one_rock(section(square(10), {cut("far", joint_set(degrees(60), 500, 250))}));
    EXPECT_EQ(made.check, SlopeCheck::valid);
    EXPECT_EQ(made.block.size(), 1U);
    EXPECT_EQ(made.cut[0].made, 0U);
}

TEST(JointedSection, SetEndsOnALine) {
    for (const SideOfLine side : {SideOfLine::above, SideOfLine::below}) {
        JointSetCut set = joint_set(degrees(90), 1, 0.5);
        set.ends_on = "fault";
        set.side = side;
        // Drawn from right to left: above stays above.
        const JointedSection made =
            cut_in_one_rock(section(square(10), {cut("fault", line({{11, 5}, {-1, 5}})), cut("b", set)}));
        expect_fills(made, square(10));
        EXPECT_EQ(made.block.size(), 12U);
        std::size_t above = 0;
        for (const SlopeBlock& block : made.block) {
            above += area_properties(outline_of(made, block)).centroid.y() > 5 ? 1 : 0;
        }
        EXPECT_EQ(above, side == SideOfLine::above ? 11U : 1U);
    }
}

TEST(JointedSection, OrderOfCuttingDoesNotMatter) {
    const JointSetCut level = joint_set(0, 1, 0.5);
    JointSetCut ending = joint_set(degrees(90), 1, 0.5);
    ending.region = {{-1, -1}, {11, -1}, {11, 4.5}, {-1, 4.5}};
    const JointedSection after = cut_in_one_rock(section(square(10), {cut("level", level), cut("b", ending)}));
    const JointedSection before = cut_in_one_rock(section(square(10), {cut("b", ending), cut("level", level)}));
    expect_fills(after, square(10));
    expect_fills(before, square(10));
    // Five rows lie in the region whole.
    EXPECT_EQ(after.block.size(), 5U * 11 + 6);
    EXPECT_EQ(sorted_vertices(before), sorted_vertices(after));
    EXPECT_EQ(before.block.size(), after.block.size());
    EXPECT_EQ(before.cut[0].dropped, 0U);
    ending.region = {{-1, -1}, {11, -1}, {11, 4.7}, {-1, 4.7}};
    const JointedSection short_of = cut_in_one_rock(section(square(10), {cut("b", ending), cut("level", level)}));
    EXPECT_EQ(short_of.block.size(), after.block.size());
    EXPECT_EQ(short_of.cut[0].dropped, 10U) << "each ends 0.2 m into the sixth row";
}

TEST(JointedSection, PersistenceIsTheShareOfBlocksCut) {
    JointSetCut traces = joint_set(degrees(90), 1, 0.5);
    traces.persistence = 0.5;
    traces.trace_length = 10;
    const JointedSection made =
        cut_in_one_rock(section(square(100), {cut("level", joint_set(0, 1, 0.5)), cut("b", traces)}));
    expect_fills(made, square(100));
    const double share = static_cast<double>(made.cut[1].made) / (101 * 100);  // rows, joints
    // A trace of 10 m in 20 m cuts a row of 1 m over 9 m of places; 500 traces of independent beginning: three standard
    // deviations are 0.5 / sqrt(500) * 3 at most, and less by far as only the ends of traces are random.
    EXPECT_NEAR(share, 0.45, 0.067);
}

TEST(JointedSection, CrossJointsAreStaggeredFromColumnToColumn) {
    JointSetCut cross = joint_set(0, 1);
    cross.staggered_by = "columns";
    cross.stagger_share = 0.5;
    const JointedSection made =
        cut_in_one_rock(section(square(8), {cut("columns", joint_set(degrees(90), 1)), cut("cross", cross)}));
    expect_fills(made, square(8));
    // Of each two columns one has joints at 1, 2, ..., the other at 0.5, 1.5, ...
    EXPECT_EQ(made.block.size(), 4U * 8 + 4 * 9);
    std::map<int, double> lowest;
    for (const SlopeBlock& block : made.block) {
        const AreaProperties<> properties = area_properties(outline_of(made, block));
        double& area = lowest.try_emplace(static_cast<int>(properties.centroid.x()), 2).first->second;
        area = std::min(area, properties.area);
    }
    for (int column = 1; column < 8; ++column) {
        EXPECT_NEAR(std::abs(lowest[column] - lowest[column - 1]), 0.5, 1e-12);
    }
}

TEST(JointedSection, FaultHasItsThicknessFilledWithGouge) {
    LineCut fault = line({{-1, 3}, {4, 3}, {11, 10}});
    fault.thickness = 0.25;
    fault.gouge = "gouge";
    const JointedSection made = cut_in_one_rock(
        section(square(10), {cut("fault", fault), cut("a", joint_set(degrees(70), 1.3)), cut("b", joint_set(0, 0.9))}));
    expect_fills(made, square(10));
    // Between the level of 3 at x = 0 and the 45 deg that reach x = 10 at y = 9: 4 m and 6 sqrt(2) m of middle line, on
    // which mitred strips have the area thickness times length; at x = 10 both ends of the strip slant alike.
    EXPECT_NEAR(area_of(made, 1), 0.25 * (4 + 6 * std::sqrt(2.0)), 1e-9);
}

TEST(JointedSection, BoundaryPartsTheRocks) {
    LineCut boundary = line({{-5, 2}, {4, 6}, {7, 3}, {15, 8}});
    boundary.rock_below = "other";
    for (const bool with_joints : {false, true}) {
        SlopeGeometry geometry = section(square(10), {cut("boundary", boundary)});
        geometry.sliver_share = 0;
        if (with_joints) {
            geometry.cut.push_back(cut("a", joint_set(degrees(70), 1.3)));
        }
        const JointedSection made = cut_in_one_rock(geometry);
        expect_fills(made, square(10));
        const double at_0 = 2 + 5 * 4.0 / 9;
        const double at_10 = 3 + 3 * 5.0 / 8;
        const double below =
            area_of(std::vector<SectionPoint>{{0, 0}, {10, 0}, {10, at_10}, {7, 3}, {4, 6}, {0, at_0}});
        EXPECT_NEAR(area_of(made, 2), below, 1e-9);
        EXPECT_NEAR(area_of(made, 0), 100 - below, 1e-9);
    }
}

TEST(JointedSection, SetKeepsToItsRock) {
    LineCut boundary = line({{-1, 5}, {11, 5}});
    boundary.rock_below = "other";
    JointSetCut set = joint_set(degrees(90), 1, 0.5);
    set.rock = "other";
    const JointedSection made = cut_in_one_rock(section(square(10), {cut("boundary", boundary), cut("a", set)}));
    EXPECT_EQ(made.block.size(), 12U);
}

TEST(JointedSection, WhatWasDividedToStayConvexIsJoinedAgain) {
    // An upright joint through each corner that points inwards leaves nothing to divide.
    const std::vector<SectionPoint> steps{{0, 0}, {9, 0}, {9, 6}, {6, 6}, {6, 4}, {3, 4}, {3, 2}, {0, 2}};
    const JointedSection bare = cut_in_one_rock(section(steps));
    expect_fills(bare, steps);
    EXPECT_EQ(bare.intact_edges, 2U);
    EXPECT_EQ(bare.block.size(), 3U);
    const JointedSection jointed = cut_in_one_rock(section(steps, {cut("upright", joint_set(degrees(90), 3))}));
    expect_fills(jointed, steps);
    EXPECT_EQ(jointed.intact_edges, 0U);
    EXPECT_EQ(jointed.block.size(), 3U);
}

TEST(JointedSection, SliversGoToTheNeighbourAndAreCounted) {
    // A second set 0.01 beside the first.
    const std::vector<SlopeCut> cuts{cut("one", joint_set(degrees(90), 1, 0.5)),
                                     cut("two", joint_set(degrees(90), 1, 0.51))};
    SlopeGeometry geometry = section(square(10), cuts);
    const JointedSection made = cut_in_one_rock(geometry);
    expect_fills(made, square(10));
    EXPECT_EQ(made.block.size(), 11U);
    EXPECT_EQ(made.slivers_merged, 10U);
    EXPECT_EQ(made.slivers_crushed + made.slivers_kept, 0U);
    geometry.sliver_share = 0;
    EXPECT_EQ(cut_in_one_rock(geometry).block.size(), 21U);
}

// A tip between the left side, a level joint and a steep one, both of which run on: with the rock below it would be a
// block that locks the level joint.
TEST(JointedSection, SliversThatWouldLockAJointAreTakenAway) {
    SlopeGeometry geometry = section(square(10), {cut("level", line({{-1, 5}, {11, 5}})),
                                                  cut("steep", line({{-0.15, 5.6}, {1.2, 2.9}, {3, -0.7}}))});
    for (const double share : {0.02, 0.0}) {
        geometry.sliver_share = share;
        const JointedSection made = cut_in_one_rock(geometry);
        expect_fills(made, square(10));
        for (const SlopeBlock& block : made.block) {
            const Polygon<> outline = outline_of(made, block);
            const auto [low, high] = std::ranges::minmax(outline, {}, [](const auto& corner) { return corner.y(); });
            EXPECT_TRUE(low.y() > 5 - 1e-9 || high.y() < 5 + 1e-9) << "no block reaches across the level joint";
        }
    }
}

TEST(JointedSection, LongSliversAreKeptBecauseBlocksRestOnThem) {
    const LineCut inclined = line({{-1, 5.035}, {11, 4.975}});
    const SlopeGeometry geometry = section(square(10), {cut("level", line({{-1, 5}, {11, 5}})), cut("b", inclined)});
    EXPECT_EQ(cut_in_one_rock(geometry).slivers_kept, 2U);
}

// The block below has thousands of corners on one line, none of them quite on it.
TEST(JointedSection, BlockUnderManyColumnsIsNoSliver) {
    JointSetCut columns = joint_set(degrees(70), 0.005);
    columns.ends_on = "base";
    columns.side = SideOfLine::above;
    const JointedSection made =
        cut_in_one_rock(section(square(10), {cut("base", line({{-1, 2}, {11, 6}})), cut("columns", columns)}));
    double greatest = 0;
    for (const SlopeBlock& block : made.block) {
        greatest = std::max(greatest, area_properties(outline_of(made, block)).area);
    }
    EXPECT_NEAR(greatest, 40, 1e-6) << "the square below the base; corners are snapped within 1e-8 m";
    EXPECT_GT(made.block.size(), 1500U);
}

TEST(JointedSection, ScatterKeepsWithinItsBounds) {
    JointSetCut set = joint_set(degrees(90), 1, 0.5);
    set.scatter = 0.3;
    set.seed = 7;
    const SlopeGeometry geometry = section(square(100), {cut("a", set)});
    const JointedSection made = cut_in_one_rock(geometry);
    std::set<double> places;
    for (const PlanePoint<>& point : made.vertex) {
        if (point.y() == 0) {
            places.insert(point.x());
        }
    }
    double least = 10;
    double greatest = 0;
    // The corners of the outline itself are left out.
    for (auto at = std::next(places.begin()); std::next(at, 2) != places.end(); ++at) {
        least = std::min(least, *std::next(at) - *at);
        greatest = std::max(greatest, *std::next(at) - *at);
    }
    EXPECT_GE(least, 0.7 - 1e-12);
    EXPECT_LE(greatest, 1.3 + 1e-12);
    EXPECT_LT(least, 0.75);
    EXPECT_GT(greatest, 1.25);
    EXPECT_EQ(sorted_vertices(made), sorted_vertices(cut_in_one_rock(geometry)));
    SlopeGeometry other = geometry;
    std::get<JointSetCut>(other.cut[0].trace).seed = 8;
    EXPECT_NE(sorted_vertices(made), sorted_vertices(cut_in_one_rock(other)));
}

std::vector<SlopeCut> scattered_sets() {
    std::vector<SlopeCut> cuts = three_sets();
    for (SlopeCut& named : cuts) {
        std::get<JointSetCut>(named.trace).scatter = 0.3;
    }
    auto& traces = std::get<JointSetCut>(cuts.back().trace);
    traces.persistence = 0.7;
    traces.trace_length = 9;
    LineCut fault = line({{-20, 2}, {25, 12}, {70, 4}});
    fault.thickness = 0.5;
    fault.gouge = "gouge";
    cuts.push_back(cut("fault", fault));
    return cuts;
}

template <class Change>
SlopeGeometry moved(SlopeGeometry geometry, Change&& change) {
    for (SectionPoint& point : geometry.outline) {
        point = change(point);
    }
    for (SlopeCut& named : geometry.cut) {
        if (auto* set = std::get_if<JointSetCut>(&named.trace)) {
            set->through = change(set->through.value_or(SectionPoint{0, 0}));
        } else {
            for (SectionPoint& point : std::get<LineCut>(named.trace).vertex) {
                point = change(point);
            }
        }
    }
    return geometry;
}

TEST(JointedSection, MirrorImageIsTheSameToTheLastBit) {
    const SlopeGeometry geometry = section(benched_slope(), scattered_sets());
    SlopeGeometry mirrored = moved(geometry, [](SectionPoint point) { return SectionPoint{-point.x, point.y}; });
    for (SlopeCut& named : mirrored.cut) {
        if (auto* set = std::get_if<JointSetCut>(&named.trace)) {
            set->dip = -set->dip;
        }
    }
    const JointedSection one = cut_in_one_rock(geometry);
    const JointedSection other = cut_in_one_rock(mirrored);
    EXPECT_TRUE(other.outline_reversed);
    expect_fills(one, benched_slope());
    EXPECT_EQ(sorted_vertices(one), sorted_vertices(other, -1));
    EXPECT_EQ(one.block.size(), other.block.size());
}

TEST(JointedSection, ScaledByAPowerOfTwoIsTheSameToTheLastBit) {
    const SlopeGeometry geometry = section(benched_slope(), scattered_sets());
    for (const double scale : {0x1p-8, 0x1p5}) {
        SlopeGeometry scaled = moved(geometry, [&](SectionPoint point) {
            return SectionPoint{scale * point.x, scale * point.y};
        });
        for (SlopeCut& named : scaled.cut) {
            if (auto* set = std::get_if<JointSetCut>(&named.trace)) {
                set->spacing *= scale;
                set->offset = *set->offset * scale;
                if (set->trace_length) {
                    set->trace_length = *set->trace_length * scale;
                }
            } else {
                auto& fault = std::get<LineCut>(named.trace);
                fault.thickness = *fault.thickness * scale;
            }
        }
        const JointedSection one = cut_in_one_rock(geometry);
        const JointedSection other = cut_in_one_rock(scaled);
        ASSERT_EQ(one.vertex.size(), other.vertex.size());
        for (std::size_t index = 0; index < one.vertex.size(); ++index) {
            EXPECT_EQ(scale * one.vertex[index].x(), other.vertex[index].x());
            EXPECT_EQ(scale * one.vertex[index].y(), other.vertex[index].y());
        }
    }
}

SectionPoint far_off(SectionPoint point) {
    return {point.x + 1024, point.y - 512};
}

void expect_same_blocks_far_off(const JointedSection& one, const JointedSection& other) {
    ASSERT_EQ(one.vertex.size(), other.vertex.size());
    ASSERT_EQ(one.block.size(), other.block.size());
    for (std::size_t index = 0; index < one.block.size(); ++index) {
        EXPECT_EQ(one.block[index].vertex, other.block[index].vertex);
    }
    for (std::size_t index = 0; index < one.vertex.size(); ++index) {
        // One rounding of the sum, at most half a unit in the last place of 1084.
        EXPECT_NEAR(other.vertex[index].x(), one.vertex[index].x() + 1024, 0x1p-42);
        EXPECT_NEAR(other.vertex[index].y(), one.vertex[index].y() - 512, 0x1p-42);
    }
}

TEST(JointedSection, MovedSectionHasTheSameBlocks) {
    const SlopeGeometry geometry = section(benched_slope(), scattered_sets());
    expect_same_blocks_far_off(cut_in_one_rock(geometry), cut_in_one_rock(moved(geometry, far_off)));
}

// A drawing in the coordinates of a survey; the foot of the lower face is the toe.
TEST(JointedSection, JointsOfASectionFarFromTheOriginAreMeasuredFromItsToe) {
    SlopeGeometry near = section(benched_slope(), three_sets());
    SlopeGeometry far = near;
    std::ranges::transform(far.outline, far.outline.begin(), far_off);
    for (SlopeCut& named : near.cut) {
        std::get<JointSetCut>(named.trace).through = SectionPoint{2, 0};
    }
    expect_same_blocks_far_off(cut_in_one_rock(near), cut_in_one_rock(far));
}

TEST(JointedSection, ClockwiseAndRepeatedCornersAreRepaired) {
    std::vector<SectionPoint> outline = benched_slope();
    std::reverse(outline.begin() + 1, outline.end());
    outline.insert(outline.begin() + 3, outline[3]);
    outline.push_back(outline.front());
    const JointedSection made = cut_in_one_rock(section(outline, three_sets()));
    EXPECT_TRUE(made.outline_reversed);
    EXPECT_EQ(made.corners_dropped, 2U);
    EXPECT_EQ(sorted_vertices(made), sorted_vertices(cut_in_one_rock(section(benched_slope(), three_sets()))));
}

TEST(JointedSection, BadGeometryIsNamed) {
    const auto check = [](std::vector<SectionPoint> outline, std::vector<SlopeCut> cuts = {}) {
        return cut_in_one_rock(section(std::move(outline), std::move(cuts))).check;
    };
    const auto with_set = [&](auto&& change) {
        JointSetCut set = joint_set(degrees(60), 1);
        change(set);
        return check(square(10), {cut("a", set)});
    };
    EXPECT_EQ(check({{0, 0}, {1, 0}}), SlopeCheck::outline_too_short);
    EXPECT_EQ(check({{0, 0}, {2, 2}, {2, 0}, {0, 2}}), SlopeCheck::outline_crosses_itself);
    // A corner lies on another edge.
    EXPECT_EQ(check({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}), SlopeCheck::outline_crosses_itself);
    EXPECT_EQ(check({{0, 0}, {4, 0}, {8, 0}}), SlopeCheck::outline_crosses_itself);
    // The case's own corner is named, whether or not it repeats some: the top is crossed by the notch below it.
    const SlopeGeometry notched = section({{0, 0}, {0, 0}, {10, 0}, {10, 10}, {4, 10}, {6, 6}, {6, 12}, {0, 10}}, {});
    EXPECT_EQ(cut_in_one_rock(notched).check, SlopeCheck::outline_crosses_itself);
    EXPECT_EQ(cut_in_one_rock(notched).index_at_fault, 3U);
    EXPECT_EQ(check({{0, 0}, {std::nan(""), 0}, {8, 8}}), SlopeCheck::number_out_of_range);
    EXPECT_EQ(with_set([](JointSetCut& set) { set.spacing = 0; }), SlopeCheck::number_out_of_range);
    EXPECT_EQ(with_set([](JointSetCut& set) { set.spacing = -1; }), SlopeCheck::number_out_of_range);
    EXPECT_EQ(with_set([](JointSetCut& set) { set.spacing = 1e-9; }), SlopeCheck::too_many_blocks);
    EXPECT_EQ(with_set([](JointSetCut& set) { set.persistence = 0.5; }), SlopeCheck::persistence_without_trace_length);
    EXPECT_EQ(with_set([](JointSetCut& set) { set.side = SideOfLine::above; }), SlopeCheck::feature_and_side);
    EXPECT_EQ(with_set([](JointSetCut& set) { set.stagger_share = 0.5; }), SlopeCheck::stagger_without_set);
    EXPECT_EQ(with_set([](JointSetCut& set) { set.rock = "granite"; }), SlopeCheck::unknown_rock);
    EXPECT_EQ(with_set([](JointSetCut& set) { set.region = {{0, 0}, {1, 1}}; }), SlopeCheck::region_too_short);
    EXPECT_EQ(with_set([](JointSetCut& set) {
                  set.region = {{0, 0}, {9, 9}, {9, 0}, {0, 9}};
              }),
              SlopeCheck::region_crosses_itself);
    EXPECT_EQ(with_set([](JointSetCut& set) {
                  set.ends_on = "a";
                  set.side = SideOfLine::above;
              }),
              SlopeCheck::unknown_line);
    EXPECT_EQ(with_set([](JointSetCut& set) {
                  set.staggered_by = "b";
                  set.stagger_share = 0.5;
              }),
              SlopeCheck::unknown_set);
    EXPECT_EQ(check(square(10), {cut("a", line({{0, 5}, {0, 5}}))}), SlopeCheck::line_too_short);
    EXPECT_EQ(check(square(10), {cut("a", line({{0, 5}, {5, 5}, {1, 5.1}}))}), SlopeCheck::line_folds_back);
    LineCut thick = line({{0, 5}, {10, 5}});
    thick.thickness = 0.1;
    EXPECT_EQ(check(square(10), {cut("a", thick)}), SlopeCheck::gouge_and_thickness);
    SlopeGeometry coarse = section(square(10), three_sets());
    coarse.snap_distance = 1;
    EXPECT_EQ(cut_in_one_rock(coarse).check, SlopeCheck::snap_distance_out_of_range);
    SlopeCut unknown = cut("a", joint_set(0, 1));
    unknown.joint = "tight";
    EXPECT_EQ(check(square(10), {cut("b", joint_set(1, 1)), unknown}), SlopeCheck::unknown_joint);
    EXPECT_EQ(cut_in_one_rock(section(square(10), {cut("b", joint_set(1, 1)), unknown})).index_at_fault, 1U);
}

TEST(JointedSection, HundredThousandBlocks) {
    const JointedSection made = cut_in_one_rock(
        section(square(320), {cut("a", joint_set(degrees(70), 1)), cut("b", joint_set(degrees(-20), 1))}));
    EXPECT_GT(made.block.size(), 100000U);
    expect_fills(made, square(320));
}

// Faces with many joints are halved first; no joint is lost by it. Cut one after the other, with all corners of the
// column beside looked through for each joint, half a million joints would take an hour.
TEST(JointedSection, ColumnsOfManyThinBlocks) {
    const std::vector<SectionPoint> low{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    const auto cut_finely = [&](double spacing) {
        SlopeGeometry geometry =
            section(low, {cut("upright", joint_set(degrees(90), 1)), cut("level", joint_set(0, spacing, spacing / 2))});
        geometry.sliver_share = 0;
        return cut_in_one_rock(geometry);
    };
    const JointedSection made = cut_finely(1.0 / 3000);
    EXPECT_EQ(made.block.size(), 2U * 3001U);
    EXPECT_EQ(made.cut[1].made, 2U * 3000U);
    expect_fills(made, low);
    EXPECT_EQ(cut_finely(1.0 / 30'000).cut[1].made, 2U * 30'000U);
}

// Joints are counted before they cut: of two sets that would make 4e12 blocks the first is not too fine by itself.
// Joints that end inside rock divide nothing before those of the other set are cut.
TEST(JointedSection, TooManyBlocksOfJointsThatAreCutAgainAreRefused) {
    JointSetCut ending = joint_set(degrees(90), 0.02, 0.01);
    ending.region = {{-1, -1}, {11, -1}, {11, 9}, {-1, 9}};
    const JointedSection made =
        cut_in_one_rock(section(square(10), {cut("b", ending), cut("level", joint_set(0, 0.02, 0.01))}));
    EXPECT_EQ(made.check, SlopeCheck::too_many_blocks);
    EXPECT_EQ(made.index_at_fault, 0U);
}

TEST(JointedSection, TooManyBlocksAreRefusedBeforeTheyAreCut) {
    const auto refused = [](std::vector<SlopeCut> cuts) {
        const JointedSection made = cut_in_one_rock(section(square(1), std::move(cuts)));
        EXPECT_EQ(made.check, SlopeCheck::too_many_blocks) << word_of(made.check);
        EXPECT_TRUE(made.block.empty());
        return made.index_at_fault;
    };
    EXPECT_EQ(refused({cut("a", joint_set(degrees(90), 2e-5)), cut("b", joint_set(0, 2e-5))}), 1U);
    EXPECT_EQ(refused({cut("a", joint_set(degrees(90), 7e-4)), cut("b", joint_set(0, 7e-4))}), 1U);
    // In a small region the set may be as fine.
    JointSetCut fine = joint_set(0, 7e-4);
    fine.region = {{-1, 0.4}, {2, 0.4}, {2, 0.5}, {-1, 0.5}};
    const JointedSection made =
        cut_in_one_rock(section(square(1), {cut("a", joint_set(degrees(90), 7e-3)), cut("b", fine)}));
    EXPECT_EQ(made.check, SlopeCheck::valid) << word_of(made.check);
    EXPECT_GT(made.cut[1].made, 143U * 140U);
}

}  // namespace
}  // namespace delabole
