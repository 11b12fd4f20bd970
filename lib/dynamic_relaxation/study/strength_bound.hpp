// Bounds the factor of safety of a scene by statics alone.
#pragma once

#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/scene/scene.hpp"
#include "dynamic_relaxation/step/simulation.hpp"
#include "limit_equilibrium/bound/lp_bound.hpp"

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

namespace delabole {

// Greatest factor of safety by strength reduction for which admissible forces exist that hold all blocks, whatever the
// loading path and the stiffness of the joints. A path may lead to failure far below it, for the reason given in
// lp_bound.hpp.
//
// Forces act over faces that lie on each other in the initial geometry, with peak strengths, and at tips that stand on
// a face, under the initial loads; fixed blocks are the base. Contacts of corners on corners do not count: where there
// are many, as where joint sets cross, a slope may stand slightly above this factor (the published problem RJ-5,
// without cohesion, by 2 %). Each end of a face has half of its tensile strength, which is more than an elastic section
// has; bonded rock has its own strength if that is more than the joint's.
//
// Infinite if blocks stand without strength; 0 if a hundred times their strength is not enough; empty if anything is
// scheduled for later, if there are bolts, or if a linear programme has no answer. Relative accuracy 1e-6. Time: some
// 20 linear programmes (`least_imbalance`).
std::optional<double> greatest_strength_reduction(const RelaxationScene& scene,
                                                  const std::atomic<bool>* stop = nullptr);

struct StaticMechanism {
    std::vector<Motion> motion;  // of each block as it begins to fail, the fastest point by about a metre
    // Whether a hundred times the strength does not hold the blocks either; empty if that is not known.
    std::optional<bool> at_any_strength = {};
};

// The mechanism by which blocks fail if no such forces exist at the scene's strength, bolts bearing up to their
// capacity along their axes; nothing if there are such forces, or no answer, or if a stage of excavation is still to
// come at this time of a run, s (0: at its start). One linear programme if there are such forces, two to four if not;
// half a second each for 1500 blocks.
std::optional<StaticMechanism> mechanism_of_statics(const RelaxationScene& scene, double time = 0);

// The same where blocks have come to rest on others that they did not touch in the initial geometry: forces act at
// those contacts, too, and blocks that have moved farther than onset act where they are now, the rest as in the initial
// geometry. `as_drawn`: the mechanism without this, which is the answer if the linear programme has none.
std::optional<StaticMechanism> mechanism_where_blocks_landed(const Simulation& at_rest,
                                                             const StaticMechanism& as_drawn);

// The blocks that have lost a neighbour among those `gone` and that the others could not hold even if they were fixed
// (the removable blocks of Goodman & Shi 1985, with friction and water). Further blocks may lose their support with
// them: call again with these gone as well.
std::vector<std::size_t> blocks_without_hold(const RelaxationScene& scene, const Bodies& bodies,
                                             const std::vector<SharedFace>& faces, const std::vector<char>& gone);

}  // namespace delabole
