// Mechanisms weighed against each other by their evidence, all equally likely beforehand.
#pragma once

#include "fitting/mechanism/fit_result.hpp"

#include <span>
#include <vector>

namespace delabole {

struct MechanismWeight {
    double log_bayes_factor;  // evidence over the best mechanism's, natural logarithm; -infinity without evidence
    double probability;       // of the mechanism, given that one of them is true
    double standard_error;    // of the probability, from the errors of all evidences
};

struct LogEvidence {
    double value;  // -infinity: the evidence is zero
    double standard_error;
};

// Weight of every mechanism that was sampled, in the order of the result; probability 0 for the others.
std::vector<MechanismWeight> weigh(const FitResult& result);

// Weights in the order given. Without any evidence all have probability 0.
std::vector<MechanismWeight> weigh(std::span<const LogEvidence> mechanisms);

}  // namespace delabole
