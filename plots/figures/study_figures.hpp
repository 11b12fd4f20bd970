// Figures of back-analyses, of the expected information of measurements, of recoveries, and of accuracy against cost.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/studies/information.hpp"
#include "fitting/studies/recovery.hpp"
#include "plots/drawing/figure.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// Misfit above the least one over the plane of the first two free parameters, with the 68 and 95 % regions, the minima
// of the starts and the locus of factor of safety 1. Nothing if the fit holds no map.
std::optional<Figure> misfit_map_figure(const MechanismFit& fit);

// Least misfit above its minimum against the value of one free parameter, with and without priors if the fit holds
// both; the 68 and 95 % levels of chi-square with one degree of freedom, and the ends of the 95 % interval. Nothing if
// the fit holds no profile of that parameter.
std::optional<Figure> profile_likelihood_figure(const MechanismFit& fit, std::string_view parameter);

// The observed profile and those that the mechanisms predict at their best points, with the band that holds 95 % of the
// posterior's predictions at each place, if it is wide enough to be seen. Nothing if no profile was observed or
// predicted. `toe_elevation` is added to heights.
std::optional<Figure> profiles_figure(const FitProblem& problem, const FitResult& result, double toe_elevation);

// The name of a variant as a figure shows it, e.g. "flat priors".
std::string variant_in_words(EvidenceVariant variant);

// The parts of the logarithm of each mechanism's evidence as bars to the left of 0, the shortest on top: misfit of the
// best point, share of the prior that the data leave, and data and field evidence that the mechanism does not predict;
// the 95 % interval of the sum if it is wide enough to be seen.
std::optional<Figure> evidence_figure(const FitResult& result);

// Logarithm of each mechanism's evidence, including field evidence, for changed priors and model errors.
std::optional<Figure> evidence_dependence_figure(const FitResult& result);

// The greatest R-hat of each mechanism's parameters against the length of its chains, with the limit.
std::optional<Figure> chain_agreement_figure(const FitResult& result);

// Median and 95 % interval of each parameter from the first steps of all chains, relative to the final median and in
// final standard deviations.
std::optional<Figure> running_quantiles_figure(const MechanismFit& fit);

// The distribution of each parameter and its prior on the diagonal; below it the 68 and 95 % regions of each pair with
// the locus of factor of safety 1 and the best point. At most the first six free parameters have panels.
std::optional<Figure> posterior_corner_figure(const MechanismFit& fit);

// Expected reduction of the standard deviation of each parameter by each candidate, averaged over mechanisms, with two
// standard errors either way; the candidate that tells most on top.
Figure information_figure(const std::vector<CandidateInformation>& candidates);

// Number of times that the truth had each rank among the draws, in bars of a tenth of the ranks, with the band that
// holds 95 % of the bars if ranks are uniform. The recovery must have repetitions of that parameter.
Figure rank_figure(const MechanismRecovery& recovery, const ParameterRecovery& parameter);

// Shares of the 68 and 95 % intervals that held the truth, with their 95 % intervals.
Figure coverage_figure(const MechanismRecovery& recovery);

// Settings that differ from the case in the same way.
struct TradeCloud {
    std::string legend = {};
    Polyline points = {};  // cost, error; both more than 0
};

struct TradeDrawing {
    std::string title = {};
    std::string cost = {};
    std::string error = {};
    std::string error_unit = {};
    std::vector<TradeCloud> clouds = {};
    Polyline front = {};    // by increasing cost
    double resolution = 0;  // least error that can be measured; 0: none
    std::vector<Label> labels = {};
};

Figure trade_figure(const TradeDrawing& drawing);

}  // namespace delabole
