#include "fitting/sensitivity/propagation.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace delabole {

namespace {

constexpr std::size_t cumulative_points = 400;

struct Sums {
    long values = 0;
    double sum = 0;  // of the values less an offset
    double squares = 0;
    long decided = 0;
    long failed = 0;

    void add(const Evaluation& evaluation, double offset, const std::optional<FailureCriterion>& criterion) {
        if (evaluation.valid()) {
            ++values;
            sum += evaluation.value - offset;
            squares += (evaluation.value - offset) * (evaluation.value - offset);
        }
        if (criterion && criterion->decided(evaluation)) {
            ++decided;
            failed += criterion->failed(evaluation) ? 1 : 0;
        }
    }
    void add(const Sums& other) {
        values += other.values;
        sum += other.sum;
        squares += other.squares;
        decided += other.decided;
        failed += other.failed;
    }
    double mean() const { return sum / static_cast<double>(values); }
    double deviation() const {
        return values < 2 ? 0 : std::sqrt(std::max(squares - sum * mean(), 0.0) / static_cast<double>(values - 1));
    }
    double share_failed() const { return static_cast<double>(failed) / static_cast<double>(decided); }
};

struct ProbabilityOfSums {
    std::optional<Estimate> estimate;
    ErrorMethod method = ErrorMethod::wilson;
};

// `replicates` is empty for independent samples.
Estimate mean_estimate(const Sums& all, const std::vector<Sums>& replicates, double offset) {
    std::vector<double> means;
    for (const Sums& replicate : replicates) {
        if (replicate.values > 0) {
            means.push_back(replicate.mean());
        }
    }
    double half = 0;
    if (means.size() >= 2) {
        const Estimate spread = mean_of_replicates(means);
        half = spread.interval_95.upper - spread.value;
    } else if (all.values >= 2) {
        const auto count = static_cast<double>(all.values);
        half = gsl_cdf_tdist_Qinv(0.025, count - 1) * all.deviation() / std::sqrt(count);
    }
    const double mean = offset + all.mean();
    return {mean, {mean - half, mean + half}};
}

ProbabilityOfSums probability_estimate(const Sums& all, const std::vector<Sums>& replicates, std::size_t samples) {
    if (all.decided == 0 || static_cast<std::size_t>(all.decided) < samples - samples / 2) {
        return {};
    }
    std::vector<double> shares;
    for (const Sums& replicate : replicates) {
        if (replicate.decided > 0) {
            shares.push_back(replicate.share_failed());
        }
    }
    const double share = all.share_failed();
    const Interval wilson = wilson_interval(static_cast<double>(all.failed), static_cast<double>(all.decided));
    const bool spread_tells = shares.size() >= 2 && std::any_of(shares.begin(), shares.end(),
                                                                [&](double other) { return other != shares.front(); });
    if (!spread_tells) {
        return {Estimate{share, wilson}, ErrorMethod::wilson};
    }
    const Estimate spread = mean_of_replicates(shares);
    const double half = spread.interval_95.upper - spread.value;
    const Interval found{std::max(share - half, 0.0), std::min(share + half, 1.0)};
    // Replicates with so few failures, or with so few that stand, often agree by chance.
    constexpr double few = 5;
    const auto rarer = static_cast<double>(std::min(all.failed, all.decided - all.failed));
    if (rarer < few * static_cast<double>(shares.size()) && found.upper - found.lower < wilson.upper - wilson.lower) {
        return {Estimate{share, wilson}, ErrorMethod::wilson};
    }
    return {Estimate{share, found}, ErrorMethod::replicates};
}

class Samples {
  public:
    Samples(const SamplePlan& plan, SamplingMethod method, std::vector<Evaluation> evaluations,
            const std::optional<FailureCriterion>& criterion)
        : plan_(plan),
          independent_(method == SamplingMethod::monte_carlo),
          layered_(method == SamplingMethod::latin_hypercube),
          evaluations_(std::move(evaluations)),
          criterion_(criterion) {
        if (!independent_ && evaluations_.size() < plan.size()) {
            evaluations_.resize(evaluations_.size() / plan.points() * plan.points());
        }
        for (const Evaluation& evaluation : evaluations_) {
            if (evaluation.valid()) {
                sorted_.push_back(evaluation.value);
            }
        }
        std::sort(sorted_.begin(), sorted_.end());
        offset_ = sorted_.empty() ? 0 : sorted_[sorted_.size() / 2];
    }

    const std::vector<Evaluation>& evaluations() const { return evaluations_; }
    const std::vector<double>& sorted() const { return sorted_; }
    double offset() const { return offset_; }
    bool independent() const { return independent_; }

