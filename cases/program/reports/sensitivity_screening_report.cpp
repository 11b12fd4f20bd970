#include "cases/program/reports/sensitivity_parts.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

constexpr std::size_t most_named = 3;

// "falls by 0.12 from 62 deg to 66 deg"
std::string change_in_words(const SweepChange& change, Dimension quantity, Dimension parameter) {
    return (change.change < 0 ? "falls by " : "rises by ") + value_in_words(std::abs(change.change), quantity) +
           " from " + value_in_words(change.from, parameter) + " to " + value_in_words(change.to, parameter);
}

std::string course_in_words(const ParameterSweep& sweep, Dimension quantity, Dimension parameter) {
    switch (sweep.course) {
    case SweepCourse::not_monotone:
        return "not monotone: " + change_in_words(sweep.main, quantity, parameter) + ", and " +
               change_in_words(sweep.reversal, quantity, parameter);
    case SweepCourse::too_few_answers:
        return "too few answers";
    default:
        return human_name(word_of(sweep.course));
    }
}

std::string answer_in_words(const Evaluation& answer, Dimension dimension) {
    return answer.valid() ? value_in_words(answer.value, dimension)
                          : human_name(answer.failure.empty() ? "not_a_number" : answer.failure);
}

std::string listed(const StudySubject& subject, const SweepResult& result, SweepCourse course) {
    std::vector<std::string> names;
    for (std::size_t index = 0; index < subject.names.size(); ++index) {
        if (result.parameters[index].course == course) {
            names.push_back(subject.names[index]);
        }
    }
    return list_in_words(names);
}

std::string method_in_words(const SweepSettings& settings) {
    const std::string points = std::to_string(settings.points);
    return settings.samples > 0 ? "Means of " + points + " classes of equal number of each parameter, from " +
                                      std::to_string(settings.samples) + " samples of all (Latin hypercube)."
                                : points + " points of each parameter from its " + percent(settings.lower_probability) +
                                      " to its " + percent(settings.upper_probability) +
                                      " quantile, the others at their medians; correlations play no part.";
}

Json json_of(const SweepChange& change, Dimension quantity, Dimension parameter) {
    return {{"from", json_of(change.from, parameter)},
            {"to", json_of(change.to, parameter)},
            {"change", json_of(change.change, quantity)}};
}

std::string end_in_words(const StudySubject& subject, const Evaluation& answer) {
    return answer_in_words(answer, subject.quantity.dimension);
}

}  // namespace

void document_tornado(const StudySubject& subject, const TornadoResult& result, const Sheet& sheet, Json& json) {
    const TornadoSettings& settings = *subject.study.tornado;
    sheet.add(Heading{"One parameter at a time"});
    const auto cell = [&](const Evaluation& answer) -> Cell {
        if (answer.valid()) {
            return subject.shown(answer.value);
        }
        return end_in_words(subject, answer);
    };
    Table table{"", {"parameter", "low"_number, "high"_number, "at low"_number, "at high"_number}};
    CsvTable csv({"parameter", "unit", "low", "high", subject.column("at_low"), subject.column("at_high")});
    json["at_medians"] = result.at_medians.valid() ? json_number(subject.shown(result.at_medians.value))
                                                   : Json(std::string(result.at_medians.failure));
    for (std::size_t index = 0; index < subject.names.size(); ++index) {
        const TornadoBar& bar = result.bars[index];
        const Dimension dimension = subject.dimensions[index];
        table.rows.push_back({subject.names[index], value_in_words(bar.low.parameter, dimension),
                              value_in_words(bar.high.parameter, dimension), end_in_words(subject, bar.low.answer),
                              end_in_words(subject, bar.high.answer)});
        csv.add_row({subject.names[index], std::string(display_unit(dimension).symbol),
                     in_display_unit(bar.low.parameter, dimension), in_display_unit(bar.high.parameter, dimension),
                     cell(bar.low.answer), cell(bar.high.answer)});
        const auto swing = bar.swing(result.at_medians);
        json["swing"][subject.names[index]] = swing ? json_number(subject.shown(*swing)) : Json(nullptr);
    }
    sheet.write("tornado.csv", csv.text());
    std::optional<double> limit;
    if (subject.study.failure) {
        limit = subject.study.failure->limit;
    }
    sheet.draw(
        tornado_range_figure(subject.quantity, result, settings, subject.study.parameters, subject.dimensions, limit),
        "tornado",
        "Each parameter alone between its quantiles, the others at their medians; correlations play no part. With all "
        "at their medians: " +
            end_in_words(subject, result.at_medians) + ".");
    sheet.add(std::move(table));
}

