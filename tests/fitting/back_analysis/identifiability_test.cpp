#include "fitting/back_analysis/steps.hpp"

#include "fitting/back_analysis/verdict.hpp"

#include "tests/fitting/test_models.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

using test::answer;
using test::formula_model;
using test::observe;

Identifiability identify_at(const FitProblem& problem, const std::vector<double>& best) {
    const Misfit misfit(problem.mechanisms[0], problem);
    ProgressMeter progress({}, 1);
    const Search search{misfit, progress};
    EvaluationCount account;
    return identify(search, best, account);
}

TEST(Identifiability, OneFailureEquationDeterminesOneCombination) {
    // Friction in radians and water as a ratio: FS = tan(phi) / tan(30 deg) - 0.5 (water - 0.4).
    ModelInterface model = formula_model(2, {"factor_of_safety"}, [](std::span<const double> x) {
        return answer({std::tan(x[0]) / std::tan(degrees(30)) - 0.5 * (x[1] - 0.4)});
    });
    model.inputs[0].name = "strength.friction_angle";
    model.inputs[0].dimension = Dimension::angle;
    model.inputs[1].name = "water.filled_ratio";
    const FitProblem problem =
        test::problem_of(model,
                         {test::free_parameter("strength.friction_angle", degrees(20), degrees(45)),
                          test::free_parameter("water.filled_ratio", 0, 1)},
                         {observe("factor_of_safety", 1, 0.05)});
    const Identifiability result = identify_at(problem, {degrees(30), 0.4});
    EXPECT_EQ(result.status, IdentifiabilityStatus::reliable);
    EXPECT_EQ(result.rank, 1);
    EXPECT_FALSE(result.covariance);
    // dFS/dphi = 1 / (cos^2 30 tan 30) = 2.3094 per rad = 0.040307 per deg; over 0.5: 0.0806 of water
    EXPECT_EQ(result.verdict,
              "strength.friction_angle and water.filled_ratio: only one combination is determined: along the line FS = "
              "1 a rise of 1 deg in strength.friction_angle is offset by a rise of 0.0806 in water.filled_ratio. There "
              "are no priors: fitted values of parameters that are not determined are one choice out of many.");
}

TEST(Identifiability, PriorsSettleWhatOneEquationLeavesOpen) {
    const FitProblem problem = test::problem_of(
        test::linear_safety(), {test::with_prior("x1", 0, 1, 0.5, 0.1), test::with_prior("x2", 0, 1, 0.5, 0.2)},
        {observe("factor_of_safety", 1, 0.05)});
    const Identifiability result = identify_at(problem, {0.7, 0.4});
    EXPECT_EQ(result.rank, 1);
    EXPECT_EQ(result.rank_with_priors, 2);
    EXPECT_NE(result.verdict.find("The priors settle what the data leave open"), std::string::npos);
    // Information: g g^T / 0.05^2 + diag(1 / sd^2), g = (0.8, -0.4); inverted by hand.
    const double a = 256 + 100;
    const double b = -128;
    const double c = 64 + 25;
    const double determinant = a * c - b * b;
    ASSERT_TRUE(result.covariance);
    EXPECT_NEAR((*result.covariance)(0, 0), c / determinant, 1e-9);
    EXPECT_NEAR((*result.covariance)(0, 1), -b / determinant, 1e-9);
    EXPECT_NEAR((*result.covariance)(1, 1), a / determinant, 1e-9);
    EXPECT_NEAR((*result.correlation)(0, 1), -b / std::sqrt(a * c), 1e-9);
}

TEST(Identifiability, NamesAParameterThatNothingDependsOn) {
    const ModelInterface model = formula_model(3, {"a", "b"}, [](std::span<const double> x) {
        return answer({x[0], x[1] * 1e-3});
    });
    const FitProblem problem = test::problem_of(
        model, {test::free_parameter("x1", 0, 1), test::free_parameter("x2", 0, 1), test::free_parameter("x3", 0, 1)},
        {observe("a", 0.5, 0.1), observe("b", 0, 0.1)});
    const Identifiability result = identify_at(problem, {0.5, 0.5, 0.5});
    EXPECT_EQ(result.rank, 1);
    EXPECT_NEAR(result.singular_values[0], 10, 1e-6);
    EXPECT_EQ(result.verdict.find("Nothing observed depends on x3 near the best point. x1: determined by the data. x2: "
                                  "hardly any effect on what was observed near the best point"),
              0u);
}

