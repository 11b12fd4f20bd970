// Numbers that many formulas need.
#pragma once

#include <limits>
#include <numbers>

namespace delabole {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double right_angle = std::numbers::pi / 2;  // rad

}  // namespace delabole
