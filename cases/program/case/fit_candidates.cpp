// [[fit.candidate]]: measurements that could be made next.
#include "cases/program/case/case_parts.hpp"
#include "cases/program/reader/spelling.hpp"

#include <algorithm>

namespace delabole {
namespace {

// Of an output or an input of any mechanism; nullptr where none has it.
const Quantity* find_measured(const std::vector<ModelNames>& models, const std::string& name) {
    for (const ModelNames& model : models) {
        for (const std::vector<Quantity>* quantities : {&model.outputs, &model.inputs}) {
            if (const Quantity* quantity = find_quantity(*quantities, name)) {
                return quantity;
            }
        }
    }
    return nullptr;
}

std::vector<std::string> measurable_names(const std::vector<ModelNames>& models) {
    std::vector<std::string> names;
    for (const ModelNames& model : models) {
        for (const std::vector<Quantity>* quantities : {&model.outputs, &model.inputs}) {
            for (const std::string& name : names_in(*quantities)) {
                names.push_back(name);
            }
        }
    }
    return names;
}

// One name or a list of them.
std::vector<std::string> read_quantities(Section& section) {
    const Node* node =
        section.require("quantity", "name of an output or an input of the model, or a list of such names");
    if (node == nullptr) {
        return {};
    }
    std::vector<std::string> names;
    const bool several = node->kind == Node::Kind::array;
    for (const Node& element : several ? node->elements : std::vector<Node>{*node}) {
        if (const auto name = read_text(section.reading(), element, section.path_of("quantity"))) {
            names.push_back(*name);
        }
    }
    if (several && node->elements.empty()) {
        section.complain("quantity", *node, "is empty");
    }
    return names;
}

void read_candidate(Section& section, const std::vector<ModelNames>& models, std::vector<CaseCandidate>& candidates) {
    FitCandidate candidate{};
    candidate.label = require_text(section, "label", "what could be measured, in a few words");
    candidate.quantities = read_quantities(section);
    candidate.conditions = read_conditions(section, models);
    candidate.source = read_optional_text(section, "source");
    section.allow("standard_deviation");
    if (const Node* cost = section.take("cost")) {
        candidate.cost = read_number(section.reading(), *cost, section.path_of("cost"), Dimension::ratio, more_than(0));
    }
    if (!candidate.label.empty() && std::ranges::any_of(candidates, [&](const CaseCandidate& other) {
            return other.candidate.label == candidate.label;
        })) {
        section.complain("label", *section.peek("label"), "names two candidates");
    }
    const Quantity* measured = nullptr;
    for (const std::string& name : candidate.quantities) {
        const Quantity* quantity = find_measured(models, name);
        if (quantity == nullptr) {
            if (std::ranges::all_of(models, &ModelNames::inputs_known)) {
                section.complain("quantity", *section.peek("quantity"),
                                 name + " is neither an output nor an input of any mechanism" +
                                     suggestion(name, measurable_names(models)));
            }
        } else if (measured != nullptr && measured->dimension != quantity->dimension) {
            section.complain("quantity", *section.peek("quantity"),
                             name + " and " + measured->name + " are not of one dimension");
        }
        measured = measured != nullptr ? measured : quantity;
    }
    if (measured == nullptr) {
        return;
    }
    candidate.standard_deviation = read_number(section, "standard_deviation", measured->dimension, more_than(0),
                                               "standard deviation of the measurement")
                                       .value_or(1);
    candidates.push_back({.candidate = std::move(candidate), .dimension = measured->dimension});
}

}  // namespace

std::vector<CaseCandidate> read_candidates(Section& fit, const std::vector<ModelNames>& models) {
    std::vector<CaseCandidate> candidates;
    for_each_table(fit, "candidate", [&](Section& element) { read_candidate(element, models, candidates); });
    if (const Node* node = fit.peek("candidate"); node != nullptr && !fit.contains("posterior")) {
        fit.complain("candidate", *node,
                     "needs [fit.posterior]: what a measurement would tell is asked of the posterior");
    }
    return candidates;
}

}  // namespace delabole
