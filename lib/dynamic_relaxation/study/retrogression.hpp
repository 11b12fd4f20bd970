// Retrogressive failure of a jointed slope: failed blocks leave the slope, those behind them have to stand without
// them, and so on until the rest stands (Cruden & Varnes 1996: retrogressing; 2.4.2 (ii) of the thesis: progressive and
// repeating).
//
// Each stage is a run of its own from the initial geometry, without the blocks that failed in earlier stages, to
// equilibrium or to the onset of failure. At onset the blocks that have moved by more than a tenth of the farthest
// motion are the failing mass (BlockOutcome::movement), together with blocks that have lost all support
// (blocks_without_hold). The same holds for blocks that come to rest although statics, or how far they have moved,
// shows that they have failed (failed_at_rest.hpp). They are removed; the others keep neither their small displacements
// nor their stresses. So the ground left standing follows from equilibrium alone, without time, fall or debris, and the
// same slope gives the same answer.
//
// Limits. Debris gives no support: where it comes to rest against the slope, less fails than is found here. A joint
// that a failure has opened is drained: its water no longer presses on the face that stays. A pond does not follow the
// ground.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "geometry/polyline.hpp"
#include "parameters/fields.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace delabole {

struct RetrogressionRequest {
    std::optional<double> most_stages;
    static constexpr auto fields() {
        return FieldTable{number<&RetrogressionRequest::most_stages>(
            at_least(1), "greatest number of masses sought: 1 finds the one that fails first; absent: all")};
    }
};

// A mass that failed and how it moved at onset, by area: blocks that rotate about a point within two radii of their
// centroid, out of the slope (they topple) or into it, and the others (they slide or fall; this includes all blocks
// that have lost their support).
struct RetrogressionStage {
    double blocks;
    double area;
    double toppling_share;
    double backward_share;
    double sliding_share;
    double rotation_share;
    static constexpr auto fields() {
        using S = RetrogressionStage;
        return FieldTable{
            number<&S::blocks>("blocks that failed"),
            number<&S::area>(Dimension::area, "of the section that failed"),
            number<&S::toppling_share>("share of this area in blocks that turn out of the slope"),
            number<&S::backward_share>("likewise, into the slope"),
            number<&S::sliding_share>("likewise, in blocks that do not turn"),
            number<&S::rotation_share>("share of rotation in the kinetic energy at onset, with displacements until "
                                       "then in place of velocities; 0: blocks slide, 0.25: rectangles turn about a "
                                       "corner. Of several masses the mean by area")};
    }
};

struct RetrogressionAnswer {
    double stages;
    RetrogressionStage total;
    RetrogressionStage first;
    RetrogressionStage largest;
    std::vector<RetrogressionStage> stage;
    static constexpr auto fields() {
        using R = RetrogressionAnswer;
        return FieldTable{
            number<&R::stages>("masses that failed one after the other until the rest stood"),
            section<&R::total>("all of them together"), section<&R::first>("the first; zero where none failed"),
            section<&R::largest>("the one of the greatest area, likewise"), section<&R::stage>("each of them")};
    }
};

struct FailureStage {
    std::vector<std::uint64_t> block = {};  // blocks that failed: first those that moved, in increasing order
    std::uint64_t moved = 0;                // number of blocks that moved; the others lost their support with them
    std::vector<Motion> start = {};         // of all blocks, after the static start
    std::vector<Motion> onset = {};         // of all blocks, when these had begun to fail
    double time = 0;                        // s, to onset
    std::uint64_t steps = 0;
    std::uint64_t contacts_evaluated = 0;
};

RetrogressionAnswer answer_of(const Bodies& bodies, const std::vector<FailureStage>& stages);

// Ground left standing after each stage, by the blocks that have failed until then; all at the same x, those of
// PostFailure::left_standing.
std::vector<Polyline> left_standing_after(const Bodies& bodies, const std::vector<FailureStage>& stages);

}  // namespace delabole
