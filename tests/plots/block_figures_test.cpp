#include "plots/figures/block_figures.hpp"
#include "plots/drawing/polygon.hpp"
#include "samples.hpp"
#include "series_of.hpp"
#include "tests/support/no_number.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace delabole {
namespace {

double arrow_length(const Arrows::Shaft& shaft) {
    return (shaft.to - shaft.from).norm();
}

// The key is the arrow without a legend and the text beside it.
struct ForceKey {
    Arrows::Shaft arrow;
    double force;  // N/m
};

ForceKey force_key(const Figure& figure) {
    for (const Label& label : figure.labels) {
        if (label.text.ends_with(" kN/m")) {
            return {with_legend<Arrows>(figure, "").shafts.at(0), 1e3 * std::stod(label.text)};
        }
    }
    ADD_FAILURE() << "no key to the forces";
    return {};
}

Polyline square(double x, double y, double side) {
    return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

BlockDrawing two_squares() {
    return {.title = "two",
            .blocks = {{.outline = square(0, 0, 2), .label = "1", .mode = DrawnMode::slides},
                       {.outline = square(2, 0, 2), .label = "2", .mode = DrawnMode::topples}}};
}

TEST(Polygon, InsideAndChords) {
    const Polyline shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
    EXPECT_TRUE(inside(shape, {0.5, 1.5}));
    EXPECT_FALSE(inside(shape, {1.5, 1.5}));
    EXPECT_DOUBLE_EQ(chord(shape, {0.5, 0.5}, 0), 2);
    EXPECT_DOUBLE_EQ(chord(shape, {0.5, 1.5}, 0), 1);
    EXPECT_DOUBLE_EQ(chord(shape, {1.5, 0.5}, 1), 1);
    EXPECT_DOUBLE_EQ(chord(shape, {1.5, 1.5}, 0), 0) << "outside";
}

TEST(BlockFigure, HasOneLegendForEachModeAndKindOfForcePresent) {
    const std::vector<std::string> names = legends(block_figure(samples::goodman_bray_blocks()));
    EXPECT_EQ(names, (std::vector<std::string>{"stays", "slides", "topples", "interblock force", "base reaction"}));
    EXPECT_TRUE(legends(block_figure({.blocks = {{.outline = square(0, 0, 1)}}})).empty()) << "a plain block";
}

TEST(BlockFigure, SaysThatADrawingFarFromTheOriginIsInCoordinates) {
    const Figure near = block_figure({.blocks = {{.outline = square(0, 0, 1)}}});
    EXPECT_EQ(near.x.title + ", " + near.y.title, "distance from the toe, height above the toe");
    const Figure far = block_figure({.blocks = {{.outline = square(1200, 340, 1)}}});
    EXPECT_EQ(far.x.title + ", " + far.y.title, "x, elevation");
}

TEST(BlockFigure, DrawsMetresEquallyLongBothWaysAtTheToesElevation) {
    BlockDrawing drawing = samples::stepped_base();
    const Figure figure = block_figure(drawing);
    EXPECT_TRUE(figure.equal_scales);
    EXPECT_EQ(figure.y.title, "elevation");
    EXPECT_EQ(with_legend<Line>(figure, "ground surface").points[1], Point(0, 107));
    EXPECT_EQ(with_legend<Region>(figure, "slides").outline[0], Point(0, 107));
    const Arrows::Shaft raised = with_legend<Arrows>(figure, "thrust").shafts.at(0);
    drawing.toe_elevation = 0;
    const Figure lower = block_figure(drawing);
    EXPECT_EQ(lower.y.title, "height above the toe");
    const Arrows::Shaft shaft = with_legend<Arrows>(lower, "thrust").shafts.at(0);
    // 1e-12 m: rounding of heights of 100 m.
    EXPECT_LT((raised.from - shaft.from - Point(0, 107)).norm(), 1e-12);
    EXPECT_LT((raised.to - shaft.to - Point(0, 107)).norm(), 1e-12);
}

TEST(BlockFigure, DrawsAllForcesToTheScaleOfTheKey) {
    const BlockDrawing drawing = samples::goodman_bray_blocks();
    const Figure figure = block_figure(drawing);
    const ForceKey key = force_key(figure);
    EXPECT_EQ(key.arrow.from.y(), key.arrow.to.y());
    const double metres_per_newton = arrow_length(key.arrow) / key.force;
    double shortest = arrow_length(key.arrow);
    for (const char* legend : {"interblock force", "base reaction"}) {
        for (const Arrows::Shaft& shaft : with_legend<Arrows>(figure, legend).shafts) {
            shortest = std::min(shortest, arrow_length(shaft));
        }
    }
    EXPECT_GT(shortest, 0.1 * arrow_length(key.arrow)) << "the least can be seen";
    std::size_t count = 0;
    std::size_t to_scale = 0;
    for (const auto& [kind, legend] :
         {std::pair{ForceKind::interblock, "interblock force"}, std::pair{ForceKind::base_reaction, "base reaction"}}) {
        const std::vector<Arrows::Shaft> shafts = with_legend<Arrows>(figure, legend).shafts;
        auto shaft = shafts.begin();
        for (const DrawnForce& force : drawing.forces) {
            if (force.kind == kind) {
                ASSERT_NE(shaft, shafts.end());
                EXPECT_EQ(shaft->from, force.at);
                const double scaled = metres_per_newton * force.force.norm();
                to_scale += scaled > shortest ? 1 : 0;
                const Point drawn = std::max(scaled, shortest) * force.force.normalized();
                // Rounding of the figure's metres, some 100.
                EXPECT_LT((shaft->to - shaft->from - drawn).norm(), 1e-12);
                ++shaft;
                ++count;
            }
        }
        EXPECT_EQ(shaft, shafts.end());
    }
    EXPECT_GT(to_scale, count / 2) << "most are drawn to scale";
    EXPECT_EQ(count, drawing.forces.size());
}

TEST(BlockFigure, HasAKeyOfARoundForceForForcesOfAnySize) {
    for (const double force : {3e-3, 1.0, 47.0, 1234.0, 9.9e5, 2.1e8}) {
        BlockDrawing drawing = two_squares();
        drawing.forces = {{.at = {2, 1}, .force = {-force, 0}}, {.at = {2, 1}, .force = {0, 0.2 * force}}};
        const ForceKey key = force_key(block_figure(drawing));
        // The key is tick_step of half the greatest force: from half of it to 1.25 times.
        EXPECT_GE(key.force, 0.5 * force * (1 - 1e-9));
        EXPECT_LE(key.force, 1.25 * force * (1 + 1e-9));
        const double mantissa = key.force / std::pow(10, std::floor(std::log10(key.force * (1 + 1e-9))));
        EXPECT_TRUE(std::abs(mantissa - 1) < 1e-9 || std::abs(mantissa - 2) < 1e-9 || std::abs(mantissa - 5) < 1e-9)
            << key.force;
    }
}

// The key is beside the blocks whichever corner of the picture is free, even if none is.
TEST(BlockFigure, PutsTheKeyBesideTheBlocks) {
    constexpr double size = 10;
    const Polyline corners{{0, 0}, {size, 0}, {size, size}, {0, size}};
    for (unsigned filled = 0; filled < 16; ++filled) {
        BlockDrawing drawing{.blocks = {{.outline = {{4, 0}, {6, 0}, {6, size}, {4, size}}}}};
        for (unsigned corner = 0; corner < 4; ++corner) {
            if (filled & (1U << corner)) {
                const Point at = corners[corner] * 0.6;
                drawing.blocks.push_back({.outline = square(at.x(), at.y(), 4)});
            }
        }
        drawing.forces = {{.at = {5, 5}, .force = {0, 1e6}}};
        const Figure figure = block_figure(drawing);
        const ForceKey key = force_key(figure);
        for (const DrawnBlock& block : drawing.blocks) {
            for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0}) {
                const Point on_key = key.arrow.from + share * (key.arrow.to - key.arrow.from);
                EXPECT_FALSE(inside(block.outline, on_key)) << filled << ' ' << share;
            }
        }
        EXPECT_GT(key.arrow.from.x(), figure.x.range->first);
        EXPECT_GT(key.arrow.from.y(), figure.y.range->first);
        EXPECT_LT(key.arrow.from.y(), figure.y.range->second);
        EXPECT_LT(key.arrow.to.x(), figure.x.range->second);
    }
}

