// The step by which an input is changed for a bar of a tornado figure, and the bars of a model computed again.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/model_reports.hpp"
#include "plots/figures/figures.hpp"

#include <cmath>
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

// Change of the factor of safety from the given one if one input is increased by its step, or decreased by it if there
// is no factor at the increased value: factor(varied, whether the changed input is within its range) is then not
// finite. Inputs without effect are left out.
template <class Problem, class Factor>
std::vector<SensitivityBar> recalculated_bars(Problem varied, double given, double slope_height, double overburden,
                                              const InputDeviations& known, const Factor& factor) {
    std::vector<SensitivityBar> bars;
    for_each_named_number(varied, [&](const std::string& path, const FieldInfo& info, double& input) {
        const double value = input;
        const SensitivityStep step = sensitivity_step(path, known, info.dimension, value, slope_height, overburden);
        const auto change_at = [&](double changed) {
            input = changed;
            const double change = factor(varied, info.range.contains(changed)) - given;
            input = value;
            return change;
        };
        const double upwards = change_at(value + step.size);
        const double effect = std::isfinite(upwards) ? upwards : -change_at(value - step.size);
        if (std::isfinite(effect) && effect != 0) {
            bars.push_back({path, step.words, effect, step.by_rule && !known.empty()});
        }
    });
    return bars;
}

InputDeviations deviations_of(const std::vector<FreeParameter>& fitted);
// Those of the priors in [fit] and of the distributions in [sensitivity]; 0 for an input that [support_design] chooses,
// because it is decided and not uncertain.
InputDeviations deviations_of(const CaseFile& file);

// A sentence for the caption of a tornado figure; empty if no deviation is known.
std::string deviations_in_words(const InputDeviations& known);

}  // namespace delabole
