// Geometry of a wedge: the block between two planes, face, upper surface and, if there is one, a tension crack.
//
// The notation is as follows. f, u: unit normals of face and upper surface, out of the rock; n1, n2: upward unit
// normals of the planes; i: their line of intersection, plunging. The origin O is the point where the line daylights in
// the face. Rock fills f . x < 0, u . x < u . C1, with C1 the point of the crest on plane 1, given by the height.
//
// The side of each plane on which the wedge lies follows from block theory (Goodman & Shi 1985), as in
// kinematics/criteria.hpp: exactly one block between the planes is finite if the line leaves through the face
// (i . f > 0) and reaches the upper surface (i . u < 0), and the signs s1, s2 with which it lies at sk nk . x >= 0 are
// those of the components of m = f / (i . f) - u / (i . u) along n1 and n2. So either plane may be called plane 1, and
// one may overlie the other. a1 = s1 n1 and a2 = s2 n2 point into the wedge.
//
// Corners. C1, C2: where the planes meet the crest, along n1 x f and n2 x f from O; L: where the line meets the upper
// surface. The crack passes through a point of the trace C1 L. It separates O from L and leaves the crest on O's side;
// otherwise the case is refused. It cuts the edges O L, C1 L, C2 L in E, P1, P2; without a crack all three are L.
//
// Volume and areas are sums of positive tetrahedra and triangles with a corner in O, so that nothing cancels:
//     6 V = |C1 . (C2 x P2)| + |C1 . (P2 x P1)| + |E . (P1 x P2)|.
//
// Accuracy: relative errors of a few rounding errors divided by the sines of the angles between the planes that meet in
// a corner, and by the remaining share of the trace if the crack is near its end.
#pragma once

#include "kinematics/orientation.hpp"
#include "wedge_failure/parameters.hpp"

#include <Eigen/Geometry>

#include <cmath>

