#include "plots/figures/block_figures.hpp"

#include "plots/drawing/extent.hpp"
#include "plots/drawing/gnuplot_words.hpp"
#include "plots/drawing/polygon.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/mode_style.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace delabole {

namespace {

// Ticks at whole numbers of blocks.
std::vector<std::pair<double, std::string>> block_ticks(const Extent& blocks) {
    constexpr int most = 16;
    const double step = std::max(1.0, tick_step(std::max(blocks.size(), 1.0), most));
    std::vector<std::pair<double, std::string>> ticks;
    for (double number = step * std::ceil(blocks.lowest / step); number <= blocks.highest; number += step) {
        ticks.emplace_back(number, human_number(number, 9));
    }
    return ticks;
}

// A band for each run of blocks in the same mode, from half a block before the first to half a block behind the last.
void shade_modes(const ForceAlongSlope& data, std::pair<double, double> height, Figure& figure) {
    const std::size_t count = std::min(data.block.size(), data.modes.size());
    for (const DrawnMode mode : drawn_modes) {
        std::string legend(word_of(mode));
        for (std::size_t first = 0; first < count; ++first) {
            if (data.modes[first] != mode || mode == DrawnMode::plain) {
                continue;
            }
            std::size_t last = first;
            while (last + 1 < count && data.modes[last + 1] == mode) {
                ++last;
            }
            const double left = data.block[first] - 0.5;
            const double right = data.block[last] + 0.5;
            figure.series.emplace_back(Region{
                .outline = {{left, height.first}, {right, height.first}, {right, height.second}, {left, height.second}},
                .legend = std::exchange(legend, ""),
                .colour = style_of(mode).colour,
                .opacity = 0.6 * style_of(mode).opacity});
            first = last;
        }
    }
}

// The place in a region with the most room for a text of this size (in the units of the axes), away from the marks;
// nothing if the text does not fit.
std::optional<Point> widest_place(const Polyline& outline, const Polyline& marks, const Point& text) {
    constexpr int steps = 40;
    // Lengths are divided by the size of the text, which thereby becomes a square of side 1.
    Polyline edge;
    for (const Point& corner : outline) {
        if (corner.allFinite()) {
            edge.emplace_back(corner.cwiseQuotient(text));
        }
    }
    Frame frame;
    frame.include(edge);
    if (edge.size() < 3 || !(frame.size().minCoeff() > 0)) {
        return std::nullopt;
    }
    edge.push_back(edge.front());
    double most = 0.6;  // half a side with a margin
    const Polyline corners{{-most, -most}, {most, -most}, {most, most}, {-most, most}};
    std::optional<Point> best;
    for (int row = 1; row < steps; ++row) {
        for (int column = 1; column < steps; ++column) {
            const Point at = frame.lowest() + frame.size().cwiseProduct(Point(column, row)) / steps;
            const auto fits = [&](const Point& corner) { return inside(edge, at + corner); };
            double room = std::ranges::all_of(corners, fits) ? std::abs(signed_distance(edge, at)) : 0;
            for (const Point& mark : marks) {
                room = std::min(room, 0.7 * (mark.cwiseQuotient(text) - at).norm());
            }
            if (room > most) {
                most = room;
                best = at.cwiseProduct(text);
            }
        }
    }
    return best;
}

// Writes the names of the modes into their regions, for readers of a black and white copy.
void name_regions(const ModeChart& chart, Figure& figure) {
    constexpr double letter_width = 0.55 * 19;  // px
    constexpr double line_height = 1.2 * 19;    // px
    const double unit = display_unit(Dimension::angle).si_per_unit;
    // Axes, title and margins take about 90 px of the width and 130 px of the height.
    const Point degrees_per_px{(figure.x.range->second - figure.x.range->first) / (figure.width - 90),
                               (figure.y.range->second - figure.y.range->first) / (figure.height - 130)};
    Polyline marks;
    for (const PrintedStatement& statement : chart.printed) {
        marks.emplace_back(statement.at / unit);
    }
    for (const ModeRegion& region : chart.regions) {
        const std::string name(word_of(region.mode));
        if (name.empty()) {
            continue;
        }
        const Point text =
            degrees_per_px.cwiseProduct(Point(letter_width * static_cast<double>(letter_count(name)), line_height));
        Polyline outline = region.outline;
        for (Point& corner : outline) {
            corner /= unit;
        }
        if (const std::optional<Point> place = widest_place(outline, marks, text)) {
            figure.labels.push_back({.at = *place, .text = name, .align = Label::Align::centre, .boxed = false});
        }
    }
}

}  // namespace

