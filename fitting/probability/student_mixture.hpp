// A mixture of multivariate Student distributions in the shape of given points: for drawing near them, without ever
// leaving out what lies far.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace delabole {

// One per column. At least one point; all of one dimension.
Eigen::MatrixXd as_columns(const std::vector<std::vector<double>>& points);

class StudentMixture {
  public:
    // Tails that fall like a power, yet with a variance.
    static constexpr double degrees_of_freedom = 5;
    // Fewer make a component that fits the points and not what they were drawn from.
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
    // Coordinates in (0, 1) that a draw takes.
    std::size_t unit_dimension() const { return dimension_ + 2; }

    double log_density(std::span<const double> point) const;
    // Continuous in the coordinates but for the choice of the component, so that evenly spread ones give even draws.
    void draw(std::span<const double> unit, std::span<double> point) const;

  private:
    struct Component {
        double weight;
        Eigen::VectorXd mean;
        Eigen::MatrixXd factor;  // lower triangular, of the covariance
        double log_scale;        // log of weight and of the density at the mean, but for Student's constant
    };

    void fit(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights, std::size_t count, std::uint64_t seed);

    std::size_t dimension_;
    double log_constant_;
    std::vector<Component> components_;
};

}  // namespace delabole
