// Input of a slope of columns: joints and base, water, loads on single columns, and the wedge above them.
//
// Section, per metre run. Origin at the toe, x into the slope, y up. The joints dip into the slope; the bases are
// normal to them and dip out of the slope, each higher than the one below by a step, so that their toe corners lie on a
// line through the toe of the slope.
#pragma once

#include "parameters/fields.hpp"
#include "parameters/lengths.hpp"
#include "plane_failure/parameters.hpp"
#include "water/water.hpp"

#include <optional>
#include <variant>
#include <vector>

namespace delabole {

template <class Columns>
constexpr auto joint_dip_field() {
    return number<&Columns::joint_dip>(Dimension::angle, left_open(0, degrees(90)),
                                       "dip of the joints, into the slope");
}

// Fields of columns of one spacing with their toe corners on one line.
template <class Columns>
constexpr auto regular_columns_fields() {
    return FieldTable{
        joint_dip_field<Columns>(),
        number<&Columns::spacing>(Dimension::length, extent_range(), "normal spacing of joints"),
        number<&Columns::base_inclination>(Dimension::angle, between(0, degrees(90)),
                                           "inclination of the line through the toe corners of the bases"),
        number<&Columns::base_end_height>(
            Dimension::length, extent_range(),
            "height above the toe at which that line ends; absent: it goes on to the ground")};
}

// Columns cut by the true ground: all results are continuous functions of slope height and spacing, except for loads
// that name a column by its number.
template <class T = double>
struct ContinuousColumns {
    T joint_dip;
    T spacing;
    T base_inclination;
    std::optional<T> base_end_height;
    static constexpr std::string_view kind = "continuous";
    static constexpr auto fields() { return regular_columns_fields<ContinuousColumns>(); }
};

// Flat-topped columns after Goodman & Bray (1976). Their number jumps with slope height and spacing.
template <class T = double>
struct ClassicalColumns {
    T joint_dip;
    T spacing;
    T base_inclination;
    std::optional<T> base_end_height;
    static constexpr std::string_view kind = "classical";
    static constexpr auto fields() { return regular_columns_fields<ClassicalColumns>(); }
};

template <class T = double>
struct ColumnBlock {
    T height;
    T width;
    T step_above;
    std::optional<T> unit_weight;
    static constexpr auto fields() {
        return FieldTable{number<&ColumnBlock::height>(Dimension::length, distance_range(), "height above its base"),
                          number<&ColumnBlock::width>(Dimension::length, extent_range(), "width of its base"),
                          number<&ColumnBlock::step_above>(Dimension::length, distance_range(),
                                                           "rise of the next base over this one, along the joint"),
                          number<&ColumnBlock::unit_weight>(Dimension::unit_weight, more_than(0),
                                                            "unit weight of this block; absent: that of the rock")};
    }
};

// Rectangular blocks one by one, from the toe up.
template <class T = double>
struct BlockColumns {
    T joint_dip;
    std::vector<ColumnBlock<T>> block;
    static constexpr std::string_view kind = "blocks";
    static constexpr auto fields() {
        return FieldTable{joint_dip_field<BlockColumns>(),
                          section<&BlockColumns::block>("the blocks, from the toe up")};
    }
};

template <class T = double>
using ColumnLayout = std::variant<ContinuousColumns<T>, ClassicalColumns<T>, BlockColumns<T>>;

// Water standing in every joint to the same part of its height.
template <class T = double>
struct FilledJointsWater {
    T unit_weight;
    T filled_ratio;
    static constexpr std::string_view kind = "filled_joints";
    static constexpr auto fields() {
        return FieldTable{
            water_unit_weight_field(&FilledJointsWater::unit_weight),
            number<&FilledJointsWater::filled_ratio>(within(0, 1), "height of water over height of each joint")};
    }
};

// A level water table; a joint that meets the ground below it is full.
template <class T = double>
struct WaterTable {
    T unit_weight;
    WaterLevel<T> level;
    static constexpr std::string_view kind = "water_table";
    static constexpr auto fields() {
        return FieldTable{water_unit_weight_field(&WaterTable::unit_weight),
                          inlined(&WaterTable::level, "level above the toe; full is the height of the slope")};
    }
};

// A water surface drawn down to the toe: straight from there to a level above the upper end of the base, horizontal
// behind it. It corresponds to the linear pressure drop of Hoek & Bray for plane failure.
template <class T = double>
struct DrawnDownWater {
    T unit_weight;
    WaterLevel<T> level;
    static constexpr std::string_view kind = "drawn_down";
    static constexpr auto fields() {
        return FieldTable{
            water_unit_weight_field(&DrawnDownWater::unit_weight),
            inlined(&DrawnDownWater::level,
                    "level at the upper end of the base, above the toe; full is the height of the slope")};
    }
};

template <class T = double>
using ColumnWater = std::variant<Dry, FilledJointsWater<T>, WaterTable<T>, DrawnDownWater<T>, PiezometricLineWater<T>>;

template <class T = double>
struct PointLoad {
    T block;
    T force;
    T plunge;
    T height;
    static constexpr auto fields() {
        return FieldTable{number<&PointLoad::block>(at_least(1), "number of the column, 1 at the toe"),
                          number<&PointLoad::force>(Dimension::force_per_length, at_least(0), "force"),
                          number<&PointLoad::plunge>(
                              Dimension::angle, within(degrees(-90), degrees(270)),
                              "direction below the horizontal, measured from into-the-slope; 90 deg is vertical"),
                          number<&PointLoad::height>(
                              Dimension::length, distance_range(),
                              "height of its point of application on the column's middle line, above the base")};
    }
};

// A bolt of given force, from its head on the joint at a column's toe side to an anchor behind the columns.
template <class T = double>
struct ColumnBolt {
    T block;
    T force;
    T plunge;
    T height;
    static constexpr auto fields() {
        return FieldTable{
            number<&ColumnBolt::block>(at_least(1), "number of the column, 1 at the toe"),
            number<&ColumnBolt::force>(Dimension::force_per_length, at_least(0), "tension"),
            number<&ColumnBolt::plunge>(Dimension::angle, within(degrees(-90), degrees(90)),
                                        "direction below the horizontal, into the slope; negative: inclined upwards"),
            number<&ColumnBolt::height>(Dimension::length, distance_range(),
                                        "height of its head above the base, on the toe side of the column")};
    }
};

template <class T = double>
struct HeadWater {
    T unit_weight;
    T filled_ratio;
    static constexpr auto fields() {
        return FieldTable{water_unit_weight_field(&HeadWater::unit_weight),
                          number<&HeadWater::filled_ratio>(
                              within(0, 1), "vertical depth of water over vertical height of the joint")};
    }
};

// Wedge between the last column, the ground and a joint that rises from the end of the base.
template <class T = double>
struct SlideHead {
    T joint_dip;
    T friction_angle;
    T cohesion;
    std::optional<HeadWater<T>> water;
    static constexpr auto fields() {
        return FieldTable{
            number<&SlideHead::joint_dip>(Dimension::angle, left_open(0, degrees(90)),
                                          "dip of the joint on which the wedge slides, out of the slope"),
            number<&SlideHead::friction_angle>(Dimension::angle, right_open(0, degrees(90)), "friction of that joint"),
            number<&SlideHead::cohesion>(Dimension::stress, at_least(0), "cohesion of that joint"),
            section<&SlideHead::water>(
                "water standing in that joint; absent: it stands as the water of the columns does there")};
    }
};

}  // namespace delabole
