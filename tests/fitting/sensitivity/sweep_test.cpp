#include "fitting/sensitivity/sweep.hpp"

#include "fitting/sensitivity/sensitivity.hpp"
#include "tests/fitting/test_functions.hpp"
#include "tests/fitting/test_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace delabole {
namespace {

using test::objective;
using test::Study;
using test::unit_box;

// x1 monotone, x2 a hump, x3 of no effect.
double hump(std::span<const double> x) {
    return 2 * x[0] + std::sin(std::numbers::pi * x[1]);
}

SweepResult swept(const Objective& quantity, std::size_t dimension, const SweepSettings& settings, double scatter = 0,
                  std::uint64_t seed = 1, int threads = 1) {
    Study study(quantity, threads);
    return sweep(study.evaluator(), unit_box(dimension), settings, scatter, seed).value();
}

SweepSettings whole_range(int points, int samples = 0) {
    return {.points = points, .lower_probability = 0, .upper_probability = 1, .samples = samples};
}

std::vector<SweepPoint> points_of(const std::vector<double>& values) {
    std::vector<SweepPoint> points;
    for (const double value : values) {
        points.push_back({static_cast<double>(points.size()), {value, {}}});
    }
    return points;
}

TEST(Sweep, TellsMonotoneFromNotAndFromConstant) {
    const SweepResult result = swept(objective(hump), 3, whole_range(9));
    EXPECT_EQ(result.evaluations.total, 1 + 3 * 8);  // the medians are shared
    const ParameterSweep& rises = result.parameters[0];
    EXPECT_EQ(rises.course, SweepCourse::rises);
    EXPECT_DOUBLE_EQ(rises.main.change, 2);
    EXPECT_EQ(rises.reversal.change, 0);
    const ParameterSweep& turns = result.parameters[1];
    EXPECT_EQ(turns.course, SweepCourse::not_monotone);
    EXPECT_NEAR(turns.main.change, 1, 1e-12);
    EXPECT_NEAR(turns.reversal.change, -1, 1e-12);
    EXPECT_DOUBLE_EQ(turns.reversal.from, 0.5);
    EXPECT_DOUBLE_EQ(turns.reversal.to, 1);
    EXPECT_EQ(result.parameters[2].course, SweepCourse::constant);
    const Objective downwards = objective([](std::span<const double> x) { return -x[0] * x[0]; });
    EXPECT_EQ(swept(downwards, 1, whole_range(3)).parameters[0].course, SweepCourse::falls);
}

TEST(Sweep, PointsLieEvenlyOnEitherSideOfTheMedian) {
    const InputSpace space({Marginal({Triangular{0, 1, 10}})}, {});
    Study study(objective([](std::span<const double> x) { return x[0]; }));
    const auto result = sweep(study.evaluator(), space, whole_range(5), 0, 1);
    const std::vector<SweepPoint>& points = result->parameters[0].points;
    const double median = space.marginal(0).value(0);
    EXPECT_DOUBLE_EQ(points[0].parameter, 0);
    EXPECT_DOUBLE_EQ(points[1].parameter, median / 2);
    EXPECT_DOUBLE_EQ(points[2].parameter, median);
    EXPECT_DOUBLE_EQ(points[4].parameter, 10);
    for (const SweepPoint& point : points) {
        EXPECT_EQ(point.answer.value, point.parameter);
    }
}

TEST(Sweep, AReversalHasToExceedAHundredthAndTheScatter) {
    EXPECT_EQ(judge_sweep(points_of({0, 5, 4.96, 10}), 0).course, SweepCourse::rises);
    EXPECT_EQ(judge_sweep(points_of({0, 5, 4.8, 10}), 0).course, SweepCourse::not_monotone);
    EXPECT_EQ(judge_sweep(points_of({0, 5, 4.8, 10}), 0.1).course, SweepCourse::rises);
    EXPECT_EQ(judge_sweep(points_of({0, 5, 4.8, 10}), 5).course, SweepCourse::within_scatter);
    EXPECT_EQ(judge_sweep(points_of({7, 7 + 1e-12, 7}), 0).course, SweepCourse::constant);
}

TEST(Sweep, PointsWithoutAnAnswerAreLeftOut) {
    std::vector<SweepPoint> points = points_of({0, 1, 9, 3, 4});
    points[2].answer = {0, "impossible"};
    EXPECT_EQ(judge_sweep(points, 0).course, SweepCourse::rises);
    points[0].answer = points[4].answer = {0, "impossible"};
    EXPECT_EQ(judge_sweep(points, 0).course, SweepCourse::too_few_answers);
    const auto half = [](std::span<const double> x) {
        return x[0] > 0.5 ? Evaluation{0, "impossible"} : Evaluation{x[0], {}};
    };
    const SweepResult result = swept(half, 1, whole_range(9));
    EXPECT_EQ(result.parameters[0].course, SweepCourse::rises);
    EXPECT_EQ(result.evaluations.failed(), 4);
}

// Noise that depends on all digits of the parameters, as that of blocks in motion.
double noise(std::span<const double> x) {
    double sum = 0;
    for (const double each : x) {
        sum += each;
    }
    const double digits = 1e6 * sum;
    return std::sqrt(12.0) * (digits - std::floor(digits) - 0.5);  // deviation 1
}

// With a hundred seeds and three parameters: at most one in twenty of the sweeps that have nothing but noise is taken
// for a change, and hardly one for a reversal; a hump of four deviations is found.
TEST(Sweep, NoiseAloneIsSeldomTakenForAReversal) {
    const Objective noisy = objective(
        [](std::span<const double> x) { return 2 * x[0] + 4 * std::sin(std::numbers::pi * x[1]) + noise(x); });
    int changes = 0;
    int reversals = 0;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        const SweepResult result = swept(noisy, 3, whole_range(5, 160), 0, seed);
        EXPECT_EQ(result.evaluations.total, 160);
        EXPECT_EQ(result.parameters[1].course, SweepCourse::not_monotone) << seed;
        EXPECT_NE(result.parameters[0].course, SweepCourse::not_monotone) << seed;
        changes += result.parameters[2].course != SweepCourse::within_scatter;
        reversals += result.parameters[2].course == SweepCourse::not_monotone;
    }
    EXPECT_LE(changes, 12);
    EXPECT_LE(reversals, 1);
}

