#include "fitting/search/nearest_point.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <new>
#include <numeric>
#include <optional>
#include <type_traits>

namespace delabole {

namespace {

using Optimiser = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, decltype(&nlopt_destroy)>;

double norm(std::span<const double> vector) {
    return std::sqrt(std::inner_product(vector.begin(), vector.end(), vector.begin(), 0.0));
}

struct Search {
    const Objective& g;
    const NearestPointSettings& settings;
    StopFlag stop;
    double scale = 1;  // slope of g at the start, so that g / scale is a distance
    double wall = 1;   // distance that a failed evaluation stands for
    nlopt_opt optimiser = nullptr;
    EvaluationCount evaluations = {};
    std::exception_ptr thrown = nullptr;

    std::optional<double> value(std::span<const double> u) {
        const Evaluation evaluation = g(u);
        evaluations.record(evaluation);
        return evaluation.valid() ? std::optional(evaluation.value / scale) : std::nullopt;
    }

    // Central differences; one-sided where the model fails on one side. False where it fails on both.
    bool gradient(std::span<const double> u, double at_u, std::vector<double>& slope) {
        std::vector<double> moved(u.begin(), u.end());
        slope.assign(u.size(), 0.0);
        for (std::size_t index = 0; index < u.size(); ++index) {
            const double step = settings.step;
            moved[index] = u[index] + step;
            const std::optional<double> above = value(moved);
            moved[index] = u[index] - step;
            const std::optional<double> below = value(moved);
            moved[index] = u[index];
            if (!above && !below) {
                return false;
            }
            slope[index] = (above.value_or(at_u) - below.value_or(at_u)) / (above && below ? 2 * step : step);
        }
        return true;
    }

    bool must_stop() const {
        return stop_requested(stop) || evaluations.total >= settings.evaluations || thrown != nullptr;
    }
};

double half_square(unsigned count, const double* u, double* gradient, void*) noexcept {
    double sum = 0;
    for (unsigned index = 0; index < count; ++index) {
        sum += u[index] * u[index] / 2;
        if (gradient != nullptr) {
            gradient[index] = u[index];
        }
    }
    return sum;
}

// NLopt, a C library, calls this function: no exception may leave it.
double constraint(unsigned count, const double* u, double* gradient, void* data) noexcept {
    Search& run = *static_cast<Search*>(data);
    if (gradient != nullptr) {
        std::fill_n(gradient, count, 0.0);
    }
    if (run.must_stop()) {
        nlopt_force_stop(run.optimiser);
        return run.wall;
    }
    try {
        const std::span<const double> point(u, count);
        const std::optional<double> value = run.value(point);
        if (!value) {
            return run.wall;
        }
        std::vector<double> slope;
        if (gradient != nullptr && run.gradient(point, *value, slope)) {
            std::copy(slope.begin(), slope.end(), gradient);
        }
        return *value;
    } catch (...) {
        run.thrown = std::current_exception();
        nlopt_force_stop(run.optimiser);
        return run.wall;
    }
}

std::vector<double> search(Search& run, nlopt_algorithm algorithm, std::vector<double> u) {
    const Optimiser optimiser(nlopt_create(algorithm, static_cast<unsigned>(u.size())), &nlopt_destroy);
    if (!optimiser) {
        throw std::bad_alloc();
    }
    run.optimiser = optimiser.get();
    const double tolerance = run.settings.tolerance / 10;
    nlopt_set_min_objective(optimiser.get(), half_square, nullptr);
    nlopt_add_equality_constraint(optimiser.get(), constraint, &run, tolerance);
    nlopt_set_lower_bounds1(optimiser.get(), -run.settings.search_radius);
    nlopt_set_upper_bounds1(optimiser.get(), run.settings.search_radius);
    nlopt_set_xtol_abs1(optimiser.get(), tolerance);
    nlopt_set_initial_step1(optimiser.get(), 0.5);
    double least = 0;
    // The status is not used, since the point itself is checked: SLSQP reports a roundoff limit even at exact answers.
    nlopt_optimize(optimiser.get(), u.data(), &least);
    if (run.thrown) {
        std::rethrow_exception(run.thrown);
    }
    return u;
}

NearestPoint judged(Search& run, std::vector<double> u) {
    NearestPoint found;
    const std::optional<double> value = run.value(u);
    std::vector<double> slope;
    if (!value || !run.gradient(u, *value, slope) || !(norm(slope) > 0)) {
        return found;
    }
    const double steepness = norm(slope);
    found.distance = norm(u);
    found.off_surface = std::abs(*value) / steepness;
    double along = 0;
    for (std::size_t index = 0; index < u.size(); ++index) {
        found.direction.push_back(-slope[index] / steepness);
        along += found.direction[index] * u[index];
    }
    // For a surface through the origin the radius has no direction; the distance of at least 0.1 keeps the quotient
    // meaningful.
    const double across = std::sqrt(std::max(found.distance * found.distance - along * along, 0.0));
    found.misalignment = across / std::max(found.distance, 0.1);
    constexpr double aligned = 0.03;  // the error of the distance is then less than the square of this, 0.1 %
    found.converged = found.off_surface <= run.settings.tolerance && found.misalignment <= aligned;
    found.point = std::move(u);
    return found;
}

}  // namespace

NearestPoint nearest_point(const Objective& g, std::span<const double> start, const NearestPointSettings& settings,
                           StopFlag stop) {
    Search run{g, settings, stop};
    std::vector<double> u(start.begin(), start.end());
    const std::optional<double> value = run.value(u);
    std::vector<double> slope;
    NearestPoint found;
    if (value && run.gradient(u, *value, slope) && norm(slope) > 0) {
        run.scale = norm(slope);
        run.wall = std::max(std::abs(*value) / run.scale, settings.search_radius);
        found = judged(run, search(run, NLOPT_LD_SLSQP, u));
        if (!found.converged && !run.must_stop()) {
            NearestPoint again = judged(run, search(run, NLOPT_LN_COBYLA, found.point.empty() ? u : found.point));
            if (again.converged || found.point.empty()) {
                found = std::move(again);
            }
        }
    }
    found.evaluations = run.evaluations;
    return found;
}

}  // namespace delabole
