// A slope cut by joints as a scene of dynamic relaxation: its blocks, its fixed boundaries, the water in its joints and
// the stages in which some of the blocks are removed.
//
// Free blocks come first, from the lowest centre up, then fixed blocks in the same order, then the frame. A neighbour's
// corner on a straight face is not a corner of the block itself, unless its material changes there. Water presses on a
// face in pieces, from each kink of the water table to the next (water_table.hpp).
#pragma once

#include "dynamic_relaxation/scene/relaxation_parameters.hpp"
#include "dynamic_relaxation/scene/scene.hpp"
#include "jointed_slope/jointed_section.hpp"

#include <cstddef>
#include <vector>

namespace delabole {

struct SlopeScene {
    SlopeCheck check = SlopeCheck::valid;
    std::size_t index_at_fault = 0;           // of the cut, the area or the stage at fault
    JointedSection section = {};              // without its vertices and blocks, which are in the scene
    std::vector<RelaxationBlock> block = {};  // materials: the slope's joints in their order
    std::vector<std::size_t> rock = {};       // of each block; for the frame: one past the last
    std::vector<FacePressure> pressure = {};
    std::vector<Removal> removal = {};
    double beside_frame = 0;  // m, of the outline's level or upright edges that face the frame but do not lie on it
};

SlopeScene slope_scene(const RelaxationSlope& slope);

}  // namespace delabole
