// Which parameters matter, from few evaluations: one parameter at a time from the medians, and Morris's elementary
// effects from many places.
//
// Both move one parameter between stated quantiles of its own distribution, the others unchanged: correlations play no
// part in them.
#pragma once

#include "fitting/probability/dependence.hpp"
#include "fitting/probability/estimate.hpp"
#include "fitting/search/evaluate_points.hpp"

#include <cstdint>
#include <optional>
#include <tuple>
#include <vector>

namespace delabole {

struct TornadoSettings {
    double lower_probability = 0.05;
    double upper_probability = 0.95;
    static constexpr auto fields() {
        using S = TornadoSettings;
        return std::tuple{
            with_default(number("lower_probability", &S::lower_probability, Dimension::ratio, lower_quantile,
                                "probability of the lower end")),
            with_default(number("upper_probability", &S::upper_probability, Dimension::ratio, upper_quantile,
                                "probability of the upper end")),
        };
    }
};

struct TornadoEnd {
    double parameter = 0;
    Evaluation answer;
};

struct TornadoBar {
    TornadoEnd low;   // the parameter at its lower quantile, all others at their medians
    TornadoEnd high;  // and at its upper quantile

    // Greatest change of the quantity between the two ends and the medians; nothing where one has no answer.
    std::optional<double> swing(const Evaluation& at_medians) const;
};

struct TornadoResult {
    Evaluation at_medians;
    std::vector<TornadoBar> bars;  // in the order of the parameters
    EvaluationCount evaluations;
};

// Returns nothing where the work was stopped.
std::optional<TornadoResult> tornado(const Evaluator& evaluator, const InputSpace& space,
                                     const TornadoSettings& settings);

// A trajectory starts at a random point of a grid of `levels` equally spaced probabilities between the two quantiles
// and moves every parameter once, in random order, by levels / 2 steps. An elementary effect is the change of the
// quantity over the share of the range that was moved: how much the whole range between the quantiles would do.
// Source: M. D. Morris, Technometrics 33 (1991) 161-174; mean of the absolute effects: F. Campolongo, J. Cariboni &
// A. Saltelli, Environmental Modelling & Software 22 (2007) 1509-1518.
struct MorrisSettings {
    int trajectories = 30;
    int levels = 4;  // even
    double lower_probability = 0.05;
    double upper_probability = 0.95;
    static constexpr auto fields() {
        using S = MorrisSettings;
        return std::tuple{
            with_default(number("trajectories", &S::trajectories, Dimension::ratio, within(2, 1e6),
                                "walks in which each parameter changes once")),
            with_default(number("levels", &S::levels, Dimension::ratio, within(2, 1000),
                                "values of each parameter; even, since a step is half the levels")),
            with_default(number("lower_probability", &S::lower_probability, Dimension::ratio, lower_quantile,
                                "probability of the lower end")),
            with_default(number("upper_probability", &S::upper_probability, Dimension::ratio, upper_quantile,
                                "probability of the upper end")),
        };
    }
};

struct MorrisEffect {
    long effects = 0;  // found; the others had an evaluation without an answer. The rest needs at least two
    double mean = 0;
    Estimate mean_absolute;       // mu*: how much the parameter matters
    Estimate standard_deviation;  // sigma: how far that depends on where, by bends or by other parameters
};

struct MorrisResult {
    std::vector<MorrisEffect> parameters;
    EvaluationCount evaluations;
};

// Intervals: bootstrap over the effects. Nothing where the work was stopped.
std::optional<MorrisResult> morris(const Evaluator& evaluator, const InputSpace& space, const MorrisSettings& settings,
                                   std::uint64_t seed);

}  // namespace delabole
