// Linear equations with a constant pattern of entries and values that change from one solution to the next.
//
// Direct solution. Many unknowns in groups are eliminated by dense matrices (frontal_factors.hpp), in the order that
// KLU finds for their groups, and the solution is improved if its residual requires it. Systems with few unknowns,
// without groups, or with too large a residual after the elimination by dense matrices are solved by KLU (Davis &
// Palamadai Natarajan 2010, Algorithm 907, ACM TOMS 37-3): the ordering is found once for the pattern, and pivots are
// kept from one set of values to the next as long as they are good enough. Neither method calls BLAS: the result is the
// same on any number of threads and with any installed BLAS.
#pragma once

#include "numerics/sparse_pattern.hpp"

#include <Eigen/Core>

#include <memory>
#include <span>
#include <vector>

namespace delabole {

class SparseSystem {
  public:
    // The matrix is square with at least one row. With more than one unknown in a `group` the pattern is symmetric and
    // has all entries between two groups, which are contiguous, or none.
    explicit SparseSystem(SparsePattern pattern, int group = 1);
    ~SparseSystem();
    SparseSystem(SparseSystem&& other) noexcept;
    SparseSystem& operator=(SparseSystem&& other) noexcept;

    const SparsePattern& pattern() const { return pattern_; }
    // Values in the order of the pattern.
    std::span<double> values() { return value_; }

    // Replaces the right-hand side by the solution. Returns false, with the vector undefined, if the matrix is singular
    // to working precision or has entries that are not finite.
    bool solve(Eigen::VectorXd& vector);

  private:
    struct Factors;

    bool solve_by_klu(Eigen::VectorXd& vector);
    bool solve_by_fronts(Eigen::VectorXd& vector);
    Eigen::VectorXd left_over(const Eigen::VectorXd& right, const Eigen::VectorXd& solution) const;

    SparsePattern pattern_;
    std::vector<double> value_;
    std::unique_ptr<Factors> factors_;
};

}  // namespace delabole
