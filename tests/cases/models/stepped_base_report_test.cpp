// The program describes outcomes of columns on a stepped base, and warns, in the words that fit them.
#include "cases/program/case/case_file.hpp"
#include "cases/program/case/case_writer.hpp"
#include "cases/program/models/stepped_base/drawing.hpp"
#include "cases/program/models/stepped_base/sweeps.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

// The friction of the push of 3883 kN/m on the toe column, which a cable holds, unloads the base of column 2.
constexpr std::string_view cable_in_a_low_column = R"(
schema = 1
model = "stepped_base"
title = "bench"
rock = { unit_weight = "27 kN/m3" }
water = { kind = "dry" }
slope = { height = "45 m", face_dip = "62 deg", upper_surface_dip = "6 deg" }
columns = { kind = "continuous", joint_dip = "66 deg", spacing = "4 m", base_inclination = "33 deg" }
joints = { friction_angle = "38 deg" }
bases = { friction_angle = "40 deg", cohesion = "0 kPa" }
required_cable = [{ block = 1, plunge = "15 deg", height = "2 m", factor_of_safety = 1.25 }]
)";

TEST(SteppedBaseReport, DoubtsACableUnderWhichAColumnWouldLiftOffItsBase) {
    SteppedBaseStudy<> study = std::get<SteppedBaseStudy<>>(parse_case(cable_in_a_low_column, "bench").model);
    const SteppedBaseAnswer answer = analyse_case(study);
    EXPECT_EQ(head_card(study, answer).sentences[1],
              "FS 1.25 takes 1850 kN/m in a cable in column 1, 2 m above its base, at 15 deg, but then column 2 would "
              "lift off the base, or slip on it while toppling, which the recursion does not see.");
    EXPECT_TRUE(warns(analyse_model(study), "required_cable[1].force: with it column 2 would lift off the base"));
    // A bolt with the same force lifts the column too.
    study.model.scene.bolt.push_back({1, answer.required_cable[0].force, degrees(15), 2});
    EXPECT_TRUE(warns(analyse_model(study), "column 2 would lift off the base"));
    study.model.scene.bolt.clear();
    study.required_cable[0].factor_of_safety = 1;
    EXPECT_FALSE(warns(analyse_model(study), "would lift off the base"));
}

// The toe column is 0 m high at its toe and 3.1 m at its joint: the line of the cable enters it through the face.
TEST(SteppedBaseReport, DrawsACableFromWhereItEntersTheColumn) {
    const auto study = std::get<SteppedBaseStudy<>>(parse_case(cable_in_a_low_column, "bench").model);
    const SteppedBaseAnswer answer = analyse_case(study);
    const DrawnForce drawn = required_force(study.model.scene, answer.slope, study.required_cable[0], 1e6);
    EXPECT_NEAR(drawn.at.y(), drawn.at.x() * std::tan(degrees(62)), 1e-9);
    // The height is measured normal to the column's base, which is normal to the joints.
    const Point head(-2 * std::sin(degrees(24)), 2 * std::cos(degrees(24)));
    EXPECT_NEAR(drawn.at.y(), head.y() - (drawn.at.x() - head.x()) * std::tan(degrees(15)), 1e-9);
}

// The toe column is smaller than two of its numbers.
TEST(SteppedBaseReport, DrawsNoNumberThatWouldHideAColumn) {
    const auto study = std::get<SteppedBaseStudy<>>(parse_case(cable_in_a_low_column, "bench").model);
    const ColumnSlope<> slope = make_columns(study.model.scene);
    const Figure figure =
        block_figure(column_drawing(study.model, slope, column_results(slope, strength_of(study.model)), 1, ""));
    EXPECT_EQ(std::ranges::count(figure.labels, std::string("1"), &Label::text), 0);
    EXPECT_EQ(std::ranges::count(figure.labels, std::string("3"), &Label::text), 1);
}

TEST(SteppedBaseReport, WhatIsNotThereHasNoNumbers) {
    EXPECT_EQ(word(analysis_of("goodman_bray_1976.toml", {}), "slide_head_factor_of_safety"), "none");
    EXPECT_EQ(word(analysis_of("water_wedge_cable.toml", {}), "slide_head_factor_of_safety"), "");
    const Analysis shaken = analysis_of("water_wedge_cable.toml", {{"seismic.horizontal_coefficient", "5"}});
    EXPECT_EQ(word(shaken, "friction_limit"), "fails_at_any_strength");
    EXPECT_EQ(word(shaken, "limiting_friction_angle"), "none");
}

SteppedBase<> problem_of(const std::string& name) {
    const CaseFile file = read_case(std::string(DELABOLE_CASES) + "/stepped_base/" + name, {});
    return std::get<SteppedBaseStudy<>>(file.model).model;
}

std::size_t breaks(const GeometrySweep& sweep, std::size_t series) {
    const Polyline& points = std::get<Line>(sweep.figure.series[series]).points;
    std::size_t count = 0;
    for (std::size_t index = 1; index + 1 < points.size(); ++index) {
        count += std::isnan(points[index].y()) && std::isfinite(points[index - 1].y()) &&
                         std::isfinite(points[index + 1].y())
                     ? 1
                     : 0;
    }
    return count;
}

