#include "cases/program/sweeps/sweep_run.hpp"

#include "cases/program/case/case_file.hpp"
#include "cases/program/reader/case_error.hpp"
#include "cases/program/reader/names.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "fitting/work/parallel.hpp"
#include "fitting/work/words.hpp"
#include "numerics/scalar_search.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <mutex>
#include <utility>

namespace delabole {

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

void set_input(std::vector<Condition>& conditions, const SweptInput& swept, double value) {
    conditions.push_back({swept.input, value, swept.dimension});
    for (const std::string& other : swept.also) {
        conditions.push_back({other, value, swept.dimension});
    }
}

// Curves that differ only in their output share an analysis.
std::vector<std::vector<std::size_t>> curves_by_conditions(const std::vector<SweepCurve>& curves) {
    const auto alike = [](const Condition& one, const Condition& other) {
        return one.input == other.input && one.value == other.value;
    };
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t curve = 0; curve < curves.size(); ++curve) {
        const auto group = std::ranges::find_if(groups, [&](const std::vector<std::size_t>& one) {
            return std::ranges::equal(curves[one.front()].conditions, curves[curve].conditions, alike);
        });
        if (group == groups.end()) {
            groups.push_back({curve});
        } else {
            group->push_back(curve);
        }
    }
    return groups;
}

struct Answer {
    double value = no_number;
    std::string word = {};  // if there is no number
    bool known = false;     // whether the model has the output
    Dimension dimension = Dimension::ratio;
};

Answer answer_of(const Analysis& analysis, const std::string& output) {
    const NamedOutput* found = analysis.find(output);
    if (!analysis.failure.empty() || found == nullptr) {
        return {.word = analysis.failure.empty() ? "none" : analysis.failure};
    }
    Answer answer{.known = true, .dimension = found->dimension};
    if (const auto* number = std::get_if<double>(&found->value)) {
        answer.value = std::isfinite(*number) ? *number : no_number;
        answer.word = std::isfinite(*number) ? "" : *number > 0 ? "infinite" : "-infinite";
    } else {
        answer.word = std::get<std::string>(found->value);
    }
    return answer;
}

// Evaluates the case at the points of a sweep and stores the results.
class SweepComputation {
  public:
    SweepComputation(const CaseFile& file, const CaseSweep& sweep)
        : file_(file), sweep_(sweep), inputs_(named_inputs(file.model)) {
        first_ = sweep.vary.front().values.size();
        second_ = sweep.vary.size() > 1 ? sweep.vary[1].values.size() : 1;
        groups_ = curves_by_conditions(sweep.curves);
        const std::size_t figures = sweep.each ? sweep.each->values.size() : 1;
        known_.assign(figures * sweep.curves.size(), false);
        for (std::size_t figure = 0; figure < figures; ++figure) {
            SweptFigure& made = figures_.emplace_back();
            made.each = sweep.each ? std::optional(sweep.each->values[figure]) : std::nullopt;
            for (const SweepCurve& curve : sweep.curves) {
                made.curves.push_back({curve.label, Dimension::ratio, std::vector(first_ * second_, no_number),
                                       std::vector<std::string>(first_ * second_)});
            }
        }
    }

    std::size_t points() const { return figures_.size() * groups_.size() * first_ * second_; }

    void compute(std::size_t number) {
        const std::size_t place = number % (first_ * second_);
        const std::size_t group = number / (first_ * second_) % groups_.size();
        const std::size_t figure = number / (first_ * second_) / groups_.size();
        std::vector<Condition> conditions = conditions_of(sweep_.curves[groups_[group].front()], figure);
        if (sweep_.vary.size() > 1) {
            set_input(conditions, sweep_.vary[1], sweep_.vary[1].values[place / first_]);
        }
        const Analysis analysis = analysis_at(std::move(conditions), sweep_.vary.front().values[place % first_]);
        for (const std::size_t curve : groups_[group]) {
            Answer answer = answer_of(analysis, sweep_.curves[curve].output);
            SweptCurve& made = figures_[figure].curves[curve];
            made.values[place] = answer.value;
            made.words[place] = std::move(answer.word);
            if (answer.known) {
                const std::scoped_lock lock(noting_);
                made.dimension = answer.dimension;
                known_[figure * sweep_.curves.size() + curve] = true;
            }
        }
        if (!analysis.failure.empty()) {
            return;
        }
        const std::scoped_lock lock(noting_);
        if (names_.empty()) {
            for (const NamedOutput& output : analysis.outputs) {
                names_.push_back(output.name);
            }
        }
    }

    void find_crossings() {
        for (std::size_t figure = 0; figure < figures_.size(); ++figure) {
            for (const CurveCrossing& crossing : sweep_.crossings) {
                figures_[figure].crossings.push_back(crossing_of(figure, crossing));
            }
        }
    }

