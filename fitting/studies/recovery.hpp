// Whether a back-analysis recovers the truth: data are made from known parameters with the errors that the observations
// are given, the posterior is sampled as for real data, and the known parameters are compared with it, many times over.
//
// If the known parameters are drawn from the prior, exactly 68 and 95 % of the intervals hold them and their rank among
// the draws is uniform, whatever the model (simulation-based calibration; S. Talts et al., arXiv 1804.06788, 2018): a
// deviation beyond chance is a fault of the sampling. At fixed parameters the coverage also shows how far the prior
// shifts the result.
//
// An inequality has no error that could be drawn. Parameters drawn from the prior are therefore kept with the
// probability exp(-residual^2 / 2) that the misfit assigns to their inequalities; ranks stay uniform. Parameters at
// which the model has no answer are drawn again, since the posterior has no density there. A profile is left out,
// because its misfit is not the probability of an observation.
#pragma once

#include "fitting/posterior/fit_problem.hpp"
#include "fitting/posterior/posterior.hpp"
#include "fitting/probability/estimate.hpp"
#include "fitting/work/progress.hpp"
#include "numerics/archive.hpp"

#include <string>
#include <vector>

namespace delabole {

struct RecoverySettings {
    int repetitions = 200;         // >= 1
    std::vector<double> truth;     // one number per parameter of the mechanism, SI; empty: drawn from the prior
    PosteriorSettings posterior;   // of each repetition; its seed is that of the whole study
    int threads = 1;               // the result depends neither on this
    const Ranks* ranks = nullptr;  // nor on these
};

// Number of draws of each posterior among which the known parameters are ranked: few enough to be almost independent.
inline constexpr int ranked_draws = 99;

// One repetition.
struct Recovered {
    PosteriorStatus status = PosteriorStatus::no_valid_point;
    bool has_truth = false;  // parameters were found at which the model has answers and the inequalities hold
    std::vector<double> truth;
    // For each free parameter:
    std::vector<double> mean;
    std::vector<double> standard_deviation;
    std::vector<int> rank;       // of the truth among ranked_draws, 0 to ranked_draws
    std::vector<int> inside_68;  // 1 where the interval holds the truth
    std::vector<int> inside_95;
};

DELABOLE_MEMBERS(Recovered, status, has_truth, truth, mean, standard_deviation, rank, inside_68, inside_95)

struct ParameterRecovery {
    std::string name;
    std::size_t index;  // among the mechanism's parameters
    Dimension dimension;
    Estimate coverage_68;  // shares of the repetitions, with their 95 % (binomial) intervals
    Estimate coverage_95;
    Estimate bias;               // mean of (posterior mean - truth) / posterior standard deviation
    double spread = 0;           // mean posterior standard deviation, SI
    std::vector<int> histogram;  // of the ranks, ten bins
    double uniformity = 0;       // probability that uniform ranks deviate at least as much (chi-square)
};

struct MechanismRecovery {
    std::string name;
    std::vector<Recovered> repetitions;         // those that were begun, in order
    std::vector<ParameterRecovery> parameters;  // free ones, over repetitions with a truth that converged
    int counted = 0;
    int without_truth = 0;
    int not_converged = 0;
    bool profile_left_out = false;
    bool interrupted = false;
};

// Throws std::invalid_argument for settings out of range and for all that PriorSpace and Misfit do not accept.
MechanismRecovery recover(const Mechanism& mechanism, const FitProblem& problem, const RecoverySettings& settings,
                          ProgressMeter& progress, StopFlag stop = nullptr);

}  // namespace delabole
