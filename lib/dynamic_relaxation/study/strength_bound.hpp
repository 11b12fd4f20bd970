// Bounds the factor of safety of a scene by statics alone.
#pragma once

#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/scene/scene.hpp"
#include "limit_equilibrium/bound/lp_bound.hpp"

#include <atomic>
#include <cstddef>
#include <optional>
#include <vector>

namespace delabole {

// Greatest factor of safety by strength reduction for which forces exist that strength allows and that hold all blocks,
// whatever the loading path and the stiffness of the joints. A path may lead to failure far below it: lp_bound.hpp says
// why.
//
// Forces act over faces that lie on each other in the initial geometry, with peak strengths, under the loads of the
// start; fixed blocks are the base. What corners hold on corners does not count: where many meet, as in joint sets that
// cross, a slope may stand somewhat above it (the published problem RJ-5, without cohesion, by 2 %). Faces have at
// each end half of their tensile strength, which is more than an elastic section has; bonded rock has its own strength
// where that is more than the joint's. Nothing where something is scheduled for later. Infinite where blocks stand
// without strength, 0 where none is enough. Time: 10 to 60 linear programmes; 0.1 s for 60 blocks, 20 s for 450.
std::optional<double> greatest_strength_reduction(const RelaxationScene& scene,
                                                  const std::atomic<bool>* stop = nullptr);

// The blocks that have lost a neighbour to those that are `gone` and that the others could not hold even if they
// stood fast themselves (the removable blocks of Goodman & Shi 1985, with friction and water). Some that are left may
// lose their hold with them: ask again with these gone as well.
std::vector<std::size_t> blocks_without_hold(const RelaxationScene& scene, const Bodies& bodies,
                                             const std::vector<SharedFace>& faces, const std::vector<char>& gone);

}  // namespace delabole