    std::vector<SweptFigure> figures() {
        for (std::size_t curve = 0; curve < sweep_.curves.size(); ++curve) {
            bool known = names_.empty();  // without any answer the words of failure are the reason
            for (std::size_t figure = 0; figure < figures_.size(); ++figure) {
                known = known || known_[figure * sweep_.curves.size() + curve];
            }
            if (!known) {
                const std::string& output = sweep_.curves[curve].output;
                throw CaseError({{file_.name, sweep_.place.line, sweep_.place.column, "sweep.output", output,
                                  "is not an output of this case" + suggestion(output, names_)}});
            }
        }
        return std::move(figures_);
    }

  private:
    std::vector<Condition> conditions_of(const SweepCurve& curve, std::size_t figure) const {
        std::vector<Condition> conditions = curve.conditions;
        if (sweep_.each) {
            set_input(conditions, *sweep_.each, sweep_.each->values[figure]);
        }
        return conditions;
    }

    Analysis analysis_at(std::vector<Condition> conditions, double value) const {
        set_input(conditions, sweep_.vary.front(), value);
        AnalysisWork work;
        work.watch = [](double, const std::string&, bool) { return !interrupt_flag(); };
        return analyse_model(model_at(std::move(conditions)), work);
    }

    // Inputs change the model itself; with other keys of the case it is read again.
    CaseModel model_at(std::vector<Condition> conditions) const {
        std::vector<Setting> settings;
        std::erase_if(conditions, [&](const Condition& condition) {
            const bool is_input = find_quantity(inputs_, condition.input) != nullptr;
            if (!is_input) {
                settings.push_back({condition.input, written_quantity(condition.value, condition.dimension)});
            }
            return !is_input;
        });
        return with_conditions(settings.empty() ? file_.model : model_with(file_, settings), conditions);
    }

    std::size_t index_of(const std::string& label) const {
        return static_cast<std::size_t>(std::ranges::find(sweep_.curves, label, &SweepCurve::label) -
                                        sweep_.curves.begin());
    }

    std::optional<double> crossing_of(std::size_t figure, const CurveCrossing& crossing) const {
        const std::size_t one = index_of(crossing.curve);
        const std::size_t other = index_of(crossing.other);
        const std::vector<double>& x = sweep_.vary.front().values;
        const auto value_at = [&](std::size_t curve, double position) {
            return answer_of(analysis_at(conditions_of(sweep_.curves[curve], figure), position),
                             sweep_.curves[curve].output)
                .value;
        };
        const auto apart = [&](std::size_t place) {
            return figures_[figure].curves[one].values[place] - figures_[figure].curves[other].values[place];
        };
        for (std::size_t place = 1; place < x.size(); ++place) {
            if (std::isfinite(apart(place - 1)) && std::isfinite(apart(place)) &&
                std::signbit(apart(place - 1)) != std::signbit(apart(place))) {
                return find_root([&](double position) { return value_at(one, position) - value_at(other, position); },
                                 {x[place - 1], x[place]})
                    .position;
            }
        }
        return std::nullopt;
    }

    const CaseFile& file_;
    const CaseSweep& sweep_;
    std::vector<Quantity> inputs_;
    std::size_t first_ = 0;
    std::size_t second_ = 0;
    std::vector<std::vector<std::size_t>> groups_;
    std::vector<SweptFigure> figures_;
    std::mutex noting_;
    std::vector<bool> known_;         // by figure and curve: whether the model has its output at some point
    std::vector<std::string> names_;  // of outputs, for a suggestion
};

// Curves over one input to which statements refer, with a prefix for their labels.
struct StatedCurves {
    std::string prefix;
    const SweptInput* input;
    std::vector<SweptCurve> curves;
};

// The curves of each figure, and the crossings over `each` as one more set of curves.
std::vector<StatedCurves> stated_curves(const SweepRun& run) {
    std::vector<StatedCurves> all;
    const CaseSweep& sweep = run.sweep;
    for (const SweptFigure& figure : run.figures) {
        all.push_back(
            {sweep.each ? each_in_words(*sweep.each, *figure.each) + ": " : "", &sweep.vary.front(), figure.curves});
    }
    if (sweep.each) {
        all.push_back({"", &*sweep.each, crossing_curves(run)});
    }
    return all;
}

Comparison compare_crossing(const CurveCrossing& crossing, const std::optional<double>& found, Dimension dimension) {
    Comparison row;
    if (found && crossing.printed) {
        row = compare_numbers(*crossing.printed, *found, crossing.tolerance.value_or(0), dimension);
    } else {
        row.expected = crossing.printed ? readable_quantity(*crossing.printed, dimension) : "not printed";
        row.computed = found ? in_six_digits(*found, dimension) : "none";
        row.verdict = crossing.printed ? Verdict::missed : Verdict::met;
    }
    return row;
}

