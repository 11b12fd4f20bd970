#include "cases/program/case/case_writer.hpp"
#include "cases/program/reader/outline_file.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

namespace delabole {
namespace {

using testing::complaint;

constexpr std::string_view slope_text = R"(schema = 1
model = "relaxation"
[scene]
kind = "jointed_slope"
intact_joint = "intact"
outline = [{ x = "0 m", y = "0 m" }, { x = "14 m", y = "0 m" }, { x = "14 m", y = "8 m" }, { x = "4.6 m", y = "8 m" }]
[[scene.rock]]
name = "slate"
density = "2700 kg/m3"
[[scene.rock]]
name = "gouge"
density = "2 t/m3"
[[scene.joint]]
name = "joint"
friction_angle = "50 deg"
[[scene.joint]]
name = "intact"
friction_angle = "60 deg"
water_share = 0
[scene.frame]
sides = "below_and_behind"
thickness = "1 m"
reach = "5 m"
joint = "joint"
[scene.water]
unit_weight = "9.81 kN/m3"
vertex = [{ x = "0 m", y = "0 m" }, { x = "14 m", y = "1.5 m" }]
[[scene.cut]]
name = "fault"
joint = "joint"
[scene.cut.trace]
kind = "line"
thickness = "0.3 m"
gouge = "gouge"
vertex = [{ x = "6 m", y = "-1 m" }, { x = "16 m", y = "6 m" }]
[[scene.cut]]
name = "a"
joint = "joint"
[scene.cut.trace]
kind = "set"
dip = "-80 deg"
spacing = "3 m"
scatter = 0.2
seed = 4
ends_on = "fault"
side = "above"
[[scene.cut]]
name = "b"
joint = "joint"
[scene.cut.trace]
kind = "set"
dip = "5 deg"
spacing = "2 m"
staggered_by = "a"
stagger_share = 0.5
[settings]
stiffness_ratio = 1e4
duration = "1 s"
)";

std::string replaced(std::string text, std::string_view from, std::string_view to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    return text.replace(at, from.size(), to);
}

std::string complaint_about(std::string_view from, std::string_view to) {
    return complaint(replaced(std::string(slope_text), from, to));
}

TEST(JointedSlopeCase, AnUndecidedSearchSaysWhatToRaiseAndItsBracket) {
    RelaxationStudyAnswer answer;  // made up: no cheap search ends between two verdicts
    answer.plan = CriticalPlan{CriticalParameter::strength_reduction, 0.5, 2, 0.01, {LoadingPath::consolidated}, {}};
    CriticalAnswer& search = answer.critical.emplace();
    search.status = CriticalStatus::undecided;
    search.stands = 0.6;
    search.fails = 0.7;
    search.seen_to_stand = search.seen_to_fail = true;
    search.consolidated_at = 0.5;
    const auto ends_with = [&](std::string_view end) { return head_card({}, answer).sentences.front().ends_with(end); };
    EXPECT_TRUE(ends_with("raise it. The blocks stand at 0.6 and fail at 0.7."));
    search.seen_to_fail = false;  // a bound, at which there was no run
    EXPECT_TRUE(ends_with("within settings.duration: raise it."));
    search.consolidated_at.reset();
    EXPECT_TRUE(ends_with("neither came to rest nor failed, so that there is no state at rest from which to begin."));
}

TEST(JointedSlopeCase, ReadsAndWritesTheSameScene) {
    const CaseFile file = parse_case(slope_text, "case");
    const RelaxationScene scene = relaxation_scene(std::get<RelaxationStudy>(file.model));
    EXPECT_GT(scene.block.size(), 15U);
    EXPECT_FALSE(scene.pressure.empty());
    const std::string written = resolved_toml(file);
    const CaseFile again = parse_case(written, "again");
    EXPECT_EQ(resolved_toml(again), written);
    const RelaxationScene same = relaxation_scene(std::get<RelaxationStudy>(again.model));
    ASSERT_EQ(same.block.size(), scene.block.size());
    for (std::size_t block = 0; block < scene.block.size(); ++block) {
        EXPECT_EQ(same.block[block].outline, scene.block[block].outline);
    }
}

TEST(JointedSlopeCase, RunsAndAnswers) {
    const Analysis analysis = analyse_model(parse_case(slope_text, "case").model);
    EXPECT_EQ(analysis.failure, "");
    ASSERT_NE(analysis.find("outcome"), nullptr);
}

TEST(JointedSlopeCase, WarnsOfASideThatNothingHolds) {
    const std::string brief = replaced(std::string(slope_text), "duration = \"1 s\"", "duration = \"0.001 s\"");
    const std::string bench = replaced(brief, "{ x = \"0 m\", y = \"0 m\" }, { x = \"14 m\", y = \"0 m\" }",
                                       "{ x = \"0 m\", y = \"0 m\" }, { x = \"-5 m\", y = \"0 m\" }, "
                                       "{ x = \"-5 m\", y = \"-2 m\" }, { x = \"14 m\", y = \"-2 m\" }");
    const auto warned = [](const std::string& text) {
        const Analysis analysis = analyse_model(parse_case(text, "case").model);
        EXPECT_EQ(analysis.failure, "");
        return std::ranges::any_of(analysis.warnings, [](const std::string& warning) {
            return warning.find("nothing holds the left side of scene.outline") != std::string::npos;
        });
    };
    EXPECT_FALSE(warned(brief)) << "the toe of the face is the outline's end";
    EXPECT_TRUE(warned(bench));
    EXPECT_EQ(questions_about(parse_case(bench, "case").model).size(), 1U) << "before it is run, too";
    EXPECT_FALSE(warned(replaced(bench, "below_and_behind", "all_around")));
}

// A wedge of 1.05 m2 under one fault at 55 deg, which daylights 3 m below the crest: it slides if it stays a block.
TEST(JointedSlopeCase, WarnsWhereOneOfFewBlocksBecameAPartOfAnother) {
    const auto warned = [](const std::string& share) {
        const Analysis analysis = analyse_model(parse_case(R"(schema = 1
model = "relaxation"
[scene]
kind = "jointed_slope"
)" + share + R"(
outline = [{ x = "0 m", y = "0 m" }, { x = "20 m", y = "0 m" }, { x = "20 m", y = "12 m" }, { x = "5.596 m", y = "12 m" }]
[[scene.rock]]
name = "slate"
density = "2700 kg/m3"
[[scene.joint]]
name = "open"
friction_angle = "30 deg"
[[scene.cut]]
name = "fault"
joint = "open"
trace = { kind = "line", vertex = [{ x = "3.05 m", y = "7.362 m" }, { x = "7.445 m", y = "13.638 m" }] }
[scene.frame]
sides = "below_and_behind"
thickness = "2 m"
joint = "open"
[settings]
duration = "0.01 s"
)",
                                                           "case")
                                                    .model);
        return std::ranges::any_of(analysis.warnings, [](const std::string& warning) {
            return warning.find("became part of a neighbour and cannot fail alone") != std::string::npos;
        });
    };
    EXPECT_TRUE(warned("sliver_share = 0.2"));
    EXPECT_FALSE(warned("")) << "1.05 m2 are no sliver of a section of 206";
}

