// How well a back-analysis knows the parameters of a mechanism: profiles, directions, correlations, minima.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "fitting/mechanism/fit_result.hpp"

namespace delabole {

// Folded, for the end of what the report says of the mechanism.
Folded knowledge_of(const MechanismFit& fit, const ResultFolder& folder);

}  // namespace delabole
