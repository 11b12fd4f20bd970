#include "fitting/mechanism/surrogate.hpp"

#include "fitting/probability/distribution.hpp"

#include <Eigen/SVD>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace delabole {

namespace {

constexpr double least_share_of_component = 1e-3;

// E[exp(-min(0, r)^2 / 2)] for a normal r; 1 where the inequality holds.
double likelihood_of_inequality(double mean, double variance) {
    if (variance <= 0) {
        return mean >= 0 ? 1 : std::exp(-mean * mean / 2);
    }
    const double deviation = std::sqrt(variance);
    const double wider = 1 + variance;
    const double broken = std::exp(-mean * mean / (2 * wider)) / std::sqrt(wider) *
                          normal_probability(-mean / (deviation * std::sqrt(wider))).below;
    return normal_probability(mean / deviation).below + broken;
}

// Nodes and weights for the mean of a function of a standard normal number; exact up to degree 9.
constexpr std::array<double, 5> node{-2.8569700138728, -1.3556261799742659, 0, 1.3556261799742659, 2.8569700138728};
constexpr std::array<double, 5> weight{0.011257411327720691, 0.2220759220056126, 0.5333333333333333, 0.2220759220056126,
                                       0.011257411327720691};

double log_of(double value) {
    return value > 0 ? std::log(value) : -std::numeric_limits<double>::max() / 1e3;
}

// Without columns, where all data are inequalities, there are none.
Eigen::MatrixXd principal_directions(const Eigen::MatrixXd& rows) {
    if (rows.cols() == 0) {
        return Eigen::MatrixXd(0, 0);
    }
    const Eigen::RowVectorXd mean = rows.colwise().mean();
    const Eigen::BDCSVD<Eigen::MatrixXd> decomposition(rows.rowwise() - mean, Eigen::ComputeThinV);
    const Eigen::VectorXd share = decomposition.singularValues().cwiseAbs2();
    Eigen::Index kept = 0;
    while (kept < share.size() && share[kept] > least_share_of_component * share.sum()) {
        ++kept;
    }
    return decomposition.matrixV().leftCols(kept);
}

}  // namespace

double LikelihoodEstimate::log_deviation() const {
    const double log_ratio = log_mean_square - 2 * log_mean;
    // If the mean is negligible the deviation is the root of the mean square, and the ratio would overflow a double.
    constexpr double beyond_a_double = 700;
    if (log_ratio > beyond_a_double) {
        return log_mean_square / 2;
    }
    return log_mean + log_of(std::sqrt(std::expm1(std::max(log_ratio, 0.0))));
}

Surrogate::Surrogate(const Misfit& misfit, std::span<const KnownRun> runs, const Surrogate* before)
    : misfit_(misfit), free_(misfit.free_parameters()) {
    const std::vector<Datum> data = misfit.data();
    for (std::size_t index = 0; index < data.size(); ++index) {
        (data[index].relation == Relation::equal ? equality_ : inequality_).push_back(index);
    }
    std::vector<const KnownRun*> valid;
    for (const KnownRun& run : runs) {
        if (run.residuals.failure.empty()) {
            valid.push_back(&run);
        }
    }
    if (valid.size() < least_runs(free_.size())) {
        throw std::invalid_argument("Surrogate: too few runs with an answer");
    }
    const auto count = static_cast<Eigen::Index>(valid.size());
    Eigen::MatrixXd points(count, static_cast<Eigen::Index>(free_.size()));
    Eigen::MatrixXd equal(count, static_cast<Eigen::Index>(equality_.size()));
    for (Eigen::Index row = 0; row < count; ++row) {
        const KnownRun& run = *valid[static_cast<std::size_t>(row)];
        const std::vector<double> unit = unit_point(run.parameters);
        std::copy(unit.begin(), unit.end(), points.row(row).begin());
        for (std::size_t index = 0; index < equality_.size(); ++index) {
            equal(row, static_cast<Eigen::Index>(index)) = run.residuals.values[equality_[index]];
        }
    }
    basis_ = before != nullptr ? before->basis_ : principal_directions(equal);
    const Eigen::MatrixXd scores = equal * basis_;
    rest_ = (equal.rowwise().squaredNorm() - scores.rowwise().squaredNorm()).mean();
    for (Eigen::Index column = 0; column < scores.cols(); ++column) {
        values_.emplace_back(scores.col(column));
    }
    for (const std::size_t index : inequality_) {
        const double sign = data[index].relation == Relation::at_least ? 1 : -1;
        Eigen::VectorXd values(count);
        for (Eigen::Index row = 0; row < count; ++row) {
            values[row] = sign * valid[static_cast<std::size_t>(row)]->residuals.values[index];
        }
        values_.push_back(std::move(values));
    }
    for (std::size_t index = 0; index < values_.size(); ++index) {
        if (before != nullptr) {
            process_.emplace_back(points, values_[index], before->process_[index].shape());
        } else {
            process_.emplace_back(points, values_[index]);
        }
    }
}

