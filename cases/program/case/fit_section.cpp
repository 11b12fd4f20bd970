// [fit]: what was observed, what is free, how to search.
#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/described_reader.hpp"
#include "cases/program/reader/spelling.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <unordered_set>

namespace delabole {
namespace {

// Inputs and outputs under the names used in the case, over all mechanisms.
std::vector<std::string> all_outputs(const std::vector<ModelNames>& models) {
    std::vector<std::string> names;
    std::unordered_set<std::string> known;  // a section of many blocks has a million of them
    for (const ModelNames& model : models) {
        for (const std::string& name : names_in(model.outputs)) {
            if (known.insert(name).second) {
                names.push_back(name);
            }
        }
    }
    return names;
}

template <class Enum>
void read_word(Section& section, std::string_view key, Enum& value) {
    if (const Node* node = section.take(key)) {
        const auto index = read_choice(section.reading(), *node, section.path_of(key), detail::enum_words<Enum>());
        value = index ? static_cast<Enum>(*index) : value;
    }
}

void read_count(Section& section, std::string_view key, int lower, int upper, int& value) {
    std::int64_t wide = value;
    read_integer(section, key, lower, upper, wide);
    value = static_cast<int>(wide);
}

void read_surrogate(Section& fit, SurrogateSettings& settings) {
    constexpr int most_runs = 2000;  // more make a surrogate that takes longer than the model
    const Node* node = fit.take("surrogate");
    const Node* table = node == nullptr ? nullptr : as_table(fit.reading(), *node, fit.path_of("surrogate"));
    if (table == nullptr) {
        return;
    }
    Section section(fit.reading(), *table, fit.path_of("surrogate"));
    read_count(section, "runs", 12, most_runs, settings.runs);
    if (section.contains("first_runs")) {
        read_count(section, "first_runs", 12, most_runs, settings.first_runs.emplace(12));
    } else {
        section.allow("first_runs");
    }
    if (const Node* tolerance = section.take("tolerance")) {
        settings.tolerance =
            read_number(section.reading(), *tolerance, section.path_of("tolerance"), Dimension::ratio, between(0, 1))
                .value_or(settings.tolerance);
    }
    if (const Node* share = section.take("give_up_below")) {
        settings.give_up_below =
            read_number(section.reading(), *share, section.path_of("give_up_below"), Dimension::ratio, right_open(0, 1))
                .value_or(settings.give_up_below);
    }
    section.finish();
}

FitSettings read_settings(Section& section) {
    constexpr int most_starts = 100'000;
    constexpr int most_evaluations = 100'000'000;
    constexpr int most_points = 2001;
    FitSettings settings;
    read_word(section, "algorithm", settings.algorithm);
    read_count(section, "starts", 1, most_starts, settings.starts);
    read_count(section, "evaluations_per_start", 10, most_evaluations, settings.evaluations_per_start);
    read_count(section, "profile_points", 5, most_points, settings.profile_points);
    read_count(section, "map_points", 5, most_points, settings.map_points);
    read_surrogate(section, settings.surrogate);
    auto seed = static_cast<std::int64_t>(settings.seed);
    read_integer(section, "seed", 0, std::numeric_limits<std::int64_t>::max(), seed);
    settings.seed = static_cast<std::uint64_t>(seed);
    if (const Node* node = section.take("relative_tolerance")) {
        settings.relative_tolerance = read_number(section.reading(), *node, section.path_of("relative_tolerance"),
                                                  Dimension::ratio, between(0, 1))
                                          .value_or(settings.relative_tolerance);
    }
    return settings;
}

std::optional<PosteriorStudy> read_posterior(Section& fit) {
    constexpr int most = 100'000'000;
    const Node* node = fit.take("posterior");
    const Node* table = node == nullptr ? nullptr : as_table(fit.reading(), *node, fit.path_of("posterior"));
    if (table == nullptr) {
        return std::nullopt;
    }
    Section section(fit.reading(), *table, fit.path_of("posterior"));
    PosteriorStudy study;
    read_count(section, "chains", 2, 1000, study.chains);
    // Fewer of each chain cannot be told to agree.
    read_count(section, "draws", 8 * study.chains, most, study.draws);
    read_count(section, "evaluations_per_chain", 1, most, study.evaluations_per_chain);
    read_count(section, "evidence_points", 16, 1 << 24, study.evidence_points);
    section.finish();
    return study;
}

std::optional<Prior> read_prior(Section& parameter, const Quantity& input) {
    const Node* node = parameter.take("prior");
    if (node == nullptr) {
        return std::nullopt;
    }
    const std::string path = parameter.path_of("prior");
    const Node* table = as_table(parameter.reading(), *node, path);
    if (table == nullptr) {
        return std::nullopt;
    }
    Section section(parameter.reading(), *table, path);
    Prior prior{};
    prior.mean = read_number(section, "mean", input.dimension, input.range, "mean of the prior").value_or(0);
    prior.standard_deviation =
        read_number(section, "standard_deviation", input.dimension, more_than(0), "standard deviation of the prior")
            .value_or(1);
    prior.source = read_optional_text(section, "source");
    section.finish();
    return prior;
}

void read_parameter(Section& section, const ModelNames& names, std::vector<FreeParameter>& parameters) {
    const std::string name = require_text(section, "name", "the input that is free, e.g. strength.friction_angle");
    for (const std::string_view key : {"lower", "upper", "prior", "also"}) {
        section.allow(key);
    }
    const Quantity* input = find_quantity(names.inputs, name);
    if (input == nullptr) {
        if (!name.empty() && names.inputs_known) {
            section.complain("name", *section.peek("name"),
                             "is not an input of this case" + suggestion(name, names_in(names.inputs)));
        }
        return;
    }
    if (std::ranges::find(parameters, name, &FreeParameter::name) != parameters.end()) {
        section.complain("name", *section.peek("name"), "is free already: each input once");
    }
    const auto lower = read_number(section, "lower", input->dimension, input->range, "lower bound");
    const auto upper = read_number(section, "upper", input->dimension, input->range, "upper bound");
    if (lower && upper && *lower > *upper) {
        section.complain("lower", *section.peek("lower"),
                         "bounds are reversed: lower must not exceed upper = " + shown(*section.peek("upper")));
    }
    parameters.push_back({.name = name,
                          .lower = lower.value_or(0),
                          .upper = upper.value_or(0),
                          .prior = read_prior(section, *input),
                          .also = read_others(section, *input, names)});
}

std::vector<FreeParameter> read_parameters(Section& section, const ModelNames& names) {
    std::vector<FreeParameter> parameters;
    for_each_table(section, "parameter", [&](Section& element) { read_parameter(element, names, parameters); });
    return parameters;
}

void check_mechanism_name(Section& section, const std::string& name, const std::vector<FitMechanism>& others) {
    check_file_name(section, "name", name);
    if (!name.empty() && std::ranges::find(others, name, &FitMechanism::name) != others.end()) {
        section.complain("name", *section.peek("name"), "names two mechanisms");
    }
}

void read_observation(Section& section, const std::vector<ModelNames>& names,
                      std::vector<CaseObservation>& observations) {
    QuantityObservation observation{};
    observation.label = require_text(section, "label", "what was observed, in a few words");
    observation.quantity = require_text(section, "quantity", "name of an output of the model");
    read_word(section, "relation", observation.relation);
    observation.conditions = read_conditions(section, names);
    observation.source = read_optional_text(section, "source");
    section.allow("value");
    section.allow("standard_deviation");
    const Quantity* output = nullptr;
    for (const ModelNames& model : names) {
        output = output != nullptr ? output : find_quantity(model.outputs, observation.quantity);
    }
    if (output == nullptr) {
        if (!observation.quantity.empty()) {
            section.complain(
                "quantity", *section.peek("quantity"),
                "is not an output of any mechanism" + suggestion(observation.quantity, all_outputs(names)));
        }
        return;
    }
    observation.value =
        read_number(section, "value", output->dimension, any_number(), "the observed value").value_or(0);
    observation.standard_deviation = read_number(section, "standard_deviation", output->dimension, more_than(0),
                                                 "standard deviation of the observation, or of the model")
                                         .value_or(1);
    observations.push_back({.observation = std::move(observation), .dimension = output->dimension});
}

// Labels of observations and names of evidence, which mechanisms refer to before they are read.
struct SharedNames {
    std::vector<std::string> labels;
    std::vector<std::string> evidence;
};

std::vector<std::string> texts_in(const Node* list, std::string_view key) {
    std::vector<std::string> texts;
    if (list != nullptr && list->kind == Node::Kind::array) {
        for (const Node& element : list->elements) {
            const Node* text = element.find(key);
            texts.push_back(text == nullptr ? std::string() : text->text);
        }
    }
    return texts;
}

void read_own_observations(Section& mechanism, const SharedNames& shared, const ModelNames& names,
                           std::vector<CaseObservation>& observations) {
    for_each_table(mechanism, "observation", [&](Section& element) {
        read_observation(element, {names}, observations);
        const Node* label = element.peek("label");
        if (label != nullptr && std::ranges::find(shared.labels, label->text) == shared.labels.end()) {
            element.complain("label", *label,
                             "is not the label of a [[fit.observation]], which this one is to put in the mechanism's "
                             "terms" +
                                 suggestion(label->text, shared.labels));
        }
    });
}

void read_sign(Section& section, const SharedNames& shared, const ModelNames& names, std::vector<CaseSign>& signs) {
    EvidenceSign sign{};
    sign.evidence = require_text(section, "evidence", "name of a [[fit.evidence]]");
    sign.quantity = require_text(section, "quantity", "name of an output of the mechanism");
    sign.relation = Relation::at_least;
    read_word(section, "relation", sign.relation);
    section.allow("value");
    if (sign.relation == Relation::equal) {
        section.complain("relation", *section.peek("relation"), "must be at_least or at_most");
    }
    if (!sign.evidence.empty() && std::ranges::find(shared.evidence, sign.evidence) == shared.evidence.end()) {
        section.complain("evidence", *section.peek("evidence"),
                         "is not the name of a [[fit.evidence]]" + suggestion(sign.evidence, shared.evidence));
    }
    const Quantity* output = find_quantity(names.outputs, sign.quantity);
    if (output == nullptr) {
        if (!sign.quantity.empty()) {
            section.complain("quantity", *section.peek("quantity"),
                             "is not an output of the mechanism" + suggestion(sign.quantity, names_in(names.outputs)));
        }
        return;
    }
    sign.value = read_number(section, "value", output->dimension, any_number(), "limit of the quantity").value_or(0);
    signs.push_back({.sign = std::move(sign), .dimension = output->dimension});
}

void read_coarse(Section& mechanism, const std::filesystem::path& case_path, FitMechanism& read) {
    const Node* node = mechanism.take("coarse");
    const Node* table = node == nullptr ? nullptr : as_table(mechanism.reading(), *node, mechanism.path_of("coarse"));
    if (table == nullptr) {
        return;
    }
    Section section(mechanism.reading(), *table, mechanism.path_of("coarse"));
    read.coarse = read.model;
    replace_in_model(section, *read.coarse);
    section.finish();
    complete_model(section.reading(), *read.coarse, case_path, section.path() + ".");
}

FitMechanism read_mechanism(Section& section, const CaseFile& case_file, const OutputsOf& outputs_of,
                            const SharedNames& shared, const std::vector<FitMechanism>& others,
                            std::vector<ModelNames>& names) {
    FitMechanism mechanism;
    mechanism.name = require_text(section, "name", "a short name, e.g. critical_geometry");
    check_mechanism_name(section, mechanism.name, others);
    mechanism.title = read_optional_text(section, "title");
    if (mechanism.title.empty()) {
        mechanism.title = mechanism.name;
    }
    mechanism.model = case_file.model;
    if (section.contains("model")) {
        std::optional<CaseModel> own = choose_model(section);
        if (!own) {
            // Without a model no other key of the mechanism can be judged.
            section.reading().finish();
        }
        mechanism.model = *std::move(own);
        read_model(section, mechanism.model);
    } else {
        section.allow("model");
        replace_in_model(section, mechanism.model);
    }
    complete_model(section.reading(), mechanism.model, case_file.name, section.path() + ".");
    read_coarse(section, case_file.name, mechanism);
    names.push_back(names_of(mechanism.model, outputs_of, section.reading().inputs_known()));
    mechanism.parameters = read_parameters(section, names.back());
    read_own_observations(section, shared, names.back(), mechanism.observations);
    for_each_table(section, "shows",
                   [&](Section& element) { read_sign(element, shared, names.back(), mechanism.signs); });
    if (!section.contains("parameter")) {
        section.reading().complain(section.place(), section.path(), {},
                                   "has nothing free: [[fit.mechanism.parameter]] is required");
    }
    return mechanism;
}

std::vector<FitMechanism> read_mechanisms(Section& section, const CaseFile& case_file, const OutputsOf& outputs_of,
                                          std::vector<ModelNames>& names) {
    const SharedNames shared{texts_in(section.peek("observation"), "label"),
                             texts_in(section.peek("evidence"), "name")};
    std::vector<FitMechanism> mechanisms;
    const bool own = section.contains("parameter");
    const bool several = section.contains("mechanism");
    if (own == several) {
        section.reading().complain(section.place(), section.path(), {},
                                   own ? "takes either [[fit.parameter]] or [[fit.mechanism]], not both"
                                       : "has nothing free: [[fit.parameter]] or [[fit.mechanism]] is required");
    }
    for_each_table(section, "mechanism", [&](Section& element) {
        mechanisms.push_back(read_mechanism(element, case_file, outputs_of, shared, mechanisms, names));
    });
    if (mechanisms.empty()) {
        names.push_back(names_of(case_file.model, outputs_of, section.reading().inputs_known()));
        const std::string name(model_name(case_file.model));
        mechanisms.push_back({.name = name,
                              .title = case_file.title.empty() ? name : case_file.title,
                              .model = case_file.model,
                              .parameters = read_parameters(section, names.back())});
    } else {
        section.allow("parameter");
    }
    return mechanisms;
}

std::optional<Point> read_point(Reading& reading, const Node& node, const std::string& path) {
    if (node.kind != Node::Kind::array || node.elements.size() != 2) {
        reading.complain(node.place, path, shown(node), "must be a point [x, y], e.g. [\"0 ft\", \"350 ft\"]");
        return std::nullopt;
    }
    const auto x = read_number(reading, node.elements[0], path + "[1]", Dimension::length, any_number());
    const auto y = read_number(reading, node.elements[1], path + "[2]", Dimension::length, any_number());
    return x && y ? std::optional(Point(*x, *y)) : std::nullopt;
}

std::optional<ProfileObservation> read_profile(Section& fit) {
    const Node* node = fit.take("profile");
    const Node* table = node == nullptr ? nullptr : as_table(fit.reading(), *node, fit.path_of("profile"));
    if (table == nullptr) {
        return std::nullopt;
    }
    Section section(fit.reading(), *table, fit.path_of("profile"));
    ProfileObservation profile{};
    const Node* points = section.require("points", "the ground after the failure, from the toe into the slope");
    if (points != nullptr && points->kind != Node::Kind::array) {
        section.complain("points", *points, "must be a list of points [x, y]");
    } else if (points != nullptr) {
        for (std::size_t index = 0; index < points->elements.size(); ++index) {
            const std::string path = section.path_of("points") + "[" + std::to_string(index + 1) + "]";
            profile.profile.push_back(
                read_point(section.reading(), points->elements[index], path).value_or(Point::Zero()));
        }
        const auto differs = [&](const Point& point) { return point != profile.profile.front(); };
        if (section.reading().clean() && std::ranges::none_of(profile.profile, differs)) {
            section.complain("points", *points, "must hold at least two different points");
        }
    }
    profile.standard_deviation = read_number(section, "standard_deviation", Dimension::length, more_than(0),
                                             "standard deviation of the distance from the profile")
                                     .value_or(1);
    profile.source = read_optional_text(section, "source");
    section.finish();
    return profile;
}

void read_evidence(Section& section, std::vector<FieldEvidence>& evidence) {
    FieldEvidence item;
    item.name = require_text(section, "name", "a short name, e.g. crest_block_rotation");
    item.statement = require_text(section, "statement", "what was seen");
    item.source = read_optional_text(section, "source");
    if (!item.name.empty() && std::ranges::find(evidence, item.name, &FieldEvidence::name) != evidence.end()) {
        section.complain("name", *section.peek("name"), "names two pieces of evidence");
    }
    evidence.push_back(std::move(item));
}

}  // namespace

void check_file_name(Section& section, std::string_view key, const std::string& name) {
    const auto plain = [](char character) {
        return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
               (character >= '0' && character <= '9') || character == '_' || character == '-';
    };
    if (!std::ranges::all_of(name, plain)) {
        section.complain(key, *section.peek(key), "must consist of letters, digits, - and _ (it names files)");
    }
}

std::vector<std::string> read_others(Section& parameter, const Quantity& input, const ModelNames& names) {
    std::vector<std::string> others;
    read_words(parameter, "also", others);
    for (const std::string& name : others) {
        const Quantity* other = find_quantity(names.inputs, name);
        if (other == nullptr && names.inputs_known) {
            parameter.complain("also", *parameter.peek("also"),
                               name + " is not an input of this case" + suggestion(name, names_in(names.inputs)));
        } else if (other != nullptr && other->dimension != input.dimension) {
            parameter.complain("also", *parameter.peek("also"), name + " has another dimension than " + input.name);
        }
    }
    return others;
}

CaseFit read_fit(Section& root, const CaseFile& case_file, const OutputsOf& outputs_of) {
    CaseFit fit;
    const Node* node = root.take("fit");
    const Node* table = as_table(root.reading(), *node, "fit");
    if (table == nullptr) {
        return fit;
    }
    Section section(root.reading(), *table, "fit");
    fit.settings = read_settings(section);
    fit.posterior = read_posterior(section);
    std::vector<ModelNames> names;
    fit.mechanisms = read_mechanisms(section, case_file, outputs_of, names);
    const Node* observations = section.peek("observation");
    for_each_table(section, "observation",
                   [&](Section& element) { read_observation(element, names, fit.observations); });
    fit.profile = read_profile(section);
    for_each_table(section, "evidence", [&](Section& element) { read_evidence(element, fit.evidence); });
    fit.candidates = read_candidates(section, names);
    fit.conclusions = read_conclusions(section, fit.mechanisms, names);
    const bool empty_list =
        observations == nullptr || (observations->kind == Node::Kind::array && observations->elements.empty());
    if (empty_list && !section.contains("profile")) {
        section.reading().complain(section.place(), "fit", {},
                                   "has no observations: [[fit.observation]] or [fit.profile] is required");
    }
    section.finish();
    return fit;
}

}  // namespace delabole
