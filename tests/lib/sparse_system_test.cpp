#include "numerics/sparse_system.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace delabole {
namespace {

// Full columns, or every column with the rows within so many of the diagonal.
SparsePattern band(int size, int reach) {
    SparsePattern pattern;
    for (int column = 0; column < size; ++column) {
        for (int row = std::max(0, column - reach); row <= std::min(size - 1, column + reach); ++row) {
            pattern.row.push_back(row);
        }
        pattern.column_begin.push_back(static_cast<int>(pattern.row.size()));
    }
    return pattern;
}

Eigen::MatrixXd dense(SparseSystem& system) {
    const SparsePattern& pattern = system.pattern();
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(pattern.size(), pattern.size());
    for (int column = 0; column < pattern.size(); ++column) {
        for (int entry = pattern.column_begin[static_cast<std::size_t>(column)];
             entry < pattern.column_begin[static_cast<std::size_t>(column) + 1]; ++entry) {
            matrix(pattern.row[static_cast<std::size_t>(entry)], column) =
                system.values()[static_cast<std::size_t>(entry)];
        }
    }
    return matrix;
}

// Again and again with other values: pivots are kept, and chosen anew where they have become bad.
TEST(SparseSystem, SolvesWhatDenseEliminationSolves) {
    SparseSystem system(band(60, 5));
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1, 1);
    std::uniform_int_distribution<int> exponent(-6, 6);
    for (int round = 0; round < 50; ++round) {
        for (double& value : system.values()) {
            value = number(random) * std::pow(10.0, exponent(random));
        }
        const Eigen::MatrixXd matrix = dense(system);
        const Eigen::VectorXd solution = Eigen::VectorXd::Random(60);
        Eigen::VectorXd found = matrix * solution;
        const Eigen::VectorXd right = found;
        ASSERT_TRUE(system.solve(found));
        // Backward error: some hundred roundings, and as much growth as makes pivots to be chosen anew.
        EXPECT_LT((matrix * found - right).norm(), 1e-8 * (matrix.norm() * found.norm() + right.norm()));
    }
}

TEST(SparseSystem, GivesTheSameBitsAgain) {
    Eigen::VectorXd first = Eigen::VectorXd::LinSpaced(200, -1, 1);
    Eigen::VectorXd second = first;
    for (Eigen::VectorXd* vector : {&first, &second}) {
        SparseSystem system(band(200, 7));
        for (std::size_t entry = 0; entry < system.values().size(); ++entry) {
            system.values()[entry] = std::sin(static_cast<double>(entry));
        }
        ASSERT_TRUE(system.solve(*vector));
    }
    EXPECT_EQ(first, second);
}

TEST(SparseSystem, SaysWhereThereIsNoSolution) {
    SparseSystem zero(band(3, 1));
    Eigen::VectorXd vector = Eigen::VectorXd::Ones(3);
    EXPECT_FALSE(zero.solve(vector));
    SparseSystem infinite(band(3, 1));
    std::ranges::fill(infinite.values(), std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(infinite.solve(vector));
    // It can be used on.
    for (std::size_t entry = 0; entry < zero.values().size(); ++entry) {
        zero.values()[entry] = entry % 3 == 0 ? 2 : 0.5;
    }
    vector.setOnes();
    EXPECT_TRUE(zero.solve(vector));
}

TEST(SparseSystem, CanBeMoved) {
    SparseSystem from(band(4, 0));
    std::ranges::fill(from.values(), 2.0);
    SparseSystem system = std::move(from);
    Eigen::VectorXd vector = Eigen::VectorXd::Ones(4);
    ASSERT_TRUE(system.solve(vector));
    EXPECT_EQ(vector, Eigen::VectorXd::Constant(4, 0.5));
}

}  // namespace
}  // namespace delabole
