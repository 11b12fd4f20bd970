#include "cases/program/case/case_file.hpp"

#include "cases/program/case/case_writer.hpp"
#include "cases/program/reader/names.hpp"
#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

using testing::changed;
using testing::complaint;
using testing::example_text;
using testing::fit_complaint;
using testing::fit_text;
using testing::two_models;

TEST(FitReader, OneMechanism) {
    const CaseFile file = parse_case(std::string(example_text) + std::string(fit_text), "slope.toml");
    ASSERT_TRUE(file.fit);
    EXPECT_EQ(file.fit->settings.algorithm, Algorithm::bobyqa);
    EXPECT_EQ(file.fit->settings.starts, FitSettings{}.starts);
    ASSERT_EQ(file.fit->mechanisms.size(), 1U);
    EXPECT_EQ(file.fit->mechanisms.front().name, "plane_failure");
    ASSERT_EQ(file.fit->mechanisms.front().parameters.size(), 1U);
    EXPECT_EQ(file.fit->mechanisms.front().parameters.front().upper, degrees(45));
    ASSERT_EQ(file.fit->observations.size(), 1U);
    EXPECT_EQ(file.fit->observations.front().relation, Relation::equal);
}

TEST(FitReader, AMechanismMayBeOfAnotherModel) {
    const std::string text = std::string(example_text) + std::string(two_models);
    const CaseFile file = parse_case(text, "slope.toml");
    ASSERT_EQ(file.fit->mechanisms.size(), 2U);
    const auto& column = std::get<TiltedColumn<>>(file.fit->mechanisms[1].model);
    EXPECT_EQ(column.filled_ratio, 0.5);
    EXPECT_EQ(file.fit->mechanisms[1].parameters.front().name, "filled_ratio");
    EXPECT_EQ(complaint(changed(text, "joint_dip = \"70 deg\"\n", "")),
              "slope.toml:37:1: fit.mechanism[2].joint_dip: is required: dip of the joint that carries the water "
              "(between 0 and 90 deg (ends excluded))");
    EXPECT_EQ(complaint(changed(text, "model = \"tilted_column\"", "model = \"tilted_colum\"")),
              "slope.toml:39:9: fit.mechanism[2].model = \"tilted_colum\": must be " + choices(model_names()) +
                  " (did you mean tilted_column?)");
}

// The terms stand behind the parameter of the second mechanism, where its own tables belong.
std::string in_own_terms() {
    std::string text = std::string(example_text) + std::string(two_models);
    return text.insert(text.find("[[fit.observation]]"), std::string(testing::own_terms).substr(1));
}

TEST(FitReader, AMechanismSpeaksInItsOwnTerms) {
    const CaseFile file = parse_case(in_own_terms(), "slope.toml");
    const FitMechanism& mechanism = file.fit->mechanisms[1];
    ASSERT_EQ(mechanism.own_observations.size(), 1U);
    EXPECT_EQ(mechanism.own_observations.front().relation, Relation::at_least);
    EXPECT_EQ(mechanism.own_observations.front().value, degrees(10));
    ASSERT_EQ(mechanism.signs.size(), 1U);
    EXPECT_EQ(mechanism.signs.front().value, degrees(5));
    EXPECT_TRUE(file.fit->mechanisms[0].own_observations.empty());
    EXPECT_EQ(file.fit->settings.surrogate.runs, 50);
    EXPECT_EQ(file.fit->settings.surrogate.first_runs, 20);
    EXPECT_EQ(file.fit->settings.surrogate.tolerance, 0.05);
}

