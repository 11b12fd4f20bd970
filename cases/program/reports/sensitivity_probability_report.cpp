#include "cases/program/reader/units.hpp"
#include "cases/program/reports/sensitivity_parts.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

std::string method_in_words(const PropagationSettings& settings) {
    const PlanSize size = plan_size(settings);
    const std::string points = std::to_string(size.points);
    switch (settings.method) {
    case SamplingMethod::monte_carlo:
        return points + " independent samples (Monte Carlo)";
    case SamplingMethod::latin_hypercube:
        return std::to_string(size.replicates) + " independent Latin hypercubes of " + points + " samples";
    case SamplingMethod::sobol_sequence:
        return std::to_string(size.replicates) + " randomly shifted Sobol sequences of " + points + " samples";
    }
    return {};
}

std::string counted_as(const StudySubject& subject, const std::string& cause) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const Evaluation evaluation = cause == "infinite"         ? Evaluation{infinite, {}}
                                  : cause == "minus_infinite" ? Evaluation{-infinite, {}}
                                                              : Evaluation{0, cause};
    const bool decided = subject.criterion && subject.criterion->decided(evaluation);
    const std::string judged = !decided ? "neither" : subject.criterion->failed(evaluation) ? "failed" : "stands";
    const auto bound = std::ranges::find(subject.bounds, cause, &OutputBound::failure);
    return bound == subject.bounds.end() ? judged
                                         : judged + ": " + readable_range(bound->within, subject.quantity.dimension);
}

Table causes_table(const StudySubject& subject, const PropagationResult& result) {
    Table table{"Samples without a finite value, by cause", {"cause", "samples"_number, "share"_number, "counted as"}};
    for (const auto& [cause, number] : result.evaluations.failed_by_cause) {
        table.rows.push_back({cause, std::to_string(number),
                              percent(static_cast<double>(number) / static_cast<double>(result.samples)),
                              counted_as(subject, cause)});
    }
    return table;
}

void document_failure(const StudySubject& subject, const FailureProbability& failure, const PropagationResult& result,
                      Report& report, Json& json) {
    put<&FailureProbability::probability>(json, failure);
    if (failure.probability) {
        json["interval_by"] = word_of(failure.method);
    }
    put<&FailureProbability::failed, &FailureProbability::decided, &FailureProbability::least,
        &FailureProbability::greatest>(json, failure);
    std::string text = probability_in_words(failure) + ". " + std::to_string(failure.failed) +
                       (failure.failed == 1 ? " sample has failed." : " samples have failed.");
    if (failure.probability) {
        text += failure.method == ErrorMethod::wilson ? " Interval of Wilson for independent samples."
                                                      : " Interval from the spread of the replicates.";
    }
    for (const auto* words : {&subject.study.failure->failing_words, &subject.study.failure->standing_words}) {
        for (const std::string& word : *words) {
            const auto& causes = result.evaluations.failed_by_cause;
            const bool met =
                std::any_of(causes.begin(), causes.end(), [&](const auto& cause) { return cause.first == word; });
            text += met ? "" : " No sample gave the word " + word + ".";
        }
    }
    report.add(Paragraph{std::move(text)});
}

void write_distribution(const StudySubject& subject, const PropagationResult& result, const ResultFolder& folder) {
    CsvTable cumulative({subject.column(subject.quantity.name), "share_not_above"});
    for (const auto& [value, share] : result.cumulative) {
        cumulative.add_row({subject.shown(value), share});
    }
    folder.write("cumulative.csv", cumulative.text());
    CsvTable histogram({subject.column("lower"), subject.column("upper"), "samples"});
    for (const HistogramBin& bin : result.histogram) {
        histogram.add_row({subject.shown(bin.lower), subject.shown(bin.upper), static_cast<double>(bin.samples)});
    }
    folder.write("histogram.csv", histogram.text());
    CsvTable convergence({"samples", subject.column("mean"), subject.column("mean_lower"), subject.column("mean_upper"),
                          "probability_of_failure", "probability_lower", "probability_upper"});
    for (const ConvergenceStep& step : result.convergence) {
        std::vector<Cell> row{static_cast<double>(step.samples), subject.shown(step.mean.value),
                              subject.shown(step.mean.interval_95.lower), subject.shown(step.mean.interval_95.upper)};
        if (step.probability) {
            row.insert(row.end(), {step.probability->value, step.probability->interval_95.lower,
                                   step.probability->interval_95.upper});
        } else {
            row.insert(row.end(), 3, std::string());
        }
        convergence.add_row(row);
    }
    folder.write("convergence.csv", convergence.text());
}

}  // namespace

