// Scenes of the limit equilibrium models, for dynamic relaxation: a row of blocks on a plane, columns on a stepped
// base.
//
// Both are drawn along their base, x up-dip, with gravity tilted instead. Free blocks come first, from the toe up, then
// the fixed ones.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"

#include <vector>

namespace delabole {

struct StandingBlock {
    double width;           // m
    double height;          // m
    double step_above = 0;  // m, from its base up to that of the next block
};

struct StandingBlocks {
    std::vector<StandingBlock> block;
    double density;           // kg/m3
    JointMaterial interface;  // between blocks
    JointMaterial base;       // below them
    double tilt;              // rad, of the base, towards -x
};

// All on one fixed block, which reaches three blocks' widths beyond the row on both sides; steps are ignored.
RelaxationScene row_scene(const StandingBlocks& blocks);

// Each on its own fixed block, whose upper side the next column stands above by the step; the lowest one reaches three
// widths out before the toe. The risers are part of the base: a column that turns leaves them.
RelaxationScene column_scene(const StandingBlocks& blocks);

// Stiffness k of a corner with k width = ratio times the weight: ratios of 1e5 to 1e8 are of use.
double stiffness_of_ratio(double ratio, const StandingBlock& block, double density, double gravity);

}  // namespace delabole
