// Figures and tables in feet and kips.
#include "plots/report/shown_units.hpp"

#include "fitting/work/words.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

constexpr double foot = 0.3048;

class ShownUnits : public testing::Test {
  protected:
    void TearDown() override { show_units_in(UnitSystem::metric); }
};

Figure section() {
    Figure figure;
    figure.x = {.title = "distance", .unit = "m", .range = std::pair{0.0, 30.48}};
    figure.y = {.title = "stress", .unit = "kPa"};
    figure.series = {Line{.points = {{foot, 47.88025898}}}, Region{.outline = {{2 * foot, 0}}}};
    figure.labels = {{.at = {3 * foot, 0}, .text = "here"}};
    return figure;
}

TEST_F(ShownUnits, MetricFiguresStayAsTheyAre) {
    const Figure figure = in_shown_units(section());
    EXPECT_EQ(figure.x.unit, "m");
    EXPECT_EQ(std::get<Line>(figure.series[0]).points[0].x(), foot);
}

TEST_F(ShownUnits, AxesAndAllThatIsDrawnOverThemAreConverted) {
    show_units_in(UnitSystem::imperial);
    const Figure figure = in_shown_units(section());
    EXPECT_EQ(figure.x.unit, "ft");
    EXPECT_EQ(figure.y.unit, "ksf");
    EXPECT_DOUBLE_EQ(figure.x.range->second, 100);
    const Point point = std::get<Line>(figure.series[0]).points[0];
    EXPECT_DOUBLE_EQ(point.x(), 1);
    EXPECT_NEAR(point.y(), 1, 1e-9);  // digits of the factor written above
    EXPECT_DOUBLE_EQ(std::get<Region>(figure.series[1]).outline[0].x(), 2);
    EXPECT_DOUBLE_EQ(figure.labels[0].at.x(), 3);
}

TEST_F(ShownUnits, ColumnsOfTablesAreConvertedWordsStay) {
    show_units_in(UnitSystem::imperial);
    Report report;
    report.add(Folded{
        "all", {Table{"", {{"height, m"}, {"area, m²"}, {"name"}}, {{"3.048", "infinite", "3.048"}, {"30.48", "1"}}}}});
    const Report shown = in_shown_units(report);
    const auto& table = std::get<Table>(std::get<Folded>(shown.blocks[0]).blocks[0]);
    EXPECT_EQ(table.columns[0].title, "height, ft");
    EXPECT_EQ(table.columns[1].title, "area, ft²");
    EXPECT_EQ(table.rows[0], (std::vector<std::string>{"10", "infinite", "3.048"}));
    EXPECT_EQ(table.rows[1], (std::vector<std::string>{"100", "10.764"}));
}

// Definitions of the foot and the pound, and standard gravity.
TEST_F(ShownUnits, SentencesToo) {
    EXPECT_EQ(value_in_words(304.8, Dimension::length), "305 m");
    show_units_in(UnitSystem::imperial);
    EXPECT_EQ(value_in_words(304.8, Dimension::length), "1000 ft");
    const double pound = 0.45359237 * 9.80665;
    const double kip = 1000 * pound;
    const auto unit = [](Dimension dimension) { return shown_unit(dimension).si_per_unit; };
    EXPECT_DOUBLE_EQ(unit(Dimension::force_per_length), kip / foot);
    EXPECT_DOUBLE_EQ(unit(Dimension::stress), kip / (foot * foot));
    EXPECT_DOUBLE_EQ(unit(Dimension::unit_weight), pound / std::pow(foot, 3));
    EXPECT_DOUBLE_EQ(unit(Dimension::density), 0.45359237 / std::pow(foot, 3));
    EXPECT_DOUBLE_EQ(unit(Dimension::moment_per_length), kip);
    EXPECT_DOUBLE_EQ(unit(Dimension::energy_per_length), pound);
    EXPECT_DOUBLE_EQ(unit(Dimension::angle), degrees(1)) << "degrees are degrees";
}

}  // namespace
}  // namespace delabole
