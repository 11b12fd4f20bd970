// Exact derivatives of the factor of safety with respect to every input, by forward differentiation of the same code.
#pragma once

#include "plane_failure/check.hpp"
#include "plane_failure/parameters.hpp"

#include <string>
#include <vector>

namespace delabole {

struct Sensitivity {
    std::string parameter;
    Dimension dimension;
    double value;       // SI
    double derivative;  // dFS / dp, per SI unit; where FS has a kink, that of the side on which the input lies
};

struct SensitivityResult {
    PlaneFailureCheck check;
    double factor_of_safety;
    std::vector<Sensitivity> derivatives;  // empty where not valid
};

// Exact means without a step: rounding remains. With a plane within an angle g of the face, terms of the order of 1 / g
// cancel in the derivatives with respect to those two dips and leave an error of about 1e-16 / g of the largest (1e-16
// / (g cos^2 f) for a nearly vertical face f).
//
// Inputs that only locate a moment (bolt heads) have derivative 0: they do not enter FS.
SensitivityResult sensitivities(const PlaneFailure<>& problem);

}  // namespace delabole
