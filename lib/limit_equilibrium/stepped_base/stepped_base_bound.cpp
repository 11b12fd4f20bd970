#include "limit_equilibrium/stepped_base/stepped_base_bound.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace delabole {

namespace {

BlockFriction friction_of(const SteppedBase<>& problem) {
    return {problem.bases.friction_angle, problem.joints.friction_angle};
}

BoundState bound_of(Assembly assembly, double base_cohesion, std::size_t bodies_on_bases,
                    const std::atomic<bool>* stop) {
    BoundState state;
    for (Contact& contact : assembly.contacts) {
        if (!contact.other && contact.body < bodies_on_bases) {
            contact.cohesion = base_cohesion;
        }
    }
    state.assembly = std::move(assembly);
    state.programme = least_strength_factor(state.assembly, stop);
    const LpBound& bound = state.programme;
    state.result.status = bound.status;
    state.result.check = bound.check;
    if (bound.status == LpStatus::optimal) {
        state.result.factor_of_safety = bound.value > 0 ? 1 / bound.value : std::numeric_limits<double>::infinity();
        state.result.duality_gap = std::abs(bound.residuals.mechanism_value);
        state.result.imbalance = bound.residuals.imbalance;
    }
    state.result.body_count = static_cast<double>(state.assembly.bodies.size());
    return state;
}

}  // namespace

bool can_bound(const ColumnSlope<>& slope) {
    return static_cast<double>(slope.columns.size()) <= most_bound_columns;
}

bool can_bound(const ColumnSlope<>& slope, const CrossJoints& cross_joints) {
    double blocks = 0;
    for (const Column<>& column : slope.columns) {
        blocks += std::ceil(column.height / cross_joints.spacing);
    }
    return blocks <= most_bound_blocks;
}

BoundState bound_of_columns(const ColumnSlope<>& slope, const SteppedBase<>& problem, double upper_part,
                            const std::atomic<bool>* stop) {
    return bound_of(assemble_columns(slope, friction_of(problem), upper_part), problem.bases.cohesion,
                    slope.columns.size(), stop);
}

BoundState bound_of_blocks(const ColumnSlope<>& slope, const SteppedBase<>& problem, const CrossJoints& cross_joints,
                           const std::atomic<bool>* stop) {
    Assembly assembly = assemble_blocks(slope, cross_joints, friction_of(problem));
    const std::size_t bodies = assembly.bodies.size();
    return bound_of(std::move(assembly), problem.bases.cohesion, bodies, stop);
}

}  // namespace delabole
