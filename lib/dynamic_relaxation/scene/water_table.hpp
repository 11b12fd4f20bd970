// Water table of a jointed slope: straight from point to point, level beyond its ends. Pressure below it grows with the
// depth, measured vertically in the section. Along a straight face the depth is linear from each kink of the table to
// the next, and zero where the face is above it: integrated piece by piece, force and moment on a face are exact to
// rounding.
#pragma once

#include "geometry/polygon.hpp"
#include "jointed_slope/slope_geometry.hpp"

#include <vector>

namespace delabole {

// Elevation y, m, of a table of at least one point, x increasing.
double water_table_height(const std::vector<SectionPoint>& table, double x);

struct FaceDepth {
    double place;  // m along the face from its start, increasing
    double depth;  // m below the table, at least 0, linear from each place to the next
};

// Depths from the start of a straight face to its end. The two points must not coincide.
std::vector<FaceDepth> depths_along(const std::vector<SectionPoint>& table, const PlanePoint<>& start,
                                    const PlanePoint<>& end);

}  // namespace delabole
