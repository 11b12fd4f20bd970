// Where a text finds room in a polygon. Outlines need not repeat their first point.
#pragma once

#include "geometry/polygon.hpp"
#include "geometry/polyline.hpp"

namespace delabole {

// Of the area; of the corners where there is no area. At least one corner.
Point centroid(const Polyline& outline);

// Length of the level (axis 0) or upright (axis 1) chord of a polygon through a point; 0 outside.
double chord(const Polyline& outline, const Point& through, int axis);

}  // namespace delabole
