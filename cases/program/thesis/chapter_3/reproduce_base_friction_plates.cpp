// Plates 3.I to 3.XIII of the thesis as drawings: the models of Table 3.2 as they were cut, with their crack paths.
#include "cases/program/thesis/chapter_3/base_friction_model.hpp"
#include "cases/program/thesis/chapter_3/chapter_3.hpp"
#include "cases/program/thesis/imperial.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "plots/drawing/extent.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/block_figures.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

// A row of cases/thesis/chapter_3/plates.csv.
struct PlateModel {
    std::string plate;
    std::string test;
    static constexpr std::string_view file = "thesis/chapter_3/plates.csv";
    static constexpr auto fields() { return table_columns<&PlateModel::plate, &PlateModel::test>(); }
};

// A model in inches, its blocks and the printed crack paths up to the ground.
struct DrawnModel {
    std::vector<DrawnBlock> blocks;
    std::vector<Polyline> paths;
    Polyline saw_tooth;
    Frame frame;
};

// Draws a saw-toothed joint from the crest down to the bottom; the size of its teeth is not printed.
Polyline saw_tooth_joint(const BaseFrictionGeometry& geometry) {
    constexpr double tooth = 1;     // in, along the joint
    constexpr double height = 0.4;  // in, of a tooth
    const double crest = (geometry.slope_height - geometry.vertical_cut) / inch;
    const Point along(std::cos(geometry.joint_dip), -std::sin(geometry.joint_dip));
    const Point across(-along.y(), along.x());
    const double length = (geometry.slope_height + geometry.depth) / inch / -along.y();
    Polyline joint;
    for (int half = 0; half * tooth / 2 <= length; ++half) {
        const double side = (half % 2 == 0 ? -0.5 : 0.5) * height;
        joint.push_back(Point(crest / std::tan(geometry.slope_angle), crest) + half * tooth / 2 * along +
                        side * across);
    }
    return joint;
}

DrawnModel draw_model(const BaseFrictionState& state) {
    const BaseFrictionGeometry geometry = geometry_of(state);
    DrawnModel drawn;
    double right = 0;  // of the model, without the frame
    for (const auto& block : slope_scene(model_as_cut(geometry)).block) {
        DrawnBlock shown{.mode = block.fixed ? DrawnMode::fixed : DrawnMode::plain};
        for (const PlanePoint<>& corner : block.outline) {
            shown.outline.push_back(corner / inch);
            right = std::max(right, block.fixed ? right : shown.outline.back().x());
        }
        drawn.frame.include(shown.outline);
        drawn.blocks.push_back(std::move(shown));
    }
    if (geometry.saw_tooth) {
        drawn.saw_tooth = saw_tooth_joint(geometry);
    }
    constexpr double above_the_toe = 0.25;  // of the slope's height: where else a path came out is not printed
    const double toe = -geometry.vertical_cut / inch;
    const double top = toe + geometry.slope_height / inch;
    const bool through_toe = state.remark.find("did not pass through the toe") == std::string::npos;
    const double height = through_toe ? 0 : above_the_toe * geometry.slope_height / inch;
    const Point foot(std::max(0.0, toe + height) / std::tan(geometry.slope_angle), toe + height);
    for (const std::optional<double>& angle : {state.crack_angle_from, state.crack_angle_to}) {
        if (angle) {
            const double along = std::min((top - foot.y()) / std::tan(*angle), right - foot.x());
            drawn.paths.push_back({foot, foot + Point(along, along * std::tan(*angle))});
        }
    }
    return drawn;
}

std::string caption_of(const BaseFrictionState& state) {
    std::string text =
        state.test + ": " + words_for(state.behaviour, {"stable", "in limiting equilibrium", "unstable"});
    if (state.crack_angle_from && state.crack_angle_to) {
        const std::string least = human_number(*state.crack_angle_from / degrees(1), 3);
        const std::string most = human_number(*state.crack_angle_to / degrees(1), 3);
        text += ", " + least + (least == most ? "" : " to " + most) + "°";
    }
    return text;
}

