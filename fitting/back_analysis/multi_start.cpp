#include "fitting/back_analysis/steps.hpp"

#include "fitting/probability/estimate.hpp"
#include "fitting/work/parallel.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

constexpr double cluster_distance = 1e-3;
constexpr double cluster_misfit = 0.01;
constexpr double exploring_tolerance = 1e-4;        // of the range; polishing reaches the full tolerance
constexpr double exploring_value_tolerance = 1e-4;  // of chi-square, far below any level of interest
constexpr double polishing_step = 0.02;             // of the range: starts close to a minimum

const FitSettings& settings_of(const Search& search) {
    return search.misfit.problem().settings;
}

// Returns the better point with the evaluations of both; the status is that of the later run.
MinimiseResult combine(const MinimiseResult& earlier, MinimiseResult later) {
    later.evaluations.add(earlier.evaluations);
    if (earlier.found() && !(later.value < earlier.value)) {
        later.value = earlier.value;
        later.point = earlier.point;
        if (later.status == MinimiseStatus::no_valid_point) {
            later.status = earlier.status;
        }
    }
    return later;
}

MinimiseResult explore(const Search& search, Priors priors, std::span<const double> start, long evaluations) {
    const FitSettings& fit = settings_of(search);
    MinimiseSettings settings;
    settings.algorithm = fit.algorithm;
    settings.evaluations = evaluations;
    settings.relative_tolerance = std::max(fit.relative_tolerance, exploring_tolerance);
    settings.value_tolerance = is_global(fit.algorithm) ? 0 : exploring_value_tolerance;
    settings.seed = fit.seed;
    return minimise(search.objective(priors), search.misfit.bounds(), start, settings, search.stop);
}

MinimiseResult explore_and_polish(const Search& search, Priors priors, std::span<const double> start,
                                  long evaluations) {
    const long for_polish = evaluations / 4;
    MinimiseResult explored = explore(search, priors, start, evaluations - for_polish);
    if (!explored.found()) {
        return explored;
    }
    return combine(explored, polish(search, priors, explored.point, for_polish));
}

std::vector<std::vector<double>> starting_points(const Misfit& misfit, std::size_t count) {
    const std::vector<Interval>& bounds = misfit.bounds();
    std::vector<std::vector<double>> points = {misfit.centre()};
    // The Sobol sequence begins with the middle of the box, which without priors is the centre already used.
    const std::size_t skipped = misfit.has_priors() ? 0 : 1;
    const std::vector<std::vector<double>> unit = sobol_points(bounds.size(), count);
    for (std::size_t number = skipped; points.size() < count && number < unit.size(); ++number) {
        std::vector<double>& point = points.emplace_back();
        for (std::size_t index = 0; index < bounds.size(); ++index) {
            point.push_back(std::lerp(bounds[index].lower, bounds[index].upper, unit[number][index]));
        }
    }
    return points;
}

bool near(std::span<const double> left, std::span<const double> right, std::span<const Interval> bounds) {
    for (std::size_t index = 0; index < bounds.size(); ++index) {
        const double range = bounds[index].upper - bounds[index].lower;
        if (std::abs(left[index] - right[index]) > cluster_distance * range) {
            return false;
        }
    }
    return true;
}

// -1 if no run found a valid point. The first of equals is taken, so that the answer does not depend on the order of
// threads.
std::ptrdiff_t best_of(const std::vector<MinimiseResult>& runs) {
    std::ptrdiff_t best = -1;
    for (std::size_t number = 0; number < runs.size(); ++number) {
        if (runs[number].found() && (best < 0 || runs[number].value < runs[static_cast<std::size_t>(best)].value)) {
            best = static_cast<std::ptrdiff_t>(number);
        }
    }
    return best;
}

}  // namespace

MinimiseResult polish(const Search& search, Priors priors, std::span<const double> start, long evaluations) {
    const FitSettings& fit = settings_of(search);
    MinimiseSettings settings;
    settings.algorithm = fit.algorithm == Algorithm::bobyqa ? Algorithm::sbplx : Algorithm::bobyqa;
    settings.evaluations = evaluations;
    settings.relative_tolerance = fit.relative_tolerance;
    settings.initial_step = polishing_step;
    const Objective objective = search.objective(priors);
    MinimiseResult result = minimise(objective, search.misfit.bounds(), start, settings, search.stop);
    const bool doubtful = result.evaluations.failed() > 0 || result.status == MinimiseStatus::algorithm_failure;
    const long left = evaluations - result.evaluations.total;
    if (settings.algorithm == Algorithm::bobyqa && result.found() && doubtful && left > 0) {
        settings.algorithm = Algorithm::sbplx;
        settings.evaluations = left;
        const MinimiseResult second = minimise(objective, search.misfit.bounds(), result.point, settings, search.stop);
        result = combine(result, second);
    }
    return result;
}

MinimiseResult polish_best_of(const Search& search, Priors priors, const std::vector<std::vector<double>>& starts) {
    const FitSettings& settings = settings_of(search);
    const auto runs = share_tasks<MinimiseResult>(starts.size(), search.workers(), [&](std::size_t number) {
        return polish(search, priors, starts[number], settings.evaluations_per_start);
    });
    EvaluationCount evaluations;
    for (const MinimiseResult& run : runs) {
        evaluations.add(run.evaluations);
    }
    const std::ptrdiff_t best = best_of(runs);
    MinimiseResult result = best < 0 ? MinimiseResult{} : runs[static_cast<std::size_t>(best)];
    result.evaluations = evaluations;
    return result;
}

void add_minimum(std::vector<MinimumCluster>& minima, std::span<const double> point, double misfit,
                 std::span<const Interval> bounds) {
    for (MinimumCluster& cluster : minima) {
        if (std::abs(cluster.misfit - misfit) <= cluster_misfit && near(cluster.parameters, point, bounds)) {
            ++cluster.hits;
            if (misfit < cluster.misfit) {
                cluster.misfit = misfit;
                cluster.parameters.assign(point.begin(), point.end());
            }
            return;
        }
    }
    const auto place = std::find_if(minima.begin(), minima.end(),
                                    [misfit](const MinimumCluster& cluster) { return cluster.misfit > misfit; });
    minima.insert(place, {{point.begin(), point.end()}, misfit, 1});
}

MultiStartResult search_from_many_starts(const Search& search, Priors priors) {
    const FitSettings& settings = settings_of(search);
    const bool one_run = is_global(settings.algorithm) || search.misfit.free_parameters().empty();
    const long per_run =
        one_run ? static_cast<long>(settings.starts) * settings.evaluations_per_start : settings.evaluations_per_start;
    const auto starts = starting_points(search.misfit, one_run ? 1 : static_cast<std::size_t>(settings.starts));
    const auto runs = share_tasks<MinimiseResult>(starts.size(), search.workers(), [&](std::size_t number) {
        return explore_and_polish(search, priors, starts[number], per_run);
    });

    std::vector<MinimiseResult> sorted = runs;
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
    MultiStartResult result;
    EvaluationCount evaluations;
    for (const MinimiseResult& run : sorted) {
        evaluations.add(run.evaluations);
        if (run.found()) {
            add_minimum(result.minima, run.point, run.value, search.misfit.bounds());
        }
    }
    result.best = sorted.front();
    result.best.evaluations = evaluations;
    if (result.best.found()) {
        const MinimiseResult polished = polish_best_of(search, priors, {result.best.point});
        result.best = combine(result.best, polished);
        result.minima.front().parameters = result.best.point;
        result.minima.front().misfit = result.best.value;
    }
    return result;
}

}  // namespace delabole
