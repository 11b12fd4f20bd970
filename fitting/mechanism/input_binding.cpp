#include "fitting/mechanism/input_binding.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace delabole {

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
    std::vector<std::vector<std::size_t>> inputs;  // of each parameter
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

// What comes first holds.
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
