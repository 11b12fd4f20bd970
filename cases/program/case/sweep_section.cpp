// [[sweep]]: which inputs vary, which outputs are drawn, and which printed values belong to them.
#include "cases/program/case/sweep.hpp"

#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/described_reader.hpp"
#include "cases/program/reader/described_writer.hpp"
#include "cases/program/reader/names.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <span>
#include <utility>

namespace delabole {
namespace {

constexpr std::size_t most_analyses = 1'000'000;  // of a sweep
constexpr std::size_t most_of_a_kind = 100;       // sweeps of a case, curves of a sweep and so on

// Finds the values that an input takes; complains and returns false if there are none.
bool find_values(Reading& reading, const std::string& path, const ModelNames& names, SweptInput& swept) {
    const Quantity* input = find_quantity(names.inputs, swept.input);
    if (input == nullptr) {
        return false;
    }
    swept.si_per_unit = display_unit(input->dimension).si_per_unit;
    if (!swept.unit.empty()) {
        const ParsedQuantity one = parse_quantity("1 " + swept.unit, input->dimension);
        if (one.status == QuantityStatus::ok) {
            swept.si_per_unit = one.value;
        } else {
            reading.complain_at(path + ".unit", "is not a unit of " + swept.input + ": " + one.message);
        }
    }
    swept.values = swept.listed;
    if (reading.knows(path + ".values")) {
        if (swept.from || swept.to || swept.points) {
            reading.complain_at(path + ".values", "takes the place of from, to and points");
        } else if (swept.listed.size() < 2) {
            reading.complain_at(path + ".values", "must be a list of at least two values");
        } else if (std::ranges::adjacent_find(swept.listed, std::greater_equal{}) != swept.listed.end()) {
            reading.complain_at(path + ".values", "must be more than the value before");
        }
    } else if (!swept.from || !swept.to) {
        reading.complain_at(path + ".input", "needs its first and last value, from and to, or values = [...]");
    } else if (!(*swept.to > *swept.from)) {
        if (!reading.blames(path + ".from") && !reading.blames(path + ".to")) {
            reading.complain_at(path + ".to", "the last value must be greater than the first");
        }
    } else {
        swept.points = swept.points.value_or(SweptInput::standard_points);
        swept.values = spaced_values(*swept.from, *swept.to, *swept.points);
    }
    return swept.values.size() > 1;
}

// Whether a list has too many elements to be read.
bool too_many(Section& section, std::string_view key) {
    const Node* all = section.peek(key);
    if (all == nullptr || all->elements.size() <= most_of_a_kind) {
        return false;
    }
    section.complain(key, *all, "are more than " + std::to_string(most_of_a_kind));
    return true;
}

// Reads the curves. It needs to know the input along the axis, since the numbers of crossings are values of it.
void read_curves(Section& section, const ModelNames& names, CaseSweep& sweep) {
    const std::string output = read_optional_text(section, "output");
    section.name_quantity(sweep.vary.empty() ? nullptr : find_quantity(names.inputs, sweep.vary.front().input));
    read_fields<SweepCurves>(section, sweep);
    for (SweepCurve& curve : sweep.curves) {
        curve.output = curve.output.empty() ? output : curve.output;
    }
    if (sweep.curves.empty()) {
        sweep.curves.push_back({.label = output, .output = output, .conditions = {}});
    }
    if (std::ranges::find(sweep.curves, "", &SweepCurve::output) != sweep.curves.end()) {
        section.require("output", "name of an output of the model, or [[sweep.curve]] with an output each");
    }
}

void check_curves(Reading& reading, const std::string& path, const CaseSweep& sweep) {
    constexpr std::string_view no_curve = "is not the label of a curve";
    check_unique(reading, path + ".curve", sweep.curves, &SweepCurve::label, "label", "names two curves of the sweep");
    check_not_empty(reading, path + ".curve", sweep.curves, &SweepCurve::label, "label");
    check_not_empty(reading, path + ".printed", sweep.printed, &PrintedPoints::label, "label");
    check_not_empty(reading, path + ".crossing", sweep.crossings, &CurveRemark::label, "label");
    check_not_empty(reading, path + ".statement", sweep.statements, &CurveRemark::label, "label");
    for (std::size_t index = 0; index < sweep.printed.size(); ++index) {
        if (sweep.printed[index].points.empty() && reading.clean()) {
            reading.complain_at(indexed(path + ".printed", index) + ".points",
                                "must be a list of points, [[x, y], ...]");
        }
    }
    for (std::size_t index = 0; index < sweep.crossings.size(); ++index) {
        const CurveCrossing& crossing = sweep.crossings[index];
        const std::string own = indexed(path + ".crossing", index);
        check_among(reading, own + ".curve", crossing.curve, sweep.curves, &SweepCurve::label, no_curve);
        check_among(reading, own + ".other", crossing.other, sweep.curves, &SweepCurve::label, no_curve);
        if (crossing.other.empty()) {
            reading.complain_at(own + ".label", "needs other, the label of the curve that it meets");
        }
        if (crossing.printed && !crossing.tolerance && !crossing.unreachable) {
            reading.complain_at(own + ".printed", "needs a tolerance");
        }
        if (crossing.printed && sweep.each) {
            reading.complain_at(own + ".printed",
                                "has a printed crossing, which does not say to which value of [sweep.each] it belongs");
        }
    }
    for (std::size_t index = 0; index < sweep.statements.size(); ++index) {
        const CurveStatement& statement = sweep.statements[index];
        const std::string own = indexed(path + ".statement", index);
        const auto check_label = [&](const std::string& key, const std::string& label) {
            if (sweep.each &&
                std::ranges::find(sweep.crossings, statement.curve, &CurveRemark::label) != sweep.crossings.end()) {
                check_among(reading, own + key, label, sweep.crossings, &CurveRemark::label, no_curve);
            } else {
                check_among(reading, own + key, label, sweep.curves, &SweepCurve::label, no_curve);
            }
        };
        check_label(".curve", statement.curve);
        check_label(".other", statement.other);
        const bool compares = statement.relation == CurveRelation::below || statement.relation == CurveRelation::above;
        if (compares && statement.other.empty()) {
            reading.complain_at(own + ".is", "needs other, the label of the other curve");
        }
    }
}

// Checks that concern several keys together.
void check_sweep(Section& section, const std::vector<CaseSweep>& before, const CaseSweep& sweep) {
    Reading& reading = section.reading();
    const std::string& path = section.path();
    const auto complain = [&](const std::string& value, const std::string& message) {
        reading.complain(section.place(), path, value, message);
    };
    check_file_name(reading, path + ".name", sweep.name);
    if (std::ranges::find(before, sweep.name, &CaseSweep::name) != before.end()) {
        reading.complain_at(path + ".name", "names two sweeps");
    }
    if (const Node* vary = section.peek("vary"); vary == nullptr || vary->elements.empty() || sweep.vary.size() > 2) {
        complain({}, "needs one or two [[sweep.vary]], the inputs that vary");
    }
    check_curves(reading, path, sweep);
    if (sweep.vary.size() > 1 && !(sweep.crossings.empty() && sweep.statements.empty())) {
        complain({}, "has crossings or statements, which go with one [[sweep.vary]] alone");
    }
    if (sweep.draw == SweepDrawing::crossings && (!sweep.each || sweep.crossings.empty())) {
        reading.complain_at(path + ".draw", "needs [sweep.each] and [[sweep.crossing]]");
    }
    std::vector<SweptInput> all = sweep.vary;
    if (sweep.each) {
        all.push_back(*sweep.each);
    }
    std::size_t analyses = 1;
    std::set<std::string> inputs;
    for (const SweptInput& swept : all) {
        analyses *= swept.values.size();
        std::vector<std::string> names = swept.also;
        names.push_back(swept.input);
        for (const std::string& name : names) {
            if (!inputs.insert(name).second) {
                complain(shown(name), "varies twice in the sweep");
            }
        }
    }
    if (analyses > most_analyses) {
        complain(std::to_string(analyses), "points are more than " + std::to_string(most_analyses));
    }
}

// The names of a case and the further keys that a sweep varies or sets.
ModelNames names_of_sweep(const Section& section, const ModelNames& names, const NumberAtKey& number_at) {
    ModelNames known = names;
    const auto add = [&](const std::string& key, const Node& value) {
        if (find_quantity(known.inputs, key) == nullptr) {
            if (const std::optional<Quantity> number = number_at(key, value)) {
                known.inputs.push_back(*number);
            }
        }
    };
    const auto add_input = [&](const Node& swept) {
        const Node* input = swept.find("input");
        const Node* value = swept.find("from");
        const Node* values = swept.find("values");
        if (values != nullptr && !values->elements.empty()) {
            value = &values->elements.front();
        }
        if (input != nullptr && value != nullptr) {
            add(input->text, *value);
            const Node* also = swept.find("also");
            for (std::size_t index = 0; also != nullptr && index < also->elements.size(); ++index) {
                add(also->elements[index].text, *value);
            }
        }
    };
    if (const Node* vary = section.peek("vary")) {
        std::ranges::for_each(vary->elements, add_input);
    }
    if (const Node* each = section.peek("each")) {
        add_input(*each);
    }
    if (const Node* curves = section.peek("curve")) {
        for (const Node& curve : curves->elements) {
            if (const Node* with = curve.find("with")) {
                for_each_flat_entry(*with, add);
            }
        }
    }
    return known;
}

void read_sweep(Section& section, const ModelNames& names, std::vector<CaseSweep>& sweeps) {
    CaseSweep sweep{};
    sweep.place = section.place();
    bool readable = true;
    for (const std::string_view key : {"name", "title", "caption", "output_axis", "output", "vary", "each", "draw",
                                       "curve", "printed", "crossing", "statement"}) {
        section.allow(key);
        readable = !too_many(section, key) && readable;
    }
    if (!readable) {
        return;
    }
    read_fields<SweepInputs>(section, sweep);
    bool known = true;
    for (std::size_t index = 0; index < sweep.vary.size(); ++index) {
        known =
            find_values(section.reading(), indexed(section.path_of("vary"), index), names, sweep.vary[index]) && known;
    }
    if (sweep.each) {
        known = find_values(section.reading(), section.path_of("each"), names, *sweep.each) && known;
    }
    read_curves(section, names, sweep);
    if (known) {
        check_sweep(section, sweeps, sweep);
    }
    sweeps.push_back(std::move(sweep));
}

}  // namespace

std::vector<CaseSweep> read_sweeps(Section& root, const ModelNames& names, const NumberAtKey& number_at) {
    std::vector<CaseSweep> sweeps;
    if (too_many(root, "sweep")) {
        root.allow("sweep");
        return sweeps;
    }
    for_each_table(root, "sweep", [&](Section& section) {
        const ModelNames known = names_of_sweep(section, names, number_at);
        section.refer_to({std::span(&known, 1), "an output of the model"});
        read_sweep(section, known, sweeps);
    });
    return sweeps;
}

void write_sweep(std::string& text, const CaseSweep& sweep) {
    text += "\n[[sweep]]\n";
    write_values<SweepInputs>(text, sweep);
    write_sections<SweepInputs>(text, sweep, "sweep");
    write_sections<SweepCurves>(text, sweep, "sweep");
}

}  // namespace delabole
