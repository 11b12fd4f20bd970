// Tests conclusions that others drew against the results of a back-analysis.
//
// A claim about mechanisms is confirmed where their probability together is on the claimed side of its limit by two
// standard errors, contradicted where the opposite is as probable as what is claimed: of at least 0.9, where it is less
// than 0.1. A claim about a quantity is asked at draws of the mechanism's posterior (at the best point where none was
// sampled): it is confirmed where it holds in 95 % of those that have an answer, contradicted where it does in no more
// than 5 %. A costly mechanism is asked at most_runs_of_claim draws, so that the words say no more than "in all of
// them" and "in none".
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "fitting/work/progress.hpp"

#include <vector>

namespace delabole {

inline constexpr std::size_t most_draws_of_claim = 1000;
inline constexpr std::size_t most_runs_of_claim = 4;

enum class ConclusionVerdict {
    confirmed,     // all that is claimed
    partly,        // some of it, while some is contradicted
    contradicted,  // all of it
    undecided,
    not_tested,  // its mechanisms were not fitted, or none has a say
};

struct TestFinding {
    ConclusionVerdict verdict = ConclusionVerdict::not_tested;  // not partly
    double value = 0;           // probability; median of the quantity, or of the difference. NaN without an answer
    double standard_error = 0;  // of a probability
    Interval interval_68 = {};  // of a quantity over the draws; from least to greatest where they are few
    int draws = 0;              // asked
    int without_answer = 0;     // of those
    int holding = 0;            // of those
};

struct ConclusionFinding {
    ConclusionVerdict verdict = ConclusionVerdict::not_tested;
    std::vector<TestFinding> tests;  // in the order of the conclusion's
};

// In the order of the problem's conclusions; not tested once a stop is requested. The result depends neither on threads
// nor on ranks.
std::vector<ConclusionFinding> judge_conclusions(const FitProblem& problem, const FitResult& result,
                                                 const FitProgressCallback& progress = {}, StopFlag stop = nullptr);

// The verdict on a conclusion whose tests came out so.
ConclusionVerdict verdict_of(const std::vector<TestFinding>& tests);

}  // namespace delabole