std::vector<std::string> sweep_findings(const StudySubject& subject, const std::vector<SweepResult>& results) {
    std::vector<std::string> sentences;
    for (std::size_t number = 0; number < results.size(); ++number) {
        const SweepResult& result = results[number];
        const Dimension dimension = subject.swept[number];
        const std::string quantity = human_name(result.quantity);
        std::vector<std::size_t> order;
        for (std::size_t index = 0; index < subject.names.size(); ++index) {
            const SweepCourse course = result.parameters[index].course;
            if (course == SweepCourse::rises || course == SweepCourse::falls || course == SweepCourse::not_monotone) {
                order.push_back(index);
            }
        }
        std::ranges::stable_sort(order, std::greater{},
                                 [&](std::size_t index) { return std::abs(result.parameters[index].main.change); });
        order.resize(std::min(order.size(), most_named));
        std::vector<std::string> most;
        for (const std::size_t index : order) {
            const ParameterSweep& sweep = result.parameters[index];
            most.push_back(subject.names[index] + " (" + human_name(word_of(sweep.course)) +
                           (sweep.course == SweepCourse::not_monotone ? ", by " : " by ") +
                           value_in_words(std::abs(sweep.main.change), dimension) + ")");
        }
        if (!most.empty()) {
            sentences.push_back("The " + quantity + " changes most with " + list_in_words(most) + ".");
        }
        for (std::size_t index = 0; index < subject.names.size(); ++index) {
            const ParameterSweep& sweep = result.parameters[index];
            if (sweep.course == SweepCourse::not_monotone) {
                sentences.push_back("Not monotone in " + subject.names[index] + ": the " + quantity + " " +
                                    change_in_words(sweep.main, dimension, subject.dimensions[index]) + ", and " +
                                    change_in_words(sweep.reversal, dimension, subject.dimensions[index]) + ".");
            }
        }
        const std::string scattered = listed(subject, result, SweepCourse::within_scatter);
        if (!scattered.empty()) {
            sentences.push_back("The " + quantity + " changes by no more than its scatter can with " + scattered + ".");
        }
        const std::string idle = listed(subject, result, SweepCourse::constant);
        if (number > 0 && !idle.empty()) {
            sentences.push_back("The " + quantity + " does not change with " + idle + ".");
        }
    }
    return sentences;
}

void document_sweeps(const StudySubject& subject, const std::vector<SweepResult>& results, const Sheet& sheet,
                     Json& json) {
    const SweepSettings& settings = *subject.study.sweep;
    sheet.add(Heading{"Each parameter over its range"});
    sheet.add(Paragraph{method_in_words(settings) +
                        " Not monotone: beside its greatest change, the quantity has one of the other sign that "
                        "exceeds a hundredth of it, and what its scatter alone would make in one sweep of twenty."});
    CsvTable csv({"quantity", "quantity_unit", "parameter", "unit", "value", "answer"});
    for (std::size_t number = 0; number < results.size(); ++number) {
        const SweepResult& result = results[number];
        const Dimension dimension = subject.swept[number];
        const std::string unit(display_unit(dimension).symbol);
        Json& part = json[column_name(result.quantity, dimension)];
        part["evaluations"] = json_of(result.evaluations);
        Table table{human_name(result.quantity),
                    {"parameter", "from"_number, "to"_number, "there"_number, "in the middle"_number, "there"_number,
                     "scatter"_number, "course"}};
        for (std::size_t index = 0; index < subject.names.size(); ++index) {
            const ParameterSweep& sweep = result.parameters[index];
            const Dimension along = subject.dimensions[index];
            const auto answer = [&](std::size_t place) {
                return answer_in_words(sweep.points[place].answer, dimension);
            };
            Json& entry = part["parameters"][subject.names[index]];
            entry["course"] = word_of(sweep.course);
            if (sweep.points.empty()) {
                table.rows.push_back({subject.names[index], "", "", "", "", "", "", "too few answers"});
                continue;
            }
            table.rows.push_back({subject.names[index], value_in_words(sweep.points.front().parameter, along),
                                  value_in_words(sweep.points.back().parameter, along), answer(0),
                                  answer(sweep.points.size() / 2), answer(sweep.points.size() - 1),
                                  sweep.scatter > 0 ? value_in_words(sweep.scatter, dimension) : "none",
                                  course_in_words(sweep, dimension, along)});
            if (sweep.course != SweepCourse::too_few_answers) {
                entry["scatter"] = json_of(sweep.scatter, dimension);
                entry["main"] = json_of(sweep.main, dimension, along);
                entry["reversal"] = sweep.reversal.change != 0 ? json_of(sweep.reversal, dimension, along) : Json();
            }
            for (const SweepPoint& point : sweep.points) {
                const Cell value = point.answer.valid() ? Cell(in_display_unit(point.answer.value, dimension))
                                                        : Cell(answer_in_words(point.answer, dimension));
                csv.add_row({result.quantity, unit, subject.names[index], std::string(display_unit(along).symbol),
                             in_display_unit(point.parameter, along), value});
            }
        }
        sheet.add(std::move(table));
    }
    sheet.write("sweep.csv", csv.text());
}

