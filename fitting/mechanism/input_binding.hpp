// How the free parameters of a mechanism, and conditions that override them, set the inputs of its model; an output or
// an input as a function of them, and draws to ask it at.
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
    // A condition on a parameter is one on all inputs that take its value. Throws std::invalid_argument where the
    // model lacks an input.
    explicit InputBinding(const Mechanism& mechanism, std::span<const Condition> conditions = {});

    // parameters: one number for each of the mechanism's, SI.
    std::vector<Assignment> at(std::span<const double> parameters) const;

  private:
    void set(std::size_t input, double value, std::optional<std::size_t> parameter);

    std::vector<Assignment> assignments_;
    std::vector<std::optional<std::size_t>> parameter_;  // that gives an assignment its value; none: a condition
};

class QuantityOfMechanism {
  public:
    // The first of the names that the mechanism has. Nothing where it has none, or lacks an input that a condition
    // fixes. The mechanism has to outlive it.
    static std::optional<QuantityOfMechanism> of(const Mechanism& mechanism, std::span<const std::string> names,
                                                 std::span<const Condition> conditions);

    // NaN where the model has no answer. An input that is not free is known already.
    double at(std::span<const double> parameters) const;

  private:
    QuantityOfMechanism(const Mechanism& mechanism, std::span<const Condition> conditions)
        : mechanism_(&mechanism), binding_(mechanism, conditions) {}

    const Mechanism* mechanism_;
    InputBinding binding_;
    std::optional<std::size_t> output_;
    std::optional<std::size_t> input_;  // where there is no output
};

// No more than `most` > 0 of them, as many of each chain.
std::vector<Draw> thinned(const std::vector<Draw>& draws, std::size_t most);

}  // namespace delabole
