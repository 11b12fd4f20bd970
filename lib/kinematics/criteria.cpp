#include "kinematics/criteria.hpp"

#include "numerics/constants.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

// Directions are accurate to a few rounding errors, which must not let a plane parallel to the face daylight.
constexpr double direction_rounding = 1e-12;

Orientation face_of(const SlopeOrientation& slope) {
    return {slope.face_dip, slope.face_dip_direction};
}

Orientation upper_surface_of(const SlopeOrientation& slope) {
    return slope.upper_surface.value_or(Orientation{0, 0});
}

// Whether a mass that moves in this direction leaves through the face and is cut off by the ground behind the crest.
Feasibility way_out(const SlopeOrientation& slope, const Direction& movement) {
    if (!(movement.dot(upward_normal(face_of(slope))) > direction_rounding)) {
        return Feasibility::does_not_daylight;
    }
    if (!(movement.dot(upward_normal(upper_surface_of(slope))) < -direction_rounding)) {
        return Feasibility::does_not_surface;
    }
    return Feasibility::feasible;
}

bool steeper(double inclination, double limit) {
    return inclination > limit + direction_rounding;
}

double angle_in_plan(double first_azimuth, double second_azimuth) {
    return std::abs(azimuth_difference(first_azimuth, second_azimuth));
}

// The sliding contact for a line that leaves through the face and is cut off behind the crest. Notation: see the
// header.
SlidingContact contact_of(const SlopeOrientation& slope, const LineOrientation& line, const Orientation& first,
                          const Orientation& second) {
    const Direction along = direction_of(line);
    const Direction face = upward_normal(face_of(slope));
    const Direction upper = upward_normal(upper_surface_of(slope));
    const Direction out_of_rock = (face / along.dot(face) - upper / along.dot(upper)).normalized();
    const Direction n1 = upward_normal(first);
    const Direction n2 = upward_normal(second);
    const Direction axis = n1.cross(n2);
    const double first_side = out_of_rock.cross(n2).dot(axis);
    const double second_side = n1.cross(out_of_rock).dot(axis);
    // Beside a plane that dips as the face does the block lies on neither side: that plane may carry it.
    const auto is_above = [](double side) { return side > -direction_rounding; };
    const auto carries = [&](double own_side, double movement_from_other, double other_side) {
        return is_above(own_side) &&
               (is_above(other_side) ? movement_from_other : -movement_from_other) > direction_rounding;
    };
    if (carries(first_side, dip_vector(first).dot(n2), second_side)) {
        return SlidingContact::first_plane;
    }
    return carries(second_side, dip_vector(second).dot(n1), first_side) ? SlidingContact::second_plane
                                                                        : SlidingContact::both_planes;
}

// Unit weight on both planes: across the line i normal forces N1, N2 on the planes carry it,
//     (1 - i i) g + N1 m1 + N2 m2 = 0;   along it  g . i = tan(friction) (N1 + N2).
// The signs of m1, m2 follow from the block's side of each plane; the magnitudes of N1, N2 do not depend on them.
double limiting_friction_on_both(const LineOrientation& line, const Orientation& first, const Orientation& second) {
    const Direction along = direction_of(line);
    const Direction normals[] = {upward_normal(first), upward_normal(second)};
    const double sine = normals[0].cross(normals[1]).norm();
    const Direction across = Direction(0, 0, -1) + along.z() * along;
    const double first_force = std::abs(across.dot(normals[1].cross(along))) / sine;
    const double second_force = std::abs(across.dot(normals[0].cross(along))) / sine;
    return std::atan2(-along.z(), first_force + second_force);
}

}  // namespace

FeasibilityVerdict planar_sliding(const SlopeOrientation& slope, const Orientation& plane, double friction_angle,
                                  double lateral_limit) {
    if (!steeper(plane.dip, 0)) {
        return {Feasibility::flatter_than_friction, 0};
    }
    const Feasibility out = way_out(slope, dip_vector(plane));
    if (out != Feasibility::feasible) {
        return {out, 0};
    }
    if (steeper(angle_in_plan(plane.dip_direction, slope.face_dip_direction), lateral_limit)) {
        return {Feasibility::outside_lateral_limit, 0};
    }
    return {steeper(plane.dip, friction_angle) ? Feasibility::feasible : Feasibility::flatter_than_friction, plane.dip};
}

