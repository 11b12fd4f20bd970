// The results of a back-analysis and the numbers needed to judge them.
#pragma once

#include "fitting/mechanism/mechanism_posterior.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/work/evaluation.hpp"
#include "numerics/archive.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

enum class FitStatus {
    converged,         // the algorithm met its own tolerance in the best run
    evaluation_limit,  // the best run ended before its tolerance, usually at the cap; the answer is the best point seen
    no_valid_point,    // every evaluation failed
    interrupted,       // the caller asked to stop; the answer is the best point seen
};

// Minima of the multi-start runs, grouped if they agree within 1e-3 of the bounds and 0.01 of misfit.
struct MinimumCluster {
    std::vector<double> parameters;
    double misfit;
    int hits;
};

enum class Determination {
    determined,     // the 95 % interval closes inside the bounds
    bounded_below,  // only a lower limit
    bounded_above,  // only an upper limit
    undetermined,   // the misfit stays under the 95 % level up to both ends of the range
    doubtful,       // one or both ends close, but in_doubt() in verdict.hpp says that this is meaningless
};

// Least misfit as a function of one parameter, with the others free. Intervals follow from chi-square with one degree
// of freedom; their ends are found by root bracketing to 1e-4 of the range. An interval spans all values below the
// level, even if the profile rises above it in between.
struct ProfileLikelihood {
    std::string parameter;
    std::vector<double> values;   // ascending: the grid, the best value and the points that the interval ends needed
    std::vector<double> misfits;  // infinity where no valid point was found
    double least_misfit;          // the level of an interval is this + its chi-square quantile
    // If the profile is still below the level at the bound, or where the model ceases to have answers, the interval
    // ends there. Neither is evidence, so such an end does not count as closed.
    Interval interval_68;
    Interval interval_95;
    Determination determination;
    bool with_priors;  // whether the priors of the other and of this parameter were counted
    // Other parameters that lie at a bound of their range at an end of interval_95 and of which the data determine only
    // combinations with this one. Such an end is due to their range, is no evidence either and does not count as
    // closed.
    std::vector<std::string> lower_bounded_by = {};
    std::vector<std::string> upper_bounded_by = {};
};

// share_tasks uses this, and the members of the locus below.
DELABOLE_MEMBERS(ProfileLikelihood, parameter, values, misfits, least_misfit, interval_68, interval_95, determination,
                 with_priors, lower_bounded_by, upper_bounded_by)

enum class IdentifiabilityStatus {
    reliable,
    steps_disagree,      // sensitivities differ by over 1 % between two step sizes: a kink or a rough model
    model_fails_nearby,  // some parameter cannot be moved either way from the best point
    run_contradicts,     // the run at the best point disagrees with the surrogate; nothing further is evaluated
    not_evaluated,       // no valid point, or interrupted
};

// Derived from the Jacobian of the data residuals (without priors) at the best point, with columns scaled by the
// parameters' ranges. Satisfied inequalities have no weight in it.
struct Identifiability {
    IdentifiabilityStatus status = IdentifiabilityStatus::not_evaluated;
    std::vector<std::string> parameters;  // those with lower < upper, in the order of the rows of directions
    // Singular values of the scaled Jacobian, in standard deviations of data per range of parameter; as many as
    // parameters, descending.
    std::vector<double> singular_values;
    Eigen::MatrixXd directions;  // right singular vectors, one per column, in the order of singular_values
    // For each parameter, the greatest residual among the data that change by over half a standard deviation over its
    // range.
    std::vector<double> misses;
    int rank = 0;  // number of singular values above 1 / 2: a range of parameter moves the data by over half a sd
    int rank_with_priors = 0;  // the same with an additional row range / standard deviation for each prior
    std::string verdict = "Not evaluated.";     // text, printed before any fitted value
    std::optional<Eigen::MatrixXd> covariance;  // of data and priors, SI; only where rank_with_priors is full
    std::optional<Eigen::MatrixXd> correlation;
};

// Points in the plane of two free parameters at which the mechanism's factor of safety is 1; the others are at the best
// point.
struct FailureLocus {
    std::string x;
    std::string y;
    std::vector<Point> points;  // the points of one branch follow each other
    std::vector<int> branch;    // of each point, from 0
};

DELABOLE_MEMBERS(FailureLocus, x, y, points, branch)

// Misfit, including priors, over the plane of two free parameters, with the others at the best point. Row and column of
// z belong to y(row) and x(column).
struct MisfitMap {
    std::string x;
    std::string y;
    std::vector<double> x_values;
    std::vector<double> y_values;
    Eigen::MatrixXd misfit;  // infinity where the model has no answer
    double level_68;         // best misfit + chi-square quantile with two degrees of freedom
    double level_95;
};

