// Water pressures along the surfaces of a sliding mass, for drawing and for checking resultants against them.
#pragma once

#include "geometry/polyline.hpp"
#include "plane_failure/parameters.hpp"

#include <vector>

namespace delabole {

// Points of a surface in the axes of the section (origin at the toe), from its lower to its upper end, with the
// pressure in Pa at each. Pressures are linear between points.
struct SurfacePressure {
    Polyline surface;
    std::vector<double> pressure;
};

struct WaterDiagram {
    SurfacePressure base;
    SurfacePressure crack;    // empty without a crack
    Polyline water_in_crack;  // the part of the crack below the water level; empty if it is dry
};

// Surfaces are empty if the problem is not valid.
WaterDiagram water_diagram(const PlaneFailure<>& problem);

}  // namespace delabole
