// Singular values in plain words.
#pragma once

#include "fitting/mechanism/fit_result.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace delabole {

// A verdict in words needs this beyond the numbers, for the parameters named in Identifiability.
struct VerdictQuestion {
    std::vector<Dimension> dimensions;
    Eigen::VectorXd ranges;  // upper - lower, SI
    bool has_priors = false;
    bool only_failure_observed = false;  // the data are one FS = 1
};

// Sentences, in this order: doubt about the numbers, parameters that nothing observed depends on, parameters that the
// data determine, combinations where only those are determined (with the exchange rate along the null direction, in
// display units), and what the priors add.
std::string verdict(const Identifiability& identifiability, const VerdictQuestion& question);

// Whether what the data say of a free parameter is worth nothing: the run at the best point contradicts the surrogate,
// or the best fit misses data that the parameter moves by more than four standard deviations.
bool in_doubt(const Identifiability& identifiability, const std::string& parameter);

// A Jacobian sees only the neighbourhood of the best point. A sentence (with a space before it) where it has full rank
// and yet the data alone close no interval for some parameter, or where it sees no effect of a parameter that the data
// alone limit all the same; empty otherwise.
std::string doubt_from_profiles(const Identifiability& identifiability, const std::vector<ProfileLikelihood>& profiles);

}  // namespace delabole
