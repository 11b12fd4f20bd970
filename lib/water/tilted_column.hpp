// Groundwater by tilting (thesis 2.3.5): one column on a joint, seen by the tilt of its resultant force.
//
// A column of rock rests on a joint of given dip. Water in the joint presses on the column, and on this joint only,
// with a triangular pressure: zero at the water surface, growing linearly with depth below it. The resultant of weight
// and water force is then inclined to the vertical by the angle through which a dry model must be tilted to be loaded
// alike. The tilt of the column with the joint full stands for the unit weights and the shape of the column, which are
// not needed by themselves; the tilt with the joint filled to a part of its height follows.
#pragma once

#include "parameters/fields.hpp"

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

}  // namespace delabole
