// The value of a parameter between standing and failing, by bisection over verdicts of runs, or of statics alone.
//
// The answer is a bracket: the blocks stand at one end and fail at the other. Its width is the resolution, not the
// accuracy: stiffness shifts the answer (simulation.hpp). Blocks that came to rest only after they had moved may stand
// at one value and fail at a less demanding one; bisection sees one such change. Where the blocks at the ratio found
// came to rest in motion, values less demanding by 2 to 10 % are tried as well, and where they rest without motion at
// the angle found, four on its way from the bound at which the blocks should stand; where they crept, these are tried
// in either case, and angles less by 2 to 7 % of that way. The answer is the least demanding at which they were found
// to fail, in motion or at rest (failed_at_rest.hpp).
#pragma once

#include "dynamic_relaxation/step/outcome.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace delabole {

enum class CriticalStatus {
    found,
    stands_everywhere,  // the blocks stand at the bound at which they should fail
    fails_everywhere,   // the blocks fail at the bound at which they should stand
    undecided,          // a run neither came to rest nor failed; the bracket is as narrow as the search made it
    run_failed,         // overlaps too large or motion not finite; the bracket is as for `undecided`
    interrupted,        // the bracket is as for `undecided`
    not_valid,          // the scene is not valid at one of the values
};

struct CriticalValue {
    CriticalStatus status = CriticalStatus::found;
    double stands = 0;                   // nearest value at which the blocks are known to stand
    double fails = 0;                    // nearest value at which they are known to fail
    bool seen_to_stand = false;          // at `stands`; otherwise that is a bound not yet tried
    bool seen_to_fail = false;           // at `fails`
    std::optional<double> stands_again;  // more demanding value than `fails`, at which the blocks stand
    bool held_by_corners = false;        // at `fails`: the blocks rest, but on corners alone
    double last = 0;                     // last value tried: if no value was found, the one that ended the search
    std::uint64_t runs = 0;              // made; verdicts of statics alone take none
    std::uint64_t steps = 0;
    std::uint64_t contacts_evaluated = 0;

    double value() const { return (stands + fails) / 2; }
};

struct CriticalProbe {
    RelaxationOutcome outcome;  // equilibrium stands; onset and collapse fail, and so do blocks held only by corners
    std::uint64_t steps;
    std::uint64_t contacts_evaluated = 0;
    bool rested_in_motion = false;  // the solver of statics found no equilibrium, or was not used
    bool crept = false;             // it found one only after they had moved by half of the threshold of onset or more
    bool without_run = false;       // admissible forces do not exist, which gives the verdict by itself
};

// How a bracket is divided. With the geometric mean, ratios over decades take no more runs for small values than for
// large ones.
enum class BracketMean { arithmetic, geometric };

// Bisects between a bound at which the blocks should stand and one at which they should fail, in either order, until
// they are no more than `tolerance` (more than 0) apart. Both bounds are tried first; for the geometric mean both are
// more than 0.
CriticalValue find_critical(const std::function<CriticalProbe(double value)>& probe, double should_stand,
                            double should_fail, double tolerance, BracketMean mean = BracketMean::arithmetic);

}  // namespace delabole
