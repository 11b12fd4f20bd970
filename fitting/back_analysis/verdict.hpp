// Identifiability in plain words.
#pragma once

#include "fitting/mechanism/fit_result.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace delabole {

// The sentences need this besides the numbers of the parameters named in Identifiability.
struct VerdictQuestion {
    std::vector<Dimension> dimensions;
    Eigen::VectorXd ranges;  // upper - lower, SI
    bool has_priors = false;
    bool only_failure_observed = false;  // the only datum is one FS = 1
};

// The sentences, in this order: doubt about the numbers, parameters on which no datum depends, parameters that the data
// determine, combinations if only those are determined (with the exchange rate along the null direction, in display
// units), and what the priors add.
std::string verdict(const Identifiability& identifiability, const VerdictQuestion& question);

// Whether the data's constraint on a free parameter is meaningless, because the run at the best point disagrees with
// the surrogate or the best fit misses data that depend on the parameter by more than four standard deviations.
bool in_doubt(const Identifiability& identifiability, const std::string& parameter);

// The parameters of which the data determine only combinations near the best point; empty if not even those.
std::vector<std::string> exchangeable(const Identifiability& identifiability);

// A Jacobian describes only the neighbourhood of the best point. This returns a sentence (with a space before it) if
// the Jacobian has full rank and yet the data alone close no interval for some parameter, or if it shows no effect of a
// parameter that the data alone limit; otherwise it is empty.
std::string doubt_from_profiles(const Identifiability& identifiability, const std::vector<ProfileLikelihood>& profiles);

}  // namespace delabole
