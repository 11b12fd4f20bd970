// Greatest allowed length: 1000 km, far beyond any slope.
//
// Closed forms hold at any scale, but linear programming loses small blocks beside huge ones (greatest_weight_ratio in
// assembly.hpp), numbers of columns and areas lose their meaning, and an absurd length is an error of the unit.
#pragma once

#include "parameters/fields.hpp"

namespace delabole {

inline constexpr double longest_length = 1e6;  // m

// Allowed lengths of bodies, which are more than 0.
constexpr Interval extent_range() {
    return left_open(0, longest_length);
}
// Allowed lengths that may be 0.
constexpr Interval distance_range() {
    return within(0, longest_length);
}
// Coordinates, elevations and distances to either side.
constexpr Interval position_range() {
    return within(-longest_length, longest_length);
}

}  // namespace delabole
