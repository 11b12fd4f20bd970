// [sensitivity]: what is uncertain and how, which quantity is studied, what is computed.
#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/described_reader.hpp"
#include "cases/program/reader/spelling.hpp"

#include <algorithm>
#include <limits>

namespace delabole {
namespace {

void read_count(Section& section, std::string_view key, std::int64_t lower, std::int64_t upper, auto& value) {
    auto wide = static_cast<std::int64_t>(value);
    read_integer(section, key, lower, upper, wide);
    value = static_cast<std::remove_reference_t<decltype(value)>>(wide);
}

void read_ratio(Section& section, std::string_view key, const Interval& range, double& value) {
    if (const Node* node = section.take(key)) {
        value = read_number(section.reading(), *node, section.path_of(key), Dimension::ratio, range).value_or(value);
    }
}

template <class Enum>
void read_word(Section& section, std::string_view key, Enum& value) {
    if (const Node* node = section.take(key)) {
        const auto index = read_choice(section.reading(), *node, section.path_of(key), detail::enum_words<Enum>());
        value = index ? static_cast<Enum>(*index) : value;
    }
}

// The keys of a law stand in the section of its parameter, in the parameter's dimension.
template <class Chosen>
Chosen read_law(Section& section, const Quantity& input) {
    Chosen law{};
    visit_fields(law, [&](const FieldInfo& info, double& value) {
        const bool is_spread = info.key == "standard_deviation";
        value = read_number(section, info.key, input.dimension, is_spread ? more_than(0) : input.range, info.meaning)
                    .value_or(is_spread ? 1 : 0);
    });
    return law;
}

std::optional<double> read_truncation(Section& section, std::string_view key, const Quantity& input) {
    const Node* node = section.take(key);
    return node == nullptr ? std::nullopt
                           : read_number(section.reading(), *node, section.path_of(key), input.dimension, input.range);
}

std::optional<Distribution> read_distribution(Section& section, const Quantity& input) {
    const std::vector<std::string> kinds = detail::kind_names<Law>();
    const Node* kind = section.require("distribution", choices(kinds));
    const auto chosen =
        kind == nullptr ? std::nullopt : read_choice(section.reading(), *kind, section.path_of("distribution"), kinds);
    if (!chosen) {
        for (const std::string_view key : {"mean", "standard_deviation", "lower", "mode", "upper"}) {
            section.allow(key);
        }
        return std::nullopt;
    }
    Distribution distribution{Normal{}};
    detail::for_each_alternative<Law>([&]<std::size_t index, class Alternative>() {
        if (*chosen == index) {
            distribution.law = read_law<Alternative>(section, input);
        }
    });
    if (!has_limits(distribution.law)) {
        distribution.lower = read_truncation(section, "lower", input);
        distribution.upper = read_truncation(section, "upper", input);
    }
    return distribution;
}

void read_parameter(Section& section, const ModelNames& names, std::vector<UncertainParameter>& parameters) {
    const std::string name = require_text(section, "name", "the input that is uncertain, e.g. strength.cohesion");
    const std::string source = read_optional_text(section, "source");
    const Quantity* input = find_quantity(names.inputs, name);
    if (input == nullptr) {
        for (const std::string_view key :
             {"distribution", "mean", "standard_deviation", "lower", "mode", "upper", "also"}) {
            section.allow(key);
        }
        if (!name.empty() && names.inputs_known) {
            section.complain("name", *section.peek("name"),
                             "is not an input of this case" + suggestion(name, names_in(names.inputs)));
        }
        return;
    }
    if (std::ranges::find(parameters, name, &UncertainParameter::name) != parameters.end()) {
        section.complain("name", *section.peek("name"), "is uncertain already: each input once");
    }
    const std::vector<std::string> others = read_others(section, *input, names);
    if (const auto distribution = read_distribution(section, *input)) {
        parameters.push_back({name, *distribution, source, others});
    }
}

void read_correlation(Section& section, const std::vector<UncertainParameter>& parameters,
                      std::vector<ParameterCorrelation>& correlations) {
    ParameterCorrelation correlation{};
    if (const Node* pair = section.require("between", "the names of two uncertain parameters, [\"a\", \"b\"]")) {
        const auto is_text = [](const Node& node) { return node.kind == Node::Kind::text; };
        if (pair->kind != Node::Kind::array || pair->elements.size() != 2 ||
            !std::ranges::all_of(pair->elements, is_text)) {
            section.complain("between", *pair, "must be the names of two uncertain parameters, [\"a\", \"b\"]");
        } else {
            std::vector<std::string> names;
            names.reserve(parameters.size());
            for (const UncertainParameter& parameter : parameters) {
                names.push_back(parameter.name);
            }
            for (const Node& node : pair->elements) {
                if (std::ranges::find(names, node.text) == names.end() && section.reading().clean()) {
                    section.complain("between", node,
                                     "is not among the uncertain parameters" + suggestion(node.text, names));
                }
            }
            correlation.first = pair->elements[0].text;
            correlation.second = pair->elements[1].text;
        }
    }
    correlation.coefficient =
        read_number(section, "coefficient", Dimension::ratio, between(-1, 1), "correlation coefficient").value_or(0);
    read_word(section, "measure", correlation.measure);
    correlations.push_back(std::move(correlation));
}

// A further output of the sweep, with its scatter.
void read_swept(Section& section, const ModelNames& names, std::vector<SweptQuantity>& swept) {
    SweptQuantity quantity;
    quantity.name = require_text(section, "name", "an output that is swept too, e.g. weight");
    const Quantity* output = find_quantity(names.outputs, quantity.name);
    if (output == nullptr) {
        section.allow("scatter");
        if (!quantity.name.empty()) {
            section.complain(
                "name", *section.peek("name"),
                "is not a number that this model answers" + suggestion(quantity.name, names_in(names.outputs)));
        }
        return;
    }
    quantity.dimension = output->dimension;
    if (const Node* node = section.take("scatter")) {
        quantity.scatter =
            read_number(section.reading(), *node, section.path_of("scatter"), output->dimension, at_least(0))
                .value_or(0);
    }
    swept.push_back(std::move(quantity));
}

// Calls read(section, settings) where the section is there.
template <class Settings, class Read>
void read_method(Section& study, std::string_view key, std::optional<Settings>& settings, Read&& read) {
    const Node* node = study.take(key);
    const Node* table = node == nullptr ? nullptr : as_table(study.reading(), *node, study.path_of(key));
    if (table == nullptr) {
        return;
    }
    Section section(study.reading(), *table, study.path_of(key));
    read(section, settings.emplace());
    section.finish();
}

void read_failure(Section& section, Dimension dimension, FailureCriterion& failure) {
    failure.limit =
        read_number(section, "limit", dimension, any_number(), "value of the quantity at which the slope fails")
            .value_or(0);
    read_word(section, "side", failure.side);
    read_words(section, "failing_words", failure.failing_words);
    read_words(section, "standing_words", failure.standing_words);
}

void read_quantiles(Section& section, double& lower, double& upper) {
    constexpr double middle = 0.5;
    read_ratio(section, "lower_probability", between(0, middle), lower);
    read_ratio(section, "upper_probability", between(middle, 1), upper);
}

void read_methods(Section& section, const ModelNames& names, Dimension dimension, SensitivityStudy& study) {
    constexpr std::int64_t most = 10'000'000;
    read_method(section, "failure", study.failure,
                [&](Section& part, FailureCriterion& failure) { read_failure(part, dimension, failure); });
    read_method(section, "tornado", study.tornado, [](Section& part, TornadoSettings& settings) {
        read_quantiles(part, settings.lower_probability, settings.upper_probability);
    });
    read_method(section, "sweep", study.sweep, [&](Section& part, SweepSettings& settings) {
        read_count(part, "points", 3, 19, settings.points);
        read_quantiles(part, settings.lower_probability, settings.upper_probability);
        read_count(part, "samples", 0, most, settings.samples);
        if (const Node* node = part.take("scatter")) {
            settings.scatter =
                read_number(part.reading(), *node, part.path_of("scatter"), dimension, at_least(0)).value_or(0);
        }
        for_each_table(part, "quantity", [&](Section& element) { read_swept(element, names, settings.further); });
    });
    read_method(section, "morris", study.morris, [&](Section& part, MorrisSettings& settings) {
        read_count(part, "trajectories", 2, most, settings.trajectories);
        read_count(part, "levels", 2, most, settings.levels);
        read_quantiles(part, settings.lower_probability, settings.upper_probability);
    });
    read_method(section, "sobol_indices", study.sobol_indices, [&](Section& part, SobolIndicesSettings& settings) {
        read_count(part, "samples", 1, most, settings.samples);
        read_count(part, "bootstrap", 1, most, settings.bootstrap);
    });
    read_method(section, "propagation", study.propagation, [&](Section& part, PropagationSettings& settings) {
        read_word(part, "method", settings.method);
        read_count(part, "samples", 2, most_samples, settings.samples);
        read_count(part, "replicates", 2, most, settings.replicates);
    });
    read_method(section, "reliability", study.reliability, [&](Section& part, ReliabilitySettings& settings) {
        read_count(part, "starts", 1, most, settings.starts);
        read_ratio(part, "step", more_than(0), settings.step);
        read_ratio(part, "tolerance", more_than(0), settings.tolerance);
    });
}

}  // namespace

CaseSensitivity read_sensitivity(Section& root, const CaseModel& model, const OutputsOf& outputs_of) {
    CaseSensitivity result;
    const Node* node = root.take("sensitivity");
    const Node* table = as_table(root.reading(), *node, "sensitivity");
    if (table == nullptr) {
        return result;
    }
    Section section(root.reading(), *table, "sensitivity");
    SensitivityStudy& study = result.study;
    const ModelNames names = names_of(model, outputs_of, root.reading().inputs_known());
    study.quantity = require_text(section, "quantity", "the output that is studied, e.g. factor_of_safety");
    if (const Quantity* output = find_quantity(names.outputs, study.quantity)) {
        result.dimension = output->dimension;
    } else if (!study.quantity.empty()) {
        section.complain(
            "quantity", *section.peek("quantity"),
            "is not a number that this model answers" + suggestion(study.quantity, names_in(names.outputs)));
    }
    auto seed = static_cast<std::int64_t>(study.seed);
    read_integer(section, "seed", 0, std::numeric_limits<std::int64_t>::max(), seed);
    study.seed = static_cast<std::uint64_t>(seed);
    for_each_table(section, "parameter", [&](Section& element) { read_parameter(element, names, study.parameters); });
    if (!section.contains("parameter")) {
        section.reading().complain(section.place(), "sensitivity", {},
                                   "has nothing uncertain: [[sensitivity.parameter]] is required");
    }
    for_each_table(section, "correlation",
                   [&](Section& element) { read_correlation(element, study.parameters, study.correlations); });
    read_methods(section, names, result.dimension, study);
    section.finish();
    return result;
}

}  // namespace delabole
