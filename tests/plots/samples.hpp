// Figures and a report with the numbers of a real slope, for tests and for inspection.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "plots/figures/block_figures.hpp"
#include "plots/figures/figures.hpp"
#include "plots/figures/stereonet.hpp"
#include "plots/figures/wedge_figure.hpp"
#include "plots/report/animation.hpp"
#include "plots/report/report.hpp"

#include <string>
#include <utility>
#include <vector>

namespace delabole::samples {

// Hoek & Bray's plane failure for H = 225 ft, face 70 deg, plane 40 deg, crack base 75 ft above the toe.
double factor_of_safety(double cohesion, double friction_angle, double water_ratio);

SectionDrawing section();
StereonetDrawing stereonet();
StereonetDrawing measured_stereonet();
WedgeDrawing wedge();
WaterDepthCurves water_depth_curves();
FailureLoci failure_loci();
MechanismFit mechanism_fit();
std::vector<SensitivityBar> sensitivities();
CriticalSearchDrawing critical_dip();
CriticalSearchDrawing critical_crack();

// Goodman & Bray (1976): 16 blocks on a stepped base, tan(friction angle) 0.7855, with the forces that they print.
ForceAlongSlope goodman_bray_forces();
BlockDrawing goodman_bray_blocks();
// The blocks of a displaced mechanism with water and a crack.
BlockDrawing stepped_base();
BlockDrawing single_block();
BlockDrawing row_of_columns(int count);
// The chart of a block with atan(width / height) = 18.435 deg on an inclined plane.
ModeChart mode_chart();

// Two columns that topple over a fixed base, sixty frames to 2.95 s.
BlockAnimation animation();

// Every kind of figure, with the name of its file.
std::vector<std::pair<std::string, Figure>> figures();

Report report(const std::vector<FigureFiles>& drawn);

}  // namespace delabole::samples
