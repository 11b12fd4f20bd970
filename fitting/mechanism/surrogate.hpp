// A surrogate replaces a mechanism whose every prediction is a run of minutes. It describes the residuals as smooth
// functions of the parameters, known from a number of runs, with their uncertainty.
//
// The residuals of the equalities are transformed into their principal components, which leaves their sum of
// squares unchanged; components that hold less than a thousandth of the scatter are replaced by the mean of their sum
// of squares. Each component, and each inequality by itself, is a Gaussian process (gaussian_process.hpp) whose scatter
// is the part of a run's outcome that does not depend on the parameters, because a pile of blocks is chaotic.
//
// The likelihood is then a random number, and the data misfit is that of its mean,
//     misfit = -2 ln E[exp(-chi-square / 2)] = sum over components (m^2 / (1 + v) + ln(1 + v)) + rest,
// m being the mean and v the variance of a component, which includes both scatter and uncertainty; inequalities are
// integrated by Gauss-Hermite quadrature. A point that is poorly known is thus neither excluded nor trusted. Where no
// run near by had an answer, the prediction comes from the nearest runs that had one.
//
// Sources: D. Higdon et al., J. Am. Stat. Assoc. 103 (2008) 570-583 (components); J. Sacks et al., Statistical Science
// 4 (1989) 409-423 (computer experiments); M. Jarvenpaa et al., Bayesian Analysis 16 (2021) 147-178 (where to run
// next).
#pragma once

#include "fitting/mechanism/misfit.hpp"
#include "fitting/search/gaussian_process.hpp"

#include <Eigen/Core>

#include <span>
#include <vector>

namespace delabole {

struct KnownRun {
    std::vector<double> parameters;  // of the mechanism, SI
    Residuals residuals;             // its failure text belongs to the model or to the misfit
    bool coarse = false;             // true: a run of the coarse model
};

// Likelihood of the data at one point: its mean and mean square over the uncertainty of the smooth functions. The
// scatter of the runs is averaged in both.
struct LikelihoodEstimate {
    double log_mean;
    double log_mean_square;

    // Logarithm of the standard deviation.
    double log_deviation() const;
};

class Surrogate {
  public:
    // Keeps a reference to the misfit. `before` is a surrogate of fewer runs, from which components and shapes are
    // taken over instead of being found again.
    Surrogate(const Misfit& misfit, std::span<const KnownRun> runs, const Surrogate* before = nullptr);

    // Least number of runs with an answer from which a surrogate can be made.
    static constexpr std::size_t least_runs(std::size_t free_parameters) { return 2 * free_parameters + 2; }

    const Misfit& misfit() const { return misfit_; }

    // Arguments as in Misfit: one number per parameter of the mechanism, SI.
    Evaluation value(std::span<const double> parameters, Priors priors) const;
    Residuals residuals(std::span<const double> parameters) const;

    LikelihoodEstimate likelihood(std::span<const double> parameters) const;
    // Correlation, 0 to 1, between two points of the component with the most scatter.
    double correlation(std::span<const double> left, std::span<const double> right) const;

    // Prediction of each run from the others: root mean square error of the residual vector, in standard deviations of
    // the data, and the share of components within 1.96 of their own standard deviations.
    struct Check {
        double error;
        double within_95;
    };
    Check leave_one_out() const;
    // Root of the sum over components of the scatter's variance: the expected difference between two runs at the same
    // point.
    double scatter() const;

    std::size_t components() const { return process_.size(); }

  private:
    std::vector<double> unit_point(std::span<const double> parameters) const;

    const Misfit& misfit_;
    std::vector<std::size_t> free_;
    std::vector<std::size_t> equality_;  // indices of residuals
    std::vector<std::size_t> inequality_;
    Eigen::MatrixXd basis_;  // equalities x components
    double rest_ = 0;
    // Components first, then inequalities with the sign that makes each of them "at least zero".
    std::vector<GaussianProcess> process_;
    std::vector<Eigen::VectorXd> values_;  // values from which each process was made
};

}  // namespace delabole
