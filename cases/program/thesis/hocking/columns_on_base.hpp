// Columns on a plane or stepped base, as blocks for the re-created program.
#pragma once

#include "cases/program/thesis/hocking/hocking_program.hpp"

#include <vector>

namespace delabole {

// What the columns stand on. The listing's data has one fixed block below each column.
enum class HockingBase {
    block_below_each,  // corners of base blocks and of columns meet: contacts at the base are double
    one_block,         // of the whole row's length; needs a plane base
};

struct HockingColumns {
    std::vector<double> heights = {};  // m, from the toe uphill
    double width = 0;                  // m
    double gap = 0;                    // m, between columns; negative: they start with that overlap
    double step = 0;                   // m, from each base to the next, normal to the base
    double dip = 0;                    // rad, of the bases
    HockingBase base = HockingBase::block_below_each;
    double base_height = 0;      // m, of the fixed blocks
    int downhill_bases = 0;      // fixed blocks (one_block: widths) in front of the first column
    int uphill_bases = 0;        // and behind the last
    double coordinate_unit = 0;  // m, to which coordinates of centroids are rounded, as where they are typed; 0: exact
};

// Columns first, from the toe uphill, then the fixed blocks in the same order. The origin is the toe of the first
// column; but for
// rounding and gap they touch exactly.
std::vector<HockingBlock> make_blocks(const HockingColumns& columns);

}  // namespace delabole
