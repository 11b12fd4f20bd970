// Factors of a large sparse matrix whose unknowns come in groups, such as the three unknowns of each block.
//
// Multifrontal elimination (Duff & Reid 1983, ACM TOMS 9, 302-325): groups with about the same neighbours are
// eliminated together, in a dense matrix of them and their neighbours, so that nearly all of the arithmetic is products
// of dense matrices. Rows are exchanged for pivots only within such a set: the diagonal groups of the matrix should be
// regular unless the matrix itself is nearly singular, as is the case for stiffness with friction. The caller checks
// the residual.
//
// The result is the same on every processor: sums are formed in one order, whatever the width of registers.
#pragma once

#include "numerics/sparse_pattern.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <vector>

namespace delabole {

class FrontalFactors {
  public:
    // Unknowns 0 to width - 1 are the first group, and so on. The pattern is symmetric, with all entries between two
    // groups or none. `order`: a favourable order of elimination of the groups.
    FrontalFactors(const SparsePattern& pattern, int width, std::span<const int> order);

    // Factors the matrix; values are in the order of the pattern. Returns false if a pivot is 0 or not finite.
    bool factor(std::span<const double> values);
    // Replaces the right-hand side by the solution, with the factors of the last call, which must have returned true.
    void solve(Eigen::VectorXd& vector);

  private:
    // Its unknowns, pivots first, have rows in `lower`, which consists of the pivots' columns; the other columns of the
    // pivots' rows are `upper`. The remainder of the others' rows and columns goes to the parent.
    struct Front {
        std::size_t pivots;
        std::size_t others;
        std::size_t unknowns;     // first of them in unknown_
        std::size_t lower;        // first number in factor_, of columns of pivots + others numbers
        std::size_t upper;        // first number in factor_, of columns of `pivots` numbers
        std::size_t first_pivot;  // in exchanged_
        std::size_t in_parent;    // first of the others' places in place_
        std::size_t parent;       // its own index if it has none
        std::size_t children;     // number of fronts on the stack that belong to it
    };
    struct Entry {
        std::size_t from;  // index among the values
        std::size_t to;    // index in factor_
    };

    void note_places(const Front& front, std::vector<std::size_t>& place) const;
    void find_places_in_parents(std::size_t unknowns);
    void find_entries(const SparsePattern& pattern, std::size_t width, const std::vector<std::size_t>& pivot_in);
    void take_up(const Front& child, const Front& front, const double* left, double* rest);
    bool eliminate(const Front& front, double* rest);

    std::vector<Front> front_ = {};  // each after all fronts below it
    std::vector<int> unknown_ = {};
    std::vector<std::size_t> place_ = {};
    std::vector<Entry> entry_ = {};
    std::vector<double> factor_ = {};
    std::vector<int> exchanged_ = {};  // for each pivot the row with which it was exchanged, in the order of the front
    std::vector<double> stack_ = {};   // remainders of fronts for their parents
    std::vector<double> rest_ = {};    // remainder of the front that is being eliminated
    std::vector<double> gathered_ = {};
};

}  // namespace delabole
