#include "cases/program/case/case_writer.hpp"
#include "cases/program/results/analysis.hpp"
#include "cases/program/results/model_reports.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "tests/support/brick_pack.hpp"

#include "tests/cases/example_case.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

using testing::changed;
using testing::complaint;

constexpr std::string_view row_text = R"(schema = 1
model = "relaxation"
[scene]
kind = "row"
tilt = "10 deg"
density = "2700 kg/m3"
[scene.interface]
friction_angle = "20 deg"
[scene.base]
friction_angle = "30 deg"
[[scene.block]]
width = "1 m"
height = "2 m"
[[scene.block]]
width = "1 m"
height = "2 m"
)";

constexpr std::string_view blocks_text = R"(schema = 1
model = "relaxation"
[scene]
kind = "blocks"
tilt = "5 deg"
[[scene.joint]]
friction_angle = "30 deg"
normal_stiffness = "500 MN/m/m"
[[scene.block]]
density = "2.7 t/m3"
vertex = [{ x = "0 m", y = "0 m" }, { x = "1 m", y = "0 m" }, { x = "0 m", y = "1 m" }]
[[scene.block]]
density = "2700 kg/m3"
hold = "fixed"
vertex = [{ x = "-2 m", y = "-1 m" }, { x = "3 m", y = "-1 m" }, { x = "3 m", y = "0 m", joint = 1 }, { x = "-2 m", y = "0 m" }]
)";

std::string complaint_with(std::string_view further) {
    return complaint(std::string(row_text) + std::string(further));
}

Analysis analysis_of(std::string_view text) {
    return analyse_model(parse_case(text, "case").model);
}

std::string word(const Analysis& analysis, std::string_view name) {
    const NamedOutput* output = analysis.find(name);
    return output == nullptr ? "" : std::get<std::string>(output->value);
}

TEST(RelaxationCase, ReadsWhatItSays) {
    const CaseFile file = parse_case(std::string(blocks_text) + R"(
[tilting]
turned = "gravity"
final_tilt = "20 deg"
rate = "30 deg/min"
[[force]]
block = 1
x = "0.5 m"
y = "0 m"
horizontal = "-2 kN/m"
vertical = "0 kN/m"
[settings]
start = "dropped"
kinetic_damping = "on"
duration = "2 min"
)",
                                     "case");
    const auto& study = std::get<RelaxationStudy>(file.model);
    const RelaxationScene scene = relaxation_scene(study);
    ASSERT_EQ(scene.block.size(), 2U);
    EXPECT_DOUBLE_EQ(scene.block[0].density, 2700);
    EXPECT_FALSE(scene.block[0].fixed);
    EXPECT_TRUE(scene.block[1].fixed);
    EXPECT_EQ(scene.block[0].outline.size(), 3U);
    EXPECT_DOUBLE_EQ(scene.material[0].normal_stiffness, 5e8);
    EXPECT_DOUBLE_EQ(scene.material[0].shear_stiffness, 5e8);
    EXPECT_DOUBLE_EQ(scene.gravity.tilt, degrees(5));
    EXPECT_DOUBLE_EQ(scene.gravity.rate, degrees(0.5));
    EXPECT_DOUBLE_EQ(scene.force.at(0).force.x(), -2000);
    const RelaxationSettings settings = relaxation_settings(study);
    EXPECT_EQ(settings.start, RelaxationStart::dropped);
    EXPECT_TRUE(settings.kinetic_damping);
    EXPECT_DOUBLE_EQ(settings.duration, 120);
}

