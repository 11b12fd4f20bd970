// Uncertain parameters that depend on each other: given marginal distributions tied by a Gaussian copula.
//
// z = L u, x_i = F_i^-1(Phi(z_i)) with u independent standard normal numbers and L L^T the matrix of correlations in
// the space of z. A rank correlation (Spearman's) gives that of z as 2 sin(pi r / 6). A linear correlation (Pearson's,
// of the values themselves) is another number than that of z unless both distributions are normal. That of z
// solves
//     r(z) = sum over k >= 1 of a_k b_k z^k / (s_1 s_2),
// a_k being the coefficients of x_1(z) over normalised Hermite polynomials (Mehler's formula), which increases with z.
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
    coefficient_out_of_reach,  // no joint distribution of these two has this linear correlation
    not_positive_definite,     // each pair is possible, all together are not
};

struct NormalCorrelation {
    DependenceCheck check;
    double coefficient;  // of the standard normal numbers; 0 unless valid
    Interval reach;      // linear correlations that the two distributions allow, ends excluded
};

// Accuracy of the solved coefficient: 1e-9 up to 0.95, 1e-4 up to 0.999, where the series ends too early.
NormalCorrelation normal_correlation(const Marginal& first, const Marginal& second, CorrelationMeasure measure,
                                     double coefficient);

class InputSpace {
  public:
    // Indices of the correlations are those of the marginals; each pair at most once.
    InputSpace(std::vector<Marginal> marginals, const std::vector<Correlation>& correlations);

    // The rest is meaningful only where valid.
    DependenceCheck check() const { return check_; }
    std::size_t faulty_correlation() const { return faulty_; }  // where one is out of reach
    Interval reach() const { return reach_; }                   // and what it may be

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

// Most parameters of a study: what GSL tabulates of the Sobol sequence.
inline constexpr std::size_t most_parameters = 40;

}  // namespace delabole
