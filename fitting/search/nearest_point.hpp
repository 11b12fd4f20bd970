// The point nearest to the origin at which a function is zero, by NLopt: the design point of first-order reliability.
//
// Sequential quadratic programming (SLSQP) on  min |u|^2 / 2  with  g(u) = 0,  gradients by central differences; where
// that does not end at a point that passes the check below, as it may where g has a kink, once more by COBYLA from the
// best point found. Sources: D. Kraft, DFVLR-FB 88-28 (1988); M. J. D. Powell, Acta Numerica 7 (1998) 287-336; S. G.
// Johnson, The NLopt nonlinear-optimization package, version 2.7.1.
#pragma once

#include "fitting/search/minimise.hpp"

#include <concepts>
#include <span>
#include <tuple>
#include <type_traits>
#include <vector>

namespace delabole {

struct NearestPointSettings {
    double step = 1e-3;        // of the differences; larger than the noise of g over its slope
    double tolerance = 1e-4;   // of the distance
    double search_radius = 8;  // no coordinate leaves it
    long evaluations = 2000;   // cap
};

struct NearestPoint {
    bool converged = false;         // off the surface by less than the tolerance, and normal to it within 0.03
    std::vector<double> point;      // empty where no evaluation at a point of the surface succeeded
    std::vector<double> direction;  // unit vector along which g falls, at the point
    double distance = 0;
    double off_surface = 0;   // |g| over its slope
    double misalignment = 0;  // sine of the angle between the point's radius and the direction
    EvaluationCount evaluations;
};

// Needed by share_tasks.
template <class Type>
requires std::same_as<std::remove_const_t<Type>, NearestPoint>
auto members_of(Type& found) {
    return std::tie(found.converged, found.point, found.direction, found.distance, found.off_surface,
                    found.misalignment, found.evaluations);
}

// g(u) is a margin: positive on the side of the origin or not, in any unit. A failed evaluation counts as a wall.
NearestPoint nearest_point(const Objective& g, std::span<const double> start, const NearestPointSettings& settings,
                           StopFlag stop = nullptr);

}  // namespace delabole
