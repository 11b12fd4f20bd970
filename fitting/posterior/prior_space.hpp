// The prior of a mechanism's free parameters, expressed by independent standard normal numbers z: parameter i is
// F_i^-1(Phi(z_i)), F_i being the distribution of its prior, which is normal and cut off at the bounds, or uniform
// between them if there is no prior. In z the bounds need no special treatment, the prior density is that of standard
// normal numbers, and the evidence is the mean of the likelihood over them.
#pragma once

#include "fitting/posterior/fit_problem.hpp"
#include "fitting/probability/distribution.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace delabole {

// Why no sample can be drawn from a prior: its bounds are not finite or not in order, or a normal prior has less than
// 1e-12 of its probability between them. Empty if a sample can be drawn; otherwise a sentence without the parameter's
// name.
std::string fault_of_prior(const FreeParameter& parameter);

class PriorSpace {
  public:
    // Throws std::invalid_argument for a parameter with a fault, and for more than most_parameters.
    explicit PriorSpace(std::vector<FreeParameter> parameters);

    const std::vector<FreeParameter>& parameters() const { return parameters_; }
    // Indices of the parameters with lower < upper; each has one coordinate.
    const std::vector<std::size_t>& free() const { return free_; }
    std::size_t size() const { return free_.size(); }

    // Parameters, fixed ones included, from one standard normal number for each free one.
    void values(std::span<const double> standard_normal, std::span<double> parameters) const;
    // The inverse of values(), limited to +-8.3 for all parameters.
    std::vector<double> coordinates(std::span<const double> parameters) const;

  private:
    std::vector<FreeParameter> parameters_;
    std::vector<std::size_t> free_;
    std::vector<Marginal> marginals_;  // of the free ones
};

}  // namespace delabole
