// Vertices on straight edges of blocks.
//
// Springs stand at corners: a block drawn with a further vertex on an edge would be held by one more of them, though it
// is the same block. A vertex at which neither the edge's direction nor its joint changes is therefore left out.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"

namespace delabole {

// Whether an outline goes on through a vertex without a turn, but for rounding.
bool goes_straight_on(const PlanePoint<>& before, const PlanePoint<>& at, const PlanePoint<>& after);

// Leaves out such vertices of all blocks; pressures stay where they press. For scenes without bonds. Outlines that are
// no polygons stay as they are.
void leave_out_straight_vertices(RelaxationScene& scene);

}  // namespace delabole
