// The figures of a back-analysis.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "plots/drawing/figure.hpp"

#include <optional>
#include <string_view>

namespace delabole {

// Misfit above the least one over the plane of the first two free parameters, with the 68 and 95 % regions, the minima
// of the starts and the locus of factor of safety 1. Nothing when the fit holds no map.
std::optional<Figure> misfit_map_figure(const MechanismFit& fit);

// Least misfit above its minimum against the value of one free parameter, with and without priors, as far as the fit
// holds them; the 68 and 95 % levels of chi-square with one degree of freedom, and the ends of the 95 % interval.
// Nothing when the fit holds no profile of that parameter.
std::optional<Figure> profile_likelihood_figure(const MechanismFit& fit, std::string_view parameter);

// The profile left standing as observed and as each mechanism predicts it at its best point, with the band that 95 % of
// the posterior's predictions keep to at each place, where it can be seen. Nothing when no profile was observed, or no
// mechanism predicts one. `toe_elevation` is added to heights.
std::optional<Figure> profiles_figure(const FitProblem& problem, const FitResult& result, double toe_elevation);

}  // namespace delabole
