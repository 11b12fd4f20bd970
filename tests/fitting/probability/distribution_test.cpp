#include "fitting/probability/distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace delabole {
namespace {

const std::vector<Distribution>& all_kinds() {
    static const std::vector<Distribution> kinds{
        {Normal{35, 5}},          {Normal{35, 5}, 15, 70},   {Normal{10, 5}, 0, std::nullopt},
        {Normal{0, 1}, 4, 6},  // far in the tail
        {Lognormal{20, 6}},       {Lognormal{20, 6}, 5, 40}, {Exponential{0.08}},
        {Exponential{0.5}, 0, 1}, {Uniform{-3, 7}},          {Triangular{1, 2, 6}},
        {Triangular{1, 1, 6}},    {Triangular{1, 6, 6}},     {Beta{0.3, 0.1, 0, 1}},
        {Beta{20, 9, 0, 40}},     {Beta{0.5, 0.0017, 0, 1}},  // shapes of nearly 5e4, the narrowest there is
        {Beta{5, 4.5, 0, 10}},                                // shapes below 1: the ends are the likeliest values
    };
    return kinds;
}

TEST(Distribution, QuantileAndProbabilityAreInverse) {
    for (const Distribution& distribution : all_kinds()) {
        const Marginal marginal(distribution);
        for (const double z : {-6.0, -3.0, -1.0, -0.1, 0.0, 0.3, 1.5, 4.0, 6.0}) {
            const Probability expected = normal_probability(z);
            const double value = marginal.value(z);
            const Probability found = marginal.probability(value);
            // A value has 16 digits; the probability may be off by as much as it changes to a neighbouring value, and
            // by the rounding of the difference to that at the truncation. Shapes of 5e4 cost GSL five digits.
            const Probability above = marginal.probability(std::nextafter(value, INFINITY));
            const Probability below = marginal.probability(std::nextafter(value, -INFINITY));
            const auto tolerance = [&](double probability, double change) {
                return 1e-11 * probability + 4 * change + 1e-15;
            };
            EXPECT_NEAR(found.below, expected.below, tolerance(expected.below, above.below - below.below))
                << distribution.law.index() << " at " << z;
            EXPECT_NEAR(found.above, expected.above, tolerance(expected.above, below.above - above.above))
                << distribution.law.index() << " at " << z;
        }
    }
}

TEST(Distribution, QuantilesIncreaseAndStayInsideTheirLimits) {
    for (const Distribution& distribution : all_kinds()) {
        const Marginal marginal(distribution);
        double before = marginal.value(-9);
        for (double z = -8.875; z <= 9; z += 0.125) {
            const double value = marginal.value(z);
            EXPECT_TRUE(std::isfinite(value));
            EXPECT_GE(value, before) << distribution.law.index() << " at " << z;
            before = value;
        }
        EXPECT_GE(marginal.value(-9), distribution.lower.value_or(-INFINITY));
        EXPECT_LE(marginal.value(9), distribution.upper.value_or(INFINITY));
    }
}

TEST(Distribution, UpperTailKeepsItsDigits) {
    // 1 - p is rounded to nothing beyond 8.3 standard deviations; the exponential's quantile is -mean log(1 - p).
    const Marginal marginal({Exponential{2}});
    for (const double z : {5.0, 8.0, 12.0}) {
        const double expected = -2 * std::log(std::erfc(z / std::numbers::sqrt2) / 2);
        EXPECT_NEAR(marginal.value(z), expected, 1e-14 * expected);
    }
    const Marginal beta({Beta{0.5, std::sqrt(1.0 / 12), 0, 1}});  // shapes 1 and 1: uniform
    EXPECT_NEAR(1 - beta.value(5), std::erfc(5 / std::numbers::sqrt2) / 2, 1e-16);
}

TEST(Distribution, MomentsAreThoseGiven) {
    // 1e-10 of the standard deviation, as the header says.
    const auto expect = [](const Distribution& distribution, double mean, double deviation, double tolerance) {
        const Marginal marginal(distribution);
        EXPECT_NEAR(marginal.mean(), mean, tolerance * deviation) << distribution.law.index();
        EXPECT_NEAR(marginal.standard_deviation(), deviation, tolerance * deviation) << distribution.law.index();
    };
    expect({Normal{35, 5}}, 35, 5, 1e-10);
    expect({Lognormal{20, 6}}, 20, 6, 1e-10);
    expect({Lognormal{1, 10}}, 1, 10, 2e-5);
    expect({Exponential{0.08}}, 0.08, 0.08, 1e-10);
    expect({Uniform{-3, 7}}, 2, 10 / std::sqrt(12.0), 1e-10);
    expect({Beta{0.3, 0.1, 0, 1}}, 0.3, 0.1, 1e-10);
    // The kink at the mode costs 1e-5 (normal_integral.hpp).
    expect({Triangular{1, 2, 6}}, 3, std::sqrt((1 + 4 + 36 - 2 - 6 - 12) / 18.0), 1e-5);
}

TEST(Distribution, TruncatedNormalHasTheMeanOfTheTextbook) {
    // mean + deviation (density(a) - density(b)) / (probability between)
    const double a = -1;
    const double b = 0.5;
    const auto density = [](double z) { return std::exp(-z * z / 2) / std::sqrt(2 * std::numbers::pi); };
    const double kept = normal_probability(b).below - normal_probability(a).below;
    const Marginal marginal({Normal{10, 2}, 8, 11});
    EXPECT_NEAR(marginal.mean(), 10 + 2 * (density(a) - density(b)) / kept, 1e-10);
}

TEST(Distribution, BetaQuantilesInClosedForm) {
    // Shapes 2 and 1: F = x^2. Mean 2/3, variance 1/18.
    const Marginal marginal({Beta{2.0 / 3, std::sqrt(1.0 / 18), 0, 1}});
    for (const double probability : {1e-12, 1e-4, 0.1, 0.5, 0.9, 0.9999}) {
        EXPECT_NEAR(marginal.quantile(probability), std::sqrt(probability), 1e-12);
    }
}

TEST(Distribution, FaultsNameTheirKey) {
    const auto key_of = [](const Distribution& distribution) {
        const auto faults = check(distribution);
        return faults.empty() ? std::string() : std::string(faults.front().key);
    };
    EXPECT_EQ(key_of({Normal{0, 0}}), "standard_deviation");
    EXPECT_EQ(key_of({Normal{0, -1}}), "standard_deviation");
    EXPECT_EQ(key_of({Normal{NAN, 1}}), "mean");
    EXPECT_EQ(key_of({Lognormal{-1, 1}}), "mean");
    EXPECT_EQ(key_of({Lognormal{1, 11}}), "standard_deviation");
    EXPECT_EQ(key_of({Uniform{2, 2}}), "lower");
    EXPECT_EQ(key_of({Triangular{0, 3, 2}}), "mode");
    EXPECT_EQ(key_of({Beta{0.5, 0.5, 0, 1}}), "standard_deviation");
    EXPECT_EQ(key_of({Beta{0.5, 1e-4, 0, 1}}), "standard_deviation");
    EXPECT_EQ(key_of({Beta{1.5, 0.1, 0, 1}}), "mean");
    EXPECT_EQ(key_of({Normal{0, 1}, 2, 1}), "lower");
    EXPECT_EQ(key_of({Normal{0, 1}, 9, 10}), "lower");
    EXPECT_EQ(key_of({Uniform{0, 1}, 0.5, std::nullopt}), "lower");
    for (const Distribution& distribution : all_kinds()) {
        EXPECT_EQ(key_of(distribution), "");
    }
    EXPECT_THROW(Marginal({Normal{0, 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace delabole
