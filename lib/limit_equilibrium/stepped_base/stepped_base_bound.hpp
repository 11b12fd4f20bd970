// The factor of safety of columns on a stepped base by linear programming, to compare with that of the recursion: it
// shows how far the answer depends on where the forces between columns act. lp_bound.hpp explains the bound.
#pragma once

#include "limit_equilibrium/bound/block_assembly.hpp"
#include "limit_equilibrium/bound/lp_bound.hpp"
#include "limit_equilibrium/stepped_base/stepped_base.hpp"

#include <atomic>
#include <optional>

namespace delabole {

struct LinearProgrammingBound {
    double upper_part;
    std::optional<CrossJoints> cross_joints;
    static constexpr auto fields() {
        return FieldTable{number<&LinearProgrammingBound::upper_part>(
                              within(1e-6, 1),
                              "share of each joint, from its top, over which columns touch; 1: the bound proper, "
                              "towards 0: the recursion, which puts forces on the tops"),
                          section<&LinearProgrammingBound::cross_joints>(
                              "joints across the columns, which cut them into blocks; columns under their own weight "
                              "alone; blocks touch over all of each joint")};
    }
};

// Numbers are 0 unless the status is optimal; factors of safety are infinite if no strength is needed, and 0 if the
// programme is infeasible.
struct BoundResult {
    LpStatus status = LpStatus::not_converged;
    AssemblyCheck check = AssemblyCheck::valid;
    double factor_of_safety = 0;
    double duality_gap = 0;
    double imbalance = 0;
    double body_count = 0;

    static constexpr auto fields() {
        return FieldTable{
            section<&BoundResult::status>("how the linear programme ended"),
            section<&BoundResult::check>("why there is none, where its assembly is invalid"),
            number<&BoundResult::factor_of_safety>(
                "largest factor on all friction and cohesion for which forces exist that keep all in equilibrium: if "
                "joints touch over all of their length, a bound from the unsafe side, since joints that slip without "
                "opening may fail before; if only over an upper part, a value between the bound and the recursion"),
            number<&BoundResult::duality_gap>(
                "horizontal force, over the weight, by which the mechanism misses the forces"),
            number<&BoundResult::imbalance>("largest force, or moment by arm, left on a body, over the mean weight"),
            number<&BoundResult::body_count>("bodies in the programme")};
    }
};

// Answer, with the assembly and the solution behind it, for the figures.
struct BoundState {
    BoundResult result{};
    Assembly assembly{};
    LpBound programme{};
};

constexpr double most_bound_columns = 500;
constexpr double most_bound_blocks = 500;

// Whether the programme takes an acceptable time. Measured: 1 s for 169 columns, 9 s for 460.
bool can_bound(const ColumnSlope<>& slope);
bool can_bound(const ColumnSlope<>& slope, const CrossJoints& cross_joints);

// Cohesion of the bases acts over their whole width; the recursion includes it only for columns that slide.
BoundState bound_of_columns(const ColumnSlope<>& slope, const SteppedBase<>& problem, double upper_part,
                            const std::atomic<bool>* stop = nullptr);

// For loads other than weight, and for columns that are not rectangles, the status is invalid_assembly and the check
// loads_beyond_weight.
BoundState bound_of_blocks(const ColumnSlope<>& slope, const SteppedBase<>& problem, const CrossJoints& cross_joints,
                           const std::atomic<bool>* stop = nullptr);

}  // namespace delabole
