// Base friction (Bray & Goodman 1981; chapter 3.2 of the thesis): the model lies flat on a belt that moves in the
// direction gravity is to have, and is stopped by a frame.
//
// On every element of a block's area acts friction tan(phi_belt) times its weight, along the velocity v of the belt
// relative to that element: tan(phi_belt) rho g v / |v|. A block at rest feels a uniform force, gravity times
// tan(phi_belt), so that limiting states are those under gravity; a block that moves is driven less, by the vector
// difference of velocities, and never gets faster than the belt: it has speed where the block under gravity has
// acceleration. The model's mass is real and its inertia is kept; it does not matter where the belt's kinetic energy is
// small against the work over a block's size b, v^2 << 2 tan(phi_belt) g b.
//
// Below `creep` of the belt's speed friction is taken in proportion to |v|, because its direction cannot be known
// there: a block carried along lags or leads by as much, and beyond it friction is exact.
//
// Bray, J.W. & Goodman, R.E. (1981) The theory of base friction models. Int. J. Rock Mech. Min. Sci. 18, 453-468.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/contact/contact_forces.hpp"
#include "dynamic_relaxation/scene/scene.hpp"

namespace delabole {

constexpr double belt_creep = 0.02;

// Resultant of a belt's friction on a block of weight `weight`, N/m, and its moment about the centroid. Exact for a
// block that does not turn; else by a quadrature of degree 5 over the triangles between centroid and edges: to 1e-6 of
// the friction as long as points of the block move against each other by less than a fifth of the belt's relative
// speed, to a per cent for a block turning in place.
BlockForce belt_drag(const Belt& belt, const PlanePoint<>& belt_velocity, double weight, const Bodies& bodies,
                     std::size_t block, const Motion& motion);

// s; with longer steps a block would swing about the belt's speed.
double longest_step(const Belt& belt, const Gravity& gravity);

}  // namespace delabole
