// Searches for the critical geometry with the water that the slope has.
#pragma once

#include "plane_failure/critical.hpp"

namespace delabole {

inline constexpr CriticalSearch<> crack_search = {CriticalFeature::tension_crack, SearchCondition::given_water, {}, {}};
inline constexpr CriticalSearch<> plane_search = {CriticalFeature::failure_plane, SearchCondition::given_water, {}, {}};

}  // namespace delabole
