// A mixture of multivariate Student distributions that has the shape of given points. Points drawn from it lie near the
// given ones, but no distant region is left out.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace delabole {

// The points as columns of a matrix; at least one point, all of one dimension.
Eigen::MatrixXd as_columns(const std::vector<std::vector<double>>& points);

class StudentMixture {
  public:
    // The tails then fall as a power of the distance, and the variance is still finite.
    static constexpr double degrees_of_freedom = 5;
    // A component of fewer points would fit their scatter instead of the distribution that they come from.
    static constexpr double least_members = 60;

    // Weights, means and covariances of at most `most_components` normal distributions by expectation-maximisation from
    // starts among the points (k-means++; numbers counted from the seed), each then given a Student distribution's
    // tails. Points: one per column, at least one, with weights > 0 that need not add up to anything; a component
    // needs the weight of `least_members` independent points. Source: A. P. Dempster, N. M. Laird & D. B. Rubin, J.
    // Royal Statistical Society B 39 (1977) 1-38; D. Arthur & S. Vassilvitskii, Proc. 18th ACM-SIAM SODA (2007)
    // 1027-1035.
    StudentMixture(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights, std::size_t most_components,
                   std::uint64_t seed);

    std::size_t size() const { return components_.size(); }
    std::size_t dimension() const { return dimension_; }
    // Number of coordinates in (0, 1) that a draw needs.
    std::size_t unit_dimension() const { return dimension_ + 2; }

    double log_density(std::span<const double> point) const;
    // A draw changes continuously with the coordinates, except where another component is chosen, so that evenly spread
    // coordinates give evenly spread draws.
    void draw(std::span<const double> unit, std::span<double> point) const;

  private:
    struct Component {
        double weight;
        Eigen::VectorXd mean;
        Eigen::MatrixXd factor;  // of the covariance, lower triangular
        double log_scale;        // log of weight and density at the mean, less the Student constant
    };

    void fit(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights, std::size_t count, std::uint64_t seed);

    std::size_t dimension_;
    double log_constant_;
    std::vector<Component> components_;
};

}  // namespace delabole
