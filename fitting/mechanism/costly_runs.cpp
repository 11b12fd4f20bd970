#include "fitting/mechanism/costly_runs.hpp"

#include "fitting/posterior/prior_space.hpp"
#include "fitting/probability/counted_random.hpp"
#include "fitting/probability/distribution.hpp"
#include "fitting/probability/estimate.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>

namespace delabole {

namespace {

constexpr std::size_t prior_candidates = 1024;
constexpr std::size_t near_candidates = 256;
constexpr std::size_t best_kept = 16;
constexpr double near_share = 0.15;  // in standard deviations of the prior
// Shapes and components are found again whenever the number of runs has grown by this factor.
constexpr double growth_before_new_shape = 1.25;

using Points = std::vector<std::vector<double>>;

std::vector<FreeParameter> with_wider_priors(std::vector<FreeParameter> parameters) {
    for (FreeParameter& parameter : parameters) {
        if (parameter.prior) {
            parameter.prior->standard_deviation *= 2;
        }
    }
    return parameters;
}

std::vector<double> at(const PriorSpace& space, std::span<const double> standard_normal) {
    std::vector<double> point(space.parameters().size());
    space.values(standard_normal, point);
    return point;
}

Points draw(const PriorSpace& space, std::size_t count) {
    Points points;
    for (std::vector<double>& unit : sobol_points(space.size(), count)) {
        std::ranges::transform(unit, unit.begin(), normal_quantile);
        points.push_back(at(space, unit));
    }
    return points;
}

struct Candidate {
    std::vector<double> point;
    LikelihoodEstimate likelihood;
    double log_worth;
};

class Refinement {
  public:
    Refinement(const Misfit& misfit, std::uint64_t seed, const Workers& workers)
        : misfit_(misfit),
          space_(misfit.mechanism().parameters),
          random_(seed, RandomPurpose::jitter),
          workers_(workers),
          drawn_(draw(space_, prior_candidates)) {}

    // Points of the next batch, the most valuable first.
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
    // Logarithm of the evidence plus twice its error.
    double log_evidence_bound() const { return log_evidence_bound_; }

  private:
    static bool worthier(const Candidate& left, const Candidate& right) { return left.log_worth > right.log_worth; }

    std::vector<Candidate> judged(const Surrogate& surrogate, const Points& points) const {
        std::vector<Candidate> candidates(points.size());
        // This work is not shared among ranks, since exchanging the results would take longer.
        run_tasks(points.size(), workers_.threads, [&](std::size_t index) {
            const LikelihoodEstimate likelihood = surrogate.likelihood(points[index]);
            candidates[index] = {points[index], likelihood,
                                 likelihood.log_deviation() - misfit_.prior(points[index]) / 2};
        });
        return candidates;
    }

    // Stores the error of the evidence, from the candidates drawn from the prior.
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
        log_evidence_bound_ = greatest + std::log((evidence + 2 * deviation) / static_cast<double>(candidates.size()));
    }

    Points around(const std::vector<Candidate>& candidates) {
        Points points;
        for (std::size_t index = 0; index < near_candidates; ++index) {
            std::vector<double> normal = space_.coordinates(candidates[index % best_kept].point);
            for (std::size_t place = 0; place < normal.size(); ++place) {
                normal[place] += near_share * normal_quantile(random_.unit(used_, static_cast<std::uint32_t>(place)));
            }
            ++used_;
            points.push_back(at(space_, normal));
        }
        return points;
    }

    const Misfit& misfit_;
    PriorSpace space_;
    CountedRandom random_;
    Workers workers_;
    Points drawn_;
    std::uint64_t used_ = 0;
    double evidence_error_ = std::numeric_limits<double>::infinity();
    double log_evidence_bound_ = std::numeric_limits<double>::infinity();
};

// A run in the form in which ranks exchange it.
struct RunMessage {
    bool made = false;
    std::vector<double> values = {};
    std::vector<int> idle = {};
    std::vector<double> scatter = {};
    std::string failure = {};
};

DELABOLE_MEMBERS(RunMessage, made, values, idle, scatter, failure)

// Runs the model at all points; runs that were stopped are left out.
std::vector<KnownRun> runs_at(const Points& points, const Misfit& misfit, const Workers& workers,
                              ProgressMeter& progress, StopFlag stop, EvaluationCount& evaluations) {
    std::vector<Residuals> own(points.size());
    const std::vector<RunMessage> messages = share_tasks<RunMessage>(points.size(), workers, [&](std::size_t index) {
        RunMessage run;
        if (!stop_requested(stop)) {
            const Residuals& found = own[index] = misfit.residuals(points[index]);
            run = {
                true, found.values, {found.idle.begin(), found.idle.end()}, found.scatter, std::string(found.failure)};
            progress.count(1, weight_of_run);
        }
        return run;
    });
    std::vector<KnownRun> runs;
    for (std::size_t index = 0; index < messages.size(); ++index) {
        const RunMessage& run = messages[index];
        if (!run.made) {
            continue;
        }
        // The text must outlive this function: it is the model's own text or a copy that the ranks keep.
        std::string_view failure = own[index].failure;
        if (failure != run.failure) {
            failure = workers.ranks->word(run.failure);
        }
        evaluations.record({0, failure});
        runs.push_back({points[index], {run.values, {run.idle.begin(), run.idle.end()}, run.scatter, failure}});
    }
    return runs;
}

void run_at(const Points& points, const Misfit& misfit, const Workers& workers, ProgressMeter& progress, StopFlag stop,
            CostlyRuns& made) {
    std::ranges::move(runs_at(points, misfit, workers, progress, stop, made.evaluations),
                      std::back_inserter(made.runs));
    made.stopped = stop_requested(stop);
}

// Runs the coarse model at the points and enters those with a hopelessly low likelihood as coarse runs. Returns the
// other points.
Points sift(Points points, const Misfit& coarse, const Workers& workers, ProgressMeter& progress, StopFlag stop,
            CostlyRuns& made) {
    std::vector<KnownRun> runs = runs_at(points, coarse, workers, progress, stop, made.coarse_evaluations);
    double least = std::numeric_limits<double>::infinity();
    for (const KnownRun& run : runs) {
        least = run.residuals.failure.empty() ? std::min(least, data_misfit(run.residuals)) : least;
    }
    for (KnownRun& run : runs) {
        if (run.residuals.failure.empty() && data_misfit(run.residuals) > least + hopeless_misfit) {
            std::erase(points, run.parameters);
            run.coarse = true;
            made.runs.push_back(std::move(run));
        }
    }
    made.stopped = stop_requested(stop);
    return points;
}

std::size_t valid_runs(const CostlyRuns& made) {
    return static_cast<std::size_t>(
        std::ranges::count_if(made.runs, [](const KnownRun& run) { return run.residuals.failure.empty(); }));
}

// Greatest difference of a free parameter, as a share of its range.
double distance(const Misfit& misfit, std::span<const double> left, std::span<const double> right) {
    double greatest = 0;
    for (const std::size_t index : misfit.free_parameters()) {
        const Interval& range = misfit.bounds()[index];
        greatest = std::max(greatest, std::abs(left[index] - right[index]) / (range.upper - range.lower));
    }
    return greatest;
}

// Difference of residuals in standard deviations of the data; satisfied inequalities count as equal.
double difference(const Residuals& left, const Residuals& right) {
    double squares = 0;
    for (std::size_t index = 0; index < left.values.size(); ++index) {
        const double step = (left.idle[index] ? 0 : left.values[index]) - (right.idle[index] ? 0 : right.values[index]);
        squares += step * step;
    }
    return std::sqrt(squares);
}

}  // namespace

