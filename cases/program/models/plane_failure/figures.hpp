// The data of plane-failure figures, from the model.
#pragma once

#include "fitting/posterior/fit_problem.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/sensitivity.hpp"
#include "plots/figures/figures.hpp"

#include <optional>
#include <string>
#include <vector>

namespace delabole {

// The slope with plane, crack, water and what a failure would leave standing.
SectionDrawing section_drawing(const PlaneFailure<>& problem, const std::string& title);
// Height, dips and the forces on what slides.
void annotate(const PlaneFailure<>& problem, const PlaneFailureResult& result, SectionDrawing& drawing);

// Factor of safety against depth of water in the crack for a few cohesions; nothing where no water form has a level or
// the strength has no cohesion.
std::optional<WaterDepthCurves> water_depth_curves(const PlaneFailure<>& problem);

// Pairs of friction and cohesion at which the slope just fails, for a few water levels (one, where the water has none).
FailureLoci failure_loci(const PlaneFailure<>& problem);

// Change of the factor of safety to first order, for 1 deg of an angle, 0.05 of a ratio, a length of 2 % of the slope
// height, a stress of 2 % of unit weight times height, and 2 % of any force or unit weight.
// Each input changed by one standard deviation of what was known of it, where it is among the fitted, otherwise by as
// much as is usual (sensitivity_step.hpp).
std::vector<SensitivityBar> sensitivity_bars(const PlaneFailure<>& problem, const SensitivityResult& sensitivities,
                                             const std::vector<FreeParameter>& fitted = {});

// Factor of safety against plane dip, the crack at its critical place for each, with the critical plane marked.
// `best` is what the study's search has found.
std::optional<CriticalSearchDrawing> critical_plane_drawing(const PlaneFailureStudy<>& study,
                                                            const ResolvedStudy& best);

}  // namespace delabole
