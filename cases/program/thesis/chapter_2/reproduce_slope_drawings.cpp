// Figs 2.1, 2.4, 2.5, 2.7 and 2.10 of the thesis drawn again from printed numbers and from the models' scenes.
#include "cases/program/models/relaxation/figures.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/thesis/chapter_2/chapter_2.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "kinematics/kinematics.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/block_figures.hpp"
#include "plots/figures/stereonet.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

// 2.2.3, in feet.
constexpr double foot_level = 350;
constexpr double knee_level = 425;
constexpr double top_level = 575;

// The line from the foot of the failure up the lower surface and the upper one.
Polyline surface(double lower, double upper) {
    const double knee = (knee_level - foot_level) / std::tan(lower);
    return {Point(0, foot_level), Point(knee, knee_level),
            Point(knee + (top_level - knee_level) / std::tan(upper), top_level)};
}

// Figs 2.4 and 2.5: what the survey leaves open, between the gentlest and the steepest surfaces.
Figure profile_figure() {
    const double boundary_x = surface(degrees(40), degrees(70))[1].x() - 5;
    Figure figure{.title = "Figs 2.4 and 2.5: the failure of 1967",
                  .x = {.title = "distance from the foot"},
                  .y = {.title = "level"}};
    figure.x.unit = figure.y.unit = "ft";
    figure.equal_scales = true;
    figure.series = {
        Line{.points = surface(degrees(40), degrees(70)), .legend = "40° and 70°", .colour = Colour::blue},
        Line{.points = surface(degrees(45), degrees(75)), .legend = "45° and 75°", .colour = Colour::vermilion},
        Line{.points = {Point(0, foot_level), Point((top_level - foot_level) / std::tan(degrees(60)), top_level)},
             .legend = "face of the models, 60°",
             .colour = Colour::black,
             .dash = Dash::dashed},
        Line{.points = {Point(0, foot_level), Point((top_level - foot_level) / std::tan(degrees(70)), top_level)},
             .legend = "face of Fig 2.8, 70°",
             .colour = Colour::black,
             .dash = Dash::dotted},
        // Traced north of the fall at 420 ft; that it is the fault where the two surfaces meet is a speculation.
        Line{.points = {Point(boundary_x - 60, 360), Point(boundary_x + 80, 500)},
             .legend = "green over grey slate, perhaps a fault: 420 ft, 45° to the pit",
             .colour = Colour::green}};
    for (const auto& [level, what] :
         {std::pair{617.3, "617.3 ft: bench 1, cracks"}, std::pair{top_level, "575 ft: third bench"},
          std::pair{475.0, "475 ft: some seepage"}, std::pair{knee_level, "425 ft: seepage"},
          std::pair{foot_level, "350 ft: foot"}}) {
        figure.labels.push_back({.at = Point(-20, level), .text = what, .align = Label::Align::right, .size = 0.8});
    }
    figure.x.range = {-270, 180};
    figure.height = 560;
    figure.y.range = {340, 630};
    return figure;
}

// How each joint set lies, as a short line with its name and dip, in the space in front of the face.
void add_directions(const RelaxationSlope& slope, Figure& figure) {
    constexpr double half = 0.025;     // m, of a line
    constexpr double between = 0.075;  // m
    std::vector<std::string> named;
    for (const SlopeCut& cut : slope.geometry.cut) {
        const auto* set = std::get_if<JointSetCut>(&cut.trace);
        if (set == nullptr || std::ranges::find(named, cut.joint) != named.end() || cut.joint == "fault") {
            continue;
        }
        const Point middle(-0.16, 0.3 - between * static_cast<double>(named.size()));
        const Point along = half * Point(std::cos(set->dip), std::sin(set->dip));
        figure.series.emplace_back(Line{.points = {middle - along, middle + along}, .colour = Colour::vermilion});
        figure.labels.push_back({.at = middle + Point(half + 0.01, 0),
                                 .text = cut.joint + ", " + human_number(std::abs(set->dip) / degrees(1), 3) + "°",
                                 .size = 0.8});
        named.push_back(cut.joint);
    }
}

Figure scene_figure(std::string_view name, const std::string& title) {
    const RelaxationStudy study = slope_model(name);
    const auto& slope = std::get<RelaxationSlope>(study.model.scene);
    const SlopeScene scene = slope_scene(slope);
    BlockDrawing drawing{.title = title};
    for (const SlopeRock& rock : slope.rock) {
        drawing.rocks.push_back(rock.name);
    }
    for (std::size_t block = 0; block < scene.block.size(); ++block) {
        DrawnBlock shown;
        for (const PlanePoint<>& corner : scene.block[block].outline) {
            shown.outline.push_back(corner);
        }
        shown.mode = scene.block[block].fixed ? DrawnMode::fixed : DrawnMode::plain;
        if (!scene.block[block].fixed) {
            shown.rock = scene.rock[block];
        }
        drawing.blocks.push_back(std::move(shown));
    }
    Figure figure = block_figure(drawing);
    add_directions(slope, figure);
    return figure;
}

// Fig 2.1 from the ranges that the text prints: the poles themselves are not at hand.
Figure stereonet_figure(const Kinematics& model, const KinematicsResult& sets) {
    StereonetDrawing drawing{.title = "Fig 2.1: joint sets of the west face",
                             .slope = model.slope,
                             .friction_angle = model.strength.friction_angle,
                             .lateral_limit = model.lateral_limit};
    for (std::size_t set = 0; set < sets.joint_set.size(); ++set) {
        const JointSetFeasibility& own = sets.joint_set[set];
        drawing.joint_set.push_back({own.name, own.mean, sets.sampled[set], sets.sampled_weights[set]});
    }
    return pole_figure(drawing);
}

