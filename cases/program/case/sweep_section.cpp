// [[sweep]]: which inputs vary, which outputs are drawn, what is printed of them.
#include "cases/program/case/sweep.hpp"

#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/described_reader.hpp"
#include "cases/program/reader/described_writer.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reader/spelling.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <utility>

namespace delabole {
namespace {

constexpr double most_points = 10001;
constexpr std::size_t most_analyses = 1'000'000;  // of a sweep
constexpr std::size_t most_of_a_kind = 100;       // sweeps of a case, curves of a sweep and so on

std::optional<double> read_position(Section& section, const Node& node, std::string_view key, const Quantity& input) {
    return read_number(section.reading(), node, section.path_of(key), input.dimension, input.range);
}

void read_listed_values(Section& section, const Node& list, const Quantity& input, SweptInput& swept) {
    if (list.kind != Node::Kind::array || list.elements.size() < 2) {
        section.complain("values", list, "must be a list of at least two values");
        return;
    }
    for (std::size_t index = 0; index < list.elements.size(); ++index) {
        const Node& node = list.elements[index];
        const auto value = read_position(section, node, "values[" + std::to_string(index + 1) + "]", input);
        if (value && !swept.values.empty() && !(*value > swept.values.back())) {
            section.complain("values", node, "must be more than the value before");
        }
        swept.values.push_back(value.value_or(0));
    }
}

void read_range(Section& section, const Quantity& input, SweptInput& swept) {
    const Node* from = section.require("from", "first value of the input (or values = [...])");
    const Node* to = section.require("to", "last value of the input");
    std::int64_t points = 101;
    if (const Node* node = section.take("points")) {
        points = read_whole_number(section.reading(), *node, section.path_of("points"), within(2, most_points))
                     .value_or(points);
    }
    const auto first = from == nullptr ? std::nullopt : read_position(section, *from, "from", input);
    const auto last = to == nullptr ? std::nullopt : read_position(section, *to, "to", input);
    if (!first || !last) {
        return;
    }
    if (!(*last > *first)) {
        section.complain("to", *to, "must be more than from");
        return;
    }
    swept.equally_spaced = true;
    swept.values = spaced_values(*first, *last, static_cast<int>(points));
}

// Nothing, with a complaint, where the input is not known.
std::optional<SweptInput> read_swept(Section& section) {
    for (const std::string_view key : {"also", "values", "from", "to", "points", "axis", "unit"}) {
        section.allow(key);
    }
    SweptInput swept;
    swept.input = read_name(section, "input", NameOf::input, "the input that varies, e.g. strength.friction_angle");
    const Quantity* input = section.named().value_or(nullptr);
    if (input == nullptr) {
        return std::nullopt;
    }
    swept.dimension = input->dimension;
    read_names(section, "also", NameOf::input, "further inputs that take the same value", swept.also);
    swept.axis = read_optional_text(section, "axis");
    swept.unit = read_optional_text(section, "unit");
    swept.si_per_unit = display_unit(input->dimension).si_per_unit;
    if (!swept.unit.empty()) {
        const ParsedQuantity one = parse_quantity("1 " + swept.unit, input->dimension);
        if (one.status != QuantityStatus::ok) {
            section.complain("unit", *section.peek("unit"), "is not a unit of " + swept.input + ": " + one.message);
        } else {
            swept.si_per_unit = one.value;
        }
    }
    if (const Node* list = section.peek("values")) {
        if (section.contains("from") || section.contains("to") || section.contains("points")) {
            section.complain("values", *list, "takes the place of from, to and points");
        }
        read_listed_values(section, *list, *input, swept);
    } else {
        read_range(section, *input, swept);
    }
    return swept.values.size() < 2 ? std::nullopt : std::optional(swept);
}

template <class Enum>
Enum word_or(Section& section, std::string_view key, const Node* node, Enum otherwise) {
    const auto index = node == nullptr
                           ? std::nullopt
                           : read_choice(section.reading(), *node, section.path_of(key), detail::enum_words<Enum>());
    return index ? static_cast<Enum>(*index) : otherwise;
}

SweepCurve read_curve(Section& section, const std::string& output) {
    SweepCurve curve;
    curve.label = require_text(section, "label", "the curve in words");
    curve.output = read_optional_text(section, "output");
    if (curve.output.empty()) {
        curve.output = output;
    }
    if (curve.output.empty()) {
        section.require("output", "name of an output of the model (or output of the sweep, for all curves)");
    }
    curve.dash = word_or(section, "dash", section.take("dash"), CurveDash::solid);
    curve.conditions = read_conditions(section, "with");
    return curve;
}

PrintedPoints read_printed(Section& section) {
    PrintedPoints printed;
    printed.label = require_text(section, "label", "what is printed, in words");
    printed.source = read_optional_text(section, "source");
    if (const Node* line = section.take("line")) {
        if (line->kind != Node::Kind::boolean) {
            section.complain("line", *line, "must be true or false");
        }
        printed.line = line->boolean;
    }
    const Node* points = section.require("points", "points in the units of the axes, [[x, y], ...]");
    if (points == nullptr) {
        return printed;
    }
    const auto is_number = [](const Node& node) {
        return (node.kind == Node::Kind::integer || node.kind == Node::Kind::real) && std::isfinite(node.real);
    };
    for (const Node& point : points->elements) {
        if (point.kind != Node::Kind::array || point.elements.size() != 2 ||
            !std::ranges::all_of(point.elements, is_number)) {
            section.complain("points", point, "must be two numbers, [x, y], in the units of the axes");
            return printed;
        }
        printed.points.emplace_back(point.elements[0].real, point.elements[1].real);
    }
    if (printed.points.empty()) {
        section.complain("points", *points, "must be a list of points, [[x, y], ...]");
    }
    return printed;
}

// What statements are made on: curves, or crossings over `each`.
std::vector<std::string> labels_of(const std::vector<SweepCurve>& curves) {
    std::vector<std::string> labels;
    std::ranges::transform(curves, std::back_inserter(labels), &SweepCurve::label);
    return labels;
}

std::vector<std::string> labels_of(const std::vector<CurveCrossing>& crossings) {
    std::vector<std::string> labels;
    std::ranges::transform(crossings, std::back_inserter(labels), &CurveCrossing::label);
    return labels;
}

std::string read_label(Section& section, std::string_view key, std::string_view what,
                       const std::vector<std::string>& labels) {
    std::string label = require_text(section, key, what);
    if (!label.empty() && std::ranges::find(labels, label) == labels.end()) {
        section.complain(key, *section.peek(key), "is not the label of a curve" + suggestion(label, labels));
    }
    return label;
}

template <class Printed>
void read_remarks(Section& section, Printed& printed) {
    printed.label = require_text(section, "label", "what is compared, in words");
    printed.source = read_optional_text(section, "source");
    printed.note = read_optional_text(section, "note");
    section.allow("unreachable");
    if (section.contains("unreachable")) {
        printed.unreachable = require_text(section, "unreachable", "why what is printed cannot be reached");
    }
}

CurveCrossing read_crossing(Section& section, const CaseSweep& sweep) {
    CurveCrossing crossing;
    read_remarks(section, crossing);
    const std::vector<std::string> labels = labels_of(sweep.curves);
    crossing.curve = read_label(section, "curve", "label of a curve", labels);
    crossing.other = read_label(section, "other", "label of the curve that it meets", labels);
    if (sweep.vary.empty()) {
        section.allow("printed");
        section.allow("tolerance");
        return crossing;
    }
    const auto read = [&](std::string_view key) {
        const Node* node = section.take(key);
        return node == nullptr ? std::nullopt
                               : read_number(section.reading(), *node, section.path_of(key),
                                             sweep.vary.front().dimension, any_number());
    };
    crossing.printed = read("printed");
    crossing.tolerance = read("tolerance");
    if (crossing.printed && !crossing.tolerance && !crossing.unreachable) {
        section.reading().complain(section.place(), section.path(), {}, "needs a tolerance for what is printed");
    }
    return crossing;
}

CurveStatement read_statement(Section& section, const CaseSweep& sweep) {
    CurveStatement statement;
    read_remarks(section, statement);
    std::vector<std::string> labels = labels_of(sweep.curves);
    const std::vector<std::string> crossings = labels_of(sweep.crossings);
    const Node* curve = section.peek("curve");
    if (sweep.each && curve != nullptr && std::ranges::find(crossings, curve->text) != crossings.end()) {
        labels = crossings;
    }
    statement.curve = read_label(section, "curve", "label of a curve", labels);
    statement.relation =
        word_or(section, "is", section.require("is", "falls, rises, below or above"), CurveRelation::falls);
    section.allow("other");
    if (statement.relation == CurveRelation::below || statement.relation == CurveRelation::above) {
        statement.other = read_label(section, "other", "label of the other curve", labels);
    }
    return statement;
}

// Whether there are too many of something to be read, let alone drawn.
bool too_many(Section& section, std::string_view key) {
    const Node* all = section.peek(key);
    if (all == nullptr || all->elements.size() <= most_of_a_kind) {
        return false;
    }
    section.complain(key, *all, "are more than " + std::to_string(most_of_a_kind));
    return true;
}

// Complains about inputs that vary twice, and about more work than anybody waits for.
void check_swept(Section& section, const CaseSweep& sweep) {
    std::vector<SweptInput> swept = sweep.vary;
    if (sweep.each) {
        swept.push_back(*sweep.each);
    }
    std::size_t analyses = 1;
    std::set<std::string> inputs;
    for (const SweptInput& one : swept) {
        analyses *= one.values.size();
        std::vector<std::string> names = one.also;
        names.push_back(one.input);
        for (const std::string& name : names) {
            if (!inputs.insert(name).second) {
                section.reading().complain(section.place(), section.path(), shown(name), "varies twice in the sweep");
            }
        }
    }
    if (analyses > most_analyses) {
        section.reading().complain(section.place(), section.path(), std::to_string(analyses),
                                   "points are more than " + std::to_string(most_analyses));
    }
}

void read_sweep(Section& section, std::vector<CaseSweep>& sweeps) {
    CaseSweep sweep;
    sweep.place = section.place();
    sweep.name = require_text(section, "name", "name of its files");
    check_file_name(section.reading(), section.path_of("name"), sweep.name);
    if (!sweep.name.empty() && std::ranges::find(sweeps, sweep.name, &CaseSweep::name) != sweeps.end()) {
        section.complain("name", *section.peek("name"), "names two sweeps");
    }
    sweep.title = read_optional_text(section, "title");
    sweep.caption = read_optional_text(section, "caption");
    sweep.output_axis = read_optional_text(section, "output_axis");
    const std::string output = read_optional_text(section, "output");
    bool readable = true;
    for (const std::string_view key : {"vary", "each", "draw", "curve", "printed", "crossing", "statement"}) {
        section.allow(key);
        readable = !too_many(section, key) && readable;
    }
    if (!readable) {
        return;
    }
    std::size_t varied = 0;
    for_each_table(section, "vary", [&](Section& element) {
        const auto swept = read_swept(element);
        if (swept && ++varied <= 2) {
            sweep.vary.push_back(*swept);
        }
    });
    if (const Node* vary = section.peek("vary"); vary == nullptr || vary->elements.empty() || varied > 2) {
        section.reading().complain(section.place(), section.path(), {},
                                   "needs one or two [[sweep.vary]], the inputs that vary");
    }
    if (const Node* each = section.take("each")) {
        if (const Node* table = as_table(section.reading(), *each, section.path_of("each"))) {
            Section inner(section, *table, section.path_of("each"));
            sweep.each = read_swept(inner);
            inner.finish();
        }
    }
    sweep.draw = word_or(section, "draw", section.take("draw"), SweepDrawing::all);
    for_each_table(section, "curve", [&](Section& element) { sweep.curves.push_back(read_curve(element, output)); });
    if (sweep.curves.empty()) {
        if (output.empty()) {
            section.require("output", "name of an output of the model, or [[sweep.curve]] with an output each");
        }
        sweep.curves.push_back({.label = output, .output = output, .conditions = {}});
    }
    std::set<std::string> labels;
    for (const SweepCurve& curve : sweep.curves) {
        if (!labels.insert(curve.label).second) {
            section.reading().complain(section.place(), section.path(), shown(curve.label),
                                       "names two curves of the sweep");
        }
    }
    for_each_table(section, "printed", [&](Section& element) { sweep.printed.push_back(read_printed(element)); });
    for_each_table(section, "crossing",
                   [&](Section& element) { sweep.crossings.push_back(read_crossing(element, sweep)); });
    for_each_table(section, "statement",
                   [&](Section& element) { sweep.statements.push_back(read_statement(element, sweep)); });
    const auto is_printed = [](const CurveCrossing& crossing) { return crossing.printed.has_value(); };
    if (sweep.each && std::ranges::any_of(sweep.crossings, is_printed)) {
        section.reading().complain(section.place(), section.path(), {},
                                   "has a printed crossing, which one value of each cannot be told from another");
    }
    if (sweep.vary.size() > 1 && !(sweep.crossings.empty() && sweep.statements.empty())) {
        section.reading().complain(section.place(), section.path(), {},
                                   "has crossings or statements, which go with one [[sweep.vary]] alone");
    }
    if (sweep.draw == SweepDrawing::crossings && (!sweep.each || sweep.crossings.empty())) {
        section.complain("draw", *section.peek("draw"), "needs [sweep.each] and [[sweep.crossing]]");
    }
    check_swept(section, sweep);
    sweeps.push_back(std::move(sweep));
}

void write_swept(std::string& text, const SweptInput& swept) {
    write_line(text, "input", in_quotes(swept.input));
    if (!swept.also.empty()) {
        write_line(text, "also", list_in_quotes(swept.also));
    }
    if (swept.equally_spaced) {
        write_line(text, "from", written_quantity(swept.values.front(), swept.dimension));
        write_line(text, "to", written_quantity(swept.values.back(), swept.dimension));
        write_line(text, "points", std::to_string(swept.values.size()));
    } else {
        std::string list;
        for (const double value : swept.values) {
            list += (list.empty() ? "" : ", ") + written_quantity(value, swept.dimension);
        }
        write_line(text, "values", "[" + list + "]");
    }
    write_text(text, "axis", swept.axis);
    write_text(text, "unit", swept.unit);
}

template <class Printed>
void write_remarks(std::string& text, const Printed& printed) {
    write_line(text, "label", in_quotes(printed.label));
    write_line(text, "curve", in_quotes(printed.curve));
    write_text(text, "other", printed.other);
    write_text(text, "source", printed.source);
    write_text(text, "note", printed.note);
    if (printed.unreachable) {
        write_line(text, "unreachable", in_quotes(*printed.unreachable));
    }
}

void write_printed(std::string& text, const PrintedPoints& printed) {
    text += "\n[[sweep.printed]]\n";
    write_line(text, "label", in_quotes(printed.label));
    write_text(text, "source", printed.source);
    if (printed.line) {
        write_line(text, "line", "true");
    }
    std::string points;
    for (const Point& point : printed.points) {
        points += (points.empty() ? "[" : ", [") + written_quantity(point.x(), Dimension::ratio) + ", " +
                  written_quantity(point.y(), Dimension::ratio) + "]";
    }
    write_line(text, "points", "[" + points + "]");
}

}  // namespace

std::vector<double> spaced_values(double from, double to, int points) {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(points));
    for (int index = 0; index < points; ++index) {
        // The last one as it was given.
        values.push_back(index + 1 == points ? to : from + (to - from) * index / (points - 1));
    }
    return values;
}

