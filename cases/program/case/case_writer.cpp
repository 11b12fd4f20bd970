#include "cases/program/case/case_writer.hpp"

#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/described_writer.hpp"
#include "numerics/fnv_1a.hpp"

#include <algorithm>
#include <array>

namespace delabole {
namespace {

std::string written(const WrittenValue& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        return written_quantity(*number, Dimension::ratio);
    }
    return in_quotes(std::get<std::string>(value));
}

void write_list(std::string& text, std::string_view key, const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) {
        list += (list.empty() ? "" : ", ") + in_quotes(word);
    }
    write_line(text, key, "[" + list + "]");
}

void write_expectation(std::string& text, const Expectation& expectation, const CaseModel& model) {
    text += "\n[[expect]]\n";
    write_text(text, "label", expectation.label);
    write_line(text, "quantity", in_quotes(expectation.quantity));
    write_line(text, "value", written(expectation.value));
    if (expectation.tolerance) {
        write_line(text, "tolerance", written(*expectation.tolerance));
    }
    if (expectation.relative_tolerance) {
        write_line(text, "relative_tolerance", written_quantity(*expectation.relative_tolerance, Dimension::ratio));
    }
    write_conditions(text, expectation.conditions, {named_inputs(model)});
    write_text(text, "source", expectation.source);
    write_text(text, "note", expectation.note);
    if (expectation.unreachable) {
        write_line(text, "unreachable", in_quotes(*expectation.unreachable));
    }
}

void write_parameter(std::string& text, const FreeParameter& parameter, const std::vector<Quantity>& inputs) {
    const Quantity* input = find_quantity(inputs, parameter.name);
    const Dimension dimension = input == nullptr ? Dimension::ratio : input->dimension;
    text += "\n[[fit.mechanism.parameter]]\n";
    write_line(text, "name", in_quotes(parameter.name));
    write_line(text, "lower", written_quantity(parameter.lower, dimension));
    write_line(text, "upper", written_quantity(parameter.upper, dimension));
    if (parameter.prior) {
        std::string prior =
            "{ mean = " + written_quantity(parameter.prior->mean, dimension) +
            ", standard_deviation = " + written_quantity(parameter.prior->standard_deviation, dimension);
        prior += parameter.prior->source.empty() ? " }" : ", source = " + in_quotes(parameter.prior->source) + " }";
        write_line(text, "prior", prior);
    }
    if (!parameter.also.empty()) {
        write_list(text, "also", parameter.also);
    }
}

void write_observation(std::string& text, std::string_view table, const CaseObservation& observation,
                       const std::vector<std::vector<Quantity>>& inputs) {
    const QuantityObservation& values = observation.observation;
    text += "\n[[" + std::string(table) + "]]\n";
    write_line(text, "label", in_quotes(values.label));
    write_line(text, "quantity", in_quotes(values.quantity));
    write_line(text, "relation", in_quotes(word_of(values.relation)));
    write_line(text, "value", written_quantity(values.value, observation.dimension));
    write_line(text, "standard_deviation", written_quantity(values.standard_deviation, observation.dimension));
    write_conditions(text, values.conditions, inputs);
    write_text(text, "source", values.source);
}

void write_sign(std::string& text, const CaseSign& sign) {
    text += "\n[[fit.mechanism.shows]]\n";
    write_line(text, "evidence", in_quotes(sign.sign.evidence));
    write_line(text, "quantity", in_quotes(sign.sign.quantity));
    write_line(text, "relation", in_quotes(word_of(sign.sign.relation)));
    write_line(text, "value", written_quantity(sign.sign.value, sign.dimension));
}

void write_coarse(std::string& text, const FitMechanism& mechanism) {
    if (!mechanism.coarse) {
        return;
    }
    text += "\n[fit.mechanism.coarse]\n";
    std::string sections;
    std::visit(
        [&](const auto& model) {
            const auto& base = std::get<std::remove_cvref_t<decltype(model)>>(mechanism.model);
            write_differences(text, sections, base, model, "fit.mechanism.coarse");
        },
        *mechanism.coarse);
    text += sections;
}

void write_mechanism(std::string& text, const FitMechanism& mechanism, const CaseModel& base) {
    text += "\n[[fit.mechanism]]\n";
    write_line(text, "name", in_quotes(mechanism.name));
    write_line(text, "title", in_quotes(mechanism.title));
    std::string sections;
    std::visit(
        [&](const auto& model) {
            if (const auto* base_model = std::get_if<std::remove_cvref_t<decltype(model)>>(&base)) {
                write_differences(text, sections, *base_model, model, "fit.mechanism");
            } else {
                write_line(text, "model", in_quotes(model_name(mechanism.model)));
                write_values(text, model);
                write_sections(sections, model, "fit.mechanism");
            }
        },
        mechanism.model);
    text += sections;
    write_coarse(text, mechanism);
    const std::vector<Quantity> inputs = named_inputs(mechanism.model);
    for (const FreeParameter& parameter : mechanism.parameters) {
        write_parameter(text, parameter, inputs);
    }
    for (const CaseObservation& observation : mechanism.observations) {
        write_observation(text, "fit.mechanism.observation", observation, {inputs});
    }
    for (const CaseSign& sign : mechanism.signs) {
        write_sign(text, sign);
    }
}

