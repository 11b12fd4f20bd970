// The point nearest to the origin at which a function is zero, found by NLopt: the design point of first-order
// reliability.
//
// Sequential quadratic programming (SLSQP) on  min |u|^2 / 2  with  g(u) = 0,  gradients by central differences. If the
// end point does not pass the check below, which can happen where g has a kink, COBYLA continues from the best point
// found. Sources: D. Kraft, DFVLR-FB 88-28 (1988); M. J. D. Powell, Acta Numerica 7 (1998) 287-336; S. G. Johnson, The
// NLopt nonlinear-optimization package, version 2.7.1.
#pragma once

#include "fitting/search/minimise.hpp"
#include "numerics/archive.hpp"

#include <span>
#include <vector>

namespace delabole {

struct NearestPointSettings {
    double step = 1e-3;        // of the differences; larger than the noise of g divided by its slope
    double tolerance = 1e-4;   // of the distance
    double search_radius = 8;  // bound of the absolute value of each coordinate
    long evaluations = 2000;   // cap
};

struct NearestPoint {
    bool converged = false;         // within the tolerance of the surface, and normal to it within 0.03
    std::vector<double> point;      // empty where no point of the surface could be evaluated
    std::vector<double> direction;  // unit vector along which g decreases at the point
    double distance = 0;
    double off_surface = 0;   // |g| divided by its slope
    double misalignment = 0;  // sine of the angle between the point's radius and the direction
    EvaluationCount evaluations;
};

// Used by share_tasks.
DELABOLE_MEMBERS(NearestPoint, converged, point, direction, distance, off_surface, misalignment, evaluations)

// g(u) is a margin in any unit; its sign at the origin does not matter. A failed evaluation counts as a great value of
// g.
NearestPoint nearest_point(const Objective& g, std::span<const double> start, const NearestPointSettings& settings,
                           StopFlag stop = nullptr);

}  // namespace delabole
