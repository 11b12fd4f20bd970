// A slope cut by joints as a scene of dynamic relaxation: its blocks, what holds them, the water in their joints and
// the stages in which some of them are taken away.
//
// Free blocks come first, from the lowest centre up, then fixed ones likewise, then the frame. A corner of a neighbour
// on a straight face is no corner of the block itself, unless what it is made of changes there. Water presses on a face
// in pieces, from each kink of the water table to the next (water_table.hpp).
#pragma once

#include "dynamic_relaxation/scene/relaxation_parameters.hpp"
#include "dynamic_relaxation/scene/scene.hpp"
#include "jointed_slope/jointed_section.hpp"

#include <cstddef>
#include <vector>

namespace delabole {

struct SlopeScene {
    SlopeCheck check = SlopeCheck::valid;
    std::size_t index_at_fault = 0;           // of the cut, the area or the stage that the check concerns
    JointedSection section = {};              // without its vertices and blocks, which the scene holds
    std::vector<RelaxationBlock> block = {};  // materials: the slope's joints in their order
    std::vector<std::size_t> rock = {};       // of each block; the frame's: one past the last
    std::vector<FacePressure> pressure = {};
    std::vector<Removal> removal = {};
};

SlopeScene slope_scene(const RelaxationSlope& slope);

}  // namespace delabole
