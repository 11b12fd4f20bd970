// Water between two blocks whose faces lie on each other in the initial geometry.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"

#include <cstddef>
#include <vector>

namespace delabole {

struct JointWater {
    std::size_t block;
    std::size_t other;
    double at_first;   // Pa, at least 0; at the end of what they share that comes first anticlockwise round the block
    double at_second;  // Pa, at least 0; at its other end, linear between
};

// Pressures on both, equal and opposite along one line in the initial geometry; later each goes with its own face. Two
// for each pair of edges: a straight face may have corners. Empty where the blocks share no face.
std::vector<FacePressure> pressures_of(const JointWater& water, const Bodies& bodies);

}  // namespace delabole
