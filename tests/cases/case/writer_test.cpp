#include "cases/program/case/case_writer.hpp"
#include "cases/program/case/starting_cases.hpp"
#include "cases/program/reader/described_reader.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <stdexcept>

namespace delabole {
namespace {

using testing::changed;
using testing::example_text;
using testing::two_models;

void expect_same_model(const CaseModel& first, const CaseModel& second) {
    const std::vector<Quantity> one = named_inputs(first);
    const std::vector<Quantity> other = named_inputs(second);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t index = 0; index < one.size(); ++index) {
        EXPECT_EQ(one[index].name, other[index].name);
        EXPECT_EQ(one[index].value, other[index].value) << one[index].name;
    }
}

// Removes the comment sign from every line that holds TOML in the further parts of a template.
std::string uncommented(const std::string& text, std::string_view from) {
    std::string result = text.substr(0, text.find(from));
    std::istringstream lines(text.substr(text.find(from)));
    for (std::string line; std::getline(lines, line);) {
        result += (line.starts_with("# ") ? line.substr(2) : line) + "\n";
    }
    return result;
}

void expect_round_trip(const std::string& text) {
    const CaseFile first = parse_case(text, "first");
    const std::string resolved = resolved_toml(first);
    SCOPED_TRACE(resolved);
    const CaseFile second = parse_case(resolved, "second");
    expect_same_model(first.model, second.model);
    EXPECT_EQ(resolved, resolved_toml(second));
    EXPECT_EQ(case_hash(first), case_hash(second));
    EXPECT_EQ(first.sources, second.sources);
    ASSERT_EQ(first.expectations.size(), second.expectations.size());
    ASSERT_EQ(first.fit.has_value(), second.fit.has_value());
    if (!first.fit) {
        return;
    }
    ASSERT_EQ(first.fit->mechanisms.size(), second.fit->mechanisms.size());
    for (std::size_t index = 0; index < first.fit->mechanisms.size(); ++index) {
        const FitMechanism& one = first.fit->mechanisms[index];
        const FitMechanism& other = second.fit->mechanisms[index];
        expect_same_model(one.model, other.model);
        EXPECT_EQ(one.title, other.title);
        ASSERT_EQ(one.parameters.size(), other.parameters.size());
        for (std::size_t parameter = 0; parameter < one.parameters.size(); ++parameter) {
            EXPECT_EQ(one.parameters[parameter].lower, other.parameters[parameter].lower);
            EXPECT_EQ(one.parameters[parameter].upper, other.parameters[parameter].upper);
        }
    }
    ASSERT_EQ(first.fit->profile.has_value(), second.fit->profile.has_value());
    if (first.fit->profile) {
        EXPECT_EQ(first.fit->profile->profile, second.fit->profile->profile);
    }
}

TEST(Writer, RoundTripOfAwkwardNumbers) {
    std::string text = changed(example_text, "\"225 ft\"", "\"224.99999999999997 ft\"");
    text = changed(text, "\"30 deg\"", "\"0.123456789012345678 rad\"");
    text = changed(text, "\"26 kN/m3\"", "\"165.3 lbf/ft3\"");
    text = changed(text, "\"Example\"", "\"quotes \\\" and \\\\ and \\u0001 and ü\"");
    expect_round_trip(text);
}

TEST(Writer, RoundTripOfMechanisms) {
    const std::string text = std::string(example_text) + R"(
[[bolt]]
force = "400 kN/m"
plunge = "10 deg"
head_height = "5 m"
action = "passive"
[sources]
"slope.height" = "map"
[[expect]]
quantity = "outcome"
value = "slides"
[[expect]]
quantity = "crack_depth"
value = "158 ft"
tolerance = "1 ft"
with = { "water.water_depth" = "3.3 ft" }
unreachable = "misprint"
[fit]
seed = 7
[[fit.mechanism]]
name = "one"
bolt = []
[fit.mechanism.tension_crack]
dip = "80 deg"
distance_behind_crest = "10 ft"
[[fit.mechanism.parameter]]
name = "slope.height"
lower = "200 ft"
upper = "250 ft"
[[fit.mechanism]]
name = "two"
[fit.mechanism.water]
kind = "piezometric_line"
unit_weight = "62.4 lbf/ft3"
[[fit.mechanism.water.point]]
x = "0 ft"
y = "1 ft"
[[fit.mechanism.parameter]]
name = "strength.cohesion"
lower = "0 psi"
upper = "40 psi"
prior = { mean = "30 psi", standard_deviation = "3 psi", source = "tests" }
[[fit.observation]]
label = "dip"
quantity = "plane_dip"
relation = "at_most"
value = "42 deg"
standard_deviation = "1.3 deg"
with = { "water.unit_weight" = "1 kPa/m" }
[fit.profile]
points = [["0 ft", "0 ft"], ["100.1 ft", "75.7 ft"]]
standard_deviation = "5 ft"
[[fit.evidence]]
name = "cracks"
statement = "seen"
)";
    expect_round_trip(text);
    const CaseFile file = parse_case(text, "case");
    EXPECT_TRUE(std::get<PlaneFailureStudy<>>(file.fit->mechanisms[0].model).model.bolt.empty());
    EXPECT_EQ(std::get<PlaneFailureStudy<>>(file.fit->mechanisms[1].model).model.bolt.size(), 1U);
}

