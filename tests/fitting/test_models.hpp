// Small models with known answers.
#pragma once

#include "fitting/posterior/fit_problem.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace delabole::test {

using Formula = std::function<Prediction(std::span<const double>)>;

// A model of ratios: inputs x1, x2, ... with base value 0 and no range; outputs as named.
inline ModelInterface formula_model(std::size_t inputs, const std::vector<std::string>& outputs, Formula formula) {
    ModelInterface model;
    for (std::size_t index = 0; index < inputs; ++index) {
        Quantity input;
        input.name = "x";
        input.name += std::to_string(index + 1);
        model.inputs.push_back(input);
    }
    for (const std::string& name : outputs) {
        Quantity output;
        output.name = name;
        model.outputs.push_back(output);
    }
    model.predict = [inputs, formula = std::move(formula)](std::span<const Assignment> assignments) {
        std::vector<double> values(inputs, 0.0);
        for (const Assignment& assignment : assignments) {
            values[assignment.input] = assignment.value;
        }
        return formula(values);
    };
    return model;
}

inline Prediction answer(std::vector<double> outputs) {
    return {{}, std::move(outputs), {}};
}

inline QuantityObservation observe(const std::string& quantity, double value, double standard_deviation,
                                   Relation relation = Relation::equal) {
    return {quantity + " observed", quantity, relation, value, standard_deviation, {}, "test"};
}

inline FreeParameter free_parameter(const std::string& name, double lower, double upper) {
    return {name, lower, upper, std::nullopt};
}

inline FreeParameter with_prior(const std::string& name, double lower, double upper, double mean, double deviation) {
    return {name, lower, upper, Prior{mean, deviation, "test"}};
}

inline Mechanism mechanism(const std::string& name, const std::string& title, ModelInterface model,
                           std::vector<FreeParameter> parameters) {
    return {{name, title, std::move(parameters)}, std::move(model)};
}

inline FitProblem problem_of(ModelInterface model, std::vector<FreeParameter> parameters,
                             std::vector<QuantityObservation> observations) {
    FitProblem problem;
    problem.mechanisms.push_back(mechanism("mechanism", "A mechanism", std::move(model), std::move(parameters)));
    problem.observations = std::move(observations);
    return problem;
}

// FS = 0.6 + 0.8 x1 - 0.4 x2: 1 along x2 = 2 x1 - 1.
inline ModelInterface linear_safety() {
    return formula_model(2, {"factor_of_safety"},
                         [](std::span<const double> x) { return answer({0.6 + 0.8 * x[0] - 0.4 * x[1]}); });
}

}  // namespace delabole::test
