// Tests conclusions that others have drawn from a failure against the results of a back-analysis.
//
// A claim about mechanisms is confirmed if the sum of their probabilities is on the claimed side of its limit by two
// standard errors. It is contradicted if the opposite is as probable as the claim: a claim of at least 0.9 if the
// probability is less than 0.1. A claim about a quantity is evaluated at draws of the mechanism's posterior (at the
// best point if none was sampled): it is confirmed if it holds in 95 % of those that have an answer, and contradicted
// if it holds in no more than 5 %. For a costly mechanism only SurrogateSettings::runs_of_claim draws are evaluated; of
// fewer than 20 the two verdicts mean no more than "in all of them" and "in none". What a mechanism does says nothing
// of the failure if the evidence is against that mechanism: where it is less probable than least_probability, by two
// standard errors, the verdict is undecided whatever it does.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "fitting/work/progress.hpp"

#include <optional>
#include <string>
#include <vector>

namespace delabole {

inline constexpr std::size_t most_draws_of_claim = 1000;
inline constexpr double least_probability = 1e-3;

enum class ConclusionVerdict {
    confirmed,     // every claim holds
    partly,        // some claims are confirmed and some contradicted
    contradicted,  // every claim is contradicted
    undecided,
    not_tested,  // its mechanisms were not fitted, or there is no test
};

// The parameter whose values differ most between draws at which a claim holds and draws at which it does not: better
// known, it would decide the claim rather than any other.
struct Decider {
    std::string parameter;
    Dimension dimension;
    double where_it_holds;  // medians, SI
    double where_it_fails;
};

struct TestFinding {
    ConclusionVerdict verdict = ConclusionVerdict::not_tested;  // never partly
    double value = 0;           // probability; median of the quantity or of the difference; NaN without an answer
    double standard_error = 0;  // of a probability
    Interval interval_68 = {};  // of a quantity over the draws; from least to greatest if there are few draws
    int draws = 0;              // evaluated
    int without_answer = 0;     // among the draws
    int holding = 0;            // among the draws
    std::optional<double> improbable = {};  // probability of the mechanism asked, if below least_probability
    std::optional<Decider> decider = {};    // of an undecided claim about a quantity; absent if chance would do as much
};

struct ConclusionFinding {
    ConclusionVerdict verdict = ConclusionVerdict::not_tested;
    std::vector<TestFinding> tests;  // in the order of the conclusion's tests
};

// The findings are in the order of the problem's conclusions; they are not_tested from a stop request on. The result
// depends neither on threads nor on ranks.
std::vector<ConclusionFinding> judge_conclusions(const FitProblem& problem, const FitResult& result,
                                                 const FitProgressCallback& progress = {}, StopFlag stop = nullptr);

// The verdict on a conclusion that follows from those on its tests.
ConclusionVerdict verdict_of(const std::vector<TestFinding>& tests);

}  // namespace delabole
