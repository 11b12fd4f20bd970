#include "fitting/work/evaluation.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

void add_cause(std::vector<std::pair<std::string, long>>& causes, std::string_view cause, long number) {
    const auto place = std::lower_bound(causes.begin(), causes.end(), cause,
                                        [](const auto& entry, std::string_view name) { return entry.first < name; });
    if (place != causes.end() && place->first == cause) {
        place->second += number;
    } else {
        causes.emplace(place, std::string(cause), number);
    }
}

}  // namespace

bool Evaluation::valid() const {
    return failure.empty() && std::isfinite(value);
}

void EvaluationCount::record(const Evaluation& evaluation) {
    ++total;
    if (evaluation.valid()) {
        return;
    }
    const std::string_view unnamed = std::isnan(evaluation.value) ? "not_a_number"
                                     : evaluation.value > 0       ? "infinite"
                                                                  : "minus_infinite";
    add_cause(failed_by_cause, evaluation.failure.empty() ? unnamed : evaluation.failure, 1);
}

void EvaluationCount::add(const EvaluationCount& other) {
    total += other.total;
    optimiser_rejections += other.optimiser_rejections;
    for (const auto& [cause, number] : other.failed_by_cause) {
        add_cause(failed_by_cause, cause, number);
    }
}

long EvaluationCount::failed() const {
    long sum = 0;
    for (const auto& [cause, number] : failed_by_cause) {
        sum += number;
    }
    return sum;
}

}  // namespace delabole
