// [[sweep]] computed: values, crossings, statements; and every case of the thesis that is data.
#include "cases/program/sweeps/sweep_report.hpp"
#include "cases/program/thesis/thesis_tables.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace delabole {
namespace {

// A block three times as high as wide on an inclined base.
CaseFile block_with(const std::string& sweep) {
    return parse_case(R"toml(schema = 1
model = "single_block"

[block]
height = "3 m"
width = "1 m"
unit_weight = "24 kN/m3"

[base]
inclination = "10 deg"
friction_angle = "35 deg"
cohesion = "0 kPa"

[[sweep]]
name = "tilt"
)toml" + sweep,
                      "a.toml");
}

constexpr std::string_view both_tilts = R"toml(
[[sweep.vary]]
input = "base.friction_angle"
from = "10 deg"
to = "40 deg"
points = 31

[[sweep.curve]]
label = "slides"
output = "critical_sliding_inclination"

[[sweep.curve]]
label = "topples"
output = "critical_toppling_inclination"
)toml";

SweepRun run_of(const CaseFile& file, int threads = 1) {
    return run_sweep(file, file.sweeps.front(), {.threads = threads});
}

TEST(SweepRun, ValuesAreThoseOfTheModel) {
    const SweepRun run = run_of(block_with(std::string(both_tilts)), 3);
    ASSERT_EQ(run.figures.size(), 1U);
    const std::vector<SweptCurve>& curves = run.figures.front().curves;
    for (std::size_t place = 0; place < 31; ++place) {
        // Closed forms: the friction angle, and atan(b / a); a few roundings apart.
        EXPECT_NEAR(curves[0].values[place], degrees(10 + static_cast<double>(place)), 1e-14);
        EXPECT_NEAR(curves[1].values[place], std::atan(1.0 / 3), 1e-14);
        EXPECT_TRUE(curves[0].words[place].empty());
    }
}

TEST(SweepRun, CurvesMeetBetweenThePoints) {
    const SweepRun run = run_of(block_with(std::string(both_tilts) + R"toml(
[[sweep.crossing]]
label = "meet"
curve = "slides"
other = "topples"
printed = "18.43 deg"
tolerance = "0.005 deg"

[[sweep.statement]]
label = "more friction"
curve = "slides"
is = "rises"

[[sweep.statement]]
label = "it slides first"
curve = "slides"
is = "below"
other = "topples"
unreachable = "only where friction is less than atan(b/a)"
)toml"));
    ASSERT_TRUE(run.figures.front().crossings.front());
    EXPECT_NEAR(*run.figures.front().crossings.front(), std::atan(1.0 / 3), 1e-14);
    const std::vector<Comparison> rows = compare_sweep(run);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].verdict, Verdict::met);
    EXPECT_EQ(rows[1].verdict, Verdict::met);
    EXPECT_EQ(rows[2].verdict, Verdict::unreachable);
    EXPECT_EQ(rows[2].computed, "up to 18 deg");  // the last point before they meet
}

