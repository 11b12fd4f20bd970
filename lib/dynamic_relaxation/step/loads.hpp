// Loads and prescribed motions at a moment of a run.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/contact/contact_forces.hpp"
#include "dynamic_relaxation/scene/scene.hpp"
#include "dynamic_relaxation/scene/settings.hpp"

#include <vector>

namespace delabole {

double tilt_at(const Gravity& gravity, double time);           // rad
PlanePoint<> gravity_at(const Gravity& gravity, double time);  // m/s2
// The acceleration of the ground, in section axes, m/s2.
PlanePoint<> shaking_at(const RelaxationScene& scene, double time);

struct FaceForce {
    PlanePoint<> arm;    // about the block's centroid, in its present rotation
    PlanePoint<> force;  // N/m
};

// Resultant of a pressure that is linear along the face, at its centre of pressure.
FaceForce force_of(const FacePressure& pressure, const Bodies& bodies, const Motion& motion);

// Sets the velocity of a fixed block.
void prescribe(const PrescribedMotion& prescribed, const Bodies& bodies, double time, Motion& motion);

// The pressures that act once blocks have been taken away: where a block that stays shared a face with one of them,
// those that drain are gone. `removed`: by block, why it is gone.
std::vector<FacePressure> pressures_left(const RelaxationScene& scene, const Bodies& bodies,
                                         const std::vector<char>& removed);

// Forces on all blocks except those of contacts and bonds; zero for blocks that are held. `pressures`: those of the
// scene that are left.
void sum_loads(const RelaxationScene& scene, const std::vector<FacePressure>& pressures,
               const RelaxationSettings& settings, const Bodies& bodies, double time, const std::vector<char>& held,
               const std::vector<Motion>& motion, std::vector<BlockForce>& load);

// Time, s, after which no scheduled change follows; no equilibrium is final before it.
double last_scheduled_time(const RelaxationScene& scene, const RelaxationSettings& settings);

}  // namespace delabole
