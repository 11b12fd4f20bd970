#include "plots/figures/figures.hpp"
#include "plots/drawing/contour.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/study_figures.hpp"
#include "samples.hpp"
#include "series_of.hpp"
#include "tests/support/no_number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace delabole {
namespace {

TEST(Text, MakesNamesHuman) {
    EXPECT_EQ(human_name("tension_crack.base_below_crest"), "tension crack: base below crest");
    EXPECT_EQ(human_unit("kN/m3"), "kN/m³");
    EXPECT_EQ(human_unit("kN m/m"), "kN m/m");
    EXPECT_EQ(human_number(0.1 + 0.2, 3), "0.3");
    EXPECT_EQ(human_number(11410, 4), "11410");
    EXPECT_EQ(human_number(-123456.7, 4), "-123500");
    EXPECT_EQ(human_number(9999.6, 4), "10000");
    EXPECT_EQ(human_number(3e9, 4), "3e+09");
    EXPECT_EQ(human_number(std::nan(""), 3), "none");
    EXPECT_EQ(human_number(-infinity, 3), "-infinite");
}

TEST(Text, WrapsBetweenWordsAndCountsLettersNotBytes) {
    EXPECT_EQ(wrapped("one two three", 7), "one two\nthree");
    EXPECT_EQ(wrapped("unbreakable", 3), "unbreakable");
    EXPECT_EQ(wrapped("φφφ φφφ", 7), "φφφ φφφ");
    EXPECT_EQ(wrapped("", 7), "");
}

TEST(Contour, OfADistanceIsACircle) {
    std::vector<double> values;
    for (int index = 0; index <= 60; ++index) {
        values.push_back(-1.5 + 0.05 * index);
    }
    Eigen::MatrixXd distance(61, 61);
    for (int row = 0; row < 61; ++row) {
        for (int column = 0; column < 61; ++column) {
            distance(row, column) =
                std::hypot(values[static_cast<std::size_t>(column)], values[static_cast<std::size_t>(row)]);
        }
    }
    const std::vector<Polyline> chains = contour_lines(values, values, distance, 1);
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_EQ(chains[0].front(), chains[0].back());
    EXPECT_NEAR(length(chains[0]), 2 * 3.14159265, 0.01);
    for (const Point& point : chains[0]) {
        EXPECT_NEAR(point.norm(), 1, 1e-3);
    }
}

TEST(Contour, EndsAtTheEdgeAndWhereThereIsNoAnswer) {
    const std::vector<double> x{0, 1, 2, 3};
    const std::vector<double> y{0, 1};
    Eigen::MatrixXd values(2, 4);
    values << 0, 0, 0, 0, 2, 2, 2, infinity;
    const std::vector<Polyline> chains = contour_lines(x, y, values, 1);
    ASSERT_EQ(chains.size(), 1U);
    EXPECT_DOUBLE_EQ(length(chains[0]), 2);
    EXPECT_TRUE(contour_lines(x, y, values, 5).empty());
    EXPECT_TRUE(contour_lines(x, x, values, 1).empty()) << "sizes do not agree";
}

TEST(Contour, KeepsTheTwoLinesOfASaddleApart) {
    Eigen::MatrixXd values(2, 2);
    values << 0, 1, 1, 0.1;
    const std::vector<Polyline> chains = contour_lines({0, 1}, {0, 1}, values, 0.5);
    ASSERT_EQ(chains.size(), 2U);
    EXPECT_EQ(broken_line(chains).size(), 5U);
}

TEST(SectionFigure, StandsOnTheToesElevation) {
    const SectionDrawing drawing = samples::section();
    const Figure figure = section_figure(drawing);
    EXPECT_TRUE(figure.equal_scales);
    EXPECT_EQ(figure.y.title, "elevation");
    const Polyline ground = with_legend<Line>(figure, "ground before the failure").points;
    ASSERT_EQ(ground.size(), drawing.ground.size());
    EXPECT_DOUBLE_EQ(ground[2].y(), 575 * 0.3048);
    EXPECT_EQ(figure.labels.size(), 4U);
    SectionDrawing lower = drawing;
    lower.toe_elevation = 0;
    EXPECT_EQ(section_figure(lower).y.title, "height above the toe");
}

TEST(SectionFigure, DrawsPressureBelowThePlaneAndNormalToIt) {
    SectionDrawing drawing;
    drawing.ground = {{0, 0}, {30, 40}, {60, 40}};
    drawing.water_pressure = {{{{0, 0}, {30, 40}}, {0, 1000}}};
    const Figure figure = section_figure(drawing);
    const Polyline outline = with_legend<Region>(figure, "water pressure").outline;
    ASSERT_EQ(outline.size(), 4U);
    EXPECT_NEAR((outline[2] - outline[1]).dot(Point(3, 4)), 0, 1e-9);
    EXPECT_GT(outline[2].x(), 30);
    EXPECT_LT(outline[2].y(), 40);
    EXPECT_EQ(outline[3], outline[0]) << "no pressure at the toe";
}

TEST(SectionFigure, OfNothingIsStillAFigure) {
    const Figure figure = section_figure({});
    EXPECT_TRUE(std::isfinite(figure.x.range->first));
    EXPECT_GT(figure.height, 0);
}

TEST(WaterFigure, MarksThePrintedStatements) {
    const Figure figure = factor_of_safety_against_water(samples::water_depth_curves());
    EXPECT_EQ(with_legend<Points>(figure, "A: printed: stable when half full, c = 0").points[0], Point(0.5, 1));
    EXPECT_EQ(all<Line>(figure).size(), 4U);
    EXPECT_EQ(figure.labels.size(), 2U) << "the statements; curves are named in the legend";
    EXPECT_EQ(factor_of_safety_against_water({}).y.range->first, 0);
}

// The plot is about 530 px wide and 290 px high, so that a letter above or below the mark would lie on a line.
TEST(MarkStatements, PutsLettersBesideTheCurves) {
    Figure figure{.x = {.range = std::pair{0.0, 53.0}}, .y = {.range = std::pair{0.0, 29.0}}};
    for (const double height : {17.0, 13.0}) {
        figure.series.emplace_back(Line{.points = {{0, height}, {53, height}}});
    }
    mark_statements({{"between two lines", {200, 15}}}, 10, 1, figure);
    ASSERT_EQ(figure.labels.size(), 1U);
    EXPECT_EQ(figure.labels[0].at.y(), 15);
    EXPECT_GT(figure.labels[0].at.x(), 20);
    EXPECT_FALSE(figure.labels[0].boxed);
}

TEST(LocusFigure, ShowsDisplayUnitsAndShadesTheLaboratory) {
    const Figure figure = failure_locus_figure(samples::failure_loci());
    EXPECT_EQ(figure.x.unit, "deg");
    EXPECT_EQ(figure.y.unit, "kPa");
    const Line dry = all<Line>(figure).front();
    EXPECT_EQ(figure.labels.front().text, "dry");
    EXPECT_TRUE(dry.legend.empty()) << "the curve bears its name itself";
    EXPECT_NEAR(dry.points[0].x(), 40, 1e-6) << "without cohesion and water friction is the dip of the plane";
    const Region band = with_legend<Region>(figure, "laboratory: apparent cohesion");
    EXPECT_DOUBLE_EQ(band.outline[0].y(), 150);
    EXPECT_DOUBLE_EQ(band.outline[2].y(), 250);
    EXPECT_EQ(band.outline[0].x(), figure.x.range->first);
}

TEST(TornadoFigure, ShowsTheEightGreatest) {
    std::vector<SensitivityBar> bars;
    for (int index = 1; index <= 12; ++index) {
        bars.push_back({"input " + std::to_string(index), "+1", 0.1 * index});
    }
    const Figure figure = tornado_figure("title", bars);
    ASSERT_EQ(figure.y.ticks.size(), 8U);
    EXPECT_NE(figure.y.ticks.front().second.find("input 12"), std::string::npos);
    EXPECT_NE(figure.y.ticks.back().second.find("input 5"), std::string::npos);
}

TEST(SectionFigure, DrawsForcesTheSmallestLongEnoughToBeSeen) {
    SectionDrawing drawing;
    drawing.ground = {{0, 0}, {30, 40}, {60, 40}};
    drawing.forces = {
        {{20, 20}, {0, -1}, 1000, "W 1000"}, {{10, 10}, {1, 0}, 10, "bolt 10"}, {{0, 0}, {1, 0}, 0, "none"}};
    drawing.measures = {{{-5, 0}, {-5, 40}, "40 m"}};
    const Figure figure = section_figure(drawing);
    const std::vector<Arrows> arrows = all<Arrows>(figure);
    ASSERT_EQ(arrows.size(), 1U);
    ASSERT_EQ(arrows[0].shafts.size(), 2U);
    const auto length = [&](std::size_t index) {
        return (arrows[0].shafts[index].to - arrows[0].shafts[index].from).norm();
    };
    EXPECT_NEAR(length(1), length(0) / 3, 1e-9);
    ASSERT_EQ(figure.arrows.size(), 1U);
    EXPECT_TRUE(figure.arrows[0].both_heads);
    EXPECT_EQ(figure.labels.size(), 3U);
}

// A note goes to the first of its places that hides nothing: not over the text of a force, not over a line.
TEST(SectionFigure, NotesKeepClear) {
    SectionDrawing drawing;
    drawing.ground = {{-10, 0}, {0, 0}, {30, 40}, {60, 40}};
    drawing.failure_plane = {{0, 0}, {40, 30}};
    drawing.forces = {{{40, 20}, {0, -1}, 1000, "W 1000"}};
    SectionNote note{{}, "bolts"};
    const Figure bare = section_figure(drawing);
    ASSERT_EQ(bare.labels.size(), 1U);
    note.places = {{bare.labels[0].at, bare.labels[0].align, bare.labels[0].raise},
                   {{20, 15}, Label::Align::centre},  // on the failure plane
                   {{59, 10}, Label::Align::left},    // over the edge
                   {{25, 5}, Label::Align::centre}};
    drawing.notes = {note};
    const Figure figure = section_figure(drawing);
    ASSERT_EQ(figure.labels.size(), 2U);
    EXPECT_EQ(figure.labels[1].at, Point(25, 5));
    // If all places hide something, a line is hidden rather than a text.
    drawing.notes[0].places.pop_back();
    EXPECT_EQ(section_figure(drawing).labels[1].at, Point(20, 15));
}

TEST(TornadoFigure, SortsBySizeAndSeparatesSigns) {
    const Figure figure =
        tornado_figure("title", {{"a", "+1", 0.1}, {"b_c", "+1 deg", -0.5}, {"d", "+1", std::nan("")}});
    ASSERT_EQ(figure.y.ticks.size(), 2U);
    EXPECT_EQ(figure.y.ticks[0], (std::pair<double, std::string>{2, "b c, +1\u00a0deg"}));
    EXPECT_EQ(figure.labels[0].text, "−0.5");
    EXPECT_EQ(figure.labels[1].text, "+0.1");
    EXPECT_EQ(with_legend<Boxes>(figure, "makes it less safe").boxes.at(0).lower_left.x(), -0.5);
    EXPECT_EQ(with_legend<Boxes>(figure, "makes it safer").boxes.at(0).upper_right.x(), 0.1);
    EXPECT_TRUE(tornado_figure("title", {}).y.ticks.empty());
    const Figure rounding = tornado_figure("title", {{"a", "+1", 0.1}, {"b", "+1", -5.3e-19}});
    EXPECT_EQ(rounding.labels[1].text, "0");
    // The number beside the only short bar to the left needs as much room as that beside a long one: 7 letters of some
    // 12 px in a picture of 720.
    const Figure short_bar = tornado_figure("title", {{"a", "+1", 0.03}, {"b", "+1", -0.0077}});
    const auto [lowest, highest] = short_bar.x.range.value();
    EXPECT_GT((-0.0077 - lowest) / (highest - lowest), 7 * 12.0 / 720 * 1.5);  // the names take a third and more
}

TEST(CriticalFigure, MarksTheLeast) {
    const CriticalSearchDrawing drawing = samples::critical_dip();
    const Figure figure = critical_figure(drawing);
    const std::vector<Points> marks = all<Points>(figure);
    ASSERT_EQ(marks.size(), 1U);
    EXPECT_NEAR(marks[0].points[0].x(), drawing.critical.x() * 180 / 3.14159265358979, 1e-9);
    CriticalSearchDrawing none = drawing;
    none.critical = {0, infinity};
    EXPECT_TRUE(all<Points>(critical_figure(none)).empty());
}

TEST(MisfitMapFigure, OverlaysRegionsLocusAndMinima) {
    const MechanismFit fit = samples::mechanism_fit();
    const Figure figure = misfit_map_figure(fit).value();
    const std::vector<HeatMap> maps = all<HeatMap>(figure);
    ASSERT_EQ(maps.size(), 1U);
    EXPECT_NEAR(maps[0].values.minCoeff(), 0, 1e-12);
    EXPECT_NEAR(maps[0].ceiling, 3 * 5.991, 1e-9);
    EXPECT_NEAR(maps[0].x_values.front(), 40, 1e-9);
    EXPECT_GT(with_legend<Line>(figure, "68 % region").points.size(), 10U);
    EXPECT_NEAR(with_legend<Line>(figure, "factor of safety 1").points[0].x(), 40, 1e-6);
    EXPECT_NEAR(with_legend<Points>(figure, "least misfit").points[0].y(), fit.best[1], 1e-12);
    EXPECT_EQ(with_legend<Points>(figure, "other minima of the starts").points.size(), 1U);
}

TEST(MisfitMapFigure, TurnsALocusThatNamesItsAxesTheOtherWayRound) {
    MechanismFit fit = samples::mechanism_fit();
    const Point expected = with_legend<Line>(misfit_map_figure(fit).value(), "factor of safety 1").points[3];
    std::swap(fit.loci[0].x, fit.loci[0].y);
    for (Point& point : fit.loci[0].points) {
        std::swap(point.x(), point.y());
    }
    EXPECT_EQ(with_legend<Line>(misfit_map_figure(fit).value(), "factor of safety 1").points[3], expected);
    fit.map.reset();
    EXPECT_FALSE(misfit_map_figure(fit).has_value());
}

TEST(ProfileFigure, ShowsBothProfilesAndOnlyTheEndsInsideTheBounds) {
    const MechanismFit fit = samples::mechanism_fit();
    const Figure figure = profile_likelihood_figure(fit, "strength.friction_angle").value();
    EXPECT_EQ(with_legend<Line>(figure, "with priors").points.size(), 61U);
    EXPECT_EQ(with_legend<Line>(figure, "data alone").points.size(), 61U);
    EXPECT_EQ(with_legend<Points>(figure, "ends of the 95 % interval").points.size(), 3U);
    EXPECT_FALSE(profile_likelihood_figure(fit, "unknown").has_value());
}

}  // namespace
}  // namespace delabole
