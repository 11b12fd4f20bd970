// Factors of a large sparse matrix whose unknowns come in groups, as the three of each block do.
//
// Multifrontal elimination (Duff & Reid 1983, ACM TOMS 9, 302-325): groups with about the same neighbours are
// eliminated together, in a dense matrix of them and their neighbours, so that nearly all of the arithmetic is products
// of dense matrices. Rows are exchanged for pivots within such a set only: the matrix should be one whose diagonal
// groups are regular unless it is singular itself or nearly so, as stiffness with friction is. Whoever solves checks
// what is left over.
//
// The same numbers come out on every processor: sums are formed in one order, whatever the width of registers.
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
    // groups or none. `order`: the groups as they are best eliminated.
    FrontalFactors(const SparsePattern& pattern, int width, std::span<const int> order);

    // Values in the order of the pattern. False where a pivot is 0 or not finite.
    bool factor(std::span<const double> values);
    // Right-hand side in, solution out, by the factors of the last call, which has been true.
    void solve(Eigen::VectorXd& vector);

  private:
    // Its unknowns, pivots first, have rows in `lower`, which the pivots' columns make up; the other columns of the
    // pivots' rows are `upper`. What is left of the others' rows and columns goes to the parent.
    struct Front {
        std::size_t pivots;
        std::size_t others;
        std::size_t unknowns;     // first of them in unknown_
        std::size_t lower;        // first number in factor_, of columns of pivots + others numbers
        std::size_t upper;        // likewise, of columns of `pivots` numbers
        std::size_t first_pivot;  // in exchanged_
        std::size_t in_parent;    // first of the others' places in place_
        std::size_t parent;       // none: itself
        std::size_t children;     // how many of the fronts on the stack belong to it
    };
    struct Entry {
        std::size_t from;  // among the values
        std::size_t to;    // in factor_
    };

    void note_places(const Front& front, std::vector<std::size_t>& place) const;
    void find_places_in_parents(std::size_t unknowns);
    void find_entries(const SparsePattern& pattern, std::size_t width, const std::vector<std::size_t>& pivot_in);
    void take_up(const Front& child, const Front& front, const double* left, double* rest);
    bool eliminate(const Front& front, double* rest);

    std::vector<Front> front_ = {};  // each after all that are below it
    std::vector<int> unknown_ = {};
    std::vector<std::size_t> place_ = {};
    std::vector<Entry> entry_ = {};
    std::vector<double> factor_ = {};
    std::vector<int> exchanged_ = {};  // of each pivot: the row that it was exchanged with, among the front's
    std::vector<double> stack_ = {};   // what fronts have left over for their parents
    std::vector<double> rest_ = {};    // what the front will leave over that is being eliminated
    std::vector<double> gathered_ = {};
};

}  // namespace delabole
