// The distribution of a quantity and the probability of failure that follow from uncertain parameters, and how far both
// have converged.
#pragma once

#include "fitting/probability/dependence.hpp"
#include "fitting/probability/estimate.hpp"
#include "fitting/probability/sampling.hpp"
#include "fitting/search/evaluate_points.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace delabole {

enum class FailureSide { below, above };

// When a sample counts as failed, for example a factor of safety below 1 or a displacement above a limit.
struct FailureCriterion {
    double limit;
    FailureSide side = FailureSide::below;
    // Words with which a model gives no value but still decides, such as "fails_at_any_strength" and
    // "holds_at_any_strength". After any other word the sample has no answer.
    std::vector<std::string> failing_words = {};
    std::vector<std::string> standing_words = {};

    static constexpr auto fields() {
        return FieldTable{
            number<&FailureCriterion::limit>(Dimension::named, "value of the quantity at which the slope fails"),
            with_default(section<&FailureCriterion::side>("where the slope has failed")),
            section<&FailureCriterion::failing_words>("words of the model that mean failure"),
            section<&FailureCriterion::standing_words>("words of the model that mean that the slope stands"),
        };
    }

    bool failed(double value) const { return side == FailureSide::below ? value < limit : value > limit; }
    bool failed(const Evaluation& evaluation) const;
    // True if all values in the interval mean failure, false if none does; no value if the interval holds both kinds.
    std::optional<bool> failed(const Interval& values) const;
    // Whether a value or a word tells that the sample has failed or stands.
    bool decided(const Evaluation& evaluation) const;
};

// Greatest number of samples, limited by the memory of a result.
inline constexpr long most_samples = 10'000'000;

struct PropagationSettings {
    SamplingMethod method = SamplingMethod::latin_hypercube;
    long samples = 16'384;
    int replicates = 16;  // not used by Monte Carlo
    static constexpr auto fields() {
        using S = PropagationSettings;
        return FieldTable{
            with_default(section<&S::method>("how samples are drawn")),
            with_default(number<&S::samples>(
                within(2, most_samples),
                "raised to the next number that the replicates share evenly, by powers of 2 for a sequence")),
            with_default(number<&S::replicates>(within(2, 1000), "independent samples whose spread gives the error")),
        };
    }
};

// Number of points of each replicate, and number of replicates.
struct PlanSize {
    std::size_t points;
    std::size_t replicates;

    std::size_t total() const { return points * replicates; }
};
PlanSize plan_size(const PropagationSettings& settings);
SamplePlan plan_of(const PropagationSettings& settings, std::size_t dimension, std::uint64_t seed);

enum class ErrorMethod {
    replicates,  // spread between independent samples, by Student's t
    wilson,      // counts of independent samples; samples of replicates that agree by chance are taken for independent
};

struct FailureProbability {
    // Share of the decided samples that failed; unset if fewer than half are decided, since these may not represent the
    // whole.
    std::optional<Estimate> probability;
    ErrorMethod method = ErrorMethod::wilson;
    long failed = 0;
    long decided = 0;
    long samples = 0;
    // The probability if all undecided samples stood, and if all of them failed.
    double least = 0;
    double greatest = 1;
};

struct HistogramBin {
    double lower;
    double upper;
    long samples;
};

// Estimates from the first samples of every replicate (from the first replicates of Latin hypercubes).
struct ConvergenceStep {
    long samples;
    Estimate mean;
    std::optional<Estimate> probability;  // of failure, as in FailureProbability
};

enum class PropagationStatus {
    finished,
    no_answer,    // no sample has a value or is decided
    interrupted,  // the result holds what was finished
};

inline constexpr std::array<double, 9> shown_shares{0.01, 0.025, 0.05, 0.25, 0.5, 0.75, 0.95, 0.975, 0.99};

struct PropagationResult {
    PropagationStatus status = PropagationStatus::no_answer;
    long samples = 0;  // evaluated
    // The following members describe the samples with a value and are meaningful if there is one.
    long with_value = 0;
    Estimate mean;
    double standard_deviation = 0;
    double least = 0;
    double greatest = 0;
    std::vector<std::pair<double, double>> quantiles;   // share of shown_shares, value
    std::vector<std::pair<double, double>> cumulative;  // value, share of samples not above it; both ascending
    std::vector<HistogramBin> histogram;                // the limit of failure is an edge if it lies inside
    std::optional<FailureProbability> failure;          // if there is a criterion
    std::vector<ConvergenceStep> convergence;
    EvaluationCount evaluations;
};

// After an early stop the result describes what was finished: the first samples of Monte Carlo, otherwise whole
// replicates.
PropagationResult propagate(const Evaluator& evaluator, const InputSpace& space, const PropagationSettings& settings,
                            const std::optional<FailureCriterion>& criterion, std::uint64_t seed);

}  // namespace delabole
