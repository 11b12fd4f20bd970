#include "cases/program/case/case_file.hpp"
#include "cases/program/case/case_writer.hpp"
#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

using testing::changed;
using testing::example_text;
using testing::expect_complaint;
using testing::two_models;

constexpr std::string_view candidates = R"(
[fit.posterior]
[[fit.candidate]]
label = "piezometer"
quantity = "water.water_depth"
standard_deviation = "2 m"
with = { "strength.friction_angle" = "30 deg" }
cost = 3
source = "a quotation"
[[fit.candidate]]
label = "tilt of a column"
quantity = ["tilt"]
standard_deviation = "1 deg"
)";

std::string text_with(std::string_view from, std::string_view to) {
    const std::string all = std::string(example_text) + std::string(two_models) + std::string(candidates);
    return from.empty() ? all : changed(all, from, to);
}

TEST(CandidatesReader, InputsAndOutputsOfAnyMechanism) {
    const CaseFile file = parse_case(text_with("", ""), "slope.toml");
    ASSERT_EQ(file.fit->candidates.size(), 2U);
    const FitCandidate& piezometer = file.fit->candidates[0];
    EXPECT_EQ(piezometer.quantities, std::vector<std::string>{"water.water_depth"});
    EXPECT_EQ(piezometer.standard_deviation, 2);
    EXPECT_EQ(piezometer.conditions.at(0).value, degrees(30));
    EXPECT_EQ(piezometer.cost, 3);
    EXPECT_EQ(file.fit->candidates[1].dimension, Dimension::angle);
    EXPECT_EQ(file.fit->candidates[1].standard_deviation, degrees(1));
}

TEST(CandidatesReader, TheResolvedCaseHoldsThem) {
    const CaseFile file = parse_case(text_with("", ""), "slope.toml");
    const CaseFile again = parse_case(resolved_toml(file), "resolved.toml");
    EXPECT_EQ(resolved_toml(again), resolved_toml(file));
    EXPECT_EQ(again.fit->candidates.at(0).source, "a quotation");
    EXPECT_EQ(again.fit->candidates.at(0).cost, 3);
}

TEST(CandidatesReader, Complaints) {
    const auto said = [](std::string_view from, std::string_view to, std::string_view words) {
        expect_complaint(text_with(from, to), words);
    };
    said("\"water.water_depth\"\nstandard_deviation = \"2 m\"", "\"water.water_deth\"\nstandard_deviation = \"2 m\"",
         "fit.candidate[1].quantity = \"water.water_deth\": is neither an output nor an input of any "
         "mechanism (did you mean water.water_depth?)");
    said("[\"tilt\"]", "[\"tilt\", \"water.water_depth\"]", "water.water_depth has another dimension than tilt");
    said("[\"tilt\"]", "[]", "fit.candidate[2].quantity = [ ... ]: is empty");
    said("\"2 m\"", "\"0 m\"", "fit.candidate[1].standard_deviation = \"0 m\": must be more than 0");
    said("\"2 m\"", "\"2 deg\"", "fit.candidate[1].standard_deviation = \"2 deg\": ");
    said("cost = 3", "cost = -1", "fit.candidate[1].cost = -1: must be more than 0");
    said("\"tilt of a column\"", "\"piezometer\"", "fit.candidate[2].label = \"piezometer\": names two candidates");
    said("[fit.posterior]\n", "", "fit.candidate");
    said("[fit.posterior]\n", "", "needs [fit.posterior]: what a measurement would tell is asked of the posterior");
}

}  // namespace
}  // namespace delabole