std::vector<double> Surrogate::unit_point(std::span<const double> parameters) const {
    std::vector<double> unit;
    unit.reserve(free_.size());
    for (const std::size_t index : free_) {
        const Interval& range = misfit_.bounds()[index];
        unit.push_back((parameters[index] - range.lower) / (range.upper - range.lower));
    }
    return unit;
}

LikelihoodEstimate Surrogate::likelihood(std::span<const double> parameters) const {
    const std::vector<double> unit = unit_point(parameters);
    LikelihoodEstimate estimate{-rest_ / 2, -rest_};
    const std::size_t equalities = static_cast<std::size_t>(basis_.cols());
    for (std::size_t index = 0; index < process_.size(); ++index) {
        const auto [mean, variance] = process_[index].predict(unit);
        const double scatter = process_[index].scatter_variance();
        if (index < equalities) {
            const double known = 1 + scatter;
            const double all = known + variance;
            estimate.log_mean -= (std::log(all) + mean * mean / all) / 2;
            estimate.log_mean_square -=
                std::log(known) + std::log1p(2 * variance / known) / 2 + mean * mean / (known + 2 * variance);
            continue;
        }
        double first = 0;
        double second = 0;
        for (std::size_t place = 0; place < node.size(); ++place) {
            const double at = likelihood_of_inequality(mean + node[place] * std::sqrt(variance), scatter);
            first += weight[place] * at;
            second += weight[place] * at * at;
        }
        estimate.log_mean += log_of(first);
        estimate.log_mean_square += log_of(second);
    }
    return estimate;
}

Evaluation Surrogate::value(std::span<const double> parameters, Priors priors) const {
    const double data = -2 * likelihood(parameters).log_mean;
    return {data + (priors == Priors::counted ? misfit_.prior(parameters) : 0), {}};
}

Residuals Surrogate::residuals(std::span<const double> parameters) const {
    const std::vector<double> unit = unit_point(parameters);
    Residuals result;
    const std::size_t equalities = static_cast<std::size_t>(basis_.cols());
    for (std::size_t index = 0; index < process_.size(); ++index) {
        const auto [mean, variance] = process_[index].predict(unit);
        result.values.push_back(mean / std::sqrt(1 + variance + process_[index].scatter_variance()));
        result.idle.push_back(index >= equalities && mean >= 0);
    }
    return result;
}

double Surrogate::correlation(std::span<const double> left, std::span<const double> right) const {
    return process_.empty() ? 0 : process_.front().correlation(unit_point(left), unit_point(right));
}

Surrogate::Check Surrogate::leave_one_out() const {
    double squares = 0;
    long within = 0;
    long all = 0;
    for (std::size_t index = 0; index < process_.size(); ++index) {
        const std::vector<ProcessPrediction> predicted = process_[index].leave_one_out();
        for (std::size_t run = 0; run < predicted.size(); ++run) {
            const double error = predicted[run].mean - values_[index][static_cast<Eigen::Index>(run)];
            squares += error * error;
            within += error * error <= 1.96 * 1.96 * predicted[run].variance ? 1 : 0;
            ++all;
        }
    }
    const double runs = process_.empty() ? 1 : static_cast<double>(values_.front().size());
    return {std::sqrt(squares / runs), all == 0 ? 1 : static_cast<double>(within) / static_cast<double>(all)};
}

double Surrogate::scatter() const {
    double sum = 0;
    for (const GaussianProcess& process : process_) {
        sum += process.scatter_variance();
    }
    return std::sqrt(sum);
}

}  // namespace delabole
