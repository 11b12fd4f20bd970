// Derivative-free minimisation in a box by NLopt.
//
// The algorithms see the unit box; parameters whose bounds coincide are left out. The wrapper keeps its own count of
// evaluations and its own best point, because the algorithms can exceed their limit and can return a point that failed.
// A failed evaluation (a cause, NaN or an infinity) is counted by cause and given to the algorithm as a finite penalty
// above every value seen, so that it is never the minimum.
//
// Accuracy: near a smooth minimum the value is flat to second order, so a point is known to about the square root of
// the value's rounding, 1e-8 of its scale; a relative_tolerance below that only costs evaluations.
// Source: S. G. Johnson, The NLopt nonlinear-optimization package, version 2.7.1.
#pragma once

#include "fitting/search/algorithm.hpp"
#include "fitting/work/evaluation.hpp"
#include "parameters/fields.hpp"

#include <atomic>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

namespace delabole {

using Objective = std::function<Evaluation(std::span<const double>)>;

// Set by the caller, possibly from a signal handler, to end the work early; null if the work cannot be ended early.
using StopFlag = const std::atomic<bool>*;

inline bool stop_requested(StopFlag stop) {
    return stop != nullptr && stop->load(std::memory_order_relaxed);
}

enum class MinimiseStatus {
    converged,          // the algorithm met its tolerance, or the stop value was reached
    evaluation_limit,   // the cap was reached
    roundoff_limited,   // rounding allows no further progress; as a rule this is the minimum
    algorithm_failure,  // the algorithm gave no reason for its end; the result is the best point seen
    no_valid_point,     // every evaluation failed
    interrupted,        // the stop flag was set
};

struct MinimiseSettings {
    Algorithm algorithm = Algorithm::sbplx;
    long evaluations = 400;            // cap, never exceeded; >= 1
    double relative_tolerance = 1e-8;  // stop when every parameter moves by less than this share of its range
    double value_tolerance = 0;        // stop when the value improves by less than this; 0: never
    double initial_step = 0.2;         // first step of the local algorithms, as a share of the range, in (0, 0.5]
    double stop_value = -std::numeric_limits<double>::infinity();  // stop at a value not above this
    std::uint64_t seed = 1;  // used by crs2, mlsl and isres; the others are deterministic
};

struct MinimiseResult {
    MinimiseStatus status = MinimiseStatus::no_valid_point;
    std::vector<double> point;  // best valid point seen; empty if there is none, or no parameters
    double value = std::numeric_limits<double>::infinity();
    EvaluationCount evaluations;

    bool found() const { return value < std::numeric_limits<double>::infinity(); }
};

// Least value of the objective for lower <= parameter <= upper, from `start` (moved into the bounds). The same
// arguments give the same result, whatever ran before or runs at the same time. An exception thrown by the objective
// ends the run and is rethrown unchanged. Throws std::invalid_argument for sizes that differ and bounds that are
// reversed or not finite.
MinimiseResult minimise(const Objective& objective, std::span<const Interval> bounds, std::span<const double> start,
                        const MinimiseSettings& settings, StopFlag stop = nullptr);

}  // namespace delabole