TEST(BlockFigure, ShowsEverythingWithinTheFrame) {
    for (const BlockDrawing& drawing : {samples::goodman_bray_blocks(), samples::stepped_base(),
                                        samples::single_block(), samples::row_of_columns(40)}) {
        const Figure figure = block_figure(drawing);
        Polyline points;
        for (const Arrows& arrows : all<Arrows>(figure)) {
            for (const Arrows::Shaft& shaft : arrows.shafts) {
                points.insert(points.end(), {shaft.from, shaft.to});
            }
        }
        for (const Line& line : all<Line>(figure)) {
            points.insert(points.end(), line.points.begin(), line.points.end());
        }
        for (const Label& label : figure.labels) {
            points.push_back(label.at);
        }
        for (const Point& point : points) {
            if (point.allFinite()) {
                EXPECT_GE(point.x(), figure.x.range->first) << drawing.title;
                EXPECT_LE(point.x(), figure.x.range->second) << drawing.title;
                EXPECT_GE(point.y(), figure.y.range->first) << drawing.title;
                EXPECT_LE(point.y(), figure.y.range->second) << drawing.title;
            }
        }
    }
}

TEST(BlockFigure, NumbersEveryBlockOfAFewInItsBlockAndOffTheArrows) {
    const BlockDrawing drawing = samples::goodman_bray_blocks();
    const Figure figure = block_figure(drawing);
    for (const DrawnBlock& block : drawing.blocks) {
        const auto label = std::find_if(figure.labels.begin(), figure.labels.end(),
                                        [&](const Label& candidate) { return candidate.text == block.label; });
        ASSERT_NE(label, figure.labels.end()) << block.label;
        EXPECT_TRUE(inside(block.outline, label->at)) << block.label;
        EXPECT_GE(19 * label->size, 11.9) << "px";
    }
    // The arrow runs through the middle of the first square.
    BlockDrawing crossed = two_squares();
    crossed.forces = {{.at = {1, 0.8}, .force = {0, 1e5}}};
    const Figure off = block_figure(crossed);
    const Arrows::Shaft shaft = with_legend<Arrows>(off, "interblock force").shafts.at(0);
    ASSERT_GT(shaft.to.y(), 1);
    const auto first = std::find_if(off.labels.begin(), off.labels.end(),
                                    [](const Label& candidate) { return candidate.text == "1"; });
    ASSERT_NE(first, off.labels.end());
    // Half the height of the digits is about 8 px, of 150 px to the metre.
    EXPECT_GT(std::abs(signed_distance({shaft.from, shaft.to}, first->at)), 0.04);
    EXPECT_TRUE(inside(crossed.blocks[0].outline, first->at));
}

