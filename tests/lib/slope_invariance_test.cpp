// Whether a jointed slope stands does not depend on how it is drawn.
#include "tests/support/random_slopes.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

TEST(RandomSlopes, StandOrFailTheSameHoweverTheyAreDrawn) {
    std::size_t stand = 0;
    // Small ones that are soon decided.
    for (const std::uint32_t seed : {3U, 4U, 7U, 9U}) {
        const std::vector<testing::Variant> variants = testing::verdicts_of(testing::random_slope(seed), seed);
        for (const testing::Variant& variant : variants) {
            EXPECT_EQ(variant.verdict, variants.front().verdict) << seed << ", " << variant.name;
        }
        EXPECT_NE(variants.front().verdict, testing::Verdict::none) << seed;
        stand += variants.front().verdict == testing::Verdict::stands ? 1 : 0;
    }
    EXPECT_GT(stand, 0U);
}

}  // namespace
}  // namespace delabole
