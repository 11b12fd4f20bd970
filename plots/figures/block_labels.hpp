// Numbers of blocks, and the F of fixed ones, in a drawing of them.
#pragma once

#include "plots/drawing/figure.hpp"
#include "plots/drawing/polygon.hpp"
#include "plots/figures/block_figures.hpp"

#include <vector>

namespace delabole {

constexpr double letter_width = 0.66;  // of the height of the text

// Positions in the units of the blocks' outlines.
Point centroid_of(const DrawnBlock& block);

// Things that labels keep clear of besides outlines, and the frame that those beside a block stay in.
struct DrawnAcrossBlocks {
    Polyline water = {};
    std::vector<Arrows::Shaft> arrows = {};
    std::vector<Arrows::Shaft> velocities = {};  // never covered: rather no label
    Rectangle frame;
};

// A label is in its block, off what is drawn across it, and no larger than the block has room for; a block too small
// for any goes without, unless most are. A long fixed block, as a thin base is, has its label beside it then, below if
// possible. Where labels would run into each other, every second, fifth, tenth, ... is left, always with the first, and
// with those of fixed blocks, the largest ones first.
std::vector<Label> block_labels(const std::vector<DrawnBlock>& blocks, const DrawnAcrossBlocks& across,
                                double metres_per_px);

}  // namespace delabole