TEST(JointedSlopeCase, WarnsOfForcesWithoutEffectOrOutsideTheirBlock) {
    const std::string brief = replaced(std::string(slope_text), "duration = \"1 s\"", "duration = \"0.001 s\"");
    const auto warnings = [&](std::size_t block, std::string_view x) {
        const std::string force = "\n[[force]]\nblock = " + std::to_string(block) + "\nx = \"" + std::string(x) +
                                  "\"\ny = \"4 m\"\nhorizontal = \"1 N/m\"\nvertical = \"0 N/m\"\n";
        std::string all;
        for (const std::string& warning : analyse_model(parse_case(brief + force, "case").model).warnings) {
            all += warning;
        }
        return all;
    };
    const auto study = std::get<RelaxationStudy>(parse_case(brief, "case").model);
    const std::size_t count = relaxation_scene(study).block.size();
    EXPECT_NE(warnings(1, "-9 m").find("force[1] acts outside block 1, as if by a lever"), std::string::npos);
    EXPECT_NE(warnings(count, "5 m").find("force[1] has no effect: block " + std::to_string(count) + " is fixed"),
              std::string::npos);
}

TEST(JointedSlopeCase, ComplaintsNameTheKey) {
    const auto has = [](const std::string& text, std::string_view part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(has(complaint_about("gouge = \"gouge\"", "gouge = \"clay\""), "scene.cut[1].trace.gouge"));
    EXPECT_TRUE(has(complaint_about("spacing = \"3 m\"", "spacing = \"0 m\""), "scene.cut[2].trace.spacing"));
    EXPECT_TRUE(has(complaint_about("side = \"above\"", ""), "scene.cut[2].trace.ends_on"));
    EXPECT_TRUE(has(complaint_about("ends_on = \"fault\"", "ends_on = \"folt\""), "scene.cut[2].trace.ends_on"));
    EXPECT_TRUE(
        has(complaint_about("staggered_by = \"a\"", "staggered_by = \"c\""), "scene.cut[3].trace.staggered_by"));
    EXPECT_TRUE(has(complaint_about("name = \"b\"\njoint = \"joint\"", "name = \"b\"\njoint = \"tight\""),
                    "scene.cut[3].joint"));
    EXPECT_TRUE(has(complaint_about("name = \"b\"", "name = \"a\""), "scene.cut[3].name"));
    EXPECT_TRUE(has(complaint_about("seed = 4", "seed = 4.5"), "scene.cut[2].trace.seed"));
    EXPECT_TRUE(has(complaint_about("scatter = 0.2\n", ""), "has no effect without scatter or persistence"));
    EXPECT_TRUE(has(complaint_about("seed = 4", "seed = 4\ntrace_length = \"2 m\""),
                    "has no effect without persistence beside it"));
    EXPECT_TRUE(
        has(complaint_about("{ x = \"4.6 m\", y = \"8 m\" }", "{ x = \"16 m\", y = \"4 m\" }"), "scene.outline"));
    EXPECT_TRUE(has(complaint_about("{ x = \"14 m\", y = \"1.5 m\" }", "{ x = \"-1 m\", y = \"1.5 m\" }"),
                    "scene.water.vertex"));
    EXPECT_TRUE(has(complaint_about("x = \"0 m\", y = \"0 m\" }, { x = \"14 m\", y = \"0 m\"",
                                    "x = \"0 m\", y = \"0 m\" }, { x = \"14 m\", y = \"1 m\""),
                    "scene.frame.sides"));
    EXPECT_TRUE(has(complaint_about("x = \"14 m\", y = \"8 m\" }, { x = \"4.6 m\", y = \"8 m\"",
                                    "x = \"9.4 m\", y = \"8 m\" }, { x = \"0 m\", y = \"8 m\""),
                    "mirror one that faces right"));
    EXPECT_TRUE(has(complaint_about("{ x = \"14 m\", y = \"0 m\" }, { x = \"14 m\", y = \"8 m\" }",
                                    "{ x = \"400 km\", y = \"0 m\" }, { x = \"400 km\", y = \"80 km\" }"),
                    "the outline is 400000 m wide: is its drawing in millimetres?"));
    const auto about_area = [](const std::string& section) { return complaint(std::string(slope_text) + section); };
    constexpr std::string_view bow_tie =
        "vertex = [{ x = \"0 m\", y = \"0 m\" }, { x = \"14 m\", y = \"8 m\" }, { x = \"14 m\", y = \"0 m\" }, "
        "{ x = \"0 m\", y = \"8 m\" }]\n";
    EXPECT_TRUE(has(about_area("[[scene.fixed]]\n" + std::string(bow_tie)), "scene.fixed[1].vertex"));
    EXPECT_TRUE(has(about_area("[[scene.stage]]\ntime = \"1 s\"\n" + std::string(bow_tie)), "edges that cross"));
    EXPECT_TRUE(has(complaint_about("outline = [", "outline_file = \"none.dxf\"\noutline = ["), "scene.outline_file"));
}

std::string dxf_of(std::string_view entities, std::string_view header = "") {
    return "0\nSECTION\n2\nHEADER\n" + std::string(header) + "0\nENDSEC\n0\nSECTION\n2\nENTITIES\n" +
           std::string(entities) + "0\nENDSEC\n0\nEOF\n";
}

std::string dxf_line(double x1, double y1, double x2, double y2) {
    return "0\nLINE\n8\n0\n10\n" + std::to_string(x1) + "\n20\n" + std::to_string(y1) + "\n11\n" + std::to_string(x2) +
           "\n21\n" + std::to_string(y2) + "\n";
}

constexpr std::string_view light_polyline =
    "0\nLWPOLYLINE\n90\n3\n70\n1\n10\n0\n20\n0\n10\n14.0\n20\n0\n10\n1.4E+1\n20\n  8.5\n";

TEST(OutlineFile, DxfPolylinesAndLinesBecomeAnOutline) {
    const OutlineFile light = outline_of_dxf(dxf_of(light_polyline));
    ASSERT_EQ(light.problem, "");
    ASSERT_EQ(light.outline.size(), 3U);
    EXPECT_EQ(light.outline[2].x, 14);
    EXPECT_EQ(light.outline[2].y, 8.5);
    const OutlineFile old = outline_of_dxf(dxf_of(
        "0\nTEXT\n10\n5\n20\n5\n1\npit\n0\nPOLYLINE\n10\n0\n20\n0\n70\n1\n0\nVERTEX\n10\n0\n20\n0\n0\nVERTEX\n10\n"
        "14\n20\n0\n0\nVERTEX\n10\n14\n20\n8\n0\nSEQEND\n",
        "9\n$INSUNITS\n70\n4\n"));
    ASSERT_EQ(old.problem, "");
    ASSERT_EQ(old.outline.size(), 3U);
    EXPECT_DOUBLE_EQ(old.outline[1].x, 0.014);
    // The lines are in no order, and one of them runs the other way round.
    const OutlineFile lines = outline_of_dxf(
        dxf_of(dxf_line(0, 0, 14, 0) + dxf_line(14, 8, 4, 8) + dxf_line(14, 8, 14, 0) + dxf_line(4, 8, 0, 0)));
    EXPECT_EQ(lines.problem, "");
    EXPECT_EQ(lines.outline.size(), 4U);
}

// Work that grew with the square of blanks or lines would not end within the test's time.
TEST(OutlineFile, LongDrawingsAreReadInOnePass) {
    const OutlineFile padded = outline_of_dxf(dxf_of(light_polyline) + std::string(std::size_t{50} << 20U, ' '));
    EXPECT_EQ(padded.problem, "");
    EXPECT_EQ(padded.outline.size(), 3U);
    std::string blanks_in_lines = "0\nSECTION\n2\nENTITIES\n" + std::string(light_polyline);
    for (int line = 0; line < 10'000; ++line) {
        blanks_in_lines += "999\n" + std::string(1000, ' ') + "\n";
    }
    EXPECT_EQ(outline_of_dxf(blanks_in_lines + "0\nENDSEC\n0\nEOF\n").outline.size(), 3U);

    // Lines of a circle, each beside the one that comes nearly half a turn later.
    constexpr int corners = 20'000;
    constexpr int step = 9'999;
    const auto corner = [](int number) {
        const double angle = 2 * 3.141592653589793 * number / corners;
        return std::pair{1000 * std::cos(angle), 1000 * std::sin(angle)};
    };
    std::string lines;
    for (int number = 0; number < corners; ++number) {
        const int at = static_cast<int>(static_cast<long>(number) * step % corners);
        const auto [x1, y1] = corner(number % 3 == 0 ? at + 1 : at);
        const auto [x2, y2] = corner(number % 3 == 0 ? at : at + 1);
        lines += dxf_line(x1, y1, x2, y2);
    }
    const OutlineFile circle = outline_of_dxf(dxf_of(lines));
    EXPECT_EQ(circle.problem, "");
    EXPECT_EQ(circle.outline.size(), static_cast<std::size_t>(corners));
}

TEST(OutlineFile, WhatIsNoOutlineIsSaid) {
    const auto problem = [](std::string_view entities) { return outline_of_dxf(dxf_of(entities)).problem; };
    const auto has = [](const std::string& text, std::string_view part) {
        return text.find(part) != std::string::npos;
    };
    EXPECT_TRUE(has(problem("0\nARC\n10\n0\n20\n0\n40\n5\n"), "ARC"));
    EXPECT_TRUE(has(problem("0\nSPLINE\n10\n0\n20\n0\n"), "SPLINE"));
    EXPECT_TRUE(has(problem("0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n42\n0.5\n10\n1\n20\n0\n10\n1\n20\n1\n"), "arc"));
    EXPECT_TRUE(has(problem("0\nINSERT\n2\nblock\n"), "INSERT"));
    EXPECT_TRUE(has(problem(""), "no LINE"));
    EXPECT_TRUE(has(problem(dxf_line(0, 0, 1, 0) + dxf_line(1, 0, 1, 1)), "not closed"));
    EXPECT_TRUE(has(problem(std::string(light_polyline) + dxf_line(50, 0, 60, 0)), "separate"));
    EXPECT_TRUE(has(problem("0\nLINE\n10\nfive\n"), "number"));
    EXPECT_TRUE(has(outline_of_dxf("AutoCAD Binary DXF").problem, "group code"));
    EXPECT_TRUE(has(outline_of_dxf("").problem, "EOF"));
    EXPECT_TRUE(has(outline_of_dxf("0\nSECTION\n2\nENTITIES\n" + dxf_line(0, 0, 1, 0)).problem, "EOF"));
    EXPECT_TRUE(has(outline_of_dxf(dxf_of(light_polyline, "9\n$INSUNITS\n70\n3\n")).problem, "unit"));
    EXPECT_TRUE(has(outline_of_dxf(dxf_of("0\nLWPOLYLINE\n70\n1\n10\n0\n20\n0\n10\n1e307\n20\n0\n10\n1\n20\n1\n",
                                          "9\n$INSUNITS\n70\n7\n"))
                        .problem,
                    "not finite in metres"));
    EXPECT_TRUE(has(outline_of_csv("x,y\n0,0\n").problem, "x_m,y_m"));
    EXPECT_TRUE(has(outline_of_csv("x_m,y_m\n0,0\n1,0\n").problem, "three corners"));
    EXPECT_TRUE(has(outline_of_csv("x_m,y_m\n0,0\n1;0\n1,1\n").problem, "line 3"));
    EXPECT_TRUE(has(outline_of_csv("x_m,y_m\n0,0\nnan,0\n1,1\n").problem, "line 3"));
    EXPECT_EQ(outline_of_csv("x_m,y_m\r\n0,0\r\n1,0\r\n\r\n1,1\r\n").outline.size(), 3U);
    EXPECT_TRUE(has(read_outline_file("outline.dwg").problem, ".dxf"));
    EXPECT_EQ(read_outline_file("none.dxf").problem, "there is no such file");
    const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "folder.csv";
    std::filesystem::create_directories(folder);
    EXPECT_EQ(read_outline_file(folder).problem, "is a folder, not an outline");
}

TEST(OutlineFile, AGapIsSaidWithItsPlaceAndWidth) {
    const std::string right = dxf_line(0, 0, 14, 0) + dxf_line(14, 8, 14, 0);
    EXPECT_EQ(outline_of_dxf(dxf_of(dxf_line(4, 8, 0, 0) + right + dxf_line(14, 8, 4.25, 8))).problem,
              "has a line that is not closed: the gap between its ends is 0.25 m wide, from x = 4.25 m, y = 8 m to "
              "x = 4 m, y = 8 m");
    EXPECT_EQ(outline_of_dxf(dxf_of(right + dxf_line(14, 8.5, 4, 8) + dxf_line(0, 1, 4, 8))).problem,
              "has 2 separate lines: an outline is one, closed; the narrowest gap between them is 0.5 m wide, from "
              "x = 14 m, y = 8 m to x = 14 m, y = 8.5 m");
}

// Lines have no direction, so that the corners go round as the program wants them.
TEST(OutlineFile, LooseLinesMakeAnAnticlockwiseOutline) {
    const OutlineFile file = outline_of_dxf(
        dxf_of(dxf_line(0, 0, 4, 8) + dxf_line(4, 8, 14, 8) + dxf_line(14, 8, 14, 0) + dxf_line(14, 0, 0, 0)));
    ASSERT_EQ(file.outline.size(), 4U);
    EXPECT_EQ(file.outline[1].x, 14);
    EXPECT_EQ(file.outline[1].y, 0);
}

TEST(OutlineFile, IsOneLayerOfADrawing) {
    std::string on_layer(light_polyline);
    on_layer.insert(on_layer.find("LWPOLYLINE\n") + 11, "8\nground\n");
    const std::string drawing =
        dxf_of(on_layer + "0\nLINE\n8\nfault\n10\n0\n20\n0\n11\n9\n21\n9\n0\nCIRCLE\n8\nnotes\n10\n1\n20\n1\n40\n1\n");
    const OutlineFile ground = outline_of_dxf(drawing, "ground");
    EXPECT_EQ(ground.problem, "");
    EXPECT_EQ(ground.outline.size(), outline_of_dxf(dxf_of(light_polyline)).outline.size());
    EXPECT_NE(outline_of_dxf(drawing, "notes").problem.find("CIRCLE"), std::string::npos);
    EXPECT_NE(outline_of_dxf(drawing, "rock").problem.find("on the layer rock; there are some on fault and ground"),
              std::string::npos);
    EXPECT_EQ(outline_of_dxf(drawing, "GROUND").problem, "");
    const std::string lines = dxf_of(on_layer + "0\nLINE\n8\nfault\n10\n50\n20\n0\n11\n60\n21\n9\n");
    EXPECT_NE(outline_of_dxf(lines).problem.find("on the layers fault and ground: name that of the outline with "
                                                 "scene.outline_layer"),
              std::string::npos)
        << outline_of_dxf(lines).problem;
}

TEST(OutlineFile, ACaseTakesItsCornersOnce) {
    const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "outline_file";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "slope.csv") << "x_m,y_m\n0,0\n14,0\n14,8\n4.6,8\n";
    const std::string given =
        R"(outline = [{ x = "0 m", y = "0 m" }, { x = "14 m", y = "0 m" }, { x = "14 m", y = "8 m" }, )"
        R"({ x = "4.6 m", y = "8 m" }])";
    const CaseFile direct = parse_case(slope_text, "case");
    const CaseFile from_file = parse_case(replaced(std::string(slope_text), given, "outline_file = \"slope.csv\""),
                                          (folder / "case.toml").string());
    EXPECT_EQ(resolved_toml(from_file), resolved_toml(direct));
}

