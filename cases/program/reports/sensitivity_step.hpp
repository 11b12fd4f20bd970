// The step by which an input is changed for a bar of a tornado figure.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/model_reports.hpp"
#include "plots/figures/figures.hpp"

#include <string>
#include <vector>

namespace delabole {

struct SensitivityStep {
    double size;  // SI
    std::string words;
    bool by_rule;  // not a standard deviation
};

// The standard deviation of the input if it is known. Otherwise 1 deg for an angle, 0.05 for a ratio, 2 % of the slope
// height for a length, 2 % of the overburden for a stress, 2 % of the value for anything else. Lengths and stresses are
// compared with the slope, because a percentage of an elevation, or of a cohesion of zero, has no meaning.
SensitivityStep sensitivity_step(const std::string& input, const InputDeviations& known, Dimension dimension,
                                 double value, double slope_height, double overburden);

InputDeviations deviations_of(const std::vector<FreeParameter>& fitted);
// Those of the priors in [fit] and of the distributions in [sensitivity]; 0 for an input that [support_design] chooses,
// because it is decided and not uncertain.
InputDeviations deviations_of(const CaseFile& file);

// A sentence for the caption of a tornado figure; empty if no deviation is known.
std::string deviations_in_words(const InputDeviations& known);

}  // namespace delabole
