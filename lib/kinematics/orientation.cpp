#include "kinematics/orientation.hpp"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace delabole {

Direction upward_normal(const Orientation& plane) {
    return {std::sin(plane.dip) * std::sin(plane.dip_direction), std::sin(plane.dip) * std::cos(plane.dip_direction),
            std::cos(plane.dip)};
}

Direction dip_vector(const Orientation& plane) {
    return direction_of({plane.dip, plane.dip_direction});
}

Direction direction_of(const LineOrientation& line) {
    return {std::cos(line.plunge) * std::sin(line.trend), std::cos(line.plunge) * std::cos(line.trend),
            -std::sin(line.plunge)};
}

Direction downward(const Direction& axis) {
    return axis.z() > 0 ? Direction(-axis) : axis;
}

Orientation plane_with_normal(const Direction& normal) {
    const Direction up = normal.z() < 0 ? Direction(-normal) : normal;
    const double horizontal = std::hypot(up.x(), up.y());
    return {std::atan2(horizontal, up.z()), horizontal > 0 ? wrapped_azimuth(std::atan2(up.x(), up.y())) : 0};
}

LineOrientation line_along(const Direction& axis) {
    const Direction down = downward(axis);
    const double horizontal = std::hypot(down.x(), down.y());
    // With -down.z() a horizontal line would plunge -0 instead of 0.
    return {std::atan2(std::abs(down.z()), horizontal),
            horizontal > 0 ? wrapped_azimuth(std::atan2(down.x(), down.y())) : 0};
}

double azimuth_difference(double from, double to) {
    return std::remainder(to - from, 2 * std::numbers::pi);
}

double wrapped_azimuth(double azimuth) {
    constexpr double turn = 2 * std::numbers::pi;
    const double wrapped = std::fmod(azimuth, turn);
    const double positive = wrapped < 0 ? wrapped + turn : wrapped;
    // Rounding turns a minute negative azimuth into the whole turn.
    return positive < turn ? positive : 0;
}

double apparent_dip(const Orientation& plane, double azimuth) {
    return std::atan2(std::sin(plane.dip) * std::cos(azimuth - plane.dip_direction), std::cos(plane.dip));
}

std::optional<LineOrientation> intersection(const Orientation& first, const Orientation& second) {
    const Direction line = upward_normal(first).cross(upward_normal(second));
    constexpr double parallel = 1e-9;
    if (!(line.norm() > parallel)) {
        return {};
    }
    return line_along(line);
}

}  // namespace delabole