    // Estimates from the first `count` samples that belong together: of all samples if these are independent, of each
    // replicate for a sequence; whole replicates are counted for Latin hypercubes.
    std::pair<Sums, std::vector<Sums>> sums(std::size_t count) const {
        Sums all;
        std::vector<Sums> replicates;
        const std::size_t kept_replicates = replicates_of(count);
        const std::size_t per_replicate = layered_ ? plan_.points() : std::min(count, plan_.points());
        for (std::size_t replicate = 0; replicate < kept_replicates; ++replicate) {
            Sums sums;
            const std::size_t first = replicate * plan_.points();
            const std::size_t last = std::min(first + per_replicate, evaluations_.size());
            for (std::size_t index = first; index < last; ++index) {
                sums.add(evaluations_[index], offset_, criterion_);
            }
            all.add(sums);
            replicates.push_back(sums);
        }
        if (independent_) {
            replicates.clear();
        }
        return {all, replicates};
    }

    // Arguments of sums() at which the convergence is shown.
    std::vector<std::size_t> steps() const {
        std::vector<std::size_t> counts;
        if (layered_) {
            for (std::size_t replicate = 2; replicate <= evaluations_.size() / plan_.points(); ++replicate) {
                counts.push_back(replicate);
            }
            return counts;
        }
        const std::size_t longest = std::min(plan_.points(), evaluations_.size());
        constexpr std::size_t first = 16;
        for (std::size_t count = std::min(independent_ ? 4 * first : first, longest); count < longest; count *= 2) {
            counts.push_back(count);
        }
        counts.push_back(longest);
        return counts;
    }

    std::size_t evaluated(std::size_t count) const {
        const std::size_t per_replicate = layered_ ? plan_.points() : std::min(count, plan_.points());
        return std::min(replicates_of(count) * per_replicate, evaluations_.size());
    }

  private:
    std::size_t replicates_of(std::size_t count) const {
        const std::size_t whole = (evaluations_.size() + plan_.points() - 1) / plan_.points();
        return layered_ ? std::min(count, whole) : whole;
    }

