// Which parameters matter, from few evaluations: a tornado diagram, which moves one parameter at a time from the
// medians, and Morris's elementary effects at many points.
//
// Both move one parameter between given quantiles of its own distribution while the others are unchanged, so
// correlations play no part.
#pragma once

#include "fitting/probability/dependence.hpp"
#include "fitting/probability/estimate.hpp"
#include "fitting/search/evaluate_points.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace delabole {

struct TornadoSettings {
    double lower_probability = 0.05;
    double upper_probability = 0.95;
    static constexpr auto fields() {
        return FieldTable{
            with_default(number<&TornadoSettings::lower_probability>(lower_quantile, "probability of the lower end")),
            with_default(number<&TornadoSettings::upper_probability>(upper_quantile, "probability of the upper end")),
        };
    }
};

struct TornadoEnd {
    double parameter = 0;
    Evaluation answer;
};

struct TornadoBar {
    TornadoEnd low;   // the parameter at its lower quantile, all others at their medians
    TornadoEnd high;  // the parameter at its upper quantile, all others at their medians

    // Greatest difference of the quantity between the two ends and the medians; nothing if one of them has no answer.
    std::optional<double> swing(const Evaluation& at_medians) const;
};

struct TornadoResult {
    Evaluation at_medians;
    std::vector<TornadoBar> bars;  // in the order of the parameters
    EvaluationCount evaluations;
};

// Returns nothing if the work was stopped.
std::optional<TornadoResult> tornado(const Evaluator& evaluator, const InputSpace& space,
                                     const TornadoSettings& settings);

// A trajectory starts at a random point of a grid of `levels` equally spaced probabilities between the two quantiles
// and moves every parameter once, in random order, by levels / 2 steps. An elementary effect is the change of the
// quantity divided by the share of the range that was moved, and so estimates the effect of the whole range between the
// quantiles.
// Source: M. D. Morris, Technometrics 33 (1991) 161-174; mean of the absolute effects: F. Campolongo, J. Cariboni &
// A. Saltelli, Environmental Modelling & Software 22 (2007) 1509-1518.
struct MorrisSettings {
    int trajectories = 30;
    int levels = 4;  // even
    double lower_probability = 0.05;
    double upper_probability = 0.95;
    static constexpr auto fields() {
        using S = MorrisSettings;
        return FieldTable{
            with_default(number<&S::trajectories>(within(2, 1e6), "walks in which each parameter changes once")),
            with_default(
                number<&S::levels>(within(2, 1000), "values of each parameter; even, since a step is half the levels")),
            with_default(number<&S::lower_probability>(lower_quantile, "probability of the lower end")),
            with_default(number<&S::upper_probability>(upper_quantile, "probability of the upper end")),
        };
    }
};

struct MorrisEffect {
    long effects = 0;  // found; the others had an evaluation without an answer. The estimates below need at least two
    double mean = 0;
    Estimate mean_absolute;       // mu*: how much the parameter matters
    Estimate standard_deviation;  // sigma: how far that depends on the place, by curvature or other parameters
};

struct MorrisResult {
    std::vector<MorrisEffect> parameters;
    EvaluationCount evaluations;
};

// The intervals come from a bootstrap over the effects. Returns nothing if the work was stopped.
std::optional<MorrisResult> morris(const Evaluator& evaluator, const InputSpace& space, const MorrisSettings& settings,
                                   std::uint64_t seed);

}  // namespace delabole