std::string probability_in_words(const FailureProbability& failure) {
    const std::string decided = std::to_string(failure.decided) + " of " + std::to_string(failure.samples);
    const std::string bounds =
        percent(failure.least) + " if the others all stood, " + percent(failure.greatest) + " if they had all failed";
    if (!failure.probability) {
        return "Probability of failure not known: only " + decided + " samples are decided; " + bounds;
    }
    const std::string probability = "Probability of failure " + percent(failure.probability->value) +
                                    " (95 % interval " + percent_range(failure.probability->interval_95) + ")";
    return failure.decided == failure.samples
               ? probability + " from " + std::to_string(failure.samples) + " samples"
               : probability + " from the " + decided + " samples that are decided; " + bounds;
}

void document_samples(const StudySubject& subject, const PropagationResult& result,
                      const std::optional<ReliabilityResult>& first_order, const Sheet& sheet, Json& json) {
    sheet.add(Heading{"Distribution of the " + human_name(subject.quantity.name)});
    sheet.add(Paragraph{method_in_words(*subject.study.propagation) + "."});
    json["status"] = word_of(result.status);
    json["method"] = word_of(subject.study.propagation->method);
    put<&PropagationResult::samples, &PropagationResult::with_value, &PropagationResult::evaluations>(json, result);
    if (result.failure) {
        document_failure(subject, *result.failure, result, sheet.report, json["failure"]);
    }
    if (!result.evaluations.failed_by_cause.empty()) {
        sheet.add(causes_table(subject, result));
    }
    if (result.with_value == 0) {
        sheet.add(Notice{NoticeKind::warning,
                         result.status == PropagationStatus::no_answer ? "No answer" : "No distribution",
                         {"no sample has a value"}});
        return;
    }
    const double shown = shown_unit(subject.quantity.dimension).si_per_unit;
    json[subject.column("mean")] = json_of(result.mean, subject.quantity.dimension);
    json[subject.column("standard_deviation")] = json_number(result.standard_deviation / subject.unit());
    json[subject.column("least")] = json_number(subject.shown(result.least));
    json[subject.column("greatest")] = json_number(subject.shown(result.greatest));
    Table table{"Of the samples with a value", {{"", false}, {human_name(subject.quantity.name), true}}};
    table.rows.push_back({"mean (95 % interval)", with_interval(result.mean, shown)});
    table.rows.push_back({"standard deviation", subject.in_words(result.standard_deviation)});
    table.rows.push_back({"least", subject.in_words(result.least)});
    for (const auto& [share, value] : result.quantiles) {
        table.rows.push_back({percent(share) + " quantile", subject.in_words(value)});
        json[subject.column("quantiles")].push_back(Json::array({share, json_number(subject.shown(value))}));
    }
    table.rows.push_back({"greatest", subject.in_words(result.greatest)});
    sheet.add(std::move(table));
    write_distribution(subject, result, sheet.folder);
    sheet.draw(histogram_figure(subject.quantity, result, subject.study.failure), "histogram",
               "Samples with a value; the outermost bars hold what lies beyond the middle 99.9 %.");
    sheet.draw(cumulative_figure(subject.quantity, result, subject.study.failure), "cumulative",
               "Share of the samples with a value not above each value.");
    std::optional<double> first_order_probability;
    if (first_order && first_order->status == ReliabilityStatus::converged) {
        first_order_probability = first_order->probability_of_failure;
    }
    sheet.draw(sampling_convergence_figure(subject.quantity, result, first_order_probability), "convergence",
               subject.study.propagation->method == SamplingMethod::latin_hypercube
                   ? "Estimates from a growing number of whole Latin hypercubes."
                   : "Estimates from the first samples, of every replicate where there are several.");
}

