#include "fitting/studies/support_design.hpp"

#include "fitting/work/spaced_values.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace delabole {

namespace {

// Indices, among the model's inputs, of those that the cost of a bolt pattern depends on.
struct CostPlaces {
    std::size_t rows;
    std::size_t spacing;
    std::size_t length;
};

std::vector<CostPlaces> cost_places(const ModelInterface& model) {
    std::vector<CostPlaces> places;
    for (std::size_t number = 1;; ++number) {
        const std::string pattern = "support[" + std::to_string(number) + "].";
        const auto rows = place_of(model.inputs, pattern + "rows");
        if (!rows) {
            return places;
        }
        places.push_back({*rows, place_of(model.inputs, pattern + "spacing").value(),
                          place_of(model.inputs, pattern + "length").value()});
    }
}

// Every combination of the choices by increasing cost; `places` are the indices of their inputs.
std::vector<TriedSupport> all_patterns(const ModelInterface& model, const SupportDesign& design,
                                       const std::vector<std::size_t>& places) {
    std::vector<TriedSupport> patterns{{{}, 0, {}, {}}};
    for (const SupportChoice& choice : design.choices) {
        std::vector<TriedSupport> longer;
        for (const TriedSupport& pattern : patterns) {
            for (const double value : spaced_values(choice.from, choice.to, static_cast<std::int64_t>(choice.points))) {
                longer.push_back(pattern);
                longer.back().values.push_back(value);
            }
        }
        patterns = std::move(longer);
    }
    const std::vector<CostPlaces> bolts = cost_places(model);
    std::vector<double> inputs;
    std::ranges::transform(model.inputs, std::back_inserter(inputs), &Quantity::value);
    for (TriedSupport& pattern : patterns) {
        for (std::size_t index = 0; index < places.size(); ++index) {
            inputs[places[index]] = pattern.values[index];
        }
        for (const CostPlaces& bolt : bolts) {
            pattern.cost += inputs[bolt.rows] / inputs[bolt.spacing] *
                            (design.cost_per_bolt + design.cost_per_metre * inputs[bolt.length]);
        }
    }
    std::ranges::stable_sort(patterns, {}, &TriedSupport::cost);
    return patterns;
}

// If the model's search ended at a bound of the factor of safety, that bound is entered. A mean that is at most a value
// does not show that the factor wanted is reached.
void evaluate(const ModelInterface& model, std::size_t factor, double wanted,
              const std::vector<Assignment>& assignments, TriedSupport& tried) {
    const Prediction prediction = model.predict(assignments);
    const auto bounded = std::ranges::find(model.bounded_outputs, factor, &BoundedOutput::output);
    if (prediction.failure.empty() && bounded != model.bounded_outputs.end() && prediction.outputs[factor] >= wanted &&
        bounded->range(prediction).lower < wanted) {
        tried.failure = known_as_bound;
        return;
    }
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

SupportDesignResult design_support(const ModelInterface& model, const SupportDesign& design,
                                   const std::function<bool(double)>& watch) {
    const std::size_t factor = place_of(model.outputs, "factor_of_safety").value();
    SupportDesignResult result{{}, {}, {}, static_cast<std::size_t>(number_of_patterns(design)), {}};
    std::vector<std::size_t> places;
    for (const SupportChoice& choice : design.choices) {
        places.push_back(place_of(model.inputs, choice.input).value());
    }
    for (TriedSupport& pattern : all_patterns(model, design, places)) {
        std::vector<Assignment> assignments;
        for (std::size_t index = 0; index < places.size(); ++index) {
            assignments.push_back({places[index], pattern.values[index]});
        }
        evaluate(model, factor, design.factor_of_safety, assignments, pattern);
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