Figure force_along_slope_figure(const ForceAlongSlope& data) {
    const double unit = display_unit(Dimension::force_per_length).si_per_unit;
    Figure figure{.title = data.title,
                  .x = {.title = "number of the block", .grid = false},
                  .y = axis_of("interblock_force", Dimension::force_per_length),
                  .width = 720};

    Extent blocks;
    Extent forces;
    forces.include(0);
    const auto line_of = [&](const std::vector<double>& values) {
        Polyline line;
        for (std::size_t index = 0; index < std::min(values.size(), data.block.size()); ++index) {
            line.emplace_back(data.block[index], values[index] / unit);
            forces.include(line.back().y());
        }
        return line;
    };
    for (const double number : data.block) {
        blocks.include(number);
    }
    const Polyline toppling = line_of(data.toppling);
    const Polyline sliding = line_of(data.sliding);
    const Polyline acting = line_of(data.acting);
    Polyline printed;
    for (const Point& point : data.printed) {
        if (point.allFinite()) {
            printed.emplace_back(point.x(), point.y() / unit);
            blocks.include(point.x());
            forces.include(printed.back().y());
        }
    }
    if (blocks.empty()) {
        return figure;
    }
    const double margin = forces.size() > 0 ? 0.07 * forces.size() : 1;
    const std::pair height{forces.lowest - margin, forces.highest + margin};
    figure.x.range = std::pair{blocks.lowest - 0.5, blocks.highest + 0.5};
    figure.x.ticks = block_ticks(blocks);
    figure.y.range = height;

    shade_modes(data, height, figure);
    figure.series.emplace_back(
        Line{.points = {{blocks.lowest - 0.5, 0}, {blocks.highest + 0.5, 0}}, .colour = Colour::grey, .width = 1.2});
    const auto mark = [&](const Polyline& points, std::string legend, Colour colour, Marker marker, double size) {
        if (!points.empty()) {
            figure.series.emplace_back(Points{
                .points = points, .legend = std::move(legend), .colour = colour, .marker = marker, .size = size});
        }
    };
    add_line(figure, {acting, "acting force", Colour::black, Dash::solid, 4});
    add_line(figure, {toppling, "needed against toppling", Colour::vermilion, Dash::dashed, 2.5});
    add_line(figure, {sliding, "needed against sliding", Colour::blue, Dash::dotted, 3});
    mark(toppling, "", Colour::vermilion, Marker::filled_triangle, 1.2);
    mark(sliding, "", Colour::blue, Marker::filled_square, 1);
    mark(printed, data.printed_legend, Colour::black, Marker::circle, 2.2);
    return figure;
}

Figure mode_chart_figure(const ModeChart& chart) {
    const double unit = display_unit(Dimension::angle).si_per_unit;
    Figure figure{.title = chart.title,
                  .x = axis_of(chart.x, Dimension::angle),
                  .y = axis_of(chart.y, Dimension::angle),
                  .height = 560};
    Frame frame;
    const auto in_degrees = [&](Polyline line) {
        for (Point& point : line) {
            point /= unit;
        }
        frame.include(line);
        return line;
    };

    for (const DrawnMode mode : drawn_modes) {
        std::string legend(word_of(mode));
        for (const ModeRegion& region : chart.regions) {
            if (region.mode == mode) {
                figure.series.emplace_back(Region{.outline = in_degrees(region.outline),
                                                  .legend = std::exchange(legend, ""),
                                                  .colour = style_of(mode).colour,
                                                  .opacity = style_of(mode).opacity});
            }
        }
    }
    constexpr std::array dashes{Dash::solid, Dash::dashed, Dash::dotted};
    constexpr std::array colours{Colour::black, Colour::vermilion, Colour::green};
    for (std::size_t index = 0; index < chart.boundaries.size(); ++index) {
        figure.series.emplace_back(Line{.points = in_degrees(chart.boundaries[index].points),
                                        .legend = chart.boundaries[index].legend,
                                        .colour = colours[index / dashes.size() % colours.size()],
                                        .dash = dashes[index % dashes.size()],
                                        .width = 3.5});
    }
    for (const PrintedStatement& statement : chart.printed) {
        in_degrees({statement.at});
    }
    if (!frame.empty() && frame.size().minCoeff() > 0) {
        figure.x.range = std::pair{frame.x.lowest, frame.x.highest};
        figure.y.range = std::pair{frame.y.lowest, frame.y.highest};
        mark_statements(chart.printed, unit, unit, figure);
        name_regions(chart, figure);
    }
    // Its name inside a region is not said again below.
    for (Series& series : figure.series) {
        auto* region = std::get_if<Region>(&series);
        if (region != nullptr && std::ranges::count(figure.labels, region->legend, &Label::text) > 0) {
            region->legend.clear();
        }
    }
    return figure;
}

}  // namespace delabole
