// Groundwater by tilting a base friction model (thesis 2.3.5): one column on a joint, seen by the tilt of its resultant
// force.
//
// A column of weight W lies on a joint of dip d, and on this joint alone; its water pushes it with a force U normal to
// the joint, by a pressure that grows linearly from zero at the water level. The model is
// turned by the angle t that the resultant of both makes with the vertical:
//     tan t = U sin d / (W - U cos d).
// With pressure growing linearly from the water level down the joint, U grows with the square of the filled height, so
// that the tilts of two levels are one column seen twice: from the saturated tilt follows U / W = tan t / (sin d +
// tan t cos d), from that times filled_ratio^2 the tilt of any other level.
#pragma once

#include "parameters/fields.hpp"
#include "parameters/model_interface.hpp"

#include <string_view>

namespace delabole {

template <class T = double>
struct TiltedColumn {
    T joint_dip;
    T saturated_tilt;
    T filled_ratio;

    static constexpr std::string_view kind = "tilted_column";
    static constexpr auto fields() {
        return std::tuple{
            number("joint_dip", &TiltedColumn::joint_dip, Dimension::angle, between(0, degrees(90)),
                   "dip of the joint that carries the water"),
            number("saturated_tilt", &TiltedColumn::saturated_tilt, Dimension::angle, between(0, degrees(90)),
                   "inclination of the resultant of weight and water to the vertical when the joint is full"),
            number("filled_ratio", &TiltedColumn::filled_ratio, Dimension::ratio, within(0, 1),
                   "depth of water over its depth when the joint is full, for the tilt asked")};
    }
};

struct ColumnTilt {
    double tilt;                     // rad, of the resultant from the vertical
    double water_force_over_weight;  // U / W at that level

    static constexpr auto fields() {
        return std::tuple{number("tilt", &ColumnTilt::tilt, Dimension::angle, any_number(),
                                 "tilt of the resultant of weight and water"),
                          number("water_force_over_weight", &ColumnTilt::water_force_over_weight, Dimension::ratio,
                                 any_number(), "water force over weight of the column")};
    }
};

// Rounding only. A tilt above 90 deg means that water lifts the column.
ColumnTilt analyse(const TiltedColumn<>& column);

// Inputs and outputs by name.
ModelInterface model_interface(const TiltedColumn<>& column);

}  // namespace delabole
