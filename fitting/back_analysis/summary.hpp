// A summary of what a mechanism explains at its best point, and what it cannot.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "fitting/mechanism/misfit.hpp"
#include "fitting/mechanism/surrogate.hpp"

namespace delabole {

// Fills in everything of `fit` that follows from `fit.best`: misfit parts, prediction, observations, profile distance,
// explained and unexplained evidence, ranking score. The misfit is that of the surrogate where there is one; the rest
// comes from the model. `found`: there is a best point.
void summarise(const Misfit& misfit, const Surrogate* surrogate, bool found, MechanismFit& fit);

}  // namespace delabole
