#include "plots/figures/figures.hpp"

#include "fitting/work/words.hpp"
#include "plots/drawing/extent.hpp"
#include "plots/drawing/polygon.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

// Outline between the surface and the ends of the pressure arrows, which are scaled by `metres_per_pascal`.
Polyline pressure_outline(const PressureDiagram& diagram, double metres_per_pascal) {
    const Polyline& surface = diagram.surface;
    const std::size_t count = std::min(surface.size(), diagram.pressure.size());
    if (count < 2) {
        return {};
    }
    Polyline outline(surface.begin(), surface.begin() + static_cast<std::ptrdiff_t>(count));
    for (std::size_t index = count; index-- > 0;) {
        const Point along =
            index + 1 < count ? Point(surface[index + 1] - surface[index]) : Point(surface[index] - surface[index - 1]);
        const Point to_the_right = Point(along.y(), -along.x()).normalized();
        outline.push_back(surface[index] + metres_per_pascal * diagram.pressure[index] * to_the_right);
    }
    return outline;
}

double greatest_pressure(const SectionDrawing& drawing) {
    double greatest = 0;
    for (const PressureDiagram& diagram : drawing.water_pressure) {
        for (const double pressure : diagram.pressure) {
            greatest = std::isfinite(pressure) ? std::max(greatest, pressure) : greatest;
        }
    }
    return greatest;
}

// One shaft for each force that is drawn, in order.
std::vector<Arrows::Shaft> force_shafts(const SectionDrawing& drawing) {
    constexpr double longest = 0.2;          // of the extent of the ground
    constexpr double least_share = 1.0 / 3;  // of the longest arrow
    Frame frame;
    frame.include(drawing.ground);
    double greatest = 0;
    for (const SectionForce& force : drawing.forces) {
        greatest = std::max(greatest, force.force);
    }
    std::vector<Arrows::Shaft> shafts;
    for (const SectionForce& force : drawing.forces) {
        if (force.force > 0 && !frame.empty()) {
            const double length = longest * frame.size().maxCoeff() * std::max(least_share, force.force / greatest);
            shafts.push_back({force.at, force.at + length * force.direction});
        }
    }
    return shafts;
}

void add_forces(const SectionDrawing& drawing, const Point& raise, double px_per_metre, Figure& figure) {
    Arrows arrows{.shafts = force_shafts(drawing),
                  .legend = "forces, " + human_unit(shown_unit(Dimension::force_per_length).symbol),
                  .colour = Colour::black,
                  .width = 3};
    if (arrows.shafts.empty()) {
        return;
    }
    for (Arrows::Shaft& shaft : arrows.shafts) {
        shaft = {shaft.from + raise, shaft.to + raise};
    }
    const std::vector<Arrows::Shaft> shafts = arrows.shafts;
    figure.series.emplace_back(std::move(arrows));
    std::size_t index = 0;
    for (const SectionForce& force : drawing.forces) {
        if (force.force > 0) {
            const auto& [tail, tip] = shafts[index++];
            const double beyond = force.direction.y() < 0 ? -0.6 : 0.6;
            const std::vector<LabelPlace> upright{{tip, Label::Align::left, beyond},
                                                  {tip, Label::Align::right, beyond},
                                                  {tail, Label::Align::left, -beyond},
                                                  {tail, Label::Align::right, -beyond}};
            // The text of a force that points into the slope stands in front of its tail.
            const Point& front = force.direction.x() > 0.7 ? tail : tip;
            std::vector<LabelPlace> sideways;
            for (const double lines_up : {0.0, 0.6, -0.6, 1.3, -1.3, 2.0}) {
                sideways.push_back({front, Label::Align::right, lines_up});
            }
            add_where_free(std::abs(force.direction.x()) > 0.7 ? sideways : upright, force.text,
                           Point::Constant(px_per_metre), figure);
        }
    }
}

Frame frame_of(const SectionDrawing& drawing) {
    Frame frame;
    for (const Polyline* line : {&drawing.ground, &drawing.failure_plane, &drawing.tension_crack,
                                 &drawing.observed_profile, &drawing.predicted_profile}) {
        frame.include(*line);
    }
    if (frame.empty()) {
        frame.include(Polyline{{0, 0}, {1, 1}});
    }
    for (const Polyline& bolt : drawing.bolts) {
        frame.include(bolt);
    }
    for (const LevelMark& level : drawing.levels) {
        frame.include(Point(frame.x.lowest, level.height));
    }
    for (const Arrows::Shaft& shaft : force_shafts(drawing)) {
        frame.include(Polyline{shaft.from, shaft.to});
    }
    // The margin at the top is for the text of the highest level. The ground is cut off at the sides of the frame.
    const double margin = 0.12 * std::max(frame.size().maxCoeff(), 1e-9);
    const double side = drawing.ground.empty() ? margin : 0;
    return {{frame.x.lowest - side, frame.x.highest + side}, {frame.y.lowest - margin, frame.y.highest + margin}};
}