// Joints are counted from the end of the base, so that a bolt moves to another column whenever one begins at the toe:
// between 1.5 and 15 m of spacing the 28 m of base take up some 20 columns.
TEST(SteppedBaseReport, BreaksTheCurveWhereABoltMovesToAnotherColumn) {
    SteppedBase<> problem = problem_of("water_wedge_cable.toml");
    const auto spacing_of = [](const std::vector<GeometrySweep>& sweeps) {
        return *std::find_if(sweeps.begin(), sweeps.end(),
                             [](const GeometrySweep& sweep) { return sweep.file == "safety_spacing"; });
    };
    EXPECT_GT(breaks(spacing_of(geometry_sweeps(problem, 1.07)), 0), 5U);
    EXPECT_TRUE(warns(analysis_of("water_wedge_cable.toml", {}), "keep the number of their column"));
    problem.scene.bolt.clear();
    const GeometrySweep bare = spacing_of(geometry_sweeps(problem, 1.05));
    EXPECT_EQ(breaks(bare, 0), 0U);
    EXPECT_GT(breaks(bare, 1), 2U);  // flat-topped columns jump without any bolt
    EXPECT_FALSE(warns(analysis_of("goodman_bray_1976.toml", {}), "keep the number of their column"));
}

TEST(SteppedBaseReport, DrawsWaterThatIsDrawnDownToTheToe) {
    SteppedBase<> problem = problem_of("water_wedge_cable.toml");
    problem.scene.water = DrawnDownWater<>{9810, WaterDepth<>{34}};
    const ColumnSlope<> slope = make_columns(problem.scene);
    const Polyline water = column_drawing(problem, slope, column_results(slope, strength_of(problem)), 1, "").water;
    ASSERT_FALSE(water.empty());
    // The base ends 28 m above the toe on a line of 35 deg.
    const double end = 28 / std::tan(degrees(35));
    for (const Point& point : water) {
        EXPECT_NEAR(point.y(), point.x() < end ? 34 * point.x() / end : 34, 1e-9);
    }
    EXPECT_GT(water.back().x(), end);
}

TEST(SteppedBaseReport, SaysWhyThereAreNoFigures) {
    EXPECT_TRUE(warns(
        analysis_of("water_wedge_cable.toml",
                    {{"columns.spacing", "1 cm"}, {"bolt[1].height", "0 m"}, {"required_cable[1].height", "0 m"}}),
        "figures are left out"));
    EXPECT_FALSE(warns(analysis_of("water_wedge_cable.toml", {}), "figures are left out"));
}

// Removes what a commented template offers instead of its own choice: from "# or:" to the next empty line.
std::string without_alternatives(std::string text) {
    constexpr std::string_view mark = "\n# or:";
    for (std::size_t start = text.find(mark); start != std::string::npos; start = text.find(mark, start)) {
        text.erase(start + 1, text.find("\n\n", start) - start);
    }
    return text;
}

// Every section of every template, uncommented by itself, is a case that the model can answer. Sections within
// commented sections are commented twice and stay so.
TEST(Templates, EverySectionGivesAnAnswerOnceUncommented) {
    int sections = 0;
    for (const std::string& model : model_names()) {
        const std::string text = without_alternatives(commented_template(model));
        ASSERT_EQ(text.find("\n# or:"), std::string::npos) << model;
        for (std::size_t start = text.find("\n# ["); start != std::string::npos;
             start = text.find("\n# [", start + 1)) {
            std::string changed = text.substr(0, start + 1);
            std::size_t at = start + 1;
            while (at < text.size() && text[at] != '\n') {
                const std::size_t end = std::min(text.find('\n', at), text.size() - 1);
                const std::string line = text.substr(at, end - at);
                changed += (line.starts_with("# ") ? line.substr(2) : line) + "\n";
                at = end + 1;
            }
            const std::string header = text.substr(start + 3, text.find_first_of("#\n", start + 4) - start - 3);
            changed += text.substr(at);
            if (header.find("[fit") != std::string::npos || header.find("[sensitivity") != std::string::npos) {
                continue;  // these need one another
            }
            const bool rows_of_bolts = model == "relaxation" && header.starts_with("[[support");
            if (rows_of_bolts || header.starts_with("[retrogression") || header.starts_with("[ensemble")) {
                continue;  // of a jointed slope, and refused of the blocks that the template has
            }
            // Poles replace the joint sets of the template; a stepped path covers no bench, and says so.
            const bool stands_instead =
                model == "kinematics" && (header.starts_with("[[poles") || header.starts_with("[set_search"));
            if (stands_instead || (model == "stepped_path" && header.starts_with("[slope.bench"))) {
                continue;
            }
            ++sections;
            try {
                const CaseFile file = parse_case(changed, "template");
                EXPECT_EQ(analyse_model(file.model).failure, "") << model << " " << header;
            } catch (const CaseError& error) {
                ADD_FAILURE() << model << " " << header << ": " << error.what();
            }
        }
    }
    EXPECT_GT(sections, 25);
}

}  // namespace
}  // namespace delabole
