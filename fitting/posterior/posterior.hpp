// Samples from the distribution of the parameters given the data. Its density is proportional to exp(-misfit / 2) times
// that of the prior, the misfit being chi-square of the data alone; it is zero where the model has no answer.
//
// There are several chains. Each begins as a population drawn from the prior that moves by differential evolution
// towards the posterior, and one member of it then continues as a single chain. Its steps are of three kinds:
// differences between points of an archive of earlier states of all chains, a third of them shortened by up to a factor
// of 30 for curved ridges; snooker steps along the line through a point of the archive; and draws from a mixture of
// Student distributions fitted to the archive. The steps therefore have the size and direction of the posterior without
// tuning, and reach every mode that any chain has found. The archive does not change while draws are kept: the chain is
// then a plain Metropolis chain and its distribution exact. As long as the diagnostics are not met, the draws only form
// the next archive and the chains continue twice as long. The chains move in the standard normal numbers of
// prior_space.hpp.
//
// Accuracy: quantiles and means have the errors of bulk_size or tail_size independent draws.
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

// The chains have converged for a parameter if R-hat is below 1.01 and the effective sizes of bulk and tails are above
// 400, as Vehtari et al. (2021) advise.
inline constexpr double greatest_r_hat = 1.01;
inline constexpr double least_effective_size = 400;

enum class PosteriorStatus {
    converged,
    not_converged,   // the diagnostics are not met within the evaluations allowed: the draws are not reliable
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

// Quantiles of one parameter from the first steps of all chains.
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
    Eigen::MatrixXd correlation;                         // between these parameters
    std::vector<Draw> draws;                             // `draws` of the settings in number, chain by chain
    std::vector<std::vector<RunningQuantiles>> running;  // for each parameter, at 10 lengths up to the whole
    int steps = 0;                                       // of each chain, on which all of the above is based
    double acceptance = 0;                               // share of the steps that moved
    EvaluationCount evaluations;
};

// The parameters in the misfit's points are those of the prior, in SI. The same arguments give the same result for any
// number of threads. Without free parameters the only draw is the one point there is. Throws std::invalid_argument for
// settings outside their range.
Posterior sample_posterior(const Evaluator& misfit, const PriorSpace& prior, const PosteriorSettings& settings);

}  // namespace delabole
