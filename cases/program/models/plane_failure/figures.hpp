// The data for figures of a plane failure, computed with the model.
#pragma once

#include "cases/program/results/model_reports.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/sensitivity.hpp"
#include "plots/figures/figures.hpp"

#include <optional>
#include <string>
#include <vector>

namespace delabole {

// The slope with failure plane, tension crack, water and the ground that a failure would leave standing.
SectionDrawing section_drawing(const PlaneFailure<>& problem, const std::string& title);
// Adds height, dips and the forces on the sliding mass.
void annotate(const PlaneFailure<>& problem, const PlaneFailureResult& result, SectionDrawing& drawing);

// Factor of safety against depth of water in the crack for several cohesions; nothing if the water has no level or the
// strength has no cohesion.
std::optional<WaterDepthCurves> water_depth_curves(const PlaneFailure<>& problem);

// Pairs of friction angle and cohesion at which the slope just fails, for several water levels (a single curve if the
// water has no level).
FailureLoci failure_loci(const PlaneFailure<>& problem);

// First-order change of the factor of safety, each input changed by the step of reports/sensitivity_step.hpp.
std::vector<SensitivityBar> sensitivity_bars(const PlaneFailure<>& problem, const SensitivityResult& sensitivities,
                                             const InputDeviations& known);

// Factor of safety against plane dip, with the tension crack at its critical position for each dip and the critical
// plane marked. `best` is the result of the study's search.
std::optional<CriticalSearchDrawing> critical_plane_drawing(const PlaneFailureStudy<>& study,
                                                            const ResolvedStudy& best);

}  // namespace delabole
