// The static equilibrium from which a preloaded run starts: without it a block falls onto its springs and overturns too
// early.
#pragma once

#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace delabole {

struct StaticSolveSettings {
    double tolerance;  // greatest unbalanced force over the load of its block
    double finest;     // likewise; what is found is improved up to here as long as that takes few rounds
    double farthest;   // m; moves no point of any block by more than this
    // From the most balanced state met, without inertia. 0: they do not creep.
    double creep_rotation;  // rad
    double creep_slide;     // in radii
    // Where no equilibrium is found, blocks are left where they have crept to when the first of them has come that far,
    // not in the most balanced state met.
    bool leave_crept;
};

struct StaticSolution {
    double ratio;                       // unbalanced, of the most balanced state met
    bool cut_short;                     // ended for lack of solutions: with more there may be an equilibrium
    bool at_farthest;                   // blocks still crept at the farthest that is allowed: they may go on from there
    std::vector<Motion> most_balanced;  // motion there
    MemoryArray memory;                 // of the contacts there; empty if the call before this one met that state
    std::uint64_t contacts_evaluated;
};

// Lets blocks that are not held sink and lean, without inertia, to where springs and friction carry their loads (x
// force, y force, moment of each), and sets the memories of the contacts. The laws are those of the run, over the same
// geometry, so that what is found is an equilibrium of the run as well; where none is found within the limits, the run
// starts from the most balanced state met, or farther on.
//
// `creeping`: what a call before this one has left at the farthest, from where this one goes on, with contacts found
// anew. Creep goes on being measured from the most balanced state of both. None: this is the first.
//
// Method: implicit integration of a motion without mass, which a pseudo-viscosity resists that fades as balance
// improves: it goes to stable equilibria only. Each solution takes Newton's tangents of the contacts (friction makes
// them unsymmetric). Fewer than 24 free blocks move by one linear solution at a time, 300 at most, 2000 where they
// creep. Of more, so many contacts begin or end to slide or to touch in one of those that balance would not improve:
// each step is solved until pseudo-viscosity balances what is out of balance, from the memories that contacts had
// before it, and what resists are not only the blocks themselves but also their contacts, open ones too, which do not
// let them flutter; there are 2000 linear solutions at most. Where the force of a contact jumps in however short a
// step, the jump is taken, up to 20 times, and balanced by the steps after it, unless there are bonds, which it might
// break. Where it finds no balance of bonded blocks, fewer than 400 and not left to creep, it tries again with loads
// that grow in eight steps.
StaticSolution solve_statically(const Bodies& bodies, const std::vector<char>& held,
                                const std::vector<Eigen::Vector3d>& loads, const StaticSolveSettings& settings,
                                const StaticSolution* creeping, const Bonds& bonds,
                                const std::vector<BondMemory>& bond_memory, std::vector<Motion>& motion,
                                ContactList& list);

}  // namespace delabole
