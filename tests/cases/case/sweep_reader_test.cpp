// [[sweep]] as it is read, refused and written.
#include "cases/program/case/case_writer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>

namespace delabole {
namespace {

constexpr std::string_view block = R"toml(schema = 1
model = "single_block"

[block]
height = "3 m"
width = "1 m"
unit_weight = "24 kN/m3"

[base]
inclination = "10 deg"
friction_angle = "35 deg"
cohesion = "0 kPa"
)toml";

constexpr std::string_view sweep = R"toml(
[[sweep]]
name = "tilt"
title = "Tilt"
output_axis = "critical tilt"

[[sweep.vary]]
input = "block.height"
also = ["block.width"]
from = "1 ft"
to = "3 ft"
points = 5
axis = "height (ft)"
unit = "ft"

[sweep.each]
input = "base.friction_angle"
values = ["10 deg", "30 deg"]

[[sweep.curve]]
label = "topples"
output = "critical_toppling_inclination"

[[sweep.curve]]
label = "slides"
output = "critical_sliding_inclination"
dash = "dashed"
with = { "base.cohesion" = "1 kPa" }

[[sweep.crossing]]
label = "meet"
curve = "topples"
other = "slides"

[[sweep.statement]]
label = "steeper"
curve = "slides"
is = "above"
other = "topples"
unreachable = "not where it is short"

[[sweep.printed]]
label = "printed"
line = true
points = [[1, 20.5], [2, 30]]
)toml";

std::string with_sweep() {
    return std::string(block) + std::string(sweep);
}

std::string changed(const std::string& from, const std::string& to) {
    std::string text = with_sweep();
    const std::size_t place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
}

std::string complaint(const std::string& text) {
    try {
        parse_case(text, "a.toml");
    } catch (const CaseError& error) {
        return error.what();
    }
    return "none";
}

TEST(SweepSection, IsReadInSi) {
    const CaseFile file = parse_case(with_sweep(), "a.toml");
    ASSERT_EQ(file.sweeps.size(), 1U);
    const CaseSweep& read = file.sweeps.front();
    ASSERT_EQ(read.vary.size(), 1U);
    const SweptInput& height = read.vary.front();
    ASSERT_EQ(height.values.size(), 5U);
    EXPECT_DOUBLE_EQ(height.values[1], 1.5 * 0.3048);
    EXPECT_EQ(height.values.back(), 3 * 0.3048);  // the end as it was given, to the last bit
    EXPECT_DOUBLE_EQ(height.shown(height.values[1]), 1.5);
    EXPECT_EQ(height.also, std::vector<std::string>{"block.width"});
    ASSERT_TRUE(read.each);
    EXPECT_DOUBLE_EQ(read.each->values.back(), degrees(30));
    ASSERT_EQ(read.curves.size(), 2U);
    EXPECT_EQ(read.curves[1].dash, CurveDash::dashed);
    EXPECT_EQ(read.curves[1].conditions.front().value, 1e3);
    EXPECT_EQ(read.statements.front().relation, CurveRelation::above);
    EXPECT_EQ(read.printed.front().points.back(), Point(2, 30));
}

TEST(SweepSection, IsWrittenAsItWasUnderstood) {
    const std::string resolved = resolved_toml(parse_case(with_sweep(), "a.toml"));
    const CaseFile again = parse_case(resolved, "b.toml");
    EXPECT_EQ(resolved_toml(again), resolved);
    EXPECT_EQ(again.sweeps.front().vary.front().values,
              parse_case(with_sweep(), "a.toml").sweeps.front().vary.front().values);
}

TEST(SweepSection, AnOutputAloneIsACurve) {
    const CaseFile file =
        parse_case(std::string(block) +
                       "[[sweep]]\nname = \"a\"\noutput = \"factor_of_safety\"\n"
                       "vary = [{ input = \"base.inclination\", from = \"1 deg\", to = \"2 deg\" }]\n",
                   "a.toml");
    ASSERT_EQ(file.sweeps.front().curves.size(), 1U);
    EXPECT_EQ(file.sweeps.front().curves.front().output, "factor_of_safety");
    EXPECT_EQ(file.sweeps.front().vary.front().values.size(), 101U);
}