TEST(BlockFigure, LeavesOutTheNumberOfABlockWithoutRoomForIt) {
    BlockDrawing drawing = two_squares();
    drawing.blocks.push_back({.outline = square(4, 0, 0.01), .label = "3"});
    const auto numbered = [](const Figure& figure, std::string_view text) {
        return std::any_of(figure.labels.begin(), figure.labels.end(),
                           [&](const Label& label) { return label.text == text; });
    };
    const Figure figure = block_figure(drawing);
    EXPECT_TRUE(numbered(figure, "1"));
    EXPECT_TRUE(numbered(figure, "2"));
    EXPECT_FALSE(numbered(figure, "3"));
}

BlockDrawing free_columns(int count) {
    BlockDrawing drawing = samples::row_of_columns(count);
    for (DrawnBlock& column : drawing.blocks) {
        column.mode = DrawnMode::plain;
    }
    return drawing;
}

TEST(BlockFigure, ThinsOutNumbersThatWouldTouch) {
    const auto texts = [](int columns) {
        std::vector<std::string> result;
        for (const Label& label : block_figure(free_columns(columns)).labels) {
            result.push_back(label.text);
        }
        return result;
    };
    EXPECT_EQ(texts(12).size(), 12U);
    const std::vector<std::string> forty = texts(40);
    ASSERT_EQ(forty.size(), 20U);
    EXPECT_EQ(forty[1], "3");
    const std::vector<std::string> many = texts(400);
    ASSERT_GE(many.size(), 5U);
    EXPECT_LE(many.size(), 41U);
    EXPECT_EQ(many[0], "1");
    EXPECT_EQ(std::stoi(many[1]) % 10, 0);
}

// Fixed blocks are few and at the end of the list: among the numbers none of their names would be left.
TEST(BlockFigure, NamesFixedBlocksHoweverManyNumbersGo) {
    for (const int columns : {40, 400}) {
        BlockDrawing drawing = free_columns(columns);
        for (const double x : {0.0, 0.5 * columns}) {
            drawing.blocks.push_back(
                {.outline = square(x, -0.5 * columns, 0.4 * columns), .label = "F", .mode = DrawnMode::fixed});
        }
        const std::vector<Label> labels = block_figure(drawing).labels;
        EXPECT_GE(labels.size(), 5U);
        EXPECT_LT(labels.size(), 45U);
        EXPECT_EQ(std::ranges::count(labels, std::string("F"), &Label::text), 2) << columns;
    }
}

