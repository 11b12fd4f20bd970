#include "cases/program/reports/sensitivity_step.hpp"

#include "fitting/work/words.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

SensitivityStep sensitivity_step(Dimension dimension, double value, double slope_height, double overburden) {
    const auto step = [&](double size) { return SensitivityStep{size, "+" + value_in_words(size, dimension)}; };
    switch (dimension) {
    case Dimension::angle:
        return step(degrees(1));
    case Dimension::ratio:
        return step(0.05);
    case Dimension::length:
        return step(0.02 * slope_height);
    case Dimension::stress:
        return step(0.02 * overburden);
    default:
        return {0.02 * std::abs(value), "+2 %"};
    }
}

SensitivityStep sensitivity_step(std::string_view input, const std::vector<FreeParameter>& fitted, Dimension dimension,
                                 double value, double slope_height, double overburden) {
    const auto known = std::ranges::find(fitted, input, &FreeParameter::name);
    if (known == fitted.end() || !known->prior) {
        return sensitivity_step(dimension, value, slope_height, overburden);
    }
    const double spread = known->prior->standard_deviation;
    return {spread, "+" + value_in_words(spread, dimension)};
}

}  // namespace delabole