WedgeVerdict wedge_sliding(const SlopeOrientation& slope, const Orientation& first, const Orientation& second,
                           double friction_angle) {
    const std::optional<LineOrientation> line = intersection(first, second);
    if (!line) {
        return {Feasibility::planes_parallel, SlidingContact::none, 0, 0};
    }
    if (!steeper(line->plunge, 0)) {
        return {Feasibility::flatter_than_friction, SlidingContact::none, 0, 0};
    }
    const Feasibility line_out = way_out(slope, direction_of(*line));
    if (line_out != Feasibility::feasible) {
        return {line_out, SlidingContact::none, 0, 0};
    }
    const SlidingContact contact = contact_of(slope, *line, first, second);
    const auto verdict = [&](double inclination, double limiting) {
        return WedgeVerdict{
            steeper(inclination, friction_angle) ? Feasibility::feasible : Feasibility::flatter_than_friction, contact,
            inclination, limiting};
    };
    if (contact == SlidingContact::both_planes) {
        return verdict(line->plunge, limiting_friction_on_both(*line, first, second));
    }
    const Orientation& carrier = contact == SlidingContact::first_plane ? first : second;
    return verdict(carrier.dip, carrier.dip);
}

FeasibilityVerdict flexural_toppling(const SlopeOrientation& slope, const Orientation& layers, double friction_angle,
                                     double lateral_limit) {
    const bool vertical = !steeper(right_angle, layers.dip);
    double out_of_slope = azimuth_difference(slope.face_dip_direction, layers.dip_direction + 2 * right_angle);
    if (vertical && std::cos(out_of_slope) < 0) {
        // Vertical layers lean neither way, whichever of their two dip directions is given.
        out_of_slope = azimuth_difference(slope.face_dip_direction, layers.dip_direction);
    }
    if (!(std::cos(out_of_slope) > direction_rounding) || !steeper(layers.dip, 0)) {
        return {Feasibility::does_not_dip_into_slope, 0};
    }
    if (steeper(std::abs(out_of_slope), lateral_limit)) {
        return {Feasibility::outside_lateral_limit, 0};
    }
    const double normal_plunge = std::atan2(std::cos(layers.dip), std::sin(layers.dip) * std::cos(out_of_slope));
    const double critical = std::max(0.0, slope.face_dip - normal_plunge);
    return {steeper(critical, friction_angle) ? Feasibility::feasible : Feasibility::no_slip_between_layers, critical};
}

Feasibility toppling_axis(const SlopeOrientation& slope, const LineOrientation& axis, double friction_angle,
                          double lateral_limit) {
    if (!steeper(axis.plunge, 0)) {
        return Feasibility::too_flat_to_topple;
    }
    // A vertical column leans neither way.
    const bool vertical = !steeper(right_angle, axis.plunge);
    const double into_slope = angle_in_plan(axis.trend, slope.face_dip_direction + 2 * right_angle);
    if (!vertical && !steeper(right_angle, into_slope)) {
        return Feasibility::does_not_dip_into_slope;
    }
    if (steeper(axis.plunge, right_angle - friction_angle)) {
        return Feasibility::feasible;
    }
    if (steeper(into_slope, lateral_limit)) {
        return Feasibility::outside_lateral_limit;
    }
    return steeper(axis.plunge, right_angle - slope.face_dip) ? Feasibility::feasible : Feasibility::too_flat_to_topple;
}

Feasibility toppling_base(const SlopeOrientation& slope, const Orientation& base, double friction_angle,
                          double lateral_limit) {
    if (steeper(friction_angle, base.dip)) {
        return Feasibility::feasible;
    }
    const double out_of_slope = angle_in_plan(base.dip_direction, slope.face_dip_direction);
    if (!(out_of_slope < right_angle)) {
        return Feasibility::base_steeper_than_friction;
    }
    if (steeper(out_of_slope, lateral_limit)) {
        return Feasibility::outside_lateral_limit;
    }
    const bool daylights = dip_vector(base).dot(upward_normal(face_of(slope))) > direction_rounding;
    return daylights ? Feasibility::feasible : Feasibility::does_not_daylight;
}

}  // namespace delabole
