// Gaussian process regression: a smooth function from its values at scattered points, each with an independent scatter.
//
// y(x) = level + f(x) + scatter. f has mean zero and the covariance amplitude^2 c(r), c the Matern function of
// order 5/2,
//     c(r) = (1 + s + s^2 / 3) exp(-s),  s = sqrt(5) r,  r^2 = sum of ((x_i - x'_i) / length_i)^2;
// the scatter is normal and independent from point to point; a chaotic model adds it to its smooth answer. The level is
// estimated by generalised least squares, and its uncertainty is included (ordinary kriging).
//
// The lengths and the ratio scatter / amplitude maximise the likelihood of the data, with the level and the amplitude
// eliminated, times a wide lognormal prior on each (median 0.5 of the box, factor e; median ratio 0.1, factor e^2),
// which matters only where the data do not decide. NLopt finds them from two starts.
//
// Source: C. E. Rasmussen & C. K. I. Williams, Gaussian Processes for Machine Learning, MIT Press 2006, equations 2.23
// to 2.26, 5.8 and (leave-one-out) 5.12.
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <span>
#include <vector>

namespace delabole {

struct ProcessShape {
    Eigen::VectorXd length;  // of each coordinate, > 0
    double scatter_ratio;    // standard deviation of the scatter over the amplitude, > 0
};

struct ProcessPrediction {
    double mean = 0;
    double variance = 0;  // of the smooth function at the point, without the scatter
};

class GaussianProcess {
  public:
    // points: one row each, coordinates in the unit box; at least two rows, as many as values; all finite. Where all
    // values are equal the prediction is that value without error.
    GaussianProcess(const Eigen::MatrixXd& points, const Eigen::VectorXd& values);
    // With a shape that is known beforehand this costs O(n^3), some hundred times less.
    GaussianProcess(const Eigen::MatrixXd& points, const Eigen::VectorXd& values, const ProcessShape& shape);

    const ProcessShape& shape() const { return shape_; }
    double amplitude() const { return std::sqrt(amplitude_squared_); }
    double scatter_variance() const { return amplitude_squared_ * shape_.scatter_ratio * shape_.scatter_ratio; }

    // O(n^2). Safe to call from several threads.
    ProcessPrediction predict(std::span<const double> point) const;

    // Correlation c between two points.
    double correlation(std::span<const double> left, std::span<const double> right) const;

    // Prediction at each of the points from all others; the variance includes the scatter. O(n^3).
    std::vector<ProcessPrediction> leave_one_out() const;

  private:
    Eigen::MatrixXd points_;  // divided by the lengths
    Eigen::VectorXd values_;
    ProcessShape shape_;
    double level_ = 0;
    double amplitude_squared_ = 0;
    Eigen::MatrixXd inverse_;   // of the correlation matrix with the scatter on its diagonal
    Eigen::VectorXd weights_;   // inverse (values - level)
    Eigen::VectorXd row_sums_;  // of the inverse
    double whole_sum_ = 0;      // sum of all elements of the inverse
};

}  // namespace delabole
