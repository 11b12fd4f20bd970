// Assemblies of bodies from rows of blocks, from columns on a stepped base, and from columns cut by cross joints.
//
// Every block rests on the fixed base, or on the block below it in its column, and touches its neighbours over their
// common height. The riser between two bases is not a contact: rock that a column leaves as it moves out of the slope
// could only push it, but friction on a face without a cause of pressure would let the programme hold the column up.
#pragma once

#include "limit_equilibrium/bound/assembly.hpp"
#include "limit_equilibrium/columns/column.hpp"
#include "parameters/fields.hpp"
#include "parameters/lengths.hpp"

namespace delabole {

struct RectangularBlock {
    double width;
    double height;
    double weight;  // N/m
};

struct BlockFriction {
    double base;       // friction angle of blocks on the base
    double interface;  // friction angle between neighbouring blocks, or columns
};

// Rectangles side by side on a level plane, the first at the toe; tilt it with largest_tilt.
Assembly assemble_row(const std::vector<RectangularBlock>& blocks, const BlockFriction& friction);

// Columns with all their loads; a wedge above them becomes the last body. Cohesion acts only on the wedge's own joint.
// The weight of a column acts at the middle of its middle line, which is exact for rectangles; for other shapes the
// difference is part of the load, so that equilibrium as given is exact and a tilt acts at that point.
//
// Columns touch over the upper part of each joint, 0 < upper_part <= 1: whole_joint gives the actual bound. As the part
// shrinks to the top of the joint, where a toppling mechanism puts the forces, the friction that least_strength_factor
// needs rises to that of the recursion (Appendix A of the thesis: from 32.66 deg to 41.14 deg; Goodman & Bray 1976:
// from 33.45 to 38.15 deg). The two methods differ only in where the forces act.
constexpr double whole_joint = 1;
Assembly assemble_columns(const ColumnSlope<>& slope, const BlockFriction& friction, double upper_part);

struct CrossJoints {
    double spacing;
    double stagger;  // less than the spacing
    double friction_angle;
    static constexpr auto fields() {
        return FieldTable{
            number<&CrossJoints::spacing>(Dimension::length, extent_range(),
                                          "distance between cross joints, along the columns from each base"),
            number<&CrossJoints::stagger>(Dimension::length, distance_range(),
                                          "height above its base of the first cross joint in every second column, less "
                                          "than the spacing; 0: as in the others"),
            number<&CrossJoints::friction_angle>(Dimension::angle, within(0, degrees(89.9)),
                                                 "friction angle of the cross joints")};
    }
};

// Rectangular columns under their own weight, cut by cross joints: the blocks of a slope that is jointed in two
// directions. A column's uppermost block has the remaining height.
Assembly assemble_blocks(const ColumnSlope<>& slope, const CrossJoints& cross_joints, const BlockFriction& friction);

constexpr std::size_t most_blocks = 100'000;

}  // namespace delabole
