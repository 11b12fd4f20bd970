// Outlines and lines: where a text finds room in or beside them. Outlines need not repeat their first point.
#pragma once

#include "geometry/polygon.hpp"
#include "geometry/polyline.hpp"

namespace delabole {

// Length of the level (axis 0) or upright (axis 1) chord of a polygon through a point; 0 outside.
double chord(const Polyline& outline, const Point& through, int axis);

// The outline with its first point repeated.
Polyline closed(Polyline outline);

// The line moved up.
Polyline raised(Polyline line, double height);

struct Rectangle {
    Point lowest;
    Point highest;
};

bool crosses(const Rectangle& rectangle, const Point& from, const Point& to);
bool crosses(const Rectangle& rectangle, const Polyline& line);

}  // namespace delabole
