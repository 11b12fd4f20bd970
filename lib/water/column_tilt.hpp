// Groundwater by tilting a base friction model (thesis 2.3.5).
//
// A column of weight W lies on a joint of dip d, whose water pushes it with a force U normal to the joint. The model is
// turned by the angle t that the resultant of both makes with the vertical:
//     tan t = U sin d / (W - U cos d).
// With pressure growing linearly from the water level down the joint, U grows with the square of the filled height, so
// that the tilts of two levels are one column seen twice: from the saturated tilt follows U / W = tan t / (sin d +
// tan t cos d), from that times filled_ratio^2 the tilt of any other level.
#pragma once

#include "parameters/model_interface.hpp"
#include "water/tilted_column.hpp"

namespace delabole {

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
