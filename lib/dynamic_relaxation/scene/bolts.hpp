// Bolts across joints, as springs between the blocks that they join.
//
// A bolt without grout stretches over its whole length, between the block at its head and the one at its end. A grouted
// bolt is held along its whole length: wherever it crosses from one block to the next, it stretches over a short free
// length. It is elastic up to its capacity, then yields; it acts in tension only, and resists shear only in so far as
// shear stretches it, which counts in motion but not for a verdict that blocks stand (study/failed_at_rest.hpp). With
// its grout's bond strength given, its capacity and pretension at a joint are at most what grout and plate hold there
// (support/bolt_pattern.hpp).
#pragma once

#include "dynamic_relaxation/scene/relaxation_parameters.hpp"
#include "dynamic_relaxation/scene/scene.hpp"

#include <cstddef>
#include <vector>

namespace delabole {

// The single bolts, then those of each row from the lowest up. A head higher than the outline is not finite.
std::vector<RelaxationBolt> all_bolts(const Relaxation& model);

// The segments of the bolt with this index. If the bolt begins or ends outside the blocks or crosses no joint, the
// result is one segment of a block that does not exist, which the scene's check refuses.
std::vector<BoltSegment> bolt_segments(const RelaxationScene& scene, const RelaxationBolt& bolt, std::size_t index);

}  // namespace delabole