TEST(Writer, HashIgnoresLayoutAndUnits) {
    const std::string same = "# a comment\n" + changed(example_text, "\"40 m\"", "\"4000 cm\"");
    const std::string other = changed(example_text, "\"40 m\"", "\"40.1 m\"");
    const auto hash = [](std::string_view text) { return case_hash(parse_case(text, "case")); };
    EXPECT_EQ(hash(example_text), hash(same));
    EXPECT_NE(hash(example_text), hash(other));
    EXPECT_EQ(hash(example_text).size(), 16U);
}

TEST(Writer, RoundTripOfMechanismsOfTwoModels) {
    expect_round_trip(std::string(example_text) + std::string(two_models));
    std::string own = std::string(example_text) + std::string(two_models);
    own.insert(own.find("[[fit.observation]]"), std::string(testing::own_terms).substr(1));
    expect_round_trip(own);
}

TEST(Template, IsACaseOfEachModel) {
    for (const std::string& model : model_names()) {
        const std::string text = commented_template(model);
        SCOPED_TRACE(text);
        EXPECT_NO_THROW(expect_round_trip(text));
        EXPECT_EQ(model_name(parse_case(text, "template").model), model);
        EXPECT_NO_THROW(parse_case(
            uncommented(text, text.find("# [sources]") == std::string::npos ? "# [[expect]]" : "# [sources]"), "all"));
    }
    EXPECT_THROW(commented_template("wedge_row"), std::invalid_argument);
}

// A jointed slope that is asked for by name is active in its template, and not a comment in another scene.
TEST(Template, OfAJointedSlopeIsOne) {
    const CaseFile file = parse_case(commented_template("jointed_slope"), "template");
    const auto& slope = std::get<RelaxationSlope>(std::get<RelaxationStudy>(file.model).model.scene);
    const CaseFile started = parse_case(starting_case("jointed_slope"), "started");
    EXPECT_EQ(slope.geometry, std::get<RelaxationSlope>(std::get<RelaxationStudy>(started.model).model.scene).geometry);
    EXPECT_EQ(file.title, "My jointed slope");
}

void expect_valid_sections(std::string_view model, const std::vector<std::string_view>& sections) {
    const std::string text = commented_template(model);
    for (const std::string_view section : sections) {
        const std::size_t start = text.find(section);
        ASSERT_NE(start, std::string::npos) << section << "\n" << text;
        const std::size_t end = text.find("\n\n", start);
        const std::string part = uncommented(text.substr(start, end - start), section);
        EXPECT_NO_THROW(parse_case(text + part, "template")) << part;
    }
}

