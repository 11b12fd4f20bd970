// Simple polygons in the section plane: area, centroid, second moment, cutting.
//
// Closed chains without repetition of the first vertex, anticlockwise for positive area. Exact up to rounding: vertices
// are taken relative to the first one, so that even for a sliver far from the origin only the rounding of its own
// coordinates matters. Any scalar (double; more digits in tests). Formulas: Green's theorem over the triangles that
// each edge makes with the first vertex.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace delabole {

template <class T = double>
using PlanePoint = Eigen::Matrix<T, 2, 1>;

template <class T = double>
using Polygon = std::vector<PlanePoint<T>>;

// Positive where b points to the left of a.
inline double cross(const PlanePoint<>& a, const PlanePoint<>& b) {
    return a.x() * b.y() - a.y() * b.x();
}
inline PlanePoint<> left_of(const PlanePoint<>& along) {
    return {-along.y(), along.x()};
}

template <class T = double>
struct AreaProperties {
    T area;                  // m2, negative for clockwise polygons
    PlanePoint<T> centroid;  // of a polygon without area: the mean of its vertices; without vertices: zero
    T polar_second_moment;   // m4, about the centroid, with the sign of the area
};

template <class T>
AreaProperties<T> area_properties(const Polygon<T>& polygon) {
    if (polygon.empty()) {
        return {T(0), PlanePoint<T>(T(0), T(0)), T(0)};
    }
    const T x0 = polygon.front().x();
    const T y0 = polygon.front().y();
    T twice_area(0);
    T moment_x(0);
    T moment_y(0);
    T polar(0);
    T sum_x(0);
    T sum_y(0);
    for (std::size_t index = 1; index < polygon.size(); ++index) {
        const T ax = polygon[index - 1].x() - x0;
        const T ay = polygon[index - 1].y() - y0;
        const T bx = polygon[index].x() - x0;
        const T by = polygon[index].y() - y0;
        const T cross = ax * by - bx * ay;
        twice_area += cross;
        moment_x += cross * (ax + bx);
        moment_y += cross * (ay + by);
        polar += cross * (ax * ax + ax * bx + bx * bx + ay * ay + ay * by + by * by);
        sum_x += bx;
        sum_y += by;
    }
    const T count(static_cast<double>(polygon.size()));
    if (twice_area == 0) {
        return {T(0), PlanePoint<T>(T(x0 + sum_x / count), T(y0 + sum_y / count)), T(0)};
    }
    const T x = moment_x / (3 * twice_area);
    const T y = moment_y / (3 * twice_area);
    const T area = twice_area / 2;
    return {area, PlanePoint<T>(T(x0 + x), T(y0 + y)), T(polar / 12 - area * (x * x + y * y))};
}

// Points on the line from `from` to `to` and to the left of it.
template <class T = double>
struct HalfPlane {
    PlanePoint<T> from;
    PlanePoint<T> to;

    // Twice the area of the triangle from, to, point: positive to the left.
    T side(const PlanePoint<T>& point) const {
        return T((to.x() - from.x()) * (point.y() - from.y()) - (to.y() - from.y()) * (point.x() - from.x()));
    }
};

template <class T = double>
struct SplitPolygon {
    Polygon<T> left;
    Polygon<T> right;
};

// The two parts of a polygon; either may be empty. Both have the same points of intersection, so that no area is lost
// or counted twice. Parts of a polygon that is not convex may be joined along the line by edges that enclose no area:
// area, centroid and second moment remain correct.
template <class T>
SplitPolygon<T> split(const Polygon<T>& polygon, const HalfPlane<T>& line) {
    SplitPolygon<T> parts;
    for (std::size_t index = 0; index < polygon.size(); ++index) {
        const PlanePoint<T>& start = polygon[index];
        const PlanePoint<T>& end = polygon[index + 1 < polygon.size() ? index + 1 : 0];
        const T start_side = line.side(start);
        const T end_side = line.side(end);
        if (start_side >= 0) {
            parts.left.push_back(start);
        }
        if (start_side <= 0) {
            parts.right.push_back(start);
        }
        if ((start_side > 0 && end_side < 0) || (start_side < 0 && end_side > 0)) {
            const T position = start_side / (start_side - end_side);
            const PlanePoint<T> crossing(T(start.x() + position * (end.x() - start.x())),
                                         T(start.y() + position * (end.y() - start.y())));
            parts.left.push_back(crossing);
            parts.right.push_back(crossing);
        }
    }
    // A part that only touches the line has no area.
    for (Polygon<T>* part : {&parts.left, &parts.right}) {
        const bool inside =
            std::any_of(part->begin(), part->end(), [&](const PlanePoint<T>& point) { return line.side(point) != 0; });
        if (part->size() < 3 || !inside) {
            part->clear();
        }
    }
    return parts;
}

// Determined from the number of edges to the right of the point. For a point on an edge the answer may be either.
inline bool inside(const Polygon<>& polygon, const PlanePoint<>& point) {
    bool result = false;
    for (std::size_t index = 0; index < polygon.size(); ++index) {
        const PlanePoint<>& from = polygon[index];
        const PlanePoint<>& to = polygon[(index + 1) % polygon.size()];
        if ((from.y() > point.y()) != (to.y() > point.y()) &&
            point.x() < from.x() + (to.x() - from.x()) * (point.y() - from.y()) / (to.y() - from.y())) {
            result = !result;
        }
    }
    return result;
}

// Whether two edges cross. Those that only touch do not.
inline bool crosses_itself(const Polygon<>& polygon) {
    const auto edge = [&](std::size_t index) {
        return HalfPlane<>{polygon[index], polygon[(index + 1) % polygon.size()]};
    };
    const auto divides = [](const HalfPlane<>& line, const HalfPlane<>& other) {
        const double from = line.side(other.from);
        const double to = line.side(other.to);
        return (from > 0 && to < 0) || (from < 0 && to > 0);
    };
    for (std::size_t one = 0; one < polygon.size(); ++one) {
        for (std::size_t other = 0; other < one; ++other) {
            if (divides(edge(one), edge(other)) && divides(edge(other), edge(one))) {
                return true;
            }
        }
    }
    return false;
}

// The part of a polygon in a half-plane; empty if there is none.
template <class T>
Polygon<T> clip(const Polygon<T>& polygon, const HalfPlane<T>& half_plane) {
    return split(polygon, half_plane).left;
}

}  // namespace delabole
