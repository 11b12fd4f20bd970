// Published problems of jointed slopes: factors of safety by strength reduction beside those of other codes.
#include "cases/program/case/case_file.hpp"
#include "cases/program/models/relaxation/figures.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/thesis/reproduction.hpp"
#include "cases/program/thesis/thesis_tables.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "dynamic_relaxation/study/strength_bound.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

// Published factors of safety; for a tilting table they are critical tilts in degrees.
struct PublishedFactors {
    std::string problem;
    std::string name;  // of the case
    std::optional<double> closed_form;
    std::optional<double> udec;
    std::optional<double> rs2;
    std::optional<double> rs2_improved;
    std::optional<double> xslope;
    std::optional<double> other;
    std::string remark;
    static constexpr std::string_view file = "published/published_factors.csv";
    static constexpr auto fields() {
        using P = PublishedFactors;
        return joined(
            table_columns<&P::problem, &P::remark>(), FieldTable{section("case", &P::name, "")},
            table_columns<&P::closed_form, &P::udec, &P::rs2, &P::rs2_improved, &P::xslope, &P::other>(more_than(0)));
    }
};

struct Code {
    std::string name;
    std::optional<double> PublishedFactors::*value;
    Colour colour;
    Marker marker;
};

const std::vector<Code>& codes() {
    static const std::vector<Code> all = {
        {"closed form", &PublishedFactors::closed_form, Colour::black, Marker::cross},
        {"UDEC", &PublishedFactors::udec, Colour::vermilion, Marker::filled_circle},
        {"RS2", &PublishedFactors::rs2, Colour::blue, Marker::filled_square},
        {"RS2, improved joints", &PublishedFactors::rs2_improved, Colour::sky, Marker::filled_square},
        {"XSLOPE", &PublishedFactors::xslope, Colour::green, Marker::filled_triangle},
        {"other", &PublishedFactors::other, Colour::orange, Marker::filled_diamond}};
    return all;
}

struct Problem {
    PublishedFactors published;
    CaseFile file;
    CriticalAnswer answer = {};
    std::optional<double> bound = {};  // by statics alone
    std::size_t blocks = 0;
    double seconds = 0;

    const RelaxationStudy& study() const { return std::get<RelaxationStudy>(file.model); }
    Dimension dimension() const { return dimension_of(parameter_of(*study().critical)); }
    // Converts a value to the unit of the published ones.
    double shown(double value) const { return in_display_unit(value, dimension()); }
};

void solve(Problem& problem) {
    const Stopwatch watch;
    StudyWork work;
    work.watch = [](double) { return !interrupt_flag(); };
    problem.answer = find_critical(problem.study(), work);
    problem.seconds = watch.seconds();
    const RelaxationScene scene = relaxation_scene(problem.study());
    problem.blocks = scene.block.size();
    if (parameter_of(*problem.study().critical) == CriticalParameter::strength_reduction) {
        problem.bound = greatest_strength_reduction(scene, &interrupt_flag());
    }
}

std::string value_in_table(const Problem& problem, double value) {
    return human_number(problem.shown(value), 4);
}

std::string found_in_words(const Problem& problem, const PathValue& answer) {
    return answer.status == CriticalStatus::found ? value_in_table(problem, answer.value())
                                                  : human_name(word_of(answer.status));
}

std::string bracket_in_words(const Problem& problem, const PathValue& answer) {
    return value_in_table(problem, std::min(answer.stands, answer.fails)) + " to " +
           value_in_table(problem, std::max(answer.stands, answer.fails));
}

// A closed form is met within 3 %; without one, the value is within the span of the codes, or not.
Remark verdict(const Problem& problem) {
    if (problem.answer.status != CriticalStatus::found) {
        return "no value";
    }
    const double value = problem.shown(problem.answer.value());
    if (const std::optional<double>& closed = problem.published.closed_form) {
        const double off = 100 * (value / *closed - 1);
        return statement(std::abs(off) <= 3) + ": " + human_number(off, 2) + " % off the closed form";
    }
    std::vector<double> values;
    for (const Code& code : codes()) {
        if (const std::optional<double>& one = problem.published.*code.value) {
            values.push_back(*one);
        }
    }
    const auto [least, most] = std::ranges::minmax(values);
    constexpr double rounding = 0.005;  // of values printed with two decimals
    const bool within = value >= least - rounding && value <= most + rounding;
    return statement(within) + (within ? ": within" : ": outside") + " the span of the codes";
}

// Collects the reasons that a case gives for values that are not met.
std::string reasons(const CaseFile& file) {
    std::string text;
    for (const Expectation& expectation : file.expectations) {
        if (expectation.unreachable) {
            text += (text.empty() ? "" : "; ") + *expectation.unreachable;
        }
    }
    return text;
}

// Friction and strength of the joints, in the order in which the case has them.
std::string joints_in_words(const RelaxationStudy& study) {
    std::string text;
    for_each_named_number(study.model, [&](const std::string&, const FieldInfo& info, double value) {
        const bool next = info.key == "friction_angle";
        if (next || info.key == "cohesion" || info.key == "tensile_strength") {
            text += (text.empty() ? ""
                     : next       ? "; "
                                  : ", ") +
                    human_name(info.key) + ' ' + value_in_words(value, info.dimension);
        }
    });
    return text;
}

