// The section of a slope cut by joints, and what the cutting did.
#pragma once

#include "cases/program/results/analysis.hpp"
#include "cases/program/results/result_folder.hpp"
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "plots/report/report.hpp"

namespace delabole {

// Cuts that divided nothing, and divisions of intact rock.
void append_cutting_warnings(const RelaxationSlope& slope, const JointedSection& section, Analysis& analysis);

// Blocks shaded by rock with the water table, and the table of cuts.
void append_section_figure(const RelaxationSlope& slope, const SlopeScene& made, const ResultFolder& folder,
                           Report& report);

}  // namespace delabole
