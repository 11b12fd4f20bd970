// The static equilibrium from which a preloaded run starts: without it a block falls onto its springs and overturns too
// early.
#pragma once

#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"
#include "dynamic_relaxation/statics/static_equations.hpp"

#include <Eigen/Core>

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace delabole {

// Motion without inertia from the most balanced state met, where no equilibrium is found. Blocks that have crept are
// put back to that state, or left where they are when the first of them reaches the limit.
enum class Creep { none, put_back, left };

struct StaticSolveSettings {
    double tolerance;  // greatest unbalanced force over the load of its block
    double finest;     // same ratio to which an equilibrium is improved as long as that takes few rounds
    double farthest;   // m; moves no point of any block by more than this
    Creep creep;
    double creep_rotation;  // rad, limit
    double creep_slide;     // in radii, limit
    // Few blocks may have several equilibria: the solver then seeks the one nearest to where they begin.
    bool nearest;
    // Whether blocks may stand on corners on corners, which have to hold them with either edge then
    // (corner_choice.hpp).
    bool corners_bear;
    const std::atomic<bool>* stop;  // set by another thread: no more solutions are made; may be null
};

struct StaticSolution {
    double ratio;                       // unbalanced ratio of the most balanced state met
    bool cut_short;                     // ended at the limit of solutions; with more there may be an equilibrium
    bool at_farthest;                   // blocks still crept at the farthest distance allowed
    std::vector<Motion> most_balanced;  // motion in the most balanced state
    MemoryArray memory;                 // of the contacts in that state; empty if the call before this one met it
    std::uint64_t contacts_evaluated;
};

// Lets blocks that are not held sink and lean, without inertia, to where springs and friction carry their loads (x
// force, y force, moment of each), and sets the memories of the contacts. The laws are those of the run, over the same
// geometry, so that the result is an equilibrium of the run as well. If none is found within the limits, the run starts
// from the most balanced state met, or from where the blocks have crept to.
//
// `creeping`: what the previous call has left at the farthest distance, from where this one continues with newly found
// contacts. Creep is still measured from the most balanced state of both calls. Null in the first call.
//
// Method: implicit integration of a motion without mass, resisted by a pseudo-viscosity that decreases as balance
// improves: it converges to stable equilibria only. Each solution uses Newton's tangents of the contacts (friction
// makes them unsymmetric). Fewer than 24 free blocks move by one linear solution at a time, 300 at most, or 2000 where
// they may be left crept. More blocks move in steps, each solved until pseudo-viscosity, which then acts in contacts,
// too, balances the unbalanced forces; there are 2000 linear solutions at most.
StaticSolution solve_statically(const Bodies& bodies, const std::vector<char>& held,
                                const std::vector<Eigen::Vector3d>& loads, const StaticSolveSettings& settings,
                                const StaticSolution* creeping, const Bonds& bonds,
                                const std::vector<BondMemory>& bond_memory, std::span<const HeldByBolt> bolts,
                                std::vector<Motion>& motion, ContactList& list);

}  // namespace delabole
