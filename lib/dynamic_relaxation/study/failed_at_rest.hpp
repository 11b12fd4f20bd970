// Blocks that have failed although they came to rest: "stands" must not be said of them.
#pragma once

#include "dynamic_relaxation/step/simulation.hpp"

#include <optional>

namespace delabole {

// Whether blocks are drawn lying on each other, so that they rest where they begin or fail.
enum class InitialContact { drawn, perhaps_none };

// Whether a free block shares no face with another. Its fall onto others is no failure, but without inertia it would
// count as creep beyond onset.
bool any_is_drawn_apart(const RelaxationScene& scene);

// The state of such blocks at the end of a run, with displacements since they began; nothing if they stand or the run
// has failed by itself. They have failed if
// - they rest beyond the threshold of onset, in rotation far beyond, from where they began: the state at rest
//   `begun_at` or else the initial geometry. A static solve lets them creep as long as their balance improves, for
//   instance until they lean on rock in front. This does not count where something carries them along, nor where blocks
//   that may be drawn apart have moved onto each other;
// - or statics finds no forces that hold them in the initial geometry, without what was excavated
//   (`mechanism_of_statics`): some find their balance in another shape, leaning on each other after a turn of a
//   thousandth. Where no strength holds them as drawn, or blocks may be drawn apart or have lost neighbours and moved
//   less than onset, what they came to rest on across open joints may hold them, too
//   (`mechanism_where_blocks_landed`). Statics is asked if the run has no verdict or came to rest; of more than
//   2000 blocks only if they have moved by 0.002 radii or have bolts, of which a short one turns towards the direction
//   of slip within millimetres, and would hold like a dowel. The state is that of its mechanism at onset if the blocks
//   moved less or some have landed.
// Onset counts as of when they began, so that blocks count as moving that have moved a tenth as far as the farthest.
std::optional<RelaxationState> failed_at_rest(const Simulation& simulation, InitialContact contact,
                                              const RelaxationState* begun_at = nullptr);

// Whether statics alone shows that blocks fail on every path: the second reason above, where nothing that they may come
// to rest on could hold them. A run is not needed for that verdict. False if it is not known, as with stages of
// excavation. Time: that of `mechanism_of_statics`.
bool fails_by_statics(const RelaxationScene& scene, const RelaxationSettings& settings, InitialContact contact);

// The result of such a run: energies and forces are those at rest, movements those of the failed state.
RelaxationResult result_of(const Simulation& at_rest, const RelaxationState& failed);

}  // namespace delabole