// Draws the models of a plate beside each other, all with the toe to the left.
Figure plate_figure(const std::string& plate, const std::vector<const BaseFrictionState*>& models) {
    constexpr double gap = 4;  // in
    BlockDrawing drawing{.title =
                             "Plate " + plate + (models.size() > 1 ? ": the models as cut" : ": the model as cut")};
    std::vector<Label> labels;
    std::vector<Series> paths;
    double offset = 0;
    for (const BaseFrictionState* state : models) {
        DrawnModel model = draw_model(*state);
        const Point shift(offset - model.frame.x.lowest, 0);
        for (DrawnBlock& block : model.blocks) {
            for (Point& corner : block.outline) {
                corner += shift;
            }
            drawing.blocks.push_back(std::move(block));
        }
        for (Polyline& path : model.paths) {
            for (Point& end : path) {
                end += shift;
            }
            paths.emplace_back(Line{.points = path,
                                    .legend = paths.empty() ? "critical crack path, printed inclination" : "",
                                    .colour = Colour::vermilion});
        }
        if (!model.saw_tooth.empty()) {
            std::ranges::for_each(model.saw_tooth, [&](Point& corner) { corner += shift; });
            paths.emplace_back(Line{.points = model.saw_tooth, .legend = "saw-tooth joint", .colour = Colour::blue});
        }
        // A caption may be wider than its model: it ends with the drawing, not beyond it.
        const bool last = state == models.back();
        labels.push_back({.at = Point(last ? offset + model.frame.x.size() : offset, model.frame.y.highest),
                          .text = caption_of(*state),
                          .align = last ? Label::Align::right : Label::Align::left,
                          .raise = 0.8,
                          .boxed = false,
                          .size = 0.8});
        offset += model.frame.x.size() + gap;
    }
    Figure figure = block_figure(drawing);
    figure.x.title = "distance";
    figure.y.title = "height";
    figure.x.unit = figure.y.unit = "in";
    figure.series.insert(figure.series.end(), paths.begin(), paths.end());
    figure.labels.insert(figure.labels.end(), labels.begin(), labels.end());
    return figure;
}

}  // namespace

Reproduction reproduce_base_friction_plates(const Sheet& sheet) {
    const std::vector<PlateModel> rows = rows_of<PlateModel>();
    const std::vector<BaseFrictionState> states = rows_of<BaseFrictionState>();
    Reproduction result;
    sheet.add(Heading{"Plates 3.I to 3.XIII, drawn"});
    sheet.add(Paragraph{
        "Models of Table 3.2 as they were cut, in the last state that the table tells of, with the critical crack path "
        "at its printed inclination from the toe, or from a fourth of the slope's height above it where the table says "
        "that it did not pass through the toe. The thesis does not print how far the ground in front of the toe went, "
        "nor where columns begin, nor how large the teeth of 14D's joint are: that is chosen. The photographs are not "
        "at hand."});
    std::vector<std::string> plates;
    for (const PlateModel& row : rows) {
        if (std::ranges::find(plates, row.plate) == plates.end()) {
            plates.push_back(row.plate);
        }
    }
    for (const std::string& plate : plates) {
        std::vector<const BaseFrictionState*> models;
        for (const PlateModel& row : rows) {
            // The last state is the one in which the test ended.
            const auto last = std::find_if(states.rbegin(), states.rend(),
                                           [&](const BaseFrictionState& state) { return state.test == row.test; });
            if (row.plate == plate && last != states.rend()) {
                models.push_back(&*last);
            }
        }
        std::string file = "plate_" + plate;
        std::ranges::replace(file, '.', '_');
        for (std::size_t first = 0; first < models.size(); first += 2) {
            const std::vector<const BaseFrictionState*> pair(
                models.begin() + static_cast<std::ptrdiff_t>(first),
                models.begin() + static_cast<std::ptrdiff_t>(std::min(first + 2, models.size())));
            sheet.draw(plate_figure(plate, pair),
                       models.size() > 2 ? file + "_" + pair.front()->test.substr(0, 1) : file,
                       "The inclination of the path is the printed one.");
        }
    }
    return result;
}

}  // namespace delabole
