#include "fitting/mechanism/misfit.hpp"

#include "fitting/back_analysis/check_problem.hpp"
#include "fitting/mechanism/input_binding.hpp"
#include "tests/fitting/test_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace delabole {
namespace {

using test::answer;
using test::formula_model;
using test::observe;

ModelInterface identity() {
    return formula_model(2, {"a", "b"}, [](std::span<const double> x) { return answer({x[0], x[1]}); });
}

TEST(Misfit, SumsSquaresOfDataAndPriors) {
    const FitProblem problem =
        test::problem_of(identity(), {test::free_parameter("x1", 0, 10), test::with_prior("x2", 0, 10, 4, 0.5)},
                         {observe("a", 3, 2), observe("b", 5, 1)});
    const Misfit misfit(problem.mechanisms[0], problem);
    const MisfitParts parts = misfit.parts(std::vector<double>{7, 6});
    EXPECT_DOUBLE_EQ(parts.data, 4 + 1);
    EXPECT_DOUBLE_EQ(parts.prior, 16);
    EXPECT_DOUBLE_EQ(misfit.value(std::vector<double>{7, 6}, Priors::counted).value, 21);
    EXPECT_DOUBLE_EQ(misfit.value(std::vector<double>{7, 6}, Priors::ignored).value, 5);
    EXPECT_EQ(misfit.centre(), (std::vector<double>{5, 4}));
}

TEST(Misfit, CountsAnInequalityOnlyWhereBroken) {
    const FitProblem problem =
        test::problem_of(identity(), {test::free_parameter("x1", 0, 10), test::free_parameter("x2", 0, 10)},
                         {observe("a", 3, 2, Relation::at_least), observe("b", 5, 1, Relation::at_most)});
    const Misfit misfit(problem.mechanisms[0], problem);
    EXPECT_EQ(misfit.parts(std::vector<double>{4, 4}).data, 0);
    EXPECT_DOUBLE_EQ(misfit.parts(std::vector<double>{1, 4}).data, 1);
    EXPECT_DOUBLE_EQ(misfit.parts(std::vector<double>{4, 8}).data, 9);
    EXPECT_EQ(misfit.compare(std::vector<double>{4, 8})[0].residual, 0);
    EXPECT_DOUBLE_EQ(misfit.compare(std::vector<double>{4, 8})[1].residual, 3);
}

// A slope that nothing drives has an infinite factor of safety: it stood, and did not just fail.
TEST(Misfit, AnInfinitePredictionSatisfiesAnInequality) {
    const auto parts = [](double sign, Relation relation) {
        const ModelInterface model = formula_model(1, {"a"}, [sign](std::span<const double>) {
            return answer({sign * std::numeric_limits<double>::infinity()});
        });
        const FitProblem problem =
            test::problem_of(model, {test::free_parameter("x1", 0, 1)}, {observe("a", 3, 2, relation)});
        return Misfit(problem.mechanisms[0], problem).parts(std::vector<double>{0.5});
    };
    EXPECT_TRUE(parts(1, Relation::at_least).failure.empty());
    EXPECT_EQ(parts(1, Relation::at_least).data, 0);
    EXPECT_EQ(parts(-1, Relation::at_most).data, 0);
    EXPECT_FALSE(parts(1, Relation::equal).failure.empty());
    EXPECT_FALSE(parts(1, Relation::at_most).failure.empty());
    EXPECT_FALSE(parts(-1, Relation::at_least).failure.empty());
    EXPECT_FALSE(parts(NAN, Relation::at_least).failure.empty());
}

TEST(Misfit, ConditionsOverrideInputsAndAreEvaluatedOnce) {
    int calls = 0;
    const ModelInterface model = formula_model(2, {"a", "b"}, [&calls](std::span<const double> x) {
        ++calls;
        return answer({x[0] + 10 * x[1], x[1]});
    });
    std::vector<QuantityObservation> observations = {observe("a", 0, 1), observe("a", 0, 1), observe("b", 0, 1)};
    observations[1].conditions = {{"x2", 0.5}, {"x1", 1}};
    observations[2].conditions = {{"x1", 1}, {"x2", 0.5}};
    const FitProblem problem =
        test::problem_of(model, {test::free_parameter("x1", 0, 10), test::free_parameter("x2", 0, 10)}, observations);
    const Misfit misfit(problem.mechanisms[0], problem);
    const Residuals residuals = misfit.residuals(std::vector<double>{2, 3});
    EXPECT_EQ(residuals.values, (std::vector<double>{32, 6, 0.5}));
    EXPECT_EQ(calls, 2);
}

TEST(Misfit, SkipsAndListsWhatTheMechanismLacks) {
    std::vector<QuantityObservation> observations = {observe("a", 1, 1), observe("crack_depth", 9, 1),
                                                     observe("b", 1, 1)};
    observations[2].conditions = {{"water", 0}};
    const FitProblem problem = test::problem_of(identity(), {test::free_parameter("x1", 0, 10)}, observations);
    const Misfit misfit(problem.mechanisms[0], problem);
    EXPECT_EQ(misfit.data_count(), 1);
    EXPECT_EQ(misfit.missing_count(), 2);
    EXPECT_DOUBLE_EQ(misfit.parts(std::vector<double>{4}).data, 9);
    EXPECT_EQ(misfit.not_compared()[0], "crack_depth observed: the mechanism does not predict crack_depth");
    EXPECT_EQ(misfit.not_compared()[1], "b observed: the mechanism has no input water, which the observation fixes");
    EXPECT_FALSE(misfit.compare(std::vector<double>{4})[1].predicted);
}

TEST(Misfit, ReportsAnOutputThatIsNotANumber) {
    const ModelInterface model =
        formula_model(1, {"a"}, [](std::span<const double> x) { return answer({std::sqrt(x[0])}); });
    const FitProblem problem = test::problem_of(model, {test::free_parameter("x1", -1, 1)}, {observe("a", 1, 1)});
    const Misfit misfit(problem.mechanisms[0], problem);
    EXPECT_EQ(misfit.parts(std::vector<double>{-0.5}).failure, "a is not a number");
    EXPECT_TRUE(misfit.parts(std::vector<double>{0.5}).failure.empty());
}

TEST(Misfit, MeasuresTheDistanceOfProfiles) {
    // The predicted ground is the observed one raised by x1; beyond x1 = 5 the model forgets it.
    const ModelInterface model = formula_model(1, {"a"}, [](std::span<const double> x) {
        Prediction prediction = answer({0});
        if (x[0] <= 5) {
            prediction.profile = {Point(-1, x[0]), Point(101, x[0])};
        }
        return prediction;
    });
    FitProblem problem = test::problem_of(model, {test::free_parameter("x1", 0, 10)}, {});
    problem.profile = ProfileObservation{{Point(0, 0), Point(50, 0), Point(100, 0)}, 2.0, "test"};
    const Misfit misfit(problem.mechanisms[0], problem);
    EXPECT_NEAR(misfit.parts(std::vector<double>{3}).data, 3 * (3.0 / 2) * (3.0 / 2), 1e-12);
    EXPECT_NEAR(misfit.compare_profile(std::vector<double>{3})->rms, 3, 1e-12);
    EXPECT_GT(misfit.residuals(std::vector<double>{3}).values.front(), 0) << "predicted above observed";
    EXPECT_EQ(misfit.data_count(), 3);
    EXPECT_EQ(misfit.parts(std::vector<double>{6}).failure, "profile_missing");
}

// A mean of cases that scatter is compared with one of them: its density at the observed place is that of a normal
// distribution as wide as observation and scatter together, over that of the observation alone.
TEST(Misfit, CountsTheScatterOfAnEnsembleAsItsDensitySays) {
    const ModelInterface model =
        formula_model(1, {"a", "ensemble_deviation.a", "ensemble_deviation.profile"}, [](std::span<const double> x) {
            Prediction prediction = answer({x[0], 4, 1});
            prediction.profile = {Point(-1, 2), Point(101, 2)};
            return prediction;
        });
    FitProblem problem =
        test::problem_of(model, {test::free_parameter("x1", 0, 10)}, {observe("a", 1, 3), observe("a", 1, 3)});
    problem.observations[1].label = "at most";
    problem.observations[1].relation = Relation::at_most;
    problem.profile = ProfileObservation{{Point(0, 0), Point(50, 0), Point(100, 0)}, 2.0, "test"};
    const Misfit misfit(problem.mechanisms[0], problem);
    const std::vector<double> at{6};
    // The deviations are 5 and the root of 5; an inequality is no density.
    const double fit = 2 * 1 + 3 * 4 / 5.0;
    const double cost = std::log(25 / 9.0) + 3 * std::log(5 / 4.0);
    EXPECT_NEAR(misfit.parts(at).data, fit + cost, 1e-12);
    EXPECT_NEAR(misfit.scatter_cost(at), cost / 2, 1e-12);
    EXPECT_NEAR(misfit.compare(at)[0].standard_deviation, 5, 1e-12);
    EXPECT_NEAR(misfit.compare_profile(at)->residual(), 2 / std::sqrt(5), 1e-12);
    EXPECT_EQ(misfit.residuals(at).values.size(), misfit.data().size());
    EXPECT_EQ(misfit.data_count(), 5);
}

// Deviations between slopes and between loading paths add as independent ones do.
TEST(Misfit, AddsTheDeviationBetweenLoadingPaths) {
    const ModelInterface model =
        formula_model(1, {"a", "ensemble_deviation.a", "path_deviation.a"}, [](std::span<const double> x) {
            return answer({x[0], 4, 12});
        });
    const FitProblem problem = test::problem_of(model, {test::free_parameter("x1", 0, 10)}, {observe("a", 1, 3)});
    const Misfit misfit(problem.mechanisms[0], problem);
    EXPECT_NEAR(misfit.parts(std::vector<double>{6}).data, 25 / 169.0 + std::log(169 / 9.0), 1e-12);
    EXPECT_NEAR(misfit.compare(std::vector<double>{6})[0].scatter, std::sqrt(160), 1e-12);
}

// Where draws cannot be divided evenly the last of them closes a shorter stretch, so that none of those asked for is
// missing.
TEST(Draws, AreThinnedToAsManyAsAskedFor) {
    std::vector<Draw> draws;
    for (int number = 0; number < 4000; ++number) {
        draws.push_back({0, {}, static_cast<double>(number)});
    }
    const std::vector<Draw> kept = thinned(draws, 30);
    ASSERT_EQ(kept.size(), 30U);
    EXPECT_EQ(kept[0].misfit, 133);
    EXPECT_EQ(kept[28].misfit, 29 * 134 - 1);
    EXPECT_EQ(kept[29].misfit, 3999);
    EXPECT_EQ(thinned(draws, 8).front().misfit, 499);
    EXPECT_EQ(thinned(draws, 5000).size(), draws.size());
}

TEST(CheckProblem, NamesEveryFault) {
    FitProblem problem = test::problem_of(
        identity(),
        {test::free_parameter("x1", 2, 1), test::free_parameter("y", 0, 1), test::with_prior("x2", 0, 1, 0.5, 0)},
        {observe("a", std::nan(""), 1), observe("b", 1, -1)});
    problem.profile = ProfileObservation{{Point(1, 1), Point(1, 1)}, 1, "test"};
    problem.settings.starts = 0;
    const std::vector<std::string> faults = check_problem(problem);
    const std::vector<std::string> expected = {
        "mechanism, parameter x1: lower = 2 exceeds upper = 1",
        "mechanism, parameter y: the model has no such input",
        "mechanism, parameter x2, prior: standard_deviation = 0 must be finite and > 0",
        "observation a observed: value = nan must be finite",
        "observation b observed: standard_deviation = -1 must be finite and > 0",
        "profile: needs at least two distinct points",
        "settings: starts = 0 must be from 1 to 100000",
    };
    EXPECT_EQ(faults, expected);
}

}  // namespace
}  // namespace delabole
