#include "fitting/search/gaussian_process.hpp"

#include "fitting/search/minimise.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace delabole {

namespace {

constexpr double median_length = 0.5;
constexpr double median_ratio = 0.1;
constexpr Interval log_length{.lower = -3.5, .upper = 3.5};
constexpr Interval log_ratio{.lower = -9.2, .upper = 1.4};

// c as a function of r^2.
double matern_correlation(double squared_distance) {
    const double s = std::sqrt(5 * squared_distance);
    return (1 + s + s * s / 3) * std::exp(-s);
}

Eigen::Map<const Eigen::VectorXd> vector_of(std::span<const double> point) {
    return {point.data(), static_cast<Eigen::Index>(point.size())};
}

Eigen::MatrixXd correlation_matrix(const Eigen::MatrixXd& points, const ProcessShape& shape) {
    const Eigen::MatrixXd scaled = points * shape.length.cwiseInverse().asDiagonal();
    const Eigen::Index count = points.rows();
    Eigen::MatrixXd matrix(count, count);
    for (Eigen::Index column = 0; column < count; ++column) {
        for (Eigen::Index row = column; row < count; ++row) {
            matrix(row, column) = matern_correlation((scaled.row(row) - scaled.row(column)).squaredNorm());
            matrix(column, row) = matrix(row, column);
        }
    }
    matrix.diagonal().array() += shape.scatter_ratio * shape.scatter_ratio;
    return matrix;
}

// -2 ln of likelihood times prior, with level and amplitude eliminated; infinite where the matrix is not positive
// definite.
double minus_two_log_likelihood(const Eigen::MatrixXd& points, const Eigen::VectorXd& values,
                                const ProcessShape& shape) {
    const Eigen::LLT<Eigen::MatrixXd> factors(correlation_matrix(points, shape));
    if (factors.info() != Eigen::Success) {
        return std::numeric_limits<double>::infinity();
    }
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(values.size());
    const Eigen::VectorXd solved_ones = factors.solve(ones);
    const double level = solved_ones.dot(values) / solved_ones.sum();
    const Eigen::VectorXd rest = values - level * ones;
    const auto count = static_cast<double>(values.size());
    const double amplitude_squared = rest.dot(factors.solve(rest)) / count;
    const Eigen::MatrixXd lower = factors.matrixL();
    const double prior = (shape.length / median_length).array().log().square().sum() +
                         std::pow(std::log(shape.scatter_ratio / median_ratio) / 2, 2);
    return count * std::log(amplitude_squared) + 2 * lower.diagonal().array().log().sum() + prior;
}

ProcessShape shape_of(std::span<const double> logarithms) {
    ProcessShape shape{Eigen::VectorXd(static_cast<Eigen::Index>(logarithms.size()) - 1), std::exp(logarithms.back())};
    for (Eigen::Index index = 0; index < shape.length.size(); ++index) {
        shape.length[index] = std::exp(logarithms[static_cast<std::size_t>(index)]);
    }
    return shape;
}

ProcessShape most_likely_shape(const Eigen::MatrixXd& points, const Eigen::VectorXd& values) {
    const auto dimensions = static_cast<std::size_t>(points.cols());
    std::vector<Interval> bounds(dimensions, log_length);
    bounds.push_back(log_ratio);
    const Objective objective = [&](std::span<const double> logarithms) {
        return Evaluation{minus_two_log_likelihood(points, values, shape_of(logarithms)), {}};
    };
    MinimiseSettings settings;
    settings.algorithm = Algorithm::bobyqa;
    settings.evaluations = 60 + 20 * static_cast<long>(dimensions);
    settings.relative_tolerance = 1e-3;
    settings.initial_step = 0.1;
    MinimiseResult best;
    // Two starts, one with nearly all signal and one with nearly all scatter: the likelihood often has a maximum of
    // each kind.
    for (const double ratio : {0.03, 1.0}) {
        std::vector<double> start(dimensions, std::log(median_length));
        start.push_back(std::log(ratio));
        MinimiseResult found = minimise(objective, bounds, start, settings);
        if (found.value < best.value) {
            best = std::move(found);
        }
    }
    return best.found() ? shape_of(best.point)
                        : ProcessShape{Eigen::VectorXd::Constant(points.cols(), median_length), median_ratio};
}

bool all_equal(const Eigen::VectorXd& values) {
    return (values.array() == values[0]).all();
}

}  // namespace

GaussianProcess::GaussianProcess(const Eigen::MatrixXd& points, const Eigen::VectorXd& values)
    : GaussianProcess(points, values,
                      all_equal(values)
                          ? ProcessShape{Eigen::VectorXd::Constant(points.cols(), median_length), median_ratio}
                          : most_likely_shape(points, values)) {}

GaussianProcess::GaussianProcess(const Eigen::MatrixXd& points, const Eigen::VectorXd& values,
                                 const ProcessShape& shape)
    : points_(points * shape.length.cwiseInverse().asDiagonal()), values_(values), shape_(shape) {
    const Eigen::Index count = points.rows();
    inverse_ = correlation_matrix(points, shape).llt().solve(Eigen::MatrixXd::Identity(count, count));
    row_sums_ = inverse_.rowwise().sum();
    whole_sum_ = row_sums_.sum();
    level_ = row_sums_.dot(values) / whole_sum_;
    const Eigen::VectorXd rest = values.array() - level_;
    weights_ = inverse_ * rest;
    amplitude_squared_ = all_equal(values) ? 0 : rest.dot(weights_) / static_cast<double>(count);
}

ProcessPrediction GaussianProcess::predict(std::span<const double> point) const {
    const Eigen::RowVectorXd scaled = vector_of(point).cwiseQuotient(shape_.length).transpose();
    Eigen::VectorXd near(points_.rows());
    for (Eigen::Index row = 0; row < points_.rows(); ++row) {
        near[row] = matern_correlation((points_.row(row) - scaled).squaredNorm());
    }
    const double unknown_level = 1 - row_sums_.dot(near);
    const double share = 1 - near.dot(inverse_ * near) + unknown_level * unknown_level / whole_sum_;
    return {level_ + weights_.dot(near), amplitude_squared_ * std::max(share, 0.0)};
}

double GaussianProcess::correlation(std::span<const double> left, std::span<const double> right) const {
    return matern_correlation((vector_of(left) - vector_of(right)).cwiseQuotient(shape_.length).squaredNorm());
}

std::vector<ProcessPrediction> GaussianProcess::leave_one_out() const {
    // The level is estimated without the point as well: the projected inverse eliminates it.
    const Eigen::MatrixXd projected = inverse_ - row_sums_ * row_sums_.transpose() / whole_sum_;
    const Eigen::VectorXd weighted = projected * values_;
    std::vector<ProcessPrediction> predictions;
    predictions.reserve(static_cast<std::size_t>(values_.size()));
    for (Eigen::Index row = 0; row < values_.size(); ++row) {
        const double precision = projected(row, row);
        predictions.push_back({values_[row] - weighted[row] / precision, amplitude_squared_ / precision});
    }
    return predictions;
}

}  // namespace delabole
