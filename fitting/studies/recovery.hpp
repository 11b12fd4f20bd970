// Whether a back-analysis says the truth: data are made from known parameters with the errors that the observations are
// given, the posterior is sampled as it would be for real data, and the truth is looked for in it, many times over.
//
// Where the truth is drawn from the prior, exactly 68 and 95 % of the intervals hold it and its rank among the draws is
// uniform, whatever the model (simulation-based calibration; S. Talts et al., arXiv 1804.06788, 2018): what departs
// from that beyond chance is a fault of the sampling. At fixed parameters coverage also tells how far the prior pulls.
//
// An inequality has no error that could be drawn. Of truths drawn from the prior those are kept with which it holds,
// with the probability exp(-pull^2 / 2) that the misfit gives it; ranks stay uniform. A truth at which the model has no
// answer is drawn again, as the posterior gives it no density. A profile, whose misfit is no probability of anything,
// is left out.
#pragma once

#include "fitting/posterior/fit_problem.hpp"
#include "fitting/posterior/posterior.hpp"
#include "fitting/probability/estimate.hpp"
#include "fitting/work/progress.hpp"

#include <concepts>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace delabole {

struct RecoverySettings {
    int repetitions = 200;         // >= 1
    std::vector<double> truth;     // one number per parameter of the mechanism, SI; empty: drawn from the prior
    PosteriorSettings posterior;   // of each repetition; its seed is of all
    int threads = 1;               // the result depends neither on these
    const Ranks* ranks = nullptr;  // nor on these
};

// Draws of each posterior among which the truth is ranked, few enough to be as good as independent.
inline constexpr int ranked_draws = 99;

// One repetition.
struct Recovered {
    PosteriorStatus status = PosteriorStatus::no_valid_point;
    bool has_truth = false;  // a truth was found at which the model has answers and the inequalities hold
    std::vector<double> truth;
    // For each free parameter:
    std::vector<double> mean;
    std::vector<double> standard_deviation;
    std::vector<int> rank;       // of the truth among ranked_draws, 0 to ranked_draws
    std::vector<int> inside_68;  // 1 where the interval holds the truth
    std::vector<int> inside_95;
};

template <class Type>
requires std::same_as<std::remove_const_t<Type>, Recovered>
auto members_of(Type& one) {
    return std::tie(one.status, one.has_truth, one.truth, one.mean, one.standard_deviation, one.rank, one.inside_68,
                    one.inside_95);
}

struct ParameterRecovery {
    std::string name;
    std::size_t index;  // among the mechanism's parameters
    Dimension dimension;
    Estimate coverage_68;  // shares of the repetitions, with their 95 % (binomial) intervals
    Estimate coverage_95;
    Estimate bias;               // mean of (posterior mean - truth) / posterior standard deviation
    double spread = 0;           // mean posterior standard deviation, SI
    std::vector<int> histogram;  // of the ranks, ten bins
    double uniformity = 0;       // probability that uniform ranks differ by as much (chi-square)
};

struct MechanismRecovery {
    std::string name;
    std::vector<Recovered> repetitions;         // those that were begun, in their order
    std::vector<ParameterRecovery> parameters;  // free ones, over the repetitions that count: with truth and converged
    int counted = 0;
    int without_truth = 0;
    int not_converged = 0;
    bool profile_left_out = false;
    bool interrupted = false;
};

// Throws std::invalid_argument for settings out of range and for what PriorSpace and Misfit refuse.
MechanismRecovery recover(const Mechanism& mechanism, const FitProblem& problem, const RecoverySettings& settings,
                          ProgressMeter& progress, StopFlag stop = nullptr);

}  // namespace delabole
