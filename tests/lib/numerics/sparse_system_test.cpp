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

// Each column has the rows within `reach` of the diagonal, or all rows.
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

// The system is solved repeatedly with other values: pivots are kept, and chosen anew once they have become bad.
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
        // The backward error is some hundred roundings, times the growth at which pivots are chosen anew.
        EXPECT_LT((matrix * found - right).norm(), 1e-8 * (matrix.norm() * found.norm() + right.norm()));
    }
}

// Groups of three on a grid, each with its eight neighbours: elimination joins what lies far apart.
SparsePattern grid(int wide, int high) {
    SparsePattern pattern;
    for (int column = 0; column < 3 * wide * high; ++column) {
        const int x = column / 3 % wide;
        const int y = column / 3 / wide;
        for (int group = 0; group < wide * high; ++group) {
            if (std::abs(group % wide - x) <= 1 && std::abs(group / wide - y) <= 1) {
                pattern.row.insert(pattern.row.end(), {3 * group, 3 * group + 1, 3 * group + 2});
            }
        }
        pattern.column_begin.push_back(static_cast<int>(pattern.row.size()));
    }
    return pattern;
}

// The matrix is not symmetric, with diagonals as large as in stiffness with friction.
void set_values(SparseSystem& system, std::mt19937& random) {
    std::uniform_real_distribution<double> number(-1, 1);
    const SparsePattern& pattern = system.pattern();
    for (int column = 0; column < pattern.size(); ++column) {
        for (auto entry = static_cast<std::size_t>(pattern.column_begin[static_cast<std::size_t>(column)]);
             entry < static_cast<std::size_t>(pattern.column_begin[static_cast<std::size_t>(column) + 1]); ++entry) {
            system.values()[entry] = number(random) + (pattern.row[entry] == column ? 5 : 0);
        }
    }
}

TEST(SparseSystem, EliminatesGroupsAsDenseEliminationDoes) {
    std::mt19937 random(2);
    for (const auto& [wide, high] : {std::pair{5, 5}, {30, 1}, {9, 12}, {1, 40}}) {
        SparseSystem system(grid(wide, high), 3);
        for (int round = 0; round < 3; ++round) {
            set_values(system, random);
            const Eigen::MatrixXd matrix = dense(system);
            const Eigen::VectorXd right = Eigen::VectorXd::Random(matrix.rows());
            Eigen::VectorXd found = right;
            ASSERT_TRUE(system.solve(found));
            // Some hundred roundings; pivots grow by little where diagonals are large.
            EXPECT_LT((matrix * found - right).norm(), 1e-13 * (matrix.norm() * found.norm() + right.norm()));
            EXPECT_LT((found - matrix.partialPivLu().solve(right)).norm(), 1e-11 * found.norm());
        }
    }
}

// Diagonal groups that have no pivots at all: their neighbours have to come to their help, which dense matrices of some
// groups cannot give.
TEST(SparseSystem, SolvesWhatNeedsPivotsOfOtherGroups) {
    SparseSystem system(grid(2, 15), 3);
    std::mt19937 random(3);
    set_values(system, random);
    for (int column = 0; column < system.pattern().size(); ++column) {
        for (auto entry = static_cast<std::size_t>(system.pattern().column_begin[static_cast<std::size_t>(column)]);
             entry < static_cast<std::size_t>(system.pattern().column_begin[static_cast<std::size_t>(column) + 1]);
             ++entry) {
            if (system.pattern().row[entry] / 3 == column / 3) {
                system.values()[entry] = 0;
            }
        }
    }
    const Eigen::MatrixXd matrix = dense(system);
    const Eigen::VectorXd right = Eigen::VectorXd::Ones(matrix.rows());
    Eigen::VectorXd found = right;
    ASSERT_TRUE(system.solve(found));
    // The tolerance is that of KLU above.
    EXPECT_LT((matrix * found - right).norm(), 1e-8 * (matrix.norm() * found.norm() + right.norm()));
}

TEST(SparseSystem, SaysWhereGroupsHaveNoSolution) {
    SparseSystem zero(grid(6, 6), 3);
    Eigen::VectorXd vector = Eigen::VectorXd::Ones(zero.pattern().size());
    EXPECT_FALSE(zero.solve(vector));
    std::ranges::fill(zero.values(), std::numeric_limits<double>::quiet_NaN());
    EXPECT_FALSE(zero.solve(vector));
    std::mt19937 random(4);
    set_values(zero, random);
    vector.setOnes();
    EXPECT_TRUE(zero.solve(vector));
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
    // The system can still be used.
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