void write_settings(std::string& text, const FitSettings& settings) {
    text += "\n[fit]\n";
    write_line(text, "algorithm", in_quotes(word_of(settings.algorithm)));
    write_line(text, "starts", std::to_string(settings.starts));
    write_line(text, "evaluations_per_start", std::to_string(settings.evaluations_per_start));
    write_line(text, "relative_tolerance", written_quantity(settings.relative_tolerance, Dimension::ratio));
    write_line(text, "profile_points", std::to_string(settings.profile_points));
    write_line(text, "map_points", std::to_string(settings.map_points));
    write_line(text, "seed", std::to_string(settings.seed));
    text += "\n[fit.surrogate]\n";
    write_line(text, "runs", std::to_string(settings.surrogate.runs));
    if (settings.surrogate.first_runs) {
        write_line(text, "first_runs", std::to_string(*settings.surrogate.first_runs));
    }
    write_line(text, "tolerance", written_quantity(settings.surrogate.tolerance, Dimension::ratio));
    write_line(text, "give_up_below", written_quantity(settings.surrogate.give_up_below, Dimension::ratio));
}

void write_posterior(std::string& text, const PosteriorStudy& study) {
    text += "\n[fit.posterior]\n";
    write_line(text, "chains", std::to_string(study.chains));
    write_line(text, "draws", std::to_string(study.draws));
    write_line(text, "evaluations_per_chain", std::to_string(study.evaluations_per_chain));
    write_line(text, "evidence_points", std::to_string(study.evidence_points));
}

void write_profile(std::string& text, const ProfileObservation& profile) {
    text += "\n[fit.profile]\npoints = [\n";
    for (const Point& point : profile.profile) {
        text += "    [" + written_quantity(point.x(), Dimension::length) + ", " +
                written_quantity(point.y(), Dimension::length) + "],\n";
    }
    text += "]\n";
    write_line(text, "standard_deviation", written_quantity(profile.standard_deviation, Dimension::length));
    write_text(text, "source", profile.source);
}

void write_candidate(std::string& text, const CaseCandidate& candidate,
                     const std::vector<std::vector<Quantity>>& inputs) {
    const FitCandidate& values = candidate.candidate;
    text += "\n[[fit.candidate]]\n";
    write_line(text, "label", in_quotes(values.label));
    write_list(text, "quantity", values.quantities);
    write_line(text, "standard_deviation", written_quantity(values.standard_deviation, candidate.dimension));
    write_conditions(text, values.conditions, inputs);
    if (values.cost) {
        write_line(text, "cost", written_quantity(*values.cost, Dimension::ratio));
    }
    write_text(text, "source", values.source);
}

void write_test(std::string& text, const ConclusionTest& test, const std::vector<std::vector<Quantity>>& inputs) {
    text += "\n[[fit.conclusion.test]]\n";
    write_line(text, "claim", in_quotes(test.claim));
    if (const auto* claim = std::get_if<ClaimOfMechanisms>(&test.of)) {
        write_list(text, "probability_of", claim->mechanisms);
    } else {
        const auto& of = std::get<ClaimOfQuantity>(test.of);
        write_line(text, "mechanism", in_quotes(of.mechanism));
        write_line(text, "quantity", in_quotes(of.quantity));
        write_conditions(text, of.conditions, inputs);
        if (of.against && of.against->empty()) {
            write_line(text, "compared_with", "{}");
        } else if (of.against) {
            write_conditions(text, *of.against, inputs, "compared_with");
        }
    }
    write_line(text, "relation", in_quotes(word_of(test.relation)));
    write_line(text, "value", written_quantity(test.limit, test.dimension));
}

void write_conclusion(std::string& text, const Conclusion& conclusion,
                      const std::vector<std::vector<Quantity>>& inputs) {
    text += "\n[[fit.conclusion]]\n";
    write_line(text, "label", in_quotes(conclusion.label));
    write_line(text, "statement", in_quotes(conclusion.statement));
    write_text(text, "source", conclusion.source);
    write_text(text, "note", conclusion.note);
    for (const ConclusionTest& test : conclusion.tests) {
        write_test(text, test, inputs);
    }
}

