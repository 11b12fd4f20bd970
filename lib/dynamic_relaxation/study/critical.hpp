// The value of a parameter between standing and failing, by bisection over runs.
//
// The answer is a bracket: one end stands, the other fails. Its width is the resolution, not the accuracy: stiffness
// shifts the answer (simulation.hpp). Blocks that came to rest only after they had moved may stand at one value and
// fail at a milder one; bisection sees one such change. Where the blocks at the ratio found came to rest in motion,
// values 2 to 10 % milder are tried as well, and the answer is the mildest at which they were found to fail.
#pragma once

#include "dynamic_relaxation/step/outcome.hpp"

#include <cstdint>
#include <functional>
#include <optional>

namespace delabole {

enum class CriticalStatus {
    found,
    stands_everywhere,  // it stands at the bound at which it was to fail
    fails_everywhere,   // it fails at the bound at which it was to stand
    undecided,          // a run neither rested nor failed; the bracket is as far as the search came
    run_failed,         // overlaps too large or motion not finite; likewise
    interrupted,        // likewise
    not_valid,          // the scene is not valid at one of the values
};

struct CriticalValue {
    CriticalStatus status = CriticalStatus::found;
    double stands = 0;                   // nearest value known to stand
    double fails = 0;                    // nearest value known to fail
    std::optional<double> stands_again;  // value at which they stand although they fail at the milder `fails`
    bool held_by_corners = false;        // at `fails`: the blocks rest, but on corners alone
    double last = 0;                     // value of the last run: the one that ended the search where it was not found
    std::uint64_t runs = 0;
    std::uint64_t steps = 0;
    std::uint64_t contacts_evaluated = 0;

    double value() const { return (stands + fails) / 2; }
};

struct CriticalProbe {
    RelaxationOutcome outcome;  // equilibrium stands; onset and collapse fail, and so does what only corners hold
    std::uint64_t steps;
    std::uint64_t contacts_evaluated = 0;
    bool rested_in_motion = false;  // statics found no equilibrium, or was not asked for one
};

// Where a bracket is divided. Of ratios over decades the geometric mean takes no more runs for small ones than for
// great ones.
enum class BracketMean { arithmetic, geometric };

// Bisects between a bound at which the blocks should stand and one at which they should fail, either of which may be
// the greater, until they are no more than `tolerance` (more than 0) apart. Both bounds are tried first; for the
// geometric mean they are more than 0.
CriticalValue find_critical(const std::function<CriticalProbe(double value)>& probe, double should_stand,
                            double should_fail, double tolerance, BracketMean mean = BracketMean::arithmetic);

}  // namespace delabole
