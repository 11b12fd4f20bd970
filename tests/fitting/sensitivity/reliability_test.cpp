#include "fitting/sensitivity/reliability.hpp"

#include "tests/fitting/test_functions.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

using test::independent;
using test::objective;
using test::Study;

const FailureCriterion fails_below_zero{0, FailureSide::below, {}, {}};

ReliabilityResult found(const std::function<double(std::span<const double>)>& margin, const InputSpace& space,
                        const FailureCriterion& criterion = fails_below_zero, int threads = 1) {
    Study study(objective(margin), threads);
    return reliability(study.evaluator(), space, {}, criterion, 1);
}

TEST(Reliability, LinearMarginOfNormals) {
    // beta = mean / deviation; alpha = minus each parameter's part of the deviation
    const InputSpace space({Marginal({Normal{100, 20}}), Marginal({Normal{40, 15}})}, {});
    const ReliabilityResult result = found([](std::span<const double> x) { return x[0] - x[1]; }, space);
    EXPECT_EQ(result.status, ReliabilityStatus::converged);
    EXPECT_NEAR(result.reliability_index, 60 / 25.0, 1e-6);
    EXPECT_NEAR(result.probability_of_failure, std::erfc(2.4 / std::sqrt(2.0)) / 2, 1e-7);
    const DesignPoint& point = result.points.front();
    EXPECT_NEAR(point.alpha[0], -0.8, 1e-4);
    EXPECT_NEAR(point.alpha[1], 0.6, 1e-4);
    EXPECT_NEAR(point.parameters[0], 100 - 20 * 0.8 * 2.4, 1e-2);
    EXPECT_NEAR(point.parameters[0], point.parameters[1], 1e-2);  // on the limit
    EXPECT_EQ(result.points.size(), 1U);
    EXPECT_EQ(result.converged_starts, result.starts);
}

TEST(Reliability, CorrelationCountsInTheVariance) {
    const double rho = -0.6;
    const InputSpace space({Marginal({Normal{100, 20}}), Marginal({Normal{40, 15}})},
                           {{0, 1, CorrelationMeasure::linear, rho}});
    const ReliabilityResult result = found([](std::span<const double> x) { return x[0] - x[1]; }, space);
    EXPECT_NEAR(result.reliability_index, 60 / std::sqrt(400 + 225 - 2 * rho * 300), 1e-6);
    // A linear margin's importance is its coefficients times the standard deviations, whatever the correlation.
    EXPECT_NEAR(result.points.front().importance[0], -0.8, 1e-4);
    EXPECT_NEAR(result.points.front().importance[1], 0.6, 1e-4);
}

TEST(Reliability, RatioOfLognormals) {
    // ln R - ln S is normal.
    const auto logarithm = [](double mean, double deviation) {
        const double variance = std::log1p(deviation * deviation / (mean * mean));
        return std::pair(std::log(mean) - variance / 2, variance);
    };
    const auto [mean_r, variance_r] = logarithm(200, 40);
    const auto [mean_s, variance_s] = logarithm(100, 30);
    const InputSpace space({Marginal({Lognormal{200, 40}}), Marginal({Lognormal{100, 30}})}, {});
    const FailureCriterion below_one{1, FailureSide::below, {}, {}};
    const ReliabilityResult result = found([](std::span<const double> x) { return x[0] / x[1]; }, space, below_one);
    EXPECT_NEAR(result.reliability_index, (mean_r - mean_s) / std::sqrt(variance_r + variance_s), 1e-5);
}

TEST(Reliability, MediansThatHaveFailedHaveANegativeIndex) {
    const ReliabilityResult result =
        found([](std::span<const double> x) { return x[0] - 1.5; }, independent(2, Normal{0, 1}));
    EXPECT_EQ(result.status, ReliabilityStatus::converged);
    EXPECT_NEAR(result.reliability_index, -1.5, 1e-6);
    EXPECT_NEAR(result.probability_of_failure, std::erfc(-1.5 / std::sqrt(2.0)) / 2, 1e-6);
}

TEST(Reliability, FailureAboveALimit) {
    const FailureCriterion above_three{3, FailureSide::above, {}, {}};
    const ReliabilityResult result =
        found([](std::span<const double> x) { return x[0] + x[1]; }, independent(2, Normal{0, 1}), above_three);
    EXPECT_NEAR(result.reliability_index, 3 / std::sqrt(2.0), 1e-6);
    EXPECT_NEAR(result.points.front().alpha[0], std::sqrt(0.5), 1e-4);  // both have to rise
}

