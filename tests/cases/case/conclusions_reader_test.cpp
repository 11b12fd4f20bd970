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

constexpr std::string_view conclusions = R"toml(
[[fit.conclusion]]
label = "(i)"
statement = "columns tilt"
source = "2.4.2"
note = "as drawn"
[[fit.conclusion.test]]
claim = "tilting it was"
probability_of = ["tilting"]
value = 0.9
[[fit.conclusion.test]]
claim = "water tilts them"
mechanism = "tilting"
quantity = "tilt"
with = { "filled_ratio" = 1.0 }
compared_with = {}
relation = "at_most"
value = "-5 deg"
[[fit.conclusion.test]]
claim = "fewer tilt when half dry"
mechanism = "tilting"
quantity = "tilt"
compared_with = { "filled_ratio" = 0.25 }
value = "1 deg"
[[fit.conclusion]]
label = "(ii)"
statement = "none has a say in this"
)toml";

std::string conclusion_text_with(std::string_view from, std::string_view to) {
    const std::string all = std::string(example_text) + std::string(two_models) + std::string(conclusions);
    return from.empty() ? all : changed(all, from, to);
}

TEST(ConclusionsReader, ClaimsOfMechanismsAndOfQuantities) {
    const CaseFile file = parse_case(conclusion_text_with("", ""), "slope.toml");
    ASSERT_EQ(file.fit->conclusions.size(), 2U);
    const Conclusion& first = file.fit->conclusions[0];
    EXPECT_EQ(first.label, "(i)");
    EXPECT_EQ(first.note, "as drawn");
    ASSERT_EQ(first.tests.size(), 3U);
    EXPECT_EQ(std::get<ClaimOfMechanisms>(first.tests[0].of).mechanisms, std::vector<std::string>{"tilting"});
    EXPECT_EQ(first.tests[0].limit, 0.9);
    EXPECT_EQ(first.tests[0].relation, Relation::at_least);
    const auto& water = std::get<ClaimOfQuantity>(first.tests[1].of);
    EXPECT_EQ(water.conditions.at(0).value, 1);
    ASSERT_TRUE(water.against.has_value());
    EXPECT_TRUE(water.against->empty());
    EXPECT_EQ(first.tests[1].relation, Relation::at_most);
    EXPECT_EQ(first.tests[1].limit, degrees(-5));
    EXPECT_EQ(first.tests[1].dimension, Dimension::angle);
    EXPECT_EQ(std::get<ClaimOfQuantity>(first.tests[2].of).against->at(0).value, 0.25);
    EXPECT_TRUE(file.fit->conclusions[1].tests.empty());
}

TEST(ConclusionsReader, TheResolvedCaseHoldsThem) {
    const CaseFile file = parse_case(conclusion_text_with("", ""), "slope.toml");
    const CaseFile again = parse_case(resolved_toml(file), "resolved.toml");
    EXPECT_EQ(resolved_toml(again), resolved_toml(file));
    const auto& water = std::get<ClaimOfQuantity>(again.fit->conclusions.at(0).tests.at(1).of);
    EXPECT_TRUE(water.against && water.against->empty());
    EXPECT_EQ(water.conditions.at(0).input, "filled_ratio");
}

TEST(ConclusionsReader, Complaints) {
    const auto said = [](std::string_view from, std::string_view to, std::string_view words) {
        expect_complaint(conclusion_text_with(from, to), words);
    };
    said("[\"tilting\"]", "[\"titling\"]",
         "fit.conclusion[1].test[1].probability_of = [ ... ]: titling is not a mechanism of this case (did you mean "
         "tilting?)");
    said("value = 0.9", "value = 1.2", "fit.conclusion[1].test[1].value = 1.2: must be");
    said("mechanism = \"tilting\"\nquantity = \"tilt\"\nwith", "mechanism = \"sliding\"\nquantity = \"tilt\"\nwith",
         "fit.conclusion[1].test[2].quantity = \"tilt\": is not an output of the mechanism");
    said("{ \"filled_ratio\" = 0.25 }", "{ \"filled_ration\" = 0.25 }",
         "fit.conclusion[1].test[3].compared_with.filled_ration: is not an input of this case (did you mean "
         "filled_ratio?)");
    said("{ \"filled_ratio\" = 0.25 }", "{ \"filled_ratio\" = 2.5 }",
         "fit.conclusion[1].test[3].compared_with.filled_ratio = 2.5: must be");
    said("\"-5 deg\"", "\"-5 m\"", "fit.conclusion[1].test[2].value = \"-5 m\": ");
    said("\"at_most\"", "\"equal\"", "fit.conclusion[1].test[2].relation = \"equal\": ");
    said("probability_of = [\"tilting\"]", "probability_of = [\"tilting\"]\nquantity = \"tilt\"",
         "fit.conclusion[1].test[1]: takes only one of probability_of or mechanism with quantity");
    said("probability_of = [\"tilting\"]", "probability_of = [\"tilting\"]\nmechanism = \"tilting\"",
         "fit.conclusion[1].test[1]: takes only one of probability_of or mechanism with quantity");
    said("probability_of = [\"tilting\"]\n", "",
         "fit.conclusion[1].test[1]: needs one of probability_of or mechanism with quantity");
    said("claim = \"tilting it was\"\n", "", "fit.conclusion[1].test[1].claim: is required");
    said("label = \"(ii)\"", "label = \"(i)\"", "fit.conclusion[2].label = \"(i)\": names two conclusions");
}

}  // namespace
}  // namespace delabole
