#include "plots/polygon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

double cross(const Point& first, const Point& second) {
    return first.x() * second.y() - first.y() * second.x();
}

}  // namespace

Point centroid(const Polyline& outline) {
    Point weighted{0, 0};
    Point sum{0, 0};
    double twice_area = 0;
    for (std::size_t index = 0; index < outline.size(); ++index) {
        const Point from = outline[index] - outline.front();
        const Point to = outline[(index + 1) % outline.size()] - outline.front();
        twice_area += cross(from, to);
        weighted += cross(from, to) * (from + to);
        sum += from;
    }
    return outline.front() +
           (twice_area != 0 ? Point(weighted / (3 * twice_area)) : Point(sum / static_cast<double>(outline.size())));
}

double chord(const Polyline& outline, const Point& through, int axis) {
    double before = -std::numeric_limits<double>::infinity();
    double after = std::numeric_limits<double>::infinity();
    for (std::size_t index = 0; index < outline.size(); ++index) {
        const Point from = outline[index] - through;
        const Point to = outline[(index + 1) % outline.size()] - through;
        if ((from[1 - axis] < 0) == (to[1 - axis] < 0)) {
            continue;
        }
        const double at = from[axis] - from[1 - axis] * (to[axis] - from[axis]) / (to[1 - axis] - from[1 - axis]);
        (at < 0 ? before : after) = at < 0 ? std::max(before, at) : std::min(after, at);
    }
    return std::isfinite(after - before) ? after - before : 0;
}

}  // namespace delabole
