// The steps of a back-analysis. Each takes the problem, its progress and its surrogate as a Search.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "fitting/mechanism/misfit.hpp"
#include "fitting/mechanism/surrogate.hpp"
#include "fitting/search/minimise.hpp"
#include "fitting/search/share.hpp"
#include "fitting/work/progress.hpp"

#include <optional>
#include <span>
#include <vector>

namespace delabole {

struct Search {
    const Misfit& misfit;
    ProgressMeter& progress;
    StopFlag stop = nullptr;
    const Surrogate* surrogate = nullptr;  // replaces a costly model

    bool stopped() const { return stop_requested(stop); }

    Workers workers() const {
        const FitSettings& settings = misfit.problem().settings;
        return {settings.threads, settings.ranks};
    }

    Evaluation evaluate(std::span<const double> parameters, Priors priors) const {
        progress.count();
        return surrogate != nullptr ? surrogate->value(parameters, priors) : misfit.value(parameters, priors);
    }

    Residuals residuals(std::span<const double> parameters) const {
        progress.count();
        return surrogate != nullptr ? surrogate->residuals(parameters) : misfit.residuals(parameters);
    }

    // Evaluates and records the evaluation in an account.
    Evaluation evaluate(std::span<const double> parameters, Priors priors, EvaluationCount& account) const {
        const Evaluation evaluation = evaluate(parameters, priors);
        account.record(evaluation);
        return evaluation;
    }

    Objective objective(Priors priors) const {
        return [this, priors](std::span<const double> parameters) { return evaluate(parameters, priors); };
    }
};

struct MultiStartResult {
    MinimiseResult best;                 // its evaluations are those of all runs
    std::vector<MinimumCluster> minima;  // best first
};

// Starts at the prior means (the middle of the bounds where there is no prior), then at the points of a Sobol sequence;
// a global algorithm makes one run with the evaluations of all starts. The best run is refined once more to the full
// tolerance, and that run's status is the result's.
MultiStartResult search_from_many_starts(const Search& search, Priors priors);

// Local minimum near a point, found by the polishing algorithm. Where this meets failures, which spoil its quadratic
// model, or reaches its cap, sbplx follows.
MinimiseResult polish(const Search& search, Priors priors, std::span<const double> start, long evaluations);

// The best result of polish() over several starts.
MinimiseResult polish_best_of(const Search& search, Priors priors, const std::vector<std::vector<double>>& starts);

// Adds a minimum to the list, which stays sorted by misfit: to the first cluster within 1e-3 of every parameter's range
// and 0.01 of misfit, otherwise as a new cluster.
void add_minimum(std::vector<MinimumCluster>& minima, std::span<const double> point, double misfit,
                 std::span<const Interval> bounds);

// The determination of a parameter by the ends of its interval that are evidence.
Determination determination_of(bool lower_closed, bool upper_closed);

// One profile for each free parameter. `minima` are those known, of this or a similar misfit. `best` is the minimum of
// the same misfit; if a profile finds a lower one it replaces `best` (polished) and the profiles are traced again. The
// evaluations are added to `best.evaluations`. Empty if `best` holds no point or the caller asked to stop.
std::vector<ProfileLikelihood> trace_profiles(const Search& search, Priors priors,
                                              std::span<const MinimumCluster> minima, MinimiseResult& best);

// The evaluations, but for that run, are added to the account. `best` needs a valid misfit.
// `scatter`: of runs that ought to be alike, standard deviations of data; meaningful where there is a surrogate.
Identifiability identify(const Search& search, std::span<const double> best, EvaluationCount& account,
                         double scatter = 0);

// One locus for each pair of free parameters on which the output "factor_of_safety" depends, the others at `best`; none
// when the model lacks that output or is costly, since a locus takes a thousand evaluations. The plane is scanned along
// the parameter that moves the factor of safety more: for each of map_points values of the other, changes of sign of FS
// - 1 between 17 equally spaced values are closed in by bracketing to 1e-10 of the range. Roots that pair up within one
// sixteenth of the range are missed, and so is a jump across 1 (no root there). The evaluations are added to the
// account.
std::vector<FailureLocus> trace_failure_loci(const Search& search, std::span<const double> best,
                                             EvaluationCount& account);

// `count` equally spaced values, both ends of the interval included; count >= 2.
std::vector<double> grid(const Interval& range, int count);

// Nothing with fewer than two free parameters. `best` and its misfit with priors are those of the fit; the evaluations
// are added to the account.
std::optional<MisfitMap> map_misfit(const Search& search, std::span<const double> best, double misfit,
                                    EvaluationCount& account);

// Fills in everything of `fit` that follows from `fit.best`: misfit parts, prediction, observations, profile distance,
// explained and unexplained evidence, ranking score. The misfit is that of the surrogate where there is one; the rest
// comes from the model. `found`: there is a best point.
void summarise(const Misfit& misfit, const Surrogate* surrogate, bool found, MechanismFit& fit);

}  // namespace delabole
