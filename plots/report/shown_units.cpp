#include "plots/report/shown_units.hpp"

#include "fitting/work/bare_number.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <optional>
#include <string_view>

namespace delabole {

namespace {

struct Conversion {
    double factor;  // shown unit per metric unit
    std::string unit;
};

constexpr Dimension last_dimension = Dimension::angular_speed;

// Returns nothing if the unit is not converted.
std::optional<Conversion> conversion_of(std::string_view unit) {
    for (int index = 0; index <= static_cast<int>(last_dimension); ++index) {
        const auto dimension = static_cast<Dimension>(index);
        const DisplayUnit metric = display_unit(dimension);
        const DisplayUnit shown = shown_unit(dimension);
        if (!metric.symbol.empty() && (unit == metric.symbol || unit == human_unit(metric.symbol)) &&
            metric.symbol != shown.symbol) {
            return Conversion{metric.si_per_unit / shown.si_per_unit, human_unit(shown.symbol)};
        }
    }
    return std::nullopt;
}

// Scales the points of a figure by the factors of its axes.
struct Scaling {
    double x = 1;
    double y = 1;

    void apply(Point& point) const { point = {x * point.x(), y * point.y()}; }
    void apply(Polyline& line) const {
        for (Point& point : line) {
            apply(point);
        }
    }
    void operator()(Line& line) const { apply(line.points); }
    void operator()(Points& points) const { apply(points.points); }
    void operator()(Region& region) const { apply(region.outline); }
    void operator()(Boxes& boxes) const {
        for (Boxes::Box& box : boxes.boxes) {
            apply(box.lower_left);
            apply(box.upper_right);
        }
    }
    void operator()(Arrows& arrows) const {
        for (Arrows::Shaft& shaft : arrows.shafts) {
            apply(shaft.from);
            apply(shaft.to);
        }
    }
    void operator()(HeatMap& map) const {
        for (double& value : map.x_values) {
            value *= x;
        }
        for (double& value : map.y_values) {
            value *= y;
        }
        // "factor (kN/m)"
        const std::size_t bracket = map.scale_title.rfind(" (");
        if (bracket == std::string::npos || !map.scale_title.ends_with(')')) {
            return;
        }
        const std::string unit = map.scale_title.substr(bracket + 2, map.scale_title.size() - bracket - 3);
        if (const std::optional<Conversion> conversion = conversion_of(unit)) {
            map.values *= conversion->factor;
            map.ceiling *= conversion->factor;
            map.scale_title = map.scale_title.substr(0, bracket) + " (" + conversion->unit + ")";
        }
    }
};

double convert(Axis& axis) {
    const std::optional<Conversion> conversion = conversion_of(axis.unit);
    if (!conversion) {
        return 1;
    }
    axis.unit = conversion->unit;
    if (axis.range) {
        axis.range = std::pair{conversion->factor * axis.range->first, conversion->factor * axis.range->second};
    }
    // Ticks given explicitly are labelled with numbers of the metric unit; gnuplot's own ticks are round numbers.
    axis.ticks.clear();
    return conversion->factor;
}

// Converts a cell that holds a number alone; words and ranges stay.
void convert(std::string& cell, double factor) {
    if (const auto value = bare_number(cell)) {
        constexpr int digits = 5;
        cell = human_number(factor * *value, digits);
    }
}

// Converts a column whose title ends with a unit, such as "weight, kN/m".
void convert(Table& table) {
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        std::string& title = table.columns[column].title;
        const std::size_t comma = title.rfind(", ");
        const auto conversion =
            comma == std::string::npos ? std::nullopt : conversion_of(std::string_view(title).substr(comma + 2));
        if (!conversion) {
            continue;
        }
        title = title.substr(0, comma + 2) + conversion->unit;
        for (std::vector<std::string>& row : table.rows) {
            if (column < row.size()) {
                convert(row[column], conversion->factor);
            }
        }
    }
}

void convert(std::vector<ReportBlock>& blocks) {
    for (ReportBlock& block : blocks) {
        if (auto* table = std::get_if<Table>(&block)) {
            convert(*table);
        } else if (auto* folded = std::get_if<Folded>(&block)) {
            convert(folded->blocks);
        }
    }
}

}  // namespace

Figure in_shown_units(Figure figure) {
    const Scaling scaling{convert(figure.x), convert(figure.y)};
    for (Series& series : figure.series) {
        std::visit(scaling, series);
    }
    for (Label& label : figure.labels) {
        scaling.apply(label.at);
    }
    for (Arrow& arrow : figure.arrows) {
        scaling.apply(arrow.from);
        scaling.apply(arrow.to);
    }
    return figure;
}

Report in_shown_units(Report report) {
    convert(report.blocks);
    return report;
}

}  // namespace delabole
