// Outlines and lines, used to find room for a text in or beside them. Outlines need not repeat their first point.
#pragma once

#include "geometry/polygon.hpp"
#include "geometry/polyline.hpp"

namespace delabole {

// Length of the horizontal (axis 0) or vertical (axis 1) chord of a polygon through a point; 0 outside.
double chord(const Polyline& outline, const Point& through, int axis);

// The outline with its first point repeated.
Polyline closed(Polyline outline);

// The line, moved upwards.
Polyline raised(Polyline line, double height);

struct Rectangle {
    Point lowest;
    Point highest;
};

// The part of an outline within a rectangle; empty if there is none.
Polyline clipped(const Polyline& outline, const Rectangle& rectangle);

bool crosses(const Rectangle& rectangle, const Point& from, const Point& to);
bool crosses(const Rectangle& rectangle, const Polyline& line);

}  // namespace delabole
