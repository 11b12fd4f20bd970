// Least misfit as a function of one parameter, the others free.
//
// The curve is followed from the best point outwards in both directions, each minimisation starting from its
// neighbours' answers; further minima are points of the curve too, lest they fall between grid values; a second pass
// inwards catches the branches that the first one missed. Interval ends are roots of sqrt(misfit - least) -
// sqrt(level), a straight line for a quadratic misfit.
#pragma once

#include "fitting/back_analysis/search.hpp"
#include "fitting/mechanism/fit_result.hpp"

#include <span>
#include <vector>

namespace delabole {

// One curve for each free parameter. `minima` are those known, of this or a similar misfit. `best` is the minimum of
// the same misfit; if a curve finds a lower one it is replaced (polished) and the curves are traced again.
// `best.evaluations` are added to. Empty when `best` holds no point or the caller asked to stop.
std::vector<ProfileLikelihood> trace_profiles(const Search& search, Priors priors,
                                              std::span<const MinimumCluster> minima, MinimiseResult& best);

}  // namespace delabole
