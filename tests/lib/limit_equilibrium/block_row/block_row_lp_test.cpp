// Compares the modes of rows of equal blocks with the bound by linear programming, which knows no modes.
#include "limit_equilibrium/block_row/block_row.hpp"
#include "limit_equilibrium/bound/block_assembly.hpp"
#include "limit_equilibrium/bound/lp_bound.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

struct RandomRow {
    int count;
    double slenderness;
    double base_friction;
    double interface_friction;
};

// The blocks are slender enough to topple on the plane, and friction lets thrust push a block forward.
RandomRow random_row(RandomProblem& random, int count) {
    const double slenderness = std::exp(random.uniform(std::log(1.0), std::log(30.0)));
    const double base = random.uniform(5, 60);
    return {count, slenderness, degrees(base), degrees(random.uniform(1, 89 - base))};
}

RowAnswer answer_of(const RandomRow& problem) {
    BlockRow row{};
    row.base = {degrees(1), problem.base_friction};
    row.interface = {problem.interface_friction};
    row.block.assign(static_cast<std::size_t>(problem.count), {problem.slenderness, 1, WeightOfBlock{1e4}, {}, {}});
    const BlockRowResult result = analyse(row);
    EXPECT_EQ(result.check, BlockRowCheck::valid);
    return result.answer;
}

double bound_of(const RandomRow& problem) {
    const std::vector<RectangularBlock> blocks(static_cast<std::size_t>(problem.count), {1, problem.slenderness, 1e4});
    const LpBound bound = largest_tilt(assemble_row(blocks, {problem.base_friction, problem.interface_friction}));
    EXPECT_EQ(bound.status, LpStatus::optimal);
    return std::atan(bound.value);
}

// The programme is right to about 1e-10.
constexpr double accuracy = 1e-8;

TEST(BlockRowAgainstBound, LimitInContactOfTwoBlocksIsTheBound) {
    RandomProblem random(4101);
    for (int repeat = 0; repeat < 2000; ++repeat) {
        const RandomRow row = random_row(random, 2);
        EXPECT_NEAR(answer_of(row).critical_tilt_in_contact, bound_of(row), accuracy)
            << row.slenderness << ' ' << row.base_friction << ' ' << row.interface_friction;
    }
}

TEST(BlockRowAgainstBound, LimitInContactOfThreeBlocksIsTheBound) {
    RandomProblem random(4102);
    for (int repeat = 0; repeat < 1000; ++repeat) {
        const RandomRow row = random_row(random, 3);
        EXPECT_NEAR(answer_of(row).critical_tilt_in_contact, bound_of(row), accuracy)
            << row.slenderness << ' ' << row.base_friction << ' ' << row.interface_friction;
    }
}

// No row can stand beyond the bound, whether its blocks are free or pressed together.
TEST(BlockRowAgainstBound, FreeBlocksFailAtOrBelowTheBound) {
    RandomProblem random(4103);
    for (int repeat = 0; repeat < 1000; ++repeat) {
        const RandomRow row = random_row(random, 2 + repeat % 2);
        EXPECT_LE(answer_of(row).critical_tilt, bound_of(row) + accuracy);
    }
}

}  // namespace
}  // namespace delabole
