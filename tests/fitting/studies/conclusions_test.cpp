#include "fitting/studies/conclusions.hpp"
#include "fitting/back_analysis/back_analysis.hpp"
#include "tests/fitting/test_models.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

namespace delabole {
namespace {

using test::answer;
using test::formula_model;
using test::observe;
using test::with_prior;
using Verdict = ConclusionVerdict;

ConclusionTest probability_of(std::vector<std::string> mechanisms, Relation relation, double limit) {
    return {"", ClaimOfMechanisms{std::move(mechanisms)}, relation, limit, Dimension::ratio};
}

ConclusionTest claim_of(ClaimOfQuantity quantity, Relation relation, double limit) {
    return {"", std::move(quantity), relation, limit, Dimension::ratio};
}

// y = x1 + x2 and z = x1 under a standard normal prior of x1; x2 is 0 unless a condition says otherwise. y is observed
// so loosely that the posterior is the prior. The second mechanism is less likely.
FitProblem two_mechanisms(double less_likely = 100) {
    const ModelInterface model = formula_model(2, {"y", "z"}, [](std::span<const double> x) {
        return answer({x[0] + x[1], x[0]});
    });
    FitProblem problem =
        test::problem_of(model, {with_prior("x1", -6, 6, 0, 1)}, {observe("y", 0, 1e6), observe("w", 0, 1)});
    problem.mechanisms[0].name = "likely";
    problem.mechanisms.push_back(problem.mechanisms[0]);
    problem.mechanisms[1].name = "unlikely";
    problem.mechanisms[0].model = formula_model(2, {"y", "z", "w"}, [](std::span<const double> x) {
        return answer({x[0] + x[1], x[0], 0});
    });
    problem.mechanisms[1].model = formula_model(2, {"y", "z", "w"}, [less_likely](std::span<const double> x) {
        return answer({x[0] + x[1], x[0], std::sqrt(2 * std::log(less_likely))});
    });
    problem.settings.starts = 2;
    problem.posterior.emplace();
    return problem;
}

std::vector<TestFinding> findings_of(FitProblem problem, std::vector<ConclusionTest> tests) {
    problem.conclusions.push_back({"(i)", "", std::move(tests), "", ""});
    return judge_conclusions(problem, fit(problem)).front().tests;
}

TEST(Conclusions, ProbabilitiesOfMechanisms) {
    const auto findings = findings_of(
        two_mechanisms(),
        {probability_of({"likely"}, Relation::at_least, 0.9), probability_of({"unlikely"}, Relation::at_least, 0.9),
         probability_of({"unlikely"}, Relation::at_most, 0.05),
         probability_of({"likely", "unlikely"}, Relation::at_least, 1 - 1e-9),
         probability_of({"left_out"}, Relation::at_least, 0.5),
         probability_of({"left_out", "likely"}, Relation::at_least, 0.5),
         probability_of({"likely"}, Relation::at_least, 0.999), probability_of({"unlikely"}, Relation::at_most, 0.001),
         probability_of({"likely"}, Relation::at_most, 0.05)});
    // Evidences are estimated to about a percent, so the probability of the unlikely one is too.
    EXPECT_NEAR(findings[0].value, 100.0 / 101, 5e-4);
    EXPECT_EQ(findings[0].verdict, Verdict::confirmed);
    EXPECT_EQ(findings[1].verdict, Verdict::contradicted);
    EXPECT_EQ(findings[2].verdict, Verdict::confirmed);
    // The limit is within the error of the value, on whichever side.
    EXPECT_NE(findings[3].verdict, Verdict::contradicted);
    EXPECT_EQ(findings[4].verdict, Verdict::not_tested);
    EXPECT_TRUE(std::isnan(findings[4].value));
    EXPECT_EQ(findings[5].verdict, Verdict::confirmed);
    // That a mechanism is less probable than claimed does not make the opposite probable.
    EXPECT_EQ(findings[6].verdict, Verdict::undecided);
    EXPECT_EQ(findings[7].verdict, Verdict::undecided);
    EXPECT_EQ(findings[8].verdict, Verdict::contradicted);
}

TEST(Conclusions, AProbabilityAtItsLimitIsUndecided) {
    FitProblem problem = two_mechanisms();
    const auto value = findings_of(problem, {probability_of({"unlikely"}, Relation::at_least, 0.5)})[0];
    ASSERT_GT(value.standard_error, 0);
    const auto at = [&](double errors) {
        return findings_of(problem, {probability_of({"unlikely"}, Relation::at_least,
                                                    value.value + errors * value.standard_error)})[0]
            .verdict;
    };
    EXPECT_EQ(at(-3), Verdict::confirmed);
    EXPECT_EQ(at(0), Verdict::undecided);
    EXPECT_EQ(at(3), Verdict::contradicted);
}

TEST(Conclusions, WhatAMechanismDoesThatIsOutDecidesNothing) {
    for (const double less_likely : {100.0, 10'000.0}) {
        const FitProblem problem = two_mechanisms(less_likely);
        for (const char* mechanism : {"likely", "unlikely"}) {
            const TestFinding finding =
                findings_of(problem, {claim_of(ClaimOfQuantity{mechanism, "z", {}, {}}, Relation::at_least, -3)})[0];
            const bool out = mechanism == std::string("unlikely") && less_likely > 100;
            EXPECT_EQ(finding.verdict, out ? Verdict::undecided : Verdict::confirmed) << mechanism << less_likely;
            EXPECT_EQ(finding.improbable.has_value(), out) << mechanism << less_likely;
            // The draws are counted all the same: a standard normal number is over -3 in 99.9 % of them.
            EXPECT_GT(finding.holding, finding.draws * 0.95) << mechanism << less_likely;
        }
    }
}

TEST(Conclusions, QuantitiesAreAskedAtDrawsOfThePosterior) {
    const auto claim = [](double limit) {
        return claim_of(ClaimOfQuantity{"likely", "z", {}, {}}, Relation::at_least, limit);
    };
    const auto findings = findings_of(two_mechanisms(), {claim(-3), claim(0), claim(3)});
    // A standard normal number is over -3 in 99.9 % of draws, over 3 in 0.1 %.
    EXPECT_EQ(findings[0].verdict, Verdict::confirmed);
    EXPECT_EQ(findings[1].verdict, Verdict::undecided);
    EXPECT_EQ(findings[2].verdict, Verdict::contradicted);
    EXPECT_EQ(findings[1].draws, static_cast<int>(most_draws_of_claim));
    // At least 400 independent draws: the share errs by 0.025, the median by 0.06, the ends of the 68 % by 0.08.
    EXPECT_NEAR(static_cast<double>(findings[1].holding) / findings[1].draws, 0.5, 0.1);
    EXPECT_NEAR(findings[1].value, 0, 0.25);
    EXPECT_NEAR(findings[1].interval_68.lower, -1, 0.3);
    EXPECT_NEAR(findings[1].interval_68.upper, 1, 0.3);
}

TEST(Conclusions, TheParameterThatWouldDecideIsNamed) {
    FitProblem problem = two_mechanisms();
    problem.mechanisms[0].model = formula_model(2, {"y", "z"}, [](std::span<const double> x) {
        return answer({std::abs(x[0]), x[0]});
    });
    const auto claim = [](const char* quantity, double limit) {
        return claim_of(ClaimOfQuantity{"likely", quantity, {}, {}}, Relation::at_least, limit);
    };
    const auto findings = findings_of(problem, {claim("z", 0), claim("y", 0.674), claim("z", -3)});
    ASSERT_TRUE(findings[0].decider);
    EXPECT_EQ(findings[0].decider->parameter, "x1");
    // Medians of the halves of a standard normal number are 0.674, with a standard error of 0.04 from 500 draws.
    EXPECT_NEAR(findings[0].decider->where_it_holds, 0.674, 0.15);
    EXPECT_NEAR(findings[0].decider->where_it_fails, -0.674, 0.15);
    EXPECT_EQ(findings[1].verdict, Verdict::undecided);
    EXPECT_FALSE(findings[1].decider);  // it holds where x1 is great or small: neither is more of it
    EXPECT_EQ(findings[2].verdict, Verdict::confirmed);
    EXPECT_FALSE(findings[2].decider);
}

TEST(Conclusions, ADifferenceIsTakenAtTheSameDraw) {
    const std::vector<Condition> raised = {{"x2", 2}};
    const std::vector<Condition> known = {{"x1", 1}};
    const auto findings = findings_of(
        two_mechanisms(),
        {claim_of(ClaimOfQuantity{"likely", "y", raised, std::vector<Condition>{}}, Relation::at_least, 1.999),
         claim_of(ClaimOfQuantity{"likely", "y", {}, raised}, Relation::at_least, -1.999),
         claim_of(ClaimOfQuantity{"likely", "y", known, {}}, Relation::at_most, 1)});
    // The tolerance is two roundings of numbers up to 6.
    EXPECT_NEAR(findings[0].value, 2, 1e-14);
    EXPECT_NEAR(findings[0].interval_68.upper - findings[0].interval_68.lower, 0, 1e-14);
    EXPECT_EQ(findings[0].verdict, Verdict::confirmed);
    EXPECT_EQ(findings[1].verdict, Verdict::contradicted);
    EXPECT_EQ(findings[2].value, 1);
    EXPECT_EQ(findings[2].verdict, Verdict::confirmed);
}

// y is about 1: 2e-15 more is some of its last bits, 1e-12 more is not.
TEST(Conclusions, ADifferenceOfRoundingsIsNone) {
    FitProblem problem = two_mechanisms();
    problem.mechanisms[0].model = formula_model(2, {"y", "z"}, [](std::span<const double> x) {
        return answer({1 + x[0] / 10 + x[1], x[0]});
    });
    const std::vector<Condition> nearly_none = {{"x2", 2e-15}};
    const std::vector<Condition> small = {{"x2", 1e-12}};
    const auto findings = findings_of(
        problem, {claim_of(ClaimOfQuantity{"likely", "y", nearly_none, std::vector<Condition>{}}, Relation::at_most, 0),
                  claim_of(ClaimOfQuantity{"likely", "y", small, std::vector<Condition>{}}, Relation::at_most, 0)});
    EXPECT_EQ(findings[0].interval_68.upper, 0);
    EXPECT_EQ(findings[0].verdict, Verdict::confirmed);
    EXPECT_EQ(findings[1].verdict, Verdict::contradicted);
}

TEST(Conclusions, DrawsWithoutAnAnswerAreCounted) {
    FitProblem problem = two_mechanisms();
    const auto model = problem.mechanisms[0].model.predict;
    problem.mechanisms[0].model.predict = [model](std::span<const Assignment> assignments) {
        const Prediction prediction = model(assignments);
        return prediction.outputs[0] > 100 ? Prediction{"too_much", {}, {}} : prediction;
    };
    const auto findings =
        findings_of(problem, {claim_of(ClaimOfQuantity{"likely", "y", {{"x2", 100}}, {}}, Relation::at_least, 0),
                              claim_of(ClaimOfQuantity{"likely", "y", {{"x2", 1000}}, {}}, Relation::at_least, 0)});
    EXPECT_NEAR(static_cast<double>(findings[0].without_answer) / findings[0].draws, 0.5, 0.1);
    EXPECT_EQ(findings[0].holding + findings[0].without_answer, findings[0].draws);
    EXPECT_EQ(findings[0].verdict, Verdict::confirmed);
    EXPECT_EQ(findings[1].without_answer, findings[1].draws);
    EXPECT_TRUE(std::isnan(findings[1].value));
    EXPECT_EQ(findings[1].verdict, Verdict::undecided);
}

TEST(Conclusions, WithoutAPosteriorTheBestPointIsAsked) {
    FitProblem problem = two_mechanisms();
    problem.posterior.reset();
    const auto findings =
        findings_of(problem, {probability_of({"likely"}, Relation::at_least, 0.5),
                              claim_of(ClaimOfQuantity{"likely", "z", {}, {}}, Relation::at_most, 0.5),
                              claim_of(ClaimOfQuantity{"left_out", "z", {}, {}}, Relation::at_most, 0.5)});
    EXPECT_EQ(findings[0].verdict, Verdict::not_tested);
    EXPECT_EQ(findings[1].draws, 1);
    EXPECT_EQ(findings[1].verdict, Verdict::confirmed);
    EXPECT_EQ(findings[2].verdict, Verdict::not_tested);
}

TEST(Conclusions, AStopLeavesThemUntested) {
    FitProblem problem = two_mechanisms();
    problem.posterior.reset();
    const FitResult result = fit(problem);
    problem.conclusions.push_back(
        {"(i)", "", {claim_of(ClaimOfQuantity{"likely", "z", {}, {}}, Relation::at_most, 0.5)}, "", ""});
    const std::atomic<bool> stop = true;
    EXPECT_EQ(judge_conclusions(problem, result, {}, &stop)[0].verdict, Verdict::not_tested);
}

TEST(Conclusions, AreTheSumOfTheirTests) {
    const auto of = [](std::vector<Verdict> verdicts) {
        std::vector<TestFinding> tests(verdicts.size());
        for (std::size_t index = 0; index < tests.size(); ++index) {
            tests[index].verdict = verdicts[index];
        }
        return verdict_of(tests);
    };
    constexpr Verdict yes = Verdict::confirmed;
    constexpr Verdict no = Verdict::contradicted;
    EXPECT_EQ(of({}), Verdict::not_tested);
    EXPECT_EQ(of({Verdict::not_tested, Verdict::not_tested}), Verdict::not_tested);
    EXPECT_EQ(of({yes, yes}), yes);
    EXPECT_EQ(of({no, no}), no);
    EXPECT_EQ(of({yes, no, Verdict::undecided}), Verdict::partly);
    EXPECT_EQ(of({yes, Verdict::undecided}), Verdict::undecided);
    EXPECT_EQ(of({yes, Verdict::not_tested}), Verdict::undecided);
    EXPECT_EQ(of({no, Verdict::not_tested}), Verdict::undecided);
}

}  // namespace
}  // namespace delabole
