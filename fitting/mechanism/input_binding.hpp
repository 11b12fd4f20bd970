// How the free parameters of a mechanism, and conditions that override them, set the inputs of its model.
#pragma once

#include "fitting/posterior/fit_problem.hpp"

#include <cstddef>
#include <optional>
#include <span>
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

}  // namespace delabole