    const SamplePlan& plan_;
    bool independent_;
    bool layered_;  // the samples of a replicate are useful only all together
    std::vector<Evaluation> evaluations_;
    const std::optional<FailureCriterion>& criterion_;
    std::vector<double> sorted_;
    double offset_ = 0;
};

std::vector<std::pair<double, double>> cumulative_curve(const std::vector<double>& sorted) {
    std::vector<std::pair<double, double>> curve;
    const std::size_t points = std::min(sorted.size(), cumulative_points);
    for (std::size_t point = 0; point < points; ++point) {
        const std::size_t index = point + 1 == points ? sorted.size() - 1 : point * sorted.size() / points;
        const auto not_above = std::upper_bound(sorted.begin(), sorted.end(), sorted[index]) - sorted.begin();
        if (curve.empty() || sorted[index] > curve.back().first) {
            curve.emplace_back(sorted[index], static_cast<double>(not_above) / static_cast<double>(sorted.size()));
        }
    }
    return curve;
}

// Bins as wide as Freedman & Diaconis (Z. Wahrscheinlichkeitstheorie 57 (1981) 453-476) advise, at most 60 of them. The
// outermost bins also hold the samples beyond the middle 99.9 %.
std::vector<HistogramBin> histogram_of(const std::vector<double>& sorted,
                                       const std::optional<FailureCriterion>& criterion) {
    constexpr double most_bins = 60;
    double lower = sorted_quantile(sorted, 0.0005);
    const double upper = sorted_quantile(sorted, 0.9995);
    if (!(lower < upper) || !std::isfinite(upper - lower)) {
        return {{sorted.front(), sorted.back(), static_cast<long>(sorted.size())}};
    }
    const double quartiles = sorted_quantile(sorted, 0.75) - sorted_quantile(sorted, 0.25);
    const double advised = 2 * quartiles / std::cbrt(static_cast<double>(sorted.size()));
    const double width = std::max(advised, (upper - lower) / most_bins);
    if (criterion && criterion->limit > lower && criterion->limit < upper) {
        lower = criterion->limit - std::ceil((criterion->limit - lower) / width) * width;
    }
    const auto bins = static_cast<std::size_t>(std::ceil((upper - lower) / width - 1e-9));
    std::vector<HistogramBin> histogram;
    auto counted = sorted.begin();
    const auto edge = [&](std::size_t number) {
        const double value = lower + static_cast<double>(number) * width;
        // The limit replaces its rounded value, because a sample exactly at the limit belongs above it.
        return criterion && std::abs(value - criterion->limit) < 1e-6 * width ? criterion->limit : value;
    };
    for (std::size_t bin = 0; bin < bins; ++bin) {
        const auto end = bin + 1 == bins ? sorted.end() : std::lower_bound(counted, sorted.end(), edge(bin + 1));
        histogram.push_back({edge(bin), edge(bin + 1), static_cast<long>(end - counted)});
        counted = end;
    }
    return histogram;
}

bool is_among(const std::vector<std::string>& words, std::string_view word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

FailureProbability failure_probability(const Sums& all, const std::vector<Sums>& replicates, long samples) {
    FailureProbability failure;
    const ProbabilityOfSums found = probability_estimate(all, replicates, static_cast<std::size_t>(samples));
    failure.probability = found.estimate;
    failure.method = found.method;
    failure.failed = all.failed;
    failure.decided = all.decided;
    failure.samples = samples;
    const auto count = static_cast<double>(samples);
    failure.least = static_cast<double>(all.failed) / count;
    failure.greatest = static_cast<double>(all.failed + samples - all.decided) / count;
    return failure;
}

// An infinite factor of safety is a value, too: nothing drives the slope.
bool gives_a_value(const Evaluation& evaluation) {
    return evaluation.failure.empty() && !std::isnan(evaluation.value);
}

}  // namespace

bool FailureCriterion::failed(const Evaluation& evaluation) const {
    return gives_a_value(evaluation) ? failed(evaluation.value) : is_among(failing_words, evaluation.failure);
}

std::optional<bool> FailureCriterion::failed(const Interval& values) const {
    const bool below = side == FailureSide::below;
    const bool all_below = values.upper < limit || (values.upper == limit && values.upper_open);
    const bool all_above = values.lower > limit || (values.lower == limit && values.lower_open);
    // A slope exactly at the limit stands.
    const bool none_below = values.lower >= limit;
    const bool none_above = values.upper <= limit;
    if (below ? all_below : all_above) {
        return true;
    }
    return (below ? none_below : none_above) ? std::optional(false) : std::nullopt;
}

bool FailureCriterion::decided(const Evaluation& evaluation) const {
    return gives_a_value(evaluation) || is_among(failing_words, evaluation.failure) ||
           is_among(standing_words, evaluation.failure);
}

PlanSize plan_size(const PropagationSettings& settings) {
    const auto samples = static_cast<std::size_t>(std::max(settings.samples, 1L));
    if (settings.method == SamplingMethod::monte_carlo) {
        return {samples, 1};
    }
    const auto replicates = static_cast<std::size_t>(std::max(settings.replicates, 2));
    const std::size_t share = (samples + replicates - 1) / replicates;
    return {settings.method == SamplingMethod::sobol_sequence ? std::bit_ceil(share) : share, replicates};
}

SamplePlan plan_of(const PropagationSettings& settings, std::size_t dimension, std::uint64_t seed) {
    const PlanSize size = plan_size(settings);
    return {settings.method, dimension, size.points, size.replicates, seed};
}

PropagationResult propagate(const Evaluator& evaluator, const InputSpace& space, const PropagationSettings& settings,
                            const std::optional<FailureCriterion>& criterion, std::uint64_t seed) {
    const SamplePlan plan = plan_of(settings, space.size(), seed);
    const auto point = [&](std::size_t index, std::span<double> parameters) {
        std::array<double, most_parameters> coordinates{};
        const std::span<double> unit = std::span(coordinates).first(space.size());
        plan.point(index, unit);
        space.values_of_unit(unit, parameters);
    };
    const Samples samples(plan, settings.method, evaluator.evaluate(space.size(), plan.size(), point), criterion);

    PropagationResult result;
    result.samples = static_cast<long>(samples.evaluations().size());
    for (const Evaluation& evaluation : samples.evaluations()) {
        result.evaluations.record(evaluation);
    }
    const bool interrupted = samples.evaluations().size() < plan.size();
    const std::vector<double>& sorted = samples.sorted();
    result.with_value = static_cast<long>(sorted.size());
    const auto [all, replicates] =
        samples.sums(settings.method == SamplingMethod::latin_hypercube ? plan.replicates() : plan.points());
    result.status = interrupted                          ? PropagationStatus::interrupted
                    : sorted.empty() && all.decided == 0 ? PropagationStatus::no_answer
                                                         : PropagationStatus::finished;
    if (criterion && result.samples > 0) {
        result.failure = failure_probability(all, replicates, result.samples);
    }
    if (sorted.empty()) {
        return result;
    }
    result.mean = mean_estimate(all, replicates, samples.offset());
    result.standard_deviation = all.deviation();
    result.least = sorted.front();
    result.greatest = sorted.back();
    for (const double share : shown_shares) {
        result.quantiles.emplace_back(share, sorted_quantile(sorted, share));
    }
    result.cumulative = cumulative_curve(sorted);
    result.histogram = histogram_of(sorted, criterion);
    for (const std::size_t count : samples.steps()) {
        const auto [part, parts] = samples.sums(count);
        if (part.values < 2) {
            continue;
        }
        ConvergenceStep step{static_cast<long>(samples.evaluated(count)), mean_estimate(part, parts, samples.offset()),
                             std::nullopt};
        if (criterion) {
            step.probability = probability_estimate(part, parts, samples.evaluated(count)).estimate;
        }
        result.convergence.push_back(step);
    }
    return result;
}

}  // namespace delabole
