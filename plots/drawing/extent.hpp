// The range of a set of finite numbers, and the frame around a set of finite points.
#pragma once

#include "geometry/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

struct Extent {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();

    // Numbers that are not finite are ignored.
    void include(double value) {
        if (std::isfinite(value)) {
            lowest = std::min(lowest, value);
            highest = std::max(highest, value);
        }
    }
    bool empty() const { return lowest > highest; }
    double size() const { return highest - lowest; }
};

struct Frame {
    Extent x;
    Extent y;

    void include(const Point& point) {
        if (point.allFinite()) {
            x.include(point.x());
            y.include(point.y());
        }
    }
    void include(const Polyline& line) {
        for (const Point& point : line) {
            include(point);
        }
    }
    bool empty() const { return x.empty(); }
    Point lowest() const { return {x.lowest, y.lowest}; }
    Point highest() const { return {x.highest, y.highest}; }
    Point size() const { return {x.size(), y.size()}; }
};

}  // namespace delabole
