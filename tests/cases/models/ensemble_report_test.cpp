// The report of an ensemble tells the slope as drawn from the mean of all, how many fail, and what has no effect.
#include "cases/program/models/relaxation/ensemble_report.hpp"
#include "cases/program/case/case_file.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace delabole {
namespace {

using testing::changed;
using testing::complaint;

// A block on a plane at 35 deg. With friction of 40 deg and deviations from it the factors of safety of the six slopes,
// tan(friction angle) / tan(35 deg), are 1.1984, 1.0607, 1.2902, 1.1619, 0.9633 and 1.2460, of which the mean
// is 1.1534.
constexpr std::string_view slopes_text = R"(schema = 1
model = "relaxation"
[scene]
kind = "jointed_slope"
intact_joint = "intact"
outline = [{ x = "-10 m", y = "-6 m" }, { x = "30 m", y = "-6 m" }, { x = "30 m", y = "12 m" }, { x = "6.928203 m", y = "12 m" }, { x = "0 m", y = "0 m" }, { x = "-10 m", y = "0 m" }]
rock = [{ name = "rock", density = "2650 kg/m3" }]
joint = [{ name = "plane", friction_angle = "40 deg" }, { name = "intact", friction_angle = "45 deg", cohesion = "5 MPa", tensile_strength = "5 MPa" }]
frame = { sides = "all_around", thickness = "3 m", joint = "plane" }
[[scene.cut]]
name = "plane"
joint = "plane"
trace = { kind = "line", vertex = [{ x = "0.288675 m", y = "0.5 m" }, { x = "16.712377 m", y = "12 m" }] }
[settings]
stop = "onset"
[critical]
parameter = "strength_reduction"
tolerance = 0.001
lower = 1
upper = 3
[ensemble]
runs = 6
friction_deviation = "3 deg"
)";

RelaxationStudy slopes_study(const std::string& text) {
    return std::get<RelaxationStudy>(parse_case(text, "case").model);
}

bool tells_of(const Analysis& analysis, std::string_view of) {
    return std::ranges::any_of(analysis.warnings,
                               [&](const std::string& warning) { return warning.find(of) != std::string::npos; });
}

double number_named(const Analysis& analysis, std::string_view name) {
    return std::get<double>(analysis.find(name)->value);
}

TEST(EnsembleReport, TellsTheSlopeAsDrawnFromTheMeanAndCountsThoseThatFail) {
    const RelaxationStudy study = slopes_study(std::string(slopes_text));
    const RelaxationStudyAnswer answer = analyse_case(study, {});
    const HeadCard head = head_card(study, answer);
    EXPECT_EQ(head.sentences[0], "FS 1.2 as drawn, by strength reduction: stands.");
    EXPECT_EQ(head.sentences[1],
              "The mean of the ensemble is FS 1.16 or less; 1 of its 6 slopes fails at the given strength.");
    EXPECT_EQ(head.tone, AnswerTone::open);
    const Analysis analysis = named_outputs(study, answer);
    EXPECT_EQ(analysis.status, "ok");
    // The fifth slope is taken at 1, and not at 0.9633. Brackets are 0.001 wide, and blocks settle on stiff contacts.
    EXPECT_NEAR(number_named(analysis, "factor_of_safety"), 1.1534 + (1 - 0.9633) / 6, 0.002);
    EXPECT_DOUBLE_EQ(number_named(analysis, "ensemble_failing_share"), 1.0 / 6);
    EXPECT_TRUE(
        tells_of(analysis, "1 of the 6 slopes of the ensemble fails even at critical.lower, 1, and is taken at it"));
}

TEST(EnsembleReport, WithoutASearchSaysHowManyRunsFail) {
    std::string text(slopes_text);
    const std::size_t search = text.find("[critical]");
    text.erase(search, text.find("[ensemble]") - search);
    const RelaxationStudy study = slopes_study(text);
    EXPECT_EQ(head_card(study, analyse_case(study, {})).sentences[1],
              "This is the slope as drawn; 1 of the ensemble's 6 slopes fails at the given strength.");
}

// The slope as drawn stands at the greatest factor tried, 1.15, as three others do. One fails at the least.
TEST(EnsembleReport, HasMeansAlthoughTheSearchOfTheSlopeAsDrawnEndedAtABound) {
    const RelaxationStudy study = slopes_study(changed(slopes_text, "upper = 3", "upper = 1.15"));
    const RelaxationStudyAnswer answer = analyse_case(study, {});
    EXPECT_EQ(head_card(study, answer).sentences[0],
              "No factor of safety found as drawn: the blocks stand even at 1.15: raise critical.upper.");
    const Analysis analysis = named_outputs(study, answer);
    EXPECT_EQ(analysis.status, "ok");
    EXPECT_EQ(number_named(analysis, "ensemble_at_lower"), 1);
    EXPECT_EQ(number_named(analysis, "ensemble_at_upper"), 4);
    EXPECT_TRUE(tells_of(analysis, "is neither at most nor at least what is given"));
    EXPECT_TRUE(tells_of(analysis, "as drawn, the blocks stand even at 1.15: raise critical.upper"));
    const RelaxationStudy all_stand =
        slopes_study(changed(changed(slopes_text, "upper = 3", "upper = 0.9"), "lower = 1", "lower = 0.5"));
    EXPECT_EQ(named_outputs(all_stand, analyse_case(all_stand, {})).status, "stands_everywhere");
}

TEST(EnsembleReport, WhatHasNoEffectIsRefusedOrTold) {
    const auto has = [](const std::string& text, std::string_view part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(has(complaint(changed(slopes_text, "friction_deviation = \"3 deg\"", "spacing_deviation = 0.3")),
                    "no [[scene.cut]] is a joint set"));
    EXPECT_TRUE(has(complaint(changed(slopes_text, "friction_deviation = \"3 deg\"", "")), "all the same"));
    std::string text =
        changed(slopes_text, "friction_angle = \"40 deg\"", "friction_angle = \"40 deg\", water_share = 0.5");
    text.erase(text.find("[critical]"));
    EXPECT_TRUE(tells_of(analyse_model(slopes_study(text)), "scene.joint[1].water_share (plane) has no effect"));
}

}  // namespace
}  // namespace delabole
