#include "fitting/sensitivity/sensitivity.hpp"

#include "tests/fitting/test_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace delabole {
namespace {

using test::answer;
using test::formula_model;

// x3 plays no part.
SensitivityProblem everything() {
    SensitivityProblem problem;
    problem.model = formula_model(3, {"weight", "factor_of_safety"}, [](std::span<const double> x) {
        return answer({7, 1.5 + 0.3 * x[0] - 0.2 * x[1]});
    });
    SensitivityStudy& study = problem.study;
    study.quantity = "factor_of_safety";
    study.parameters = {{"x1", {Normal{0, 1}}, ""}, {"x3", {Uniform{0, 1}}, ""}, {"x2", {Normal{0, 1}}, ""}};
    study.failure = FailureCriterion{1, FailureSide::below, {}, {}};
    study.tornado = TornadoSettings{};
    study.morris = MorrisSettings{};
    study.sobol_indices = SobolIndicesSettings{.samples = 256, .bootstrap = 100};
    study.propagation = PropagationSettings{};
    study.reliability = ReliabilitySettings{};
    return problem;
}

TEST(Sensitivity, AllMethodsSpeakOfTheSameProblem) {
    const SensitivityResult result = sensitivity(everything());
    EXPECT_EQ(result.status, SensitivityStatus::finished);
    const double beta = 0.5 / std::sqrt(0.09 + 0.04);
    EXPECT_NEAR(result.reliability->reliability_index, beta, 1e-5);
    EXPECT_NEAR(result.propagation->failure->probability->value, result.reliability->probability_of_failure, 0.01);
    EXPECT_NEAR(result.sobol_indices->parameters[0].total.value, 9.0 / 13, 0.03);
    EXPECT_NEAR(result.propagation->standard_deviation, std::sqrt(0.13), 0.01);
    EXPECT_DOUBLE_EQ(result.tornado->at_medians.value, 1.5);
    ASSERT_EQ(result.without_effect.size(), 1U);
    EXPECT_EQ(result.without_effect.front(), 1U);
}

// A search that ended at a bound is decided if the bound and all beyond it are on one side of the limit.
TEST(Sensitivity, BoundsOfTheQuantityDecideSamples) {
    SensitivityProblem problem;
    problem.model = formula_model(1, {"critical_tilt", "weight"}, [](std::span<const double> x) {
        return x[0] > 0.5   ? Prediction{"stands_everywhere", {}, {}}
               : x[0] < 0.1 ? Prediction{"fails_everywhere", {}, {}}
                            : answer({x[0], 7});
    });
    problem.model.bounds = {{"stands_everywhere", 0, at_least(0.5)}, {"fails_everywhere", 0, less_than(0.1)}};
    SensitivityStudy& study = problem.study;
    study.quantity = "critical_tilt";
    study.parameters = {{"x1", {Uniform{0, 1}}, ""}};
    study.failure = FailureCriterion{0.3, FailureSide::below, {}, {}};
    study.propagation = PropagationSettings{SamplingMethod::latin_hypercube, 1000, 10};
    const auto studied = [&] { return *sensitivity(problem).propagation; };
    const PropagationResult decided = studied();
    EXPECT_EQ(decided.failure->decided, 1000);
    EXPECT_DOUBLE_EQ(decided.failure->probability->value, 0.3);
    EXPECT_EQ(decided.with_value, 400);  // a bound is no value
    EXPECT_GE(decided.least, 0.1);
    EXPECT_LE(decided.greatest, 0.5);

    // A value of at least 0.5 is undecided at a limit of 0.6.
    study.failure->limit = 0.6;
    const PropagationResult open = studied();
    EXPECT_EQ(open.failure->decided, 500);
    EXPECT_DOUBLE_EQ(open.failure->least, 0.5);

    // The words listed in the study go first; bounds of another output decide nothing.
    study.failure = FailureCriterion{0.3, FailureSide::below, {"stands_everywhere"}, {}};
    EXPECT_DOUBLE_EQ(studied().failure->probability->value, 0.8);
    study.quantity = "weight";
    study.failure = FailureCriterion{0.3, FailureSide::below, {}, {}};
    EXPECT_EQ(studied().failure->decided, 400);

    study.quantity = "critical_tilt";
    problem.model.predict = [](std::span<const Assignment>) { return Prediction{"stands_everywhere", {}, {}}; };
    const SensitivityResult all_stand = sensitivity(problem);
    EXPECT_EQ(all_stand.status, SensitivityStatus::finished);
    EXPECT_EQ(all_stand.propagation->failure->probability->value, 0);
}

// Of two slopes one is at x; the other is taken at the lower bound of a search, 0.2, if x is below 0.4 and at the upper
// one, 0.6, if it is above 0.5; in between both are at x.
TEST(Sensitivity, AMeanThatIsOnlyABoundDecidesOnlyTheSideOnWhichItLies) {
    SensitivityProblem problem;
    problem.model = formula_model(1, {"mean", "at_lower", "at_upper"}, [](std::span<const double> x) {
        return x[0] < 0.4   ? answer({(x[0] + 0.2) / 2, 1, 0})
               : x[0] > 0.5 ? answer({(x[0] + 0.6) / 2, 0, 1})
                            : answer({x[0], 0, 0});
    });
    problem.model.bounded_outputs = {{0, 1, 2}};
    SensitivityStudy& study = problem.study;
    study.quantity = "mean";
    study.parameters = {{"x1", {Uniform{0, 1}}, ""}};
    study.propagation = PropagationSettings{SamplingMethod::latin_hypercube, 1000, 10};
    const auto studied = [&](double limit) {
        study.failure = FailureCriterion{limit, FailureSide::below, {}, {}};
        return *sensitivity(problem).propagation;
    };
    // Means of at most 0.3 are below 0.45, and means of at least 0.55 above it.
    const PropagationResult decided = studied(0.45);
    EXPECT_EQ(decided.failure->decided, 1000);
    EXPECT_DOUBLE_EQ(decided.failure->probability->value, 0.45);
    // A mean of at most 0.25 to 0.3 may be below 0.25; one of at least 0.55 is not.
    const PropagationResult low = studied(0.25);
    EXPECT_EQ(low.failure->decided, 900);
    EXPECT_DOUBLE_EQ(low.failure->least, 0.3);
    EXPECT_DOUBLE_EQ(low.failure->greatest, 0.4);
    // A mean of at least 0.55 to 0.7 may be above 0.7.
    EXPECT_EQ(studied(0.7).failure->decided, 700);
    // Without a limit the mean is a value like any other.
    study.failure.reset();
    EXPECT_EQ(sensitivity(problem).propagation->with_value, 1000);
}

TEST(Sensitivity, NothingAnsweredIsAStatus) {
    SensitivityProblem problem = everything();
    problem.model.predict = [](std::span<const Assignment>) { return Prediction{"impossible", {}, {}}; };
    const SensitivityResult result = sensitivity(problem);
    EXPECT_EQ(result.status, SensitivityStatus::no_answer);
    EXPECT_EQ(result.propagation->evaluations.failed(), result.propagation->samples);
    EXPECT_TRUE(result.without_effect.empty());  // without any value no effect can be judged
}

TEST(Sensitivity, StoppedBeforeItBegan) {
    const std::atomic<bool> stop = true;
    const SensitivityResult result = sensitivity(everything(), {}, &stop);
    EXPECT_EQ(result.status, SensitivityStatus::interrupted);
    EXPECT_FALSE(result.tornado);
}

TEST(Sensitivity, FaultsStandAtTheirKeys) {
    const auto key_of = [](const std::function<void(SensitivityStudy&)>& spoil) {
        SensitivityProblem problem = everything();
        spoil(problem.study);
        const std::vector<StudyFault> faults = check_study(problem);
        EXPECT_THROW(sensitivity(problem), std::invalid_argument);
        return faults.empty() ? std::string("none") : faults.front().key;
    };
    using Study = SensitivityStudy;
    EXPECT_EQ(key_of([](Study& study) { study.parameters.clear(); }), "");
    EXPECT_EQ(key_of([](Study& study) { study.parameters[1].name = "x9"; }), "parameter[2].name");
    EXPECT_EQ(key_of([](Study& study) { study.parameters[1].name = "x1"; }), "parameter[2].name");
    EXPECT_EQ(key_of([](Study& study) {
                  study.parameters[0].distribution = {Normal{0, -1}};
              }),
              "parameter[1].standard_deviation");
    EXPECT_EQ(key_of([](Study& study) { study.quantity = "settlement"; }), "quantity");
    EXPECT_EQ(key_of([](Study& study) { study.failure.reset(); }), "reliability");
    EXPECT_EQ(key_of([](Study& study) { study.morris->levels = 5; }), "morris.levels");
    EXPECT_EQ(key_of([](Study& study) { study.tornado->lower_probability = 0.7; }), "tornado.lower_probability");
    EXPECT_EQ(key_of([](Study& study) { study.sobol_indices->samples = 100; }), "sobol_indices.samples");
    EXPECT_EQ(key_of([](Study& study) { study.propagation->samples = 0; }), "propagation.samples");
    EXPECT_EQ(key_of([](Study& study) {
                  study.tornado.reset();
                  study.morris.reset();
                  study.sobol_indices.reset();
                  study.propagation.reset();
                  study.reliability.reset();
              }),
              "");
    const auto tie = [](const char* first, const char* second, double coefficient) {
        return [=](Study& study) {
            study.sobol_indices.reset();
            study.correlations = {{{first, second}, CorrelationMeasure::linear, coefficient}};
        };
    };
    EXPECT_EQ(key_of(tie("x1", "x7", 0.5)), "correlation[1].between");
    EXPECT_EQ(key_of(tie("x1", "x1", 0.5)), "correlation[1].between");
    EXPECT_EQ(key_of(tie("x1", "x2", 1)), "correlation[1].coefficient");
    EXPECT_EQ(key_of(tie("x1", "x3", 0.99)), "correlation[1].coefficient");  // a uniform and a normal reach 0.977
    EXPECT_EQ(key_of([](Study& study) {
                  study.correlations = {{{"x1", "x2"}, CorrelationMeasure::linear, 0.5}};
              }),
              "sobol_indices");
}

}  // namespace
}  // namespace delabole
