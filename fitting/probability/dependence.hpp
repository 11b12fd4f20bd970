// Uncertain parameters that depend on each other: given marginal distributions with a Gaussian copula.
//
// z = L u, x_i = F_i^-1(Phi(z_i)) with u independent standard normal numbers and L L^T the correlation matrix of z. A
// rank correlation r (Spearman's) of the parameters gives the correlation of z as 2 sin(pi r / 6). A linear correlation
// r (Pearson's, of the values themselves) equals that of z only if both distributions are normal; in general the
// correlation z of the normal numbers solves
//     r(z) = sum over k >= 1 of a_k b_k z^k / (s_1 s_2),
// a_k being the coefficients of x_1(z) over normalised Hermite polynomials (Mehler's formula). r(z) increases with z.
// Sources: A. Nataf, C. R. Acad. Sci. 225 (1962) 42-43; P.-L. Liu & A. Der Kiureghian, Probabilistic Engineering
// Mechanics 1 (1986) 105-112.
#pragma once

#include "fitting/probability/distribution.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace delabole {

enum class CorrelationMeasure {
    linear,  // Pearson's, of the values
    rank,    // Spearman's
};

struct Correlation {
    std::size_t first;
    std::size_t second;
    CorrelationMeasure measure;
    double coefficient;  // between -1 and 1, ends excluded
};

enum class DependenceCheck {
    valid,
    coefficient_out_of_reach,  // the two distributions have no joint distribution with this linear correlation
    not_positive_definite,     // each pair is possible, but not all of them together
};

struct NormalCorrelation {
    DependenceCheck check;
    double coefficient;  // of the standard normal numbers; 0 unless valid
    Interval reach;      // linear correlations that the two distributions allow, without the ends
};

// Accuracy of the coefficient found: 1e-9 up to 0.95, 1e-4 up to 0.999, where the series is cut off too early.
NormalCorrelation normal_correlation(const Marginal& first, const Marginal& second, CorrelationMeasure measure,
                                     double coefficient);

class InputSpace {
  public:
    // The correlations refer to marginals by index; each pair may occur at most once.
    InputSpace(std::vector<Marginal> marginals, const std::vector<Correlation>& correlations);

    // All other members are meaningful only if the check is valid.
    DependenceCheck check() const { return check_; }
    std::size_t faulty_correlation() const { return faulty_; }  // index of the correlation that is out of reach
    Interval reach() const { return reach_; }                   // and the values that it may have

    std::size_t size() const { return marginals_.size(); }
    const Marginal& marginal(std::size_t index) const { return marginals_[index]; }
    bool independent() const { return independent_; }
    const Eigen::MatrixXd& normal_correlations() const { return correlations_; }
    const Eigen::MatrixXd& factor() const { return factor_; }

    // Parameters from independent standard normal numbers.
    void values(std::span<const double> standard_normal, std::span<double> parameters) const;
    // Parameters from independent numbers uniform in (0, 1).
    void values_of_unit(std::span<const double> unit, std::span<double> parameters) const;

  private:
    std::vector<Marginal> marginals_;
    Eigen::MatrixXd correlations_;
    Eigen::MatrixXd factor_;  // lower triangular
    DependenceCheck check_ = DependenceCheck::valid;
    std::size_t faulty_ = 0;
    Interval reach_;
    bool independent_ = true;
};

// Greatest number of parameters of a study: GSL tabulates the Sobol sequence up to this dimension.
inline constexpr std::size_t most_parameters = 40;

}  // namespace delabole
