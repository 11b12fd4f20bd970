#include "fitting/search/minimise.hpp"

#include "fitting/probability/bracketed_root.hpp"
#include "fitting/probability/estimate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>

namespace delabole {
namespace {

constexpr std::array all_algorithms = {Algorithm::sbplx,    Algorithm::bobyqa, Algorithm::cobyla, Algorithm::crs2,
                                       Algorithm::direct_l, Algorithm::mlsl,   Algorithm::isres};

// Minimum 0 at (1, 1), at the bottom of a curved valley.
Evaluation rosenbrock(std::span<const double> x) {
    const double valley = x[1] - x[0] * x[0];
    return {100 * valley * valley + (1 - x[0]) * (1 - x[0]), {}};
}

const std::vector<Interval> square = {{.lower = -2, .upper = 2}, {.lower = -1, .upper = 3}};
const std::vector<double> far_start = {-1.2, 1.0};

class EveryAlgorithm : public testing::TestWithParam<Algorithm> {
  protected:
    MinimiseSettings settings(long evaluations) const {
        MinimiseSettings result;
        result.algorithm = GetParam();
        result.evaluations = evaluations;
        return result;
    }
};

INSTANTIATE_TEST_SUITE_P(Minimise, EveryAlgorithm, testing::ValuesIn(all_algorithms), [](const auto& parameter) {
    return std::string(enum_names(Algorithm{})[static_cast<std::size_t>(parameter.param)]);
});

TEST_P(EveryAlgorithm, FindsTheBottomOfACurvedValley) {
    const MinimiseResult result = minimise(rosenbrock, square, far_start, settings(20000));
    // COBYLA's linear models and the dividing and random searches creep along the valley floor, where an error of 0.1
    // in x costs 0.01; the others converge.
    const bool converges = GetParam() == Algorithm::sbplx || GetParam() == Algorithm::bobyqa ||
                           GetParam() == Algorithm::mlsl || GetParam() == Algorithm::crs2;
    const double tolerance = converges ? 1e-4 : 0.1;
    ASSERT_TRUE(result.found());
    EXPECT_NEAR(result.point[0], 1, tolerance);
    EXPECT_NEAR(result.point[1], 1, 2 * tolerance);
    EXPECT_EQ(result.value, rosenbrock(result.point).value);
    EXPECT_EQ(result.evaluations.failed(), 0);
}

TEST_P(EveryAlgorithm, StopsAtTheCap) {
    for (const long cap : {1L, 7L, 100L}) {
        long calls = 0;
        const auto counted = [&calls](std::span<const double> x) {
            ++calls;
            return rosenbrock(x);
        };
        const MinimiseResult result = minimise(counted, square, far_start, settings(cap));
        EXPECT_EQ(calls, cap);
        EXPECT_EQ(result.evaluations.total, cap);
        EXPECT_EQ(result.status, MinimiseStatus::evaluation_limit);
        EXPECT_TRUE(result.found());
    }
}

TEST_P(EveryAlgorithm, RethrowsWhatTheObjectiveThrows) {
    long calls = 0;
    const auto throwing = [&calls](std::span<const double> x) {
        if (++calls == 5) {
            throw std::out_of_range("the fifth");
        }
        return rosenbrock(x);
    };
    try {
        minimise(throwing, square, far_start, settings(1000));
        FAIL() << "no exception";
    } catch (const std::out_of_range& exception) {
        EXPECT_STREQ(exception.what(), "the fifth");
    }
    EXPECT_EQ(calls, 5) << "evaluated again after the exception";
}

TEST_P(EveryAlgorithm, CountsFailuresAndKeepsTheBestValidPoint) {
    // The objective fails in half of the domain, in two ways; the least valid value is 0.25 at x = 0.5.
    const auto half = [](std::span<const double> x) -> Evaluation {
        if (x[0] < 0.5) {
            return {0, "left"};
        }
        return {x[1] > 2 ? std::numeric_limits<double>::quiet_NaN() : x[0] * x[0] + x[1] * x[1], {}};
    };
    const std::vector<double> start = {1.5, 1.5};
    const MinimiseResult result = minimise(half, square, start, settings(5000));
    ASSERT_TRUE(result.found());
    EXPECT_GE(result.point[0], 0.5);
    EXPECT_EQ(result.value, half(result.point).value);
    EXPECT_EQ(result.evaluations.optimiser_rejections, result.evaluations.failed());
    EXPECT_GT(result.evaluations.failed(), 0);
    // The models of BOBYQA and COBYLA are spoilt by the cliff: they only have to stay on the valid side.
    if (GetParam() != Algorithm::bobyqa && GetParam() != Algorithm::cobyla) {
        EXPECT_LT(result.value, 0.3);
    }
}

TEST_P(EveryAlgorithm, SaysWhenEverythingFails) {
    const auto never = [](std::span<const double>) { return Evaluation{std::nan(""), {}}; };
    const MinimiseResult result = minimise(never, square, far_start, settings(200));
    EXPECT_EQ(result.status, MinimiseStatus::no_valid_point);
    EXPECT_FALSE(result.found());
    EXPECT_TRUE(result.point.empty());
    ASSERT_EQ(result.evaluations.failed_by_cause.size(), 1u);
    EXPECT_EQ(result.evaluations.failed_by_cause[0].first, "not_a_number");
    EXPECT_EQ(result.evaluations.failed_by_cause[0].second, result.evaluations.total);
}

TEST_P(EveryAlgorithm, LeavesOutAParameterThatCannotMove) {
    const std::vector<Interval> bounds = {square[0], {.lower = 0.25, .upper = 0.25}};
    long moved = 0;
    const auto watching = [&moved](std::span<const double> x) {
        moved += x[1] == 0.25 ? 0 : 1;
        return rosenbrock(x);
    };
    const MinimiseResult result = minimise(watching, bounds, std::vector{1.2, 1.0}, settings(3000));
    // d/dx of 100 (0.25 - x^2)^2 + (1 - x)^2 vanishes at 0.5049752469
    ASSERT_TRUE(result.found());
    EXPECT_EQ(moved, 0);
    EXPECT_LE(result.value, rosenbrock(std::array{0.5049752469, 0.25}).value + 0.01);
}

TEST_P(EveryAlgorithm, StopsWhenAsked) {
    std::atomic<bool> stop = false;
    long calls = 0;
    const auto asking = [&](std::span<const double> x) {
        stop = ++calls >= 12;
        return rosenbrock(x);
    };
    const MinimiseResult result = minimise(asking, square, far_start, settings(1000), &stop);
    EXPECT_EQ(result.status, MinimiseStatus::interrupted);
    EXPECT_EQ(calls, 12);
    EXPECT_TRUE(result.found());
}

TEST_P(EveryAlgorithm, GivesTheSameAnswerOnAnotherThread) {
    const MinimiseResult here = minimise(rosenbrock, square, far_start, settings(500));
    MinimiseResult there;
    std::thread([&] { there = minimise(rosenbrock, square, far_start, settings(500)); }).join();
    EXPECT_EQ(here.point, there.point);
    EXPECT_EQ(here.evaluations.total, there.evaluations.total);
}

TEST(Minimise, ValuesAboveTheFirstPenaltyStillBeatFailures) {
    const auto steep = [](std::span<const double> x) -> Evaluation {
        return x[0] > 0 ? Evaluation{0, "right"} : Evaluation{1e9 + 1e9 * x[0] * x[0], {}};
    };
    const std::vector<Interval> bounds = {{.lower = -2, .upper = 2}};
    const std::vector<double> start = {-1.5};
    const MinimiseResult result = minimise(steep, bounds, start, {});
    EXPECT_NEAR(result.value, 1e9, 1e5);  // x within 0.01 of the cliff
}

TEST(Minimise, EvaluatesOnceWithoutParameters) {
    const auto constant = [](std::span<const double>) { return Evaluation{3, {}}; };
    const MinimiseResult result = minimise(constant, {}, {}, {});
    EXPECT_EQ(result.status, MinimiseStatus::converged);
    EXPECT_EQ(result.value, 3);
    EXPECT_EQ(result.evaluations.total, 1);
}

TEST(Minimise, RefusesReversedBounds) {
    const std::vector<Interval> reversed = {{.lower = 1, .upper = 0}};
    EXPECT_THROW(minimise(rosenbrock, reversed, std::vector{0.5}, {}), std::invalid_argument);
    EXPECT_THROW(minimise(rosenbrock, square, std::vector{0.5}, {}), std::invalid_argument);
}

TEST(BracketedRoot, ClosesInAndReportsAGap) {
    const auto cubic = [](double x) { return x * x * x - 2; };
    const auto root = bracketed_root(cubic, {0, 10, cubic(0), cubic(10)}, 1e-12);
    ASSERT_TRUE(root);
    EXPECT_NEAR(*root, std::cbrt(2.0), 1e-12);
    const auto gap = [](double x) { return x < 0.1 ? -1 : x > 0.9 ? 1 : std::nan(""); };
    EXPECT_FALSE(bracketed_root(gap, {0, 1, -1, 1}, 1e-12));
}

TEST(ChiSquare, HasTheTabulatedQuantiles) {
    // Abramowitz & Stegun, table 26.8
    EXPECT_NEAR(chi_square_quantile(probability_68, 1), 1, 1e-9);
    EXPECT_NEAR(chi_square_quantile(0.95, 1), 3.841458821, 1e-8);
    EXPECT_NEAR(chi_square_quantile(0.95, 2), 5.991464547, 1e-8);
}

}  // namespace
}  // namespace delabole
