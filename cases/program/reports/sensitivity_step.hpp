// The step by which an input is changed for a bar of a tornado figure.
#pragma once

#include "fitting/posterior/fit_problem.hpp"
#include "parameters/fields.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

struct SensitivityStep {
    double size;  // SI
    std::string words;
};

// 1 deg for an angle, 0.05 for a ratio, 2 % of the slope height for a length, 2 % of the overburden for a stress, 2 %
// of the value for anything else. Lengths and stresses are compared with the slope, because a percentage of an
// elevation, or of a cohesion of zero, has no meaning.
SensitivityStep sensitivity_step(Dimension dimension, double value, double slope_height, double overburden);

// The standard deviation of its prior if a fit leaves the input free; otherwise the step above.
SensitivityStep sensitivity_step(std::string_view input, const std::vector<FreeParameter>& fitted, Dimension dimension,
                                 double value, double slope_height, double overburden);

}  // namespace delabole
