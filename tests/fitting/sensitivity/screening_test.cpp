#include "fitting/sensitivity/screening.hpp"

#include "tests/fitting/test_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

using test::objective;
using test::Study;
using test::unit_box;

// The whole box is screened, so that effects are those of the papers.
MorrisSettings whole_box(int trajectories) {
    return {.trajectories = trajectories, .levels = 4, .lower_probability = 0, .upper_probability = 1};
}

TEST(Tornado, MovesEachParameterAloneBetweenItsQuantiles) {
    const InputSpace space({Marginal({Normal{10, 2}}), Marginal({Normal{5, 1}})},
                           {{0, 1, CorrelationMeasure::linear, 0.7}});  // plays no part
    Study study(objective([](std::span<const double> x) { return 3 * x[0] - x[1] * x[1]; }));
    const auto result = tornado(study.evaluator(), space, {.lower_probability = 0.05, .upper_probability = 0.95});
    ASSERT_TRUE(result);
    constexpr double z = 1.6448536269514722;  // 95 % quantile of the standard normal
    EXPECT_DOUBLE_EQ(result->at_medians.value, 5);
    EXPECT_NEAR(result->bars[0].low.parameter, 10 - 2 * z, 1e-12);
    EXPECT_NEAR(result->bars[0].low.answer.value, 5 - 6 * z, 1e-12);
    EXPECT_NEAR(result->bars[0].high.answer.value, 5 + 6 * z, 1e-12);
    EXPECT_NEAR(result->bars[1].high.answer.value, 30 - (5 + z) * (5 + z), 1e-12);
    EXPECT_NEAR(result->bars[0].swing(result->at_medians).value(), 12 * z, 1e-12);
    EXPECT_EQ(result->evaluations.total, 5);
}

TEST(Tornado, CountsEndsWithoutAnswer) {
    Study study([](std::span<const double> x) {
        return x[0] > 0.9 ? Evaluation{0, "crack_below_plane"} : Evaluation{x[0], {}};
    });
    const auto result = tornado(study.evaluator(), unit_box(1), {});
    EXPECT_FALSE(result->bars[0].swing(result->at_medians));
    EXPECT_EQ(result->evaluations.failed_by_cause.front().first, "crack_below_plane");
}

TEST(Morris, LinearEffectsAreTheSlopesEverywhere) {
    Study study(objective([](std::span<const double> x) { return 4 * x[0] - 0.5 * x[1] + 0 * x[2]; }));
    const auto result = morris(study.evaluator(), unit_box(3), whole_box(10), 1);
    const std::array slopes{4.0, -0.5, 0.0};
    for (std::size_t index = 0; index < slopes.size(); ++index) {
        const MorrisEffect& effect = result->parameters[index];
        EXPECT_EQ(effect.effects, 10);
        EXPECT_NEAR(effect.mean, slopes[index], 1e-13);
        EXPECT_NEAR(effect.mean_absolute.value, std::abs(slopes[index]), 1e-13);
        EXPECT_NEAR(effect.standard_deviation.value, 0, 1e-13);
    }
    EXPECT_EQ(result->parameters[2].mean_absolute.value, 0);  // exactly: nothing depends on it
    EXPECT_EQ(result->evaluations.total, 40);
}

TEST(Morris, ProductOfTwoHasTheEffectsOfItsLevels) {
    // The effect of one factor is the other one: 0, 1/3, 2/3 and 1 equally often, mean 1/2, deviation sqrt(5) / 6.
    Study study(objective([](std::span<const double> x) { return x[0] * x[1]; }));
    const auto result = morris(study.evaluator(), unit_box(2), whole_box(400), 3);
    for (const MorrisEffect& effect : result->parameters) {
        // Four standard errors of the mean of 400.
        EXPECT_NEAR(effect.mean_absolute.value, 0.5, 4 * std::sqrt(5.0) / 6 / 20);
        EXPECT_NEAR(effect.standard_deviation.value, std::sqrt(5.0) / 6, 0.04);
        EXPECT_TRUE(effect.mean_absolute.interval_95.contains(effect.mean_absolute.value));
        EXPECT_TRUE(effect.standard_deviation.interval_95.contains(effect.standard_deviation.value));
        EXPECT_LT(effect.mean_absolute.interval_95.upper - effect.mean_absolute.interval_95.lower, 0.1);
    }
}

TEST(Morris, FunctionOfHisPaperFallsIntoItsThreeGroups) {
    Study study(objective(test::morris_function));
    const auto result = morris(study.evaluator(), unit_box(20), whole_box(100), 5);
    for (std::size_t index = 0; index < 20; ++index) {
        const MorrisEffect& effect = result->parameters[index];
        const double mean = effect.mean_absolute.value;
        const double deviation = effect.standard_deviation.value;
        if (index < 7) {  // curved or interacting: the deviation is as large as the mean (the seventh only bends)
            EXPECT_GT(deviation, index == 6 ? 10 : 25) << index;
        } else if (index < 10) {  // important and nearly linear: the slope is 40
            EXPECT_NEAR(mean, 40, 5) << index;
            EXPECT_LT(deviation, 10) << index;
        } else {  // coefficients of 1
            EXPECT_LT(mean, 10) << index;
        }
    }
}

TEST(Morris, SameNumbersOnAnyNumberOfThreads) {
    Study one(objective(test::morris_function), 1);
    Study three(objective(test::morris_function), 3);
    const auto alone = morris(one.evaluator(), unit_box(20), whole_box(10), 5);
    const auto together = morris(three.evaluator(), unit_box(20), whole_box(10), 5);
    for (std::size_t index = 0; index < 20; ++index) {
        EXPECT_EQ(alone->parameters[index].mean_absolute.value, together->parameters[index].mean_absolute.value);
        EXPECT_EQ(alone->parameters[index].standard_deviation.interval_95.upper,
                  together->parameters[index].standard_deviation.interval_95.upper);
    }
}

TEST(Morris, EffectsBesideAFailureAreLost) {
    Study study([](std::span<const double> x) {
        return x[0] > 0.9 && x[1] > 0.9 ? Evaluation{0, "impossible"} : Evaluation{x[0] + x[1], {}};
    });
    const auto result = morris(study.evaluator(), unit_box(2), whole_box(50), 1);
    const long lost = 100 - result->parameters[0].effects - result->parameters[1].effects;
    EXPECT_GT(lost, 0);
    EXPECT_NEAR(result->parameters[0].mean_absolute.value, 1, 1e-13);
    EXPECT_EQ(result->evaluations.failed(), result->evaluations.failed_by_cause.front().second);
}

}  // namespace
}  // namespace delabole