TEST(RelaxationCase, RefusesWhatContradictsItself) {
    EXPECT_EQ(complaint(changed(row_text, "\"30 deg\"", "\"30 deg\"\nresidual_friction_angle = \"31 deg\"")),
              "slope.toml:11:27: scene.base.residual_friction_angle = \"31 deg\": must not exceed the peak, 30 deg");
    EXPECT_NE(complaint(changed(row_text, "\"30 deg\"", "\"30 deg\"\nshear_stiffness = \"1 MN/m/m\""))
                  .find("needs normal_stiffness"),
              std::string::npos);
    EXPECT_NE(complaint_with("[[removal]]\nblock = 4\ntime = \"1 s\"\n")
                  .find("removal[1].block = 4: must be the number of a block, 1 to 3"),
              std::string::npos);
    EXPECT_NE(complaint_with("[[removal]]\nblock = 1.5\ntime = \"1 s\"\n").find("must be the number of a block"),
              std::string::npos);
    EXPECT_NE(complaint_with("[[pressure]]\nblock = 1\nedge = 5\nat_first = \"0 kPa\"\nat_second = \"1 kPa\"\n")
                  .find("pressure[1].edge = 5: must be the number of a face of the block, 1 to 4"),
              std::string::npos);
    EXPECT_NE(complaint_with("[[motion]]\nfixed_block = 1\n").find("motion[1].fixed_block = 1: is free"),
              std::string::npos);
    EXPECT_NE(complaint_with("[[motion]]\nfixed_block = 3\nvelocity = [{ time = \"0 s\", horizontal = \"1 m/s\", "
                             "vertical = \"0 m/s\" }]\n")
                  .find("motion[1].velocity[1]: must be 0 m/s at first"),
              std::string::npos);
    EXPECT_NE(complaint_with("[history]\ninterval = \"1 s\"\n[[history.contact]]\nblock = 1\nother = 1\n")
                  .find("history.contact[1].other = 1: must be another block"),
              std::string::npos);
    EXPECT_NE(complaint_with("[critical]\nparameter = \"tilt\"\nlower = \"20 deg\"\nupper = \"10 deg\"\n")
                  .find("bounds are reversed"),
              std::string::npos);
    EXPECT_NE(complaint_with("[settings]\nwatch = \"6 s\"\nstop = \"collapse\"\n").find("takes the place of"),
              std::string::npos);
    EXPECT_NE(complaint_with("[settings]\nstart = \"ramped\"\n").find("ramp_time"), std::string::npos);
    EXPECT_NE(complaint_with("[settings]\nconsolidation_time = \"1 s\"\n").find("held_at_first"), std::string::npos);
    EXPECT_NE(complaint_with("[settings]\nmost_steps = 1.5\n").find("most_steps = 1.5: must be a whole number"),
              std::string::npos);
    EXPECT_NE(complaint(changed(row_text, "[scene.base]",
                                "[scene.scatter]\nseed = 2.5\nheight_deviation = 0.1\n"
                                "friction_deviation = \"1 deg\"\n[scene.base]"))
                  .find("seed = 2.5: must be a whole number"),
              std::string::npos);
    EXPECT_NE(complaint_with("[history]\ninterval = \"1 s\"\n[[history.block]]\nblock = 9\n")
                  .find("history.block[1].block = 9"),
              std::string::npos);
    EXPECT_NE(complaint(changed(row_text, "\"2700 kg/m3\"", "\"27 kN/m3\"")).find("a density is expected"),
              std::string::npos);
    EXPECT_NE(complaint(changed(blocks_text, "joint = 1", "joint = 2")).find("must be the number of a [[scene.joint]]"),
              std::string::npos);
    EXPECT_NE(complaint_with("[[bolt]]\nhead_x = \"0 m\"\nhead_y = \"0.5 m\"\nplunge = \"0 deg\"\nlength = \"1.5 m\"\n"
                             "spacing = \"1 m\"\naxial_stiffness = \"100 MN\"\ncapacity = \"200 kN\"\n"
                             "grout = { bond_strength = \"150 kN/m\", plate_capacity = \"100 kN\" }\n")
                  .find("bolt[1].grout: needs free_length_at_joints"),
              std::string::npos);
    EXPECT_NE(complaint(changed(row_text, "kind = \"row\"", "kind = \"wall\""))
                  .find("row, stepped_base, blocks or jointed_slope"),
              std::string::npos);
}

std::string joint_water(std::string_view block, std::string_view other) {
    return "[[joint_water]]\nblock = " + std::string(block) + "\nother = " + std::string(other) +
           "\nat_first = \"20 kPa\"\nat_second = \"5 kPa\"\n";
}

