// Water between two blocks whose faces lie on each other in the initial geometry.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"

#include <cstddef>
#include <vector>

namespace delabole {

struct JointWater {
    std::size_t block;
    std::size_t other;
    double at_first;   // Pa, at least 0; at the end of the shared length that comes first anticlockwise round the block
    double at_second;  // Pa, at least 0; at its other end, with a linear variation between
};

// Pressures on both blocks, equal and opposite along one line in the initial geometry; later each moves with its own
// face. There are two for each pair of edges: a straight face may have corners. Empty where the blocks share no face.
std::vector<FacePressure> pressures_of(const JointWater& water, const Bodies& bodies);

}  // namespace delabole