constexpr std::string_view fit_text = R"(
[post_failure]
moved_share = 0.5
[[fit.observation]]
label = "failed"
quantity = "post_failure.failed_area"
relation = "at_least"
value = "10 m2"
standard_deviation = "1 m2"
[fit.surrogate]
[[fit.mechanism]]
name = "as_drawn"
[[fit.mechanism.parameter]]
name = "scene.joint[1].friction_angle"
lower = "30 deg"
upper = "60 deg"
[[fit.mechanism]]
name = "as_surveyed"
[[fit.mechanism.parameter]]
name = "scene.joint[1].friction_angle"
lower = "30 deg"
upper = "60 deg"
)";

// Writes the scene of the case as that of the mechanism written last, with its outline in a file.
std::string scene_of_mechanism() {
    const std::size_t begin = slope_text.find("[scene]");
    std::string text(slope_text.substr(begin, slope_text.find("[settings]") - begin));
    const std::size_t outline = text.find("outline = ");
    text.replace(outline, text.find('\n', outline) - outline, "outline_file = \"slope.csv\"");
    for (std::size_t at = 0; (at = text.find("[scene", at)) != std::string::npos; at += 1) {
        text.insert(at + 1, "fit.mechanism.");
    }
    return text;
}

std::size_t corners_of(const CaseModel& model) {
    return std::get<RelaxationSlope>(std::get<RelaxationStudy>(model).model.scene).geometry.outline.size();
}

