// Samples of the parameters' distribution given the data: density proportional to exp(-misfit / 2) times the prior's,
// the misfit being chi-square of the data alone. A point where the model has no answer has no density.
//
// Several chains, each begun as a population drawn from the prior that moves by differential evolution towards the
// posterior. Then one walker of each goes on. Its steps are differences between points of an archive of earlier states
// of all chains, a third of them cut down by up to a factor of 30 for ridges that bend; snooker steps along the line
// through one of them; and draws from a mixture of Student distributions fitted to the archive. So they have the size
// and direction of the posterior without tuning, and reach every mode that any chain has found. The archive is fixed
// while draws are kept: the chain is then a plain Metropolis chain and its distribution exact. Where the diagnostics
// are not met, the draws only make the next archive, and the chains go on twice as long. The walk takes place in the
// standard normal numbers of prior_space.hpp.
//
// Accuracy: quantiles and means err as those of bulk_size or tail_size independent draws.
// Sources: C. J. F. ter Braak, Statistics and Computing 16 (2006) 239-249; C. J. F. ter Braak & J. A. Vrugt, Statistics
// and Computing 18 (2008) 435-446.
#pragma once

#include "fitting/posterior/posterior_settings.hpp"
#include "fitting/posterior/prior_space.hpp"
#include "fitting/probability/chain_diagnostics.hpp"
#include "fitting/search/evaluate_points.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace delabole {

// The chains have converged for a parameter at R-hat below 1.01 and effective sizes of bulk and tails above 400, as
// Vehtari et al. (2021) advise.
inline constexpr double greatest_r_hat = 1.01;
inline constexpr double least_effective_size = 400;

enum class PosteriorStatus {
    converged,
    not_converged,   // the diagnostics are not met within the evaluations allowed: the draws are no fair sample
    no_valid_point,  // no draw of the prior has an answer
    interrupted,
};

struct ParameterPosterior {
    std::string name;
    double mean = 0;
    double standard_deviation = 0;
    double median = 0;
    Interval interval_68 = {0, 0};  // between equal tails
    Interval interval_95 = {0, 0};
    ChainDiagnostics diagnostics{};
};

// Quantiles of one parameter from the first steps of every chain.
struct RunningQuantiles {
    int steps;  // of each chain
    double lower_95;
    double median;
    double upper_95;
    double r_hat;
};

struct Draw {
    int chain;
    std::vector<double> parameters;  // all of them, SI
    double misfit;                   // of the data
};

struct Posterior {
    PosteriorStatus status = PosteriorStatus::no_valid_point;
    std::vector<ParameterPosterior> parameters;          // those with lower < upper
    Eigen::MatrixXd correlation;                         // of them
    std::vector<Draw> draws;                             // thinned to `draws` of the settings, chain by chain
    std::vector<std::vector<RunningQuantiles>> running;  // of each parameter, 10 lengths up to the whole
    int steps = 0;                                       // of each chain, behind all of the above
    double acceptance = 0;                               // share of the steps that moved
    EvaluationCount evaluations;
};

// The parameters of the misfit's points are those of the prior, in SI. Same arguments, same result, whatever the number
// of threads. Without free parameters the one point there is, as one draw. Throws std::invalid_argument for settings
// outside their range.
Posterior sample_posterior(const Evaluator& misfit, const PriorSpace& prior, const PosteriorSettings& settings);

}  // namespace delabole
