// The figures of a system of blocks, from plain numbers: the section with its forces, the interblock forces along the
// slope, and the chart of the modes of failure over two angles.
//
// Lengths in metres, forces in newtons per metre run, angles in radians; x into the slope, y up, origin at the toe.
#pragma once

#include "plots/figures/figures.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

enum class DrawnMode { plain, stays, slides, topples, slides_and_topples, moves, held_by_corners, fixed };

// The words in the legend; a plain block has no word.
constexpr std::array<std::string_view, 8> enum_names(DrawnMode) {
    return {"", "stays", "slides", "topples", "slides and topples", "moves", "held by corners", "fixed"};
}

struct DrawnBlock {
    Polyline outline = {};  // corners in order, clockwise or anticlockwise; the first need not be repeated
    std::string label = {};
    DrawnMode mode = DrawnMode::plain;
    std::optional<std::size_t> rock = {};  // index of the rock whose shade the block has; absent: that of its mode
    Polyline displaced = {};               // the outline after the displacement; empty: not shown
};

enum class ForceKind { interblock, base_reaction, thrust, applied, weight, required };

constexpr std::array<std::string_view, 6> enum_names(ForceKind) {
    return {"interblock force", "base reaction", "thrust", "applied force", "weight", "required force"};
}

struct DrawnForce {
    Point at;     // the arrow's tail
    Point force;  // N/m
    ForceKind kind = ForceKind::interblock;
};

// A broken face or an open joint, from end to end.
struct DrawnCrack {
    Point from;
    Point to;
};

// Empty members are not drawn, nor are forces that are zero or not finite.
struct BlockDrawing {
    std::string title = {};
    std::vector<DrawnBlock> blocks = {};
    std::vector<std::string> rocks = {};  // names for the legend
    Polyline base = {};                   // surface of the rock on which the blocks stand; drawn as rock below
    Polyline ground = {};                 // surface of the slope
    Polyline water = {};                  // water level
    Polyline tension_crack = {};
    std::vector<DrawnCrack> broken = {};       // rock that has broken
    std::vector<DrawnCrack> open_joints = {};  // joints that stand open
    std::vector<DrawnForce> forces = {};
    Arrows velocities = {};  // to a scale of their own, stated in the legend
    std::string displaced_legend = "mechanism, displacements enlarged";
    double toe_elevation = 0;  // m; added to heights on the vertical axis
};

// All forces have one scale, at which the greatest is about one and a half times as long as the spacing of the blocks;
// an arrow of a round force is the key. Very small forces are drawn longer, so that they can be seen. If there are so
// many that their heads would cover the blocks, they are drawn as force chains: lines through the points of contact in
// the direction of the forces, with a width proportional to the force. For labels see block_labels.
Figure block_figure(const BlockDrawing& drawing);

// Interblock forces against the number of the block, N/m. Each of the vectors is empty or has the length of `block`.
struct ForceAlongSlope {
    std::string title = {};
    std::vector<double> block = {};     // numbers, increasing
    std::vector<double> toppling = {};  // least force that prevents toppling; not drawn if not finite
    std::vector<double> sliding = {};   // least force that prevents sliding; not drawn if not finite
    std::vector<double> acting = {};
    std::vector<DrawnMode> modes = {};  // shades the background
    Polyline printed = {};              // (number of the block, N/m)
    std::string printed_legend = "printed";
};

Figure force_along_slope_figure(const ForceAlongSlope& data);

struct ModeRegion {
    DrawnMode mode = DrawnMode::stays;
    Polyline outline = {};  // rad
};

// A chart over two angles of the mode of a block.
struct ModeChart {
    std::string title = {};
    std::string x = {};  // names of the angles: "base.dip"
    std::string y = {};
    std::vector<ModeRegion> regions = {};
    std::vector<NamedCurve> boundaries = {};     // rad
    std::vector<PrintedStatement> printed = {};  // rad
};

Figure mode_chart_figure(const ModeChart& chart);

}  // namespace delabole