// The outline of the case has four corners, that of the file, which has a bench, six.
TEST(OutlineFile, AMechanismMayHaveItsOwn) {
    const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "mechanism_outline";
    std::filesystem::create_directories(folder);
    const std::string name = (folder / "case.toml").string();
    const std::string text = std::string(slope_text) + std::string(fit_text) + scene_of_mechanism();
    std::ofstream(folder / "slope.csv") << "x_m,y_m\n0,0\n14,0\n14,8\n6.6,8\n4.3,4\n2.3,4\n";
    const CaseFile file = parse_case(text, name);
    ASSERT_EQ(file.fit->mechanisms.size(), 2U);
    EXPECT_EQ(corners_of(file.fit->mechanisms[0].model), 4U);
    EXPECT_EQ(corners_of(file.fit->mechanisms[1].model), 6U);

    std::ofstream(folder / "slope.csv") << "x_m,y_m\n0,0\n14,0\n";
    try {
        parse_case(text, name);
        FAIL() << "two corners are no outline";
    } catch (const CaseError& error) {
        ASSERT_EQ(error.problems().size(), 1U);
        EXPECT_EQ(error.problems()[0].key, "fit.mechanism[2].scene.outline_file");
        EXPECT_GT(error.problems()[0].line, 0);
    }
}

// At a friction of 5 deg the section collapses, and its 700 blocks collide. Every 5000 steps, and at the end, the run
// measures the area that any two blocks have in common.
TEST(DelaboleSection, BlocksDoNotPassThroughEachOtherAtLowFriction) {
    const CaseFile file = read_case(std::string(DELABOLE_CASES) + "/relaxation/delabole_section.toml");
    RelaxationStudy study = std::get<RelaxationStudy>(file.model);
    std::get<RelaxationSlope>(study.model.scene).joint[0].strength.friction_angle = degrees(5);
    study.settings->stop = RelaxationStop::collapse;
    const RelaxationResult result = run(study).result;
    EXPECT_EQ(result.outcome, RelaxationOutcome::collapse);
    ASSERT_TRUE(result.overlap);
    // A thousandth of a usual block of 10 m2; springs pressed by blocks that fall make a quarter of that.
    EXPECT_LT(result.overlap->area, 0.01);  // m2
    EXPECT_LT(std::abs(result.energy_balance.residual_share()), 0.02);
}

}  // namespace
}  // namespace delabole
