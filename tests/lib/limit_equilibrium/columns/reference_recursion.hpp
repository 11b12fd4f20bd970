// Goodman & Bray's recursion written out plainly, by which columns are judged without the library's own solver.
#pragma once

#include "limit_equilibrium/columns/make_columns.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole::test {

// Thrust that must be brought to the toe of the first column, all friction divided by `reduction`; its sign tells
// whether the slope stands. A first column that would topple counts by its moment per metre of base.
inline double toe_thrust(const ColumnSlope<>& slope, double joint_friction, double base_friction, double reduction) {
    const double joint = joint_friction / reduction;
    const double base = base_friction / reduction;
    double thrust = 0;
    double arm_of_thrust = 0;
    if (slope.slide_head) {
        const SlideHeadThrust<> head = slide_head_thrust(*slope.slide_head, slope.base_dip, joint_friction, reduction);
        thrust = head.force;
        arm_of_thrust = head.height;
    }
    for (std::size_t index = slope.columns.size(); index-- > 0;) {
        const Column<>& column = slope.columns[index];
        const double above = index + 1 < slope.columns.size() ? column.upper_contact : arm_of_thrust;
        const double moment = thrust * (above - joint * column.width) + column.overturning_moment;
        // From friction + friction = 90 deg on, joint and base lock a column that does not slide by itself.
        const double excess = column.down_dip_force - base * column.normal_force;
        const double slide = base * joint < 1 ? thrust + excess / (1 - base * joint)
                             : excess > 0     ? std::numeric_limits<double>::infinity()
                                              : -std::numeric_limits<double>::infinity();
        if (index == 0) {
            return std::max(moment / column.width, slide);
        }
        const double topple = moment > 0 ? moment / column.lower_contact : 0;
        thrust = std::max({topple, slide, 0.0});
    }
    return thrust;
}

// The largest reduction at which the slope just stands; 0 where none makes it stand. The thrust at the toe need not
// grow with the reduction throughout (beyond 45 deg of friction a heavy thrust may hold down a first column that tips
// without it), so that the search comes down from above in steps of a twentieth.
inline double factor_of_safety(const ColumnSlope<>& slope, double joint_friction, double base_friction) {
    double high = 1e3;
    double low = high;
    while (toe_thrust(slope, joint_friction, base_friction, low) > 0) {
        high = low;
        low /= 1.05;
        if (low < 1e-3) {
            return 0;
        }
    }
    for (int repeat = 0; repeat < 50; ++repeat) {
        const double middle = (low + high) / 2;
        (toe_thrust(slope, joint_friction, base_friction, middle) > 0 ? high : low) = middle;
    }
    return (low + high) / 2;
}

}  // namespace delabole::test
