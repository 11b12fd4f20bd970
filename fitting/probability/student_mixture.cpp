#include "fitting/probability/student_mixture.hpp"

#include "fitting/probability/counted_random.hpp"
#include "fitting/probability/distribution.hpp"

#include <gsl/gsl_cdf.h>
#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace delabole {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// A standard deviation of 1e-5 is negligible in the space of standard normal numbers.
constexpr double least_variance = 1e-10;

struct NormalComponent {
    double weight;
    VectorXd mean;
    MatrixXd factor;
};

// Lower triangular Cholesky factor of a covariance matrix that may be singular.
MatrixXd factor_of(MatrixXd covariance) {
    covariance.diagonal().array() += least_variance + 1e-9 * covariance.trace();
    return Eigen::LLT<MatrixXd>(covariance).matrixL();
}

MatrixXd covariance_about(const MatrixXd& points, const VectorXd& mean, const VectorXd& share) {
    const MatrixXd centred = points.colwise() - mean;
    return centred * share.asDiagonal() * centred.transpose();
}

// Starting points that lie far from each other (k-means++).
std::vector<VectorXd> spread_points(const MatrixXd& points, const VectorXd& shares, std::size_t count,
                                    std::uint64_t seed) {
    RandomStream random(seed, RandomPurpose::fit, 0);
    std::vector<VectorXd> chosen;
    VectorXd squares = VectorXd::Ones(points.cols());  // of the distance to the nearest one chosen
    while (chosen.size() < count) {
        const VectorXd chances = shares.cwiseProduct(squares);
        if (!(chances.sum() > 0)) {
            break;
        }
        double rest = random.unit() * chances.sum();
        Index next = 0;
        while (next + 1 < points.cols() && rest > chances(next)) {
            rest -= chances(next++);
        }
        chosen.emplace_back(points.col(next));
        if (chosen.size() == 1) {
            squares.setConstant(std::numeric_limits<double>::infinity());
        }
        squares = squares.cwiseMin(VectorXd((points.colwise() - chosen.back()).colwise().squaredNorm().transpose()));
    }
    return chosen;
}

// Log of weight times normal density, without the constant that all components share.
VectorXd log_shares(const MatrixXd& points, const NormalComponent& component) {
    const MatrixXd scaled = component.factor.triangularView<Eigen::Lower>().solve(points.colwise() - component.mean);
    const double offset = std::log(component.weight) - component.factor.diagonal().array().log().sum();
    return (offset - scaled.colwise().squaredNorm().array() / 2).matrix().transpose();
}

// Probability that each point (row) belongs to each component (column).
MatrixXd responsibilities(const MatrixXd& points, const std::vector<NormalComponent>& components) {
    MatrixXd shares(points.cols(), static_cast<Index>(components.size()));
    for (std::size_t index = 0; index < components.size(); ++index) {
        shares.col(static_cast<Index>(index)) = log_shares(points, components[index]);
    }
    const VectorXd greatest = shares.rowwise().maxCoeff();
    shares = (shares.colwise() - greatest).array().exp().matrix();
    const VectorXd sums = shares.rowwise().sum();
    return shares.array().colwise() / sums.array();
}

// The entries of `shares` add up to `count`, the number of independent points.
std::vector<NormalComponent> improved(const MatrixXd& points, const MatrixXd& shares, double count) {
    std::vector<NormalComponent> components;
    for (Index column = 0; column < shares.cols(); ++column) {
        const double members = shares.col(column).sum();
        if (members < StudentMixture::least_members) {
            continue;
        }
        const VectorXd share = shares.col(column) / members;
        const VectorXd mean = points * share;
        components.push_back({members / count, mean, factor_of(covariance_about(points, mean, share))});
    }
    return components;
}

}  // namespace

MatrixXd as_columns(const std::vector<std::vector<double>>& points) {
    MatrixXd columns(static_cast<Index>(points.front().size()), static_cast<Index>(points.size()));
    for (Index column = 0; column < columns.cols(); ++column) {
        columns.col(column) = VectorXd::Map(points[static_cast<std::size_t>(column)].data(), columns.rows());
    }
    return columns;
}

