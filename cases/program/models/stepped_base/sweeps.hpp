// How the stability of columns on a stepped base depends on the geometry and on each input.
#pragma once

#include "cases/program/results/model_reports.hpp"
#include "limit_equilibrium/stepped_base/stepped_base.hpp"
#include "plots/figures/figures.hpp"

#include <string>
#include <vector>

namespace delabole {

// The number of that name among the inputs; null if there is none.
double* find_input(SteppedBase<>& problem, const std::string& name);

struct GeometrySweep {
    std::string file;  // name of the figure
    std::string caption;
    Figure figure;
};

// Whether columns and inputs are few enough for the analyses below.
bool can_sweep(const SteppedBase<>& problem, const ColumnSlope<>& slope);

// Factor of safety against base inclination, spacing and height, for columns cut continuously and for classical ones;
// for blocks given one by one, against the dip of the joints. Then the limiting friction angle against base inclination
// for several dips of the joints. Figures without an answer are left out. Curves are interrupted where they jump,
// except with more than 500 columns. Throws Interrupted.
std::vector<GeometrySweep> geometry_sweeps(const SteppedBase<>& problem, double factor_of_safety);

// Change of the factor of safety when it is computed again with each input changed by the step of
// reports/sensitivity_step.hpp. An input that cannot be increased is decreased instead.
std::vector<SensitivityBar> sensitivity_bars(const SteppedBase<>& problem, double factor_of_safety,
                                             const InputDeviations& known);

}  // namespace delabole
