// [[fit.conclusion]]: what others concluded, and how to hold it against the fit.
#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/spelling.hpp"

#include <algorithm>

namespace delabole {
namespace {

// What the mechanisms of the case are called, and what their models know, in the same order.
struct Mechanisms {
    std::vector<std::string> names;
    const std::vector<ModelNames>& models;
};

// Its place among the mechanisms; nothing, with a complaint, where there is none of that name.
std::optional<std::size_t> demand_mechanism(Section& section, std::string_view key, const std::string& name,
                                            const Mechanisms& mechanisms) {
    const auto found = std::ranges::find(mechanisms.names, name);
    if (found == mechanisms.names.end()) {
        section.complain(key, *section.peek(key),
                         name + " is not a mechanism of this case" + suggestion(name, mechanisms.names));
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - mechanisms.names.begin());
}

ClaimOfMechanisms read_claim_of_mechanisms(Section& section, const Mechanisms& mechanisms) {
    ClaimOfMechanisms claim;
    read_words(section, "probability_of", claim.mechanisms);
    for (const std::string& name : claim.mechanisms) {
        demand_mechanism(section, "probability_of", name, mechanisms);
    }
    for (const std::string_view key : {"quantity", "with", "compared_with"}) {
        if (const Node* node = section.take(key)) {
            section.complain(key, *node, "goes with mechanism, not with probability_of");
        }
    }
    return claim;
}

// With the dimension of its quantity, where it is known.
std::optional<Dimension> read_claim_of_quantity(Section& section, const Mechanisms& mechanisms,
                                                ClaimOfQuantity& claim) {
    claim.mechanism = require_text(section, "mechanism", "name of the mechanism that is asked, or probability_of");
    claim.quantity = require_text(section, "quantity", "name of an output of the mechanism");
    for (const std::string_view key : {"with", "compared_with"}) {
        section.allow(key);
    }
    const auto place =
        claim.mechanism.empty() ? std::nullopt : demand_mechanism(section, "mechanism", claim.mechanism, mechanisms);
    if (!place) {
        return std::nullopt;
    }
    const ModelNames& model = mechanisms.models[*place];
    claim.conditions = read_conditions(section, std::span(&model, 1));
    if (section.contains("compared_with")) {
        claim.against = read_conditions(section, std::span(&model, 1), "compared_with");
    }
    const Quantity* output = find_quantity(model.outputs, claim.quantity);
    if (output == nullptr) {
        if (!claim.quantity.empty() && model.inputs_known) {
            section.complain("quantity", *section.peek("quantity"),
                             "is not an output of the mechanism" + suggestion(claim.quantity, names_in(model.outputs)));
        }
        return std::nullopt;
    }
    return output->dimension;
}

void read_test(Section& section, const Mechanisms& mechanisms, Conclusion& conclusion) {
    ConclusionTest test{};
    test.claim = require_text(section, "claim", "what is claimed, in words");
    section.allow("value");
    std::optional<Dimension> dimension;
    if (section.contains("probability_of")) {
        test.of = read_claim_of_mechanisms(section, mechanisms);
        dimension = Dimension::ratio;
        if (const Node* node = section.take("mechanism")) {
            section.complain("mechanism", *node, "a claim has either mechanism or probability_of");
        }
    } else {
        section.allow("probability_of");
        ClaimOfQuantity claim;
        dimension = read_claim_of_quantity(section, mechanisms, claim);
        test.of = std::move(claim);
    }
    test.relation = Relation::at_least;
    if (const Node* node = section.take("relation")) {
        const auto index = read_choice(section.reading(), *node, section.path_of("relation"), {"at_least", "at_most"});
        test.relation = index == 1U ? Relation::at_most : Relation::at_least;
    }
    if (!dimension) {
        return;
    }
    const bool probability = std::holds_alternative<ClaimOfMechanisms>(test.of);
    test.limit =
        read_number(section, "value", *dimension, probability ? within(0, 1) : any_number(), "limit of what is claimed")
            .value_or(0);
    test.dimension = *dimension;
    conclusion.tests.push_back(std::move(test));
}

void read_conclusion(Section& section, const Mechanisms& mechanisms, std::vector<Conclusion>& conclusions) {
    Conclusion conclusion;
    conclusion.label = require_text(section, "label", "what it is called, e.g. (i)");
    conclusion.statement = require_text(section, "statement", "what was concluded");
    conclusion.source = read_optional_text(section, "source");
    conclusion.note = read_optional_text(section, "note");
    if (!conclusion.label.empty() &&
        std::ranges::any_of(conclusions, [&](const Conclusion& other) { return other.label == conclusion.label; })) {
        section.complain("label", *section.peek("label"), "names two conclusions");
    }
    for_each_table(section, "test", [&](Section& element) { read_test(element, mechanisms, conclusion); });
    conclusions.push_back(std::move(conclusion));
}

}  // namespace

std::vector<Conclusion> read_conclusions(Section& fit, const std::vector<FitMechanism>& mechanisms,
                                         const std::vector<ModelNames>& models) {
    Mechanisms known{{}, models};
    for (const FitMechanism& mechanism : mechanisms) {
        known.names.push_back(mechanism.name);
    }
    std::vector<Conclusion> conclusions;
    for_each_table(fit, "conclusion", [&](Section& element) { read_conclusion(element, known, conclusions); });
    return conclusions;
}

}  // namespace delabole
