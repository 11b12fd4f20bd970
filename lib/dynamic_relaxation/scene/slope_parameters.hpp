// Input of a slope cut by joints, besides its geometry and joints: rocks, fixed boundaries, water, stages of
// excavation. Section axes and metres are those of jointed_slope/slope_geometry.hpp.
#pragma once

#include "jointed_slope/slope_geometry.hpp"
#include "parameters/fields.hpp"

#include <optional>
#include <string>
#include <vector>

namespace delabole {

struct SlopeRock {
    std::string name;
    double density;
    static constexpr auto fields() {
        return FieldTable{section<&SlopeRock::name>("by which lines and sets refer to it"),
                          number<&SlopeRock::density>(Dimension::density, more_than(0), "of the rock")};
    }
};

enum class FrameSides { below, below_and_behind, all_around };

// Fixed blocks along the lowest edges of the outline, along those farthest into the slope, and along those in front.
struct SlopeFrame {
    FrameSides sides;
    double thickness;
    std::optional<double> reach;
    std::string joint;
    static constexpr auto fields() {
        return FieldTable{section<&SlopeFrame::sides>("of the section that rest on fixed blocks"),
                          number<&SlopeFrame::thickness>(Dimension::length, more_than(0), "of the fixed blocks"),
                          number<&SlopeFrame::reach>(
                              Dimension::length, at_least(0),
                              "of the block below, beyond the section where there is none beside it; absent: 0"),
                          section<&SlopeFrame::joint>("name of the properties along the frame")};
    }
};

// Pressure grows with depth below the table in every joint in proportion to its share, and on surfaces below it. Beyond
// its ends the table is level. A joint keeps its pressure however it moves. Excavations are dry: where a stage takes
// away the block on one side of a joint, the face on the other side is drained.
struct SlopeWater {
    double unit_weight;
    std::vector<SectionPoint> vertex;
    static constexpr auto fields() {
        using W = SlopeWater;
        return FieldTable{number<&W::unit_weight>(Dimension::unit_weight, more_than(0), "unit weight of water"),
                          section<&W::vertex>("points of the water table, x increasing")};
    }
};

struct SlopeArea {
    std::vector<SectionPoint> vertex;
    static constexpr auto fields() {
        return FieldTable{section<&SlopeArea::vertex>("corners of an area; it has the blocks whose centre is in it")};
    }
};

struct SlopeStage {
    double time;
    std::vector<SectionPoint> vertex;
    static constexpr auto fields() {
        return FieldTable{number<&SlopeStage::time>(Dimension::time, at_least(0), "at which its blocks are taken away"),
                          section<&SlopeStage::vertex>("corners of an area; it has the blocks whose centre is in it")};
    }
};

}  // namespace delabole