CostlyRuns make_costly_runs(const Misfit& misfit, const Misfit* coarse, const SurrogateSettings& settings,
                            std::uint64_t seed, double log_evidence_to_beat, const Workers& workers,
                            ProgressMeter& progress, StopFlag stop) {
    CostlyRuns made;
    const std::size_t free = misfit.free_parameters().size();
    const auto most = static_cast<std::size_t>(settings.runs);
    const std::size_t first =
        settings.first_runs ? static_cast<std::size_t>(*settings.first_runs) : std::min(10 * free, most);
    Points points = draw(PriorSpace(with_wider_priors(misfit.mechanism().parameters)), first);
    if (coarse != nullptr) {
        points = sift(std::move(points), *coarse, workers, progress, stop, made);
    }
    run_at(points, misfit, workers, progress, stop, made);
    Refinement refinement(misfit, seed, workers);
    std::size_t shaped_with = 0;
    while (valid_runs(made) >= Surrogate::least_runs(free)) {
        const bool shape_anew =
            static_cast<double>(valid_runs(made)) >= growth_before_new_shape * static_cast<double>(shaped_with);
        shaped_with = shape_anew ? valid_runs(made) : shaped_with;
        made.surrogate = std::make_unique<Surrogate>(misfit, made.runs, shape_anew ? nullptr : made.surrogate.get());
        const Points next = refinement.next(*made.surrogate, std::min(runs_at_a_time, most - made.runs.size()));
        made.evidence_error = refinement.evidence_error();
        made.given_up = refinement.log_evidence_bound() < log_evidence_to_beat;
        if (made.stopped || next.empty() || made.given_up || made.evidence_error < settings.tolerance) {
            break;
        }
        run_at(next, misfit, workers, progress, stop, made);
    }
    return made;
}

std::optional<Jump> steepest_jump(const CostlyRuns& costly) {
    constexpr double beside = 0.02;
    const Misfit& misfit = costly.surrogate->misfit();
    std::vector<const KnownRun*> runs;
    for (const KnownRun& run : costly.runs) {
        if (!run.coarse && run.residuals.failure.empty()) {
            runs.push_back(&run);
        }
    }
    double greatest = 0;
    std::optional<Jump> steepest;
    for (std::size_t left = 0; left < runs.size(); ++left) {
        for (std::size_t right = left + 1; right < runs.size(); ++right) {
            Jump jump{{},
                      distance(misfit, runs[left]->parameters, runs[right]->parameters),
                      difference(runs[left]->residuals, runs[right]->residuals)};
            greatest = std::max(greatest, jump.difference);
            if (jump.distance <= beside &&
                (!steepest || jump.difference * steepest->distance > steepest->difference * jump.distance)) {
                std::ranges::transform(runs[left]->parameters, runs[right]->parameters, std::back_inserter(jump.at),
                                       [](double one, double other) { return (one + other) / 2; });
                steepest = std::move(jump);
            }
        }
    }
    const double least = std::max(4 * std::max(1.0, costly.surrogate->scatter()), greatest / 2);
    return steepest && steepest->difference > least ? steepest : std::nullopt;
}

std::vector<KnownRun> judged_by(const Misfit& other, const Misfit& as_judged, std::vector<KnownRun> runs) {
    const std::vector<Datum> now = other.data();
    const std::vector<Datum> then = as_judged.data();
    for (KnownRun& run : runs) {
        for (std::size_t index = 0; index < run.residuals.values.size(); ++index) {
            const double scatter = run.residuals.scatter[index];
            double& residual = run.residuals.values[index];
            residual = now[index].cost ? cost_of_scatter(scatter, now[index].standard_deviation, now[index].share)
                                       : residual * std::hypot(then[index].standard_deviation, scatter) /
                                             std::hypot(now[index].standard_deviation, scatter);
        }
    }
    return runs;
}

}  // namespace delabole
