#include "cases/program/case/model_cases.hpp"
#include "cases/program/results/analysis.hpp"
#include "kinematics/kinematics.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace delabole {
namespace {

using testing::changed;
using testing::complaint;

constexpr std::string_view sets_text = R"(schema = 1
model = "kinematics"
[slope]
face_dip = "70 deg"
face_dip_direction = "350 deg"
[strength]
friction_angle = "20 deg"
[lateral_limit]
planar_sliding = "20 deg"
flexural_toppling = "30 deg"
direct_toppling = "20 deg"
[[joint_set]]
name = "shorters"
lower_dip = "40 deg"
upper_dip = "60 deg"
first_dip_direction = "340 deg"
last_dip_direction = "10 deg"
[[joint_set]]
name = "toppling set"
dip = "85 deg"
dip_direction = "170 deg"
)";

std::string complaint_after(std::string_view from, std::string_view to) {
    return complaint(changed(sets_text, from, to));
}

TEST(KinematicsCase, ReadsRangesThroughNorthAndMeans) {
    const CaseFile file = parse_case(sets_text, "sets.toml");
    const auto& sets = std::get<KinematicsStudy>(file.model).model.joint_set;
    ASSERT_EQ(sets.size(), 2U);
    const Orientation mean = mean_orientation(sets[0]);
    EXPECT_NEAR(mean.dip, degrees(50), 1e-12);             // a rounding of 50 deg
    EXPECT_NEAR(mean.dip_direction, degrees(355), 1e-12);  // the middle of 340 to 370 deg
    EXPECT_FALSE(std::get<MeanOrientation>(sets[1].orientation).concentration);
}

TEST(KinematicsCase, RefusesValuesOutOfRange) {
    EXPECT_EQ(complaint_after("\"350 deg\"", "\"400 deg\""),
              "slope.toml:5:22: slope.face_dip_direction = \"400 deg\": must be from 0 to 360 deg");
    EXPECT_EQ(complaint_after("\"170 deg\"", "\"-10 deg\""),
              "slope.toml:21:17: joint_set[2].dip_direction = \"-10 deg\": must be from 0 to 360 deg");
    EXPECT_EQ(complaint_after("friction_angle = \"20 deg\"", "friction_angle = \"95 deg\""),
              "slope.toml:7:18: strength.friction_angle = \"95 deg\": must be at least 0 and less than 90 deg");
}

TEST(KinematicsCase, RefusesWhatContradictsItself) {
    EXPECT_EQ(complaint_after("lower_dip = \"40 deg\"", "lower_dip = \"61 deg\""),
              "slope.toml:14:13: joint_set[1].lower_dip = \"61 deg\": range is reversed: must be at most "
              "joint_set[1].upper_dip");
    EXPECT_EQ(complaint_after("toppling set", "shorters"),
              "slope.toml:19:8: joint_set[2].name = \"shorters\": names two joint sets");
    EXPECT_EQ(complaint_after("toppling set", ""), "slope.toml:19:8: joint_set[2].name = \"\": must not be empty");
    EXPECT_EQ(complaint(std::string(sets_text) + "[sampling]\nsample_count = 10.5\n"),
              "slope.toml:23:16: sampling.sample_count = 10.5: must be a whole number");
    EXPECT_EQ(complaint(std::string(sets_text) + "concentration = 50\nlower_dip = \"3 deg\"\n").substr(0, 54),
              "slope.toml:18:1: joint_set[2]: takes only one of lower");
}

TEST(KinematicsCase, RefusesTooFewAndTooManySets) {
    EXPECT_EQ(complaint(sets_text.substr(0, sets_text.find("[[joint_set]]"))),
              "slope.toml:1:1: joint_set: is required: at least one [[joint_set]], or measured [[poles]]");
    std::string many(sets_text);
    for (std::size_t set = 2; set <= most_joint_sets; ++set) {
        many +=
            "[[joint_set]]\nname = \"set " + std::to_string(set) + "\"\ndip = \"5 deg\"\ndip_direction = \"5 deg\"\n";
    }
    EXPECT_NE(complaint(many).find("joint_set: is given 31 times: at most 30"), std::string::npos) << complaint(many);
}

