// Pairs of blocks near enough to touch, through a uniform grid.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace delabole {

using BlockPair = std::pair<std::uint32_t, std::uint32_t>;  // lower number first

// All pairs whose bounding boxes, drawn out on every side by the `reach` of each block, overlap; at least one of them
// free, none removed. Where blocks are crowded, some pairs that are farther apart than their reaches are left out. In
// increasing order, so that nothing depends on how the grid lies.
std::vector<BlockPair> neighbouring_blocks(const Bodies& bodies, const std::vector<Motion>& motion,
                                           const std::vector<char>& removed, const std::vector<double>& reach);

}  // namespace delabole
