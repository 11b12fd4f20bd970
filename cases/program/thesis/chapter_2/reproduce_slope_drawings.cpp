// Figs 2.4, 2.5, 2.7 and 2.10 of the thesis drawn again from printed numbers and from the models' scenes.
#include "cases/program/models/relaxation/figures.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/thesis/chapter_2/chapter_2.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/block_figures.hpp"

#include <array>
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
    Figure figure{.title = "The failure of 1967 (Figs 2.4 and 2.5)",
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
             .dash = Dash::dashed}};
    for (const auto& [level, what] :
         {std::pair{top_level, "575 ft: third bench"}, std::pair{knee_level, "425 ft: seepage"},
          std::pair{foot_level, "350 ft: foot"}}) {
        figure.labels.push_back({.at = Point(-20, level), .text = what, .align = Label::Align::right, .size = 0.8});
    }
    figure.x.range = {-160, 180};
    return figure;
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
    return block_figure(drawing);
}

}  // namespace

Reproduction reproduce_slope_drawings(const ResultFolder& folder, Report& report) {
    report.blocks.emplace_back(Heading{"Figs 2.4, 2.5, 2.7 and 2.10, drawn again"});
    report.blocks.emplace_back(
        folder.draw(profile_figure(), "fig_2_4", "Failure surfaces between the inclinations surveyed."));
    struct Drawing {
        std::string_view model;
        std::string title;
        std::string file;
        std::string caption;
    };
    const std::array drawings{
        Drawing{"plate_2_ii", "Undercutting (Figs 2.7 and 2.10 b)", "fig_2_7",
                "A fault with gouge, joint A, cleavage."},
        Drawing{"plate_2_iii", "Joints A and B and cleavage (Fig 2.10 a)", "fig_2_10_a", "The model of Plate 2.III."},
        Drawing{"plate_2_i", "Joints A and C and cleavage (Fig 2.10 a)", "fig_2_10_c", "The model of Plate 2.I."},
        Drawing{"plate_2_vi", "Joint B ends at a discontinuity (Fig 2.10 b)", "fig_2_10_b",
                "The model of Plate 2.VI."}};
    for (const Drawing& drawing : drawings) {
        report.blocks.emplace_back(
            folder.draw(scene_figure(drawing.model, drawing.title), drawing.file, drawing.caption));
    }
    Reproduction result;
    // The knee lies a third of the way up; between gentlest and steepest the failure's top moves by so much.
    const double wide = surface(degrees(40), degrees(70)).back().x() - surface(degrees(45), degrees(75)).back().x();
    result.rows.push_back({"top of the failure behind its foot", "40 to 45° and 70 to 75°",
                           human_number(surface(degrees(45), degrees(75)).back().x(), 3) + " to " +
                               human_number(surface(degrees(40), degrees(70)).back().x(), 3) + " ft",
                           human_number(wide, 2) + " ft", "what the inclinations leave open"});
    report.blocks.emplace_back(printed_table("The printed inclinations", result.rows));
    result.json["top_behind_foot_ft"] = {surface(degrees(45), degrees(75)).back().x(),
                                         surface(degrees(40), degrees(70)).back().x()};
    return result;
}

}  // namespace delabole
