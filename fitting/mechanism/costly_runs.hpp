// Chooses the runs of a costly mechanism: some that fill the space of its priors first, then, with a surrogate made
// from these, runs at the points where the evidence is least certain.
//
// The first runs lie on a Sobol sequence, drawn from the priors with twice their standard deviations. If the mechanism
// has a coarse model, it is evaluated there first: points at which its likelihood is less than exp(-hopeless_misfit /
// 2) of the best keep the residuals of the coarse model and are never run. After that batches of `runs_at_a_time`
// follow at the points where
//     standard deviation of the likelihood x prior density
// is greatest among 1024 points drawn from the priors and 256 near the best of them; a point that is chosen lowers the
// value of its neighbours by their correlation. The work ends when the same quantity, averaged over the prior, is less
// than `tolerance` of the evidence (a bound of the relative error of the evidence due to the surrogate, as if it were
// wrong in the same way everywhere), when the number of runs allowed is reached, or when the evidence plus twice that
// error is below `log_evidence_to_beat`.
//
// The choice of runs does not depend on the number of threads or ranks.
#pragma once

#include "fitting/mechanism/surrogate.hpp"
#include "fitting/search/share.hpp"
#include "fitting/work/progress.hpp"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace delabole {

inline constexpr std::size_t runs_at_a_time = 8;
// The limit is high because a run may differ from the coarse one by several standard deviations of the data.
inline constexpr double hopeless_misfit = 60;

struct CostlyRuns {
    std::vector<KnownRun> runs;            // in the order in which they were chosen, coarse runs first
    std::unique_ptr<Surrogate> surrogate;  // null if too few runs had an answer
    double evidence_error = 0;             // relative, as described above
    bool given_up = false;                 // because the evidence was too low
    EvaluationCount evaluations;           // of the model itself
    EvaluationCount coarse_evaluations;
    bool stopped = false;
};

// Number of surrogate calls that one run counts as in a progress report.
inline constexpr long weight_of_run = 20'000;

// coarse: the same misfit with the mechanism's coarse model; null if it has none.
// log_evidence_to_beat: natural logarithm of the mean of exp(-data misfit / 2) over the prior; -infinity if there is no
// other mechanism to beat.
CostlyRuns make_costly_runs(const Misfit& misfit, const Misfit* coarse, const SurrogateSettings& settings,
                            std::uint64_t seed, double log_evidence_to_beat, const Workers& workers,
                            ProgressMeter& progress, StopFlag stop);

// The steepest jump among all pairs of full runs whose parameters differ by no more than 2 % of their ranges. It counts
// only if the two runs differ by at least half of the greatest difference between any runs, and by over four standard
// deviations of the data (or four times the scatter, if that is more).
std::optional<Jump> steepest_jump(const CostlyRuns& costly);

// The residuals of the runs for other standard deviations of the data. `as_judged` is the misfit with which they were
// made; the problem of `other` may differ from its problem only in what a run does not depend on.
std::vector<KnownRun> judged_by(const Misfit& other, const Misfit& as_judged, std::vector<KnownRun> runs);

}  // namespace delabole
