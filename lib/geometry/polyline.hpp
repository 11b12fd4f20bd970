// Open chains of straight segments in the section plane, metres.
#pragma once

#include <Eigen/Core>

#include <span>
#include <vector>

namespace delabole {

using Point = Eigen::Vector2d;
using Polyline = std::vector<Point>;

// Length along the chain; 0 for fewer than two points.
double length(const Polyline& line);

// Shortest distance from a point to the chain, positive if the point lies to the left of the nearest segment in the
// direction from the first to the last point, negative to the right. The chain needs at least two distinct points; NaN
// otherwise.
double signed_distance(const Polyline& line, const Point& point);

// Root mean square distance of a chain from the straight line through two points, each part of the chain weighted by
// its length. 0 for a chain without length, and where the two points coincide.
double rms_distance(std::span<const Point> line, const Point& from, const Point& to);

// `count` points equally spaced along the chain, ends included. Empty unless count >= 2 and the chain has at least two
// distinct points.
Polyline resample(const Polyline& line, std::size_t count);

}  // namespace delabole
