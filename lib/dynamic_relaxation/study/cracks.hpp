// Cracks of a run with bonds: broken rock and open joints.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"
#include "dynamic_relaxation/step/state.hpp"

#include <cstddef>
#include <vector>

namespace delabole {

struct BrokenBond {
    std::size_t block;  // the block whose face broke
    double time;        // s
    // The face's ends in the initial geometry; it moves with the block.
    PlanePoint<> from;
    PlanePoint<> to;
};

// The bonds of rock that broke, in the order of the scene's bonds, without those whose blocks were removed.
std::vector<BrokenBond> broken_bonds(const RelaxationScene& scene, const Bodies& bodies, const RelaxationState& state);

// A joint whose faces, in contact initially, have separated by more than `least`, m, somewhere along them and still lie
// side by side. Stored is the face of one of the blocks, in the frame of the initial geometry, after its motion. Faces
// with a bond of rock, whole or broken, and those of fixed blocks are left out.
struct OpenJoint {
    PlanePoint<> from;
    PlanePoint<> to;
    double opening;  // m, greatest opening along the faces
};

std::vector<OpenJoint> open_joints(const RelaxationScene& scene, const Bodies& bodies, const RelaxationState& state,
                                   double least);

// Present position of a point of the initial geometry that moves with a block.
PlanePoint<> carried(const Bodies& bodies, const std::vector<Motion>& motion, std::size_t block,
                     const PlanePoint<>& point);

}  // namespace delabole
