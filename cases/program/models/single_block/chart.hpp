// Ashby's chart of a single block, static and dynamic.
#pragma once

#include "plots/figures/block_figures.hpp"

#include <string>

namespace delabole {

enum class BlockCriteria { superposed_static, onset_of_motion };

// Modes of a dry block over the inclination of the base (0 to 90 deg) and its slenderness angle atan(width / height),
// for one angle of friction.
ModeChart single_block_chart(double friction_angle, BlockCriteria criteria, const std::string& title);

}  // namespace delabole
