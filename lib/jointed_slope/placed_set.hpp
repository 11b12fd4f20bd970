// A joint set placed in a section: where its joints lie, and the parts of them that exist.
#pragma once

#include "geometry/polyline.hpp"
#include "jointed_slope/face_cutting.hpp"
#include "jointed_slope/jointed_section.hpp"
#include "jointed_slope/slope_geometry.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace delabole {

// The range of the distances of points from a line.
struct DistanceRange {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
    void include(double value) {
        lowest = value < lowest ? value : lowest;
        highest = value > highest ? value : highest;
    }
};

// Unit vectors of a dip: `along` up-dip, `normal` downwards; for the opposite dip they are the mirror images.
StraightLine line_of_dip(double dip);

// Joints are numbered downwards from the one at the offset. Returns an empty list and too_many_blocks if there are too
// many.
std::vector<double> joint_positions(const JointSetCut& set, std::uint64_t seed, double first,
                                    const DistanceRange& extent, std::int64_t& number_of_first, SlopeCheck& check);

constexpr double least_part = 4;  // snap distances; shorter parts of joints end where they begin

// Between two places along a line.
struct LinePart {
    double begin;
    double end;
};

// The parts of joints along which they may cut: their traces, limited to the region.
class Reach {
  public:
    Reach(const JointSetCut& set, std::uint64_t seed, Polygon<> region, double snap, double anchor);

    bool is_bounded() const { return persistence_ < 1 || !region_.empty(); }
    // Whether a joint extends from one place to the other, but for some snap distances.
    bool contains(const StraightLine& line, std::int64_t number, double first, double last, double snaps = 1) const;
    // Its parts between two places that are longer than the least.
    std::vector<LinePart> parts(const StraightLine& line, std::int64_t number, double first, double last) const;

  private:
    double period() const { return trace_ / persistence_; }
    double first_trace(std::int64_t number) const;
    std::vector<LinePart> in_region(const StraightLine& line) const;

    double persistence_;
    double trace_;
    std::uint64_t seed_;
    Polygon<> region_;
    double snap_;
    double anchor_;
};

}  // namespace delabole