TEST(FitReader, TermsThatBelongToNothingAreErrors) {
    const std::string text = in_own_terms();
    EXPECT_NE(complaint(changed(text, "label = \"tilt\"", "label = \"tild\""))
                  .find("fit.mechanism[2].observation[1].label = \"tild\": is not the label of a [[fit.observation]]"),
              std::string::npos);
    EXPECT_NE(complaint(changed(text, "evidence = \"leaning_columns\"", "evidence = \"leaning\""))
                  .find("fit.mechanism[2].shows[1].evidence = \"leaning\": is not the name of a [[fit.evidence]]"),
              std::string::npos);
    EXPECT_NE(complaint(changed(text, "relation = \"at_least\"\nvalue = \"5 deg\"",
                                "relation = \"equal\"\nvalue = \"5 deg\""))
                  .find("fit.mechanism[2].shows[1].relation = \"equal\": must be at_least or at_most"),
              std::string::npos);
    EXPECT_NE(complaint(changed(text, "quantity = \"tilt\"\nrelation = \"at_least\"\nvalue = \"5 deg\"",
                                "quantity = \"tipt\"\nrelation = \"at_least\"\nvalue = \"5 deg\""))
                  .find("fit.mechanism[2].shows[1].quantity = \"tipt\": is not an output of the mechanism"),
              std::string::npos);
    EXPECT_NE(complaint(changed(text, "runs = 50", "runs = 5")).find("fit.surrogate.runs"), std::string::npos);
    EXPECT_NE(complaint(changed(text, "upper = 1\n", "upper = 1\nalso = [\"joint_dip\"]\n"))
                  .find("joint_dip has another dimension than filled_ratio"),
              std::string::npos);
    EXPECT_NE(complaint(changed(text, "upper = 1\n", "upper = 1\nalso = [\"joint_dib\"]\n"))
                  .find("joint_dib is not an input of this case (did you mean joint_dip?)"),
              std::string::npos);
}

TEST(FitReader, MechanismsReplaceSectionsWholly) {
    const std::string text = std::string(example_text) + R"(
[fit]
[[fit.mechanism]]
name = "given"
[[fit.mechanism.parameter]]
name = "water.water_depth"
lower = "0 m"
upper = "40 m"
[[fit.mechanism]]
name = "predicted"
title = "Geometry predicted"
[fit.mechanism.strength]
kind = "stepped_surface"
cohesion = "0 kPa"
friction_angle = "20 deg"
roughness_angle = "40 deg"
[fit.mechanism.critical]
find = "both"
under = "dry_slope"
[[fit.mechanism.parameter]]
name = "strength.roughness_angle"
lower = "0 deg"
upper = "46 deg"
prior = { mean = "40 deg", standard_deviation = "3 deg" }
[fit.profile]
points = [["0 ft", "0 ft"], ["100 ft", "75 ft"]]
standard_deviation = "5 ft"
)";
    const CaseFile file = parse_case(text, "slope.toml");
    ASSERT_EQ(file.fit->mechanisms.size(), 2U);
    const auto& given = std::get<PlaneFailureStudy<>>(file.fit->mechanisms[0].model);
    const auto& predicted = std::get<PlaneFailureStudy<>>(file.fit->mechanisms[1].model);
    EXPECT_TRUE(std::holds_alternative<Coulomb<>>(given.model.strength));
    EXPECT_FALSE(given.critical);
    EXPECT_TRUE(std::holds_alternative<SteppedSurface<>>(predicted.model.strength));
    EXPECT_TRUE(predicted.critical);
    EXPECT_TRUE(predicted.model.tension_crack);
    EXPECT_EQ(file.fit->mechanisms[1].parameters.front().prior->mean, degrees(40));
    ASSERT_TRUE(file.fit->profile);
    EXPECT_DOUBLE_EQ(file.fit->profile->profile.back().x(), 30.48);
    EXPECT_EQ(complaint(changed(text, "cohesion = \"0 kPa\"\n", "")),
              "slope.toml:40:1: fit.mechanism[2].strength.cohesion: is required: apparent cohesion (at least 0 kPa)");
    EXPECT_EQ(complaint(changed(text, "\"predicted\"", "\"given\"")),
              "slope.toml:38:8: fit.mechanism[2].name = \"given\": names two mechanisms");
    EXPECT_EQ(complaint(changed(text, "\"100 ft\", \"75 ft\"", "\"0 ft\", \"0 ft\"")),
              "slope.toml:54:10: fit.profile.points = [ ... ]: must hold at least two different points");
}

// A rival that is like another mechanism but for one value.
constexpr std::string_view rival = R"(
[[fit.mechanism]]
name = "wetter"
like = "tilting"
with = { "filled_ratio" = 0.75 }
)";

