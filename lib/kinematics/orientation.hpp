// Planes and lines in space, by the angles that a geologist's compass measures.
//
// Directions are unit vectors (east, north, up). Azimuths run clockwise from north; dip and plunge are measured below
// the horizontal. A plane with dip d and dip direction a has
//     upward normal   n = (sin d sin a, sin d cos a, cos d),
//     dip vector      v = (cos d sin a, cos d cos a, -sin d).
// Its pole is -n, the end of the normal in the lower hemisphere: plunge 90 deg - d, trend a + 180 deg.
// Everything here is exact to rounding.
#pragma once

#include "parameters/fields.hpp"

#include <Eigen/Core>

#include <optional>

namespace delabole {

using Direction = Eigen::Vector3d;

struct Orientation {
    double dip;
    double dip_direction;
    static constexpr auto fields() {
        return FieldTable{number<&Orientation::dip>(Dimension::angle, within(0, degrees(90)), "dip"),
                          number<&Orientation::dip_direction>(Dimension::angle, within(0, degrees(360)),
                                                              "azimuth of the dip, clockwise from north")};
    }
};

struct LineOrientation {
    double plunge;
    double trend;
    static constexpr auto fields() {
        return FieldTable{number<&LineOrientation::plunge>(Dimension::angle, within(0, degrees(90)),
                                                           "inclination below the horizontal"),
                          number<&LineOrientation::trend>(Dimension::angle, within(0, degrees(360)),
                                                          "azimuth of the plunge, clockwise from north")};
    }
};

Direction upward_normal(const Orientation& plane);
Direction dip_vector(const Orientation& plane);
Direction direction_of(const LineOrientation& line);

// The downward end of the axis; a horizontal axis is left as it is.
Direction downward(const Direction& axis);

// Orientation of the plane with this normal, in either sense and of any length but 0. A horizontal plane has dip
// direction 0.
Orientation plane_with_normal(const Direction& normal);

// Trend and plunge of the axis in this direction, in either sense and of any length but 0. A vertical line has trend 0.
LineOrientation line_along(const Direction& axis);

// Clockwise angle from one azimuth to another, -180 to 180 deg.
double azimuth_difference(double from, double to);

// The same azimuth from 0 to below 360 deg.
double wrapped_azimuth(double azimuth);

// Plunge of the line that a vertical section of the given azimuth cuts from the plane, negative where it rises:
// tan(apparent dip) = tan(dip) cos(azimuth - dip direction).
double apparent_dip(const Orientation& plane, double azimuth);

// Absent if the planes are parallel to within 1e-9 rad.
std::optional<LineOrientation> intersection(const Orientation& first, const Orientation& second);

}  // namespace delabole