std::vector<CaseSweep> read_sweeps(Section& root, const ModelNames& names) {
    std::vector<CaseSweep> sweeps;
    if (too_many(root, "sweep")) {
        root.allow("sweep");
        return sweeps;
    }
    for_each_table(root, "sweep", [&](Section& section) {
        section.refer_to({std::span(&names, 1), "an output of the model"});
        read_sweep(section, sweeps);
    });
    return sweeps;
}

void write_sweep(std::string& text, const CaseSweep& sweep) {
    text += "\n[[sweep]]\n";
    write_line(text, "name", in_quotes(sweep.name));
    write_text(text, "title", sweep.title);
    write_text(text, "caption", sweep.caption);
    write_text(text, "output_axis", sweep.output_axis);
    if (sweep.draw != SweepDrawing::all) {
        write_line(text, "draw", in_quotes(word_of(sweep.draw)));
    }
    for (const SweptInput& swept : sweep.vary) {
        text += "\n[[sweep.vary]]\n";
        write_swept(text, swept);
    }
    if (sweep.each) {
        text += "\n[sweep.each]\n";
        write_swept(text, *sweep.each);
    }
    for (const SweepCurve& curve : sweep.curves) {
        text += "\n[[sweep.curve]]\n";
        write_line(text, "label", in_quotes(curve.label));
        write_line(text, "output", in_quotes(curve.output));
        write_line(text, "dash", in_quotes(word_of(curve.dash)));
        if (!curve.conditions.empty()) {
            write_line(text, "with", written_conditions(curve.conditions));
        }
    }
    for (const PrintedPoints& printed : sweep.printed) {
        write_printed(text, printed);
    }
    for (const CurveCrossing& crossing : sweep.crossings) {
        text += "\n[[sweep.crossing]]\n";
        write_remarks(text, crossing);
        const Dimension dimension = sweep.vary.front().dimension;
        for (const auto& [key, value] :
             {std::pair{"printed", crossing.printed}, std::pair{"tolerance", crossing.tolerance}}) {
            if (value) {
                write_line(text, key, written_quantity(*value, dimension));
            }
        }
    }
    for (const CurveStatement& statement : sweep.statements) {
        text += "\n[[sweep.statement]]\n";
        write_remarks(text, statement);
        write_line(text, "is", in_quotes(word_of(statement.relation)));
    }
}

}  // namespace delabole
