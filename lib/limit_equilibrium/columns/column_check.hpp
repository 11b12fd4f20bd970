// Reasons why a slope cannot be divided into columns on a stepped base.
#pragma once

namespace delabole {

enum class ColumnCheck {
    valid,
    base_flatter_than_joints_allow,  // base inclination below 90 deg - joint dip: the base would step downwards
    base_does_not_daylight,          // base inclination not below the face
    base_never_surfaces,             // the ground behind the crest is as steep as the base, and no end is given
    base_end_outside_slope,          // the given end of the base lies above the ground
    joints_never_surface,            // part of the ground falls away as steeply as the joints, or more steeply
    step_larger_than_block,
    no_columns,
    too_many_columns,             // more than 1 000 000
    slide_head_needs_base_end,    // a wedge above the columns, but the end of the base is not given
    head_joint_never_surfaces,    // the ground above the wedge is as steep as its joint
    load_outside_columns,         // a load or bolt names a column that does not exist or lies above its top
    load_needs_slope,             // loads on the ground or a level in filled ratio, but only blocks are given
    bench_needs_continuous,       // flat-topped columns have no bench
    elevation_without_datum,      // an elevation is given but slope.toe_elevation is not
    water_points_not_increasing,  // piezometric line out of order, or a single point
    slope_needed,                 // columns cut from a slope, but no slope
    input_out_of_range,
};

}  // namespace delabole
