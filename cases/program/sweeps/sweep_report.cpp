#include "cases/program/sweeps/sweep_report.hpp"

#include "plots/drawing/contour.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace delabole {

namespace {

constexpr std::array sweep_colours{Colour::blue,   Colour::vermilion, Colour::green, Colour::purple,
                                   Colour::orange, Colour::sky,       Colour::black};
constexpr std::size_t most_rows = 20;   // of a table in the report
constexpr std::size_t most_curves = 8;  // for a second input with more values, a map is drawn
constexpr int digits_of_table = 5;

Axis axis_of(const SweptInput& input) {
    if (!input.axis.empty()) {
        return {.title = input.axis};
    }
    Axis axis = axis_of(input.input, input.dimension);
    axis.unit = input.unit.empty() ? axis.unit : human_unit(input.unit);
    return axis;
}

using Places = std::vector<std::size_t>;  // indices of curves in their sweep

// The vertical axis for curves of one dimension.
Axis axis_of_outputs(const SweepRun& run, const SweptFigure& data, const Places& curves) {
    const std::string& first = run.sweep.curves[curves.front()].output;
    Axis axis = axis_of(first, data.curves[curves.front()].dimension);
    if (!run.sweep.output_axis.empty()) {
        axis.title = run.sweep.output_axis;
    } else if (std::ranges::any_of(curves,
                                   [&](std::size_t curve) { return run.sweep.curves[curve].output != first; })) {
        axis.title = "value";
    }
    return axis;
}

// Groups of curves of equal dimension, each drawn in one figure. Curves without any number appear only in the tables.
std::vector<Places> curves_by_dimension(const SweptFigure& data) {
    std::vector<Places> groups;
    for (std::size_t curve = 0; curve < data.curves.size(); ++curve) {
        const SweptCurve& one = data.curves[curve];
        if (std::ranges::none_of(one.values, [](double value) { return std::isfinite(value); })) {
            continue;
        }
        const auto group = std::ranges::find_if(
            groups, [&](const Places& places) { return data.curves[places.front()].dimension == one.dimension; });
        if (group == groups.end()) {
            groups.push_back({curve});
        } else {
            group->push_back(curve);
        }
    }
    return groups;
}

Dash dash_of(CurveDash dash) {
    return dash == CurveDash::solid ? Dash::solid : dash == CurveDash::dashed ? Dash::dashed : Dash::dotted;
}

// Assigns the colours in order, a new one to each solid curve; dotted curves are references, in grey.
class CurveColours {
  public:
    Colour of(CurveDash dash) {
        if (dash == CurveDash::dotted) {
            return Colour::grey;
        }
        if (dash == CurveDash::solid && used_) {
            ++next_;
        }
        used_ = true;
        return sweep_colours[next_ % sweep_colours.size()];
    }

