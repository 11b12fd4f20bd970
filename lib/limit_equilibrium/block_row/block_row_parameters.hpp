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

struct RowBase {
    double inclination;
    double friction_angle;
    static constexpr auto fields() {
        return FieldTable{number<&RowBase::inclination>(Dimension::angle, right_open(0, degrees(90)),
                                                        "inclination of the plane as it is"),
                          number<&RowBase::friction_angle>(Dimension::angle, within(0, degrees(89.9)),
                                                           "angle of friction between blocks and plane")};
    }
};

struct RowInterface {
    double friction_angle;
    static constexpr auto fields() {
        return FieldTable{number<&RowInterface::friction_angle>(Dimension::angle, within(0, degrees(89.9)),
                                                                "angle of friction between neighbouring blocks")};
    }
};

struct WeightOfBlock {
    double weight;
    static constexpr auto fields() {
        return FieldTable{number<&WeightOfBlock::weight>(Dimension::force_per_length, more_than(0),
                                                         "weight of the block per metre run")};
    }
};

struct UnitWeightOfBlock {
    double unit_weight;
    static constexpr auto fields() {
        return FieldTable{
            number<&UnitWeightOfBlock::unit_weight>(Dimension::unit_weight, more_than(0), "unit weight of the block")};
    }
};

using MassOfBlock = std::variant<WeightOfBlock, UnitWeightOfBlock>;

struct RowBlock {
    double height;
    double width;
    MassOfBlock mass;
    std::optional<double> base_friction_angle;
    std::optional<double> interface_friction_angle;
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

struct BlockRow {
    RowBase base;
    RowInterface interface;
    std::vector<RowBlock> block;

    static constexpr std::string_view kind = "block_row";
    static constexpr auto fields() {
        return FieldTable{section<&BlockRow::base>("the plane"), section<&BlockRow::interface>("between the blocks"),
                          section<&BlockRow::block>("the blocks, from the lowest up")};
    }
};

}  // namespace delabole
