// Forces of bolts in a step. The energy balance counts their work among that of the loads.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/step/outcome.hpp"
#include "dynamic_relaxation/step/state.hpp"

#include <vector>

namespace delabole {

// Installs the bolts with the blocks as they are now: from here on they stretch, beginning with their pretension.
void put_in_bolts(const RelaxationScene& scene, const Bodies& bodies, RelaxationState& state);

// Adds the forces of bolts to the loads and records yield. Bolts of removed blocks carry no force.
void add_bolt_forces(const RelaxationScene& scene, const Bodies& bodies, RelaxationState& state,
                     std::vector<BlockForce>& load);

// Greatest stable step, s, of blocks held by bolts alone; infinite without bolts.
double stable_step_of_bolts(const RelaxationScene& scene, const Bodies& bodies);

// The present state of a segment, in the frame of the initial geometry.
struct BoltPull {
    PlanePoint<> at = {0, 0};
    PlanePoint<> other_at = {0, 0};
    double force = 0;    // N/m
    double yielded = 0;  // m, plastic extension
    bool holds = false;  // false: one of its blocks has been removed, and it carries no force
};

// Pulls in the order of the scene's segments.
std::vector<BoltPull> bolt_pulls(const RelaxationScene& scene, const Bodies& bodies, const RelaxationState& state);

// For each bolt, the segment with the greatest force.
std::vector<BoltOutcome> bolt_outcomes(const RelaxationScene& scene, const std::vector<BoltPull>& pulls);

}  // namespace delabole
