#include "kinematics/criteria.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace delabole {

namespace {

constexpr double right_angle = std::numbers::pi / 2;

// Directions are known to a few roundings; a plane parallel to the face must not daylight by one of them.
constexpr double direction_rounding = 1e-12;

Orientation face_of(const SlopeOrientation& slope) {
    return {slope.face_dip, slope.face_dip_direction};
}

// Whether a mass that moves along this direction leaves through the face and is cut off by the ground behind the crest.
Feasibility way_out(const SlopeOrientation& slope, const Direction& movement) {
    if (!(movement.dot(upward_normal(face_of(slope))) > direction_rounding)) {
        return Feasibility::does_not_daylight;
    }
    const Orientation upper = slope.upper_surface.value_or(Orientation{0, 0});
    if (!(movement.dot(upward_normal(upper)) < -direction_rounding)) {
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

// Strictly between in plan, on the short way round.
bool between_in_plan(double azimuth, double from, double to) {
    const double whole = azimuth_difference(from, to);
    const double part = azimuth_difference(from, azimuth);
    return part * whole > 0 && std::abs(part) < std::abs(whole) - direction_rounding &&
           std::abs(part) > direction_rounding;
}

SlidingContact contact_of(const SlopeOrientation& slope, const LineOrientation& line, const Orientation& first,
                          const Orientation& second) {
    const double face = slope.face_dip_direction;
    const bool on_first = between_in_plan(first.dip_direction, line.trend, face);
    const bool on_second = between_in_plan(second.dip_direction, line.trend, face);
    if (on_first && on_second) {
        return angle_in_plan(first.dip_direction, face) < angle_in_plan(second.dip_direction, face)
                   ? SlidingContact::first_plane
                   : SlidingContact::second_plane;
    }
    return on_first    ? SlidingContact::first_plane
           : on_second ? SlidingContact::second_plane
                       : SlidingContact::both_planes;
}

// Weight 1 on both planes: across the line i it is carried by normal forces N1, N2 on the planes,
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
    const Feasibility out = way_out(slope, dip_vector(carrier));
    if (out != Feasibility::feasible) {
        return {out, SlidingContact::none, 0, 0};
    }
    return verdict(carrier.dip, carrier.dip);
}

FeasibilityVerdict flexural_toppling(const SlopeOrientation& slope, const Orientation& layers, double friction_angle,
                                     double lateral_limit) {
    const bool vertical = !steeper(right_angle, layers.dip);
    double out_of_slope = azimuth_difference(slope.face_dip_direction, layers.dip_direction + 2 * right_angle);
    if (vertical && std::cos(out_of_slope) < 0) {
        // Vertical layers lean neither way, whichever of their two dip directions was written down.
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