// Each optional section alone must be valid once its comment signs are taken away.
TEST(Template, OptionalSectionsAreValid) {
    expect_valid_sections("plane_failure",
                          {"# [slope.bench]", "# [tension_cutoff]", "# [pond]", "# [seismic]", "# [[surcharge]]",
                           "# [[line_load]]", "# [[bolt]]", "# [[support]]", "# [critical]", "# [[required]]"});
    expect_valid_sections("stepped_base",
                          {"# [slope.bench]", "# [seismic]", "# [[surcharge]]", "# [[line_load]]", "# [[point_load]]",
                           "# [[bolt]]", "# [[support]]", "# [slide_head.water]", "# [critical]", "# [[required]]",
                           "# [[required_cable]]", "# [linear_programming_bound]"});
    expect_valid_sections("relaxation",
                          {"# [tilting]", "# [[force]]", "# [[pressure]]", "# [[joint_water]]", "# [[shaking]]",
                           "# [[removal]]", "# [[bolt]]", "# [settings]", "# [critical]", "# [history]"});
    expect_valid_sections("kinematics", {"# [slope.upper_surface]", "# [sampling]"});
    expect_valid_sections("wedge", {"# [seismic]", "# [[load]]", "# [[bolt]]", "# [[required]]"});
}

// Cross joints need columns without loads, but the sections above give the columns loads.
TEST(Template, CrossJointsAreValidInDryColumnsWithoutALoad) {
    const std::string text = commented_template("stepped_base");
    const auto without = [](std::string remaining, const std::string& section) {
        const std::size_t start = remaining.find("\n" + section);
        return remaining.erase(start, remaining.find("\n\n", start) - start);
    };
    const std::string bare = without(without(text, "[water]"), "[slide_head]") + "\n[water]\nkind = \"dry\"\n";
    const std::size_t start = text.find("# [linear_programming_bound]");
    const std::string once = uncommented(text.substr(start, text.find("\n\n", start) - start), "#");
    const std::string twice = uncommented(once, "#\n");
    ASSERT_NE(twice.find("\nstagger = "), std::string::npos) << twice;
    EXPECT_NO_THROW(parse_case(bare + twice, "template")) << twice;
}

TEST(Template, NamesEveryKind) {
    const std::string text = commented_template("plane_failure");
    for (const std::string_view word :
         {"coulomb", "stepped_surface", "patton_bilinear", "barton_bandis", "power_curve", "dry", "crack_and_base",
          "crack_only", "base_peak_mid_height", "peak_at_toe", "piezometric_line", "custom", "distance_behind_crest",
          "base_elevation", "toe_elevation", "water_elevation", "more than 0 and at most 1000000 m",
          "at least 0 kPa"}) {
        EXPECT_NE(text.find(word), std::string::npos) << word;
    }
}

template <class Type>
void collect_keys(std::set<std::string>& keys) {
    if constexpr (is_optional<Type> || is_vector<Type>) {
        collect_keys<typename Type::value_type>(keys);
    } else if constexpr (is_variant<Type>) {
        detail::for_each_alternative<Type>([&]<std::size_t, class One>() { collect_keys<One>(keys); });
    } else if constexpr (Described<Type>) {
        const Type object{};
        visit_fields(object, [&]<class Member>(const FieldInfo& info, const Member&) {
            keys.emplace(info.key);
            collect_keys<Member>(keys);
        });
    }
}

// Each optional section of a study stands in the template, with all its keys.
TEST(Template, NamesEveryKeyOfAFitAndASensitivityStudy) {
    const std::string text = commented_template("plane_failure");
    std::set<std::string> keys;
    collect_keys<FitTask>(keys);
    collect_keys<MechanismTask>(keys);
    collect_keys<SensitivityStudy>(keys);
    ASSERT_TRUE(keys.contains("give_up_below") && keys.contains("compared_with") && keys.contains("bootstrap"));
    for (const std::string& key : keys) {
        const bool named = key.empty() || text.find(key + " = ") != std::string::npos ||
                           text.find("." + key + "]") != std::string::npos;
        EXPECT_TRUE(named) << key;
    }
}

TEST(Show, NamesValuesRangesAndSources) {
    const std::string text =
        described_inputs(parse_case(std::string(example_text) + "[sources]\n\"slope.height\" = \"map\"\n", "case"));
    EXPECT_NE(text.find("slope.height"), std::string::npos);
    EXPECT_NE(text.find("68.58 m"), std::string::npos);
    EXPECT_NE(text.find("more than 0 and at most 1000000 m"), std::string::npos);
    EXPECT_NE(text.find("map\n"), std::string::npos);
}

}  // namespace
}  // namespace delabole