  private:
    std::size_t next_ = 0;
    bool used_ = false;
};

Line line_of(const SweptInput& input, const SweptCurve& curve, std::size_t from, const std::string& legend,
             Colour colour, CurveDash dash) {
    Line line{.legend = legend, .colour = colour, .dash = dash_of(dash), .width = 3};
    for (std::size_t place = 0; place < input.values.size(); ++place) {
        line.points.emplace_back(input.shown(input.values[place]),
                                 in_display_unit(curve.values[from + place], curve.dimension));
    }
    return line;
}

void add_printed_points(const CaseSweep& sweep, Figure& figure) {
    constexpr std::array markers{Marker::filled_diamond, Marker::filled_circle, Marker::filled_square, Marker::circle};
    constexpr std::array colours{Colour::black, Colour::vermilion, Colour::purple, Colour::grey};
    for (std::size_t index = 0; index < sweep.printed.size(); ++index) {
        const PrintedPoints& printed = sweep.printed[index];
        const Colour colour = colours[index % colours.size()];
        if (printed.line) {
            figure.series.emplace_back(
                Line{.points = printed.points, .legend = printed.label, .colour = colour, .dash = Dash::dashed});
        } else {
            figure.series.emplace_back(Points{.points = printed.points,
                                              .legend = printed.label,
                                              .colour = colour,
                                              .marker = markers[index % markers.size()],
                                              .size = 1.6});
        }
    }
}

std::string title_of(const CaseSweep& sweep, const std::optional<double>& each) {
    const std::string title = sweep.title.empty() ? human_name(sweep.name) : sweep.title;
    return each ? title + ", " + each_in_words(*sweep.each, *each) : title;
}

// Curves over the first input, one for each value of the second if there is one.
Figure curves_figure(const SweepRun& run, const SweptFigure& data, const Places& curves) {
    const CaseSweep& sweep = run.sweep;
    const SweptInput& first = sweep.vary.front();
    Figure figure{.title = title_of(sweep, data.each), .x = axis_of(first), .y = axis_of_outputs(run, data, curves)};
    CurveColours colours;
    for (const std::size_t index : curves) {
        const SweptCurve& curve = data.curves[index];
        const CurveDash dash = sweep.curves[index].dash;
        // A single curve named after its output needs no label, because the axis has that name.
        const std::string label = curves.size() == 1 && curve.label == sweep.curves[index].output ? "" : curve.label;
        if (sweep.vary.size() == 1) {
            figure.series.emplace_back(line_of(first, curve, 0, label, colours.of(dash), dash));
            continue;
        }
        const SweptInput& second = sweep.vary[1];
        for (std::size_t value = 0; value < second.values.size(); ++value) {
            const std::string legend =
                label + (label.empty() ? "" : ", ") + each_in_words(second, second.values[value]);
            figure.series.emplace_back(
                line_of(first, curve, value * first.values.size(), legend, colours.of(dash), dash));
        }
    }
    add_printed_points(sweep, figure);
    return figure;
}

Figure map_figure(const SweepRun& run, const SweptFigure& data, std::size_t index) {
    const SweptCurve& curve = data.curves[index];
    const SweptInput& first = run.sweep.vary[0];
    const SweptInput& second = run.sweep.vary[1];
    HeatMap map;
    for (const double value : first.values) {
        map.x_values.push_back(first.shown(value));
    }
    for (const double value : second.values) {
        map.y_values.push_back(second.shown(value));
    }
    map.values.resize(static_cast<Eigen::Index>(second.values.size()), static_cast<Eigen::Index>(first.values.size()));
    map.ceiling = 0;
    for (std::size_t place = 0; place < curve.values.size(); ++place) {
        const double shown = in_display_unit(curve.values[place], curve.dimension);
        map.values(static_cast<Eigen::Index>(place / first.values.size()),
                   static_cast<Eigen::Index>(place % first.values.size())) = shown;
        map.ceiling = std::isfinite(shown) ? std::max(map.ceiling, shown) : map.ceiling;
    }
    map.ceiling = map.ceiling > 0 ? map.ceiling : 1;
    const Axis output = axis_of_outputs(run, data, {index});
    map.scale_title = output.title + (output.unit.empty() ? "" : " (" + output.unit + ")");
    map.no_answer_legend = "no answer";
    Figure figure{.title = title_of(run.sweep, data.each), .x = axis_of(first), .y = axis_of(second)};
    Line balance{.legend = "factor of safety 1", .colour = Colour::vermilion, .width = 3.5};
    if (run.sweep.curves[index].output == "factor_of_safety") {
        balance.points = broken_line(contour_lines(map.x_values, map.y_values, map.values, 1));
    }
    figure.series.emplace_back(std::move(map));
    add_line(figure, std::move(balance));
    add_printed_points(run.sweep, figure);
    return figure;
}

std::string header_of(const Axis& axis) {
    return axis.unit.empty() ? axis.title : axis.title + ", " + axis.unit;
}

std::string cell_of(const SweptCurve& curve, std::size_t place) {
    return curve.words[place].empty()
               ? human_number(in_display_unit(curve.values[place], curve.dimension), digits_of_table)
               : human_name(curve.words[place]);
}

Table curves_table(const std::string& caption, const SweptInput& input, const std::vector<SweptCurve>& curves) {
    Table table{caption, {{header_of(axis_of(input)), true}}};
    for (const SweptCurve& curve : curves) {
        const std::string_view unit = display_unit(curve.dimension).symbol;
        table.columns.emplace_back(curve.label + (unit.empty() ? "" : ", " + human_unit(unit)), true);
    }
    for (std::size_t place = 0; place < input.values.size(); ++place) {
        std::vector<std::string>& row = table.rows.emplace_back();
        row.push_back(human_number(input.shown(input.values[place]), digits_of_table));
        for (const SweptCurve& curve : curves) {
            row.push_back(cell_of(curve, place));
        }
    }
    return table;
}

// A header and rows, for CSV, JSON and the terminal.
struct SweepRows {
    std::vector<std::string> columns;
    std::vector<std::vector<Cell>> rows;
};

SweepRows rows_of(const SweepRun& run) {
    const CaseSweep& sweep = run.sweep;
    SweepRows made;
    if (sweep.each) {
        made.columns.push_back(column_name(sweep.each->input, sweep.each->dimension));
    }
    for (const SweptInput& swept : sweep.vary) {
        made.columns.push_back(column_name(swept.input, swept.dimension));
    }
    for (const SweptCurve& curve : run.figures.front().curves) {
        made.columns.push_back(column_name(curve.label, curve.dimension));
    }
    const std::size_t first = sweep.vary.front().values.size();
    for (const SweptFigure& figure : run.figures) {
        for (std::size_t place = 0; place < figure.curves.front().values.size(); ++place) {
            std::vector<Cell>& row = made.rows.emplace_back();
            if (sweep.each) {
                row.emplace_back(in_display_unit(*figure.each, sweep.each->dimension));
            }
            row.emplace_back(in_display_unit(sweep.vary[0].values[place % first], sweep.vary[0].dimension));
            if (sweep.vary.size() > 1) {
                row.emplace_back(in_display_unit(sweep.vary[1].values[place / first], sweep.vary[1].dimension));
            }
            for (const SweptCurve& curve : figure.curves) {
                row.push_back(curve.words[place].empty() ? Cell(in_display_unit(curve.values[place], curve.dimension))
                                                         : Cell(curve.words[place]));
            }
        }
    }
    return made;
}

std::string sweep_csv(const SweepRun& run) {
    const SweepRows rows = rows_of(run);
    CsvTable csv(rows.columns);
    for (const std::vector<Cell>& row : rows.rows) {
        csv.add_row(row);
    }
    return csv.text();
}

std::string name_of_figure(const SweepRun& run, const SweptFigure& data) {
    if (!data.each) {
        return run.sweep.name;
    }
    std::string number = human_number(run.sweep.each->shown(*data.each), 6);
    std::ranges::replace(number, '.', '_');
    return run.sweep.name + "_" + number;
}

void document_figure(const SweepRun& run, const SweptFigure& data, const Sheet& sheet) {
    const CaseSweep& sweep = run.sweep;
    const bool is_map = sweep.vary.size() > 1 && sweep.vary[1].values.size() > most_curves &&
                        sweep.vary[0].equally_spaced() && sweep.vary[1].equally_spaced();
    if (sweep.vary.size() == 1 && sweep.vary.front().values.size() <= most_rows) {
        sheet.add(curves_table(title_of(sweep, data.each), sweep.vary.front(), data.curves));
    }
    int number = 0;
    const auto draw = [&](const Figure& figure) {
        const std::string part = ++number > 1 ? "_" + std::to_string(number) : "";
        sheet.draw(figure, name_of_figure(run, data) + part, sweep.caption);
    };
    for (const Places& group : curves_by_dimension(data)) {
        if (!is_map) {
            draw(curves_figure(run, data, group));
            continue;
        }
        for (const std::size_t curve : group) {
            draw(map_figure(run, data, curve));
        }
    }
}

void document_crossings(const SweepRun& run, const Sheet& sheet) {
    const CaseSweep& sweep = run.sweep;
    const std::vector<SweptCurve> curves = crossing_curves(run);
    SweepRun crossings;
    crossings.sweep.vary = {*sweep.each};
    crossings.figures.push_back({std::nullopt, curves, {}});
    sheet.write(sweep.name + "_crossings.csv", sweep_csv(crossings));
    const std::string title = "Where curves cross: " + human_name(sweep.vary.front().input);
    if (sweep.each->values.size() <= most_rows) {
        sheet.add(curves_table(title, *sweep.each, curves));
    }
    if (sweep.draw == SweepDrawing::crossings || sweep.each->values.size() > 2) {
        Figure figure{.title = sweep.draw == SweepDrawing::crossings ? sweep.title : title,
                      .x = axis_of(*sweep.each),
                      .y = axis_of(sweep.vary.front())};
        CurveColours colours;
        for (const SweptCurve& curve : curves) {
            figure.series.emplace_back(
                line_of(*sweep.each, curve, 0, curve.label, colours.of(CurveDash::solid), CurveDash::solid));
        }
        if (sweep.draw == SweepDrawing::crossings) {
            add_printed_points(sweep, figure);
        }
        sheet.draw(figure, sweep.draw == SweepDrawing::crossings ? sweep.name : sweep.name + "_crossings",
                   sweep.caption);
    }
}

}  // namespace

