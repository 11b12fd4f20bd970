#include "fitting/back_analysis/back_analysis.hpp"

#include "fitting/mechanism/misfit.hpp"
#include "tests/fitting/test_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <stdexcept>

namespace delabole {
namespace {

using test::answer;
using test::formula_model;
using test::observe;

FitProblem failure_problem() {
    return test::problem_of(test::linear_safety(),
                            {test::with_prior("x1", 0, 1, 0.6, 0.2), test::with_prior("x2", 0, 1, 0.5, 0.3)},
                            {observe("factor_of_safety", 1, 0.05)});
}

// The problem has three parameters, a curved misfit, failures in a corner, an inequality and a profile.
FitProblem rough_problem() {
    const ModelInterface model =
        formula_model(3, {"factor_of_safety", "depth"}, [](std::span<const double> x) -> Prediction {
            if (x[0] + x[1] + x[2] > 2.5) {
                return {"corner", {}, {}};
            }
            Prediction prediction = answer({0.3 + x[0] * (1.5 - x[1]) + 0.2 * x[2], 20 * x[2] * (1 + x[1])});
            prediction.profile = {Point(0, 0), Point(10, 10 * x[2]), Point(20, 12)};
            return prediction;
        });
    FitProblem problem = test::problem_of(
        model,
        {test::with_prior("x1", 0, 1, 0.5, 0.2), test::free_parameter("x2", 0, 1), test::free_parameter("x3", 0, 1)},
        {observe("factor_of_safety", 1, 0.05), observe("factor_of_safety", 1, 0.05), observe("depth", 15, 2)});
    problem.observations[1].relation = Relation::at_least;
    problem.observations[1].conditions = {{"x2", 0.0}};
    problem.profile = ProfileObservation{{Point(0, 0), Point(10, 7), Point(20, 12)}, 1, "test"};
    problem.settings.starts = 6;
    problem.settings.map_points = 9;
    problem.settings.profile_points = 9;
    return problem;
}

void expect_same(const MechanismFit& left, const MechanismFit& right) {
    EXPECT_EQ(left.best, right.best);
    EXPECT_EQ(left.misfit, right.misfit);
    EXPECT_EQ(left.evaluations.total, right.evaluations.total);
    EXPECT_EQ(left.evaluations.failed_by_cause, right.evaluations.failed_by_cause);
    EXPECT_EQ(left.identifiability.verdict, right.identifiability.verdict);
    EXPECT_EQ(left.map->misfit, right.map->misfit);
    ASSERT_EQ(left.profiles.size(), right.profiles.size());
    for (std::size_t index = 0; index < left.profiles.size(); ++index) {
        EXPECT_EQ(left.profiles[index].values, right.profiles[index].values);
        EXPECT_EQ(left.profiles[index].misfits, right.profiles[index].misfits);
    }
    ASSERT_EQ(left.loci.size(), right.loci.size());
    for (std::size_t index = 0; index < left.loci.size(); ++index) {
        EXPECT_EQ(left.loci[index].points, right.loci[index].points);
    }
}

TEST(BackAnalysis, DoesNotDependOnThreadsOrRepetition) {
    for (const Algorithm algorithm : {Algorithm::sbplx, Algorithm::crs2}) {
        FitProblem problem = rough_problem();
        problem.settings.algorithm = algorithm;
        const FitResult one = fit(problem);
        const FitResult again = fit(problem);
        problem.settings.threads = 2;
        const FitResult two = fit(problem);
        ASSERT_EQ(one.mechanisms[0].profiles.size(), 6u);
        expect_same(one.mechanisms[0], again.mechanisms[0]);
        expect_same(one.mechanisms[0], two.mechanisms[0]);
    }
}

TEST(BackAnalysis, TheStationaryPointOfARoughProblemIsAMinimum) {
    const MechanismFit result = fit(rough_problem()).mechanisms[0];
    ASSERT_EQ(result.status, FitStatus::converged);
    const FitProblem problem = rough_problem();
    const Misfit misfit(problem.mechanisms[0], problem);
    for (std::size_t index = 0; index < 3; ++index) {
        for (const double shift : {-1e-3, 1e-3}) {
            std::vector<double> beside = result.best;
            beside[index] += shift;
            EXPECT_GT(misfit.value(beside, Priors::counted).value, result.misfit);
        }
    }
    EXPECT_EQ(result.data_count, 6);
    EXPECT_TRUE(result.profile_fit);
    EXPECT_EQ(result.evaluations.failed_by_cause[0].first, "corner");
}

TEST(BackAnalysis, DrawsTheFailureLine) {
    const MechanismFit result = fit(failure_problem()).mechanisms[0];
    ASSERT_EQ(result.loci.size(), 1u);
    ASSERT_FALSE(result.loci[0].points.empty());
    for (const Point& point : result.loci[0].points) {
        EXPECT_NEAR(point.y(), 2 * point.x() - 1, 1e-9);
    }
    // x1 moves FS more, so there is a root for each value of x2
    EXPECT_EQ(result.loci[0].points.size(), 61u);
    EXPECT_EQ(result.loci[0].branch.size(), 61u);
}

TEST(BackAnalysis, DrawsBothBranchesOfAFailureLine) {
    // FS = 1 on the circle of radius 0.3 round (0.5, 0.5)
    const ModelInterface model = formula_model(2, {"factor_of_safety"}, [](std::span<const double> x) {
        return answer({1.09 - (1 + std::pow(x[0] - 0.5, 2) + std::pow(x[1] - 0.5, 2)) + 1});
    });
    FitProblem problem = test::problem_of(model, {test::free_parameter("x1", 0, 1), test::free_parameter("x2", 0, 1)},
                                          {observe("factor_of_safety", 1, 0.05)});
    const MechanismFit result = fit(problem).mechanisms[0];
    ASSERT_EQ(result.loci.size(), 1u);
    ASSERT_GT(result.loci[0].points.size(), 40u);
    for (const Point& point : result.loci[0].points) {
        EXPECT_NEAR((point - Point(0.5, 0.5)).norm(), 0.3, 1e-9);
    }
    EXPECT_GE(result.loci[0].branch.back(), 1);
}

TEST(BackAnalysis, HasNoLocusWhereFailureIsImpossible) {
    const ModelInterface model =
        formula_model(2, {"factor_of_safety"}, [](std::span<const double> x) { return answer({2 + x[0] + x[1]}); });
    const FitProblem problem =
        test::problem_of(model, {test::free_parameter("x1", 0, 1), test::free_parameter("x2", 0, 1)},
                         {observe("factor_of_safety", 1, 0.05)});
    const MechanismFit result = fit(problem).mechanisms[0];
    ASSERT_EQ(result.loci.size(), 1u);
    EXPECT_TRUE(result.loci[0].points.empty());
    EXPECT_EQ(result.unexplained.size(), 1u) << "a factor of safety of 2 is 20 deviations from 1";
}

TEST(BackAnalysis, GathersTwoMinima) {
    // (x1^2 - 1)^2 / 0.1^2 with a slight preference for +1
    const ModelInterface model = formula_model(1, {"a", "b"}, [](std::span<const double> x) {
        return answer({x[0] * x[0], x[0]});
    });
    const FitProblem problem =
        test::problem_of(model, {test::free_parameter("x1", -2, 2.5)}, {observe("a", 1, 0.1), observe("b", 1, 2)});
    const MechanismFit result = fit(problem).mechanisms[0];
    ASSERT_EQ(result.minima.size(), 2u);
    EXPECT_NEAR(result.minima[0].parameters[0], 1, 1e-4);
    EXPECT_NEAR(result.minima[1].parameters[0], -1, 0.01);
    EXPECT_NEAR(result.minima[1].misfit, 1, 0.01);
    EXPECT_EQ(result.minima[0].hits + result.minima[1].hits, 16);
    EXPECT_EQ(result.best, result.minima[0].parameters);
}

TEST(BackAnalysis, EveryAlgorithmFindsTheSameFit) {
    for (std::size_t number = 0; number < enum_names(Algorithm{}).size(); ++number) {
        FitProblem problem = rough_problem();
        problem.settings.algorithm = static_cast<Algorithm>(number);
        problem.settings.evaluations_per_start = 800;
        const MechanismFit result = fit(problem).mechanisms[0];
        EXPECT_NEAR(result.misfit, fit(rough_problem()).mechanisms[0].misfit, 1e-4) << number;
    }
}

TEST(BackAnalysis, EvaluatesAMechanismWithoutFreeParameters) {
    FitProblem problem = test::problem_of(test::linear_safety(), {}, {observe("factor_of_safety", 1, 0.1)});
    const MechanismFit result = fit(problem).mechanisms[0];
    EXPECT_EQ(result.status, FitStatus::converged);
    EXPECT_NEAR(result.misfit, 16, 1e-12);
    EXPECT_NEAR(result.observations[0].residual, -4, 1e-12);
    EXPECT_EQ(result.prediction.outputs, (std::vector<double>{0.6}));
    EXPECT_EQ(result.identifiability.verdict, "No free parameters: nothing to identify.");
    EXPECT_TRUE(result.profiles.empty());
    EXPECT_FALSE(result.map);
}

TEST(BackAnalysis, KeepsAFixedParameterOutOfTheAnalysis) {
    FitProblem problem = failure_problem();
    problem.mechanisms[0].parameters[1] = test::free_parameter("x2", 0.2, 0.2);
    const MechanismFit result = fit(problem).mechanisms[0];
    ASSERT_EQ(result.best.size(), 2u);
    EXPECT_EQ(result.best[1], 0.2);
    EXPECT_EQ(result.identifiability.parameters, std::vector<std::string>{"x1"});
    EXPECT_EQ(result.identifiability.rank, 1);
    EXPECT_EQ(result.profiles.size(), 2u);
    EXPECT_TRUE(result.loci.empty());
}

TEST(BackAnalysis, AcceptsAnEmptyProblem) {
    EXPECT_TRUE(fit({}).mechanisms.empty());
    const FitProblem silent = test::problem_of(test::linear_safety(), {test::free_parameter("x1", 0, 1)}, {});
    const MechanismFit result = fit(silent).mechanisms[0];
    EXPECT_EQ(result.misfit, 0);
    EXPECT_EQ(result.data_count, 0);
    EXPECT_EQ(result.identifiability.rank, 0);
    EXPECT_EQ(result.identifiability.verdict.find("Nothing observed depends on x1 near the best point."), 0u);
    EXPECT_EQ(result.profiles[0].determination, Determination::undetermined);
}

// A single block overturns at 18.4 deg whatever its friction, unless it slides earlier.
TEST(BackAnalysis, AFlatBestPointIsNotTheWholeRange) {
    const ModelInterface model =
        formula_model(1, {"critical_tilt"}, [](std::span<const double> x) { return answer({std::min(x[0], 18.4)}); });
    const MechanismFit flat =
        fit(test::problem_of(model, {test::free_parameter("x1", 5, 30)}, {observe("critical_tilt", 25, 1)}))
            .mechanisms[0];
    const std::string& verdict = flat.identifiability.verdict;
    EXPECT_EQ(flat.identifiability.rank, 0);
    EXPECT_NE(verdict.find("near the best point"), std::string::npos) << verdict;
    EXPECT_NE(verdict.find(" That holds near the best point only: over the whole range the data alone limit x1"),
              std::string::npos)
        << verdict;
    const MechanismFit idle =
        fit(test::problem_of(formula_model(1, {"critical_tilt"}, [](std::span<const double>) { return answer({18}); }),
                             {test::free_parameter("x1", 5, 30)}, {observe("critical_tilt", 25, 1)}))
            .mechanisms[0];
    EXPECT_EQ(idle.identifiability.verdict.find("That holds"), std::string::npos);
}

TEST(BackAnalysis, TwoSolutionsAreNotCalledOne) {
    const auto verdict = [](double lowest) {
        const ModelInterface model = formula_model(1, {"safety"}, [lowest](std::span<const double> x) {
            return answer({lowest + (1 - lowest) * std::pow((x[0] - 0.5) / 0.3, 2)});
        });
        return fit(test::problem_of(model, {test::free_parameter("x1", 0, 1)}, {observe("safety", 1, 0.02)}))
            .mechanisms[0]
            .identifiability.verdict;
    };
    // Two roots, 12.5 standard deviations away in between, and roots that one standard deviation joins.
    const std::string words =
        "There is more than one solution: the 95 % interval of x1 holds values that the data exclude.";
    EXPECT_NE(verdict(0.75).find(words), std::string::npos) << verdict(0.75);
    EXPECT_EQ(verdict(0.98).find("more than one solution"), std::string::npos) << verdict(0.98);
}

TEST(BackAnalysis, IntervalsBetweenContradictingDataAreDoubtful) {
    const ModelInterface model = formula_model(1, {"a", "b"}, [](std::span<const double> x) {
        return answer({x[0], x[0]});
    });
    const auto determination = [&](double a, double b) {
        return fit(test::problem_of(model, {test::free_parameter("x1", 0, 1)},
                                    {observe("a", a, 0.05), observe("b", b, 0.05)}))
            .mechanisms[0]
            .profiles[0]
            .determination;
    };
    EXPECT_EQ(determination(0.45, 0.55), Determination::determined);
    EXPECT_EQ(determination(0.1, 0.9), Determination::doubtful);
}

TEST(BackAnalysis, RanksMechanismsAndSaysWhatTheyCannotExplain) {
    FitProblem problem = failure_problem();
    const auto blunt = [](std::span<const double>) { return answer({1.3}); };
    problem.mechanisms.insert(problem.mechanisms.begin(),
                              test::mechanism("blunt", "Blunt", formula_model(1, {"factor_of_safety"}, blunt), {}));
    const auto failing = [](std::span<const double>) { return Prediction{"impossible", {}, {}}; };
    problem.mechanisms.insert(problem.mechanisms.begin(),
                              test::mechanism("failing", "Failing", formula_model(1, {"factor_of_safety"}, failing),
                                              {test::free_parameter("x1", 0, 1)}));
    problem.mechanisms[2].signs = {{"cracks", "factor_of_safety", Relation::at_most, 1.2}};
    problem.evidence = {{"cracks", "cracks opened behind the crest", "test"}};
    const FitResult result = fit(problem);
    EXPECT_EQ(result.mechanisms[0].name, "mechanism");
    EXPECT_EQ(result.mechanisms[0].explained, std::vector<std::string>{"cracks"});
    EXPECT_TRUE(result.mechanisms[0].unexplained.empty());
    EXPECT_EQ(result.mechanisms[1].name, "blunt");
    EXPECT_NEAR(result.mechanisms[1].ranking_score, 36 + 4, 1e-9);
    EXPECT_EQ(
        result.mechanisms[1].unexplained,
        (std::vector<std::string>{"cracks (cracks opened behind the crest): the mechanism predicts nothing of the kind",
                                  "factor_of_safety observed: predicted 1.3, observed 1, 6 standard deviations away"}));
    EXPECT_EQ(result.mechanisms[2].status, FitStatus::no_valid_point);
    EXPECT_TRUE(result.mechanisms[2].best.empty());
    EXPECT_EQ(result.mechanisms[2].evaluations.failed(), result.mechanisms[2].evaluations.total);
    EXPECT_EQ(result.mechanisms[2].evaluations.failed_by_cause[0].first, "impossible");
}

TEST(BackAnalysis, EvidenceIsExplainedByWhatIsPredictedAlone) {
    FitProblem problem = failure_problem();
    problem.evidence = {{"cracks", "cracks opened behind the crest", "test"}};
    // At the best point the factor of safety is near 1: the priors draw it away by less than a hundredth.
    problem.mechanisms[0].signs = {{"cracks", "factor_of_safety", Relation::at_least, 0.5},
                                   {"cracks", "factor_of_safety", Relation::at_least, 1.5}};
    const MechanismFit missed = fit(problem).mechanisms[0];
    EXPECT_TRUE(missed.explained.empty());
    ASSERT_EQ(missed.unexplained.size(), 1U);
    EXPECT_TRUE(missed.unexplained[0].starts_with("cracks (cracks opened behind the crest): factor_of_safety is 0.99"))
        << missed.unexplained[0];
    problem.mechanisms[0].signs.pop_back();
    EXPECT_EQ(fit(problem).mechanisms[0].explained, std::vector<std::string>{"cracks"});
}

TEST(BackAnalysis, KeepsTheBestPointWhenInterrupted) {
    std::atomic<bool> stop = false;
    std::atomic<int> calls = 0;
    FitProblem problem = failure_problem();
    const auto predict = problem.mechanisms[0].model.predict;
    problem.mechanisms[0].model.predict = [&, predict](std::span<const Assignment> assignments) {
        if (++calls == 50) {
            stop = true;
        }
        return predict(assignments);
    };
    const MechanismFit result = fit(problem, {}, &stop).mechanisms[0];
    EXPECT_EQ(result.status, FitStatus::interrupted);
    EXPECT_EQ(result.best.size(), 2u);
    EXPECT_TRUE(result.observations[0].predicted);
    EXPECT_TRUE(result.profiles.empty());
    EXPECT_LT(calls, 60) << "a few more to describe the best point";
    EXPECT_EQ(result.identifiability.status, IdentifiabilityStatus::not_evaluated);
}

TEST(BackAnalysis, PassesOnAModelsException) {
    for (const int threads : {1, 2}) {
        FitProblem problem = failure_problem();
        problem.settings.threads = threads;
        problem.mechanisms[0].model.predict = [](std::span<const Assignment>) -> Prediction {
            throw std::domain_error("broken model");
        };
        EXPECT_THROW(fit(problem), std::domain_error);
    }
}

TEST(BackAnalysis, ReportsProgressThatRisesToOne) {
    std::vector<double> fractions;
    fit(failure_problem(), [&fractions](const FitProgress& progress) {
        EXPECT_EQ(progress.mechanism, "mechanism");
        fractions.push_back(progress.fraction);
    });
    ASSERT_GE(fractions.size(), 5u);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    EXPECT_EQ(fractions.back(), 1);
}

TEST(BackAnalysis, RefusesAFaultyProblem) {
    FitProblem problem = failure_problem();
    problem.observations[0].standard_deviation = 0;
    EXPECT_THROW(fit(problem), std::invalid_argument);
}

}  // namespace
}  // namespace delabole
