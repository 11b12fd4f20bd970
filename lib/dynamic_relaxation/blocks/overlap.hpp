// Overlap of blocks, independent of their contacts: the area that two convex polygons have in common. Springs that
// carry load leave overlaps far below the size of a block; a larger overlap means that a contact was missed, or that a
// joint is too soft for the speed at which blocks meet.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace delabole {

struct BlockOverlap {
    std::uint64_t block = 0;
    std::uint64_t other = 0;
    double depth = 0;  // m, penetration depth: least displacement that separates the two
    double share = 0;  // depth over the shortest edge of the two
    double area = 0;   // m2, common to both; exact up to rounding
};

// The pair with the greatest share among those of which at least one is free and none is removed; absent where no
// blocks overlap.
std::optional<BlockOverlap> greatest_overlap(const Bodies& bodies, const std::vector<Motion>& motion,
                                             const std::vector<char>& removed);

}  // namespace delabole
