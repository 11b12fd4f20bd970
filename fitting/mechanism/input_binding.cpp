#include "fitting/mechanism/input_binding.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

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
    // The last draw of each stretch, also of a shorter one at the end.
    for (std::size_t first = 0; first < draws.size(); first += step) {
        kept.push_back(draws[std::min(first + step, draws.size()) - 1]);
    }
    return kept;
}

namespace {

std::size_t demanded_input(const Mechanism& mechanism, const std::string& name) {
    const auto place = place_of(mechanism.model.inputs, name);
    if (!place) {
        throw std::invalid_argument(mechanism.name + ": the model has no input " + name);
    }
    return *place;
}

}  // namespace

InputBinding::InputBinding(const Mechanism& mechanism, std::span<const Condition> conditions) {
    std::vector<std::vector<std::size_t>> inputs;  // inputs of each parameter
    for (const FreeParameter& parameter : mechanism.parameters) {
        inputs.push_back({demanded_input(mechanism, parameter.name)});
        for (const std::string& name : parameter.also) {
            inputs.back().push_back(demanded_input(mechanism, name));
        }
    }
    for (const Condition& condition : conditions) {
        set(demanded_input(mechanism, condition.input), condition.value, std::nullopt);
    }
    for (const Condition& condition : conditions) {
        for (const std::vector<std::size_t>& together : inputs) {
            if (together.front() == demanded_input(mechanism, condition.input)) {
                for (const std::size_t input : together) {
                    set(input, condition.value, std::nullopt);
                }
            }
        }
    }
    for (std::size_t parameter = 0; parameter < inputs.size(); ++parameter) {
        for (const std::size_t input : inputs[parameter]) {
            set(input, 0, parameter);
        }
    }
}

// If an input is set more than once, the first value holds.
void InputBinding::set(std::size_t input, double value, std::optional<std::size_t> parameter) {
    if (std::ranges::find(assignments_, input, &Assignment::input) == assignments_.end()) {
        assignments_.push_back({input, value});
        parameter_.push_back(parameter);
    }
}

std::vector<Assignment> InputBinding::at(std::span<const double> parameters) const {
    std::vector<Assignment> assignments = assignments_;
    for (std::size_t index = 0; index < assignments.size(); ++index) {
        if (parameter_[index]) {
            assignments[index].value = parameters[*parameter_[index]];
        }
    }
    return assignments;
}

}  // namespace delabole
