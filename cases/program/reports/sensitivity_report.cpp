#include "cases/program/reports/study_reports.hpp"

#include "cases/program/reports/sensitivity_parts.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <iterator>

namespace delabole {

namespace {

std::string law_in_words(const Distribution& distribution, Dimension dimension) {
    std::string text = std::visit([](const auto& law) { return std::string(law.kind); }, distribution.law);
    std::visit(
        [&](const auto& law) {
            visit_fields(law, [&](const FieldInfo& info, double value) {
                text += ", " + human_name(info.key) + " " + value_in_words(value, dimension);
            });
        },
        distribution.law);
    if (distribution.lower) {
        text += ", cut off below " + value_in_words(*distribution.lower, dimension);
    }
    if (distribution.upper) {
        text += ", cut off above " + value_in_words(*distribution.upper, dimension);
    }
    return text;
}

void document_parameters(const StudySubject& subject, Report& report) {
    Table table{"Uncertain parameters",
                {"parameter", "distribution", "mean"_number, "standard deviation"_number, "source"}};
    for (std::size_t index = 0; index < subject.names.size(); ++index) {
        const UncertainParameter& parameter = subject.study.parameters[index];
        const Dimension dimension = subject.dimensions[index];
        table.rows.push_back({parameter.name, law_in_words(parameter.distribution, dimension),
                              value_in_words(subject.space.marginal(index).mean(), dimension),
                              value_in_words(subject.space.marginal(index).standard_deviation(), dimension),
                              parameter.source});
    }
    report.add(std::move(table));
    if (subject.study.correlations.empty()) {
        return;
    }
    Table correlations{"Correlations: Gaussian copula",
                       {"between", "measure", "given"_number, "of the standard normal numbers"_number}};
    for (const ParameterCorrelation& correlation : subject.study.correlations) {
        const auto place = [&](const std::string& name) {
            return std::find(subject.names.begin(), subject.names.end(), name) - subject.names.begin();
        };
        correlations.rows.push_back(
            {correlation.pair[0] + " and " + correlation.pair[1],
             correlation.measure == CorrelationMeasure::linear ? "linear (Pearson)" : "rank (Spearman)",
             number_in_words(correlation.coefficient),
             number_in_words(
                 subject.space.normal_correlations()(place(correlation.pair[0]), place(correlation.pair[1])))});
    }
    report.add(std::move(correlations));
}

std::vector<std::string> findings(const StudySubject& subject, const SensitivityResult& result) {
    std::vector<std::string> sentences;
    if (result.propagation && result.propagation->with_value > 0) {
        const PropagationResult& samples = *result.propagation;
        sentences.push_back("Mean " + human_name(subject.quantity.name) + " " + subject.in_words(samples.mean.value) +
                            ", standard deviation " + subject.in_words(samples.standard_deviation) +
                            (samples.with_value < samples.samples
                                 ? ", of the " + std::to_string(samples.with_value) + " of " +
                                       std::to_string(samples.samples) + " samples that have a finite value."
                                 : "."));
    }
    if (result.propagation && result.propagation->failure) {
        sentences.push_back(probability_in_words(*result.propagation->failure) + ".");
    }
    if (result.reliability) {
        sentences.push_back("First order: " + reliability_in_words(*result.reliability) + ".");
    }
    if (result.sobol_indices && result.sobol_indices->status == SobolIndicesStatus::found) {
        const auto& indices = result.sobol_indices->parameters;
        const auto most = std::ranges::max_element(indices, {}, [](const SobolIndex& one) { return one.total.value; });
        const SobolIndicesResult& found = *result.sobol_indices;
        sentences.push_back(
            subject.names[static_cast<std::size_t>(most - indices.begin())] + " matters most: it has a part in " +
            percent(std::min(most->total.value, 1.0)) + " of the variance" +
            (found.rows_without > 0
                 ? ", but " + std::to_string(found.rows_without) + " of the " + std::to_string(found.rows) +
                       " rows of samples have an evaluation without a value and were left out: the "
                       "shares are those of the part of the space that has values."
                 : "."));
    }
    for (std::string& sentence : sweep_findings(subject, result.sweeps)) {
        sentences.push_back(std::move(sentence));
    }
    std::vector<std::string> idle;
    for (const std::size_t index : result.without_effect) {
        idle.push_back(subject.names[index]);
    }
    if (!idle.empty()) {
        sentences.push_back("No change of " + list_in_words(idle) + " alone was seen to change the " +
                            human_name(subject.quantity.name) + ".");
    }
    return sentences;
}

}  // namespace

StudySubject::StudySubject(const SensitivityProblem& problem)
    : study(problem.study),
      quantity{study.quantity, study.dimension},
      space(input_space(study)),
      criterion(criterion_of(problem)) {
    std::ranges::copy_if(problem.model.bounds, std::back_inserter(bounds), [&](const OutputBound& bound) {
        return problem.model.outputs[bound.output].name == study.quantity;
    });
    for (const UncertainParameter& parameter : study.parameters) {
        names.push_back(parameter.name);
        dimensions.push_back(find_quantity(problem.model.inputs, parameter.name)->dimension);
    }
    swept.push_back(quantity.dimension);
    if (study.sweep) {
        std::ranges::transform(study.sweep->further, std::back_inserter(swept), &SweptQuantity::dimension);
    }
}

std::string StudySubject::in_words(double value) const {
    return value_in_words(value, quantity.dimension);
}

std::string percent(double share) {
    return number_in_words(100 * share) + " %";
}

std::string percent_range(const Interval& interval) {
    return number_in_words(100 * interval.lower) + " to " + percent(interval.upper);
}

std::string with_interval(const Estimate& estimate, double unit) {
    return number_in_words(estimate.value / unit) + " (" + number_in_words(estimate.interval_95.lower / unit) + " to " +
           number_in_words(estimate.interval_95.upper / unit) + ")";
}

Json json_of(const Estimate& estimate, Dimension dimension) {
    const double unit = display_unit(dimension).si_per_unit;
    Json json;
    json["value"] = json_number(estimate.value / unit);
    json["interval_95"] =
        Json::array({json_number(estimate.interval_95.lower / unit), json_number(estimate.interval_95.upper / unit)});
    return json;
}

Json json_of(const EvaluationCount& count) {
    Json json;
    json["total"] = count.total;
    json["without_answer"] = Json::object();
    for (const auto& [cause, number] : count.failed_by_cause) {
        json["without_answer"][cause] = number;
    }
    return json;
}

std::string evaluations_in_words(const EvaluationCount& count) {
    std::string text = std::to_string(count.total) + " evaluations of the model";
    for (const auto& [cause, number] : count.failed_by_cause) {
        text += ", " + std::to_string(number) + " without a value (" + cause + ")";
    }
    return text + ".";
}

StudyDocuments document_sensitivity(const CaseFile& file, const SensitivityProblem& problem,
                                    const SensitivityResult& result, const Sheet& sheet) {
    const StudySubject subject(problem);
    StudyDocuments documents;
    Json& json = documents.json;
    json["title"] = file.title;
    json["model"] = std::string(model_name(file.model));
    json["quantity"] = subject.column(subject.quantity.name);
    const std::vector<std::string> sentences = findings(subject, result);
    json["findings"] = sentences;
    json["without_effect"] = Json::array();
    for (const std::size_t index : result.without_effect) {
        json["without_effect"].push_back(subject.names[index]);
    }
    json["not_monotone"] = Json::array();
    for (const SweepResult& sweep : result.sweeps) {
        for (std::size_t index = 0; index < subject.names.size(); ++index) {
            if (sweep.parameters[index].course == SweepCourse::not_monotone) {
                json["not_monotone"].push_back({{"quantity", sweep.quantity}, {"parameter", subject.names[index]}});
            }
        }
    }
    Report details;
    const Sheet detailed{sheet.folder, details};
    if (result.propagation) {
        document_samples(subject, *result.propagation, result.reliability, detailed, json["propagation"]);
    }
    if (result.reliability) {
        document_reliability(subject, *result.reliability, detailed, json["reliability"]);
    }
    if (result.tornado) {
        document_tornado(subject, *result.tornado, detailed, json["tornado"]);
    }
    if (!result.sweeps.empty()) {
        document_sweeps(subject, result.sweeps, detailed, json["sweep"]);
    }
    if (result.morris) {
        document_morris(subject, *result.morris, detailed, json["morris"]);
    }
    if (result.sobol_indices) {
        document_indices(subject, *result.sobol_indices, detailed, json["sobol_indices"]);
    }
    constexpr std::size_t most = 3;
    HeadCard head{AnswerTone::open, sentences, {}};
    std::stable_partition(head.sentences.begin(), head.sentences.end(),
                          [](const std::string& sentence) { return sentence.starts_with("Probability of failure"); });
    if (sentences.size() > most) {
        details.add(Heading{"Further findings"});
        details.add(BulletList{{head.sentences.begin() + most, head.sentences.end()}});
        head.sentences.resize(most);
    }
    take_picture(details.blocks, head);
    sheet.report.blocks.insert(sheet.report.blocks.begin(), std::move(head));
    std::ranges::move(details.blocks, std::back_inserter(sheet.report.blocks));
    sheet.add(Heading{"Uncertain parameters"});
    document_parameters(subject, sheet.report);
    for (const std::string& sentence : sentences) {
        documents.screen += sentence + "\n";
    }
    return documents;
}

}  // namespace delabole