TEST(Sweep, SamplesGiveTheMeansOfClassesAndTheirScatter) {
    const Objective linear = objective([](std::span<const double> x) { return 3 * x[0] + 0 * x[1]; });
    const SweepResult result = swept(linear, 2, whole_range(3, 300));
    const ParameterSweep& rises = result.parameters[0];
    EXPECT_EQ(rises.course, SweepCourse::rises);
    EXPECT_NEAR(rises.points[1].parameter, 0.5, 0.01);
    EXPECT_NEAR(rises.points[1].answer.value, 1.5, 0.03);
    // Within a class uniform over a third of the range, 100 samples.
    EXPECT_NEAR(rises.scatter, 1 / std::sqrt(12.0) / 10, 0.002);
    EXPECT_EQ(result.parameters[1].course, SweepCourse::within_scatter);
}

TEST(Sweep, SameNumbersOnAnyNumberOfThreads) {
    for (const int samples : {0, 64}) {
        const SweepResult one = swept(objective(hump), 3, whole_range(5, samples), 0, 1, 1);
        const SweepResult three = swept(objective(hump), 3, whole_range(5, samples), 0, 1, 3);
        for (std::size_t index = 0; index < 3; ++index) {
            EXPECT_EQ(one.parameters[index].main.change, three.parameters[index].main.change);
            EXPECT_EQ(one.parameters[index].scatter, three.parameters[index].scatter);
        }
    }
}

// A study has further outputs at the same points, and inputs that move together.
TEST(Sweep, OfAStudyHasFurtherQuantitiesAndInputsTogether) {
    SensitivityProblem problem;
    problem.model = test::formula_model(3, {"area", "count"}, [](std::span<const double> x) {
        return test::answer({x[0] + x[1], (x[0] - 0.5) * (x[1] - 0.5)});
    });
    problem.study.quantity = "area";
    problem.study.parameters = {{"x1", {Uniform{0, 1}}, "", {"x2"}}, {"x3", {Uniform{0, 1}}, ""}};
    problem.study.sweep = SweepSettings{.points = 5};
    problem.study.sweep->further = {{"count", 0, Dimension::ratio}};
    const SensitivityResult result = sensitivity(problem);
    ASSERT_EQ(result.sweeps.size(), 2U);
    EXPECT_NEAR(result.sweeps[0].parameters[0].main.change, 2 * 0.9, 1e-12);  // 5 to 95 %
    EXPECT_EQ(result.sweeps[1].quantity, "count");
    EXPECT_EQ(result.sweeps[1].parameters[0].course, SweepCourse::not_monotone);
    EXPECT_EQ(result.without_effect, std::vector<std::size_t>{1});

    const auto key_of = [&](const std::function<void(SensitivityStudy&)>& spoil) {
        SensitivityProblem spoilt = problem;
        spoil(spoilt.study);
        const std::vector<StudyFault> faults = check_study(spoilt);
        return faults.empty() ? std::string("none") : faults.front().key;
    };
    EXPECT_EQ(key_of([](auto&) {}), "none");
    EXPECT_EQ(key_of([](auto& study) { study.sweep->points = 4; }), "sweep.points");
    EXPECT_EQ(key_of([](auto& study) { study.sweep->points = 21; }), "sweep.points");
    EXPECT_EQ(key_of([](auto& study) { study.sweep->samples = 39; }), "sweep.samples");
    EXPECT_EQ(key_of([](auto& study) { study.sweep->scatter = -1; }), "sweep.scatter");
    EXPECT_EQ(key_of([](auto& study) { study.sweep->further[0].name = "mass"; }), "sweep.quantity[1].name");
    EXPECT_EQ(key_of([](auto& study) { study.sweep->further[0].name = "area"; }), "sweep.quantity[1].name");
    EXPECT_EQ(key_of([](auto& study) { study.parameters[0].also = {"x7"}; }), "parameter[1].also");
    EXPECT_EQ(key_of([](auto& study) { study.parameters[0].also = {"x3"}; }), "parameter[2].name");
}

}  // namespace
}  // namespace delabole
