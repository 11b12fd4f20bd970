// What the program says of columns on a stepped base: outcomes and warnings in the words that fit them.
#include "cases/analysis.hpp"
#include "cases/case_file.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace delabole {
namespace {

Analysis analysis_of(const std::string& name, const std::vector<Setting>& settings) {
    return analyse_model(read_case(std::string(DELABOLE_CASES) + "/stepped_base/" + name, settings).model);
}

std::string word(const Analysis& analysis, std::string_view name) {
    const NamedOutput* output = analysis.find(name);
    const auto* text = output != nullptr ? std::get_if<std::string>(&output->value) : nullptr;
    return text != nullptr ? *text : "";
}

bool warns(const Analysis& analysis, std::string_view of) {
    return std::any_of(analysis.warnings.begin(), analysis.warnings.end(),
                       [&](const std::string& warning) { return warning.find(of) != std::string::npos; });
}

// An earthquake of 0.448 takes the wedge's push on columns whose friction angles at the limit add up to 90 deg.
TEST(SteppedBaseReport, NamesAnEndWithoutEquilibrium) {
    const Analysis before = analysis_of("water_wedge_cable.toml", {{"seismic.horizontal_coefficient", "0.44"}});
    EXPECT_EQ(word(before, "limit"), "found");
    EXPECT_FALSE(warns(before, "no limiting equilibrium"));
    const Analysis after = analysis_of("water_wedge_cable.toml", {{"seismic.horizontal_coefficient", "0.4479"}});
    EXPECT_EQ(word(after, "limit"), "abrupt");
    EXPECT_TRUE(warns(after, "no limiting equilibrium"));
}

TEST(SteppedBaseReport, AStrengthOfNothingIsNotSaidToFailAtAnyFriction) {
    const Analysis analysis =
        analysis_of("goodman_bray_1976.toml", {{"joints.friction_angle", "0 deg"}, {"bases.friction_angle", "0 deg"}});
    EXPECT_EQ(word(analysis, "limit"), "fails_at_any_strength");
    EXPECT_EQ(word(analysis, "friction_limit"), "found");
    EXPECT_FALSE(warns(analysis, "no friction, however large"));
    EXPECT_TRUE(warns(analysis, "one friction angle of 38.2 deg on joints and bases would"));
}

TEST(SteppedBaseReport, SaysWhatLiftsTheWedge) {
    EXPECT_TRUE(
        warns(analysis_of("water_wedge_cable.toml", {{"seismic.horizontal_coefficient", "5"}}), "its loads lift"));
    const Analysis flooded = analysis_of("water_wedge_cable.toml",
                                         {{"slide_head.water.filled_ratio", "1"}, {"slide_head.joint_dip", "75 deg"}});
    EXPECT_EQ(word(flooded, "slide_head"), "lifts_off");
    EXPECT_TRUE(warns(flooded, "water lifts"));
    const Analysis dragged = analysis_of("water_wedge_cable.toml",
                                         {{"joints.friction_angle", "89 deg"}, {"slide_head.water.filled_ratio", "0"}});
    EXPECT_EQ(word(dragged, "slide_head"), "lifts_off");
    EXPECT_TRUE(warns(dragged, "the friction of the columns"));
}

TEST(SteppedBaseReport, ARequirementMetByAnyValueIsNotNeverReached) {
    const Analysis analysis = analysis_of("water_wedge_cable.toml", {{"required[1].factor_of_safety", "0.5"}});
    EXPECT_EQ(word(analysis, "required.bolt[1].force"), "always_exceeded");
    EXPECT_TRUE(warns(analysis, "whatever its value"));
    EXPECT_EQ(
        word(analysis_of("water_wedge_cable.toml", {{"required[1].factor_of_safety", "50"}}), "required.bolt[1].force"),
        "never_reached");
}

TEST(SteppedBaseReport, WhatIsNotThereHasNoNumbers) {
    EXPECT_EQ(analysis_of("goodman_bray_1976.toml", {}).find("slide_head_factor_of_safety"), nullptr);
    EXPECT_NE(analysis_of("water_wedge_cable.toml", {}).find("slide_head_factor_of_safety"), nullptr);
    const Analysis shaken = analysis_of("water_wedge_cable.toml", {{"seismic.horizontal_coefficient", "5"}});
    EXPECT_EQ(word(shaken, "friction_limit"), "fails_at_any_strength");
    EXPECT_EQ(word(shaken, "limiting_friction_angle"), "none");
}

}  // namespace
}  // namespace delabole
