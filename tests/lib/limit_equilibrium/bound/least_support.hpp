// The support that an assembly needs, by the largest factor on a load that acts against it.
#pragma once

#include "limit_equilibrium/bound/lp_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

// Least force in `direction` through `point` on a body for which the assembly stands.
inline double least_support_force(const delabole::Assembly& assembly, std::size_t body, const delabole::Point& point,
                                  const delabole::Point& direction) {
    const delabole::Body& held = assembly.bodies[body];
    const delabole::Point force = -held.weight * direction.normalized();
    const delabole::Point arm = point - held.centroid;
    std::vector<delabole::BodyLoad> loads(assembly.bodies.size());
    loads[body] = {force, arm.x() * force.y() - arm.y() * force.x()};
    const delabole::LpBound bound = largest_load_factor(assembly, loads);
    EXPECT_EQ(bound.status, delabole::LpStatus::optimal);
    return std::max(0.0, -bound.value) * held.weight;
}
