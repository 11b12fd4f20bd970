#include "fitting/sensitivity/reliability.hpp"

#include "fitting/work/parallel.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

std::vector<double> start_of(std::size_t number, std::size_t dimension, const CountedRandom& random) {
    constexpr double radius = 2;
    std::vector<double> u(dimension, 0.0);
    if (number == 0) {
        return u;
    }
    double squares = 0;
    for (std::size_t index = 0; index < dimension; ++index) {
        u[index] = normal_quantile(random.unit(number, static_cast<std::uint32_t>(index)));
        squares += u[index] * u[index];
    }
    for (double& coordinate : u) {
        coordinate *= radius / std::sqrt(squares);
    }
    return u;
}

DesignPoint design_point(const NearestPoint& found, const InputSpace& space, bool medians_fail) {
    DesignPoint point;
    point.reliability_index = medians_fail ? -found.distance : found.distance;
    point.standard_normal = found.point;
    point.alpha = found.direction;
    point.parameters.resize(space.size());
    space.values(found.point, point.parameters);
    const Eigen::VectorXd alpha = Eigen::Map<const Eigen::VectorXd>(point.alpha.data(), std::ssize(point.alpha));
    const Eigen::VectorXd importance =
        space.factor().transpose().triangularView<Eigen::Upper>().solve(alpha).normalized();
    point.importance.assign(importance.begin(), importance.end());
    point.off_surface = found.off_surface;
    point.misalignment = found.misalignment;
    point.hits = 1;
    point.converged = found.converged;
    return point;
}

bool same_place(const DesignPoint& one, const DesignPoint& other) {
    constexpr double near = 0.05;  // standard deviations
    double squares = 0;
    for (std::size_t index = 0; index < one.standard_normal.size(); ++index) {
        const double difference = one.standard_normal[index] - other.standard_normal[index];
        squares += difference * difference;
    }
    return squares < near * near;
}

// Enters a design point. Two points at the same place become one, which is a converged one if possible.
void enter(std::vector<DesignPoint>& points, DesignPoint point) {
    const auto same =
        std::find_if(points.begin(), points.end(), [&](const DesignPoint& other) { return same_place(point, other); });
    if (same != points.end()) {
        point.hits += same->hits;
        if (point.converged && !same->converged) {
            *same = std::move(point);
        } else {
            same->hits = point.hits;
        }
        return;
    }
    points.push_back(std::move(point));
}

}  // namespace

ReliabilityResult reliability(const Evaluator& evaluator, const InputSpace& space, const ReliabilitySettings& settings,
                              const FailureCriterion& criterion, std::uint64_t seed) {
    ReliabilityResult result;
    const std::size_t dimension = space.size();
    const double sign = criterion.side == FailureSide::below ? 1 : -1;
    const Objective margin = [&](std::span<const double> u) {
        std::array<double, most_parameters> storage{};
        const std::span<double> parameters = std::span(storage).first(dimension);
        space.values(u, parameters);
        evaluator.progress.count();
        Evaluation evaluation = evaluator.quantity(parameters);
        evaluation.value = sign * (evaluation.value - criterion.limit);
        return evaluation;
    };
    const Evaluation at_medians = margin(std::vector<double>(dimension, 0.0));
    result.evaluations.record(at_medians);
    if (!at_medians.valid()) {
        result.status = ReliabilityStatus::no_answer_at_medians;
        return result;
    }
    result.medians_fail = at_medians.value < 0;
    const NearestPointSettings how{.step = settings.step, .tolerance = settings.tolerance};
    const CountedRandom random(seed, RandomPurpose::start);
    const auto starts = static_cast<std::size_t>(settings.starts);
    const auto found = share_tasks<NearestPoint>(starts, evaluator.workers(), [&](std::size_t number) {
        return evaluator.stopped() ? NearestPoint{}
                                   : nearest_point(margin, start_of(number, dimension, random), how, evaluator.stop);
    });
    result.starts = settings.starts;
    for (const NearestPoint& nearest : found) {
        result.evaluations.add(nearest.evaluations);
        result.converged_starts += nearest.converged ? 1 : 0;
    }
    for (const NearestPoint& nearest : found) {
        // An unconverged end point near the surface is shown only if no start converged.
        const bool near_surface = !nearest.point.empty() && nearest.off_surface <= 10 * settings.tolerance;
        if (nearest.converged || (result.converged_starts == 0 && near_surface)) {
            enter(result.points, design_point(nearest, space, result.medians_fail));
        }
    }
    std::stable_sort(result.points.begin(), result.points.end(), [](const DesignPoint& one, const DesignPoint& other) {
        return std::pair(!one.converged, std::abs(one.reliability_index)) <
               std::pair(!other.converged, std::abs(other.reliability_index));
    });
    if (!result.points.empty()) {
        const DesignPoint& nearest = result.points.front();
        result.status = nearest.converged ? ReliabilityStatus::converged : ReliabilityStatus::not_converged;
        result.reliability_index = nearest.reliability_index;
        result.probability_of_failure = normal_probability(-nearest.reliability_index).below;
    }
    if (evaluator.stopped()) {
        result.status = ReliabilityStatus::interrupted;
    }
    return result;
}

}  // namespace delabole
