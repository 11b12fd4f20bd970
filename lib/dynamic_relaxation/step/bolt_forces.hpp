// What bolts do in a step. Their work is among that of the loads in the energy balance.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/step/outcome.hpp"
#include "dynamic_relaxation/step/state.hpp"

#include <vector>

namespace delabole {

// The bolts are put in as the blocks are now: from here on they stretch, beginning with their pretension.
void put_in_bolts(const RelaxationScene& scene, const Bodies& bodies, RelaxationState& state);

// Adds their forces to the loads and notes what has yielded. Bolts of blocks that are gone pull no more.
void add_bolt_forces(const RelaxationScene& scene, const Bodies& bodies, RelaxationState& state,
                     std::vector<BlockForce>& load);

// s, beyond which bolts alone would make blocks swing ever farther; infinite without bolts.
double stable_step_of_bolts(const RelaxationScene& scene, const Bodies& bodies);

// A segment as it is now, in the frame of the initial geometry.
struct BoltPull {
    PlanePoint<> at = {0, 0};
    PlanePoint<> other_at = {0, 0};
    double force = 0;    // N/m
    double yielded = 0;  // m, by which it has stretched for good
    bool holds = false;  // false: one of its blocks is gone, and it does not pull
};

// In the order of the scene's segments.
std::vector<BoltPull> bolt_pulls(const RelaxationScene& scene, const Bodies& bodies, const RelaxationState& state);

// Of each bolt, the segment that pulls most.
std::vector<BoltOutcome> bolt_outcomes(const RelaxationScene& scene, const std::vector<BoltPull>& pulls);

}  // namespace delabole
