#include "geometry/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

double length(const Polyline& line) {
    double total = 0;
    for (std::size_t index = 1; index < line.size(); ++index) {
        total += (line[index] - line[index - 1]).norm();
    }
    return total;
}

double signed_distance(const Polyline& line, const Point& point) {
    double nearest_squared = std::numeric_limits<double>::infinity();
    double side = 0;
    for (std::size_t index = 1; index < line.size(); ++index) {
        const Point along = line[index] - line[index - 1];
        const double length_squared = along.squaredNorm();
        if (length_squared == 0) {
            continue;
        }
        const Point offset = point - line[index - 1];
        const double position = std::clamp(offset.dot(along) / length_squared, 0.0, 1.0);
        // Beyond an end the distance is to the given vertex, so that both segments which share it give the same number.
        const Point away = position < 1 ? Point(offset - position * along) : Point(point - line[index]);
        const double distance_squared = away.squaredNorm();
        const double cross = (along.x() * offset.y() - along.y() * offset.x()) / std::sqrt(length_squared);
        // At a shared vertex two segments are equally near: the one with the greater normal distance determines the
        // side.
        const bool tie = distance_squared == nearest_squared && std::abs(cross) > std::abs(side);
        if (distance_squared < nearest_squared || tie) {
            nearest_squared = distance_squared;
            side = cross;
        }
    }
    if (std::isinf(nearest_squared)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return std::copysign(std::sqrt(nearest_squared), side);
}

double rms_distance(std::span<const Point> line, const Point& from, const Point& to) {
    const Point along = to - from;
    const double whole = along.norm();
    if (line.empty() || whole == 0) {
        return 0;
    }
    const auto distance = [&](const Point& point) {
        return (along.x() * (point.y() - from.y()) - along.y() * (point.x() - from.x())) / whole;
    };
    double squares = 0;
    double length = 0;
    double before = distance(line.front());
    for (std::size_t index = 1; index < line.size(); ++index) {
        const double after = distance(line[index]);
        const double stretch = (line[index] - line[index - 1]).norm();
        squares += stretch * (before * before + before * after + after * after) / 3;
        length += stretch;
        before = after;
    }
    return length > 0 ? std::sqrt(squares / length) : 0;
}

Polyline resample(const Polyline& line, std::size_t count) {
    const double total = length(line);
    if (count < 2 || !(total > 0)) {
        return {};
    }
    Polyline points;
    points.reserve(count);
    std::size_t segment = 1;
    double passed = 0;
    for (std::size_t index = 0; index < count; ++index) {
        const double target = total * static_cast<double>(index) / static_cast<double>(count - 1);
        double segment_length = (line[segment] - line[segment - 1]).norm();
        while (segment + 1 < line.size() && passed + segment_length < target) {
            passed += segment_length;
            ++segment;
            segment_length = (line[segment] - line[segment - 1]).norm();
        }
        const double position = segment_length > 0 ? std::clamp((target - passed) / segment_length, 0.0, 1.0) : 0.0;
        points.push_back(line[segment - 1] + position * (line[segment] - line[segment - 1]));
    }
    points.back() = line.back();
    return points;
}

}  // namespace delabole