TEST(RelaxationCase, WaterOfAJointActsOnBothItsFaces) {
    const CaseFile file = parse_case(std::string(row_text) + joint_water("1", "2") + joint_water("2", "3"), "case");
    const std::vector<FacePressure> pressure = relaxation_scene(std::get<RelaxationStudy>(file.model)).pressure;
    ASSERT_EQ(pressure.size(), 4U);
    EXPECT_EQ(pressure[0].block, 0U);
    EXPECT_EQ(pressure[0].edge, 1U);
    EXPECT_DOUBLE_EQ(pressure[0].at_first, 20e3);
    EXPECT_EQ(pressure[1].block, 1U);
    EXPECT_EQ(pressure[1].edge, 3U);
    EXPECT_DOUBLE_EQ(pressure[1].at_second, 20e3);
    // The plane begins three widths before the row; water acts only on its part under the second block.
    EXPECT_EQ(pressure[3].block, 2U);
    ASSERT_TRUE(pressure[3].part);
    EXPECT_DOUBLE_EQ(pressure[3].part->end - pressure[3].part->begin, 1);
    EXPECT_EQ(complaint_with(joint_water("1", "1")),
              "slope.toml:19:9: joint_water[1].other = 1: is the block itself: water is between two");
    EXPECT_EQ(complaint(std::string(row_text) + "[[scene.block]]\nwidth = \"1 m\"\nheight = \"1 m\"\n" +
                        joint_water("1", "3")),
              "slope.toml:22:9: joint_water[1].other = 3: shares no face with block 1 in the drawing");
    EXPECT_NE(
        complaint_with(joint_water("4", "1")).find("joint_water[1].block = 4: must be the number of a block, 1 to 3"),
        std::string::npos);
    EXPECT_NE(complaint_with(joint_water("1", "1.5")).find("joint_water[1].other = 1.5: must be the number of a block"),
              std::string::npos);
}

TEST(RelaxationCase, SaysThatTheTimeStepGivenWasDivided) {
    const auto warning_at = [](std::string_view step) -> std::string {
        const Analysis analysis =
            analysis_of(std::string(row_text) + "[settings]\ntime_step = \"" + std::string(step) + "\"\n");
        const auto found = std::ranges::find_if(
            analysis.warnings, [](const std::string& warning) { return warning.starts_with("settings.time_step, "); });
        return found == analysis.warnings.end() ? "" : *found;
    };
    EXPECT_TRUE(
        warning_at("10 ms").starts_with("settings.time_step, 0.01 s, is longer than springs and dashpots bear "
                                        "and was divided: steps of "))
        << warning_at("10 ms");
    EXPECT_EQ(warning_at("1e-6 s"), "");
}

// Only the scene as a whole shows what is wrong, which is reported in the words that a user gets.
TEST(RelaxationCase, NamesWhatMakesASceneImpossible) {
    const auto explained = [](std::string_view text) {
        const auto study = std::get<RelaxationStudy>(parse_case(text, "case").model);
        const std::string failure = failure_of(study);
        EXPECT_EQ(failure, analyse_model(study).failure);
        return failure + ": " + impossibility(study, failure).words;
    };
    EXPECT_EQ(explained(changed(blocks_text, "{ x = \"1 m\", y = \"0 m\" }, { x = \"0 m\", y = \"1 m\" }",
                                "{ x = \"0 m\", y = \"1 m\" }, { x = \"1 m\", y = \"0 m\" }")),
              "outline_not_convex: block 1 is not convex, or its corners run clockwise: list them anticlockwise, the "
              "first one once");
    EXPECT_EQ(explained(changed(blocks_text, "y = \"0 m\", joint = 1", "y = \"0.1 m\"")),
              "overlap_at_start: block 1 and block 2 overlap in the drawing by more than ten times what their weight "
              "would do, and not by rounding along one face: they would explode");
    EXPECT_EQ(explained(changed(blocks_text, "500 MN", "1e-6 MN")).substr(0, 18), "stiffness_too_soft");
    EXPECT_EQ(explained(changed(blocks_text, "500 MN", "1e12 MN")).substr(0, 19), "stiffness_too_stiff");
    EXPECT_EQ(explained(changed(blocks_text, "\"2.7 t/m3\"", "\"2.7 t/m3\"\nhold = \"fixed\"")),
              "no_free_block: every block is fixed: nothing can move");
}

