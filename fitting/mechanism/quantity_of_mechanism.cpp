#include "fitting/mechanism/quantity_of_mechanism.hpp"

#include <algorithm>
#include <limits>

namespace delabole {

std::optional<QuantityOfMechanism> QuantityOfMechanism::of(const Mechanism& mechanism,
                                                           std::span<const std::string> names,
                                                           std::span<const Condition> conditions) {
    for (const Condition& condition : conditions) {
        if (!place_of(mechanism.model.inputs, condition.input)) {
            return std::nullopt;
        }
    }
    QuantityOfMechanism quantity(mechanism, conditions);
    for (const std::string& name : names) {
        quantity.output_ = place_of(mechanism.model.outputs, name);
        quantity.input_ = place_of(mechanism.model.inputs, name);
        if (quantity.output_ || quantity.input_) {
            return quantity;
        }
    }
    return std::nullopt;
}

double QuantityOfMechanism::at(std::span<const double> parameters) const {
    const std::vector<Assignment> assignments = binding_.at(parameters);
    if (!output_) {
        const auto assigned = std::ranges::find(assignments, *input_, &Assignment::input);
        return assigned == assignments.end() ? mechanism_->model.inputs[*input_].value : assigned->value;
    }
    const Prediction prediction = mechanism_->model.predict(assignments);
    return prediction.failure.empty() ? prediction.outputs[*output_] : std::numeric_limits<double>::quiet_NaN();
}

std::vector<Draw> thinned(const std::vector<Draw>& draws, std::size_t most) {
    const std::size_t step = std::max<std::size_t>((draws.size() + most - 1) / most, 1);
    std::vector<Draw> kept;
    for (std::size_t index = step - 1; index < draws.size(); index += step) {
        kept.push_back(draws[index]);
    }
    return kept;
}

}  // namespace delabole
