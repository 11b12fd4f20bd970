// Scenes of the limit equilibrium models for dynamic relaxation: a row of blocks on a plane, and columns on a stepped
// base.
//
// In both the x axis runs up-dip along the base, and gravity is tilted instead. Free blocks come first, from the toe
// up, then the fixed ones.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"

#include <vector>

namespace delabole {

inline Polygon<> upright_rectangle(double left, double bottom, double right, double top) {
    return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

struct StandingBlock {
    double width;           // m
    double height;          // m
    double step_above = 0;  // m, from its base up to the base of the next block
};

struct StandingBlocks {
    std::vector<StandingBlock> block;
    double density;           // kg/m3
    JointMaterial interface;  // between blocks
    JointMaterial base;       // below them
    double tilt;              // rad, of the base, towards -x
};

// All blocks stand on one fixed block, which extends three blocks' widths beyond the row on both sides; steps are
// ignored.
RelaxationScene row_scene(const StandingBlocks& blocks);

// Each column stands on its own fixed block, a step below the next one's; the lowest fixed block extends three widths
// in front of the toe. The risers are part of the base: a column that rotates leaves them.
RelaxationScene column_scene(const StandingBlocks& blocks);

// Stiffness k of a corner for which k width is `ratio` times the weight; ratios from 1e5 to 1e8 are practical.
double stiffness_of_ratio(double ratio, const StandingBlock& block, double density, double gravity);

}  // namespace delabole
