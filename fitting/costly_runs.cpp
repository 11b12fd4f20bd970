#include "fitting/costly_runs.hpp"

#include "fitting/counted_random.hpp"
#include "fitting/distribution.hpp"
#include "fitting/parallel.hpp"
#include "fitting/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace delabole {

namespace {

constexpr std::size_t prior_candidates = 1024;
constexpr std::size_t near_candidates = 256;
constexpr std::size_t best_kept = 16;
constexpr double near_share = 0.15;  // of a parameter's spread
// Shapes and components are found anew when the runs have become so many times more.
constexpr double growth_before_new_shape = 1.25;

using Points = std::vector<std::vector<double>>;

// Priors as distributions; `wider` multiplies their standard deviations.
class PriorSpace {
  public:
    PriorSpace(const Misfit& misfit, double wider) : bounds_(misfit.bounds()) {
        for (const FreeParameter& parameter : misfit.mechanism().parameters) {
            marginal_.emplace_back();
            if (parameter.prior && parameter.lower < parameter.upper) {
                marginal_.back().emplace(
                    Distribution{Normal{parameter.prior->mean, wider * parameter.prior->standard_deviation},
                                 parameter.lower, parameter.upper});
            }
        }
    }

    double at(std::size_t parameter, double share) const {
        const std::optional<Marginal>& marginal = marginal_[parameter];
        return marginal ? marginal->quantile(share)
                        : std::lerp(bounds_[parameter].lower, bounds_[parameter].upper, share);
    }

    double spread(std::size_t parameter) const {
        const std::optional<Marginal>& marginal = marginal_[parameter];
        return marginal ? marginal->standard_deviation()
                        : (bounds_[parameter].upper - bounds_[parameter].lower) / std::sqrt(12.0);
    }

    Points draw(std::size_t count) const {
        Points points = sobol_points(bounds_.size(), count);
        for (std::vector<double>& point : points) {
            for (std::size_t parameter = 0; parameter < point.size(); ++parameter) {
                point[parameter] = at(parameter, point[parameter]);
            }
        }
        return points;
    }

  private:
    std::vector<Interval> bounds_;
    std::vector<std::optional<Marginal>> marginal_;
};

struct Candidate {
    std::vector<double> point;
    LikelihoodEstimate likelihood;
    double log_worth;
};

class Refinement {
  public:
    Refinement(const Misfit& misfit, std::uint64_t seed, int threads)
        : misfit_(misfit),
          space_(misfit, 1),
          random_(seed, RandomPurpose::jitter),
          threads_(threads),
          drawn_(space_.draw(prior_candidates)) {}

    // Points of the next batch, worthiest first.
    Points next(const Surrogate& surrogate, std::size_t count) {
        std::vector<Candidate> candidates = judged(surrogate, drawn_);
        remember_error(candidates);
        std::partial_sort(candidates.begin(), candidates.begin() + best_kept, candidates.end(), worthier);
        std::vector<Candidate> near = judged(surrogate, around(candidates));
        candidates.insert(candidates.end(), near.begin(), near.end());
        Points chosen;
        while (chosen.size() < count) {
            const auto best = std::min_element(candidates.begin(), candidates.end(), worthier);
            if (best->log_worth == -std::numeric_limits<double>::infinity()) {
                break;
            }
            chosen.push_back(best->point);
            for (Candidate& candidate : candidates) {
                const double alike = surrogate.correlation(candidate.point, chosen.back());
                candidate.log_worth += std::log1p(-alike * alike);
            }
        }
        return chosen;
    }

    double evidence_error() const { return evidence_error_; }

  private:
    static bool worthier(const Candidate& left, const Candidate& right) { return left.log_worth > right.log_worth; }

    std::vector<Candidate> judged(const Surrogate& surrogate, const Points& points) const {
        std::vector<Candidate> candidates(points.size());
        run_tasks(points.size(), threads_, [&](std::size_t index) {
            const LikelihoodEstimate likelihood = surrogate.likelihood(points[index]);
            candidates[index] = {points[index], likelihood,
                                 likelihood.log_deviation() - misfit_.prior(points[index]) / 2};
        });
        return candidates;
    }

