// Cases of single blocks and of rows of blocks: what is refused, and what the answers are called.
#include "cases/program/case/model_cases.hpp"
#include "cases/program/results/analysis.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

using testing::changed;
using testing::complaint;

constexpr std::string_view block_text = R"(schema = 1
model = "single_block"
[block]
height = "3 m"
width = "1 m"
unit_weight = "26 kN/m3"
[base]
inclination = "25 deg"
friction_angle = "30 deg"
cohesion = "0 kPa"
[water]
unit_weight = "9.81 kN/m3"
depth_behind = "1 m"
depth_in_front = "0.5 m"
)";

constexpr std::string_view row_text = R"(schema = 1
model = "block_row"
[base]
inclination = "15 deg"
friction_angle = "30 deg"
[interface]
friction_angle = "20 deg"
[[block]]
height = "3 m"
width = "1 m"
unit_weight = "26 kN/m3"
[[block]]
height = "3 m"
width = "1 m"
weight = "78 kN/m"
)";

TEST(BlockCases, SingleBlockRefusesWaterAboveItsTop) {
    EXPECT_EQ(complaint(block_text), "no complaint");
    EXPECT_EQ(complaint(changed(block_text, "depth_behind = \"1 m\"", "depth_behind = \"4 m\"")),
              "slope.toml:13:16: water.depth_behind = \"4 m\": exceeds the height of the block, 3 m");
    EXPECT_EQ(complaint(changed(block_text, "\"0.5 m\"", "\"3.5 m\"")),
              "slope.toml:14:18: water.depth_in_front = \"3.5 m\": exceeds the height of the block, 3 m");
}

TEST(BlockCases, SingleBlockRefusesValuesOutOfRange) {
    EXPECT_EQ(complaint(changed(block_text, "\"25 deg\"", "\"90 deg\"")),
              "slope.toml:8:15: base.inclination = \"90 deg\": must be at least 0 and less than 90 deg");
    EXPECT_EQ(complaint(changed(block_text, "height = \"3 m\"", "height = \"0 m\"")),
              "slope.toml:4:10: block.height = \"0 m\": must be more than 0 and at most 1000000 m");
}

TEST(BlockCases, RowRefusesWhatCannotBe) {
    EXPECT_EQ(complaint(row_text), "no complaint");
    EXPECT_EQ(complaint(row_text.substr(0, row_text.find("[[block]]"))),
              "slope.toml:1:1: block: is required: at least one [[block]]");
    EXPECT_EQ(complaint(changed(row_text, "\"20 deg\"", "\"90 deg\"")),
              "slope.toml:7:18: interface.friction_angle = \"90 deg\": must be from 0 to 89.9 deg");
    EXPECT_EQ(complaint(changed(row_text, "weight = \"78 kN/m\"", "weight = \"-78 kN/m\"")),
              "slope.toml:15:10: block[2].weight = \"-78 kN/m\": must be more than 0 kN/m");
    EXPECT_NE(complaint(std::string(row_text) + "unit_weight = \"26 kN/m3\"\n").find("block[2]"), std::string::npos);
}

TEST(BlockCases, NamesTheCheckThatAConditionBreaks) {
    const CaseFile file = parse_case(block_text, "block.toml");
    EXPECT_EQ(analyse_model(with_conditions(file.model, {{"block.height", 0.8}})).failure, "water_above_block");
}

TEST(BlockCases, EveryModeOfARowAnswersByItsLetters) {
    const Analysis analysis = analyse_model(parse_case(row_text, "row.toml").model);
    const auto word = [&](std::string_view name) { return std::get<std::string>(analysis.find(name)->value); };
    EXPECT_EQ(word("mode"), "P0");
    EXPECT_EQ(word("mode_in_contact"), "FP");
    EXPECT_EQ(word("mode.FB.admissibility"), "over_determined");
    EXPECT_EQ(std::get<double>(analysis.find("mode.FP.critical_tilt")->value),
              std::get<double>(analysis.find("critical_tilt_in_contact")->value));
    EXPECT_NE(analysis.find("block[2].normal_force"), nullptr);
}

// Answers of long rows do not list thousands of modes, and give the roles in a form that can be read.
TEST(BlockCases, LongRowsAreSummarised) {
    CaseFile file = parse_case(row_text, "row.toml");
    auto& row = std::get<BlockRow>(file.model);
    row.block.assign(1000, row.block.front());
    const Analysis analysis = analyse_model(file.model);
    EXPECT_EQ(std::get<std::string>(analysis.find("search")->value), "bounded");
    EXPECT_EQ(std::get<std::string>(analysis.find("mode")->value), "P and 0 × 999");
    EXPECT_EQ(analysis.warnings.size(), 1U);
    EXPECT_LT(analysis.outputs.size(), 2000U);
}

}  // namespace
}  // namespace delabole
