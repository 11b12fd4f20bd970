// Mechanisms fitted through a surrogate of their runs, against the same fitted directly.
#include "fitting/mechanism/surrogate.hpp"

#include "fitting/back_analysis/back_analysis.hpp"
#include "fitting/back_analysis/check_problem.hpp"
#include "fitting/mechanism/costly_runs.hpp"
#include "fitting/probability/counted_random.hpp"
#include "fitting/probability/distribution.hpp"
#include "tests/fitting/test_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>

namespace delabole {
namespace {

using test::answer;
using test::formula_model;
using test::observe;

// A curved model of two parameters with an inequality; costly or not, it is the same. `scatter`: what chance adds to
// the first output, from the parameters' bits alone.
FitProblem curved_problem(bool costly, double scatter = 0) {
    ModelInterface model = formula_model(2, {"depth", "width"}, [scatter](std::span<const double> x) {
        const CountedRandom random(static_cast<std::uint64_t>(1e15 * (x[0] + 3 * x[1])), RandomPurpose::jitter);
        return answer({10 * std::exp(x[0]) * (1 + 0.3 * x[1]) + scatter * normal_quantile(random.unit(0)),
                       4 + 6 * x[1] - 2 * x[0]});
    });
    model.costly = costly;
    FitProblem problem =
        test::problem_of(model, {test::with_prior("x1", 0, 1, 0.5, 0.2), test::with_prior("x2", 0, 1, 0.4, 0.3)},
                         {observe("depth", 19, 0.5), observe("width", 5, 0.6, Relation::at_least)});
    problem.settings.starts = 4;
    problem.settings.profile_points = 9;
    problem.settings.map_points = 9;
    problem.settings.surrogate = {.runs = 60, .first_runs = 20, .tolerance = 0.02};
    problem.posterior = PosteriorStudy{};
    problem.posterior->draws = 2000;
    return problem;
}

const MechanismFit& only(const FitResult& result) {
    return result.mechanisms.front();
}

TEST(Surrogate, GivesTheSameFitAsTheModel) {
    const FitResult direct = fit(curved_problem(false));
    const FitResult costly = fit(curved_problem(true));
    const MechanismFit& exact = only(direct);
    const MechanismFit& near = only(costly);
    ASSERT_TRUE(near.surrogate);
    EXPECT_FALSE(exact.surrogate);
    EXPECT_LE(near.evaluations.total, 60);
    EXPECT_EQ(near.evaluations.total, static_cast<long>(near.surrogate->runs.size()));
    // The tolerance is a twentieth of the priors' standard deviations, 0.2 and 0.3.
    EXPECT_NEAR(near.best[0], exact.best[0], 0.01);
    EXPECT_NEAR(near.best[1], exact.best[1], 0.015);
    EXPECT_NEAR(near.misfit, exact.misfit, 0.05);
    EXPECT_NEAR(near.surrogate->misfit_of_run, near.data_misfit, 0.05);
    // The surrogate's own bound was to be 2 %.
    EXPECT_LT(near.surrogate->evidence_error, 0.02);
    EXPECT_NEAR(near.posterior->evidence().log_evidence, exact.posterior->evidence().log_evidence, 0.03);
    for (std::size_t index = 0; index < 2; ++index) {
        const ParameterPosterior& one = near.posterior->posterior.parameters[index];
        const ParameterPosterior& other = exact.posterior->posterior.parameters[index];
        // Means of two samples of some four hundred effective draws: a tenth of a standard deviation.
        EXPECT_NEAR(one.mean, other.mean, 0.15 * other.standard_deviation);
        EXPECT_NEAR(one.standard_deviation, other.standard_deviation, 0.15 * other.standard_deviation);
    }
}

TEST(Surrogate, ScatterOfTheRunsWidensTheAnswer) {
    const FitResult smooth = fit(curved_problem(true));
    const FitResult rough = fit(curved_problem(true, 1.5));
    ASSERT_TRUE(only(rough).surrogate);
    // The scatter is 1.5 of an output that was observed to 0.5: three standard deviations of the data. Sixty runs tell
    // it to a fifth.
    EXPECT_NEAR(only(rough).surrogate->scatter, 3, 1);
    EXPECT_LT(only(smooth).surrogate->scatter, 0.3);
    EXPECT_GT(only(rough).posterior->posterior.parameters[0].standard_deviation,
              1.2 * only(smooth).posterior->posterior.parameters[0].standard_deviation);
    EXPECT_GE(only(rough).surrogate->within_95, 0.85);
}

TEST(Surrogate, RunsDoNotDependOnTheNumberOfThreads) {
    FitProblem one = curved_problem(true);
    FitProblem three = curved_problem(true);
    three.settings.threads = 3;
    const FitResult left = fit(one);
    const FitResult right = fit(three);
    ASSERT_EQ(only(left).surrogate->runs.size(), only(right).surrogate->runs.size());
    for (std::size_t run = 0; run < only(left).surrogate->runs.size(); ++run) {
        EXPECT_EQ(only(left).surrogate->runs[run].parameters, only(right).surrogate->runs[run].parameters);
    }
    EXPECT_EQ(only(left).best, only(right).best);
    EXPECT_EQ(only(left).posterior->log_evidence(), only(right).posterior->log_evidence());
}

TEST(Surrogate, RunsWithoutAnAnswerAreCountedAndNeighboursSpeakForThem) {
    FitProblem problem = curved_problem(true);
    const auto whole = problem.mechanisms.front().model.predict;
    problem.mechanisms.front().model.predict = [whole](std::span<const Assignment> assignments) {
        Prediction prediction = whole(assignments);
        return prediction.outputs[0] > 24 ? Prediction{"broken", {}, {}} : prediction;
    };
    const FitResult result = fit(problem);
    EXPECT_GT(only(result).evaluations.failed(), 0);
    EXPECT_EQ(only(result).evaluations.failed_by_cause.front().first, "broken");
    EXPECT_NEAR(only(result).best[0], only(fit(curved_problem(false))).best[0], 0.02);

    problem.mechanisms.front().model.predict = [](std::span<const Assignment>) { return Prediction{"broken", {}, {}}; };
    const FitResult none = fit(problem);
    EXPECT_EQ(only(none).status, FitStatus::no_valid_point);
    EXPECT_FALSE(only(none).surrogate);
}

TEST(Surrogate, HopelessPointsAreLeftToTheCoarseModel) {
    FitProblem problem = curved_problem(true);
    const MechanismFit alone = only(fit(problem));
    const auto model = problem.mechanisms[0].model.predict;
    problem.mechanisms[0].coarse = problem.mechanisms[0].model;
    // The coarse model is wrong by a standard deviation of the datum.
    problem.mechanisms[0].coarse->predict = [model](std::span<const Assignment> assignments) {
        Prediction prediction = model(assignments);
        prediction.outputs[0] += 0.5;
        return prediction;
    };
    const MechanismFit sifted = only(fit(problem));
    ASSERT_TRUE(sifted.surrogate);
    const auto hopeless = std::ranges::count_if(sifted.surrogate->runs, &SurrogateFit::Run::coarse);
    // 10 exp(x1) (1 + 0.3 x2) is 19 within 4 on less than two thirds of the priors' space, doubled.
    EXPECT_GT(hopeless, 5);
    EXPECT_EQ(sifted.surrogate->coarse_runs, 20);
    EXPECT_EQ(sifted.evaluations.total, static_cast<long>(sifted.surrogate->runs.size()) - hopeless);
    for (const SurrogateFit::Run& run : sifted.surrogate->runs) {
        EXPECT_TRUE(!run.coarse || run.data_misfit > hopeless_misfit);
    }
    EXPECT_NEAR(sifted.best[0], alone.best[0], 0.01);
    EXPECT_NEAR(sifted.best[1], alone.best[1], 0.015);
    EXPECT_NEAR(sifted.posterior->evidence().log_evidence, alone.posterior->evidence().log_evidence, 0.05);
}

TEST(Surrogate, CoarseModelsHaveToFitTheirMechanism) {
    FitProblem problem = curved_problem(true);
    problem.mechanisms[0].coarse = formula_model(2, {"depth"}, [](std::span<const double>) { return answer({0}); });
    EXPECT_EQ(check_problem(problem),
              std::vector<std::string>{"mechanism: the coarse model has other inputs or outputs"});
    problem.mechanisms[0].coarse = problem.mechanisms[0].model;
    problem.mechanisms[0].model.costly = false;
    EXPECT_EQ(check_problem(problem), std::vector<std::string>{"mechanism: a coarse model is for costly ones only"});
}

TEST(Surrogate, NoFailureLocusIsTracedThroughACostlyModel) {
    for (const bool costly : {true, false}) {
        FitProblem problem = curved_problem(costly);
        problem.mechanisms[0].model.outputs[0].name = "factor_of_safety";
        problem.observations[0].quantity = "factor_of_safety";
        EXPECT_EQ(only(fit(problem)).loci.empty(), costly);
    }
}

TEST(Surrogate, FirstRunsAreAmongAllRuns) {
    FitProblem problem = curved_problem(true);
    problem.settings.surrogate.runs = 19;
    EXPECT_EQ(check_problem(problem),
              std::vector<std::string>{"settings: surrogate.first_runs = 20 must be at most surrogate.runs = 19"});
}

// Beside a cheap mechanism that has all the evidence, runs of a costly one that misses the data are few.
TEST(Surrogate, GivesUpWhereAnotherMechanismIsOutOfReach) {
    FitProblem problem = curved_problem(true);
    problem.settings.surrogate.runs = 40;
    problem.settings.surrogate.tolerance = 1e-6;
    // 10 exp(x1) (1 + 0.3 x2) is at most 35.3: missed by nine standard deviations.
    problem.observations[0].value = 40;
    const MechanismFit alone = only(fit(problem));
    EXPECT_FALSE(alone.surrogate->given_up);

    problem.mechanisms.push_back(test::mechanism("cheap", "",
                                                 formula_model(1, {"depth", "width"},
                                                               [](std::span<const double> x) {
                                                                   return answer({x[0], 5});
                                                               }),
                                                 {test::with_prior("x1", 30, 50, 40, 2)}));
    const FitResult both = fit(problem);
    EXPECT_EQ(both.mechanisms[0].name, "cheap");
    const MechanismFit& beaten = both.mechanisms[1];
    EXPECT_TRUE(beaten.surrogate->given_up);
    EXPECT_LT(beaten.surrogate->runs.size(), alone.surrogate->runs.size());

    problem.settings.surrogate.give_up_below = 0;
    EXPECT_EQ(fit(problem).mechanisms[1].surrogate->runs.size(), alone.surrogate->runs.size());
}

// The model stands or collapses: the observation lies between the two, and a smooth function crosses it.
TEST(Surrogate, AJumpDeterminesNothing) {
    ModelInterface model = formula_model(1, {"displacement"},
                                         [](std::span<const double> x) { return answer({x[0] < 0.4567 ? 1.6 : 0.0}); });
    model.costly = true;
    FitProblem problem =
        test::problem_of(model, {test::free_parameter("x1", 0, 1)}, {observe("displacement", 0.1, 0.01)});
    problem.settings.starts = 4;
    const MechanismFit found = only(fit(problem));
    ASSERT_TRUE(found.surrogate);
    EXPECT_EQ(found.identifiability.status, IdentifiabilityStatus::run_contradicts);
    EXPECT_TRUE(std::isfinite(found.surrogate->evidence_error));
    // Hardly any two runs are made at one point while others would tell more.
    std::vector<double> made;
    for (const SurrogateFit::Run& run : found.surrogate->runs) {
        made.push_back(run.parameters[0]);
    }
    std::ranges::sort(made);
    const auto repeated = std::unique(made.begin(), made.end());
    EXPECT_LT(made.end() - repeated, std::ssize(made) / 10);
    EXPECT_EQ(found.identifiability.verdict.find("Nothing is determined: the run at the best point contradicts"), 0u);
    EXPECT_FALSE(found.identifiability.covariance);
    for (const ProfileLikelihood& profile : found.profiles) {
        EXPECT_TRUE(profile.determination == Determination::doubtful ||
                    profile.determination == Determination::undetermined);
    }
    ASSERT_TRUE(found.surrogate->jump);
    EXPECT_LE(found.surrogate->jump->distance, 0.02);
    EXPECT_NEAR(found.surrogate->jump->at[0], 0.4567, 0.02);
    EXPECT_NEAR(found.surrogate->jump->difference, 160, 1e-9);
    EXPECT_FALSE(only(fit(curved_problem(true))).surrogate->jump);
}

TEST(Surrogate, InterruptedRunsLeaveWhatWasFinished) {
    FitProblem problem = curved_problem(true);
    std::atomic<bool> stop = false;
    auto runs = std::make_shared<std::atomic<int>>(0);
    const auto whole = problem.mechanisms.front().model.predict;
    problem.mechanisms.front().model.predict = [whole, runs, &stop](std::span<const Assignment> assignments) {
        if (++*runs == 5) {
            stop = true;
        }
        return whole(assignments);
    };
    const FitResult result = fit(problem, {}, &stop);
    EXPECT_EQ(only(result).status, FitStatus::interrupted);
    EXPECT_LT(*runs, 10);
}

// A costly mechanism whose data are inequalities, or that predicts none of the data.
TEST(Surrogate, NeedsNoEquality) {
    ModelInterface model = formula_model(1, {"area"}, [](std::span<const double> x) { return answer({100 * x[0]}); });
    model.costly = true;
    FitProblem problem =
        test::problem_of(model, {test::free_parameter("x1", 0, 1)}, {observe("area", 60, 1, Relation::at_least)});
    const FitResult result = fit(problem);
    EXPECT_GE(only(result).best[0], 0.59);  // a standard deviation below, which the scatter of a surrogate may take
    problem.observations = {observe("another", 60, 1)};
    EXPECT_EQ(only(fit(problem)).data_count, 0);
}

TEST(OwnTerms, MechanismComparesTheSameDatumByItsOwnQuantity) {
    FitProblem problem = test::problem_of(test::linear_safety(), {test::free_parameter("x1", 0, 1)},
                                          {{"it failed", "factor_of_safety", Relation::equal, 1, 0.05, {}, "test"}});
    problem.mechanisms.push_back(test::mechanism(
        "other", "Other", formula_model(1, {"area"}, [](std::span<const double> x) { return answer({100 * x[0]}); }),
        {test::free_parameter("x1", 0, 1)}));
    const FitResult silent = fit(problem);
    EXPECT_EQ(silent.mechanisms.back().name, "other");
    EXPECT_EQ(silent.mechanisms.back().data_count, 0);
    problem.mechanisms.back().own_observations = {{"it failed", "area", Relation::at_least, 60, 10, {}, "test"}};
    const FitResult speaking = fit(problem);
    const MechanismFit& fitted = *std::ranges::find(speaking.mechanisms, std::string("other"), &MechanismFit::name);
    EXPECT_EQ(fitted.data_count, 1);
    EXPECT_GE(fitted.best[0], 0.6 - 1e-6);  // where the inequality begins to hold, to the tolerance of the search
    EXPECT_EQ(fitted.observations.front().quantity, "area");
    EXPECT_EQ(fitted.ranking_score, 0);
}

TEST(OwnTerms, EvidenceIsExplainedWhereEverySignHolds) {
    FitProblem problem = test::problem_of(formula_model(1, {"cracks", "turn"},
                                                        [](std::span<const double> x) {
                                                            return answer({3 * x[0], -x[0]});
                                                        }),
                                          {test::with_prior("x1", 0, 1, 0.8, 0.01)}, {observe("cracks", 2.4, 0.1)});
    problem.evidence = {{"parallel_cracks", "several cracks", "test"}, {"turning", "blocks turn", "test"}};
    problem.mechanisms.front().signs = {{"parallel_cracks", "cracks", Relation::at_least, 2},
                                        {"turning", "turn", Relation::at_most, -0.5},
                                        {"turning", "cracks", Relation::at_least, 2.9}};
    const FitResult result = fit(problem);
    EXPECT_EQ(only(result).explained, std::vector<std::string>{"parallel_cracks"});
    EXPECT_EQ(only(result).unexplained.size(), 1U);
}

TEST(OwnTerms, InputsThatShareAParameterMoveTogetherAlsoUnderConditions) {
    FitProblem problem = test::problem_of(
        formula_model(2, {"sum"}, [](std::span<const double> x) { return answer({x[0] + 10 * x[1]}); }),
        {{"x1", 0, 1, std::nullopt, {"x2"}}}, {observe("sum", 5.5, 0.1), observe("sum", 2.2, 0.1)});
    problem.observations[1].conditions = {{"x1", 0.2}};
    const FitResult result = fit(problem);
    EXPECT_NEAR(only(result).best[0], 0.5, 1e-6);  // 11 x = 5.5, to the tolerance of the search
    EXPECT_NEAR(*only(result).observations[1].predicted, 2.2, 1e-12);
    EXPECT_NEAR(only(result).misfit, 0, 1e-9);
    problem.mechanisms.front().parameters.front().also = {"x3"};
    EXPECT_THROW(fit(problem), std::invalid_argument);
}

}  // namespace
}  // namespace delabole
