// The step by which an input is changed for a bar of a tornado figure.
#pragma once

#include "parameters/fields.hpp"

#include <string>

namespace delabole {

struct SensitivityStep {
    double size;  // SI
    std::string words;
};

// 1 deg of an angle, 0.05 of a ratio, a length of 2 % of the slope height, a stress of 2 % of the overburden, 2 % of
// anything else. Lengths and stresses are compared with the slope and not with themselves: 5 % of an elevation, or of
// no cohesion, says nothing.
SensitivityStep sensitivity_step(Dimension dimension, double value, double slope_height, double overburden);

}  // namespace delabole
