// One column of a slope, ready for the recursion of limiting equilibrium, and the slope made of them.
//
// Local axes: u along the bases up-dip, v normal to them upwards; a column's own origin is the lower (toe) corner of
// its base. The bases dip out of the slope at base_dip = 90 deg - dip of the joints.
#pragma once

#include "geometry/polygon.hpp"
#include "limit_equilibrium/columns/column_check.hpp"

#include <optional>
#include <vector>

namespace delabole {

template <class T = double>
struct Column {
    T width;   // of the base, m
    T base_u;  // of the toe corner, in axes through the toe of the slope turned by base_dip
    T base_v;
    T height;         // of its middle line; 0 allowed
    T lower_contact;  // above its own base, of the highest contact with the column below; 0 for the first column
    T upper_contact;  // above its own base, of the highest contact with the column above; 0 if there is none
    T joint_length;   // of the contact with the column above; 0 if there is none
    T weight;         // N/m, of rock alone
    // Resultant of all loads on the column, without interblock and base forces. Water is included here: joint and base
    // forces are effective ones.
    T down_dip_force;      // along -u, N/m
    T normal_force;        // along -v, N/m
    T overturning_moment;  // about the toe corner, positive tipping out of the slope, N
};

// The wedge that slides on a joint above and behind the columns and rests against the last of them.
template <class T = double>
struct SlideHeadWedge {
    T weight;          // N/m
    T joint_dip;       // of the joint on which it slides
    T joint_length;    // of that joint, up to the ground
    T friction_angle;  // of that joint
    T cohesion;
    T water_force;  // on that joint, normal to it
    T force_x;      // resultant of weight, earthquake, loads on top and water on the columns' face
    T force_y;
    T reaction_position;  // distance along the joint from its lower end to the point at which that resultant meets it
    T face_length;        // of its contact with the last column, above the lower end of the joint
    T face_base;          // height of that lower end above the base of the last column
};

template <class T = double>
struct ColumnSlope {
    ColumnCheck check = ColumnCheck::no_columns;
    T base_dip{};
    std::vector<Column<T>> columns{};  // from the toe up
    std::optional<SlideHeadWedge<T>> slide_head{};
    std::optional<T> end_v{};  // of the given end of the base, turned axes
};

}  // namespace delabole
