#include "fitting/probability/chain_diagnostics.hpp"

#include "fitting/probability/counted_random.hpp"
#include "fitting/probability/distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace delabole {
namespace {

using Chains = std::vector<std::vector<double>>;

// x(n + 1) = memory x(n) + noise with unit variance altogether, about a mean and times a scale of each chain.
Chains walks(double memory, std::size_t length, const std::vector<double>& means, const std::vector<double>& scales) {
    Chains chains;
    for (std::size_t number = 0; number < means.size(); ++number) {
        RandomStream random(7, RandomPurpose::chain, static_cast<std::uint32_t>(number));
        double x = normal_quantile(random.unit());
        std::vector<double>& chain = chains.emplace_back();
        for (std::size_t step = 0; step < length; ++step) {
            x = memory * x + std::sqrt(1 - memory * memory) * normal_quantile(random.unit());
            chain.push_back(means[number] + scales[number] * x);
        }
    }
    return chains;
}

TEST(ChainDiagnostics, EffectiveSizeOfAnAutoregressiveWalk) {
    for (const double memory : {0.0, 0.5, 0.9}) {
        const Chains chains = walks(memory, 5000, {0, 0, 0, 0}, {1, 1, 1, 1});
        const ChainDiagnostics found = diagnose(chains);
        // Autocorrelation memory^lag: time (1 + memory) / (1 - memory), which is itself estimated to about 10 %.
        const double expected = 20'000 * (1 - memory) / (1 + memory);
        EXPECT_NEAR(found.bulk_size / expected, 1, 0.2) << memory;
        EXPECT_LT(found.r_hat, 1.01);
        EXPECT_EQ(found.r_hat, r_hat(chains));
    }
}

TEST(ChainDiagnostics, FlagsAChainThatStandsElsewhere) {
    EXPECT_GT(r_hat(walks(0, 1000, {0, 0, 0, 2}, {1, 1, 1, 1})), 1.2);
}

TEST(ChainDiagnostics, FlagsAChainOfAnotherWidthByItsDistancesFromTheMedian) {
    EXPECT_GT(r_hat(walks(0, 1000, {0, 0, 0, 0}, {1, 1, 1, 4})), 1.1);
}

TEST(ChainDiagnostics, FlagsADriftByHalves) {
    Chains chains = walks(0, 1000, {0, 0}, {1, 1});
    for (std::vector<double>& chain : chains) {
        for (std::size_t step = 0; step < chain.size(); ++step) {
            chain[step] += 3e-3 * static_cast<double>(step);
        }
    }
    EXPECT_GT(r_hat(chains), 1.2);
}

TEST(ChainDiagnostics, DoNotChangeWithTheScaleOfTheValues) {
    Chains chains = walks(0.5, 500, {0, 0, 0.2}, {1, 1, 1});
    const ChainDiagnostics before = diagnose(chains);
    for (std::vector<double>& chain : chains) {
        for (double& value : chain) {
            value = std::exp(3 * value);
        }
    }
    // Ranks stay; distances from the median, which r_hat takes too, do not.
    EXPECT_EQ(diagnose(chains).bulk_size, before.bulk_size);
    EXPECT_EQ(diagnose(chains).tail_size, before.tail_size);
}

TEST(ChainDiagnostics, AChainThatNeverMovesIsWorthNothing) {
    const ChainDiagnostics found = diagnose(Chains{{1, 1, 1, 1, 1, 1}, {1, 1, 1, 1, 1, 1}});
    EXPECT_EQ(found.r_hat, std::numeric_limits<double>::infinity());
    EXPECT_EQ(found.bulk_size, 0);
    EXPECT_EQ(found.tail_size, 0);
}

TEST(ChainDiagnostics, RefuseChainsOfDifferentLength) {
    EXPECT_THROW(diagnose(Chains{{1, 2, 3, 4}, {1, 2, 3}}), std::invalid_argument);
    EXPECT_THROW(r_hat(Chains{}), std::invalid_argument);
}

}  // namespace
}  // namespace delabole
