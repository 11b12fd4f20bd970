// Measures the rounding of the row's tilts against the same templates with 50 digits, on the same double inputs.
#include "limit_equilibrium/block_row/block_row.hpp"
#include "limit_equilibrium/block_row/block_row_search.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_dec_float.hpp>

namespace delabole {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>;

std::vector<RowMember<Real>> exact(const std::vector<RowMember<double>>& members) {
    std::vector<RowMember<Real>> result;
    for (const RowMember<double>& member : members) {
        result.push_back({member.height, member.width, member.weight, member.base_friction, member.interface_friction,
                          member.contact});
    }
    return result;
}

TEST(BlockRowReference, TiltsToFiftyDigits) {
    RandomProblem random(19);
    int compared = 0;
    for (int count = 0; count < 300; ++count) {
        BlockRow row{};
        row.base = {0, degrees(random.uniform(1, 44))};
        row.interface = {degrees(random.uniform(1, 44))};
        for (int blocks = 1 + random.pick(4); blocks > 0; --blocks) {
            const double width = random.logarithmic(1, 3);
            row.block.push_back(
                {width * random.logarithmic(0.5, 10), width, WeightOfBlock{random.uniform(1, 5)}, {}, {}});
        }
        const RowSearchResult<double> rounded = RowSearch<double>(row_members(row)).search();
        const RowSearchResult<Real> reference = RowSearch<Real>(exact(row_members(row))).search();
        ASSERT_EQ(rounded.modes.size(), reference.modes.size());
        ASSERT_EQ(rounded.least.has_value(), reference.least.has_value());
        if (rounded.least) {
            EXPECT_EQ(rounded.modes[*rounded.least].roles, reference.modes[*reference.least].roles);
        }
        for (std::size_t index = 0; index < rounded.modes.size(); ++index) {
            const RowMode<double>& mode = rounded.modes[index].mode;
            const RowMode<Real>& truth = reference.modes[index].mode;
            EXPECT_EQ(mode.check, truth.check) << rounded.modes[index].roles;
            if (truth.check == RowModeCheck::admissible) {
                // A chain of a few dozen operations; 1 - mu c down to 0.07 costs one digit.
                EXPECT_NEAR(static_cast<double>(Real(mode.tangent) / truth.tangent), 1, 1e-13);
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 300);
}

}  // namespace
}  // namespace delabole
