#include "fitting/probability/dependence.hpp"

#include "fitting/probability/bracketed_root.hpp"
#include "fitting/probability/normal_integral.hpp"

#include <Eigen/Cholesky>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace delabole {

namespace {

constexpr std::size_t hermite_terms = 120;
using Coefficients = std::array<double, hermite_terms>;

// Coefficients of (x(z) - mean) / standard deviation over Hermite polynomials normalised to unit variance; entry [0]
// belongs to degree 1.
Coefficients hermite_coefficients(const Marginal& marginal) {
    Coefficients coefficients{};
    for (int node = 0; node < normal_nodes; ++node) {
        const double z = normal_node(node);
        const double weighted =
            normal_weight(node) * (marginal.value(z) - marginal.mean()) / marginal.standard_deviation();
        double previous = 0;
        double polynomial = 1;
        for (std::size_t degree = 1; degree <= hermite_terms; ++degree) {
            const auto n = static_cast<double>(degree);
            const double next = (z * polynomial - std::sqrt(n - 1) * previous) / std::sqrt(n);
            previous = polynomial;
            polynomial = next;
            coefficients[degree - 1] += weighted * polynomial;
        }
    }
    return coefficients;
}

double linear_correlation(const Coefficients& first, const Coefficients& second, double z) {
    double sum = 0;
    for (std::size_t degree = hermite_terms; degree > 0; --degree) {
        sum = (sum + first[degree - 1] * second[degree - 1]) * z;
    }
    return sum;
}

// Correlation of two parameters that are both functions of one normal number and rise together (sign 1) or against each
// other (sign -1).
double extreme_correlation(const Marginal& first, const Marginal& second, double sign) {
    return normal_integral([&](double z) {
        return (first.value(z) - first.mean()) / first.standard_deviation() *
               ((second.value(sign * z) - second.mean()) / second.standard_deviation());
    });
}

}  // namespace

NormalCorrelation normal_correlation(const Marginal& first, const Marginal& second, CorrelationMeasure measure,
                                     double coefficient) {
    if (measure == CorrelationMeasure::rank) {
        return {DependenceCheck::valid, 2 * std::sin(std::numbers::pi * coefficient / 6), between(-1, 1)};
    }
    const Interval reach = between(extreme_correlation(first, second, -1), extreme_correlation(first, second, 1));
    if (!reach.contains(coefficient)) {
        return {DependenceCheck::coefficient_out_of_reach, 0, reach};
    }
    const Coefficients of_first = hermite_coefficients(first);
    const Coefficients of_second = hermite_coefficients(second);
    const auto excess = [&](double z) { return linear_correlation(of_first, of_second, z) - coefficient; };
    constexpr double nearly_one = 1 - 1e-9;
    const double low = excess(-nearly_one);
    const double high = excess(nearly_one);
    if (low >= 0 || high <= 0) {
        // The given correlation lies beyond what the truncated series gives, but within reach of the two distributions.
        return {DependenceCheck::valid, low >= 0 ? -nearly_one : nearly_one, reach};
    }
    const auto root = bracketed_root(excess, RootBracket{-nearly_one, nearly_one, low, high}, 1e-14);
    return {DependenceCheck::valid, root.value_or(coefficient), reach};
}

InputSpace::InputSpace(std::vector<Marginal> marginals, const std::vector<Correlation>& correlations)
    : marginals_(std::move(marginals)) {
    if (marginals_.size() > most_parameters) {
        throw std::invalid_argument("InputSpace: " + std::to_string(marginals_.size()) + " parameters, at most " +
                                    std::to_string(most_parameters));
    }
    const auto count = static_cast<Eigen::Index>(marginals_.size());
    correlations_ = factor_ = Eigen::MatrixXd::Identity(count, count);
    for (std::size_t index = 0; index < correlations.size(); ++index) {
        const Correlation& given = correlations[index];
        const NormalCorrelation found = normal_correlation(marginals_.at(given.first), marginals_.at(given.second),
                                                           given.measure, given.coefficient);
        if (found.check != DependenceCheck::valid) {
            check_ = found.check;
            faulty_ = index;
            reach_ = found.reach;
            return;
        }
        const auto row = static_cast<Eigen::Index>(given.first);
        const auto column = static_cast<Eigen::Index>(given.second);
        correlations_(row, column) = correlations_(column, row) = found.coefficient;
        independent_ = independent_ && found.coefficient == 0;
    }
    if (independent_) {
        return;
    }
    const Eigen::LLT<Eigen::MatrixXd> cholesky(correlations_);
    // A pivot as small as this is a rounding error: the matrix counts as singular.
    if (cholesky.info() != Eigen::Success || !(cholesky.matrixLLT().diagonal().minCoeff() > 1e-7)) {
        check_ = DependenceCheck::not_positive_definite;
        return;
    }
    factor_ = cholesky.matrixL();
}

void InputSpace::values(std::span<const double> standard_normal, std::span<double> parameters) const {
    for (std::size_t row = 0; row < marginals_.size(); ++row) {
        double z = standard_normal[row];
        if (!independent_) {
            z = 0;
            for (std::size_t column = 0; column <= row; ++column) {
                z += factor_(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) *
                     standard_normal[column];
            }
        }
        parameters[row] = marginals_[row].value(z);
    }
}

void InputSpace::values_of_unit(std::span<const double> unit, std::span<double> parameters) const {
    std::array<double, most_parameters> standard_normal{};
    for (std::size_t index = 0; index < marginals_.size(); ++index) {
        standard_normal[index] = normal_quantile(unit[index]);
    }
    values(std::span(standard_normal).first(marginals_.size()), parameters);
}

}  // namespace delabole
