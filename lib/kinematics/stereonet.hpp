// The stereonet: projections of the lower hemisphere, curves on it, and the density of poles.
//
// Points of the net: x to the east, y to the north, primitive circle of radius 1.
// With t the angle from the downward vertical, the radius is
//     equal area (Schmidt, Lambert's azimuthal projection)  sqrt(2) sin(t / 2),
//     equal angle (Wulff, stereographic projection)         tan(t / 2).
// Directions somewhat above the horizontal lie outside the primitive, so that curves may cross it and be cut there.
// Exact to rounding.
#pragma once

#include "geometry/polyline.hpp"
#include "kinematics/orientation.hpp"
#include "kinematics/parameters.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <vector>

namespace delabole {

enum class NetProjection { equal_area, equal_angle };

// The image of a direction, upward or downward; the upward vertical has no image on the equal-angle net, and its image
// on the equal-area net is a whole circle.
Point projected(const Direction& direction, NetProjection projection);

// The inverse; equal-area points lie within sqrt(2) of the centre.
Direction direction_at(const Point& point, NetProjection projection);

Point projected_pole(const Orientation& plane, NetProjection projection);
Point projected_line(const LineOrientation& line, NetProjection projection);

// Curves have `count` points, count >= 2.

// The plane itself, from strike to strike.
Polyline great_circle(const Orientation& plane, NetProjection projection, std::size_t count = 181);

// Lines of one plunge all around, closed. Poles of planes of dip d plunge 90 deg - d.
Polyline plunge_circle(double plunge, NetProjection projection, std::size_t count = 181);

// Poles of the planes whose dip vector lies in the face, from strike to strike: planes with poles inside daylight.
Polyline daylight_envelope(const SlopeOrientation& slope, NetProjection projection, std::size_t count = 181);

// Outlines of the zones of kinematics/criteria.hpp, behind a level upper surface; empty if nothing is feasible.

// Poles of planes on which planar sliding is feasible.
Polyline planar_sliding_zone(const SlopeOrientation& slope, double friction_angle, double lateral_limit,
                             NetProjection projection, std::size_t count = 181);

// Poles of layers for which flexural toppling is feasible.
Polyline flexural_toppling_zone(const SlopeOrientation& slope, double friction_angle, double lateral_limit,
                                NetProjection projection, std::size_t count = 181);

// Lines of intersection along which wedge sliding is feasible on both planes: the primary zone. Wedges that slide on a
// single plane follow its dip vector, which lies in the same zone.
Polyline wedge_sliding_zone(const SlopeOrientation& slope, double friction_angle, NetProjection projection,
                            std::size_t count = 181);
// Lines of intersection that plunge less than the friction angle and yet may belong to a wedge that slides, on one
// plane steeper than that: the secondary zone, of two wings that meet in the dip direction of the face. Such a plane
// dips in a direction between those of line and face (Hocking 1976) and is the steeper the nearer to the latter, so
// that the line plunges more steeply than the plane that dips with the face at the friction angle does in the line's
// direction.
Polyline secondary_wedge_sliding_zone(const SlopeOrientation& slope, double friction_angle, NetProjection projection,
                                      std::size_t count = 181);

// Lines of intersection that can be axes of toppling columns: those within the lateral limit, and the oblique ones near
// vertical. The two zones overlap.
Polyline toppling_axis_zone(const SlopeOrientation& slope, double lateral_limit, NetProjection projection,
                            std::size_t count = 181);
Polyline oblique_toppling_axis_zone(const SlopeOrientation& slope, double friction_angle, NetProjection projection,
                                    std::size_t count = 181);

// Density of poles in multiples of the uniform density, by Fisher's kernel on axes: every pole p adds
//     K cosh(K x.p) / sinh K
// at the direction x, whose mean over the hemisphere is 1; the density is the mean over the poles (after Robin & Jowett
// 1986, who use the same exponential kernel). A pole adds nothing where exp(K (|x.p| - 1)) falls under 1e-13.
double pole_density(const std::vector<Direction>& poles, const Direction& at, double kernel_concentration);

// The density of weighted poles; one weight for each.
double pole_density(const std::vector<Direction>& poles, const std::vector<double>& weights, const Direction& at,
                    double kernel_concentration);

// A single pole has a peak of K = 100 times the uniform density, as under the customary counting circle of 1 % of the
// net's area.
inline constexpr double customary_kernel_concentration = 100;

struct DensityGrid {
    std::vector<double> coordinates;  // of columns (x) and of rows (y), equally spaced
    Eigen::MatrixXd values;           // not finite farther than one cell outside the primitive
};

// The density on `side` times `side` points, side >= 4, one cell wider than the net on each side.
DensityGrid density_grid(const std::function<double(const Direction&)>& density, NetProjection projection,
                         std::size_t side);

// The density of weighted poles. It is computed at every second point and around the primitive, and interpolated by
// cubics through four points between them: at a kernel concentration of 100 and with 121 points a side the error is
// within 1.1 % of a pole's peak on the equal-area net, 2.1 % on the equal-angle one. Time grows with
// side^2 * poles.size().
DensityGrid pole_density_grid(const std::vector<Direction>& poles, const std::vector<double>& weights,
                              double kernel_concentration, NetProjection projection, std::size_t side);

// The parts of a line inside the primitive circle, where it is cut.
std::vector<Polyline> inside_primitive(const Polyline& line);

}  // namespace delabole