TEST(RelaxationCase, AnswersWithOutcomeEnergyAndBlocks) {
    const Analysis standing = analysis_of(row_text);
    EXPECT_EQ(word(standing, "outcome"), "equilibrium");
    EXPECT_EQ(word(standing, "block[1].movement"), "stays");
    EXPECT_EQ(word(standing, "block[3].movement"), "fixed");
    EXPECT_EQ(standing.status, "ok");
    EXPECT_TRUE(standing.unfinished.empty());
    const Analysis sliding = analysis_of(changed(row_text, "\"10 deg\"", "\"35 deg\""));
    EXPECT_EQ(word(sliding, "outcome"), "collapse");
    // Every run has to balance its energy to 2 %; here it is far better.
    EXPECT_LT(std::abs(std::get<double>(sliding.find("energy.residual_share")->value)), 0.02);
    for (const Analysis& analysis : {standing, sliding}) {
        for (const NamedOutput& output : analysis.outputs) {
            const bool known = [&] {
                const auto names = known_outputs(parse_case(row_text, "case").model);
                return !std::holds_alternative<double>(output.value) ||
                       std::ranges::find(names, output.name, &Quantity::name) != names.end();
            }();
            EXPECT_TRUE(known) << output.name;
        }
    }
}

TEST(RelaxationCase, SaysWhenARunHadNoEnd) {
    const std::string slow =
        std::string(changed(row_text, "\"10 deg\"", "\"35 deg\"")) + "[settings]\nduration = \"0.01 s\"\n";
    const Analysis undecided = analysis_of(slow);
    EXPECT_EQ(undecided.status, "undecided");
    EXPECT_EQ(undecided.unfinished,
              "the blocks neither came to rest nor failed within 0.01 s: raise settings.duration");
    // A run that is told to last so long has done what it should.
    EXPECT_EQ(analysis_of(slow + "stop = \"collapse\"\n").status, "ok");
}

TEST(RelaxationCase, ASearchThatFindsNothingSaysWhichBoundToMove) {
    const Analysis low =
        analysis_of(std::string(row_text) + "[critical]\nparameter = \"tilt\"\nlower = \"1 deg\"\nupper = \"5 deg\"\n");
    EXPECT_EQ(word(low, "critical_tilt"), "stands_everywhere");
    EXPECT_EQ(low.unfinished, "the blocks stand even at 5 deg: raise critical.upper");
    const Analysis high = analysis_of(std::string(row_text) +
                                      "[critical]\nparameter = \"friction\"\nlower = \"1 deg\"\nupper = \"5 deg\"\n");
    EXPECT_EQ(word(high, "limiting_friction_angle"), "fails_everywhere");
    EXPECT_EQ(high.unfinished, "the blocks fail even at 5 deg: raise critical.upper");
}

TEST(RelaxationCase, ASearchShowsItsBracketBesideItsAnswer) {
    const auto shown = [](const Analysis& analysis, std::string_view name) {
        const NamedOutput* output = analysis.find(name);
        return output != nullptr && !output->detail;
    };
    const Analysis found = analysis_of(std::string(row_text) +
                                       "[critical]\nparameter = \"tilt\"\nlower = \"5 deg\"\nupper = \"40 deg\"\n");
    EXPECT_TRUE(shown(found, "critical.stands"));
    EXPECT_TRUE(shown(found, "critical.fails"));
    EXPECT_FALSE(shown(found, "critical.runs"));
    const double answer = std::get<double>(found.find("critical_tilt")->value);
    EXPECT_LT(std::get<double>(found.find("critical.stands")->value), answer);
    EXPECT_GT(std::get<double>(found.find("critical.fails")->value), answer);
    // Without an answer the greater bound was never found to fail.
    const Analysis not_found =
        analysis_of(std::string(row_text) + "[critical]\nparameter = \"tilt\"\nlower = \"1 deg\"\nupper = \"5 deg\"\n");
    EXPECT_FALSE(shown(not_found, "critical.fails"));
}

