#include "dynamic_relaxation/step/base_friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace delabole {

namespace {

struct QuadraturePoint {
    double first;   // barycentric weight of the corner at the edge's start
    double second;  // weight of the corner at its end; the centroid has the rest
    double weight;
};

// Radon (1948), degree 5.
const std::array<QuadraturePoint, 7>& triangle_rule() {
    static const std::array<QuadraturePoint, 7> rule = [] {
        const double root = std::sqrt(15.0);
        const double near = (6 - root) / 21;
        const double far = (6 + root) / 21;
        const double of_near = (155 - root) / 1200;
        const double of_far = (155 + root) / 1200;
        return std::array<QuadraturePoint, 7>{{{1.0 / 3, 1.0 / 3, 9.0 / 40},
                                               {near, near, of_near},
                                               {near, 1 - 2 * near, of_near},
                                               {1 - 2 * near, near, of_near},
                                               {far, far, of_far},
                                               {far, 1 - 2 * far, of_far},
                                               {1 - 2 * far, far, of_far}}};
    }();
    return rule;
}

// Mean over the block's area of the square of the distance from its centroid along a direction.
double mean_square_along(const Bodies& bodies, std::size_t block, const Motion& motion, const PlanePoint<>& direction) {
    // The direction is rotated back to section axes.
    const PlanePoint<> back((1 - motion.versine) * direction.x() + motion.sine * direction.y(),
                            (1 - motion.versine) * direction.y() - motion.sine * direction.x());
    double twice_area = 0;
    double sum = 0;
    const CornerRange& range = bodies.range[block];
    for (std::size_t corner = range.begin; corner < range.end; ++corner) {
        const PlanePoint<>& first = bodies.corner[corner];
        const PlanePoint<>& second = bodies.corner[range.after(corner)];
        const double triangle = first.x() * second.y() - first.y() * second.x();
        const double from = back.dot(first);
        const double to = back.dot(second);
        twice_area += triangle;
        sum += triangle * (from * from + from * to + to * to);
    }
    return sum / (6 * twice_area);
}

}  // namespace

BlockForce belt_drag(const Belt& belt, const PlanePoint<>& belt_velocity, double weight, const Bodies& bodies,
                     std::size_t block, const Motion& motion) {
    const double friction = std::tan(belt.friction_angle) * weight;
    const double slowest = belt_creep * belt.speed;
    const double x = belt_velocity.x() - motion.vx;
    const double y = belt_velocity.y() - motion.vy;
    if (motion.spin == 0) {
        const double share = friction / std::max(std::sqrt(x * x + y * y), slowest);
        return {share * x, share * y, 0};
    }
    const double speed = std::sqrt(x * x + y * y);
    // A rotation that adds less than this share of the speed changes the resultant only by the square of that share,
    // and the moment is linear in it. This avoids the quadrature for most blocks of a slope most of the time.
    constexpr double slow_turning = 1e-3;
    if (speed > 2 * slowest && std::abs(motion.spin) * bodies.radius[block] < slow_turning * speed) {
        const double share = friction / speed;
        const PlanePoint<> direction(x / speed, y / speed);
        return {share * x, share * y, -share * motion.spin * mean_square_along(bodies, block, motion, direction)};
    }
    double twice_area = 0;
    BlockForce sum;
    const CornerRange& range = bodies.range[block];
    for (std::size_t corner = range.begin; corner < range.end; ++corner) {
        const PlanePoint<> first = motion.turned(bodies.corner[corner]);
        const PlanePoint<> second = motion.turned(bodies.corner[range.after(corner)]);
        const double triangle = first.x() * second.y() - first.y() * second.x();
        twice_area += triangle;
        for (const QuadraturePoint& point : triangle_rule()) {
            const double arm_x = point.first * first.x() + point.second * second.x();
            const double arm_y = point.first * first.y() + point.second * second.y();
            const double past_x = x + motion.spin * arm_y;
            const double past_y = y - motion.spin * arm_x;
            const double share =
                triangle * point.weight / std::max(std::sqrt(past_x * past_x + past_y * past_y), slowest);
            sum.x += share * past_x;
            sum.y += share * past_y;
            sum.moment += share * (arm_x * past_y - arm_y * past_x);
        }
    }
    const double per_area = friction / twice_area;
    return {per_area * sum.x, per_area * sum.y, per_area * sum.moment};
}

double longest_step(const Belt& belt, const Gravity& gravity) {
    // Half of the step in which a creeping block would reach the belt's speed.
    return belt_creep * belt.speed / (2 * std::tan(belt.friction_angle) * gravity.acceleration);
}

}  // namespace delabole
