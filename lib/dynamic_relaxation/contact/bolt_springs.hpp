// The spring of a bolt, or of a grouted one where it crosses a joint, in a state of its two blocks (scene/bolts.hpp).
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/scene/scene.hpp"

#include <vector>

namespace delabole {

// Extension of a segment of a bolt at its installation, and its yield since.
struct BoltMemory {
    double extension_at_start = 0;  // m
    double yielded = 0;             // m
};

struct BoltPosition {
    double extension;      // m, since the initial geometry
    PlanePoint<> towards;  // unit vector from the block to the other
    double arm_x;          // of its end on the block, about the block's centroid, in its present rotation
    double arm_y;
    double other_arm_x;
    double other_arm_y;

    PlanePoint<> arm() const { return {arm_x, arm_y}; }
    PlanePoint<> other_arm() const { return {other_arm_x, other_arm_y}; }
};

BoltPosition locate(const BoltSegment& segment, const Bodies& bodies, const std::vector<Motion>& motion);

// Tension, N/m, from 0 to the capacity, after such an extension.
double force_of(const BoltSegment& segment, const BoltMemory& memory, double extension);

// Whether both blocks are there.
bool holds(const BoltSegment& segment, const std::vector<char>& removed);

}  // namespace delabole