// There are dozens of small fixed blocks beside a floor, which is the last of them.
TEST(BlockFigure, NamesTheLargestFixedBlocksFirst) {
    constexpr int columns = 400;
    BlockDrawing drawing = free_columns(columns);
    for (int block = 0; block < 100; ++block) {
        drawing.blocks.push_back({.outline = square(4.0 * block, -4, 4), .label = "F", .mode = DrawnMode::fixed});
    }
    drawing.blocks.push_back(
        {.outline = {{0, -200}, {400, -200}, {400, -4}, {0, -4}}, .label = "F", .mode = DrawnMode::fixed});
    const std::vector<Label> labels = block_figure(drawing).labels;
    EXPECT_LT(labels.size(), 100U);
    EXPECT_EQ(std::ranges::count_if(labels, [](const Label& label) { return label.text == "F" && label.at.y() < -50; }),
              1);
}

// The label of a base 0.3 m thick, whatever its slope, is beside it and on nothing else.
TEST(BlockFigure, NamesABaseTooThinForItsLabelBesideIt) {
    for (const double slope : {0.0, 0.15, 0.35, 0.6}) {
        const Point along(std::cos(slope), std::sin(slope));
        const Point normal(-along.y(), along.x());
        const auto rectangle = [&](double from, double to, double bottom, double top) {
            return Polyline{from * along + bottom * normal, to * along + bottom * normal, to * along + top * normal,
                            from * along + top * normal};
        };
        BlockDrawing drawing{
            .blocks = {{.outline = rectangle(0, 2, 0, 8), .label = "1"},
                       {.outline = rectangle(2, 4, 0, 8), .label = "2"},
                       {.outline = rectangle(-4, 12, -0.3, 0), .label = "F", .mode = DrawnMode::fixed}}};
        const Figure figure = block_figure(drawing);
        const auto label = std::ranges::find(figure.labels, std::string("F"), &Label::text);
        ASSERT_NE(label, figure.labels.end()) << slope;
        const double metres_per_px = (figure.x.range->second - figure.x.range->first) / 620;
        // The text is 15 px high and 0.66 of that wide.
        const Point half = 0.5 * 15 * metres_per_px * Point(0.66, 0.85);
        const Rectangle text{label->at - half, label->at + half};
        for (const DrawnBlock& block : drawing.blocks) {
            EXPECT_FALSE(crosses(text, closed(block.outline))) << slope;
            EXPECT_FALSE(inside(block.outline, label->at)) << slope;
        }
        // The label is near the base, whose middle is at (4, -0.15) along it and whose half length is 8 m.
        EXPECT_LT(normal.dot(label->at), -0.3) << "below";
        EXPECT_GT(normal.dot(label->at), -2.5);
        EXPECT_GT(label->at.y() - half.y(), figure.y.range->first);
    }
}

TEST(BlockFigure, LeavesOutANumberThatWouldHideAVelocity) {
    BlockDrawing drawing = two_squares();
    // A net of arrows over the first block, one corner to corner over none of the second's lower half.
    for (double at = 0.05; at < 2; at += 0.1) {
        drawing.velocities.shafts.push_back({{at, 0}, {at, 2}});
    }
    drawing.velocities.legend = "velocity";
    const Figure figure = block_figure(drawing);
    EXPECT_EQ(std::ranges::count(figure.labels, std::string("1"), &Label::text), 0);
    EXPECT_EQ(std::ranges::count(figure.labels, std::string("2"), &Label::text), 1);
    EXPECT_EQ(with_legend<Arrows>(figure, "velocity").shafts.size(), drawing.velocities.shafts.size());
}

