// Singular values in plain words.
#pragma once

#include "fitting/fit_result.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace delabole {

// What the words need beyond the numbers, for the parameters named in Identifiability.
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

// A Jacobian sees only the neighbourhood of the best point. Where it has full rank and yet the data alone close no
// interval for some parameter, a sentence that says so (with a space before it); empty otherwise.
std::string doubt_from_profiles(const Identifiability& identifiability, const std::vector<ProfileLikelihood>& profiles);

}  // namespace delabole
