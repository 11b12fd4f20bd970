#include "fitting/mechanism/mechanism_posterior.hpp"

#include "fitting/back_analysis/back_analysis.hpp"
#include "fitting/back_analysis/check_problem.hpp"
#include "fitting/studies/comparison.hpp"

#include "tests/fitting/posterior_targets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace delabole {
namespace {

using test::answer;
using test::formula_model;
using test::free_parameter;
using test::observe;
using test::problem_of;
using test::square;
using test::with_prior;

FitProblem with_posterior(FitProblem problem) {
    problem.posterior = PosteriorStudy{};
    problem.settings.starts = 2;
    problem.settings.profile_points = 5;
    problem.settings.map_points = 5;
    return problem;
}

MechanismPosterior studied(const FitProblem& problem, std::size_t mechanism = 0) {
    ProgressMeter progress({}, 1);
    return study_posterior(problem, mechanism, nullptr, progress);
}

bool mention(const std::vector<std::string>& sentences, const std::string& words) {
    return std::any_of(sentences.begin(), sentences.end(),
                       [&](const std::string& sentence) { return sentence.find(words) != std::string::npos; });
}

FitProblem linear_problem() {
    return with_posterior(problem_of(test::linear_safety(),
                                     {with_prior("x1", -6, 6, 0.5, 1), with_prior("x2", -6, 6, 0, 0.5)},
                                     {observe("factor_of_safety", 1, 0.1)}));
}

// With those priors the linear FS has mean 0.6 + 0.4 = 1 and variance 0.64 + 0.04; the bounds cut off 1e-7.
double linear_evidence(double prior_factor, double model_error) {
    const double variance = 0.68 * square(prior_factor) + square(model_error);
    return std::log(model_error / std::sqrt(variance));
}

TEST(MechanismPosterior, EvidenceOfEachVariantIsThatOfTheTextbook) {
    const MechanismPosterior found = studied(linear_problem());
    ASSERT_EQ(found.evidences.size(), 8U);
    const auto expect = [&](EvidenceVariant variant, double expected) {
        const auto place = std::find_if(found.evidences.begin(), found.evidences.end(),
                                        [&](const VariantEvidence& one) { return one.variant == variant; });
        ASSERT_NE(place, found.evidences.end());
        // Student's distribution with 15 degrees of freedom exceeds 4.1 with probability 0.001.
        EXPECT_NEAR(place->evidence.log_evidence, expected, 4.1 * place->evidence.standard_error) << word_of(variant);
        EXPECT_LT(place->evidence.standard_error, 0.05) << word_of(variant);
    };
    expect(EvidenceVariant::as_given, linear_evidence(1, 0.1));
    expect(EvidenceVariant::priors_halved, linear_evidence(0.5, 0.1));
    // Both means move by one deviation: the factor of safety by 0.8 of 1 less 0.4 of 0.5; its variance stays.
    const double moved = linear_evidence(1, 0.1) - square(0.6) / (2 * (0.68 + 0.01));
    expect(EvidenceVariant::prior_means_lower, moved);
    expect(EvidenceVariant::prior_means_higher, moved);
    expect(EvidenceVariant::model_error_halved, linear_evidence(1, 0.05));
    expect(EvidenceVariant::model_error_doubled, linear_evidence(1, 0.2));
    // Flat in a square of side 12: the band |0.8 x1 - 0.4 x2 - 0.4| crosses it over x2 = -6 ... 6 with width
    // sqrt(2 pi) 0.1 / 0.8 in x1, all within the bounds (x1 = 0.5 + x2 / 2).
    expect(EvidenceVariant::priors_flat, std::log(std::sqrt(2 * std::numbers::pi) * 0.1 / 0.8 / 12));
    EXPECT_TRUE(found.warnings.empty() || !mention(found.warnings, "exclude"));
}

// A rival that states the same datum with ten times the standard deviation would be perfect for every parameter.
TEST(MechanismPosterior, LessPreciseDataMakeNoMechanismMoreLikely) {
    FitProblem problem = linear_problem();
    problem.mechanisms.push_back(problem.mechanisms.front());
    const std::string label = problem.observations.front().label;
    const auto own = [&](Relation relation) {
        problem.mechanisms.back().own_observations = {{label, "factor_of_safety", relation, 1, 1, {}, "test"}};
        return studied(problem, 1);
    };
    const MechanismPosterior found = own(Relation::equal);
    // Both densities, of variance 0.68 + 0.01 and 0.68 + 1, in units of the shared standard deviation of 0.1.
    EXPECT_NEAR(found.log_evidence(), std::log(0.1 / std::sqrt(0.68 + 1)), 4.1 * found.evidence().standard_error);
    EXPECT_LT(found.log_evidence(), studied(problem, 0).log_evidence());
    EXPECT_EQ(own(Relation::at_least).log_own_precision, 0);
    // Nor does a datum that the mechanism cannot be compared with.
    own(Relation::equal);
    problem.mechanisms.back().own_observations.front().standard_deviation = 0.01;
    problem.mechanisms.back().own_observations.front().conditions = {{"x9", 1}};
    EXPECT_EQ(studied(problem, 1).log_own_precision, 0);
    problem.mechanisms.back().own_observations.push_back(problem.mechanisms.back().own_observations.front());
    EXPECT_TRUE(mention(check_problem(problem), "its label belongs to more than one observation"));
}

TEST(MechanismPosterior, OfACostlyModelWithTooFewRunsIsUnknownWithoutFurtherRuns) {
    FitProblem problem = linear_problem();
    int runs = 0;
    problem.mechanisms.front().model.predict = [&](std::span<const Assignment>) {
        ++runs;
        return Prediction{"no_answer", {}, {}};
    };
    problem.mechanisms.front().model.costly = true;
    problem.profile = ProfileObservation{{Point(0, 0), Point(1, 0)}, 1, "test"};
    const MechanismPosterior found = studied(problem);
    EXPECT_EQ(found.evidence().status, EvidenceStatus::no_valid_point);
    EXPECT_EQ(found.evidence().log_evidence, -std::numeric_limits<double>::infinity());
    EXPECT_LT(runs, 20) << "those that find out about a profile, 16 at most";
    EXPECT_TRUE(mention(found.warnings, "too_few_runs_have_an_answer"));
}

TEST(MechanismPosterior, OfTwoParametersAgreesWithQuadrature) {
    // A product, so that the ridge bends: friction against water along FS = 1.
    const auto safety = [](double x, double y) { return x * (2 - y * y); };
    FitProblem problem = with_posterior(problem_of(
        formula_model(2, {"factor_of_safety"}, [&](std::span<const double> x) { return answer({safety(x[0], x[1])}); }),
        {with_prior("x1", 0.2, 2, 0.8, 0.4), free_parameter("x2", 0, 1.3)}, {observe("factor_of_safety", 1, 0.05)}));
    const MechanismPosterior found = studied(problem);
    ASSERT_EQ(found.posterior.status, PosteriorStatus::converged);
    double prior = 0;
    double sum = 0;
    double mean = 0;
    constexpr int cells = 1200;  // the ridge is 0.03 wide, the cells are 0.0015: the midpoint rule errs by far less
    for (int i = 0; i < cells; ++i) {
        const double x = 0.2 + 1.8 * (i + 0.5) / cells;
        for (int j = 0; j < cells; ++j) {
            const double y = 1.3 * (j + 0.5) / cells;
            const double weight = std::exp(-square((x - 0.8) / 0.4) / 2);
            const double likelihood = std::exp(-square((safety(x, y) - 1) / 0.05) / 2);
            prior += weight;
            sum += weight * likelihood;
            mean += weight * likelihood * x;
        }
    }
    EXPECT_NEAR(found.evidence().log_evidence, std::log(sum / prior), 4.1 * found.evidence().standard_error);
    const ParameterPosterior& x = found.posterior.parameters.front();
    EXPECT_NEAR(x.mean, mean / sum, 4 * x.standard_deviation / std::sqrt(x.diagnostics.bulk_size));
}

TEST(MechanismPosterior, CountsWhatTheMechanismSaysNothingAboutAsMissed) {
    FitProblem problem = linear_problem();
    problem.observations.push_back(observe("crack_depth", 10, 1));
    problem.evidence = {{"planar_surface", "planar", ""}, {"rotation", "blocks turn", ""}};
    problem.mechanisms[0].signs = {{"rotation", "factor_of_safety", Relation::at_least, 0}};
    const FitResult fitted = fit(problem);
    const MechanismPosterior& found = *fitted.mechanisms.front().posterior;
    EXPECT_EQ(found.missing_data, 1);
    EXPECT_EQ(found.missing_field_evidence, 1);
    EXPECT_DOUBLE_EQ(found.log_evidence(found.evidence(), false), found.evidence().log_evidence - 2);
    EXPECT_DOUBLE_EQ(found.log_evidence(), found.evidence().log_evidence - 4);
    // The best point fits exactly: the Occam factor is the evidence itself, to the misfit of the best of the points.
    EXPECT_NEAR(found.log_occam_factor(), found.evidence().log_evidence, 1e-3);
}

TEST(MechanismPosterior, NamesThePriorsThatExcludeWhatWasObserved) {
    FitProblem problem = linear_problem();
    problem.observations.front().value = 9;  // 10 standard deviations of the prior's own spread away
    const MechanismPosterior found = studied(problem);
    EXPECT_TRUE(mention(found.warnings, "The priors exclude what was observed"));
    EXPECT_TRUE(mention(found.warnings, "factor_of_safety observed"));
}

TEST(MechanismPosterior, SaysWhenThereAreMoreParametersThanData) {
    EXPECT_TRUE(mention(studied(linear_problem()).warnings, "2 free parameters, 1 datum"));
    FitProblem enough = linear_problem();
    enough.observations.push_back(observe("factor_of_safety", 1, 0.2));
    EXPECT_FALSE(mention(studied(enough).warnings, "More parameters"));
}

TEST(MechanismPosterior, SaysWhenNoDrawHasAnAnswerAndWhy) {
    FitProblem problem = linear_problem();
    problem.mechanisms[0].model.predict = [](std::span<const Assignment>) {
        return Prediction{"crack_below_plane", {}, {}};
    };
    const MechanismPosterior found = studied(problem);
    EXPECT_EQ(found.posterior.status, PosteriorStatus::no_valid_point);
    EXPECT_TRUE(mention(found.warnings, "crack_below_plane"));
    EXPECT_EQ(found.evidence().status, EvidenceStatus::no_valid_point);
    EXPECT_EQ(found.log_evidence(), -std::numeric_limits<double>::infinity());
}

TEST(MechanismPosterior, VariantsAreThoseThatChangeAnything) {
    FitProblem problem = problem_of(test::linear_safety(), {free_parameter("x1", 0, 1)}, {observe("depth", 1, 1)});
    EXPECT_EQ(variants_of(problem), std::vector{EvidenceVariant::as_given});
    const FitProblem halved = varied(linear_problem(), EvidenceVariant::priors_halved);
    EXPECT_DOUBLE_EQ(halved.mechanisms[0].parameters[0].prior->standard_deviation, 0.5);
    EXPECT_DOUBLE_EQ(halved.observations[0].standard_deviation, 0.1);
    EXPECT_FALSE(varied(linear_problem(), EvidenceVariant::priors_flat).mechanisms[0].parameters[1].prior.has_value());
    EXPECT_DOUBLE_EQ(varied(linear_problem(), EvidenceVariant::model_error_doubled).observations[0].standard_deviation,
                     0.2);
}

TEST(MechanismPosterior, PriorsThatLeaveNothingBetweenTheBoundsAreFaults) {
    FitProblem problem = linear_problem();
    EXPECT_TRUE(check_problem(problem).empty());
    problem.mechanisms[0].parameters[0].prior->mean = 100;
    EXPECT_TRUE(mention(check_problem(problem), "x1"));
    // Four deviations beyond the bound are enough as given, eight are not when the deviation is halved.
    problem.mechanisms[0].parameters[0].prior->mean = 10;
    EXPECT_TRUE(mention(check_problem(problem), "halved"));
    problem = linear_problem();
    problem.posterior->draws = 63;
    EXPECT_TRUE(mention(check_problem(problem), "draws = 63"));
}

TEST(MechanismPosterior, FitRanksByEvidenceAndNamesWhatNothingDependsOn) {
    FitProblem problem = linear_problem();
    // The rival has a parameter that must be tuned far more closely, and one without effect.
    problem.mechanisms.push_back(test::mechanism(
        "tuned", "Tuned",
        formula_model(2, {"factor_of_safety"}, [](std::span<const double> x) { return answer({1 + 10 * x[0]}); }),
        {with_prior("x1", -6, 6, 0, 1), with_prior("x2", -6, 6, 0, 1)}));
    std::swap(problem.mechanisms[0], problem.mechanisms[1]);
    problem.settings.threads = 2;
    const FitResult result = fit(problem);
    EXPECT_EQ(result.mechanisms[0].name, "mechanism");
    const MechanismFit& tuned = result.mechanisms[1];
    EXPECT_NE(tuned.identifiability.verdict.find("Nothing observed depends on x2"), std::string::npos);
    // Both fit exactly; the tuned one leaves a share 0.1 / 10 of its prior, ln(0.01), the other ln(0.1 / 0.83).
    EXPECT_NEAR(result.mechanisms[0].posterior->log_evidence() - tuned.posterior->log_evidence(),
                linear_evidence(1, 0.1) - std::log(0.1 / std::sqrt(100.01)), 0.1);
    // A parameter that the data do not touch keeps its prior.
    EXPECT_NEAR(tuned.posterior->posterior.parameters[1].standard_deviation, 1, 0.1);
}

TEST(MechanismPosterior, FitWithoutTheQuestionHasNone) {
    FitProblem problem = linear_problem();
    problem.posterior.reset();
    EXPECT_FALSE(fit(problem).mechanisms[0].posterior.has_value());
}

TEST(Comparison, ProbabilitiesAndTheirErrors) {
    constexpr double nothing = -std::numeric_limits<double>::infinity();
    const std::vector<LogEvidence> evidences = {{-1000, 0.1}, {-1000 - std::log(3.0), 0.2}, {nothing, 0}};
    const std::vector<MechanismWeight> weights = weigh(evidences);
    EXPECT_NEAR(weights[0].probability, 0.75, 1e-12);
    EXPECT_NEAR(weights[1].probability, 0.25, 1e-12);
    EXPECT_EQ(weights[2].probability, 0);
    EXPECT_NEAR(weights[1].log_bayes_factor, -std::log(3.0), 1e-12);
    // The error is p (1 - p) times that of the difference, the same for both.
    EXPECT_NEAR(weights[0].standard_error, 0.1875 * std::sqrt(0.05), 1e-12);
    EXPECT_NEAR(weights[1].standard_error, 0.1875 * std::sqrt(0.05), 1e-12);
    EXPECT_EQ(weigh(std::vector<LogEvidence>{{nothing, 0}})[0].probability, 0);
}

}  // namespace
}  // namespace delabole
