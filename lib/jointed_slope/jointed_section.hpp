// Blocks of a slope that are cut by joints, faults and boundaries, in exact contact.
//
// The outline is first divided into convex parts, from each re-entrant corner to the opposite side. Then the cuts are
// made in their order, each through every block that it crosses from side to side; lines and joints of sets that ended
// inside a block are cut again as far as cuts that came later and others that they meet there. Finally, parts that were
// divided only to stay convex are joined again if the result is a convex block. Slivers are merged in the same way
// where the merged block does not reach across a joint that runs on; other small ones are taken away, and leave a void.
// Blocks that share an edge share the numbers of its ends: their areas and those of the voids add up to that of the
// outline to rounding, and nothing overlaps.
//
// All lengths are relative to the outline's first corner: a section moved by a number that its coordinates can
// represent, mirrored or scaled by a power of two gives the same blocks to the last bit. Cost: proportional to the
// number of blocks times the number of corners of a block; a hundred thousand blocks take less than a few seconds.
#pragma once

#include "jointed_slope/section_mesh.hpp"
#include "jointed_slope/slope_geometry.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace delabole {

// A twentieth more than the largest number that has been run: a check of this many takes a second or two, and less than
// ten under the sanitizers.
inline constexpr std::size_t most_slope_blocks = 105'000;

enum class SlopeCheck {
    valid,
    number_out_of_range,         // not finite, or outside the range of its field
    outline_too_short,           // fewer than three corners
    outline_crosses_itself,      // or touches itself
    snap_distance_out_of_range,  // less than 4e-6 of the section's size, or more than a quarter of a spacing
    too_many_blocks,             // more than `most_slope_blocks`, counted before each set is cut
    line_too_short,              // fewer than two points apart
    line_folds_back,             // turns by more than about 150 deg
    region_too_short,
    region_crosses_itself,
    persistence_without_trace_length,
    gouge_and_thickness,  // one without the other
    feature_and_side,     // one without the other
    stagger_without_set,  // one without the other
    unknown_rock,
    unknown_joint,
    unknown_line,
    unknown_set,
    intact_joint_missing,  // rock is divided where a block would not be convex, and the joint of that division has no
                           // properties
    frame_without_edge,    // no part of the outline lies along a side of the frame
    water_table_too_short,
    water_table_not_increasing,  // in x
    area_too_short,              // fewer than three corners
    area_crosses_itself,
    area_without_block,  // no block has its centre in the area
};

struct SlopeBlock {
    std::vector<MeshIndex> vertex;  // anticlockwise; includes corners of neighbours on its faces
    std::vector<MeshIndex> joint;   // along each edge, to the next vertex: index of a name, free_surface or intact_rock
    MeshIndex rock;                 // index of a name
    // The joint that was cut along each edge of the outline, or free_surface. It counts on the frame.
    std::vector<MeshIndex> joint_along;
};

// Numbers of divisions by each cut, in the order of the cuts. All are 0 if it misses the section or its spacing is
// larger.
struct CutCount {
    std::size_t made = 0;     // blocks divided
    std::size_t dropped = 0;  // places where a joint ends inside a block, which it does not divide
    std::size_t along = 0;    // edges that were there before, on a stronger joint or on the outline
};

struct JointedSection {
    SlopeCheck check = SlopeCheck::valid;
    std::size_t index_at_fault = 0;  // of the cut that the check concerns, or of the corner of the outline
    std::vector<PlanePoint<>> vertex = {};
    std::vector<SlopeBlock> block = {};
    std::vector<CutCount> cut = {};
    bool outline_reversed = false;    // it was clockwise
    std::size_t corners_dropped = 0;  // corners of the outline that repeated the one before or the first
    std::size_t slivers_merged = 0;
    std::size_t slivers_crushed = 0;  // taken away: merged, they would lock a joint or be no convex block
    std::size_t slivers_kept = 0;     // likewise, but too large to be taken away
    std::size_t intact_edges = 0;     // left between blocks of the same rock
    double crushed_area = 0;          // m2, of the slivers taken away
    double snap_distance = 0;         // m
    double typical_area = 0;          // m2, median of the blocks, at most a thirtieth of all of them
    // Joints of which one runs along the other, the lesser index first.
    std::set<std::pair<std::size_t, std::size_t>> along_each_other = {};
};

// `rocks` and `joints` are the names to whose indices blocks refer; there is at least one of each. The whole section is
// of the first rock unless a line assigns another. `rank`: of each joint, the higher the stronger it is; where two run
// along each other, and around slivers, the weaker one counts. Absent: all are equally strong.
JointedSection cut_slope(const SlopeGeometry& geometry, const std::vector<std::string>& rocks,
                         const std::vector<std::string>& joints, const std::vector<std::size_t>& rank = {});

Polygon<> outline_of(const JointedSection& section, const SlopeBlock& block);
Polygon<> polygon_of(const std::vector<SectionPoint>& corners);

}  // namespace delabole
