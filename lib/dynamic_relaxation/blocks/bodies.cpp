#include "dynamic_relaxation/blocks/bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

namespace delabole {

namespace {

bool move_as_one(const PrescribedMotion& one, const PrescribedMotion& other) {
    const auto turn_of = [](const PrescribedMotion& motion) {
        return std::tuple(motion.angular_velocity, motion.pivot.x(), motion.pivot.y(), motion.start, motion.duration);
    };
    const auto same_entry = [](const TimedVector& left, const TimedVector& right) {
        return left.time == right.time && left.value == right.value;
    };
    return std::ranges::equal(one.velocity, other.velocity, same_entry) &&
           ((one.angular_velocity == 0 && other.angular_velocity == 0) || turn_of(one) == turn_of(other));
}

std::optional<std::size_t> moved_base(const RelaxationScene& scene) {
    const auto fixed = std::ranges::count_if(scene.block, &RelaxationBlock::fixed);
    const auto as_first = std::ranges::count_if(
        scene.motion, [&](const PrescribedMotion& motion) { return move_as_one(motion, scene.motion.front()); });
    return as_first > 0 && as_first == fixed ? std::optional(scene.motion.front().block) : std::nullopt;
}

}  // namespace

Bodies make_bodies(const RelaxationScene& scene) {
    Bodies bodies;
    for (const RelaxationBlock& block : scene.block) {
        const AreaProperties<> area = area_properties(block.outline);
        const double mass = block.density * area.area;
        const double inertia = block.density * area.polar_second_moment;
        bodies.mass.push_back(mass);
        bodies.inertial_mass.push_back(mass);
        bodies.inertia.push_back(inertia);
        bodies.inverse_mass.push_back(block.fixed ? 0 : 1 / mass);
        bodies.inverse_inertia.push_back(block.fixed ? 0 : 1 / inertia);
        bodies.fixed.push_back(block.fixed ? 1 : 0);
        bodies.centroid.push_back(area.centroid);
        const std::size_t begin = bodies.corner.size();
        const std::size_t count = block.outline.size();
        bodies.range.push_back({begin, begin + count});
        double radius = 0;
        double shortest = std::numeric_limits<double>::infinity();
        for (std::size_t vertex = 0; vertex < count; ++vertex) {
            const PlanePoint<>& from = block.outline[vertex];
            const PlanePoint<>& to = block.outline[vertex + 1 < count ? vertex + 1 : 0];
            const PlanePoint<> edge = to - from;
            bodies.block_of.push_back(bodies.mass.size() - 1);
            bodies.corner.emplace_back(from - area.centroid);
            bodies.length.push_back(edge.norm());
            bodies.along.emplace_back(edge / edge.norm());
            bodies.material.push_back(block.joint.empty() ? 0 : block.joint[vertex]);
            radius = std::max(radius, bodies.corner.back().norm());
            shortest = std::min(shortest, bodies.length.back());
        }
        bodies.radius.push_back(radius);
        bodies.shortest_edge.push_back(shortest);
    }
    bodies.moved_base = moved_base(scene);
    return bodies;
}

double area_of(const Bodies& bodies, std::size_t block) {
    const auto first = bodies.corner.begin();
    return area_properties(Polygon<>(first + static_cast<std::ptrdiff_t>(bodies.range[block].begin),
                                     first + static_cast<std::ptrdiff_t>(bodies.range[block].end)))
        .area;
}

std::optional<double> median_of_free(const Bodies& bodies, const std::vector<double>& numbers,
                                     const std::vector<char>& removed) {
    std::vector<double> free;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (bodies.fixed[block] == 0 && (removed.empty() || removed[block] == 0)) {
            free.push_back(numbers[block]);
        }
    }
    const auto middle = free.begin() + static_cast<std::ptrdiff_t>(free.size() / 2);
    std::nth_element(free.begin(), middle, free.end());
    return free.empty() ? std::nullopt : std::optional(*middle);
}

void scale_masses(Bodies& bodies) {
    constexpr double most = 100;
    double heaviest = 0;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        heaviest = bodies.fixed[block] != 0 ? heaviest : std::max(heaviest, bodies.mass[block]);
    }
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (bodies.fixed[block] == 0) {
            const double factor = std::min(heaviest / bodies.mass[block], most);
            bodies.inertial_mass[block] *= factor;
            bodies.inertia[block] *= factor;
            bodies.inverse_mass[block] /= factor;
            bodies.inverse_inertia[block] /= factor;
        }
    }
}

void Motion::set_large_angle(double value) {
    angle = value;
    sine = std::sin(value);
    const double half = std::sin(value / 2);
    versine = 2 * half * half;
}

BondMaterial lesser_of(const BondMaterial& one, const BondMaterial& two) {
    return {std::min(one.young_modulus, two.young_modulus),       std::min(one.shear_modulus, two.shear_modulus),
            std::min(one.tensile_strength, two.tensile_strength), std::min(one.cohesion, two.cohesion),
            std::min(one.friction_angle, two.friction_angle),     std::max(one.spacing, two.spacing)};
}

JointMaterial lesser_of(const JointMaterial& one, const JointMaterial& two) {
    const auto strength = [](const JointMaterial& joint) {
        return std::tuple(joint.friction_angle, joint.cohesion, joint.normal_stiffness, joint.shear_stiffness);
    };
    const auto residual = [](const JointMaterial& joint) {
        return joint.residual_friction_angle.value_or(joint.friction_angle);
    };
    JointMaterial joint = strength(one) < strength(two) ? one : two;
    joint.friction_angle = std::min(one.friction_angle, two.friction_angle);
    if (const double least = std::min(residual(one), residual(two)); least < joint.friction_angle) {
        joint.residual_friction_angle = least;
    }
    joint.cohesion = std::min(one.cohesion, two.cohesion);
    joint.residual_cohesion = std::min(one.residual_cohesion, two.residual_cohesion);
    joint.tensile_strength = std::min(one.tensile_strength, two.tensile_strength);
    joint.bond = one.bond && two.bond ? std::optional(lesser_of(*one.bond, *two.bond)) : std::nullopt;
    return joint;
}

bool holds_at_least(const JointMaterial& one, const JointMaterial& other) {
    const auto strengths = [](const JointMaterial& joint) {
        const BondMaterial rock = joint.bond.value_or(BondMaterial{});
        return std::array{joint.friction_angle,   joint.residual_friction_angle.value_or(joint.friction_angle),
                          joint.cohesion,         joint.residual_cohesion,
                          joint.tensile_strength, rock.friction_angle,
                          rock.cohesion,          rock.tensile_strength};
    };
    return std::ranges::equal(strengths(one), strengths(other), std::greater_equal());
}

JointMaterial joint_between(const RelaxationScene& scene, const Bodies& bodies, std::size_t edge,
                            std::size_t other_edge) {
    const std::size_t one = bodies.material[edge];
    const std::size_t two = bodies.material[other_edge];
    return one == two ? scene.material[one] : lesser_of(scene.material[one], scene.material[two]);
}

}  // namespace delabole
