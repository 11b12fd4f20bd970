// Lines of a drawing, joined at their ends.
#pragma once

#include "jointed_slope/slope_geometry.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

struct LineChain {
    std::vector<SectionPoint> point = {};
    bool closed = false;
    bool joined = false;  // of several, whose directions say nothing
    std::string_view layer = {};
};

// Joins open chains at their ends; chains that do not meet stay separate.
std::vector<LineChain> joined(std::vector<LineChain> chains);

// The first corner stays the first.
void turn_anticlockwise(std::vector<SectionPoint>& outline);

// "0.05 m wide, from x = 4.37 m, y = 12 m to x = 4.42 m, y = 12 m": the narrowest gap between two chains, or that of a
// single one. Empty if there are too many to compare. `unit` is that of the coordinates in metres.
std::string gap_in_words(const std::vector<LineChain>& chains, double unit);

}  // namespace delabole
