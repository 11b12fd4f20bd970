// How the free parameters of a mechanism, and conditions that override them, set the inputs of its model; an output or
// an input as a function of the parameters, and thinned draws at which to evaluate it.
#pragma once

#include "fitting/posterior/fit_problem.hpp"
#include "fitting/posterior/posterior.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace delabole {

class InputBinding {
  public:
    // A condition on a parameter holds for all inputs that take its value. Throws std::invalid_argument if the model
    // lacks an input.
    explicit InputBinding(const Mechanism& mechanism, std::span<const Condition> conditions = {});

    // parameters: one number for each of the mechanism's, SI.
    std::vector<Assignment> at(std::span<const double> parameters) const;

  private:
    void set(std::size_t input, double value, std::optional<std::size_t> parameter);

    std::vector<Assignment> assignments_;
    std::vector<std::optional<std::size_t>> parameter_;  // that gives the value; absent for a condition
};

class QuantityOfMechanism {
  public:
    // The first of the names that the mechanism has. Nothing if it has none of them, or if the model lacks an input
    // that a condition sets. The mechanism has to outlive the result.
    static std::optional<QuantityOfMechanism> of(const Mechanism& mechanism, std::span<const std::string> names,
                                                 std::span<const Condition> conditions);

    // NaN if the model has no answer. The value of an input is known without running the model.
    double at(std::span<const double> parameters) const;

  private:
    QuantityOfMechanism(const Mechanism& mechanism, std::span<const Condition> conditions)
        : mechanism_(&mechanism), binding_(mechanism, conditions) {}

    const Mechanism* mechanism_;
    InputBinding binding_;
    std::optional<std::size_t> output_;
    std::optional<std::size_t> input_;  // used if there is no output
};

// At most `most` > 0 of the draws, equally many of each chain.
std::vector<Draw> thinned(const std::vector<Draw>& draws, std::size_t most);

}  // namespace delabole
