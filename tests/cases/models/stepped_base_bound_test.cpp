#include "cases/program/case/model_cases.hpp"
#include "cases/program/results/analysis.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

using testing::changed;
using testing::complaint;

// The upper of these two columns would topple by itself.
constexpr std::string_view columns_text = R"(schema = 1
model = "stepped_base"
title = "Two columns"
[columns]
kind = "blocks"
joint_dip = "70 deg"
[[columns.block]]
height = "2 m"
width = "1 m"
step_above = "0 m"
[[columns.block]]
height = "5 m"
width = "1 m"
step_above = "0 m"
[rock]
unit_weight = "25 kN/m3"
[joints]
friction_angle = "30 deg"
[bases]
friction_angle = "30 deg"
cohesion = "0 kPa"
[water]
kind = "dry"
[linear_programming_bound]
upper_part = 1
[linear_programming_bound.cross_joints]
spacing = "1 m"
stagger = "0.5 m"
friction_angle = "35 deg"
)";

const LinearProgrammingBound& bound_in(const CaseFile& file) {
    return *std::get<SteppedBaseStudy<>>(file.model).linear_programming_bound;
}

double number_of(const Analysis& analysis, std::string_view name) {
    const NamedOutput* output = analysis.find(name);
    return output != nullptr ? std::get<double>(output->value) : -1;
}

TEST(SteppedBaseBound, IsRead) {
    const CaseFile file = parse_case(std::string(columns_text), "case");
    EXPECT_EQ(bound_in(file).upper_part, 1);
    ASSERT_TRUE(bound_in(file).cross_joints);
    EXPECT_EQ(bound_in(file).cross_joints->stagger, 0.5);
    EXPECT_EQ(bound_in(file).cross_joints->friction_angle, degrees(35));
}

TEST(SteppedBaseBound, RefusesWhatContradictsIt) {
    EXPECT_NE(complaint(changed(columns_text, "upper_part = 1", "upper_part = 0")).find("upper_part"),
              std::string::npos);
    EXPECT_NE(complaint(changed(columns_text, "\"0.5 m\"", "\"1 m\"")).find("less than the spacing"),
              std::string::npos);
    const std::string loaded = std::string(columns_text) +
                               "[[point_load]]\nblock = 1\nforce = \"1 kN/m\"\nplunge = \"0 deg\"\nheight = \"1 m\"\n";
    EXPECT_NE(complaint(loaded).find("but the case has [[point_load]]"), std::string::npos);
}

// Whole columns may choose every force state of the recursion, and every one of cut columns.
TEST(SteppedBaseBound, LiesOnTheUnsafeSide) {
    const Analysis analysis = analyse_model(parse_case(std::string(columns_text), "case").model);
    ASSERT_EQ(analysis.failure, "");
    const double recursion = number_of(analysis, "factor_of_safety");
    const double bound = number_of(analysis, "bound.factor_of_safety");
    const double blocks = number_of(analysis, "bound.blocks.factor_of_safety");
    EXPECT_GT(recursion, 0);
    EXPECT_GE(bound, recursion);
    EXPECT_GT(blocks, 0);
    EXPECT_LE(blocks, bound * (1 + 1e-9));  // rounding of the programme
    EXPECT_EQ(number_of(analysis, "bound.body_count"), 2);
}

// A single column can only slide on its base, with the cohesion that the recursion counts too.
TEST(SteppedBaseBound, CountsTheCohesionOfTheBases) {
    const std::string second = "[[columns.block]]\nheight = \"5 m\"\nwidth = \"1 m\"\nstep_above = \"0 m\"\n";
    std::string text = changed(columns_text, second, "");
    text = changed(text, "\"0 kPa\"", "\"4 kPa\"");
    const Analysis analysis = analyse_model(parse_case(text, "case").model);
    ASSERT_EQ(analysis.failure, "");
    EXPECT_NEAR(number_of(analysis, "bound.factor_of_safety"), number_of(analysis, "factor_of_safety"), 1e-9);
}

// Columns whose tops follow the ground are no rectangles: the report says so and gives no number.
TEST(SteppedBaseBound, NamesWhyOddColumnsAreNotCut) {
    const std::string_view continuous = R"([slope]
height = "20 m"
face_dip = "65 deg"
upper_surface_dip = "5 deg"
[columns]
kind = "continuous"
joint_dip = "70 deg"
spacing = "3 m"
base_inclination = "35 deg"
[rock])";
    std::string text(columns_text);
    const std::size_t start = text.find("[columns]");
    text.replace(start, text.find("[rock]") + 6 - start, continuous);
    const Analysis analysis = analyse_model(parse_case(text, "case").model);
    ASSERT_EQ(analysis.failure, "");
    EXPECT_EQ(std::get<std::string>(analysis.find("bound.blocks.check")->value), "loads_beyond_weight");
    EXPECT_EQ(std::get<std::string>(analysis.find("bound.blocks.factor_of_safety")->value), "none");
    EXPECT_GE(number_of(analysis, "bound.factor_of_safety"), number_of(analysis, "factor_of_safety"));
    ASSERT_FALSE(analysis.warnings.empty());
    EXPECT_NE(analysis.warnings.back().find("loads_beyond_weight"), std::string::npos);
}

}  // namespace
}  // namespace delabole