TEST(KinematicsCase, RefusesUnknownKeys) {
    EXPECT_EQ(complaint_after("upper_dip =", "uper_dip ="),
              "slope.toml:12:1: joint_set[1].upper_dip: is required: steepest dip (from 0 to 90 deg)\n"
              "slope.toml:15:1: joint_set[1].uper_dip: is not a key of joint_set[1] (did you mean upper_dip?)");
}

// Whatever the number of sets, the reader knows the outputs that the model has, and so converts units.
TEST(KinematicsCase, ExpectationsKnowTheOutputsOfEverySet) {
    const auto expectation = [](std::string_view quantity, std::string_view value) {
        return "[[expect]]\nquantity = \"" + std::string(quantity) + "\"\nvalue = " + std::string(value) +
               "\ntolerance = \"0.5 deg\"\n";
    };
    constexpr std::string_view critical = "joint_set[2].flexural_toppling.critical_friction_angle";
    const CaseFile file = parse_case(std::string(sets_text) + expectation(critical, "\"65 deg\""), "sets.toml");
    EXPECT_EQ(file.expectations.at(0).dimension, Dimension::angle);
    EXPECT_NE(complaint(std::string(sets_text) + expectation(critical, "\"65 m\"")), "no complaint");
    // A third set is not there, so its outputs are not known either.
    const CaseFile beyond =
        parse_case(std::string(sets_text) + expectation("joint_set[3].apparent_dip", "\"65 deg\""), "sets.toml");
    EXPECT_EQ(beyond.expectations.at(0).dimension, std::nullopt);

    const std::vector<Quantity> listed = known_outputs(file.model);
    const std::vector<Quantity> answered = interface_of(file.model).outputs;
    EXPECT_TRUE(std::ranges::equal(listed, answered, {}, &Quantity::name, &Quantity::name));
    EXPECT_TRUE(std::ranges::equal(listed, answered, {}, &Quantity::dimension, &Quantity::dimension));
}

TEST(KinematicsCase, AnswersInWordsFirstAndInDetailByName) {
    const CaseFile file = parse_case(sets_text, "sets.toml");
    const Analysis analysis = analyse_model(file.model);
    const auto word = [&](std::string_view name) { return std::get<std::string>(analysis.find(name)->value); };
    EXPECT_EQ(word("planar_sliding"), "shorters");
    EXPECT_EQ(word("wedge_sliding"), "none");
    EXPECT_EQ(word("flexural_toppling"), "toppling set");
    EXPECT_EQ(word("joint_set[2].planar_sliding.at_mean"), "does_not_daylight");
    EXPECT_EQ(word("pair[1].second"), "toppling set");
    EXPECT_EQ(word("pair[1].toppling_base"), "none");
    // Every number that a fit may ask for stands among the answers, too, but not in the short table.
    for (const Quantity& output : known_outputs(file.model)) {
        const NamedOutput* answer = analysis.find(output.name);
        ASSERT_NE(answer, nullptr) << output.name;
        EXPECT_TRUE(answer->detail && std::holds_alternative<double>(answer->value)) << output.name;
    }
    EXPECT_EQ(std::ranges::count(analysis.outputs, false, &NamedOutput::detail), 4);
}

TEST(KinematicsCase, NamesTheCheckThatAConditionBreaks) {
    const CaseFile file = parse_case(sets_text, "sets.toml");
    const Analysis analysis = analyse_model(with_conditions(file.model, {{"joint_set[1].lower_dip", degrees(61)}}));
    EXPECT_EQ(analysis.failure, "lower_dip_above_upper_dip");
    EXPECT_TRUE(analysis.outputs.empty());
}

}  // namespace
}  // namespace delabole
