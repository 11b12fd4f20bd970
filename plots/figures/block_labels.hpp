// Numbers of blocks, and the letter F of fixed blocks, in a drawing of them.
#pragma once

#include "plots/drawing/figure.hpp"
#include "plots/drawing/polygon.hpp"
#include "plots/figures/block_figures.hpp"

#include <vector>

namespace delabole {

constexpr double letter_width = 0.66;  // of the height of the text

// In the coordinates of the block's outline.
Point centroid_of(const DrawnBlock& block);

// Items that labels must not hide, besides outlines, and the frame within which labels beside a block stay.
struct DrawnAcrossBlocks {
    Polyline water = {};
    std::vector<Arrows::Shaft> arrows = {};
    std::vector<Arrows::Shaft> velocities = {};  // never hidden: a label that would hide one is left out
    Rectangle frame;
};

// A label stands inside its block, away from other drawn items, and is no larger than the block allows. A block that is
// too small for a label has none, unless most blocks are too small. A long thin fixed block, such as a base, has its
// label beside it, below if possible. If labels would overlap, only the first and every second, fifth, tenth, ...
// remain, and those of fixed blocks, the largest ones first; those that take most of their block are then left out, if
// few do.
std::vector<Label> block_labels(const std::vector<DrawnBlock>& blocks, const DrawnAcrossBlocks& across,
                                double metres_per_px);

}  // namespace delabole