// A block without friction slides and does not turn; its base presses it all the way.
TEST(RelaxationCase, DrawsWhatAHistoryHasAndNothingEmpty) {
    const std::string text =
        changed(changed(row_text, "\"30 deg\"", "\"0 deg\""), "[[scene.block]]\nwidth = \"1 m\"\nheight = \"2 m\"\n",
                "") +
        "[settings]\nstop = \"collapse\"\nduration = \"0.02 s\"\nviscous_damping = 0\nlocal_damping = 0\n"
        "[history]\ninterval = \"0.002 s\"\n[[history.block]]\nblock = 1\n"
        "[[history.contact]]\nblock = 1\nother = 2\n";
    const CaseFile file = parse_case(text, "case");
    const std::filesystem::path path = std::filesystem::temp_directory_path() / "delabole_history_figures";
    std::filesystem::remove_all(path);
    Options options;
    options.out = path.string();
    options.quiet = true;
    Report report;
    append_case_figures(file.model, analyse_case(file.model), {{options, "case", OnInterrupt::stop}, report});
    const auto script = [&](const std::string& name) {
        std::ifstream stream(path / "figures" / (name + ".gp"));
        return std::string(std::istreambuf_iterator<char>(stream), {});
    };
    EXPECT_FALSE(std::filesystem::exists(path / "figures" / "rotations.gp"));
    EXPECT_NE(script("displacements").find("displacement (m)"), std::string::npos);
    EXPECT_NE(script("displacements").find("block 1 x"), std::string::npos);
    EXPECT_NE(script("monitored_contacts").find("force on the first block (kN/m)"), std::string::npos);
    EXPECT_NE(script("monitored_contacts").find("contact 1 2 normal"), std::string::npos);
    std::filesystem::remove_all(path);
}

TEST(RelaxationCase, HasAThousandBricksInBalanceAtTheStart) {
    CaseFile file = parse_case(blocks_text, "case");
    RelaxationStudy& study = std::get<RelaxationStudy>(file.model);
    auto& polygons = std::get<RelaxationPolygons>(study.model.scene);
    polygons.tilt = degrees(20);
    polygons.joint.front().friction_angle = degrees(40);
    polygons.joint.front().normal_stiffness.reset();
    polygons.block.clear();
    for (const RelaxationBlock& brick : brick_pack_scene({22, 45, 1e5, 0, 0}).block) {
        polygons.block.push_back({brick.density, brick.fixed ? BlockHold::fixed : BlockHold::free, {}, {}});
        for (const PlanePoint<>& corner : brick.outline) {
            polygons.block.back().vertex.push_back({corner.x(), corner.y(), {}});
        }
    }
    study.settings = RelaxationNumerics{};
    study.settings->duration = 1e-6;
    const Analysis analysis = analyse_model(file.model);
    EXPECT_FALSE(std::ranges::any_of(analysis.warnings, [](const std::string& warning) {
        return warning.starts_with("the static solve of the start was ended early");
    }));
}

bool warns(const Analysis& analysis, std::string_view beginning) {
    return std::ranges::any_of(analysis.warnings,
                               [&](const std::string& warning) { return warning.starts_with(beginning); });
}

bool warns(const std::string& text, std::string_view beginning) {
    return warns(analysis_of(text), beginning);
}

TEST(RelaxationCase, SaysThatAGapOfTheDrawingWasClosed) {
    const std::string_view corner = "{ x = \"0 m\", y = \"0 m\" }, { x = \"1 m\", y = \"0 m\" }";
    const std::string above =
        changed(blocks_text, corner, "{ x = \"0 m\", y = \"10 mm\" }, { x = \"1 m\", y = \"10 mm\" }");
    EXPECT_TRUE(warns(above, "the static solve of the start closed gaps of the initial geometry"));
    EXPECT_FALSE(warns(std::string(blocks_text), "the static solve of the start closed gaps of the initial geometry"));
}