std::string reliability_in_words(const ReliabilityResult& result) {
    switch (result.status) {
    case ReliabilityStatus::converged:
        return "reliability index " + number_in_words(result.reliability_index) +
               ", first-order probability of failure " + percent(result.probability_of_failure);
    case ReliabilityStatus::not_converged:
        return "the search for the design point did not converge: the reliability index is near " +
               number_in_words(result.reliability_index) + ", if the limit surface is smooth there";
    case ReliabilityStatus::limit_not_reached:
        return result.medians_fail ? "the medians fail, and no combination of parameters within 8 standard deviations "
                                     "was found that does not"
                                   : "no combination of parameters within 8 standard deviations was found to fail";
    case ReliabilityStatus::no_answer_at_medians:
        return "the quantity has no value at the medians of the parameters: there is nowhere to start from";
    case ReliabilityStatus::interrupted:
        return "the search for the design point was interrupted";
    }
    return {};
}

void document_reliability(const StudySubject& subject, const ReliabilityResult& result, const Sheet& sheet,
                          Json& json) {
    sheet.add(Heading{"First-order reliability"});
    std::string text = capitalised(reliability_in_words(result));
    text += ". " + std::to_string(result.converged_starts) + " of " + std::to_string(result.starts) +
            " starts converged, to " + std::to_string(result.points.size()) +
            (result.points.size() == 1 ? " point" : " distinct points") + " of the limit surface. " +
            evaluations_in_words(result.evaluations);
    sheet.add(Paragraph{std::move(text)});
    put<&ReliabilityResult::status, &ReliabilityResult::starts, &ReliabilityResult::converged_starts,
        &ReliabilityResult::evaluations>(json, result);
    if (result.points.empty()) {
        return;
    }
    put<&ReliabilityResult::reliability_index, &ReliabilityResult::probability_of_failure>(json, result);
    const DesignPoint& nearest = result.points.front();
    Table table{result.medians_fail ? "Design point: the likeliest way to stand, since the median fails"
                                    : "Design point: the likeliest way to fail",
                {"parameter", "design point"_number, "standard deviations from the median"_number, "alpha"_number,
                 "importance"_number}};
    CsvTable csv(
        {"point", "reliability_index", "parameter", "value", "unit", "standard_normal", "alpha", "importance"});
    for (std::size_t number = 0; number < result.points.size(); ++number) {
        const DesignPoint& point = result.points[number];
        Json entry;
        put<&DesignPoint::reliability_index, &DesignPoint::converged>(entry, point);
        entry["starts"] = point.hits;
        for (std::size_t index = 0; index < subject.names.size(); ++index) {
            const Dimension dimension = subject.dimensions[index];
            const double value = in_display_unit(point.parameters[index], dimension);
            csv.add_row({static_cast<double>(number + 1), point.reliability_index, subject.names[index], value,
                         std::string(display_unit(dimension).symbol), point.standard_normal[index], point.alpha[index],
                         point.importance[index]});
            entry["parameters"][column_name(subject.names[index], dimension)] = {
                {"value", json_number(value)}, {"alpha", point.alpha[index]}, {"importance", point.importance[index]}};
        }
        json["design_points"].push_back(std::move(entry));
    }
    for (std::size_t index = 0; index < subject.names.size(); ++index) {
        const double z = normal_quantile(subject.space.marginal(index).probability(nearest.parameters[index]).below);
        table.rows.push_back({subject.names[index],
                              value_in_words(nearest.parameters[index], subject.dimensions[index]),
                              std::isfinite(z) ? number_in_words(z) : "at its end",
                              number_in_words(nearest.alpha[index]), number_in_words(nearest.importance[index])});
    }
    sheet.write("design_points.csv", csv.text());
    sheet.add(std::move(table));
    sheet.add(
        Paragraph{"A negative importance: the parameter falls on the way to failure. Squares of the importances add up "
                  "to 1. The first-order probability takes the limit surface for flat; the samples do not."});
}

}  // namespace delabole