std::string model_name(const std::string& set) {
    std::string name = human_name(set);
    constexpr std::string_view prefix = "joint set ";
    if (name.starts_with(prefix)) {
        name = "joint " + std::string(1, static_cast<char>(std::toupper(name.back())));
    }
    return name;
}

// The sets' mean planes in the section across the face, from one point.
Figure traces_figure(const KinematicsResult& sets) {
    Figure figure{.title = "Fig 2.1: mean planes in the section",
                  .x = {.title = "out of the slope to the left", .range = std::pair(-1.6, 1.6)},
                  .y = {.title = "up", .range = std::pair(-1.25, 1.25)},
                  .equal_scales = true};
    constexpr std::array colours{Colour::blue, Colour::vermilion, Colour::green, Colour::orange, Colour::purple};
    std::size_t number = 0;
    for (const JointSetFeasibility& set : sets.joint_set) {
        // A dip to the pit falls to the left.
        const Point along(std::cos(set.apparent_dip), std::sin(set.apparent_dip));
        figure.series.emplace_back(
            Line{.points = {-along, along},
                 .legend = model_name(set.name) + ", " + human_number(set.apparent_dip / degrees(1), 3) + "°",
                 .colour = colours[number % colours.size()],
                 .dash = number < colours.size() - 1 ? Dash::solid : Dash::dashed});
        ++number;
    }
    return figure;
}

// Apparent dips of the sets beside those of the models; negative: into the slope.
void add_traces(const KinematicsResult& sets, double face_dip_direction, const ResultFolder& folder, Report& report,
                Reproduction& result) {
    struct Printed {
        std::string_view dip;
        std::string remark;
    };
    constexpr std::size_t cleavage = 3;
    const double north_of_the_fall =
        apparent_dip({degrees(10), sets.joint_set[cleavage].mean.dip_direction}, face_dip_direction);
    // The case's sets are joint_set_a, b, c, cleavage and faults, in this order.
    const std::array<Printed, 5> printed{
        {{"70 deg (models)", "the model has the flattest of 70 to 90, that of the upper surface"},
         {"-85 deg (models)", ""},
         {"50 deg (models)", "40 of the field and 10 more for the friction of the mixture"},
         {"-5, -10, -15 deg (models)",
          "as measured throughout the quarry; the 10 deg measured north of the fall give " +
              human_number(north_of_the_fall / degrees(1), 2) + " deg"},
         {"70 to 90 deg", "they go with joint A"}}};
    for (std::size_t set = 0; set < sets.joint_set.size() && set < printed.size(); ++set) {
        const double apparent = sets.joint_set[set].apparent_dip / degrees(1);
        result.rows.push_back({"Fig 2.1: mean of " + model_name(sets.joint_set[set].name) + " in the section",
                               std::string(printed[set].dip), human_number(apparent, 3) + " deg", "",
                               printed[set].remark});
    }
    report.blocks.emplace_back(
        folder.draw(traces_figure(sets), "fig_2_1_traces", "Apparent dips across the face; the pit is to the left."));
}

}  // namespace

Reproduction reproduce_slope_drawings(const ResultFolder& folder, Report& report) {
    Reproduction result;
    const auto study = std::get<KinematicsStudy>(built_in_case("delabole_1967", "delabole_joint_sets").model);
    const KinematicsResult sets = analyse(study);
    report.blocks.emplace_back(Heading{"Figs 2.1, 2.4, 2.5, 2.7 and 2.10, drawn again"});
    report.blocks.emplace_back(Paragraph{
        "Fig 2.1 is drawn with poles spread evenly over the ranges of the text. Fig 2.6, a plan of the crest that is "
        "not to scale, and its pegs cannot be drawn: no place of a crack or peg is printed but the benches they lie "
        "on."});
    report.blocks.emplace_back(
        folder.draw(stereonet_figure(study.model, sets), "fig_2_1", "Poles sampled from the printed ranges."));
    add_traces(sets, study.model.slope.face_dip_direction, folder, report, result);
    report.blocks.emplace_back(
        folder.draw(profile_figure(), "fig_2_4", "Failure surfaces between the inclinations surveyed."));
    struct Drawing {
        std::string_view model;
        std::string title;
        std::string file;
        std::string caption;
    };
    const std::array drawings{
        Drawing{"plate_2_ii", "Figs 2.7 and 2.10 (b): undercutting", "fig_2_7",
                "A fault with gouge, joint A, cleavage."},
        Drawing{"plate_2_iii", "Fig 2.10 (a): joints A, B and cleavage", "fig_2_10_a", "The model of Plate 2.III."},
        Drawing{"plate_2_i", "Fig 2.10 (a): joints A, C and cleavage", "fig_2_10_c", "The model of Plate 2.I."},
        Drawing{"plate_2_vi", "Fig 2.10 (b): joint B ends at a discontinuity", "fig_2_10_b",
                "The model of Plate 2.VI."}};
    for (const Drawing& drawing : drawings) {
        report.blocks.emplace_back(
            folder.draw(scene_figure(drawing.model, drawing.title), drawing.file, drawing.caption));
    }
    // The knee lies a third of the way up; between gentlest and steepest the failure's top moves by so much.
    const double wide = surface(degrees(40), degrees(70)).back().x() - surface(degrees(45), degrees(75)).back().x();
    result.rows.push_back({"top of the failure behind its foot", "40 to 45° and 70 to 75°",
                           human_number(surface(degrees(45), degrees(75)).back().x(), 3) + " to " +
                               human_number(surface(degrees(40), degrees(70)).back().x(), 3) + " ft",
                           human_number(wide, 2) + " ft", "what the inclinations leave open"});
    report.blocks.emplace_back(printed_table("The printed inclinations", result.rows));
    return result;
}

}  // namespace delabole
