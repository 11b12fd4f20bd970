// The prior of a mechanism's free parameters, as independent standard normal numbers z: parameter i is
// F_i^-1(Phi(z_i)), F_i being its prior's distribution, normal and cut off at the bounds, or uniform between them where
// there is no prior. Bounds need no care in z, the prior density there is that of standard normal numbers, and the
// evidence is the mean of the likelihood over them.
#pragma once

#include "fitting/posterior/fit_problem.hpp"
#include "fitting/probability/distribution.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace delabole {

// Why no sample can be drawn from a prior: no finite bounds in order, or a normal prior that has less than 1e-12 of its
// probability between them. Empty where nothing does; otherwise a sentence without the parameter's name.
std::string fault_of_prior(const FreeParameter& parameter);

class PriorSpace {
  public:
    // Throws std::invalid_argument for a parameter with a fault, and for more than most_parameters.
    explicit PriorSpace(std::vector<FreeParameter> parameters);

    const std::vector<FreeParameter>& parameters() const { return parameters_; }
    // Indices of the parameters with lower < upper: one coordinate each.
    const std::vector<std::size_t>& free() const { return free_; }
    std::size_t size() const { return free_.size(); }

    // Parameters, fixed ones included, from one standard normal number for each free one.
    void values(std::span<const double> standard_normal, std::span<double> parameters) const;
    // Its inverse, within +-8.3 whatever the parameters.
    std::vector<double> coordinates(std::span<const double> parameters) const;

  private:
    std::vector<FreeParameter> parameters_;
    std::vector<std::size_t> free_;
    std::vector<Marginal> marginals_;  // of the free ones
};

}  // namespace delabole
