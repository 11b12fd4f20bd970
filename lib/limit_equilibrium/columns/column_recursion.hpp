// Limiting equilibrium of columns on a stepped base, from the uppermost column down (Goodman & Bray 1976; thesis 4.4,
// eqs. 20, 21), for general loads and different friction on joints and bases.
//
// Column n, between the joints n (above) and n - 1 (below), is held by the normal force P_(n-1) of its lower joint. m
// is the tangent of the joints' friction angle, c that of the bases, both fully mobilised on moving columns; w the
// width, M and L the heights of contact on the upper and lower joint, D, N, O the column's own down-dip force, normal
// force and overturning moment, C = cohesion x w on the base.
//   topples about its toe corner:  P_(n-1) L = P_n (M - m w) + O
//   slides on its base:            P_(n-1) (1 - c m) = P_n (1 - c m) + D - c N - C
// The larger of both, and of zero, is needed: the column topples, slides or stays. With one friction angle and weight
// alone these are eqs. 20 and 21 solved for the force below. The thesis numbers the columns from the toe, solves for
// the force above, which is the greatest that a column can bear, and takes the smaller one: the same limiting
// equilibrium.
//
// Contact of a leaning column is at the highest common point of the two columns, so that joints have friction but no
// cohesion: a joint that touches at a corner has no area for it.
//
// Where c m >= 1 (friction angles adding to 90 deg) pushing the column up no longer unloads it: the friction of the
// push reduces the base's resistance by more than the push itself provides. A column that its own base holds
// (D - c N - C + P_n (1 - c m) <= 0) needs no push; any other cannot be held by a push, and the force becomes infinite.
// There a column changes at once from needing no push to being held by none, and the slope from standing to failing,
// without a strength at which the toe column is in limiting equilibrium. The same applies to a column that topples
// without a neighbour to lean on.
#pragma once

#include "limit_equilibrium/columns/column.hpp"
#include "limit_equilibrium/columns/slide_head.hpp"

#include <cstddef>
#include <limits>

namespace delabole {

enum class ColumnMode { stays, slides, topples };

template <class T = double>
struct ColumnStrength {
    T joint_friction;  // tangent of the friction angle
    T base_friction;   // tangent of the friction angle
    T base_cohesion;   // Pa

    ColumnStrength reduced_by(const T& factor) const {
        return {T(joint_friction / factor), T(base_friction / factor), T(base_cohesion / factor)};
    }
};

// Force of one joint on the column below it.
template <class T = double>
struct JointForce {
    T normal;  // out of the slope, along the bases, N/m
    T shear;   // down along the joint, N/m
    T height;  // above the base of the column below
};

// Balance of the toe column without a push. It stands if both are negative. Both are finite unless no push holds a
// column above.
template <class T = double>
struct ToeBalance {
    T overturning_moment;  // about its toe corner, N
    T unresisted_force;    // D + P (1 - c m) - c N - C, N/m
    T push_effect;         // 1 - c m: decrease of the unresisted force by a push of 1 N/m
};

// Calls visit(index, column, force of the upper joint, needed to prevent toppling, needed to prevent sliding, force of
// the lower joint) for each column but the first, from the top. Linear in their number, no allocation.
template <class T, class Visitor>
ToeBalance<T> descend(const ColumnSlope<T>& slope, const ColumnStrength<T>& strength, const JointForce<T>& head,
                      Visitor&& visit) {
    const T infinite = T(std::numeric_limits<double>::infinity());
    const T& friction = strength.joint_friction;
    const T push_effect = 1 - strength.base_friction * friction;
    JointForce<T> upper = head;
    for (std::size_t index = slope.columns.size(); index-- > 0;) {
        const Column<T>& column = slope.columns[index];
        const T overturning = column.overturning_moment + upper.normal * upper.height - upper.shear * column.width;
        const T unresisted = column.down_dip_force + upper.normal -
                             strength.base_friction * (column.normal_force + upper.shear) -
                             strength.base_cohesion * column.width;
        if (index == 0) {
            return {overturning, unresisted, push_effect};
        }
        // A push cannot reach a column without a neighbour to lean on.
        const T against_toppling =
            overturning > 0 ? (column.lower_contact > 0 ? T(overturning / column.lower_contact) : infinite) : T(0);
        const T against_sliding = unresisted > 0 ? (push_effect > 0 ? T(unresisted / push_effect) : infinite) : T(0);
        const T needed = against_toppling > against_sliding ? against_toppling : against_sliding;
        visit(index, column, upper, against_toppling, against_sliding, needed);
        if (!(needed < infinite)) {
            return {infinite, infinite, push_effect};
        }
        upper = {needed, T(friction * needed), slope.columns[index - 1].upper_contact};
    }
    return {T(0), T(0), push_effect};
}

template <class T>
ToeBalance<T> toe_balance(const ColumnSlope<T>& slope, const ColumnStrength<T>& strength, const JointForce<T>& head) {
    return descend(slope, strength, head, [](auto&&...) {});
}

// Height at which a force on the toe column acts in place of a neighbour: that of its middle line.
template <class T>
T toe_lever(const Column<T>& toe) {
    return toe.height > 0 ? toe.height : toe.width;
}

// Positive if the toe column moves, N/m. Continuous in all inputs while every column can be held, and then zero in
// limiting equilibrium; it jumps from a negative number to infinity where one can no longer be held.
template <class T>
T failure_margin(const ColumnSlope<T>& slope, const ToeBalance<T>& toe) {
    const T toppling = toe.overturning_moment / toe_lever(slope.columns.front());
    return toppling > toe.unresisted_force ? toppling : toe.unresisted_force;
}

}  // namespace delabole
