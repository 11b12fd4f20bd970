// The drawing of a row of blocks in one of its modes.
#pragma once

#include "limit_equilibrium/block_row/block_row.hpp"
#include "plots/figures/block_figures.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

DrawnMode drawn_role(char role);

// Blocks at a tilt, coloured by their roles, with the forces of the mode and the blocks after a turn. A mode without a
// motion, which is only the limit of pressed blocks, shows none. `forces` may be empty.
BlockDrawing row_drawing(const BlockRow& row, std::string_view roles, double tilt,
                         const std::vector<RowBlockForces>& forces, const std::string& title, double turn = degrees(5));

}  // namespace delabole
