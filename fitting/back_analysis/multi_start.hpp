// Many searches for the least misfit, each polished by a second algorithm, and the minima they found.
#pragma once

#include "fitting/back_analysis/search.hpp"
#include "fitting/mechanism/fit_result.hpp"

#include <span>
#include <vector>

namespace delabole {

struct MultiStartResult {
    MinimiseResult best;                 // evaluations: of all runs
    std::vector<MinimumCluster> minima;  // best first
};

// Starts at the prior means (the middle of the bounds where there is no prior), then at the points of a Sobol sequence;
// a global algorithm makes one run with the evaluations of all starts. The best run is polished once more to the full
// tolerance; its status is the result's.
MultiStartResult search_from_many_starts(const Search& search, Priors priors);

// Local minimum near a point: the polishing algorithm, and sbplx where that met failures, which spoil its quadratic
// model, or reached its cap.
MinimiseResult polish(const Search& search, Priors priors, std::span<const double> start, long evaluations);

// Best of the polished points.
MinimiseResult polish_best_of(const Search& search, Priors priors, const std::vector<std::vector<double>>& starts);

// Enters a minimum in the list, which stays sorted by misfit: in the first cluster within 1e-3 of every parameter's
// range and 0.01 of misfit, otherwise in one of its own.
void add_minimum(std::vector<MinimumCluster>& minima, std::span<const double> point, double misfit,
                 std::span<const Interval> bounds);

}  // namespace delabole