TEST(RelaxationCase, SaysThatNothingHoldsTheBlocks) {
    const std::string loose = changed(blocks_text, "hold = \"fixed\"\n", "");
    const std::string shortly = "[settings]\nduration = \"0.01 s\"\nstop = \"duration\"\n";
    EXPECT_TRUE(warns(loose + shortly, "no block is fixed"));
    EXPECT_FALSE(warns(std::string(blocks_text) + shortly, "no block is fixed"));
}

// A face of 60 deg and a plane of 35 deg through its toe, or above it.
std::string slope_over(std::string_view toe) {
    return R"(
schema = 1
model = "relaxation"
[scene]
kind = "jointed_slope"
outline = [{ x = "-15 m", y = "-8 m" }, { x = "35 m", y = "-8 m" }, { x = "35 m", y = "12 m" },
           { x = "6.9282 m", y = "12 m" }, { x = "0 m", y = "0 m" }, { x = "-15 m", y = "0 m" }]
intact_joint = "intact"
[[scene.rock]]
name = "rock"
density = "2600 kg/m3"
[[scene.joint]]
name = "plane"
friction_angle = "20 deg"
[[scene.joint]]
name = "intact"
friction_angle = "45 deg"
cohesion = "5 MPa"
tensile_strength = "5 MPa"
[[scene.cut]]
name = "plane"
joint = "plane"
[scene.cut.trace]
kind = "set"
dip = "35 deg"
spacing = "100 m"
through = )" +
           std::string(toe) +
           R"(
[scene.frame]
sides = "all_around"
thickness = "5 m"
joint = "plane"
[settings]
stop = "onset"
)";
}

TEST(RelaxationCase, SearchesThatCannotBeAreRefused) {
    const std::string reduction = "parameter = \"strength_reduction\"\n";
    const std::string acceleration = "horizontal = \"4 m/s2\"\nvertical = \"0 m/s2\"\n";
    const std::string shaken =
        "[[shaking]]\ntime = \"0 s\"\n" + acceleration + "[[shaking]]\ntime = \"9 s\"\n" + acceleration;
    const std::vector<std::pair<std::string, std::string_view>> searches{
        {"parameter = \"strength\"",
         "critical.parameter = \"strength\": must be tilt, friction, strength_reduction or weight"},
        {"parameter = \"tilt\"", "critical.lower: is required"},
        {"parameter = \"friction\"\nlower = \"10 deg\"\nupper = \"95 deg\"",
         "critical.upper = \"95 deg\": must be at least 0"},
        {"parameter = \"weight\"\ntolerance = 0", "critical.tolerance = 0: must be from"},
        {reduction + "lower = 0", "critical.lower = 0: must be more than 0"},
        {reduction + "lower = 3\nupper = 2",
         "critical.lower = 3: bounds are reversed: must be less than critical.upper (3 and 2)"},
        {reduction + "joints = [\"planes\"]",
         ":36:10: critical.joints = [ ... ]: \"planes\" is no joint of the scene: must be plane or intact"},
        {reduction + "path = \"slow\"",
         "critical.path = \"slow\": must be consolidated, preloaded, gravity, sudden or stages"},
        {reduction + "path = \"stages\"", "critical.path = \"stages\": needs stages of excavation"},
        {reduction + "path = \"consolidated\"\n" + shaken,
         "critical.path = \"consolidated\": a record of shaking is over"},
        {reduction + "paths = \"both\"", "critical.paths = \"both\": must be one or all"}};
    const std::string slope = slope_over("{ x = \"0 m\", y = \"0.2 m\" }");
    for (const auto& [search, words] : searches) {
        const std::string refusal = complaint(slope + "[critical]\n" + search + "\n");
        EXPECT_NE(refusal.find(words), std::string::npos) << search << ": " << refusal;
    }
}