TEST(BlockFigure, DrawsManyForcesAsChainsAsThickAsTheyAreGreat) {
    BlockDrawing drawing;
    constexpr int side = 40;
    for (int row = 0; row < side; ++row) {
        for (int column = 0; column < side; ++column) {
            drawing.blocks.push_back({.outline = square(column, row, 1)});
            drawing.forces.push_back(
                {.at = Point(column, row), .force = {0, 1e3 * (row + 1)}, .kind = ForceKind::interblock});
        }
    }
    const Figure figure = block_figure(drawing);
    EXPECT_TRUE(all<Arrows>(figure).empty());
    const Line thickest = with_legend<Line>(figure, "interblock force");
    // Lines have twenty-four widths, each right to half of their difference.
    const double px_per_newton = thickest.width / (40e3 * 23.5 / 24);
    std::size_t links = 0;
    for (const Line& line : all<Line>(figure)) {
        if (line.colour != Colour::purple) {
            continue;
        }
        for (std::size_t index = 0; index + 1 < line.points.size(); index += 3) {
            const Point middle = 0.5 * (line.points[index] + line.points[index + 1]);
            EXPECT_NEAR(line.width, px_per_newton * 1e3 * (std::round(middle.y()) + 1),
                        px_per_newton * 40e3 / 48 * 1.001);
            EXPECT_NEAR((line.points[index + 1] - line.points[index]).norm(), 1, 1e-12) << "as long as a block";
            ++links;
        }
    }
    EXPECT_EQ(links, drawing.forces.size());
    // The key is as thick and names its force.
    const auto text =
        std::ranges::find_if(figure.labels, [](const Label& label) { return label.text.ends_with(" kN/m"); });
    ASSERT_NE(text, figure.labels.end());
    const Polyline key = all<Region>(figure).back().outline;
    const double metres_per_px = (figure.x.range->second - figure.x.range->first) / 620;
    // Rounding: the drawing is as wide as the plot, 620 px.
    EXPECT_NEAR((key[3] - key[0]).norm() / metres_per_px, px_per_newton * 1e3 * std::stod(text->text), 1e-9);
    drawing.forces.resize(40);
    EXPECT_FALSE(all<Arrows>(block_figure(drawing)).empty()) << "few are arrows";
}

TEST(BlockFigure, DrawsBrokenRockBoldAndOpenJointsApart) {
    BlockDrawing drawing = two_squares();
    drawing.toe_elevation = 10;
    drawing.broken = {{{0, 1}, {2, 1}}, {{2, 0.5}, {4, 0.5}}, {{0, not_a_number}, {1, 1}}};
    drawing.open_joints = {{{2, 0}, {2, 2}}};
    const Figure figure = block_figure(drawing);
    const Line broken = with_legend<Line>(figure, "broken rock");
    // Two cracks with a gap between them; the third cannot be drawn.
    ASSERT_EQ(broken.points.size(), 5U);
    EXPECT_EQ(broken.points[0], Point(0, 11));
    EXPECT_FALSE(broken.points[2].allFinite());
    EXPECT_EQ(broken.points[4], Point(4, 10.5));
    const Line open = with_legend<Line>(figure, "open joint");
    EXPECT_NE(open.colour, broken.colour);
    EXPECT_LT(open.width, broken.width);
}

TEST(BlockFigure, LeavesOutWhatCannotBeDrawn) {
    BlockDrawing drawing = two_squares();
    drawing.blocks.push_back({.outline = {{0, 0}, {not_a_number, 1}, {1, 1}}, .label = "3", .mode = DrawnMode::fixed});
    drawing.blocks[0].outline.emplace_back(infinity, 0);
    drawing.forces = {{.at = {0, 0}, .force = {0, 0}, .kind = ForceKind::thrust},
                      {.at = {0, infinity}, .force = {1, 0}, .kind = ForceKind::thrust},
                      {.at = {0, 0}, .force = {not_a_number, 0}, .kind = ForceKind::thrust}};
    const Figure figure = block_figure(drawing);
    EXPECT_EQ(legends(figure), (std::vector<std::string>{"slides", "topples"}));
    EXPECT_TRUE(all<Arrows>(figure).empty());
    EXPECT_EQ(figure.labels.size(), 2U);

    const Figure nothing = block_figure({});
    EXPECT_TRUE(nothing.series.empty());
    EXPECT_LT(nothing.x.range->first, nothing.x.range->second);
    const Figure force_alone = block_figure({.forces = {{.at = {1, 1}, .force = {0, 5}}}});
    EXPECT_LT(force_alone.x.range->first, force_alone.x.range->second);
}

