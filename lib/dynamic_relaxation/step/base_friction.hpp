// Base friction (Bray & Goodman 1981; chapter 3.2 of the thesis): the model lies flat on a belt that moves in the
// intended direction of gravity, and a frame stops it.
//
// Every element of a block's area is subject to friction tan(phi_belt) times its weight, along the velocity v of the
// belt relative to that element: tan(phi_belt) rho g v / |v|. On a block at rest the force is uniform, gravity times
// tan(phi_belt), so that limiting states are those under gravity. A moving block is driven less, by the vector
// difference of velocities, and never gets faster than the belt: it has a velocity where the block under gravity has an
// acceleration. The model keeps its real mass and inertia; the inertia does not matter where the belt's kinetic energy
// is small against the work over a block's size b, v^2 << 2 tan(phi_belt) g b.
//
// Below `creep` of the belt's speed friction is taken in proportion to |v|, because its direction is not defined at
// rest: the velocity of a block carried along differs from the belt's by up to that share; above it friction is exact.
//
// Bray, J.W. & Goodman, R.E. (1981) The theory of base friction models. Int. J. Rock Mech. Min. Sci. 18, 453-468.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/contact/contact_forces.hpp"
#include "dynamic_relaxation/scene/scene.hpp"

namespace delabole {

constexpr double belt_creep = 0.02;

// Resultant of a belt's friction on a block of weight `weight`, N/m, and its moment about the centroid. It is exact for
// a block that does not rotate. Otherwise it is a quadrature of degree 5 over the triangles between centroid and edges:
// accurate to 1e-6 of the friction as long as points of the block move against each other by less than a fifth of the
// belt's relative speed, and to a per cent for a block that rotates in place.
BlockForce belt_drag(const Belt& belt, const PlanePoint<>& belt_velocity, double weight, const Bodies& bodies,
                     std::size_t block, const Motion& motion);

// Longest step, s, at which the velocity of a block does not oscillate about the belt's.
double longest_step(const Belt& belt, const Gravity& gravity);

}  // namespace delabole