void write_fit(std::string& text, const CaseFit& fit, const CaseModel& base) {
    write_settings(text, fit.settings);
    if (fit.posterior) {
        write_posterior(text, *fit.posterior);
    }
    std::vector<std::vector<Quantity>> inputs;
    for (const FitMechanism& mechanism : fit.mechanisms) {
        inputs.push_back(named_inputs(mechanism.model));
        write_mechanism(text, mechanism, base);
    }
    for (const CaseObservation& observation : fit.observations) {
        write_observation(text, "fit.observation", observation, inputs);
    }
    if (fit.profile) {
        write_profile(text, *fit.profile);
    }
    for (const FieldEvidence& evidence : fit.evidence) {
        text += "\n[[fit.evidence]]\n";
        write_line(text, "name", in_quotes(evidence.name));
        write_line(text, "statement", in_quotes(evidence.statement));
        write_text(text, "source", evidence.source);
    }
    for (const CaseCandidate& candidate : fit.candidates) {
        write_candidate(text, candidate, inputs);
    }
    for (const Conclusion& conclusion : fit.conclusions) {
        write_conclusion(text, conclusion, inputs);
    }
}

void write_uncertain(std::string& text, const UncertainParameter& parameter, const std::vector<Quantity>& inputs) {
    const Quantity* input = find_quantity(inputs, parameter.name);
    const Dimension dimension = input == nullptr ? Dimension::ratio : input->dimension;
    text += "\n[[sensitivity.parameter]]\n";
    write_line(text, "name", in_quotes(parameter.name));
    const Distribution& distribution = parameter.distribution;
    std::visit(
        [&](const auto& law) {
            write_line(text, "distribution", in_quotes(std::remove_cvref_t<decltype(law)>::kind));
            visit_fields(law, [&](const FieldInfo& info, double value) {
                write_line(text, info.key, written_quantity(value, dimension));
            });
        },
        distribution.law);
    if (distribution.lower) {
        write_line(text, "lower", written_quantity(*distribution.lower, dimension));
    }
    if (distribution.upper) {
        write_line(text, "upper", written_quantity(*distribution.upper, dimension));
    }
    if (!parameter.also.empty()) {
        write_list(text, "also", parameter.also);
    }
    write_text(text, "source", parameter.source);
}

void write_ratio(std::string& text, std::string_view key, double value) {
    write_line(text, key, written_quantity(value, Dimension::ratio));
}

void write_failure(std::string& text, const FailureCriterion& failure, Dimension dimension) {
    text += "\n[sensitivity.failure]\n";
    write_line(text, "limit", written_quantity(failure.limit, dimension));
    write_line(text, "side", in_quotes(word_of(failure.side)));
    for (const auto& [key, words] :
         {std::pair{"failing_words", &failure.failing_words}, std::pair{"standing_words", &failure.standing_words}}) {
        std::string list;
        for (const std::string& word : *words) {
            list += (list.empty() ? "" : ", ") + in_quotes(word);
        }
        if (!list.empty()) {
            write_line(text, key, "[" + list + "]");
        }
    }
}

void write_sensitivity_sweep(std::string& text, const SweepSettings& sweep, Dimension dimension) {
    text += "\n[sensitivity.sweep]\n";
    write_line(text, "points", std::to_string(sweep.points));
    write_ratio(text, "lower_probability", sweep.lower_probability);
    write_ratio(text, "upper_probability", sweep.upper_probability);
    write_line(text, "samples", std::to_string(sweep.samples));
    write_line(text, "scatter", written_quantity(sweep.scatter, dimension));
    for (const SweptQuantity& further : sweep.further) {
        text += "\n[[sensitivity.sweep.quantity]]\n";
        write_line(text, "name", in_quotes(further.name));
        write_line(text, "scatter", written_quantity(further.scatter, further.dimension));
    }
}

void write_methods(std::string& text, const SensitivityStudy& study, Dimension dimension) {
    if (study.tornado) {
        text += "\n[sensitivity.tornado]\n";
        write_ratio(text, "lower_probability", study.tornado->lower_probability);
        write_ratio(text, "upper_probability", study.tornado->upper_probability);
    }
    if (study.sweep) {
        write_sensitivity_sweep(text, *study.sweep, dimension);
    }
    if (study.morris) {
        text += "\n[sensitivity.morris]\n";
        write_line(text, "trajectories", std::to_string(study.morris->trajectories));
        write_line(text, "levels", std::to_string(study.morris->levels));
        write_ratio(text, "lower_probability", study.morris->lower_probability);
        write_ratio(text, "upper_probability", study.morris->upper_probability);
    }
    if (study.sobol_indices) {
        text += "\n[sensitivity.sobol_indices]\n";
        write_line(text, "samples", std::to_string(study.sobol_indices->samples));
        write_line(text, "bootstrap", std::to_string(study.sobol_indices->bootstrap));
    }
    if (study.propagation) {
        text += "\n[sensitivity.propagation]\n";
        write_line(text, "method", in_quotes(word_of(study.propagation->method)));
        write_line(text, "samples", std::to_string(study.propagation->samples));
        write_line(text, "replicates", std::to_string(study.propagation->replicates));
    }
    if (study.reliability) {
        text += "\n[sensitivity.reliability]\n";
        write_line(text, "starts", std::to_string(study.reliability->starts));
        write_ratio(text, "step", study.reliability->step);
        write_ratio(text, "tolerance", study.reliability->tolerance);
    }
}

