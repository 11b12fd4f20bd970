// Values that are not numbers, which models give for outputs without a value.
#pragma once

#include <limits>

namespace delabole {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace delabole
