#include "plots/figures/figures.hpp"
#include "plots/drawing/extent.hpp"

#include "plots/drawing/free_place.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

namespace delabole {

namespace {

constexpr std::array curve_colours{Colour::blue,   Colour::vermilion, Colour::green,
                                   Colour::purple, Colour::orange,    Colour::black};
constexpr std::array curve_dashes{Dash::solid, Dash::dashed, Dash::dotted};

// Neighbouring curves differ in colour and dash, so that a black and white copy can be read.
Line curve_line(const NamedCurve& curve, std::size_t index, double x_unit, double y_unit) {
    Line line{.points = curve.points,
              .legend = curve.legend,
              .colour = curve_colours[index % curve_colours.size()],
              .dash = curve_dashes[index % curve_dashes.size()],
              .width = 3};
    for (Point& point : line.points) {
        point = {point.x() / x_unit, point.y() / y_unit};
    }
    return line;
}

// About: title and axes take so much of the height and the width, px.
Point px_per_unit(const Figure& figure) {
    return {(figure.width - 110) / (figure.x.range->second - figure.x.range->first),
            (figure.height - 135) / (figure.y.range->second - figure.y.range->first)};
}

// Draws the curves, each with its legend as a label on it, at another place on every curve where that is as free as
// any.
void add_labelled(std::vector<Line> lines, Figure& figure) {
    std::vector<std::string> legends;
    for (Line& line : lines) {
        legends.push_back(std::exchange(line.legend, ""));
    }
    figure.series.insert(figure.series.end(), lines.begin(), lines.end());
    for (std::size_t index = 0; index < lines.size(); ++index) {
        const Polyline& points = lines[index].points;
        if (points.empty() || legends[index].empty()) {
            continue;
        }
        constexpr std::size_t places_on_a_curve = 24;
        const std::size_t first = (2 * index + 1) * places_on_a_curve / (2 * lines.size());
        std::vector<LabelPlace> places;
        for (std::size_t place = 0; place < places_on_a_curve; ++place) {
            places.push_back({points[(first + place) % places_on_a_curve * points.size() / places_on_a_curve],
                              Label::Align::centre});
        }
        add_where_free(places, legends[index], px_per_unit(figure), figure, lines[index].colour);
    }
}

// Joins a number and its unit by a no-break space.
std::string unbroken(std::string_view text) {
    std::string result;
    for (const char letter : text) {
        result += letter == ' ' ? "\u00a0" : std::string(1, letter);
    }
    return result;
}

}  // namespace

Line level_line(double from, double to, double height, std::string legend, Colour colour) {
    return {.points = {{from, height}, {to, height}},
            .legend = std::move(legend),
            .colour = colour,
            .dash = Dash::dashed,
            .width = 2};
}

void set_rows(Figure& figure, std::size_t rows, int around, int height_of_row) {
    figure.y.grid = false;
    figure.y.range = std::pair{0.4, static_cast<double>(std::max<std::size_t>(rows, 1)) + 0.6};
    figure.width = 720;
    figure.height = around + height_of_row * static_cast<int>(std::max<std::size_t>(rows, 2));
}

Axis axis_of(std::string_view name, Dimension dimension) {
    return {.title = human_name(name), .unit = human_unit(display_unit(dimension).symbol)};
}

void mark_statements(const std::vector<PrintedStatement>& statements, double x_unit, double y_unit, Figure& figure) {
    char letter = 'A';
    Polyline marks;
    for (const PrintedStatement& statement : statements) {
        const Point at{statement.at.x() / x_unit, statement.at.y() / y_unit};
        marks.push_back(at);
        figure.series.emplace_back(Points{.points = {at},
                                          .legend = std::string(1, letter) + ": " + statement.text,
                                          .colour = Colour::black,
                                          .marker = letter % 2 ? Marker::filled_circle : Marker::filled_diamond,
                                          .size = 1.6});
        letter = letter == 'Z' ? 'A' : static_cast<char>(letter + 1);
    }
    if (marks.empty()) {
        return;
    }
    const Point scale = px_per_unit(figure);
    letter = 'A';
    for (const Point& mark : marks) {
        std::vector<LabelPlace> places;
        for (const auto& [right, up, align] :
             {std::tuple{0, 20, Label::Align::centre}, std::tuple{0, -22, Label::Align::centre},
              std::tuple{12, 0, Label::Align::left}, std::tuple{-12, 0, Label::Align::right},
              std::tuple{10, 16, Label::Align::left}, std::tuple{-10, 16, Label::Align::right},
              std::tuple{10, -18, Label::Align::left}, std::tuple{-10, -18, Label::Align::right}}) {
            places.push_back({mark + Point(right / scale.x(), up / scale.y()), align});
        }
        add_where_free(places, std::string(1, letter), scale, figure);
        figure.labels.back().boxed = false;  // a ground of its own would hide the curves that the mark stands on
        letter = letter == 'Z' ? 'A' : static_cast<char>(letter + 1);
    }
}

Figure factor_of_safety_against_water(const WaterDepthCurves& data) {
    Figure figure{.title = data.title,
                  .x = {.title = data.ratio, .range = std::pair{0.0, 1.0}},
                  .y = {.title = "factor of safety"}};
    Extent shown;
    shown.include(1);
    std::vector<Line> lines;
    for (std::size_t index = 0; index < data.curves.size(); ++index) {
        lines.push_back(curve_line(data.curves[index], index, 1, 1));
        for (const Point& point : lines.back().points) {
            shown.include(point.y());
        }
    }
    figure.series.insert(figure.series.end(), lines.begin(), lines.end());
    figure.series.emplace_back(Line{.points = {{0, 1}, {1, 1}},
                                    .legend = "factor of safety 1",
                                    .colour = Colour::black,
                                    .dash = Dash::dashed,
                                    .width = 1.5});

    for (const PrintedStatement& statement : data.statements) {
        shown.include(statement.at.y());
    }
    // The range leaves room for the letters of the marks, and includes zero, because the distance to failure is to be
    // judged.
    figure.y.range = std::pair{std::min(0.0, shown.lowest), shown.highest + 0.08 * shown.size() + 0.05};
    mark_statements(data.statements, 1, 1, figure);
    return figure;
}

Figure failure_locus_figure(const FailureLoci& data) {
    const double angle_unit = display_unit(Dimension::angle).si_per_unit;
    const double stress_unit = display_unit(Dimension::stress).si_per_unit;
    Figure figure{.title = data.title,
                  .x = axis_of("friction_angle", Dimension::angle),
                  .y = axis_of("cohesion", Dimension::stress)};

    std::vector<Line> lines;
    Frame bounds;
    for (std::size_t index = 0; index < data.loci.size(); ++index) {
        lines.push_back(curve_line(data.loci[index], index, angle_unit, stress_unit));
        bounds.include(lines.back().points);
    }
    const auto given =
        data.given ? std::optional(Point(data.given->x() / angle_unit, data.given->y() / stress_unit)) : std::nullopt;
    if (given) {
        bounds.include(*given);
    }
    for (const LaboratoryRange& range : data.laboratory) {
        if (range.friction_angle) {
            bounds.x.include(range.friction_angle->lower / angle_unit);
            bounds.x.include(range.friction_angle->upper / angle_unit);
        }
        if (range.cohesion) {
            bounds.y.include(range.cohesion->lower / stress_unit);
            bounds.y.include(range.cohesion->upper / stress_unit);
        }
    }
    if (bounds.x.empty() || bounds.y.empty()) {
        bounds = {.x = {0, 90}, .y = {0, 1}};
    }
    const double top = bounds.y.highest + 0.05 * std::max(bounds.y.size(), 1e-6);
    figure.x.range = std::pair{bounds.x.lowest, bounds.x.highest + 1e-6};
    figure.y.range = std::pair{std::min(0.0, bounds.y.lowest), top};

    const auto clipped = [](const std::optional<Interval>& range, double unit, std::pair<double, double> shown) {
        return range
                   ? std::pair{std::max(range->lower / unit, shown.first), std::min(range->upper / unit, shown.second)}
                   : shown;
    };
    constexpr std::array colours{Colour::orange, Colour::sky, Colour::grey, Colour::green};
    for (std::size_t index = 0; index < data.laboratory.size(); ++index) {
        const LaboratoryRange& range = data.laboratory[index];
        const auto [left, right] = clipped(range.friction_angle, angle_unit, *figure.x.range);
        const auto [bottom, upper] = clipped(range.cohesion, stress_unit, *figure.y.range);
        const Colour colour = colours[index % colours.size()];
        if (left < right && bottom < upper) {
            figure.series.emplace_back(
                Region{.outline = {{left, bottom}, {right, bottom}, {right, upper}, {left, upper}},
                       .legend = range.legend,
                       .colour = colour});
        } else {  // all values are equal
            figure.series.emplace_back(
                Line{.points = {{left, bottom}, {right, upper}}, .legend = range.legend, .colour = colour, .width = 5});
        }
    }
    if (given) {  // before the labels, which keep off it
        figure.series.emplace_back(
            Points{.points = {*given}, .legend = "as given", .marker = Marker::circle, .size = 1.8});
    }
    add_labelled(std::move(lines), figure);
    return figure;
}

Figure tornado_figure(std::string_view title, std::vector<SensitivityBar> bars) {
    std::erase_if(bars, [](const SensitivityBar& bar) { return !std::isfinite(bar.effect); });
    constexpr double rounding = 1e-12;  // of a factor of safety
    for (SensitivityBar& bar : bars) {
        bar.effect = std::abs(bar.effect) < rounding ? 0 : bar.effect;
    }
    std::stable_sort(bars.begin(), bars.end(), [](const SensitivityBar& first, const SensitivityBar& second) {
        return std::abs(first.effect) > std::abs(second.effect);
    });
    constexpr std::size_t most_bars = 8;
    bars.resize(std::min(bars.size(), most_bars));

    Figure figure{.title = std::string(title), .x = {.title = "change of the factor of safety"}};
    std::array<Boxes, 4> kinds{{{.legend = "makes it safer", .colour = Colour::blue},
                                {.legend = "makes it less safe", .colour = Colour::vermilion},
                                {.colour = Colour::pale_blue},
                                {.colour = Colour::pale_vermilion}}};
    Extent range;
    range.include(0);
    for (const SensitivityBar& bar : bars) {
        range.include(bar.effect);
    }
    const double gap = 0.02 * range.size();
    for (std::size_t index = 0; index < bars.size(); ++index) {
        const SensitivityBar& bar = bars[index];
        const double position = static_cast<double>(bars.size() - index);
        const bool lowers = bar.effect < 0;
        kinds[(bar.pale ? 2 : 0) + (lowers ? 1 : 0)].boxes.push_back(
            {{std::min(0.0, bar.effect), position - 0.32}, {std::max(0.0, bar.effect), position + 0.32}});
        figure.y.ticks.emplace_back(position, wrapped(human_name(bar.name) + ", " + unbroken(bar.change), 22));
        figure.labels.push_back(
            {.at = {bar.effect + (lowers ? -gap : gap), position},
             .text = bar.effect == 0 ? "0" : (lowers ? "−" : "+") + human_number(std::abs(bar.effect), 2),
             .align = lowers ? Label::Align::right : Label::Align::left,
             .boxed = false});
    }
    for (const std::size_t kind : {0U, 1U}) {
        if (kinds[kind].boxes.empty()) {
            std::swap(kinds[kind].legend, kinds[kind + 2].legend);
        }
    }
    figure.series.insert(figure.series.end(), kinds.begin(), kinds.end());
    set_rows(figure, bars.size(), 130, 74);
    if (!bars.empty()) {
        figure.series.emplace_back(Line{.points = {{0, 0.4}, {0, figure.y.range->second}}, .width = 1.5});
        // Leaves room for the numbers at the bars' ends; the names of the inputs leave about this many pixels for the
        // bars.
        constexpr double plot_width = 380;
        constexpr double letter_width = 13;
        std::array<double, 2> room{};  // below and above zero, as a share of the width
        for (std::size_t index = 0; index < bars.size(); ++index) {
            const double letters = 1.5 + static_cast<double>(letter_count(figure.labels[index].text));
            double& side = room[bars[index].effect < 0 ? 0 : 1];
            side = std::max(side, letters * letter_width / plot_width);
        }
        const double per_share = std::max(range.size(), 1e-12) / (1 - room[0] - room[1]);
        figure.x.range = std::pair{range.lowest - room[0] * per_share, range.highest + room[1] * per_share};
    }
    return figure;
}

Figure critical_figure(const CriticalSearchDrawing& drawing) {
    const double unit = display_unit(drawing.dimension).si_per_unit;
    Figure figure{
        .title = drawing.title, .x = axis_of(drawing.quantity, drawing.dimension), .y = {.title = "factor of safety"}};
    Frame bounds;
    for (std::size_t index = 0; index < drawing.curves.size(); ++index) {
        const Line line = curve_line(drawing.curves[index], index, unit, 1);
        bounds.include(line.points);
        figure.series.emplace_back(line);
    }
    if (!bounds.x.empty() && bounds.y.lowest <= 1 && bounds.y.highest >= 1) {
        figure.series.emplace_back(Line{.points = {{bounds.x.lowest, 1}, {bounds.x.highest, 1}},
                                        .legend = "factor of safety 1",
                                        .dash = Dash::dashed,
                                        .width = 1.5});
    }
    if (drawing.critical.allFinite()) {
        // Towards the limits of the geometry the factor of safety increases without bound, but the values near the
        // least one matter.
        const double least = drawing.critical.y();
        const double top = std::min(bounds.y.highest, std::max(2.0, 4 * least));
        if (top > least) {
            const double margin = 0.08 * (top - least);
            figure.y.range = std::pair{std::min(least, bounds.y.lowest) - margin, top + margin};
        }
        const Point at{drawing.critical.x() / unit, drawing.critical.y()};
        figure.series.emplace_back(Points{.points = {at},
                                          .legend = "least factor of safety " + human_number(at.y(), 3) + " at " +
                                                    human_number(at.x(), 3) +
                                                    (figure.x.unit.empty() ? "" : " " + figure.x.unit),
                                          .size = 1.8});
    }
    return figure;
}

}  // namespace delabole
