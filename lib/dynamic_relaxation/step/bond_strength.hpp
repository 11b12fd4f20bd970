// The strength of rock that a bonded slope needs to stand.
//
// Friction has no scale, so what decides whether columns break is the strength of the bonds over the stress that weight
// raises in them. The slope first comes to rest with bonds too strong to break. Then it is run on from there with less
// strength, tensile strength and cohesion together, until it rests again or has failed; and from there again with still
// less, step by step of a fixed ratio, until it fails. The first strength tried is the first at which a bond breaks. No
// bisection: a slope can fail at a strength and stand at a lower one, at which its columns go to pieces too small to
// topple. What is found is the greatest strength of the row at which it fails.
//
// Failed: blocks that have moved by more than a given distance since the unbroken slope came to rest make up more than
// a given area, and have not come to rest; or the slope still moves when the longest run is over. A single block that
// comes loose is no failure of the slope: once it has moved by more than `loose_distance`, it is taken away, and
// counted.
#pragma once

#include "dynamic_relaxation/step/simulation.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace delabole {

// Shares are of the strengths that the scene gives its bonds.
struct StrengthReduction {
    double strongest;        // share at which the slope first comes to rest: more than any bond needs
    double weakest;          // share at which the search ends, more than 0
    double ratio;            // of a share to the one before, 0 to 1
    double failed_distance;  // m
    double failed_area;      // m2
    double loose_distance;   // m, more than failed_distance
    double rest_speed;       // m/s; a slope whose blocks move no faster, in the mean by their squares, rests
    double longest_run;  // s of model time at one strength, half of it unbroken; who does not rest by then has failed
};

enum class StrengthStatus {
    found,
    fails_however_strong,  // before any bond breaks
    stands_however_weak,   // at the weakest share
    run_failed,            // overlaps too large or motion not finite
    interrupted,
};

// The slope between two runs.
struct ReducedSlope {
    RelaxationScene scene;             // with the strengths of the last run, and without the loose blocks
    RelaxationState state;             // at the end of it
    std::vector<Motion> unbroken;      // at rest before any bond broke; in the initial geometry where it never rested
    std::vector<std::size_t> loose{};  // blocks taken away

    double displacement(std::size_t block) const;  // m, since the unbroken slope was at rest
};

struct CriticalStrength {
    StrengthStatus status = StrengthStatus::run_failed;
    double stands = 0;         // the share before `fails`, which stands; infinite where it fails however strong
    double fails = 0;          // greatest share that fails; 0 where none does
    std::size_t runs = 0;      // at different strengths
    std::size_t creeping = 0;  // of these, that ended at `longest_run`
    std::uint64_t steps = 0;   // of time
    ReducedSlope end;          // of the last run; of find_critical_strength, where no share fails, unbroken
};

// The scene must be valid, and has bonds. The settings' thresholds of onset and collapse, stop and duration are not
// used. `watch` is asked now and then; false ends the search as interrupted.
CriticalStrength find_critical_strength(const RelaxationScene& scene, const RelaxationSettings& settings,
                                        const StrengthReduction& reduction, const std::function<bool()>& watch = {});

// The unbroken slope at rest, then this share of the strengths at once: `found` where it then fails.
CriticalStrength run_at_strength(const RelaxationScene& scene, const RelaxationSettings& settings,
                                 const StrengthReduction& reduction, double share,
                                 const std::function<bool()>& watch = {});

// The line along which columns have bent most where they broke: that of least squares through the middles of the broken
// bonds, each counted by how far its faces have turned against each other.
struct CrackPath {
    std::size_t broken = 0;     // bonds
    double inclination = 0;     // rad; 0 with fewer than two
    PlanePoint<> middle{0, 0};  // m, in the initial geometry
    double length = 0;          // m, between the outermost of the bonds that turned by more than a tenth of the most
};

CrackPath crack_path(const ReducedSlope& slope);

}  // namespace delabole
