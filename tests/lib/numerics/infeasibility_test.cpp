#include "numerics/infeasibility.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

// The tolerance is the rounding of a few eliminations on numbers of the order of 1.
constexpr double rounding = 1e-12;

TEST(Infeasibility, OfEquationsWithAndWithoutASolution) {
    Infeasibility<double> infeasibility;
    EXPECT_NEAR(infeasibility({1, 1, 1, -1}, {3, 1}), 0, rounding);    // x = 2, 1
    EXPECT_NEAR(infeasibility({1, 1, 1, -1}, {1, 3}), 2, rounding);    // x = 2, -1
    EXPECT_NEAR(infeasibility({1, 1}, {-4}), 4, rounding);             // a sum that would have to be negative
    EXPECT_NEAR(infeasibility({1, -1, -1, 1}, {5, -5}), 0, rounding);  // one equation twice
    EXPECT_NEAR(infeasibility({0, 0}, {0}), 0, rounding);
}

// The right sides are made from unknowns that are not negative, half of them zero: a degenerate solution exists. One
// more equation asks for a sum of all unknowns lower than possible: then there is none.
TEST(Infeasibility, OfRandomEquations) {
    RandomProblem random(61);
    Infeasibility<double> infeasibility;
    for (int repeat = 0; repeat < 300; ++repeat) {
        const std::size_t rows = 1 + static_cast<std::size_t>(random.pick(20));
        const std::size_t columns = rows + static_cast<std::size_t>(random.pick(30));
        std::vector<double> coefficients;
        std::vector<double> right_sides(rows, 0.0);
        std::vector<double> unknowns;
        for (std::size_t column = 0; column < columns; ++column) {
            unknowns.push_back(random.chance(0.5) ? 0 : random.uniform(0, 1));
        }
        for (double& right_side : right_sides) {
            for (const double unknown : unknowns) {
                coefficients.push_back(random.uniform(-1, 1));
                right_side += coefficients.back() * unknown;
            }
        }
        // Up to fifty eliminations.
        EXPECT_LT(infeasibility(coefficients, right_sides), 1e-10) << rows << " by " << columns;
        coefficients.insert(coefficients.end(), columns, 1.0);
        right_sides.push_back(-0.25);
        EXPECT_GE(infeasibility(coefficients, right_sides), 0.25 - 1e-10) << rows << " by " << columns;
    }
}

}  // namespace
}  // namespace delabole
