// Cracks of a run with bonds: where rock has broken, and which joints stand open.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"
#include "dynamic_relaxation/step/state.hpp"

#include <cstddef>
#include <vector>

namespace delabole {

struct BrokenBond {
    std::size_t block;  // whose face it was
    double time;        // s
    // The face's ends in the initial geometry; it goes where the block goes.
    PlanePoint<> from;
    PlanePoint<> to;
};

// The bonds of rock that broke, in the order of the scene's bonds; not those whose blocks were taken away.
std::vector<BrokenBond> broken_bonds(const RelaxationScene& scene, const Bodies& bodies, const RelaxationState& state);

// Where faces that lay on each other have parted by more than `least`, m, somewhere along them, and still lie side by
// side: the face of one of the blocks, in the frame of the initial geometry, moved. Faces with a bond of rock, whole or
// broken, and those of fixed blocks are left out.
struct OpenJoint {
    PlanePoint<> from;
    PlanePoint<> to;
    double opening;  // m, at its widest
};

std::vector<OpenJoint> open_joints(const RelaxationScene& scene, const Bodies& bodies, const RelaxationState& state,
                                   double least);

// A line in the initial geometry that goes with a block.
PlanePoint<> carried(const Bodies& bodies, const std::vector<Motion>& motion, std::size_t block,
                     const PlanePoint<>& point);

}  // namespace delabole
