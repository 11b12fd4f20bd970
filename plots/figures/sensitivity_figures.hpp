// The figures of a sensitivity study. Values that have a Dimension are given in SI.
#pragma once

#include "fitting/sensitivity/sensitivity.hpp"
#include "plots/drawing/figure.hpp"

#include <optional>
#include <string>
#include <vector>

namespace delabole {

struct StudiedQuantity {
    std::string name = {};  // "factor_of_safety"
    Dimension dimension = Dimension::ratio;
};

// The names of the parameters in the order of the results.
using ParameterNames = std::vector<std::string>;

// Range of the quantity when each parameter varies alone, the widest on top; parameters without an answer at an end are
// left out. `limit` is that of failure.
Figure tornado_range_figure(const StudiedQuantity& quantity, const TornadoResult& result,
                            const TornadoSettings& settings, const std::vector<UncertainParameter>& parameters,
                            const std::vector<Dimension>& dimensions, std::optional<double> limit);

// Mean absolute effect against the standard deviation of effects, with their 95 % intervals.
Figure morris_figure(const StudiedQuantity& quantity, const MorrisResult& result, const ParameterNames& names);

// First-order and total indices with their 95 % intervals, the largest total on top.
Figure sobol_indices_figure(const StudiedQuantity& quantity, const SobolIndicesResult& result,
                            const ParameterNames& names);

// Share of the samples in each bin; bins of failed samples have a different colour.
Figure histogram_figure(const StudiedQuantity& quantity, const PropagationResult& result,
                        const std::optional<FailureCriterion>& criterion);

// Share of the samples not above a value, with the share that failed.
Figure cumulative_figure(const StudiedQuantity& quantity, const PropagationResult& result,
                         const std::optional<FailureCriterion>& criterion);

// Probability of failure (without a criterion the mean) against the number of samples, with its 95 % interval and the
// result of first-order reliability.
Figure sampling_convergence_figure(const StudiedQuantity& quantity, const PropagationResult& result,
                                   std::optional<double> first_order_probability);

}  // namespace delabole
