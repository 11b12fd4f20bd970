// How the stability of columns on a stepped base depends on geometry and on every input.
#pragma once

#include "fitting/posterior/fit_problem.hpp"
#include "limit_equilibrium/stepped_base/stepped_base.hpp"
#include "plots/figures/figures.hpp"

#include <string>
#include <vector>

namespace delabole {

struct GeometrySweep {
    std::string file;  // name of the figure
    std::string caption;
    Figure figure;
};

// Whether the analyses that follow can be afforded: columns and inputs are not too many.
bool can_sweep(const SteppedBase<>& problem, const ColumnSlope<>& slope);

// Factor of safety against base inclination, spacing and height, columns cut continuously beside classical ones; for
// blocks given one by one, against the dip of the joints. Then the limiting friction angle against base inclination for
// a few dips of the joints. Figures without an answer are left out. Curves are broken where
// they jump, except with more than 500 columns. Ends by Interrupted.
std::vector<GeometrySweep> geometry_sweeps(const SteppedBase<>& problem, double factor_of_safety);

// Change of the factor of safety by recalculation, the 15 largest. An input that cannot be raised is lowered instead.
// Fitted inputs are changed by one standard deviation of their priors.
std::vector<SensitivityBar> sensitivity_bars(const SteppedBase<>& problem, double factor_of_safety,
                                             const std::vector<FreeParameter>& fitted = {});

}  // namespace delabole
