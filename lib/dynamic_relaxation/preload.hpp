// Equilibrium from which a preloaded run starts: without it a block falls onto its springs and overturns too early.
#pragma once

#include "dynamic_relaxation/bonds.hpp"
#include "dynamic_relaxation/contacts.hpp"

#include <Eigen/Core>

#include <vector>

namespace delabole {

struct PreloadSettings {
    double tolerance;  // greatest unbalanced force over the load of its block
    double farthest;   // m; moves no point of any block by more than this
};

// Lets blocks that are not held sink and lean, without inertia, to where springs and friction carry their loads (x
// force, y force, moment of each), and sets the memories of the contacts. The laws are those of the run, over the same
// geometry, so that what is found is an equilibrium of the run as well; where none is found within the limits, the most
// balanced state met is kept, from which the run then moves.
//
// Method: Newton's, over the tangents of the contacts (friction makes them unsymmetric), with a resistance to the
// change of each round that fades as balance improves. It is the implicit integration of a motion without mass through
// a thick fluid, with growing steps: it goes to stable equilibria only. Returns the unbalanced ratio reached.
double preload(const Bodies& bodies, const std::vector<char>& held, const std::vector<Eigen::Vector3d>& loads,
               const PreloadSettings& settings, const Bonds& bonds, const std::vector<BondMemory>& bond_memory,
               std::vector<Motion>& motion, ContactList& list);

}  // namespace delabole