StudentMixture::StudentMixture(const MatrixXd& points, const VectorXd& weights, std::size_t most_components,
                               std::uint64_t seed)
    : dimension_(static_cast<std::size_t>(points.rows())) {
    if (points.rows() < 1 || points.cols() < 1 || weights.size() != points.cols() || most_components < 1) {
        throw std::invalid_argument("StudentMixture: needs points and at least one component");
    }
    const auto d = static_cast<double>(dimension_);
    const double nu = degrees_of_freedom;
    // Logarithm of the normalising constant of the Student distribution, written for its covariance instead of its
    // scale matrix.
    log_constant_ = std::lgamma((nu + d) / 2) - std::lgamma(nu / 2) - d / 2 * std::log((nu - 2) * std::numbers::pi);
    fit(points, weights, most_components, seed);
}

void StudentMixture::fit(const MatrixXd& points, const VectorXd& weights, std::size_t count, std::uint64_t seed) {
    const VectorXd shares = weights / weights.sum();
    const double independent = 1 / shares.squaredNorm();
    count = std::clamp<std::size_t>(static_cast<std::size_t>(independent / least_members / 2), 1, count);
    const VectorXd middle = points * shares;
    const MatrixXd whole = covariance_about(points, middle, shares);
    std::vector<NormalComponent> components;
    for (const VectorXd& start : spread_points(points, shares, count, seed)) {
        // The component is narrow, so that each start attracts the points around it.
        components.push_back({1.0, start, factor_of(whole / static_cast<double>(count * count))});
    }
    constexpr int iterations = 30;
    for (int iteration = 0; iteration < iterations; ++iteration) {
        const MatrixXd belongings =
            responsibilities(points, components).array().colwise() * (shares * independent).array();
        std::vector<NormalComponent> next = improved(points, belongings, independent);
        if (next.empty()) {
            components.clear();
            break;
        }
        components = std::move(next);
    }
    if (components.size() <= 1) {
        components = {{1.0, middle, factor_of(whole)}};
    }
    double sum = 0;
    for (const NormalComponent& component : components) {
        sum += component.weight;
    }
    for (const NormalComponent& component : components) {
        const double weight = component.weight / sum;
        components_.push_back({weight, component.mean, component.factor,
                               std::log(weight) - component.factor.diagonal().array().log().sum()});
    }
}

double StudentMixture::log_density(std::span<const double> point) const {
    const Eigen::Map<const VectorXd> at(point.data(), static_cast<Index>(dimension_));
    const double exponent = (degrees_of_freedom + static_cast<double>(dimension_)) / 2;
    double greatest = -std::numeric_limits<double>::infinity();
    double sum = 0;  // of densities over exp(greatest)
    VectorXd scaled(at.size());
    for (const Component& component : components_) {
        scaled = at - component.mean;
        component.factor.triangularView<Eigen::Lower>().solveInPlace(scaled);
        const double term =
            component.log_scale - exponent * std::log1p(scaled.squaredNorm() / (degrees_of_freedom - 2));
        if (term > greatest) {
            sum = sum * std::exp(greatest - term) + 1;
            greatest = term;
        } else {
            sum += std::exp(term - greatest);
        }
    }
    return log_constant_ + greatest + std::log(sum);
}

void StudentMixture::draw(std::span<const double> unit, std::span<double> point) const {
    double rest = unit[0];
    std::size_t chosen = 0;
    while (chosen + 1 < components_.size() && rest > components_[chosen].weight) {
        rest -= components_[chosen++].weight;
    }
    const Component& component = components_[chosen];
    const double stretch =
        std::sqrt((degrees_of_freedom - 2) / gsl_cdf_chisq_Pinv(unit[dimension_ + 1], degrees_of_freedom));
    VectorXd normal(static_cast<Index>(dimension_));
    for (std::size_t index = 0; index < dimension_; ++index) {
        normal(static_cast<Index>(index)) = stretch * normal_quantile(unit[index + 1]);
    }
    Eigen::Map<VectorXd>(point.data(), static_cast<Index>(dimension_)) =
        component.mean + component.factor.triangularView<Eigen::Lower>() * normal;
}

}  // namespace delabole
