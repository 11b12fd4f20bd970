#include "plots/drawing/polygon.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace delabole {

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

Polyline closed(Polyline outline) {
    if (!outline.empty()) {
        outline.push_back(outline.front());
    }
    return outline;
}

Polyline raised(Polyline line, double height) {
    for (Point& point : line) {
        point.y() += height;
    }
    return line;
}

Polyline clipped(const Polyline& outline, const Rectangle& rectangle) {
    const std::array corners{rectangle.lowest, Point(rectangle.highest.x(), rectangle.lowest.y()), rectangle.highest,
                             Point(rectangle.lowest.x(), rectangle.highest.y())};
    Polyline part = outline;
    for (std::size_t index = 0; index < corners.size(); ++index) {
        part = clip(part, HalfPlane<>{corners[index], corners[(index + 1) % corners.size()]});
    }
    return part;
}

bool crosses(const Rectangle& rectangle, const Point& from, const Point& to) {
    double enters = 0;
    double leaves = 1;
    for (const int axis : {0, 1}) {
        const double run = to[axis] - from[axis];
        if (run == 0) {
            if (from[axis] < rectangle.lowest[axis] || from[axis] > rectangle.highest[axis]) {
                return false;
            }
            continue;
        }
        const double first = (rectangle.lowest[axis] - from[axis]) / run;
        const double second = (rectangle.highest[axis] - from[axis]) / run;
        enters = std::max(enters, std::min(first, second));
        leaves = std::min(leaves, std::max(first, second));
    }
    return enters <= leaves;
}

bool crosses(const Rectangle& rectangle, const Polyline& line) {
    for (std::size_t index = 1; index < line.size(); ++index) {
        if (crosses(rectangle, line[index - 1], line[index])) {
            return true;
        }
    }
    return false;
}

}  // namespace delabole