TEST(FitReader, AMechanismMayBeLikeAnother) {
    const std::string own = in_own_terms();
    const CaseFile file = parse_case(own + std::string(rival), "slope.toml");
    ASSERT_EQ(file.fit->mechanisms.size(), 3U);
    const FitMechanism& first = file.fit->mechanisms[1];
    const FitMechanism& second = file.fit->mechanisms[2];
    EXPECT_EQ(second.name, "wetter");
    EXPECT_EQ(second.title, "wetter");
    EXPECT_EQ(std::get<TiltedColumn<>>(second.model).filled_ratio, 0.75);
    EXPECT_EQ(std::get<TiltedColumn<>>(second.model).joint_dip, std::get<TiltedColumn<>>(first.model).joint_dip);
    EXPECT_EQ(second.parameters.size(), first.parameters.size());
    EXPECT_EQ(second.own_observations.size(), first.own_observations.size());
    EXPECT_EQ(second.signs.size(), first.signs.size());
    EXPECT_NE(complaint(changed(own + std::string(rival), "like = \"tilting\"", "like = \"tilding\""))
                  .find("fit.mechanism[3].like = \"tilding\": is not the name of an earlier mechanism"),
              std::string::npos);
    EXPECT_NE(complaint(changed(own + std::string(rival), "\"filled_ratio\" = 0.75", "\"bolt[1].force\" = 0.75"))
                  .find("fit.mechanism[3].with.bolt[1].force = 0.75: has no element 1 in the case"),
              std::string::npos);
    EXPECT_NE(complaint(changed(own + std::string(rival), "filled_ratio\" = 0.75", "filled_ratio\" = 2"))
                  .find("fit.mechanism[3].filled_ratio = 2: must be"),
              std::string::npos);
}

TEST(FitReader, FewMechanismsAreLikeOthers) {
    std::string text = in_own_terms();
    for (int number = 0; number < 21; ++number) {
        text += changed(std::string(rival), "wetter", "wetter_" + std::to_string(number));
    }
    EXPECT_NE(complaint(text).find("is one more than the 20 mechanisms that may be like others"), std::string::npos);
}

TEST(FitReader, Parameters) {
    EXPECT_EQ(
        fit_complaint("lower = \"20 deg\"", "lower = \"50 deg\""),
        "slope.toml:35:9: fit.parameter[1].lower = \"50 deg\": bounds are reversed: lower must not exceed upper = "
        "\"45 deg\"");
    EXPECT_EQ(fit_complaint("upper = \"45 deg\"", "upper = \"95 deg\""),
              "slope.toml:36:9: fit.parameter[1].upper = \"95 deg\": must be from 0 to 89.9 deg");
    EXPECT_EQ(fit_complaint("upper = \"45 deg\"", "upper = nan"),
              "slope.toml:36:9: fit.parameter[1].upper = nan: must be a finite number that a double can hold");
    EXPECT_EQ(fit_complaint("\"strength.friction_angle\"", "\"strength.friction_angel\""),
              "slope.toml:34:8: fit.parameter[1].name = \"strength.friction_angel\": is not an input of this case (did "
              "you mean strength.friction_angle?)");
    EXPECT_EQ(fit_complaint("[[fit.observation]]",
                            "[[fit.parameter]]\nname = \"strength.friction_angle\"\nlower = \"1 deg\"\nupper = \"2 "
                            "deg\"\n[[fit.observation]]"),
              "slope.toml:39:8: fit.parameter[2].name = \"strength.friction_angle\": is free already: each input once");
    EXPECT_EQ(fit_complaint("upper = \"45 deg\"",
                            "upper = \"45 deg\"\nprior = { mean = \"30 deg\", standard_deviation = \"0 deg\" }"),
              "slope.toml:37:49: fit.parameter[1].prior.standard_deviation = \"0 deg\": must be more than 0 deg");
}

TEST(FitReader, Posterior) {
    const std::string text = std::string(example_text) + std::string(fit_text);
    EXPECT_FALSE(parse_case(text, "slope.toml").fit->posterior);
    const CaseFile usual =
        parse_case(changed(text, "[[fit.parameter]]", "[fit.posterior]\n[[fit.parameter]]"), "a.toml");
    ASSERT_TRUE(usual.fit->posterior);
    EXPECT_EQ(usual.fit->posterior->chains, PosteriorStudy{}.chains);
    const CaseFile own = parse_case(
        changed(text, "[[fit.parameter]]",
                "[fit.posterior]\nchains = 4\ndraws = 800\nevaluations_per_chain = 9000\nevidence_points = 64\n"
                "[[fit.parameter]]"),
        "a.toml");
    EXPECT_EQ(own.fit->posterior->chains, 4);
    EXPECT_EQ(own.fit->posterior->draws, 800);
    EXPECT_EQ(own.fit->posterior->evaluations_per_chain, 9000);
    EXPECT_EQ(own.fit->posterior->evidence_points, 64);
    EXPECT_EQ(fit_complaint("[[fit.parameter]]", "[fit.posterior]\nchians = 4\n[[fit.parameter]]"),
              "slope.toml:34:1: fit.posterior.chians: is not a key of fit.posterior (did you mean chains?)");
    EXPECT_EQ(fit_complaint("[[fit.parameter]]", "[fit.posterior]\nchains = 1\n[[fit.parameter]]"),
              "slope.toml:34:10: fit.posterior.chains = 1: must be a whole number from 2 to 1000");
    EXPECT_EQ(fit_complaint("[[fit.parameter]]", "[fit.posterior]\nchains = 4\ndraws = 31\n[[fit.parameter]]"),
              "slope.toml:35:9: fit.posterior.draws = 31: must be at least 8 for each chain: 32");
    EXPECT_EQ(fit_complaint("algorithm = \"bobyqa\"", "posterior = true"),
              "slope.toml:31:13: fit.posterior = true: must be a section: [fit.posterior] and its keys");
}

