#include "limit_equilibrium/bound/lp_bound.hpp"
#include "limit_equilibrium/bound/lp_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace delabole {

using detail::Scales;
using detail::Sense;

namespace {

// 4^5. With cones much nearer to half planes the simplex method has no accurate digits.
constexpr double largest_strength = 1024;
// Likewise with cones so narrow that both edges are one line.
constexpr double least_strength_told = 1e-6;

}  // namespace

// The assembly stands if a horizontal force of k times the weights may be 0: the largest k is then not below 0 and the
// least not above it. The two move apart as strength grows, so that the smaller of the largest k and minus the least
// crosses 0 once. This margin is a piecewise smooth function, whose root is found between a strength with which the
// assembly stands and one with which it does not.
LpBound least_strength_factor(const Assembly& assembly, const std::atomic<bool>* stop) {
    if (const AssemblyCheck check = check_assembly(assembly); check != AssemblyCheck::valid) {
        return detail::refused_bound(check);
    }
    const Scales scales = detail::scales_of(assembly);
    const std::vector<BodyLoad> push = detail::horizontal_weights(assembly);
    int iterations = 0;
    bool failed = false;
    bool stopped = false;
    struct Trial {
        double strength = 0;
        double margin = -infinity;
        LpBound state{};
    };
    const auto attempt = [&](double strength) {
        Trial trial;
        trial.strength = strength;
        trial.margin = infinity;
        for (const Sense sense : {Sense::largest, Sense::least}) {
            stopped = stopped || (stop != nullptr && *stop);
            if (stopped) {
                failed = true;
                break;
            }
            LpBound bound = detail::solve(assembly, scales, {push, sense}, strength);
            iterations += bound.iterations;
            LpStatus status = bound.status;
            if (status == LpStatus::not_converged && sense == Sense::least) {
                // The largest k is known not to be below 0: it suffices to know whether the assembly stands without the
                // force.
                const LpBound without = detail::solve(assembly, scales, {push, sense, 0, 0}, strength);
                iterations += without.iterations;
                status = without.status == LpStatus::optimal ? LpStatus::unbounded : without.status;
            }
            failed = failed || status == LpStatus::not_converged;
            double margin = status == LpStatus::unbounded ? infinity : -infinity;
            if (status == LpStatus::optimal) {
                margin = sense == Sense::largest ? bound.value : -bound.value;
            }
            if (margin < trial.margin) {
                trial.margin = margin;
                trial.state = std::move(bound);
            }
            if (trial.margin < 0) {
                break;  // the largest k and minus the least are not both below 0
            }
        }
        return trial;
    };
    const auto finish = [&](Trial trial) {
        LpBound bound = std::move(trial.state);
        if (trial.margin > 1e-9 && !stopped) {
            // Here the margin is not zero: friction is 0, or below this strength no horizontal force would suffice. The
            // forces are those without any horizontal force.
            bound = detail::solve(assembly, scales, {push, Sense::largest, 0, 0}, trial.strength);
            failed = failed || bound.status != LpStatus::optimal;
        }
        if (stopped) {
            bound = {};
            bound.status = LpStatus::interrupted;
            return bound;
        }
        bound.status = failed ? LpStatus::not_converged : LpStatus::optimal;
        bound.value = trial.strength;
        bound.iterations = iterations;
        return bound;
    };
    Trial low = attempt(0);
    if (low.margin >= 0) {
        return finish(std::move(low));
    }
    Trial high = attempt(1);
    while (high.margin < 0 && high.strength < largest_strength && !failed) {
        low = std::move(high);
        high = attempt(low.strength * 4);
    }
    if (high.margin < 0) {
        LpBound bound;
        bound.status = stopped ? LpStatus::interrupted : failed ? LpStatus::not_converged : LpStatus::infeasible;
        bound.iterations = iterations;
        return bound;
    }
    int stale = 0;  // steps since the bracket halved
    while (high.strength - low.strength > 1e-13 * high.strength && high.strength > least_strength_told &&
           high.margin > 0 && !failed) {
        const double width = high.strength - low.strength;
        const bool both = std::isfinite(low.margin) && std::isfinite(high.margin) && stale < 2;
        const double share = both ? -low.margin / (high.margin - low.margin) : 0.5;
        // The trial stays away from the ends, because otherwise one of them would never move.
        const double middle = low.strength + width * std::clamp(share, 1e-3, 1 - 1e-3);
        Trial trial = attempt(middle);
        (trial.margin < 0 ? low : high) = std::move(trial);
        stale = high.strength - low.strength > 0.5 * width ? stale + 1 : 0;
    }
    return finish(std::move(high));
}

}  // namespace delabole
