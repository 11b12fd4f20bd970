// Groundwater by tilting a base friction model (thesis 2.3.5): one column on a joint, represented by the tilt of its
// resultant force.
//
// A column of weight W rests on a single joint of dip d; its water pushes it with a force U normal to the joint, by a
// pressure that grows linearly from zero at the water level. The model is rotated by the angle t between the resultant
// of both and the vertical:
//     tan t = U sin d / (W - U cos d).
// As the pressure grows linearly from the water level down the joint, U grows with the square of the filled height, so
// that the tilts at two levels are related: the saturated tilt gives U / W = tan t / (sin d + tan t cos d), and this
// times filled_ratio^2 gives the tilt at any other level.
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
        return FieldTable{
            number<&TiltedColumn::joint_dip>(Dimension::angle, between(0, degrees(90)),
                                             "dip of the joint that carries the water"),
            number<&TiltedColumn::saturated_tilt>(
                Dimension::angle, between(0, degrees(90)),
                "inclination of the resultant of weight and water to the vertical when the joint is full"),
            number<&TiltedColumn::filled_ratio>(
                within(0, 1), "depth of water over its depth when the joint is full, for the tilt asked")};
    }
};

struct ColumnTilt {
    double tilt;                     // rad, of the resultant from the vertical
    double water_force_over_weight;  // U / W at that level

    static constexpr auto fields() {
        return FieldTable{number<&ColumnTilt::tilt>(Dimension::angle, "tilt of the resultant of weight and water"),
                          number<&ColumnTilt::water_force_over_weight>("water force over weight of the column")};
    }
};

// Exact to rounding. A tilt above 90 deg means that water lifts the column.
ColumnTilt analyse(const TiltedColumn<>& column);

// Inputs and outputs by name.
ModelInterface model_interface(const TiltedColumn<>& column);

}  // namespace delabole