TEST(SweepSection, KeysThatAreNoInputsHaveTheirDimensionAndRange) {
    const auto text = [](const std::string& key, const std::string& values) {
        return "schema = 1\nmodel = \"relaxation\"\nscene.kind = \"row\"\nscene.tilt = \"18 deg\"\n"
               "scene.density = \"2700 kg/m3\"\nscene.interface.friction_angle = \"40 deg\"\n"
               "scene.base.friction_angle = \"40 deg\"\nscene.block = [{ width = \"1 m\", height = \"3 m\" }]\n"
               "[[sweep]]\nname = \"a\"\noutput = \"outcome\"\nvary = [{ input = \"" +
               key + "\", values = " + values + " }]\n";
    };
    const std::string duration = text("settings.duration", "[\"500 ms\", \"2 s\"]");
    const CaseFile file = parse_case(duration, "a.toml");
    EXPECT_EQ(file.sweeps.front().vary.front().values, (std::vector{0.5, 2.0}));
    EXPECT_EQ(file.sweeps.front().vary.front().dimension, Dimension::time);
    EXPECT_EQ(resolved_toml(parse_case(resolved_toml(file), "b.toml")), resolved_toml(file));
    const auto expect = [](const std::string& wrong, std::string_view words) {
        const std::string complained = complaint(wrong);
        EXPECT_NE(complained.find(words), std::string::npos) << complained;
    };
    expect(text("settings.duration", "[1, 2]"), "sweep[1].vary[1].values[1] = 1: has no unit: a time is expected");
    expect(text("settings.duration", "[\"-1 s\", \"2 s\"]"), "must be more than 0 s");
    expect(text("settings.durations", "[\"1 s\", \"2 s\"]"), "is not an input of this case");
    expect(text("settings.start", "[1, 2]"), "is not an input of this case");
}

TEST(SweepSection, MistakesHaveTheirPlaceAndReason) {
    const auto expect = [](const std::string& from, const std::string& to, std::string_view words) {
        const std::string text = complaint(changed(from, to));
        EXPECT_NE(text.find(words), std::string::npos) << from << " -> " << to << ":\n" << text;
    };
    expect("input = \"block.height\"", "input = \"block.heigth\"",
           "sweep[1].vary[1].input = \"block.heigth\": is not an input of this case (did you mean block.height?)");
    expect("from = \"1 ft\"", "from = \"4 ft\"", "the last value must be greater than the first");
    EXPECT_EQ(complaint(changed("to = \"3 ft\"", "to = \"3 kPa\"")).find("the last value"), std::string::npos);
    expect("from = \"1 ft\"", "from = \"1 kPa\"", "sweep[1].vary[1].from");
    expect("to = \"3 ft\"", "to = \"3 ft\"\nvalues = [\"1 ft\", \"2 ft\"]", "takes the place of from, to and points");
    expect("points = 5", "points = 1", "from 2 to 10001");
    expect("unit = \"ft\"", "unit = \"kPa\"", "is not a unit of block.height");
    expect("[\"10 deg\", \"30 deg\"]", "[\"30 deg\", \"10 deg\"]", "must be more than the value before");
    expect("[\"10 deg\", \"30 deg\"]", "[\"30 deg\"]", "must be a list of at least two values");
    expect("name = \"tilt\"", "name = \"../tilt\"", "must consist of at most 100 letters, digits, - and _");
    expect("other = \"slides\"", "other = \"slide\"", "is not the label of a curve (did you mean slides?)");
    expect("is = \"above\"", "is = \"over\"", "must be falls, rises, below or above");
    expect("label = \"meet\"", "label = \"meet\"\nprinted = \"1 ft\"\ntolerance = \"1 in\"", "has a printed crossing");
    expect("label = \"slides\"", "label = \"topples\"", "names two curves of the sweep");
    expect("output_axis = \"critical tilt\"", "draw = \"crossings\"\nname2 = 1", "sweep[1].name2");
    expect("curve = \"slides\"\nis = \"above\"", "curve = \"meet\"\nis = \"above\"", "is not the label of a curve");
    expect("dash = \"dashed\"", "dash = \"wavy\"", "must be solid, dashed or dotted");
    expect("points = [[1, 20.5], [2, 30]]", "points = [[1, 20.5], [2]]", "must be two numbers, [x, y]");
    expect("output = \"critical_toppling_inclination\"\n", "", "name of an output of the model");
    expect("also = [\"block.width\"]", "also = [\"block.height\"]", "\"block.height\": varies twice in the sweep");
    expect("also = [\"block.width\"]", "also = [\"base.cohesion\"]", "has another dimension than block.height");
    expect(
        "\n[[sweep.vary]]\ninput = \"block.height\"\nalso = [\"block.width\"]\nfrom = \"1 ft\"\nto = \"3 ft\"\n"
        "points = 5\naxis = \"height (ft)\"\nunit = \"ft\"\n",
        "\n", "needs one or two [[sweep.vary]]");
}

}  // namespace
}  // namespace delabole
