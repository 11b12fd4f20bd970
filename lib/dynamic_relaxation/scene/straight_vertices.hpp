// Vertices on straight edges of blocks.
//
// Springs act at corners: a further vertex on an edge would give a block one more spring, although it is the same
// block. A vertex at which neither the edge's direction nor its joint changes is therefore left out.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"

namespace delabole {

// Whether an outline is straight at a vertex, except for rounding.
bool goes_straight_on(const PlanePoint<>& before, const PlanePoint<>& at, const PlanePoint<>& after);

// Leaves out such vertices of all blocks; pressures keep their places. For scenes without bonds. Outlines that are not
// polygons stay as they are.
void leave_out_straight_vertices(RelaxationScene& scene);

}  // namespace delabole
