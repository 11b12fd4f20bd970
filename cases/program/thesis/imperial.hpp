// Units of the thesis's models and quarry.
#pragma once

namespace delabole {

inline constexpr double inch = 0.0254;  // m
inline constexpr double foot = 0.3048;

}  // namespace delabole
