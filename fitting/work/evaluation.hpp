// One evaluation of an objective, and counts of many.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace delabole {

struct Evaluation {
    double value = 0;
    // Why there is no value; empty when there is one. The text must outlive the evaluation (a literal, or a string
    // owned by the objective).
    std::string_view failure;

    // A value that is not finite is never valid, even if the objective reports no failure.
    bool valid() const;
};

struct EvaluationCount {
    long total = 0;
    long optimiser_rejections = 0;  // failed evaluations that an algorithm received as a finite penalty
    std::vector<std::pair<std::string, long>> failed_by_cause;  // sorted by cause

    // Counts one evaluation, under the cause "not_a_number", "infinite" or "minus_infinite" if it failed without saying
    // why.
    void record(const Evaluation& evaluation);
    void add(const EvaluationCount& other);
    long failed() const;
};

}  // namespace delabole
