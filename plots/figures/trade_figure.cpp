#include "plots/figures/study_figures.hpp"

#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace delabole {

namespace {

struct Style {
    Colour colour;
    Marker marker;
};

constexpr std::array<Style, 12> styles{{{Colour::blue, Marker::filled_circle},
                                        {Colour::vermilion, Marker::filled_square},
                                        {Colour::green, Marker::filled_triangle},
                                        {Colour::orange, Marker::filled_diamond},
                                        {Colour::purple, Marker::filled_circle},
                                        {Colour::sky, Marker::filled_square},
                                        {Colour::vermilion, Marker::filled_triangle},
                                        {Colour::blue, Marker::filled_diamond},
                                        {Colour::grey, Marker::circle},
                                        {Colour::black, Marker::circle},
                                        {Colour::black, Marker::filled_diamond},
                                        {Colour::black, Marker::filled_square}}};

Point in_decades(const Point& point) {
    return {std::log10(point.x()), std::log10(point.y())};
}

Polyline in_decades(const Polyline& points) {
    Polyline result;
    for (const Point& point : points) {
        result.push_back(in_decades(point));
    }
    return result;
}

// Numbers from 0.001 to below 10 000 in digits, others as a power of ten.
std::string tick_text(int mantissa, int decade) {
    const double value = mantissa * std::pow(10.0, decade);
    if (decade >= -3 && decade <= 3) {
        return human_number(value, 1);
    }
    return std::to_string(mantissa) + "e" + std::to_string(decade);
}

// Labels whole decades, or 1, 2 and 5 of each if there are few of them.
void set_ticks(Axis& axis, double least, double greatest) {
    constexpr double room = 0.08;
    axis.range = {least - room, greatest + room};
    const bool few = greatest - least < 2.5;
    for (int decade = static_cast<int>(std::floor(least)) - 1; decade <= std::ceil(greatest); ++decade) {
        for (const int mantissa : {1, 2, 5}) {
            const double at = decade + std::log10(mantissa);
            if ((mantissa == 1 || few) && at >= least - room && at <= greatest + room) {
                axis.ticks.emplace_back(at, tick_text(mantissa, decade));
            }
        }
    }
}

// The least error at each cost: that of the best setting that is no more expensive.
Polyline staircase(const Polyline& front, double last_cost) {
    Polyline line;
    for (std::size_t index = 0; index < front.size(); ++index) {
        line.push_back(front[index]);
        line.emplace_back(index + 1 < front.size() ? front[index + 1].x() : last_cost, front[index].y());
    }
    return line;
}

}  // namespace

Figure trade_figure(const TradeDrawing& drawing) {
    Figure figure;
    figure.title = drawing.title;
    figure.x = {.title = drawing.cost};
    figure.y = {.title = drawing.error, .unit = drawing.error_unit};
    figure.width = 760;
    figure.height = 520;

    constexpr double infinity = std::numeric_limits<double>::infinity();
    Point least(infinity, infinity);
    Point greatest = -least;
    for (const TradeCloud& cloud : drawing.clouds) {
        for (const Point& point : in_decades(cloud.points)) {
            least = least.cwiseMin(point);
            greatest = greatest.cwiseMax(point);
        }
    }
    if (!(least.x() <= greatest.x())) {
        return figure;
    }
    if (drawing.resolution > 0) {
        least.y() = std::min(least.y(), std::log10(drawing.resolution));
    }
    set_ticks(figure.x, least.x(), greatest.x());
    set_ticks(figure.y, least.y(), greatest.y());

    if (drawing.resolution > 0) {
        const double height = std::log10(drawing.resolution);
        figure.series.emplace_back(Line{.points = {{least.x(), height}, {greatest.x(), height}},
                                        .legend = "half the final bracket",
                                        .colour = Colour::grey,
                                        .dash = Dash::dotted});
    }
    if (!drawing.front.empty()) {
        figure.series.emplace_back(Line{.points = staircase(in_decades(drawing.front), greatest.x()),
                                        .legend = "front: nothing cheaper is as accurate",
                                        .colour = Colour::black});
    }
    for (std::size_t index = 0; index < drawing.clouds.size(); ++index) {
        const Style& style = styles[index % styles.size()];
        figure.series.emplace_back(Points{.points = in_decades(drawing.clouds[index].points),
                                          .legend = drawing.clouds[index].legend,
                                          .colour = style.colour,
                                          .marker = style.marker,
                                          .size = 1.4});
    }
    for (Label label : drawing.labels) {
        label.at = in_decades(label.at);
        figure.labels.push_back(std::move(label));
    }
    return figure;
}

}  // namespace delabole
