// The section of a slope cut by joints, and the result of the cutting.
#pragma once

#include "cases/program/results/analysis.hpp"
#include "cases/program/results/result_folder.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "plots/report/report.hpp"

namespace delabole {

// Warns of cuts that divided nothing and of intact rock that had to be divided.
void append_cutting_warnings(const RelaxationSlope& slope, const SlopeScene& made, Analysis& analysis);

// Figure of the blocks shaded by rock with the water table, and the table of cuts.
void append_section_figure(const RelaxationSlope& slope, const SlopeScene& made, const ResultFolder& folder,
                           Report& report);

}  // namespace delabole
