#include "fitting/sensitivity/propagation.hpp"

#include "tests/fitting/test_functions.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

namespace delabole {
namespace {

using test::independent;
using test::objective;
using test::Study;
using test::unit_box;

// The margin of three normal parameters has mean 2 and deviation sqrt(1 + 0.25 + 0.36): p_f = Phi(-1.576).
double margin(std::span<const double> x) {
    return 2 + x[0] - 0.5 * x[1] + 0.6 * x[2];
}
const double margin_deviation = std::sqrt(1 + 0.25 + 0.36);
const double margin_failure = std::erfc(2 / margin_deviation / std::sqrt(2.0)) / 2;
const FailureCriterion below_zero{0, FailureSide::below, {}, {}};

PropagationResult propagated(SamplingMethod method, long samples, std::uint64_t seed = 1, int threads = 1) {
    Study study(objective(margin), threads);
    return propagate(study.evaluator(), independent(3, Normal{0, 1}), {method, samples, 16}, below_zero, seed);
}

TEST(Propagation, LinearMarginHasTheMomentsAndTheProbabilityOfTheTextbook) {
    // Standard errors of 16 384 independent samples: 0.0099 of the mean, 0.0018 of the probability; Latin hypercubes
    // take the linear part away, a sequence nearly everything.
    struct Expected {
        SamplingMethod method;
        double mean;
        double probability;
    };
    for (const Expected& expected :
         {Expected{SamplingMethod::monte_carlo, 0.04, 0.0075}, Expected{SamplingMethod::latin_hypercube, 1e-3, 0.0075},
          Expected{SamplingMethod::sobol_sequence, 1e-3, 0.002}}) {
        const PropagationResult result = propagated(expected.method, 16'384);
        EXPECT_EQ(result.status, PropagationStatus::finished);
        EXPECT_EQ(result.samples, 16'384);
        EXPECT_NEAR(result.mean.value, 2, expected.mean);
        EXPECT_NEAR(result.standard_deviation, margin_deviation, 0.03);
        EXPECT_NEAR(result.failure->probability->value, margin_failure, expected.probability);
        EXPECT_EQ(result.failure->least, result.failure->greatest);  // every sample has an answer
        for (const auto& [share, value] : result.quantiles) {
            const double exact = 2 + margin_deviation * normal_quantile(share);
            // Four standard errors of a quantile of independent samples, share (1 - share) / n over the density.
            const double z = (exact - 2) / margin_deviation;
            const double density = std::exp(-z * z / 2) / std::sqrt(2 * M_PI) / margin_deviation;
            EXPECT_NEAR(value, exact, 4 * std::sqrt(share * (1 - share) / 16'384) / density) << share;
        }
    }
}

TEST(Propagation, IntervalsCoverTheTruthAsOftenAsTheySay) {
    for (const SamplingMethod method :
         {SamplingMethod::monte_carlo, SamplingMethod::latin_hypercube, SamplingMethod::sobol_sequence}) {
        int mean_covered = 0;
        int failure_covered = 0;
        constexpr int repetitions = 200;
        for (int seed = 0; seed < repetitions; ++seed) {
            const PropagationResult result = propagated(method, 512, static_cast<std::uint64_t>(seed));
            mean_covered += result.mean.interval_95.contains(2) ? 1 : 0;
            failure_covered += result.failure->probability->interval_95.contains(margin_failure) ? 1 : 0;
        }
        // At 95 % 190 of 200 are expected, and 179 or fewer have a probability of 0.001. Replicates of 32 points are
        // slightly skewed.
        EXPECT_GE(mean_covered, 178) << word_of(method);
        EXPECT_GE(failure_covered, 176) << word_of(method);
    }
}

TEST(Propagation, SequenceBeatsHypercubesAndThoseBeatChance) {
    const auto error = [](SamplingMethod method) {
        double squares = 0;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            const double off = propagated(method, 2048, seed).failure->probability->value - margin_failure;
            squares += off * off;
        }
        return std::sqrt(squares / 20);
    };
    const double chance = error(SamplingMethod::monte_carlo);
    EXPECT_LT(error(SamplingMethod::latin_hypercube), chance);
    EXPECT_LT(error(SamplingMethod::sobol_sequence), 0.7 * chance);  // with only 128 points in each replicate
}

TEST(Propagation, SameNumbersOnAnyNumberOfThreads) {
    for (const SamplingMethod method :
         {SamplingMethod::monte_carlo, SamplingMethod::latin_hypercube, SamplingMethod::sobol_sequence}) {
        const PropagationResult alone = propagated(method, 4096, 7, 1);
        const PropagationResult together = propagated(method, 4096, 7, 3);
        EXPECT_EQ(alone.mean.value, together.mean.value);
        EXPECT_EQ(alone.mean.interval_95.lower, together.mean.interval_95.lower);
        EXPECT_EQ(alone.quantiles, together.quantiles);
        EXPECT_EQ(alone.cumulative, together.cumulative);
        EXPECT_EQ(alone.failure->failed, together.failure->failed);
    }
}

TEST(Propagation, HistogramHoldsEverySampleAndSplitsAtTheLimit) {
    const PropagationResult result = propagated(SamplingMethod::latin_hypercube, 4096);
    long all = 0;
    long failed = 0;
    double edge = result.histogram.front().lower;
    for (const HistogramBin& bin : result.histogram) {
        EXPECT_EQ(bin.lower, edge);
        edge = bin.upper;
        all += bin.samples;
        failed += bin.upper <= below_zero.limit ? bin.samples : 0;
    }
    EXPECT_EQ(all, 4096);
    EXPECT_EQ(failed, result.failure->failed);
    EXPECT_EQ(result.cumulative.back().second, 1);
}

TEST(Propagation, ConvergenceEndsAtTheAnswer) {
    for (const SamplingMethod method :
         {SamplingMethod::monte_carlo, SamplingMethod::latin_hypercube, SamplingMethod::sobol_sequence}) {
        const PropagationResult result = propagated(method, 4096);
        ASSERT_GE(result.convergence.size(), 3U);
        EXPECT_EQ(result.convergence.back().samples, 4096);
        EXPECT_EQ(result.convergence.back().mean.value, result.mean.value);
        EXPECT_EQ(result.convergence.back().probability->value, result.failure->probability->value);
        const auto width = [](const Estimate& estimate) {
            return estimate.interval_95.upper - estimate.interval_95.lower;
        };
        EXPECT_LT(width(result.convergence.back().mean), width(result.convergence.front().mean));
    }
}

TEST(Propagation, SamplesWithoutAnswerAreCountedByCause) {
    // A tenth of the box has no answer, in another one a word says that it fails, in a third that it stands, and half
    // of the rest lies below the limit.
    Study study([](std::span<const double> x) {
        return x[0] < 0.1   ? Evaluation{0, "crack_outside"}
               : x[0] < 0.2 ? Evaluation{0, "fails_at_any_strength"}
               : x[0] < 0.3 ? Evaluation{0, "holds_at_any_strength"}
                            : Evaluation{x[1], {}};
    });
    const FailureCriterion criterion{0.5, FailureSide::below, {"fails_at_any_strength"}, {"holds_at_any_strength"}};
    const PropagationResult result =
        propagate(study.evaluator(), unit_box(2), {SamplingMethod::sobol_sequence, 16'384, 16}, criterion, 1);
    const auto& causes = result.evaluations.failed_by_cause;
    ASSERT_EQ(causes.size(), 3U);
    EXPECT_EQ(causes[0].first, "crack_outside");
    EXPECT_NEAR(static_cast<double>(causes[0].second), 1638, 20);
    EXPECT_EQ(causes[1].first, "fails_at_any_strength");
    EXPECT_EQ(causes[2].first, "holds_at_any_strength");
    EXPECT_EQ(result.with_value + causes[0].second + causes[1].second + causes[2].second, result.samples);
    // Of the 0.9 that are decided 0.1 + 0.35 fail; of all, 0.45 to 0.55 do.
    EXPECT_NEAR(result.failure->probability->value, 0.5, 0.005);
    EXPECT_NEAR(result.failure->least, 0.45, 0.005);
    EXPECT_NEAR(result.failure->greatest, 0.55, 0.005);
}

TEST(Propagation, NoAnswerAnywhereIsSaid) {
    Study study([](std::span<const double>) { return Evaluation{0, "crack_outside"}; });
    const PropagationResult result = propagate(study.evaluator(), unit_box(2), {}, below_zero, 1);
    EXPECT_EQ(result.status, PropagationStatus::no_answer);
    EXPECT_FALSE(result.failure->probability);
    EXPECT_EQ(result.failure->least, 0);
    EXPECT_EQ(result.failure->greatest, 1);
    EXPECT_EQ(result.evaluations.failed(), result.samples);
}

TEST(Propagation, FewDecidedSamplesGiveBoundsAndNoProbability) {
    const auto decided_below = [](double share) {
        Study study([share](std::span<const double> x) {
            return x[0] < share ? Evaluation{-1, {}} : Evaluation{0, "stands_everywhere"};
        });
        return propagate(study.evaluator(), unit_box(1), {SamplingMethod::latin_hypercube, 1000, 10}, below_zero, 1);
    };
    const PropagationResult few = decided_below(0.49);
    EXPECT_EQ(few.status, PropagationStatus::finished);
    EXPECT_FALSE(few.failure->probability);
    EXPECT_FALSE(few.convergence.back().probability);
    EXPECT_EQ(few.failure->decided, 490);
    EXPECT_EQ(few.failure->samples, 1000);
    EXPECT_DOUBLE_EQ(few.failure->least, 0.49);
    EXPECT_EQ(few.failure->greatest, 1);
    const PropagationResult half = decided_below(0.5);
    ASSERT_TRUE(half.failure->probability);
    EXPECT_EQ(half.failure->probability->value, 1);
    EXPECT_TRUE(half.convergence.back().probability);
}

TEST(Propagation, ValuesOnOneSideOfTheLimitAreDecided) {
    const FailureCriterion below{1, FailureSide::below, {}, {}};
    EXPECT_EQ(below.failed(at_least(1)), false);
    EXPECT_EQ(below.failed(more_than(2)), false);
    EXPECT_EQ(below.failed(at_least(0.9)), std::nullopt);
    EXPECT_EQ(below.failed(less_than(1)), true);
    EXPECT_EQ(below.failed(at_most(1)), std::nullopt);  // the limit itself stands
    EXPECT_EQ(below.failed(at_most(0.9)), true);
    const FailureCriterion above{1, FailureSide::above, {}, {}};
    EXPECT_EQ(above.failed(at_most(1)), false);
    EXPECT_EQ(above.failed(less_than(1.1)), std::nullopt);
    EXPECT_EQ(above.failed(more_than(1)), true);
    EXPECT_EQ(above.failed(at_least(1)), std::nullopt);
    EXPECT_EQ(above.failed(any_number()), std::nullopt);
}

TEST(Propagation, AnInfiniteFactorOfSafetyStands) {
    const double infinite = std::numeric_limits<double>::infinity();
    const FailureCriterion below{1, FailureSide::below, {}, {}};
    const FailureCriterion above{1, FailureSide::above, {}, {}};
    EXPECT_TRUE(below.decided({infinite, {}}));
    EXPECT_FALSE(below.failed(Evaluation{infinite, {}}));
    EXPECT_TRUE(above.failed(Evaluation{infinite, {}}));
    EXPECT_FALSE(below.decided({NAN, {}}));
    EXPECT_FALSE(below.decided({infinite, "no_answer"}));
}

TEST(Propagation, NumbersThatAreNoneAreFailuresOfTheModel) {
    Study study(objective([](std::span<const double> x) { return x[0] < 0.5 ? NAN : 1 / (x[0] - x[0]); }));
    const PropagationResult result = propagate(study.evaluator(), unit_box(1), {}, below_zero, 1);
    EXPECT_EQ(result.evaluations.failed_by_cause.size(), 2U);
    EXPECT_EQ(result.with_value, 0);
}

TEST(Propagation, NoFailureAmongManySamplesLeavesAnUpperBound) {
    Study study(objective([](std::span<const double> x) { return x[0]; }));
    const PropagationResult result =
        propagate(study.evaluator(), unit_box(1), {SamplingMethod::monte_carlo, 1000, 16}, below_zero, 1);
    EXPECT_EQ(result.failure->probability->value, 0);
    EXPECT_EQ(result.failure->probability->interval_95.lower, 0);
    // Wilson: z^2 / (n + z^2)
    EXPECT_NEAR(result.failure->probability->interval_95.upper, 3.8415 / 1003.8415, 1e-6);
    EXPECT_EQ(result.failure->method, ErrorMethod::wilson);
}

// Each of four Latin hypercubes of 512 samples has three or four failures, and their shares hardly differ.
TEST(Propagation, FewFailuresThatAgreeByChanceLeaveTheIntervalOfTheirNumber) {
    Study study(objective([](std::span<const double> x) { return x[0]; }));
    for (const double limit : {0.0060, 0.0062, 0.0066}) {
        const FailureCriterion below{limit, FailureSide::below, {}, {}};
        const PropagationResult result =
            propagate(study.evaluator(), unit_box(1), {SamplingMethod::latin_hypercube, 2048, 4}, below, 1);
        const Interval interval = result.failure->probability->interval_95;
        EXPECT_LT(interval.lower, limit);
        EXPECT_GT(interval.upper, limit);
        const Interval wilson = wilson_interval(static_cast<double>(result.failure->failed), 2048);
        EXPECT_GE(interval.upper - interval.lower, wilson.upper - wilson.lower) << limit;
    }
}

TEST(Propagation, ConstantQuantity) {
    Study study(objective([](std::span<const double>) { return 1.5; }));
    const PropagationResult result = propagate(study.evaluator(), unit_box(1), {}, below_zero, 1);
    EXPECT_EQ(result.mean.value, 1.5);
    EXPECT_EQ(result.standard_deviation, 0);
    EXPECT_EQ(result.histogram.size(), 1U);
    EXPECT_EQ(result.cumulative.size(), 1U);
}

TEST(Propagation, StoppedWorkIsJudgedByWhatWasFinished) {
    std::atomic<bool> stop = false;
    std::atomic<int> evaluated = 0;
    Study study([&](std::span<const double> x) {
        if (++evaluated == 3000) {
            stop = true;
        }
        return Evaluation{x[0], {}};
    });
    const PropagationResult result =
        propagate(study.evaluator(&stop), unit_box(1), {SamplingMethod::latin_hypercube, 16'000, 16}, below_zero, 1);
    EXPECT_EQ(result.status, PropagationStatus::interrupted);
    EXPECT_EQ(result.samples, 3000);  // three whole replicates
    EXPECT_NEAR(result.mean.value, 0.5, 1e-3);
}

}  // namespace
}  // namespace delabole