TEST(FitReader, ObservationsAndSettings) {
    EXPECT_EQ(fit_complaint("standard_deviation = 0.05", "standard_deviation = 0"),
              "slope.toml:42:22: fit.observation[1].standard_deviation = 0: must be more than 0");
    EXPECT_EQ(fit_complaint("standard_deviation = 0.05", "standard_deviation = -1"),
              "slope.toml:42:22: fit.observation[1].standard_deviation = -1: must be more than 0");
    EXPECT_EQ(fit_complaint("\"factor_of_safety\"", "\"factor_of_saftey\""),
              "slope.toml:40:12: fit.observation[1].quantity = \"factor_of_saftey\": is not an output of any mechanism "
              "(did you mean factor_of_safety?)");
    EXPECT_EQ(
        fit_complaint("\"bobyqa\"", "\"boby\""),
        "slope.toml:31:13: fit.algorithm = \"boby\": must be sbplx, bobyqa, cobyla, crs2, direct_l, mlsl or isres "
        "(did you mean bobyqa?)");
    EXPECT_EQ(fit_complaint("algorithm = \"bobyqa\"", "starts = 0"),
              "slope.toml:31:10: fit.starts = 0: must be a whole number from 1 to 100000");
    EXPECT_EQ(complaint(std::string(example_text) + std::string(fit_text).substr(0, fit_text.find("[[fit.obs"))),
              "slope.toml:30:1: fit: has no observations: [[fit.observation]] or [fit.profile] is required");
    EXPECT_EQ(complaint(std::string(example_text) + "[fit]\nobservation = []\n"),
              "slope.toml:29:1: fit: has no observations: [[fit.observation]] or [fit.profile] is required\n"
              "slope.toml:29:1: fit: has nothing free: [[fit.parameter]] or [[fit.mechanism]] is required");
}

TEST(FitReader, ACoarseModelIsTheMechanismsWithItsOwnSections) {
    const auto text = [](std::string_view coarse) {
        return changed(std::string(example_text) + std::string(two_models), "filled_ratio = 0.5\n",
                       "filled_ratio = 0.5\n[fit.mechanism.coarse]\n" + std::string(coarse));
    };
    const CaseFile file = parse_case(text("joint_dip = \"60 deg\"\n"), "slope.toml");
    ASSERT_FALSE(file.fit->mechanisms[0].coarse);
    ASSERT_TRUE(file.fit->mechanisms[1].coarse);
    const auto dip_of = [](const CaseModel& model) {
        const std::vector<Quantity> inputs = named_inputs(model);
        return find_quantity(inputs, "joint_dip")->value;
    };
    EXPECT_EQ(dip_of(file.fit->mechanisms[1].model), degrees(70));
    EXPECT_EQ(dip_of(*file.fit->mechanisms[1].coarse), degrees(60));

    const CaseFile again = parse_case(resolved_toml(file), "resolved.toml");
    EXPECT_EQ(resolved_toml(again), resolved_toml(file));
    EXPECT_EQ(dip_of(*again.fit->mechanisms[1].coarse), degrees(60));

    EXPECT_NE(complaint(text("joint_dop = \"60 deg\"\n")).find("fit.mechanism[2].coarse.joint_dop"), std::string::npos);
    EXPECT_NE(complaint(text("joint_dip = \"95 deg\"\n")).find("fit.mechanism[2].coarse.joint_dip"), std::string::npos);
}

}  // namespace
}  // namespace delabole