    // Of the candidates drawn from the prior.
    void remember_error(const std::vector<Candidate>& candidates) {
        double greatest = -std::numeric_limits<double>::infinity();
        for (const Candidate& candidate : candidates) {
            greatest = std::max(greatest, candidate.likelihood.log_mean);
        }
        double evidence = 0;
        double deviation = 0;
        for (const Candidate& candidate : candidates) {
            evidence += std::exp(candidate.likelihood.log_mean - greatest);
            deviation += std::exp(candidate.likelihood.log_deviation() - greatest);
        }
        evidence_error_ = deviation / evidence;
    }

    Points around(const std::vector<Candidate>& candidates) {
        Points points;
        for (std::size_t index = 0; index < near_candidates; ++index) {
            std::vector<double> point = candidates[index % best_kept].point;
            for (std::size_t parameter = 0; parameter < point.size(); ++parameter) {
                const double step = normal_quantile(random_.unit(used_, static_cast<std::uint32_t>(parameter)));
                const Interval& range = misfit_.bounds()[parameter];
                point[parameter] = std::clamp(point[parameter] + near_share * space_.spread(parameter) * step,
                                              range.lower, range.upper);
            }
            ++used_;
            points.push_back(std::move(point));
        }
        return points;
    }

    const Misfit& misfit_;
    PriorSpace space_;
    CountedRandom random_;
    int threads_;
    Points drawn_;
    std::uint64_t used_ = 0;
    double evidence_error_ = std::numeric_limits<double>::infinity();
};

// Runs them all; those that were stopped are left out.
void run_at(const Points& points, const Misfit& misfit, int threads, ProgressMeter& progress, StopFlag stop,
            CostlyRuns& made) {
    std::vector<std::optional<KnownRun>> runs(points.size());
    run_tasks(points.size(), threads, [&](std::size_t index) {
        if (!stop_requested(stop)) {
            runs[index] = KnownRun{points[index], misfit.residuals(points[index])};
            progress.count(1, weight_of_run);
        }
    });
    for (std::optional<KnownRun>& run : runs) {
        if (run) {
            made.evaluations.record({0, run->residuals.failure});
            made.runs.push_back(*std::move(run));
        }
    }
    made.stopped = stop_requested(stop);
}

std::size_t valid_runs(const CostlyRuns& made) {
    return static_cast<std::size_t>(
        std::ranges::count_if(made.runs, [](const KnownRun& run) { return run.residuals.failure.empty(); }));
}

}  // namespace

CostlyRuns make_costly_runs(const Misfit& misfit, const SurrogateSettings& settings, std::uint64_t seed, int threads,
                            ProgressMeter& progress, StopFlag stop) {
    CostlyRuns made;
    const std::size_t free = misfit.free_parameters().size();
    const auto most = static_cast<std::size_t>(settings.runs);
    const std::size_t first =
        std::min(settings.first_runs ? static_cast<std::size_t>(*settings.first_runs) : 10 * free, most);
    run_at(PriorSpace(misfit, 2).draw(first), misfit, threads, progress, stop, made);
    Refinement refinement(misfit, seed, threads);
    std::size_t shaped_with = 0;
    while (valid_runs(made) >= Surrogate::least_runs(free)) {
        const bool shape_anew =
            static_cast<double>(valid_runs(made)) >= growth_before_new_shape * static_cast<double>(shaped_with);
        shaped_with = shape_anew ? valid_runs(made) : shaped_with;
        made.surrogate = std::make_unique<Surrogate>(misfit, made.runs, shape_anew ? nullptr : made.surrogate.get());
        const Points next = refinement.next(*made.surrogate, std::min(runs_at_a_time, most - made.runs.size()));
        made.evidence_error = refinement.evidence_error();
        if (made.stopped || next.empty() || made.evidence_error < settings.tolerance) {
            break;
        }
        run_at(next, misfit, threads, progress, stop, made);
    }
    return made;
}

}  // namespace delabole