void document_sweep(const SweepRun& run, const Sheet& sheet) {
    sheet.write(run.sweep.name + ".csv", sweep_csv(run));
    if (run.sweep.draw != SweepDrawing::crossings) {
        for (const SweptFigure& figure : run.figures) {
            document_figure(run, figure, sheet);
        }
    }
    if (run.sweep.each && !run.sweep.crossings.empty()) {
        document_crossings(run, sheet);
    }
}

std::vector<Comparison> document_sweeps(const CaseFile& file, const SweepWork& work, const Sheet& sheet) {
    std::vector<Comparison> rows;
    for (std::size_t index = 0; index < file.sweeps.size(); ++index) {
        SweepWork one = work;
        if (work.progress) {
            one.progress = [&, index](double share) {
                work.progress((static_cast<double>(index) + share) / static_cast<double>(file.sweeps.size()));
            };
        }
        const SweepRun run = run_sweep(file, file.sweeps[index], one);
        document_sweep(run, sheet);
        std::ranges::move(compare_sweep(run), std::back_inserter(rows));
    }
    return rows;
}

Json json_of(const SweepRun& run) {
    const SweepRows rows = rows_of(run);
    Json json = Json::array();
    for (const std::vector<Cell>& row : rows.rows) {
        Json& point = json.emplace_back();
        for (std::size_t column = 0; column < row.size(); ++column) {
            std::visit([&](const auto& cell) { point[rows.columns[column]] = cell; }, row[column]);
        }
    }
    return json;
}