TEST(Reliability, FindsBothOfTwoDesignPoints) {
    // The margin has a valley on either side: its zeros are nearest at u1 = +-3, at a distance of 3.
    const ReliabilityResult result =
        found([](std::span<const double> u) { return 9 - u[0] * u[0] + 0.1 * u[1]; }, independent(2, Normal{0, 1}));
    EXPECT_EQ(result.status, ReliabilityStatus::converged);
    ASSERT_GE(result.points.size(), 2U);
    EXPECT_NEAR(result.points[0].reliability_index, result.points[1].reliability_index, 1e-3);
    EXPECT_LT(result.points[0].standard_normal[0] * result.points[1].standard_normal[0], 0);
}

TEST(Reliability, KinkInTheLimitSurface) {
    // Two planes, at distances 2 and 3 along different axes: the nearer one counts.
    const ReliabilityResult result =
        found([](std::span<const double> u) { return std::min(2 - u[0], 3 + u[1]); }, independent(2, Normal{0, 1}));
    EXPECT_EQ(result.status, ReliabilityStatus::converged);
    EXPECT_NEAR(result.reliability_index, 2, 1e-3);
}

TEST(Reliability, CornerOfTheLimitSurface) {
    // Both planes have to be passed: the design point is their corner, which the differences see as rounded.
    const ReliabilityResult result =
        found([](std::span<const double> u) { return std::max(2 - u[0], 1.5 - u[1]); }, independent(2, Normal{0, 1}));
    ASSERT_FALSE(result.points.empty());
    EXPECT_NEAR(result.reliability_index, 2.5, 2e-3);  // the step of the differences
}

TEST(Reliability, LimitBeyondReachIsSaid) {
    const ReliabilityResult result =
        found([](std::span<const double> u) { return 20 - u[0]; }, independent(2, Normal{0, 1}));
    EXPECT_EQ(result.status, ReliabilityStatus::limit_not_reached);
    EXPECT_TRUE(result.points.empty());
    EXPECT_FALSE(result.medians_fail);
    const ReliabilityResult failing =
        found([](std::span<const double> u) { return u[0] - 20; }, independent(2, Normal{0, 1}));
    EXPECT_EQ(failing.status, ReliabilityStatus::limit_not_reached);
    EXPECT_TRUE(failing.medians_fail);
}

TEST(Reliability, FailuresOfTheModelAreWallsAndCounted) {
    Study study([](std::span<const double> u) {
        return u[1] > 1 ? Evaluation{0, "crack_outside"} : Evaluation{3 - u[0] - 0.5 * u[1], {}};
    });
    const ReliabilityResult result =
        reliability(study.evaluator(), independent(2, Normal{0, 1}), {}, fails_below_zero, 1);
    // Without the wall the design point is (2.4, 1.2) at 2.683; with it, the best left is (2.5, 1) at 2.693, where the
    // wall and not the slope of the margin decides, or none.
    EXPECT_NE(result.status, ReliabilityStatus::converged);
    EXPECT_GT(result.evaluations.failed(), 0);

    Study hopeless([](std::span<const double>) { return Evaluation{0, "crack_outside"}; });
    EXPECT_EQ(reliability(hopeless.evaluator(), independent(2, Normal{0, 1}), {}, fails_below_zero, 1).status,
              ReliabilityStatus::no_answer_at_medians);
}

TEST(Reliability, SameNumbersOnAnyNumberOfThreads) {
    const auto margin = [](std::span<const double> u) { return 3 - u[0] * u[1] - 0.2 * u[2]; };
    const ReliabilityResult alone = found(margin, independent(3, Normal{0, 1}), fails_below_zero, 1);
    const ReliabilityResult together = found(margin, independent(3, Normal{0, 1}), fails_below_zero, 3);
    EXPECT_EQ(alone.reliability_index, together.reliability_index);
    EXPECT_EQ(alone.evaluations.total, together.evaluations.total);
    EXPECT_EQ(alone.points.front().parameters, together.points.front().parameters);
}

TEST(Reliability, ExceptionsOfTheModelReachTheCaller) {
    Study study([](std::span<const double> u) -> Evaluation {
        if (u[0] > 0.5) {
            throw std::runtime_error("model");
        }
        return {1 - u[0], {}};
    });
    EXPECT_THROW(reliability(study.evaluator(), independent(1, Normal{0, 1}), {}, fails_below_zero, 1),
                 std::runtime_error);
}

}  // namespace
}  // namespace delabole