void document_morris(const StudySubject& subject, const MorrisResult& result, const Sheet& sheet, Json& json) {
    const MorrisSettings& settings = *subject.study.morris;
    const double unit = display_unit(subject.quantity.dimension).si_per_unit;
    const double shown = shown_unit(subject.quantity.dimension).si_per_unit;
    sheet.add(Heading{"Screening by elementary effects (Morris)"});
    sheet.draw(morris_figure(subject.quantity, result, subject.names), "morris",
               "Mean absolute effect of a parameter's range, from its " + percent(settings.lower_probability) +
                   " to its " + percent(settings.upper_probability) +
                   " quantile, against the deviation of the effects, with 95 % intervals (bootstrap); " +
                   std::to_string(settings.trajectories) + " trajectories over " + std::to_string(settings.levels) +
                   " levels. Correlations play no part.");
    Table table{"Effects of the whole range (95 % interval)",
                {"parameter", "mean absolute"_number, "mean"_number, "standard deviation"_number, "effects"_number}};
    CsvTable csv({"parameter", subject.column("mean_absolute"), subject.column("mean_absolute_lower"),
                  subject.column("mean_absolute_upper"), subject.column("mean"), subject.column("standard_deviation"),
                  subject.column("standard_deviation_lower"), subject.column("standard_deviation_upper"), "effects"});
    for (std::size_t index = 0; index < subject.names.size(); ++index) {
        const MorrisEffect& effect = result.parameters[index];
        Json& entry = json["parameters"][subject.names[index]];
        entry["effects"] = effect.effects;
        if (effect.effects < 2) {
            table.rows.push_back({subject.names[index], "too few answers", "", "", std::to_string(effect.effects)});
            continue;
        }
        table.rows.push_back({subject.names[index], with_interval(effect.mean_absolute, shown),
                              number_in_words(effect.mean / shown), with_interval(effect.standard_deviation, shown),
                              std::to_string(effect.effects)});
        csv.add_row({subject.names[index], effect.mean_absolute.value / unit,
                     effect.mean_absolute.interval_95.lower / unit, effect.mean_absolute.interval_95.upper / unit,
                     effect.mean / unit, effect.standard_deviation.value / unit,
                     effect.standard_deviation.interval_95.lower / unit,
                     effect.standard_deviation.interval_95.upper / unit, static_cast<double>(effect.effects)});
        entry["mean_absolute"] = json_of(effect.mean_absolute, subject.quantity.dimension);
        entry["mean"] = json_number(effect.mean / unit);
        entry["standard_deviation"] = json_of(effect.standard_deviation, subject.quantity.dimension);
    }
    sheet.write("morris.csv", csv.text());
    json["evaluations"] = json_of(result.evaluations);
    sheet.add(std::move(table));
    sheet.add(Paragraph{evaluations_in_words(result.evaluations)});
}

void document_indices(const StudySubject& subject, const SobolIndicesResult& result, const Sheet& sheet, Json& json) {
    sheet.add(Heading{"Shares of the variance (Sobol indices)"});
    put<&SobolIndicesResult::status, &SobolIndicesResult::evaluations, &SobolIndicesResult::rows>(json, result);
    json["rows_left_out"] = result.rows_without;
    if (result.status != SobolIndicesStatus::found) {
        sheet.add(Notice{NoticeKind::warning,
                         "No indices",
                         {result.status == SobolIndicesStatus::no_variance
                              ? "the quantity is the same at every sample"
                              : "too few rows of samples have a value. " + evaluations_in_words(result.evaluations)}});
        return;
    }
    sheet.draw(sobol_indices_figure(subject.quantity, result, subject.names), "sobol_indices",
               "The share of the variance that would go if the parameter were known, and the share that would stay "
               "if all others were; the difference is interaction. " +
                   std::to_string(result.rows) +
                   " rows of a Sobol sequence, estimators of Saltelli et al. (2010) "
                   "and Jansen (1999), intervals by bootstrap.");
    Table table{"Sobol indices (95 % interval)", {"parameter", "first order"_number, "total"_number}};
    CsvTable csv({"parameter", "first", "first_lower", "first_upper", "total", "total_lower", "total_upper"});
    double sum = 0;
    for (std::size_t index = 0; index < subject.names.size(); ++index) {
        const auto& [first, total] = result.parameters[index];
        table.rows.push_back({subject.names[index], with_interval(first, 1), with_interval(total, 1)});
        csv.add_row({subject.names[index], first.value, first.interval_95.lower, first.interval_95.upper, total.value,
                     total.interval_95.lower, total.interval_95.upper});
        put<&SobolIndex::first, &SobolIndex::total>(json["parameters"][subject.names[index]], result.parameters[index]);
        sum += first.value;
    }
    table.rows.push_back({"sum", number_in_words(sum), ""});
    sheet.write("sobol_indices.csv", csv.text());
    sheet.add(std::move(table));
    if (result.rows_without > 0) {
        sheet.add(Notice{NoticeKind::warning,
                         "Rows left out",
                         {std::to_string(result.rows_without) + " of " + std::to_string(result.rows) +
                          " rows have an evaluation without a value and were left out: the indices are those of the "
                          "remaining part of the space, in which the parameters are no longer quite independent."}});
    }
    sheet.add(Paragraph{evaluations_in_words(result.evaluations)});
}

}  // namespace delabole
