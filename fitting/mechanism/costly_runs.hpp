// Which runs of a costly mechanism to make: first some that fill the space of its priors, then, by the surrogate made
// of them, those of which the evidence knows least.
//
// The first runs lie on a Sobol sequence, drawn through the priors with twice their standard deviations. Where the
// mechanism has a coarse model it is asked there first: points that it finds hopeless (their likelihood is under
// exp(-hopeless_misfit / 2) of the best) are left to what it says, and never run. After that
// batches of `runs_at_a_time`, each at the points where
//     standard deviation of the likelihood x prior density
// is greatest: of 1024 points drawn from the priors and of 256 near the best of them; a point chosen lowers the worth
// of its neighbours by their correlation. The work ends when the same quantity, averaged over the prior, is less than
// `tolerance` of the evidence (a bound of the relative error of the evidence that the surrogate causes, as if it were
// wrong in the same way everywhere), with the number of runs allowed, or once twice that error added to the evidence
// leaves it below `log_evidence_to_beat`.
//
// The runs do not depend on the number of threads and ranks.
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
// A run may differ from the coarse one by several standard deviations of the data.
inline constexpr double hopeless_misfit = 60;

struct CostlyRuns {
    std::vector<KnownRun> runs;            // in the order in which they were chosen, hopeless ones first
    std::unique_ptr<Surrogate> surrogate;  // none where too few runs had an answer
    double evidence_error = 0;             // relative, as above
    bool given_up = false;                 // for want of evidence
    EvaluationCount evaluations;           // of the model itself
    EvaluationCount coarse_evaluations;
    bool stopped = false;
};

// One run counts as so many surrogate calls in a progress report.
inline constexpr long weight_of_run = 20'000;

// coarse: the same misfit by the mechanism's coarse model; null: it has none.
// log_evidence_to_beat: natural logarithm of the mean of exp(-data misfit / 2) over the prior, -infinity: no rival.
CostlyRuns make_costly_runs(const Misfit& misfit, const Misfit* coarse, const SurrogateSettings& settings,
                            std::uint64_t seed, double log_evidence_to_beat, const Workers& workers,
                            ProgressMeter& progress, StopFlag stop);

// The steepest of all pairs of full runs whose parameters differ by no more than 2 % of their ranges, if half of all
// that runs differ by lies between the two, and over four standard deviations of the data (four times the scatter where
// that is more).
std::optional<Jump> steepest_jump(const CostlyRuns& costly);

// The runs as they would be judged with other standard deviations of the data: `as_judged` is the misfit that they were
// made with, `other` that of a problem that differs from its problem in nothing else that a run depends on.
std::vector<KnownRun> judged_by(const Misfit& other, const Misfit& as_judged, std::vector<KnownRun> runs);

}  // namespace delabole