void write_sensitivity(std::string& text, const CaseSensitivity& sensitivity, const CaseModel& model) {
    const SensitivityStudy& study = sensitivity.study;
    text += "\n[sensitivity]\n";
    write_line(text, "quantity", in_quotes(study.quantity));
    write_line(text, "seed", std::to_string(study.seed));
    const std::vector<Quantity> inputs = named_inputs(model);
    for (const UncertainParameter& parameter : study.parameters) {
        write_uncertain(text, parameter, inputs);
    }
    for (const ParameterCorrelation& correlation : study.correlations) {
        text += "\n[[sensitivity.correlation]]\n";
        write_line(text, "between", "[" + in_quotes(correlation.first) + ", " + in_quotes(correlation.second) + "]");
        write_ratio(text, "coefficient", correlation.coefficient);
        write_line(text, "measure", in_quotes(word_of(correlation.measure)));
    }
    if (study.failure) {
        write_failure(text, *study.failure, sensitivity.dimension);
    }
    write_methods(text, study, sensitivity.dimension);
}

std::size_t characters_in(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U; }));
}

}  // namespace

void write_text(std::string& text, std::string_view key, const std::string& value) {
    if (!value.empty()) {
        write_line(text, key, in_quotes(value));
    }
}

void write_conditions(std::string& text, const std::vector<Condition>& conditions,
                      const std::vector<std::vector<Quantity>>& inputs, std::string_view key) {
    if (conditions.empty()) {
        return;
    }
    std::string table;
    for (const Condition& condition : conditions) {
        const Quantity* input = nullptr;
        for (const std::vector<Quantity>& of_model : inputs) {
            input = input != nullptr ? input : find_quantity(of_model, condition.input);
        }
        const Dimension dimension = input == nullptr ? Dimension::ratio : input->dimension;
        table += (table.empty() ? "" : ", ") + in_quotes(condition.input) + " = " +
                 written_quantity(condition.value, dimension);
    }
    write_line(text, key, "{ " + table + " }");
}

std::string resolved_model(const CaseModel& model) {
    std::string text;
    write_line(text, "model", in_quotes(model_name(model)));
    std::visit(
        [&](const auto& parameters) {
            write_values(text, parameters);
            write_sections(text, parameters, "");
        },
        model);
    return text;
}

std::string resolved_toml(const CaseFile& case_file) {
    std::string text = "schema = 1\n";
    write_text(text, "title", case_file.title);
    write_text(text, "description", case_file.description);
    text += resolved_model(case_file.model);
    if (!case_file.sources.empty()) {
        text += "\n[sources]\n";
        for (const auto& [key, source] : case_file.sources) {
            write_line(text, in_quotes(key), in_quotes(source));
        }
    }
    for (const Expectation& expectation : case_file.expectations) {
        write_expectation(text, expectation, case_file.model);
    }
    for (const CaseSweep& sweep : case_file.sweeps) {
        write_sweep(text, sweep, case_file.model);
    }
    if (case_file.fit) {
        write_fit(text, *case_file.fit, case_file.model);
    }
    if (case_file.sensitivity) {
        write_sensitivity(text, *case_file.sensitivity, case_file.model);
    }
    return text;
}

std::string case_hash(const CaseFile& case_file) {
    std::uint64_t hash = fnv_1a(resolved_toml(case_file));
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text(16, '0');
    for (auto digit = text.rbegin(); digit != text.rend(); ++digit, hash >>= 4U) {
        *digit = digits[hash & 0xFU];
    }
    return text;
}

std::string aligned_columns(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t column = 0; column < row.size(); ++column) {
            widths[column] = std::max(widths[column], characters_in(row[column]));
        }
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t column = 0; column < row.size(); ++column) {
            line += row[column] + std::string(widths[column] - characters_in(row[column]) + 2, ' ');
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string described_inputs(const CaseFile& case_file) {
    std::vector<std::vector<std::string>> rows{{"input", "value", "allowed", "meaning", "source"}};
    for (const Quantity& input : named_inputs(case_file.model)) {
        const auto source = case_file.sources.find(input.name);
        const std::string range = readable_range(input.range, input.dimension);
        rows.push_back({input.name, readable_quantity(input.value, input.dimension), range.empty() ? "any" : range,
                        input.meaning, source == case_file.sources.end() ? "" : source->second});
    }
    return aligned_columns(rows);
}

}  // namespace delabole
