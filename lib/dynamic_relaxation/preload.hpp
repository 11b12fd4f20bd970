// Equilibrium from which a preloaded run starts: without it a block falls onto its springs and overturns too early.
#pragma once

#include "dynamic_relaxation/bonds.hpp"
#include "dynamic_relaxation/contacts.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace delabole {

struct PreloadSettings {
    double tolerance;  // greatest unbalanced force over the load of its block
    double finest;     // likewise; what is found is improved up to here as long as that takes few rounds
    double farthest;   // m; moves no point of any block by more than this
    // Where no equilibrium is found, blocks are left where they have crept to when the first of them has come this far
    // from the most balanced state met, not in that state. 0: they do not creep.
    double creep_rotation;  // rad
    double creep_slide;     // in radii
};

struct Preloaded {
    double ratio;                       // unbalanced, of the most balanced state met
    bool cut_short;                     // ended for lack of rounds: with more there may be an equilibrium
    std::vector<Motion> most_balanced;  // motion there
    std::uint64_t contacts_evaluated;
};

// Lets blocks that are not held sink and lean, without inertia, to where springs and friction carry their loads (x
// force, y force, moment of each), and sets the memories of the contacts. The laws are those of the run, over the same
// geometry, so that what is found is an equilibrium of the run as well; where none is found within the limits, the run
// starts from the most balanced state met, or farther on. It takes 300 rounds at most, 2000 where blocks creep. Many
// blocks are given fewer, 40 000 over their number but no fewer than 8: they settle in the run for less than their
// equations cost.
//
// Method: Newton's, over the tangents of the contacts (friction makes them unsymmetric), with a resistance to the
// change of each round that fades as balance improves. It is the implicit integration of a motion without mass through
// a thick fluid, with growing steps: it goes to stable equilibria only. Where it finds none of bonded blocks, fewer
// than 400 and not left to creep, it tries again with loads that grow in eight steps.
Preloaded preload(const Bodies& bodies, const std::vector<char>& held, const std::vector<Eigen::Vector3d>& loads,
                  const PreloadSettings& settings, const Bonds& bonds, const std::vector<BondMemory>& bond_memory,
                  std::vector<Motion>& motion, ContactList& list);

}  // namespace delabole