TEST(SweepRun, AWrongStatementOrCrossingIsMissed) {
    const std::vector<Comparison> rows = compare_sweep(run_of(block_with(std::string(both_tilts) + R"toml(
[[sweep.crossing]]
label = "meet"
curve = "slides"
other = "topples"
printed = "19 deg"
tolerance = "0.5 deg"

[[sweep.statement]]
label = "falls"
curve = "slides"
is = "falls"
)toml")));
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[0].verdict, Verdict::missed);
    EXPECT_EQ(rows[1].verdict, Verdict::missed);
}

// The curves meet at atan(b / a), which is 45, 26.6 and 18.4 deg.
TEST(SweepRun, CrossingsFollowEach) {
    const SweepRun run = run_of(block_with(std::string(both_tilts) + R"toml(
[[sweep.crossing]]
label = "meet"
curve = "slides"
other = "topples"

[[sweep.statement]]
label = "slender ones topple at less"
curve = "meet"
is = "falls"

[sweep.each]
input = "block.height"
values = ["1 m", "2 m", "3 m"]
)toml"));
    ASSERT_EQ(run.figures.size(), 3U);
    EXPECT_FALSE(run.figures[0].crossings.front());
    EXPECT_NEAR(run.figures[1].crossings.front().value(), std::atan(1.0 / 2), 1e-14);
    EXPECT_NEAR(run.figures[2].crossings.front().value(), std::atan(1.0 / 3), 1e-14);
    const std::vector<Comparison> rows = compare_sweep(run);
    ASSERT_EQ(rows.size(), 1U);
    EXPECT_EQ(rows.front().verdict, Verdict::met);
}

TEST(SweepRun, WhatHasNoAnswerIsSaidInAWord) {
    CaseFile file = parse_case(R"toml(schema = 1
model = "tilted_column"
joint_dip = "70 deg"
saturated_tilt = "47.5 deg"
filled_ratio = 0.5

[[sweep]]
name = "tilt"
output = "titl"

[[sweep.vary]]
input = "filled_ratio"
values = [0, 1]
)toml",
                               "a.toml");
    try {
        run_of(file);
        FAIL() << "an output that the model does not have was accepted";
    } catch (const CaseError& error) {
        EXPECT_NE(std::string(error.what()).find("is not an output of this case (did you mean tilt?)"),
                  std::string::npos)
            << error.what();
    }
    file.sweeps.front().curves.front().output = "tilt";
    EXPECT_EQ(run_of(file).figures.front().curves.front().values.size(), 2U);
}

TEST(SweepRun, TwoInputsMakeAGridWithTheFirstFastest) {
    const SweepRun run = run_of(block_with(R"toml(output = "critical_toppling_inclination"

[[sweep.vary]]
input = "block.height"
values = ["1 m", "2 m"]

[[sweep.vary]]
input = "block.width"
values = ["1 m", "2 m", "4 m"]
)toml"));
    const std::vector<double>& values = run.figures.front().curves.front().values;
    ASSERT_EQ(values.size(), 6U);
    EXPECT_NEAR(values[1], std::atan(1.0 / 2), 1e-14);
    EXPECT_NEAR(values[2], std::atan(2.0), 1e-14);
    EXPECT_EQ(json_of(run).size(), 6U);
    EXPECT_EQ(json_of(run)[5]["block.width_m"], 4);
}

// The forward mode governs up to 48.69 and 41.23 deg of base friction, given to two decimals, and not to 50 deg, where
// the printed graph ends.
TEST(ThesisAsData, Fig46ForwardModeGovernsBelowTheCrossing) {
    const CaseFile file = built_in_case("thesis/chapter_4", "fig_4_6");
    const SweepRun run = run_of(file);
    ASSERT_EQ(run.figures.front().crossings.size(), 2U);
    EXPECT_NEAR(run.figures.front().crossings[0].value() / degrees(1), 48.69, 0.005);
    EXPECT_NEAR(run.figures.front().crossings[1].value() / degrees(1), 41.23, 0.005);
    const std::vector<Comparison> rows = compare_sweep(run);
    EXPECT_EQ(std::ranges::count(rows, Verdict::unreachable, &Comparison::verdict), 2);
}

constexpr std::string_view column_in_motion = R"toml(schema = 1
model = "relaxation"

[scene]
kind = "row"
tilt = "18.5 deg"
density = "2700 kg/m3"

[scene.interface]
friction_angle = "40 deg"

[scene.base]
friction_angle = "40 deg"

[[scene.block]]
width = "1 m"
height = "3 m"

[critical]
parameter = "tilt"
lower = "10 deg"
upper = "30 deg"
tolerance = "0.005 deg"
)toml";

// A sweep may change numbers of a case that are no inputs, as --set can.
TEST(SweepRun, TakesOtherKeysOfTheCase) {
    const std::string sweep = R"toml(
[[sweep]]
name = "stiffness"
output = "critical_tilt"

[[sweep.vary]]
input = "settings.stiffness_ratio"
values = [1000, 10000]

[[sweep.curve]]
label = "as it is"

[[sweep.curve]]
label = "undamped"
with = { "settings.local_damping" = 0 }
)toml";
    const SweepRun run = run_of(parse_case(std::string(column_in_motion) + sweep, "a.toml"), 2);
    const std::vector<SweptCurve>& curves = run.figures.front().curves;
    for (const std::size_t place : {0U, 1U}) {
        const double ratio = place == 0 ? 1000 : 10000;
        // The base settles under the toe: tan = b/a - sqrt(1 + (b/a)^2) / ratio to first order, and the bracket of
        // the search is 0.005 deg wide.
        EXPECT_NEAR(std::tan(curves[0].values[place]), 1.0 / 3 - std::sqrt(10.0) / 3 / ratio, 1e-4);
        const CaseFile set =
            parse_case(column_in_motion, "a.toml", {{"settings.stiffness_ratio", std::to_string(ratio)}});
        EXPECT_EQ(curves[0].values[place], std::get<double>(analyse_model(set.model).find("critical_tilt")->value));
    }
    const CaseFile undamped =
        parse_case(column_in_motion, "a.toml", {{"settings.stiffness_ratio", "1000"}, {"settings.local_damping", "0"}});
    EXPECT_EQ(curves[1].values[0], std::get<double>(analyse_model(undamped.model).find("critical_tilt")->value));
}

// Boundaries of Fig 4.7 with equal weights, given to two decimals.
TEST(ThesisAsData, Fig46BoundariesAtNine) {
    const CaseFile file = built_in_case("thesis/chapter_4", "fig_4_6");
    const SweepRun run = run_sweep(file, file.sweeps.back(), {});
    const std::vector<double>& ratios = run.sweep.each->values;
    EXPECT_EQ(ratios.size(), 14U);
    const auto nine = static_cast<std::size_t>(std::ranges::find(ratios, 9.0) - ratios.begin());
    ASSERT_LT(nine, ratios.size());
    EXPECT_NEAR(run.figures[nine].crossings[0].value() / degrees(1), 31.42, 0.005);
    EXPECT_NEAR(run.figures[nine].crossings[1].value() / degrees(1), 24.60, 0.005);
}

}  // namespace
}  // namespace delabole
