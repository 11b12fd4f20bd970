// Strength of a stepped surface.
#pragma once

#include "limit_equilibrium/stepped_path/stepped_path_parameters.hpp"

#include <cmath>

namespace delabole {

// The strength of joint and rock bridges together.
struct SurfaceStrength {
    double step_friction, step_cohesion;  // tangent; Pa
    double riser_tension;

    explicit SurfaceStrength(const SteppedPath& problem)
        : step_friction(std::tan(problem.steps.friction_angle)),
          step_cohesion(problem.steps.cohesion),
          riser_tension(0) {
        if (problem.rock_bridges) {
            const RockBridges& bridges = *problem.rock_bridges;
            const double joint = bridges.step_persistence;
            step_friction = joint * step_friction + (1 - joint) * std::tan(bridges.friction_angle);
            step_cohesion = joint * step_cohesion + (1 - joint) * bridges.cohesion;
            riser_tension = (1 - bridges.riser_persistence) * bridges.tensile_strength;
        }
    }
};

}  // namespace delabole
