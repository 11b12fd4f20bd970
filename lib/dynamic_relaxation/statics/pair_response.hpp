// Forces between two blocks in a given state, and their changes with small motions of the two: those of bonds and
// bolts. Those of contacts, which take most of the time, are computed where they are summed (static_equations.cpp).
#pragma once

#include "dynamic_relaxation/contact/bolt_springs.hpp"
#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"

#include <Eigen/Core>

#include <array>

namespace delabole {

// Relative displacement along a line of a point of one block and a point of another: the product of (x, y, lever) with
// the first block's displacements and rotation times radius, plus that of (-x, -y, other_lever) with the second's.
struct PairDirection {
    double x = 0;
    double y = 0;
    double lever = 0;
    double other_lever = 0;

    Eigen::Vector3d of_first() const { return {x, y, lever}; }
    std::array<double, 6> of_both() const { return {x, y, lever, -x, -y, other_lever}; }
    PairDirection of_other_first() const { return {-x, -y, other_lever, lever}; }
};

// The force of a contact, a bond or a bolt in a given state, N/m, and how it changes with the motion of its two blocks,
// N/m2.
struct PairResponse {
    PairDirection normal = {};
    PairDirection along = {};
    double normal_force = 0;
    double shear_force = 0;
    double normal_stiffness = 0;
    double shear_stiffness = 0;  // where the contact sticks
    double coupling = 0;         // of the shear force with the displacement along the normal, where it slides
    double normal_damping = 0;   // for a unit pseudo-viscosity of contacts
    double shear_damping = 0;    // for a unit pseudo-viscosity of contacts

    // Whether it adds anything to forces and their changes; a third to a half of all contacts add nothing.
    bool acts() const {
        return normal_damping != 0 || normal_stiffness != 0 || shear_stiffness != 0 || coupling != 0 ||
               shear_damping != 0 || normal_force != 0 || shear_force != 0;
    }
};

// Maps displacements of two blocks to the relative displacement of two of their points along a line, and to the
// relative rotation.
struct Arms {
    double radius;
    double other_radius;

    template <class Position>
    PairDirection along(double x, double y, const Position& at) const {
        return {x, y, (at.arm_x * y - at.arm_y * x) / radius,
                -(at.other_arm_x * y - at.other_arm_y * x) / other_radius};
    }
    PairDirection turn() const { return {0, 0, 1 / radius, -1 / other_radius}; }
};

// The response of a bond to displacements, and its response to a rotation.
std::array<PairResponse, 2> respond(const Bond& bond, const FacePosition& at, const Arms& arms);

// A bolt that stretches while blocks move, and what it remembers from before.
struct HeldByBolt {
    BoltSegment segment;
    BoltMemory memory;
};

// A bolt's direction changes too little in a round for its tangent to matter.
PairResponse respond(const HeldByBolt& bolt, const BoltPosition& at, const Arms& arms);

}  // namespace delabole