namespace delabole {

enum class WedgeFailureCheck {
    valid,
    planes_parallel,                  // to within 1e-9 rad
    line_does_not_daylight,           // the line of intersection is level or does not leave through the face
    line_does_not_surface,            // the line never reaches the ground behind the crest
    upper_surface_steeper_than_face,  // there is no crest
    crest_below_daylight,             // plane 1 meets the crest no higher than the line daylights in the face
    crack_misses_wedge,               // the crack lies behind the wedge, or does not cut the line of intersection
    crack_cuts_face,                  // the crack meets the crest between the planes
    water_needs_crack,                // a pressure is given for a crack, but there is no crack
    friction_not_below_90_deg,        // friction_angle + roughness_angle
    input_out_of_range,               // a number outside the range of its field, or not finite
};

struct WedgeGeometry {
    Direction line;     // unit vector down the line of intersection
    Direction inner_1;  // unit normals of the planes, into the wedge
    Direction inner_2;
    Direction crack_normal;  // unit normal of the crack, out of the wedge; zero without a crack
    Direction crest_1;       // C1
    Direction crest_2;       // C2
    Direction line_top;      // L
    Direction line_end;      // E, and the corners of the crack on the upper surface
    Direction crack_1;       // P1
    Direction crack_2;       // P2
    double volume;
    double area_1;
    double area_2;
    double crack_area;
    double crack_depth;  // vertical depth of E below the upper surface; 0 without a crack
};

namespace detail {

inline double triangle_area(const Direction& a, const Direction& b) {
    return a.cross(b).norm() / 2;
}

inline double six_volumes(const Direction& a, const Direction& b, const Direction& c) {
    return std::abs(a.dot(b.cross(c)));
}

inline WedgeFailureCheck cut_by_crack(const WedgeCrack& crack, WedgeGeometry& wedge) {
    const Direction trace = wedge.line_top - wedge.crest_1;
    const double trace_length = trace.norm();
    if (!(crack.distance < trace_length)) {
        return WedgeFailureCheck::crack_misses_wedge;
    }
    const Direction on_crack = wedge.crest_1 + crack.distance / trace_length * trace;
    Direction normal = upward_normal({crack.dip, crack.dip_direction});
    if (normal.dot(on_crack) < 0) {
        normal = -normal;
    }
    const double reach = normal.dot(on_crack);
    const double behind = normal.dot(wedge.line_top) - reach;
    if (!(reach > 0) || !(behind > 0)) {
        return WedgeFailureCheck::crack_misses_wedge;
    }
    const double before = reach - normal.dot(wedge.crest_2);
    if (before < 0) {
        return WedgeFailureCheck::crack_cuts_face;
    }
    wedge.crack_normal = normal;
    wedge.line_end = reach / (reach + behind) * wedge.line_top;
    wedge.crack_1 = on_crack;
    wedge.crack_2 = wedge.crest_2 + before / (before + behind) * (wedge.line_top - wedge.crest_2);
    return WedgeFailureCheck::valid;
}

}  // namespace detail

// `wedge` is complete if the result is valid.
inline WedgeFailureCheck make_geometry(const WedgeFailure& problem, WedgeGeometry& wedge) {
    const WedgeSlope& slope = problem.slope;
    const Direction face = upward_normal({slope.face_dip, slope.face_dip_direction});
    const Direction upper = upward_normal({slope.upper_surface_dip, slope.upper_surface_dip_direction});
    const Direction normal_1 = upward_normal({problem.plane_1.dip, problem.plane_1.dip_direction});
    const Direction normal_2 = upward_normal({problem.plane_2.dip, problem.plane_2.dip_direction});
    // Directions are accurate to a few rounding errors, which must not let a line in the face daylight.
    constexpr double direction_rounding = 1e-12;
    constexpr double least_angle = 1e-9;

    const Direction axis = normal_1.cross(normal_2);
    if (!(axis.norm() > least_angle)) {
        return WedgeFailureCheck::planes_parallel;
    }
    wedge.line = axis / axis.norm();
    if (wedge.line.z() > 0) {
        wedge.line = -wedge.line;
    }
    const double out_of_face = wedge.line.dot(face);
    const double out_of_upper = wedge.line.dot(upper);
    if (!(wedge.line.z() < -direction_rounding) || !(out_of_face > direction_rounding)) {
        return WedgeFailureCheck::line_does_not_daylight;
    }
    if (!(out_of_upper < -direction_rounding)) {
        return WedgeFailureCheck::line_does_not_surface;
    }
    if (!(upper.z() > upper.dot(face) * face.z())) {
        return WedgeFailureCheck::upper_surface_steeper_than_face;
    }
    const Direction m = face / out_of_face - upper / out_of_upper;
    wedge.inner_1 = m.cross(normal_2).dot(axis) < 0 ? Direction(-normal_1) : normal_1;
    wedge.inner_2 = normal_1.cross(m).dot(axis) < 0 ? Direction(-normal_2) : normal_2;

    // The traces of the planes on the face point away from O, each to the inner side of the other plane.
    Direction trace_1 = normal_1.cross(face);
    Direction trace_2 = normal_2.cross(face);
    if (wedge.inner_2.dot(trace_1) < 0) {
        trace_1 = -trace_1;
    }
    if (wedge.inner_1.dot(trace_2) < 0) {
        trace_2 = -trace_2;
    }
    if (!(trace_1.z() > direction_rounding)) {
        return WedgeFailureCheck::crest_below_daylight;
    }
    wedge.crest_1 = slope.height / trace_1.z() * trace_1;
    const double upper_level = upper.dot(wedge.crest_1);
    const double rise_2 = upper.dot(trace_2);
    if (!(upper_level > 0) || !(rise_2 > 0)) {
        return WedgeFailureCheck::crest_below_daylight;
    }
    wedge.crest_2 = upper_level / rise_2 * trace_2;
    wedge.line_top = upper_level / out_of_upper * wedge.line;
    wedge.crack_normal = Direction::Zero();
    wedge.line_end = wedge.crack_1 = wedge.crack_2 = wedge.line_top;
    if (problem.tension_crack) {
        const WedgeFailureCheck check = detail::cut_by_crack(*problem.tension_crack, wedge);
        if (check != WedgeFailureCheck::valid) {
            return check;
        }
    }
    using detail::six_volumes;
    using detail::triangle_area;
    wedge.volume = (six_volumes(wedge.crest_1, wedge.crest_2, wedge.crack_2) +
                    six_volumes(wedge.crest_1, wedge.crack_2, wedge.crack_1) +
                    six_volumes(wedge.line_end, wedge.crack_1, wedge.crack_2)) /
                   6;
    wedge.area_1 = triangle_area(wedge.crest_1, wedge.crack_1) + triangle_area(wedge.crack_1, wedge.line_end);
    wedge.area_2 = triangle_area(wedge.crest_2, wedge.crack_2) + triangle_area(wedge.crack_2, wedge.line_end);
    wedge.crack_area = triangle_area(wedge.crack_1 - wedge.line_end, wedge.crack_2 - wedge.line_end);
    wedge.crack_depth = problem.tension_crack ? (upper_level - upper.dot(wedge.line_end)) / upper.z() : 0;
    return WedgeFailureCheck::valid;
}

}  // namespace delabole
