#include "fitting/search/minimise.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace delabole {

namespace {

using Optimiser = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, decltype(&nlopt_destroy)>;

nlopt_algorithm nlopt_name(Algorithm algorithm) {
    switch (algorithm) {
    case Algorithm::sbplx:
        return NLOPT_LN_SBPLX;
    case Algorithm::bobyqa:
        return NLOPT_LN_BOBYQA;
    case Algorithm::cobyla:
        return NLOPT_LN_COBYLA;
    case Algorithm::crs2:
        return NLOPT_GN_CRS2_LM;
    case Algorithm::direct_l:
        return NLOPT_GN_DIRECT_L;
    case Algorithm::mlsl:
        return NLOPT_G_MLSL_LDS;
    case Algorithm::isres:
        return NLOPT_GN_ISRES;
    }
    throw std::invalid_argument("minimise: unknown algorithm");
}

// All that the callback needs; it exists as long as one run.
struct Run {
    const Objective& objective;
    std::span<const Interval> bounds;
    const MinimiseSettings& settings;
    StopFlag stop;
    std::vector<std::size_t> active;  // parameters that can move
    std::vector<double> parameters;   // of the evaluation under way
    nlopt_opt optimiser = nullptr;
    MinimiseResult result;
    // Chi-square misfits of practical interest lie far below this; it is raised when a run finds greater values.
    double penalty = 1e6;
    bool limit_reached = false;
    bool interrupted = false;
    std::exception_ptr thrown;

    void set_parameters(const double* unit) {
        for (std::size_t index = 0; index < active.size(); ++index) {
            const Interval& range = bounds[active[index]];
            // std::lerp returns the bounds exactly at 0 and 1.
            parameters[active[index]] = std::lerp(range.lower, range.upper, std::clamp(unit[index], 0.0, 1.0));
        }
    }

    double evaluate_parameters() {
        const Evaluation evaluation = objective(parameters);
        result.evaluations.record(evaluation);
        if (!evaluation.valid()) {
            ++result.evaluations.optimiser_rejections;
            return penalty;
        }
        // The penalty is at most 1e300, so that the algorithms' own arithmetic with it stays finite.
        penalty = std::max(penalty, std::min(2 * std::abs(evaluation.value), 1e300));
        if (evaluation.value < result.value) {
            result.value = evaluation.value;
            result.point = parameters;
        }
        return evaluation.value;
    }