TEST(Identifiability, DescribesACommonChangeOfThreeParameters) {
    const ModelInterface model = formula_model(3, {"a", "b"}, [](std::span<const double> x) {
        return answer({x[0] - x[1], x[1] - x[2]});
    });
    const FitProblem problem = test::problem_of(
        model,
        {test::free_parameter("x1", 0, 10), test::free_parameter("x2", 0, 10), test::free_parameter("x3", 0, 10)},
        {observe("a", 0, 0.1), observe("b", 0, 0.1)});
    const Identifiability result = identify_at(problem, {5, 5, 5});
    EXPECT_EQ(result.rank, 2);
    EXPECT_EQ(result.verdict.find("x1, x2 and x3: only 2 combinations of these 3 are determined: a rise of 1 in x1, a "
                                  "rise of 1 in x2 and a rise of 1 in x3 together leave the predictions as they are."),
              0u);
}

TEST(Identifiability, ExchangesInTheRightSense) {
    // c rises where x1 falls: FS constant along x2 = -2 x1.
    const ModelInterface model =
        formula_model(2, {"a"}, [](std::span<const double> x) { return answer({2 * x[0] + x[1]}); });
    const FitProblem problem = test::problem_of(
        model, {test::free_parameter("x1", 0, 10), test::free_parameter("x2", 0, 100)}, {observe("a", 20, 1)});
    const Identifiability result = identify_at(problem, {5, 10});
    EXPECT_EQ(
        result.verdict.find("x1 and x2: only one combination is determined: along the valley of least misfit a rise "
                            "of 1 in x1 is offset by a fall of 2 in x2."),
        0u);
}

TEST(Identifiability, DoubtsAKink) {
    const ModelInterface model =
        formula_model(1, {"a"}, [](std::span<const double> x) { return answer({x[0] < 0.50005 ? x[0] : 5 * x[0]}); });
    const FitProblem problem = test::problem_of(model, {test::free_parameter("x1", 0, 1)}, {observe("a", 0.5, 0.1)});
    const Identifiability result = identify_at(problem, {0.5});
    EXPECT_EQ(result.status, IdentifiabilityStatus::steps_disagree);
    EXPECT_EQ(result.verdict.find("Doubtful"), 0u);
}

TEST(Identifiability, WorksAtABoundAndBesideFailures) {
    const ModelInterface model = formula_model(1, {"a"}, [](std::span<const double> x) {
        return x[0] > 0.5 ? Prediction{"too_large", {}, {}} : answer({3 * x[0]});
    });
    const FitProblem problem = test::problem_of(model, {test::free_parameter("x1", 0, 1)}, {observe("a", 0.5, 0.1)});
    EXPECT_NEAR(identify_at(problem, {0}).singular_values[0], 30, 1e-6);
    EXPECT_NEAR(identify_at(problem, {0.5}).singular_values[0], 30, 1e-6);
    EXPECT_EQ(identify_at(problem, {0.5}).status, IdentifiabilityStatus::reliable);
}

TEST(Identifiability, WhatMissesTheDataIsNotDetermined) {
    const ModelInterface model = formula_model(2, {"a", "b", "c", "d"}, [](std::span<const double> x) {
        return answer({x[0], x[0], x[1], 3});
    });
    const auto verdict_of = [&](double a, double b) {
        const FitProblem problem =
            test::problem_of(model, {test::free_parameter("x1", 0, 1), test::free_parameter("x2", 0, 1)},
                             {observe("a", a, 0.05), observe("b", b, 0.05), observe("c", 0.3, 0.1),
                              observe("d", 9, 0.1)});  // missed whatever the parameters are
        return identify_at(problem, {0.5, 0.3});
    };
    EXPECT_EQ(verdict_of(0.4, 0.6).verdict, "x1 and x2: determined by the data.");
    const Identifiability result = verdict_of(0.1, 0.9);
    EXPECT_EQ(result.verdict,
              "x2: determined by the data. x1: not determined: the best fit misses the data that depend on it by up to "
              "8 standard deviations.");
    EXPECT_TRUE(in_doubt(result, "x1"));
    EXPECT_FALSE(in_doubt(result, "x2"));
}

TEST(Identifiability, GivesASatisfiedInequalityNoWeight) {
    const ModelInterface model = formula_model(1, {"a"}, [](std::span<const double> x) { return answer({x[0]}); });
    const FitProblem problem =
        test::problem_of(model, {test::free_parameter("x1", 0, 1)}, {observe("a", 0.3, 0.1, Relation::at_least)});
    EXPECT_EQ(identify_at(problem, {0.5}).rank, 0);
    EXPECT_EQ(identify_at(problem, {0.2}).rank, 1);
}

}  // namespace
}  // namespace delabole
