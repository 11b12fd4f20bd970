#include "fitting/studies/support_design.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

std::vector<Assignment> assignments_of(const ModelInterface& model, const SupportDesign& design,
                                       const std::vector<double>& values) {
    std::vector<Assignment> assignments;
    for (std::size_t index = 0; index < design.choices.size(); ++index) {
        assignments.push_back({place_of(model.inputs, design.choices[index].input).value(), values[index]});
    }
    return assignments;
}

double value_of(const SupportChoice& choice, std::size_t index) {
    return choice.points > 1
               ? choice.from + (choice.to - choice.from) * static_cast<double>(index) / (choice.points - 1)
               : choice.from;
}

// Every combination, the last choice running fastest.
std::vector<TriedSupport> all_patterns(const ModelInterface& model, const SupportDesign& design) {
    std::vector<TriedSupport> patterns{{{}, 0, {}, {}}};
    for (const SupportChoice& choice : design.choices) {
        std::vector<TriedSupport> longer;
        for (const TriedSupport& pattern : patterns) {
            for (std::size_t index = 0; static_cast<double>(index) < choice.points; ++index) {
                longer.push_back(pattern);
                longer.back().values.push_back(value_of(choice, index));
            }
        }
        patterns = std::move(longer);
    }
    for (TriedSupport& pattern : patterns) {
        pattern.cost = cost_of_support(model, design, pattern.values);
    }
    std::ranges::stable_sort(patterns, {}, &TriedSupport::cost);
    return patterns;
}

// Where a model's search ended at a bound, that bound.
void evaluate(const ModelInterface& model, std::size_t factor, const std::vector<Assignment>& assignments,
              TriedSupport& tried) {
    const Prediction prediction = model.predict(assignments);
    if (prediction.failure.empty()) {
        tried.factor_of_safety = prediction.outputs[factor];
        return;
    }
    tried.failure = prediction.failure;
    for (const OutputBound& bound : model.bounds) {
        if (bound.failure == prediction.failure && bound.output == factor) {
            tried.factor_of_safety = std::isfinite(bound.within.lower) ? bound.within.lower : bound.within.upper;
            tried.failure.clear();
        }
    }
}

}  // namespace

double number_of_patterns(const SupportDesign& design) {
    double count = 1;
    for (const SupportChoice& choice : design.choices) {
        count *= choice.points;
    }
    return count;
}

double cost_of_support(const ModelInterface& model, const SupportDesign& design, const std::vector<double>& values) {
    std::vector<Quantity> inputs = model.inputs;
    for (const Assignment& assignment : assignments_of(model, design, values)) {
        inputs[assignment.input].value = assignment.value;
    }
    double cost = 0;
    for (std::size_t number = 1;; ++number) {
        const std::string pattern = "support[" + std::to_string(number) + "].";
        const Quantity* rows = find_quantity(inputs, pattern + "rows");
        if (rows == nullptr) {
            return cost;
        }
        cost += rows->value / find_quantity(inputs, pattern + "spacing")->value *
                (design.cost_per_bolt + design.cost_per_metre * find_quantity(inputs, pattern + "length")->value);
    }
}

SupportDesignResult design_support(const ModelInterface& model, const SupportDesign& design,
                                   const std::function<bool(double)>& watch) {
    const std::size_t factor = place_of(model.outputs, "factor_of_safety").value();
    SupportDesignResult result{{}, {}, {}, static_cast<std::size_t>(number_of_patterns(design)), {}};
    for (TriedSupport& pattern : all_patterns(model, design)) {
        evaluate(model, factor, assignments_of(model, design, pattern.values), pattern);
        if (!pattern.factor_of_safety) {
            ++result.failed_by_cause[pattern.failure];
        }
        const std::size_t index = result.tried.size();
        const std::optional<double> reached = pattern.factor_of_safety;
        result.tried.push_back(std::move(pattern));
        if (reached && (!result.strongest || *reached > *result.tried[*result.strongest].factor_of_safety)) {
            result.strongest = index;
        }
        if (reached && *reached >= design.factor_of_safety) {
            result.cheapest = index;
            break;
        }
        if (watch && !watch(static_cast<double>(index + 1) / static_cast<double>(result.patterns))) {
            break;
        }
    }
    return result;
}

}  // namespace delabole