std::string screen_of(const SweepRun& run) {
    const SweepRows rows = rows_of(run);
    if (rows.rows.size() > most_rows) {
        return {};
    }
    std::vector<std::vector<std::string>> screen = {rows.columns};
    for (const std::vector<Cell>& row : rows.rows) {
        std::vector<std::string>& line = screen.emplace_back();
        for (const Cell& cell : row) {
            const auto* number = std::get_if<double>(&cell);
            line.push_back(number == nullptr ? std::get<std::string>(cell)
                                             : human_number(*number, digits_of_table + 1));
        }
    }
    return text_table(screen);
}

Table comparison_table(const std::vector<Comparison>& comparisons) {
    Table table{"Printed and computed",
                {"quantity", "printed"_number, "computed"_number, "difference"_number, "verdict", "source"}};
    for (const Comparison& row : comparisons) {
        table.rows.push_back(
            {row.what, row.expected, row.computed, row.difference, std::string(word_of(row.verdict)), row.source});
    }
    return table;
}

Json json_of(const std::vector<Comparison>& comparisons) {
    Json json = Json::array();
    for (const Comparison& row : comparisons) {
        json.push_back({{"what", row.what},
                        {"printed", row.expected},
                        {"computed", row.computed},
                        {"difference", row.difference},
                        {"verdict", std::string(word_of(row.verdict))}});
    }
    return json;
}

}  // namespace delabole