TEST(RelaxationCase, SaysThatASlopeStandsOnCornersAlone) {
    const std::string through_toe = slope_over("{ x = \"0 m\", y = \"0 m\" }");
    const Analysis held = analysis_of(through_toe);
    EXPECT_EQ(word(held, "outcome"), "held_by_corners");
    EXPECT_TRUE(held.unfinished.empty());
    EXPECT_TRUE(warns(held, "the blocks rest only because corners bear on corners"));
    const Analysis counted = analysis_of(through_toe + "corners_bear = \"on\"\n");
    EXPECT_EQ(word(counted, "outcome"), "equilibrium");
    EXPECT_FALSE(warns(counted, "the blocks rest only"));
    const Analysis slides = analysis_of(slope_over("{ x = \"0 m\", y = \"0.2 m\" }"));
    EXPECT_EQ(word(slides, "outcome"), "onset");
    EXPECT_FALSE(warns(slides, "the blocks rest only"));

    const std::string search = "[critical]\nparameter = \"strength_reduction\"\n";
    const double of_plane = std::tan(degrees(20)) / std::tan(degrees(35));
    const Analysis searched = analysis_of(through_toe + search);
    EXPECT_TRUE(warns(searched, "at 0.520904 the blocks rest only because corners bear on corners"));
    EXPECT_NEAR(std::get<double>(searched.find("factor_of_safety")->value), of_plane, 0.005);  // the bracket
    const Analysis on_corners = analysis_of(through_toe + "corners_bear = \"on\"\n" + search);
    EXPECT_TRUE(warns(on_corners, "beyond a factor of 0.52 the blocks rest only"));
    EXPECT_GT(std::get<double>(on_corners.find("factor_of_safety")->value), 1.2);
    const NamedOutput* bound = searched.find("critical.bound_of_statics");
    ASSERT_NE(bound, nullptr);
    EXPECT_NEAR(std::get<double>(bound->value), of_plane, 1e-6);
}

TEST(RelaxationCase, SaysThatBlocksRestElsewhere) {
    // Two blocks that topple against a third and lean there.
    const std::string pushed = std::string(row_text) +
                               "[[shaking]]\ntime = \"0 s\"\nhorizontal = \"8 m/s2\"\nvertical = \"0 m/s2\"\n"
                               "[[shaking]]\ntime = \"0.2 s\"\nhorizontal = \"8 m/s2\"\nvertical = \"0 m/s2\"\n"
                               "[[shaking]]\ntime = \"0.21 s\"\nhorizontal = \"0 m/s2\"\nvertical = \"0 m/s2\"\n";
    const Analysis shaken = analysis_of(pushed);
    ASSERT_EQ(word(shaken, "outcome"), "equilibrium");
    EXPECT_TRUE(warns(pushed, "the blocks came to rest only after the onset of failure"));
    EXPECT_FALSE(warns(std::string(row_text), "the blocks came to rest only after the onset of failure"));
}

TEST(RelaxationCase, SaysThatDampingSlowsWhatFails) {
    const std::string slides = changed(row_text, "\"10 deg\"", "\"35 deg\"");
    const std::string shortly = "[settings]\nduration = \"0.3 s\"\nstop = \"duration\"\n";
    EXPECT_TRUE(warns(slides + shortly, "local damping slows what fails by 20 %"));
    EXPECT_FALSE(warns(slides + shortly + "local_damping = 0\n", "local damping"));
}

TEST(RelaxationCase, AWatchEndsTheRun) {
    const CaseModel model = parse_case(row_text, "case").model;
    const Analysis stopped = analyse_model(model, {.watch = [](double, const std::string&, bool) { return false; }});
    EXPECT_EQ(stopped.status, "interrupted");
    EXPECT_FALSE(stopped.unfinished.empty());
}

TEST(RelaxationCase, RoundTrip) {
    for (const std::string_view text : {row_text, blocks_text}) {
        const CaseFile first = parse_case(text, "first");
        const std::string resolved = resolved_toml(first);
        EXPECT_EQ(resolved, resolved_toml(parse_case(resolved, "second"))) << resolved;
    }
}

}  // namespace
}  // namespace delabole
