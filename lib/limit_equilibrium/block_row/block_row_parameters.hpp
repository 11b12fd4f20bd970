// A row of blocks on an inclined plane (thesis 4.2, 4.3): properties of the plane, the interfaces and the blocks.
//
// Block 1 stands lowest. Faces are normal to the plane and touch their neighbours over the lesser of the two heights;
// no cohesion, no water.
#pragma once

#include "parameters/fields.hpp"
#include "parameters/lengths.hpp"

#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace delabole {

template <class T = double>
struct RowBase {
    T inclination;
    T friction_angle;
    static constexpr auto fields() {
        return FieldTable{number<&RowBase::inclination>(Dimension::angle, right_open(0, degrees(90)),
                                                        "inclination of the plane as it is"),
                          number<&RowBase::friction_angle>(Dimension::angle, within(0, degrees(89.9)),
                                                           "angle of friction between blocks and plane")};
    }
};

template <class T = double>
struct RowInterface {
    T friction_angle;
    static constexpr auto fields() {
        return FieldTable{number<&RowInterface::friction_angle>(Dimension::angle, within(0, degrees(89.9)),
                                                                "angle of friction between neighbouring blocks")};
    }
};

template <class T = double>
struct WeightOfBlock {
    T weight;
    static constexpr auto fields() {
        return FieldTable{number<&WeightOfBlock::weight>(Dimension::force_per_length, more_than(0),
                                                         "weight of the block per metre run")};
    }
};

template <class T = double>
struct UnitWeightOfBlock {
    T unit_weight;
    static constexpr auto fields() {
        return FieldTable{
            number<&UnitWeightOfBlock::unit_weight>(Dimension::unit_weight, more_than(0), "unit weight of the block")};
    }
};

template <class T = double>
using MassOfBlock = std::variant<WeightOfBlock<T>, UnitWeightOfBlock<T>>;

template <class T = double>
struct RowBlock {
    T height;
    T width;
    MassOfBlock<T> mass;
    std::optional<T> base_friction_angle;
    std::optional<T> interface_friction_angle;
    static constexpr auto fields() {
        return FieldTable{
            number<&RowBlock::height>(Dimension::length, extent_range(), "height, normal to the plane"),
            number<&RowBlock::width>(Dimension::length, extent_range(), "width, along the plane"),
            inlined(&RowBlock::mass, "weight or unit weight"),
            number<&RowBlock::base_friction_angle>(
                Dimension::angle, within(0, degrees(89.9)),
                "friction between this block and the plane; absent: that of the row"),
            number<&RowBlock::interface_friction_angle>(Dimension::angle, within(0, degrees(89.9)),
                                                        "friction with the block above; absent: that of the row")};
    }
};

template <class T = double>
struct BlockRow {
    RowBase<T> base;
    RowInterface<T> interface;
    std::vector<RowBlock<T>> block;

    static constexpr std::string_view kind = "block_row";
    static constexpr auto fields() {
        return FieldTable{section<&BlockRow::base>("the plane"), section<&BlockRow::interface>("between the blocks"),
                          section<&BlockRow::block>("the blocks, from the lowest up")};
    }
};

}  // namespace delabole
