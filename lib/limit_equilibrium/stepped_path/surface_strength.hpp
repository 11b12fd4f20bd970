// Strength of a stepped surface.
#pragma once

#include "limit_equilibrium/stepped_path/stepped_path_parameters.hpp"

#include <cmath>

namespace delabole {

// The strength of joint and rock bridges together.
struct SurfaceStrength {
    double step_friction, step_cohesion;    // tangent; Pa
    double riser_friction, riser_cohesion;  // likewise, where something slides on a riser; 0 without risers
    double riser_tension;

    explicit SurfaceStrength(const SteppedPath& problem)
        : step_friction(std::tan(problem.steps.friction_angle)),
          step_cohesion(problem.steps.cohesion),
          riser_friction(problem.risers ? std::tan(problem.risers->friction_angle) : 0),
          riser_cohesion(problem.risers ? problem.risers->cohesion : 0),
          riser_tension(0) {
        if (problem.rock_bridges) {
            const RockBridges& bridges = *problem.rock_bridges;
            const auto together = [](double joint, double of_joint, double of_rock) {
                return joint * of_joint + (1 - joint) * of_rock;
            };
            const double rock_friction = std::tan(bridges.friction_angle);
            step_friction = together(bridges.step_persistence, step_friction, rock_friction);
            step_cohesion = together(bridges.step_persistence, step_cohesion, bridges.cohesion);
            riser_friction = together(bridges.riser_persistence, riser_friction, rock_friction);
            riser_cohesion = together(bridges.riser_persistence, riser_cohesion, bridges.cohesion);
            riser_tension = (1 - bridges.riser_persistence) * bridges.tensile_strength;
        }
    }
};

}  // namespace delabole