TEST(ForceAlongSlopeFigure, ShowsForcesInKilonewtonsBesideThePrintedOnes) {
    const ForceAlongSlope data = samples::goodman_bray_forces();
    const Figure figure = force_along_slope_figure(data);
    const Polyline acting = with_legend<Line>(figure, "acting force").points;
    const Polyline printed = with_legend<Points>(figure, data.printed_legend).points;
    ASSERT_EQ(acting.size(), 16U);
    ASSERT_EQ(printed.size(), 13U);
    for (const Point& point : printed) {
        const Point& computed = acting.at(static_cast<std::size_t>(point.x()) - 1);
        EXPECT_EQ(computed.x(), point.x());
        // Goodman & Bray print one decimal; that at the toe is ill-conditioned in the friction angle, 0.5 to 1.5 in the
        // literature.
        EXPECT_NEAR(computed.y(), point.y(), point.x() == 1 ? 2 : 0.06);
    }
    EXPECT_EQ(figure.y.unit, "kN/m");
    EXPECT_EQ(figure.x.ticks.size(), 16U);
}

TEST(ForceAlongSlopeFigure, ShadesRunsOfBlocksInOneMode) {
    const Figure figure = force_along_slope_figure(samples::goodman_bray_forces());
    ASSERT_EQ(all<Region>(figure).size(), 3U);
    // 1 to 3 slide, 4 to 13 topple, 14 to 16 stay.
    EXPECT_EQ(with_legend<Region>(figure, "slides").outline[1].x(), 3.5);
    EXPECT_EQ(with_legend<Region>(figure, "topples").outline[0].x(), 3.5);
    EXPECT_EQ(with_legend<Region>(figure, "topples").outline[1].x(), 13.5);
    ForceAlongSlope data{.block = {1, 2, 3, 4},
                         .acting = {1, 1, 1, 1},
                         .modes = {DrawnMode::slides, DrawnMode::plain, DrawnMode::slides, DrawnMode::slides}};
    const std::vector<Region> regions = all<Region>(force_along_slope_figure(data));
    ASSERT_EQ(regions.size(), 2U);
    EXPECT_EQ(regions[0].legend, "slides");
    EXPECT_EQ(regions[1].legend, "");
    EXPECT_EQ(regions[1].outline[0].x(), 2.5);
    EXPECT_EQ(regions[1].outline[1].x(), 4.5);
}

TEST(ForceAlongSlopeFigure, HoldsFromOneBlockToManyAndNone) {
    EXPECT_TRUE(force_along_slope_figure({}).series.empty());
    const Figure one = force_along_slope_figure({.block = {1}, .acting = {0}});
    EXPECT_EQ(one.x.ticks.size(), 1U);
    EXPECT_LT(one.y.range->first, one.y.range->second);
    ForceAlongSlope many{.block = std::vector<double>(1000), .acting = std::vector<double>(1000, 5e3)};
    std::iota(many.block.begin(), many.block.end(), 1.0);
    const Figure figure = force_along_slope_figure(many);
    EXPECT_LE(figure.x.ticks.size(), 17U);
    EXPECT_EQ(figure.x.ticks.at(0).second, "100");
}

TEST(ModeChartFigure, ShowsRegionsBoundariesAndPrintedPointsInDegrees) {
    const ModeChart chart = samples::mode_chart();
    const Figure figure = mode_chart_figure(chart);
    EXPECT_EQ(figure.x.title, "plane: dip");
    EXPECT_EQ(figure.x.unit, "deg");
    EXPECT_EQ(figure.x.range->first, 0);
    EXPECT_DOUBLE_EQ(figure.x.range->second, 60);
    std::set<std::string> shown;
    for (const Region& region : all<Region>(figure)) {
        shown.insert(region.legend);
    }
    // The others have their name inside (below).
    EXPECT_EQ(shown, (std::set<std::string>{"", "slides and topples"}));
    EXPECT_EQ(all<Line>(figure).size(), chart.boundaries.size());
    const Points printed = with_legend<Points>(figure, "A: base friction model, slides and topples");
    ASSERT_EQ(printed.points.size(), 1U);
    EXPECT_LT((printed.points[0] - Point(45, 22)).norm(), 1e-12);  // rounding
}

TEST(ModeChartFigure, NamesARegionInsideItWhereThereIsRoom) {
    const ModeChart chart = samples::mode_chart();
    const Figure figure = mode_chart_figure(chart);
    std::size_t named = 0;
    for (const ModeRegion& region : chart.regions) {
        for (const Label& label : figure.labels) {
            if (label.text == enum_names(region.mode)[static_cast<std::size_t>(region.mode)]) {
                EXPECT_TRUE(inside(region.outline, label.at * degrees(1))) << label.text;
                ++named;
            }
        }
    }
    // "slides and topples" is too long for its wedge.
    EXPECT_EQ(named, 3U);
    EXPECT_TRUE(mode_chart_figure({}).series.empty());
}

}  // namespace
}  // namespace delabole
