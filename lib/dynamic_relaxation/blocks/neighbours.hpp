// Pairs of blocks near enough to touch, through a uniform grid.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace delabole {

using BlockPair = std::pair<std::uint32_t, std::uint32_t>;  // lower number first

// All pairs whose bounding boxes, extended on every side by the `reach` of each block, overlap; at least one of the two
// is free, and none is removed. Some pairs that are farther apart than their reaches are left out, above all among
// crowded blocks. The order is increasing, so that nothing depends on the position of the grid.
std::vector<BlockPair> neighbouring_blocks(const Bodies& bodies, const std::vector<Motion>& motion,
                                           const std::vector<char>& removed, const std::vector<double>& reach);

}  // namespace delabole
