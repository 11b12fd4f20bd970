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

// 1 deg of an angle, 0.05 of a ratio, a length of 2 % of the slope height, a stress of 2 % of the overburden, 2 % of
// anything else. Lengths and stresses are compared with the slope and not with themselves: 5 % of an elevation, or of
// no cohesion, says nothing.
SensitivityStep sensitivity_step(Dimension dimension, double value, double slope_height, double overburden);

// The standard deviation of its prior, where the input is one that a fit leaves free; otherwise the step above.
SensitivityStep sensitivity_step(std::string_view input, const std::vector<FreeParameter>& fitted, Dimension dimension,
                                 double value, double slope_height, double overburden);

}  // namespace delabole
