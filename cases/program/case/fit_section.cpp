// [fit]: what was observed, what is free, and how to search.
#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/described_reader.hpp"

#include <algorithm>

namespace delabole {
namespace {

constexpr std::string_view one_side = "must be at_least or at_most";

void check_parameters(Reading& reading, const std::string& list, const std::vector<FreeParameter>& parameters) {
    check_unique(reading, list, parameters, &FreeParameter::name, "name", "is free already: each input once");
    for (std::size_t index = 0; index < parameters.size(); ++index) {
        const std::string lower = indexed(list, index) + ".lower";
        const std::string upper = indexed(list, index) + ".upper";
        if (parameters[index].lower > parameters[index].upper && !reading.blames(lower) && !reading.blames(upper)) {
            reading.complain_at(
                lower, "bounds are reversed: lower must not exceed upper = " + reading.places().at(upper).value);
        }
    }
}

void check_mechanism(Reading& reading, const std::string& path, const FitMechanism& mechanism, const FitTask& fit) {
    check_file_name(reading, path + ".name", mechanism.name);
    check_parameters(reading, path + ".parameter", mechanism.parameters);
    for (std::size_t index = 0; index < mechanism.own_observations.size(); ++index) {
        check_among(reading, indexed(path + ".observation", index) + ".label", mechanism.own_observations[index].label,
                    fit.observations, &QuantityObservation::label,
                    "is not the label of a [[fit.observation]], which this one is to put in the mechanism's terms");
    }
    for (std::size_t index = 0; index < mechanism.signs.size(); ++index) {
        const std::string sign = indexed(path + ".shows", index);
        check_among(reading, sign + ".evidence", mechanism.signs[index].evidence, fit.evidence, &FieldEvidence::name,
                    "is not the name of a [[fit.evidence]]");
        if (mechanism.signs[index].relation == Relation::equal) {
            reading.complain_at(sign + ".relation", std::string(one_side));
        }
    }
}

void check_test(Reading& reading, const std::string& path, const ConclusionTest& test) {
    if (test.relation == Relation::equal) {
        reading.complain_at(path + ".relation", std::string(one_side));
    }
    if (std::holds_alternative<ClaimOfMechanisms>(test.of) && !(test.limit >= 0 && test.limit <= 1)) {
        reading.complain_at(path + ".value", "must be from 0 to 1");
    }
}

void check_profile(Reading& reading, const ProfileObservation& profile) {
    const std::string key = "fit.profile.points";
    const auto differs = [&](const Point& point) { return point != profile.profile.front(); };
    if (reading.clean() && std::ranges::none_of(profile.profile, differs)) {
        reading.complain_at(key, "must hold at least two different points");
    }
}

// Checks that concern several keys together.
void check_fit(Section& section, const CaseFit& fit) {
    Reading& reading = section.reading();
    check_unique(reading, "fit.mechanism", fit.mechanisms, &FitMechanism::name, "name", "names two mechanisms");
    check_unique(reading, "fit.evidence", fit.evidence, &FieldEvidence::name, "name", "names two pieces of evidence");
    check_unique(reading, "fit.candidate", fit.candidates, &FitCandidate::label, "label", "names two candidates");
    check_unique(reading, "fit.conclusion", fit.conclusions, &Conclusion::label, "label", "names two conclusions");
    check_not_empty(reading, "fit.mechanism", fit.mechanisms, &FitMechanism::name, "name");
    check_not_empty(reading, "fit.observation", fit.observations, &QuantityObservation::label, "label");
    check_not_empty(reading, "fit.evidence", fit.evidence, &FieldEvidence::name, "name");
    check_not_empty(reading, "fit.evidence", fit.evidence, &FieldEvidence::statement, "statement");
    check_not_empty(reading, "fit.candidate", fit.candidates, &FitCandidate::label, "label");
    check_not_empty(reading, "fit.conclusion", fit.conclusions, &Conclusion::label, "label");
    check_not_empty(reading, "fit.conclusion", fit.conclusions, &Conclusion::statement, "statement");
    if (section.contains("parameter")) {
        check_parameters(reading, "fit.parameter", fit.mechanisms.front().parameters);
    } else {
        for (std::size_t index = 0; index < fit.mechanisms.size(); ++index) {
            check_mechanism(reading, indexed("fit.mechanism", index), fit.mechanisms[index], fit);
        }
    }
    for (std::size_t index = 0; index < fit.conclusions.size(); ++index) {
        for (std::size_t test = 0; test < fit.conclusions[index].tests.size(); ++test) {
            check_test(reading, indexed(indexed("fit.conclusion", index) + ".test", test),
                       fit.conclusions[index].tests[test]);
        }
    }
    if (fit.profile) {
        check_profile(reading, *fit.profile);
    }
    const std::string draws = "fit.posterior.draws";
    if (fit.posterior && fit.posterior->draws < draws_per_chain * fit.posterior->chains && reading.knows(draws) &&
        !reading.blames(draws)) {
        reading.complain_at(draws, "must be at least " + std::to_string(draws_per_chain) +
                                       " for each chain: " + std::to_string(draws_per_chain * fit.posterior->chains));
    }
    if (const Node* node = section.peek("candidate"); node != nullptr && !fit.posterior) {
        section.complain("candidate", *node,
                         "needs [fit.posterior]: what a measurement would tell is asked of the posterior");
    }
    const Node* observations = section.peek("observation");
    if ((observations == nullptr || (observations->kind == Node::Kind::array && observations->elements.empty())) &&
        !section.contains("profile")) {
        reading.complain(section.place(), "fit", {},
                         "has no observations: [[fit.observation]] or [fit.profile] is required");
    }
}

FitMechanism read_mechanism(Section& section, const CaseFile& case_file, const OutputsOf& outputs_of,
                            std::vector<ModelNames>& names) {
    FitMechanism mechanism{};
    mechanism.model = case_file.model;
    if (section.contains("model")) {
        std::optional<CaseModel> own = choose_model(section);
        if (!own) {
            // Without a model none of the mechanism's other keys can be checked.
            section.reading().finish();
        }
        mechanism.model = *std::move(own);
        read_model(section, mechanism.model);
    } else {
        section.allow("model");
        replace_in_model(section, mechanism.model);
    }
    complete_model(section.reading(), mechanism.model, case_file.name, section.path() + ".");
    for_table(section, "coarse", [&](Section& coarse) {
        mechanism.coarse = mechanism.model;
        replace_in_model(coarse, *mechanism.coarse);
        complete_model(coarse.reading(), *mechanism.coarse, case_file.name, coarse.path() + ".");
    });
    names.push_back(names_of(mechanism.model, outputs_of, section.reading().inputs_known()));
    section.refer_to({std::span(&names.back(), 1), "an output of the mechanism"});
    read_fields(section, mechanism);
    names.back().mechanism = mechanism.name;
    if (mechanism.title.empty()) {
        mechanism.title = mechanism.name;
    }
    if (!section.contains("parameter")) {
        section.reading().complain(section.place(), section.path(), {},
                                   "has nothing free: [[fit.mechanism.parameter]] is required");
    }
    return mechanism;
}

std::vector<FitMechanism> read_mechanisms(Section& section, const CaseFile& case_file, const OutputsOf& outputs_of,
                                          std::vector<ModelNames>& names) {
    std::vector<FitMechanism> mechanisms;
    const bool own = section.contains("parameter");
    const bool several = section.contains("mechanism");
    if (own == several) {
        section.reading().complain(section.place(), section.path(), {},
                                   own ? "takes either [[fit.parameter]] or [[fit.mechanism]], not both"
                                       : "has nothing free: [[fit.parameter]] or [[fit.mechanism]] is required");
    }
    for_each_table(section, "mechanism", [&](Section& element) {
        mechanisms.push_back(read_mechanism(element, case_file, outputs_of, names));
    });
    if (!mechanisms.empty()) {
        section.allow("parameter");
        return mechanisms;
    }
    FitMechanism& mechanism = mechanisms.emplace_back();
    mechanism.name = model_name(case_file.model);
    mechanism.title = case_file.title.empty() ? mechanism.name : case_file.title;
    mechanism.model = case_file.model;
    names.push_back(names_of(case_file.model, outputs_of, section.reading().inputs_known()));
    names.back().mechanism = mechanism.name;
    section.refer_to({names, {}});
    for_each_table(section, "parameter",
                   [&](Section& element) { read_fields(element, mechanism.parameters.emplace_back()); });
    return mechanisms;
}

}  // namespace

void check_file_name(Reading& reading, const std::string& key, const std::string& name) {
    const auto plain = [](char character) {
        return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
               (character >= '0' && character <= '9') || character == '_' || character == '-';
    };
    constexpr std::size_t longest = 100;
    if (!std::ranges::all_of(name, plain) || name.size() > longest) {
        reading.complain_at(
            key, "must consist of at most " + std::to_string(longest) + " letters, digits, - and _ (it names files)");
    }
}

CaseFit read_fit(Section& section, const CaseFile& case_file, const OutputsOf& outputs_of) {
    CaseFit fit;
    std::vector<ModelNames> names;
    fit.mechanisms = read_mechanisms(section, case_file, outputs_of, names);
    section.refer_to({names, "an output of any mechanism"});
    read_fields(section, fit);
    check_fit(section, fit);
    return fit;
}

}  // namespace delabole
