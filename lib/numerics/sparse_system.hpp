// Linear equations whose pattern of entries stays while their values change from one solution to the next.
//
// Direct solution. Many unknowns in groups are eliminated by dense matrices (frontal_factors.hpp), in the order that
// KLU finds for their groups, and the solution is improved once if that leaves something over. Few of them, those
// without groups, and those of which the dense matrices leave too much over are solved by KLU (Davis & Palamadai
// Natarajan 2010, Algorithm 907, ACM TOMS 37-3): the ordering is found once for the pattern, pivots once for some
// values and kept for the next ones as long as they are good enough. Neither calls BLAS: the same numbers come out on
// any number of threads and with whatever BLAS is installed.
#pragma once

#include "numerics/sparse_pattern.hpp"

#include <Eigen/Core>

#include <memory>
#include <span>
#include <vector>

namespace delabole {

class SparseSystem {
  public:
    // Square, with at least one row. More than one unknown in a `group`: the pattern is symmetric and has all entries
    // between two groups, which follow one another, or none.
    explicit SparseSystem(SparsePattern pattern, int group = 1);
    ~SparseSystem();
    SparseSystem(SparseSystem&& other) noexcept;
    SparseSystem& operator=(SparseSystem&& other) noexcept;

    const SparsePattern& pattern() const { return pattern_; }
    // Values in the order of the pattern.
    std::span<double> values() { return value_; }

    // Right-hand side in, solution out. False, with the vector undefined, where the matrix is singular to working
    // precision or has entries that are not finite.
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