Table factor_table(const std::vector<Problem>& problems) {
    Table table{
        "Factors of safety by strength reduction and as published; of RJ-16 critical tilts in degrees. Statics: up "
        "to this factor forces over faces exist that strength allows and that hold the blocks.",
        {"problem", "joints", "factor"_number, "bracket"_number, "path", "statics"_number, "blocks"_number,
         "seconds"_number}};
    for (const Code& code : codes()) {
        table.columns.emplace_back(code.name, true);
    }
    table.columns.emplace_back("verdict");
    table.columns.emplace_back("remark");
    for (const Problem& problem : problems) {
        table.rows.push_back({problem.file.title, joints_in_words(problem.study()),
                              found_in_words(problem, problem.answer), bracket_in_words(problem, problem.answer),
                              human_name(word_of(problem.answer.path)),
                              problem.bound ? human_number(*problem.bound, 4) : "", std::to_string(problem.blocks),
                              human_number(problem.seconds, 2)});
        std::vector<std::string>& row = table.rows.back();
        for (const Code& code : codes()) {
            const std::optional<double>& value = problem.published.*code.value;
            row.push_back(value ? human_number(*value, 4) : "");
        }
        row.push_back(in_words(verdict(problem)));
        const std::string why = reasons(problem.file);
        row.push_back(problem.published.remark + (problem.published.remark.empty() || why.empty() ? "" : "; ") + why);
    }
    return table;
}

// Draws published values divided by those found here, problem by problem.
Figure factor_figure(const std::vector<Problem>& problems) {
    Figure figure{.title = "Published values over those of strength reduction",
                  .x = {.title = "problem"},
                  .y = {.title = "published over computed"},
                  .width = 1000};
    std::vector<double> place;
    for (std::size_t index = 0; index < problems.size(); ++index) {
        place.push_back(static_cast<double>(index + 1));
        figure.x.ticks.push_back({place.back(), problems[index].published.problem.substr(3)});
    }
    const double last = static_cast<double>(problems.size()) + 0.5;
    constexpr double allowed = 0.03;
    figure.series.emplace_back(Region{.outline = {Point(0.5, 1 - allowed), Point(last, 1 - allowed),
                                                  Point(last, 1 + allowed), Point(0.5, 1 + allowed)},
                                      .legend = "computed, 3 % either way"});
    for (const Code& code : codes()) {
        Points points{.legend = code.name, .colour = code.colour, .marker = code.marker};
        for (std::size_t index = 0; index < problems.size(); ++index) {
            const Problem& problem = problems[index];
            const std::optional<double>& value = problem.published.*code.value;
            if (value && problem.answer.status == CriticalStatus::found) {
                points.points.emplace_back(place[index], *value / problem.shown(problem.answer.value()));
            }
        }
        figure.series.emplace_back(std::move(points));
    }
    return figure;
}

void append_mechanism(const Sheet& sheet, const Problem& problem, const PathValue& answer) {
    if (answer.failed && answer.failed->end) {
        const std::string path(word_of(answer.path));
        sheet.draw(mechanism_figure(*answer.failed, problem.published.problem + ", path " + path + ", failing at " +
                                                        in_digits(answer.fails, problem.dimension(), 4)),
                   problem.published.name + (problem.answer.other.empty() ? "" : '_' + path),
                   problem.file.title + ", path " + path + ". " + problem.file.description);
    }
}

Json json_of(const Problem& problem) {
    return {{"case", problem.published.name},
            {"status", word_of(problem.answer.status)},
            {"path", word_of(problem.answer.path)},
            {"stands", problem.shown(problem.answer.stands)},
            {"fails", problem.shown(problem.answer.fails)},
            {"statics", problem.bound ? Json(*problem.bound) : Json(nullptr)},
            {"blocks", problem.blocks},
            {"seconds", problem.seconds},
            {"verdict", in_words(verdict(problem))}};
}

PrintedRow printed_row(const Problem& problem) {
    std::string printed;
    for (const Code& code : codes()) {
        if (const std::optional<double>& value = problem.published.*code.value) {
            printed += (printed.empty() ? "" : ", ") + code.name + " " + human_number(*value, 4);
        }
    }
    return {problem.file.title, printed, found_in_words(problem, problem.answer), "", verdict(problem)};
}

Reproduction reproduce_factors(const Sheet& sheet) {
    std::vector<Problem> problems;
    for (const PublishedFactors& row : rows_of<PublishedFactors>()) {
        CaseFile file = built_in_case("published", row.name);
        problems.push_back({.published = row, .file = std::move(file)});
    }
    run_part(sheet.folder, {"published problems", 0, 0.9}, problems.size(),
             [&](std::size_t index) { solve(problems[index]); });
    sheet.add(Heading{"Published problems of jointed slopes"});
    sheet.add(factor_table(problems));
    sheet.draw(factor_figure(problems), "published_factors", "Values of other codes over those computed here.");
    Reproduction result;
    for (const Problem& problem : problems) {
        append_mechanism(sheet, problem, problem.answer);
        for (const PathValue& other : problem.answer.other) {
            append_mechanism(sheet, problem, other);
        }
        result.add(printed_row(problem));
        result.json["problems"].push_back(json_of(problem));
    }
    return result;
}

}  // namespace

ReproductionChapter published_problems() {
    return {"published",
            "published problems of jointed slopes, RJ-1 to RJ-20",
            "Published problems of jointed slopes",
            {{"factors", "published", "factors of safety by strength reduction beside those of other codes",
              reproduce_factors, ReproductionCost::minutes}}};
}

}  // namespace delabole