struct ObservationFit {
    std::string label;
    std::string quantity;
    Relation relation = Relation::equal;
    Dimension dimension = Dimension::ratio;  // ratio also if no mechanism has the output that would tell
    double observed = 0;
    double standard_deviation = 0;    // including the scatter
    double scatter = 0;               // standard deviation of cases that differ by chance alone, about the prediction
    std::optional<double> predicted;  // absent if the mechanism does not predict the quantity
    double residual = 0;              // (predicted - observed) / standard deviation; 0 for a satisfied inequality
    std::string source;
};

// The observed profile against the predicted one, m.
struct ProfileFit {
    double rms = 0;                 // root mean square distance
    double scatter = 0;             // as in ObservationFit
    double standard_deviation = 0;  // including the scatter
    double residual() const { return rms / standard_deviation; }
};

// Two neighbouring runs with very different outcomes.
struct Jump {
    std::vector<double> at;  // midpoint of their parameters, SI
    double distance;         // greatest difference of a parameter, as a share of its range
    double difference;       // root of the sum of squares over the data, in their standard deviations
};

// How a costly mechanism was fitted. The misfits of its MechanismFit come from the surrogate, the predictions from a
// run at the best point.
struct SurrogateFit {
    struct Run {
        std::vector<double> parameters;
        double data_misfit;   // meaningful if the run had an answer
        std::string failure;  // why it had no answer
        bool coarse;          // a run of the coarse model, whose likelihood was hopelessly low
    };
    std::vector<Run> runs;       // those that the surrogate was made from, in the order in which they were chosen
    long coarse_runs = 0;        // made to find points with hopelessly low likelihood
    std::size_t components = 0;  // of the data, inequalities included
    double error = 0;      // root mean square error of predicting each run from the others; standard deviations of data
    double within_95 = 0;  // share of such predictions within 1.96 of their own standard deviations
    double scatter = 0;    // expected difference of runs at the same point, in standard deviations of data
    double evidence_error = 0;      // bound of the relative error; see costly_runs.hpp
    bool given_up = false;          // ended early because the evidence was too low
    double misfit_of_run = 0;       // data misfit of the run at the best point; infinite where it has no answer
    std::optional<Jump> jump = {};  // the steepest one found
};

struct MechanismFit {
    std::string name;
    std::string title;
    FitStatus status = FitStatus::no_valid_point;
    std::vector<FreeParameter> parameters;
    std::vector<Dimension> dimensions;  // of the parameters
    std::vector<double> best;           // SI, in the order of parameters; empty when no valid point
    double misfit = 0;                  // data + priors
    double data_misfit = 0;
    double prior_misfit = 0;
    int data_count = 0;  // number of observations compared; a profile counts with its number of vertices
    // misfit + 4 for each datum and each piece of field evidence that the mechanism does not predict, as if missed by
    // two standard deviations; otherwise a mechanism would gain by predicting less. Less 2 log_own_precision() of
    // Misfit. Infinite without a valid point.
    double ranking_score = 0;
    Prediction prediction;  // at the best point
    std::vector<ObservationFit> observations;
    std::optional<ProfileFit> profile_fit;
    // How much the scatter of predictions lowers the logarithm of the likelihood if the mean agrees with the data.
    double scatter_cost = 0;
    std::vector<std::string> explained;  // names of field evidence
    std::vector<std::string>
        unexplained;  // sentences: field evidence, quantities without prediction, residuals of data and priors beyond 2
    Identifiability identifiability;
    std::vector<ProfileLikelihood> profiles;  // with priors, then without
    std::vector<FailureLocus> loci;         // one for each pair of free parameters that the factor of safety depends on
    std::optional<MisfitMap> map;           // of the first two free parameters
    std::vector<MinimumCluster> minima;     // best first
    std::optional<SurrogateFit> surrogate;  // of a costly mechanism
    std::optional<MechanismPosterior> posterior;  // if the problem asks for it
    EvaluationCount evaluations;                  // including those of the posterior

    // The dimension of a parameter, by its name.
    Dimension dimension_of(const std::string& parameter) const {
        const auto found = std::ranges::find(parameters, parameter, &FreeParameter::name);
        return dimensions[static_cast<std::size_t>(found - parameters.begin())];
    }
};

struct FitResult {
    // Sorted by evidence, greatest first, including field evidence; without evidence by ranking_score, least first.
    std::vector<MechanismFit> mechanisms;
    double wall_seconds = 0;
};

}  // namespace delabole
