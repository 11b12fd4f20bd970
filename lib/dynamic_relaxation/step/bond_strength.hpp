// The strength of rock that a bonded slope needs to stand.
//
// Friction has no scale, so that the ratio of the bonds' strength to the stress from weight decides whether columns
// break. The slope first comes to rest with bonds too strong to break. From that state runs are made with less and less
// strength, tensile strength and cohesion together, each a fixed ratio of the one before, until the slope fails. The
// first strength tried is the first at which a bond breaks. Bisection is not possible: a slope can fail at a strength
// and stand at a lower one, at which its columns break into pieces too small to topple. The result is the greatest
// strength of the sequence at which it fails.
//
// Failure: blocks that have moved by more than a given distance since the unbroken slope came to rest make up more than
// a given area and have not come to rest; or the slope still moves at the end of the longest run. A single loose block
// is not a failure of the slope: once it has moved by more than `loose_distance`, it is removed and counted.
#pragma once

#include "dynamic_relaxation/step/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace delabole {

// Shares refer to the strengths that the scene gives its bonds.
struct StrengthReduction {
    double strongest;        // share at which the slope first comes to rest: more than any bond needs
    double weakest;          // share at which the search ends, more than 0
    double ratio;            // ratio of each share to the one before, 0 to 1
    double failed_distance;  // m
    double failed_area;      // m2
    double loose_distance;   // m, more than failed_distance
    double rest_speed;       // m/s; a slope is at rest if the root mean square velocity of its blocks is below this
    double longest_run;  // s of model time at one strength, half of it unbroken; a slope not at rest by then has failed
};

enum class StrengthStatus {
    found,
    fails_however_strong,  // before any bond breaks
    stands_however_weak,   // at the weakest share
    run_failed,            // overlaps too large or motion not finite
    interrupted,
};

// State of the slope between two runs.
struct ReducedSlope {
    RelaxationScene scene;             // with the strengths of the last run, and without the loose blocks
    RelaxationState state;             // at the end of the last run
    std::vector<Motion> unbroken;      // at rest before any bond broke; in the initial geometry if it never came to
                                       // rest
    std::vector<std::size_t> loose{};  // blocks removed

    double displacement(std::size_t block) const;  // m, since the unbroken slope was at rest
};

struct CriticalStrength {
    StrengthStatus status = StrengthStatus::run_failed;
    double stands = 0;         // the share before `fails`, at which the slope stands; infinite if it fails however
                               // strong
    double fails = 0;          // greatest share that fails; 0 where none does
    std::size_t runs = 0;      // at different strengths
    std::size_t creeping = 0;  // number of these runs that ended at `longest_run`
    std::uint64_t steps = 0;   // time steps
    ReducedSlope end;          // state after the last run; from find_critical_strength the unbroken state if no share
                               // fails
};

// The scene must be valid and have bonds. The settings' thresholds of onset and collapse, stop and duration are not
// used. `watch` is called from time to time; if it returns false, the search ends as interrupted.
CriticalStrength find_critical_strength(const RelaxationScene& scene, const RelaxationSettings& settings,
                                        const StrengthReduction& reduction, const std::function<bool()>& watch = {});

// Brings the unbroken slope to rest and then applies this share of the strengths at once: `found` if it then fails.
CriticalStrength run_at_strength(const RelaxationScene& scene, const RelaxationSettings& settings,
                                 const StrengthReduction& reduction, double share,
                                 const std::function<bool()>& watch = {});

// The line along which columns have bent most where they broke: a least-squares line through the middles of the broken
// bonds, each weighted by the relative rotation of its faces.
struct CrackPath {
    std::size_t broken = 0;     // bonds
    double inclination = 0;     // rad; 0 with fewer than two
    PlanePoint<> middle{0, 0};  // m, in the initial geometry
    double length = 0;          // m, between the outermost of the bonds whose rotation exceeds a tenth of the greatest
};

CrackPath crack_path(const ReducedSlope& slope);

}  // namespace delabole
