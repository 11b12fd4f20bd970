// Linear equations whose pattern of entries stays while their values change from one solution to the next.
//
// Direct solution by KLU (Davis & Palamadai Natarajan 2010, Algorithm 907, ACM TOMS 37-3): the ordering is found once
// for the pattern, pivots once for some values and kept for the next ones as long as they are good enough. It calls no
// BLAS: the same numbers come out on any number of threads and with whatever BLAS is installed.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <span>
#include <vector>

namespace delabole {

// Compressed columns: the entries of column j are those from column_begin[j] to before column_begin[j + 1], with their
// rows in increasing order.
struct SparsePattern {
    std::vector<int> column_begin = {0};
    std::vector<int> row = {};

    int size() const { return static_cast<int>(column_begin.size()) - 1; }
};

class SparseSystem {
  public:
    // Square, with at least one row.
    explicit SparseSystem(SparsePattern pattern);
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

    SparsePattern pattern_;
    std::vector<double> value_;
    std::unique_ptr<Factors> factors_;
};

}  // namespace delabole
