// The data for figures of a wedge, computed with the model.
#pragma once

#include "cases/program/results/model_reports.hpp"
#include "plots/figures/figures.hpp"
#include "plots/figures/stereonet.hpp"
#include "plots/figures/wedge_figure.hpp"
#include "wedge_failure/wedge_failure.hpp"

#include <optional>
#include <string>
#include <vector>

namespace delabole {

// Both functions need a problem whose check is valid.
WedgeDrawing wedge_drawing(const WedgeFailure& problem, const std::string& title);
WedgeNet wedge_net(const WedgeFailure& problem, const WedgeFailureResult& result);

// Factor of safety against the filled ratio of the fissures; nothing if the water is given in another form.
std::optional<WaterDepthCurves> filled_ratio_curve(const WedgeFailure& problem);

// Change of the factor of safety if one input is increased by the step of reports/sensitivity_step.hpp, or decreased by
// it if no wedge exists at the increased value. Inputs without effect are left out.
std::vector<SensitivityBar> sensitivity_bars(const WedgeFailure& problem, const InputDeviations& known);

}  // namespace delabole