    bool must_stop() {
        interrupted = interrupted || stop_requested(stop);
        limit_reached = limit_reached || result.evaluations.total >= settings.evaluations;
        return interrupted || limit_reached || thrown != nullptr;
    }
};

// NLopt, a C library, calls this function: no exception may leave it.
double callback(unsigned, const double* unit, double*, void* data) noexcept {
    Run& run = *static_cast<Run*>(data);
    if (run.must_stop()) {
        nlopt_force_stop(run.optimiser);
        return run.penalty;
    }
    try {
        run.set_parameters(unit);
        return run.evaluate_parameters();
    } catch (...) {
        run.thrown = std::current_exception();
        nlopt_force_stop(run.optimiser);
        return run.penalty;
    }
}

void require(nlopt_result result, const char* what) {
    if (result == NLOPT_OUT_OF_MEMORY) {
        throw std::bad_alloc();
    }
    if (result == NLOPT_INVALID_ARGS) {
        throw std::logic_error(std::string("minimise: NLopt refused ") + what);
    }
}

void set_tolerances(nlopt_opt optimiser, const MinimiseSettings& settings) {
    require(nlopt_set_xtol_abs1(optimiser, settings.relative_tolerance), "the tolerance");
    require(nlopt_set_ftol_abs(optimiser, settings.value_tolerance), "the value tolerance");
}

Optimiser make_optimiser(Run& run) {
    const auto dimension = static_cast<unsigned>(run.active.size());
    const MinimiseSettings& settings = run.settings;
    Optimiser optimiser(nlopt_create(nlopt_name(settings.algorithm), dimension), &nlopt_destroy);
    if (!optimiser) {
        throw std::bad_alloc();
    }
    require(nlopt_set_min_objective(optimiser.get(), callback, &run), "the objective");
    require(nlopt_set_lower_bounds1(optimiser.get(), 0), "the lower bounds");
    require(nlopt_set_upper_bounds1(optimiser.get(), 1), "the upper bounds");
    require(nlopt_set_initial_step1(optimiser.get(), settings.initial_step), "the initial step");
    require(nlopt_set_stopval(optimiser.get(), settings.stop_value), "the stop value");
    set_tolerances(optimiser.get(), settings);
    if (settings.algorithm == Algorithm::mlsl) {
        const Optimiser local(nlopt_create(NLOPT_LN_SBPLX, dimension), &nlopt_destroy);
        if (!local) {
            throw std::bad_alloc();
        }
        set_tolerances(local.get(), settings);
        require(nlopt_set_local_optimizer(optimiser.get(), local.get()), "the local algorithm");
    }
    return optimiser;
}

void check(std::span<const Interval> bounds, std::span<const double> start, const MinimiseSettings& settings) {
    if (bounds.size() != start.size()) {
        throw std::invalid_argument("minimise: the start has " + std::to_string(start.size()) +
                                    " numbers, the bounds " + std::to_string(bounds.size()));
    }
    for (std::size_t index = 0; index < bounds.size(); ++index) {
        const Interval& range = bounds[index];
        if (!(std::isfinite(range.lower) && std::isfinite(range.upper) && range.lower <= range.upper)) {
            throw std::invalid_argument("minimise: bounds of parameter " + std::to_string(index) +
                                        " must be finite and lower <= upper");
        }
        if (std::isnan(start[index])) {
            throw std::invalid_argument("minimise: start of parameter " + std::to_string(index) + " is not a number");
        }
    }
    if (settings.evaluations < 1 || !(settings.initial_step > 0 && settings.initial_step <= 0.5) ||
        !(settings.relative_tolerance >= 0) || !(settings.value_tolerance >= 0)) {
        throw std::invalid_argument("minimise: needs evaluations >= 1, 0 < initial_step <= 0.5 and tolerances >= 0");
    }
}

MinimiseStatus status_of(const Run& run, nlopt_result outcome) {
    if (run.interrupted) {
        return MinimiseStatus::interrupted;
    }
    if (!run.result.found()) {
        return MinimiseStatus::no_valid_point;
    }
    if (run.limit_reached) {
        return MinimiseStatus::evaluation_limit;
    }
    if (outcome == NLOPT_ROUNDOFF_LIMITED) {
        return MinimiseStatus::roundoff_limited;
    }
    return outcome > 0 ? MinimiseStatus::converged : MinimiseStatus::algorithm_failure;
}

nlopt_result optimise(Run& run) {
    std::vector<double> unit(run.active.size());
    for (std::size_t index = 0; index < unit.size(); ++index) {
        const std::size_t parameter = run.active[index];
        const Interval& range = run.bounds[parameter];
        unit[index] = (run.parameters[parameter] - range.lower) / (range.upper - range.lower);
    }
    const Optimiser optimiser = make_optimiser(run);
    run.optimiser = optimiser.get();
    // The generator's state belongs to a thread (in Debian's build), so seeding here makes every run repeatable on any
    // thread.
    nlopt_srand(static_cast<unsigned long>(run.settings.seed));
    double value = 0;
    const nlopt_result outcome = nlopt_optimize(optimiser.get(), unit.data(), &value);
    if (run.thrown) {
        std::rethrow_exception(run.thrown);
    }
    require(outcome, "to start");
    return outcome;
}

}  // namespace

MinimiseResult minimise(const Objective& objective, std::span<const Interval> bounds, std::span<const double> start,
                        const MinimiseSettings& settings, StopFlag stop) {
    check(bounds, start, settings);
    Run run{objective, bounds, settings, stop, {}, {}, nullptr, {}, 1e6, false, false, nullptr};
    for (std::size_t index = 0; index < bounds.size(); ++index) {
        run.parameters.push_back(std::clamp(start[index], bounds[index].lower, bounds[index].upper));
        if (bounds[index].lower < bounds[index].upper) {
            run.active.push_back(index);
        }
    }
    nlopt_result outcome = NLOPT_SUCCESS;
    if (!run.active.empty()) {
        outcome = optimise(run);
    } else if (!run.must_stop()) {
        run.evaluate_parameters();
    }
    run.result.status = status_of(run, outcome);
    return run.result;
}

}  // namespace delabole