// How far a relation holds, in words; the verdict is missed if it does not hold everywhere.
Comparison compare_relation(const CurveStatement& statement, const SweptCurve& curve, const SweptCurve* other,
                            const SweptInput& input) {
    Comparison row;
    row.expected = word_of(statement.relation);
    row.verdict = Verdict::missed;
    const double sign =
        statement.relation == CurveRelation::falls || statement.relation == CurveRelation::below ? -1 : 1;
    double largest = 0;
    double last_held = no_number;
    double previous = no_number;
    for (std::size_t place = 0; place < input.values.size(); ++place) {
        const double reference = other == nullptr ? previous : other->values[place];
        const double by = sign * (curve.values[place] - reference);
        previous = std::isfinite(curve.values[place]) ? curve.values[place] : previous;
        if (!std::isfinite(by)) {
            continue;
        }
        if (by < 0 || (other == nullptr && by == 0)) {
            row.computed = std::isfinite(last_held)
                               ? "up to " + readable_quantity(last_held, input.dimension)
                               : "not at " + readable_quantity(input.values[place], input.dimension);
            return row;
        }
        largest = std::max(largest, by);
        last_held = input.values[place];
    }
    if (largest == 0) {
        row.computed = "nowhere";
        return row;
    }
    row.verdict = Verdict::met;
    row.computed = std::string(word_of(statement.relation)) +
                   (other == nullptr ? "" : " by up to " + value_in_words(largest, curve.dimension));
    return row;
}

template <class Printed>
Comparison remarked(Comparison row, const std::string& prefix, const Printed& printed) {
    row.what = prefix + printed.label;
    row.source = printed.source;
    row.note = printed.note;
    excuse(row, printed.unreachable);
    return row;
}

}  // namespace

std::string each_in_words(const SweptInput& each, double value) {
    const std::string unit = each.unit.empty() ? std::string(display_unit(each.dimension).symbol) : each.unit;
    const std::string number = number_in_words(each.shown(value));
    return each.axis.empty() ? each.input + " = " + number + (unit.empty() ? "" : " " + unit)
                             : each.axis + " = " + number;
}

std::vector<SweptCurve> crossing_curves(const SweepRun& run) {
    std::vector<SweptCurve> curves;
    for (std::size_t index = 0; index < run.sweep.crossings.size(); ++index) {
        SweptCurve curve;
        curve.label = run.sweep.crossings[index].label;
        curve.dimension = run.sweep.vary.front().dimension;
        for (const SweptFigure& figure : run.figures) {
            curve.values.push_back(figure.crossings[index].value_or(no_number));
            curve.words.emplace_back(figure.crossings[index] ? "" : "none");
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

SweepRun run_sweep(const CaseFile& file, const CaseSweep& sweep, const SweepWork& work) {
    SweepComputation computation(file, sweep);
    std::mutex reporting;
    std::size_t done = 0;
    run_tasks(computation.points(), work.threads, [&](std::size_t number) {
        if (interrupt_flag()) {
            return;
        }
        computation.compute(number);
        if (work.progress) {
            const std::scoped_lock lock(reporting);
            work.progress(static_cast<double>(++done) / static_cast<double>(computation.points()));
        }
    });
    stop_if_interrupted();
    computation.find_crossings();
    return {sweep, computation.figures()};
}

std::vector<Comparison> compare_sweep(const SweepRun& run) {
    std::vector<Comparison> rows;
    const CaseSweep& sweep = run.sweep;
    for (std::size_t index = 0; index < sweep.crossings.size() && !sweep.each; ++index) {
        const CurveCrossing& crossing = sweep.crossings[index];
        rows.push_back(
            remarked(compare_crossing(crossing, run.figures.front().crossings[index], sweep.vary.front().dimension), "",
                     crossing));
    }
    for (const StatedCurves& stated : stated_curves(run)) {
        for (const CurveStatement& statement : sweep.statements) {
            const auto find = [&](const std::string& label) {
                return std::ranges::find(stated.curves, label, &SweptCurve::label);
            };
            const auto curve = find(statement.curve);
            const auto other = find(statement.other);
            if (curve == stated.curves.end() || (other == stated.curves.end() && !statement.other.empty())) {
                continue;
            }
            rows.push_back(remarked(
                compare_relation(statement, *curve, other == stated.curves.end() ? nullptr : &*other, *stated.input),
                stated.prefix, statement));
        }
    }
    return rows;
}

std::vector<Comparison> compare_sweeps(const CaseFile& file, const SweepWork& work) {
    std::vector<Comparison> rows;
    for (const CaseSweep& sweep : file.sweeps) {
        if (!sweep.crossings.empty() || !sweep.statements.empty()) {
            std::ranges::move(compare_sweep(run_sweep(file, sweep, work)), std::back_inserter(rows));
        }
    }
    return rows;
}

}  // namespace delabole
