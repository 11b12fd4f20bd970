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
    double derivative;  // dFS / dp, per SI unit; at a kink of FS, the derivative on the side of the input
};

struct SensitivityResult {
    PlaneFailureCheck check;
    double factor_of_safety;
    std::vector<Sensitivity> derivatives;  // empty if not valid
};

// Exact means that no step is involved; rounding remains. With a plane within an angle g of the face, terms of the
// order of 1 / g cancel in the derivatives with respect to those two dips and leave an error of about 1e-16 / g of the
// largest term (1e-16 / (g cos^2 f) for a nearly vertical face f).
//
// Inputs that only locate a moment (bolt heads) have derivative 0, because they do not enter FS.
SensitivityResult sensitivities(const PlaneFailure<>& problem);

}  // namespace delabole
