#include "fitting/probability/sampling.hpp"

#include "fitting/probability/estimate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace delabole {
namespace {

TEST(CountedRandom, PhiloxGivesThePublishedAnswers) {
    // Known answers of the authors' Random123 library, philox4x32 with ten rounds.
    using Words = std::array<std::uint32_t, 4>;
    EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8}));
    EXPECT_EQ(philox({0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF, 0xFFFFFFFF}, {0xFFFFFFFF, 0xFFFFFFFF}),
              (Words{0x408F276D, 0x41C83B0E, 0xA20BC7C6, 0x6D5451FD}));
    EXPECT_EQ(philox({0x243F6A88, 0x85A308D3, 0x13198A2E, 0x03707344}, {0xA4093822, 0x299F31D0}),
              (Words{0xD16CFE09, 0x94FDCCEB, 0x5001E420, 0x24126EA1}));
}

TEST(CountedRandom, NumbersAreUniformAndIndependentOfEachOther) {
    const CountedRandom random(5, RandomPurpose::sample);
    constexpr std::size_t count = 20'000;
    double sum = 0;
    double squares = 0;
    double products = 0;
    for (std::size_t index = 0; index < count; ++index) {
        const double one = random.unit(index, 0) - 0.5;
        const double other = random.unit(index, 1) - 0.5;
        sum += one;
        squares += one * one;
        products += one * other;
    }
    // Four standard errors: 1 / sqrt(12 n), sqrt(1 / 180 n) and 1 / (12 sqrt(n)).
    const double root = std::sqrt(static_cast<double>(count));
    EXPECT_NEAR(sum / count, 0, 4 / (std::sqrt(12.0) * root));
    EXPECT_NEAR(squares / count, 1.0 / 12, 4 / (std::sqrt(180.0) * root));
    EXPECT_NEAR(products / count, 0, 4 / (12 * root));
}

TEST(CountedRandom, SeedPurposeAndDimensionMakeOtherNumbers) {
    std::set<std::uint64_t> seen;
    for (const std::uint64_t seed : {0U, 1U}) {
        for (const RandomPurpose purpose : {RandomPurpose::sample, RandomPurpose::bootstrap}) {
            for (std::uint32_t dimension = 0; dimension < 4; ++dimension) {
                for (std::uint64_t index = 0; index < 4; ++index) {
                    seen.insert(CountedRandom(seed, purpose).bits(index, dimension));
                }
            }
        }
    }
    EXPECT_EQ(seen.size(), 2U * 2 * 4 * 4);
}

TEST(SamplePlan, LatinHypercubeHasOnePointInEachStratum) {
    constexpr std::size_t points = 37;
    constexpr std::size_t dimension = 5;
    const SamplePlan plan(SamplingMethod::latin_hypercube, dimension, points, 3, 11);
    for (std::size_t replicate = 0; replicate < plan.replicates(); ++replicate) {
        std::array<std::set<std::size_t>, dimension> strata;
        for (std::size_t point = 0; point < points; ++point) {
            std::array<double, dimension> x{};
            plan.point(replicate * points + point, x);
            for (std::size_t coordinate = 0; coordinate < dimension; ++coordinate) {
                ASSERT_TRUE(x[coordinate] > 0 && x[coordinate] < 1);
                strata[coordinate].insert(static_cast<std::size_t>(x[coordinate] * points));
            }
        }
        for (const auto& of_coordinate : strata) {
            EXPECT_EQ(of_coordinate.size(), points);
        }
    }
}

TEST(SamplePlan, ShiftedSequenceFillsEveryElementaryBox) {
    // The first 2^m points of the first two coordinates: one in each box of sides 2^-k and 2^-(m - k).
    constexpr std::size_t m = 6;
    constexpr std::size_t points = 1 << m;
    const SamplePlan plan(SamplingMethod::sobol_sequence, 2, points, 2, 4);
    for (std::size_t replicate = 0; replicate < 2; ++replicate) {
        for (std::size_t k = 0; k <= m; ++k) {
            std::set<std::pair<int, int>> boxes;
            for (std::size_t point = 0; point < points; ++point) {
                std::array<double, 2> x{};
                plan.point(replicate * points + point, x);
                boxes.emplace(static_cast<int>(std::ldexp(x[0], static_cast<int>(k))),
                              static_cast<int>(std::ldexp(x[1], static_cast<int>(m - k))));
            }
            EXPECT_EQ(boxes.size(), points) << k;
        }
    }
}

TEST(SamplePlan, SequenceIsThatOfGslButForTheShift) {
    constexpr std::size_t dimension = 40;
    constexpr std::size_t count = 1000;
    const SobolSequence sequence(dimension, count, 9);
    const auto expected = sobol_points(dimension, count - 1);  // from the second point on
    std::array<double, dimension> origin{};
    sequence.point(0, 0, origin);
    const auto digits = [](double coordinate) { return static_cast<std::uint32_t>(std::ldexp(coordinate, 30)); };
    for (std::size_t index = 1; index < count; ++index) {
        std::array<double, dimension> x{};
        sequence.point(index, 0, x);
        for (std::size_t coordinate = 0; coordinate < dimension; ++coordinate) {
            ASSERT_EQ(digits(x[coordinate]) ^ digits(origin[coordinate]), digits(expected[index - 1][coordinate]));
        }
    }
}

TEST(SamplePlan, RefusesWhatGslDoesNotTabulate) {
    EXPECT_THROW(SobolSequence(41, 16, 1), std::invalid_argument);
    EXPECT_THROW(SobolSequence(0, 16, 1), std::invalid_argument);
    EXPECT_NO_THROW(SobolSequence(40, 16, 1));
}

}  // namespace
}  // namespace delabole