void add_water(const SectionDrawing& drawing, double height, Figure& figure) {
    const double greatest = greatest_pressure(drawing);
    std::string legend = "water pressure";
    for (const PressureDiagram& diagram : drawing.water_pressure) {
        const Polyline outline = greatest > 0 ? pressure_outline(diagram, 0.12 * height / greatest) : Polyline{};
        if (!outline.empty()) {
            figure.series.emplace_back(Region{
                .outline = outline, .legend = std::exchange(legend, ""), .colour = Colour::sky, .opacity = 0.55});
            figure.series.emplace_back(Line{.points = closed(outline), .colour = Colour::blue, .width = 1});
        }
    }
}

}  // namespace

void add_measure(const Measure& measure, Figure& figure) {
    figure.arrows.push_back({.from = measure.from, .to = measure.to, .colour = Colour::grey, .both_heads = true});
    figure.labels.push_back({.at = 0.5 * (measure.from + measure.to), .text = "\u00a0" + measure.text, .boxed = false});
}

Figure section_figure(const SectionDrawing& drawing) {
    const Frame frame = frame_of(drawing);
    const Point size = frame.size();
    Figure figure{.title = drawing.title,
                  .x = {.title = "distance from the toe", .unit = "m"},
                  .y = {.title = drawing.toe_elevation != 0 ? "elevation" : "height above the toe", .unit = "m"},
                  .equal_scales = true};
    figure.x.range = std::pair{frame.x.lowest, frame.x.highest};
    figure.y.range = std::pair{frame.y.lowest + drawing.toe_elevation, frame.y.highest + drawing.toe_elevation};

    Polyline rock = drawing.ground;
    if (rock.size() >= 2) {
        rock.emplace_back(rock.back().x(), frame.y.lowest);
        rock.emplace_back(drawing.ground.front().x(), frame.y.lowest);
        figure.series.emplace_back(Region{.outline = rock, .colour = Colour::rock, .opacity = 0.5});
    }
    for (const LevelMark& level : drawing.levels) {
        figure.series.emplace_back(Line{.points = {{frame.x.lowest, level.height}, {frame.x.highest, level.height}},
                                        .colour = Colour::grey,
                                        .dash = Dash::dotted,
                                        .width = 1});
        figure.labels.push_back({.at = {frame.x.lowest + 0.015 * size.x(), level.height + drawing.toe_elevation},
                                 .text = level.text,
                                 .raise = 0.55,
                                 .boxed = false});
    }
    add_water(drawing, size.y(), figure);
    const bool is_plain = drawing.predicted_profile.empty() && drawing.observed_profile.empty();
    const std::string ground = is_plain ? "" : "ground before the failure";
    add_line(figure, {drawing.ground, ground, Colour::black, Dash::solid, 3});
    add_line(figure, {drawing.predicted_profile, "predicted after the failure", Colour::green, Dash::solid, 6});
    add_line(figure, {drawing.failure_plane, "failure plane", Colour::vermilion, Dash::dashed, 3});
    add_line(figure, {drawing.tension_crack, "tension crack", Colour::purple, Dash::dashed, 3});
    add_line(figure, {drawing.water_in_crack, "water in the crack", Colour::blue, Dash::solid, 5});
    for (const Polyline& bolt : drawing.bolts) {
        add_line(figure, {bolt, "", Colour::green, Dash::solid, 3});
    }
    add_line(figure, {drawing.observed_profile, "", Colour::black, Dash::dotted, 2});
    if (!drawing.observed_profile.empty()) {
        figure.series.emplace_back(Points{.points = drawing.observed_profile,
                                          .legend = "observed after the failure",
                                          .marker = Marker::filled_circle,
                                          .size = 1.3});
    }

    for (Series& series : figure.series) {
        if (auto* region = std::get_if<Region>(&series)) {
            region->outline = raised(std::move(region->outline), drawing.toe_elevation);
        } else if (auto* line = std::get_if<Line>(&series)) {
            line->points = raised(std::move(line->points), drawing.toe_elevation);
        } else if (auto* points = std::get_if<Points>(&series)) {
            points->points = raised(std::move(points->points), drawing.toe_elevation);
        }
    }
    const Point raise(0, drawing.toe_elevation);
    for (const Measure& measure : drawing.measures) {
        add_measure({measure.from + raise, measure.to + raise, measure.text}, figure);
    }
    // The plot is about 540 px wide; title and axis take about 120 px of the height.
    const double plot_height = std::clamp(540 * size.y() / size.x(), 200.0, 680.0);
    figure.height = static_cast<int>(plot_height) + 120;
    const double px_per_metre = std::min(540 / size.x(), plot_height / size.y());
    add_forces(drawing, raise, px_per_metre, figure);
    for (SectionNote note : drawing.notes) {
        for (LabelPlace& place : note.places) {
            place.at += raise;
        }
        add_where_free(note.places, note.text, Point::Constant(px_per_metre), figure);
    }
    return figure;
}

}  // namespace delabole
