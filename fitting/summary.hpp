// What a mechanism explains at its best point, and what it cannot.
#pragma once

#include "fitting/fit_result.hpp"
#include "fitting/misfit.hpp"

namespace delabole {

// Fills in everything of `fit` that follows from `fit.best`: misfit parts, prediction, observations, profile distance,
// explained and unexplained evidence, ranking score.
void summarise(const Misfit& misfit, bool found, MechanismFit& fit);

}  // namespace delabole
