#include "plots/drawing/free_place.hpp"

#include "plots/drawing/polygon.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <limits>
#include <variant>

namespace delabole {

namespace {

Rectangle place_of(const Label& label, const Point& px_per_unit) {
    constexpr double mean_letter = 0.64 * text_height;  // width of a digit, px; letters are narrower on the average
    const double width = label.size * mean_letter * static_cast<double>(letter_count(label.text)) / px_per_unit.x();
    constexpr double of_the_box = 1.3;  // in which browsers put the text; of the height of the text
    const double height = label.size * of_the_box * text_height / px_per_unit.y();
    const double share = label.align == Label::Align::left ? 0 : label.align == Label::Align::centre ? 0.5 : 1;
    const Point lowest = label.at + Point(-share * width, label.raise * text_height / px_per_unit.y() - 0.5 * height);
    return {lowest, lowest + Point(width, height)};
}

bool overlap(const Rectangle& one, const Rectangle& other) {
    return (one.lowest.array() < other.highest.array()).all() && (other.lowest.array() < one.highest.array()).all();
}

bool within(const Rectangle& text, const Figure& figure) {
    return text.lowest.x() >= figure.x.range->first && text.highest.x() <= figure.x.range->second &&
           text.lowest.y() >= figure.y.range->first && text.highest.y() <= figure.y.range->second;
}

double hidden(const Rectangle& text, const Series& series) {
    if (const auto* line = std::get_if<Line>(&series)) {
        return crosses(text, line->points) ? 1 : 0;
    }
    if (const auto* points = std::get_if<Points>(&series)) {
        return static_cast<double>(
            std::ranges::count_if(points->points, [&](const Point& at) { return crosses(text, at, at); }));
    }
    if (const auto* arrows = std::get_if<Arrows>(&series)) {
        return 3.0 * static_cast<double>(std::ranges::count_if(
                         arrows->shafts, [&](const auto& shaft) { return crosses(text, shaft.from, shaft.to); }));
    }
    return 0;
}

double disturbance(const Label& label, const Point& px_per_unit, const Figure& figure) {
    constexpr double never = 1000;  // greater than the sum of all items that a text can hide
    const Rectangle text = place_of(label, px_per_unit);
    double sum = within(text, figure) ? 0 : never;
    for (const Label& other : figure.labels) {
        sum += overlap(text, place_of(other, px_per_unit)) ? never : 0;
    }
    for (const Series& series : figure.series) {
        sum += hidden(text, series);
    }
    for (const Arrow& arrow : figure.arrows) {
        sum += crosses(text, arrow.from, arrow.to) ? 3 : 0;
    }
    return sum;
}

}  // namespace

void add_where_free(const std::vector<LabelPlace>& places, const std::string& text, const Point& px_per_unit,
                    Figure& figure, Colour colour) {
    double least = std::numeric_limits<double>::infinity();
    Label best;
    for (const LabelPlace& place : places) {
        const Label label{.at = place.at, .text = text, .align = place.align, .colour = colour, .raise = place.raise};
        const double sum = disturbance(label, px_per_unit, figure);
        if (sum < least) {
            least = sum;
            best = label;
        }
    }
    figure.labels.push_back(best);
}

}  // namespace delabole
