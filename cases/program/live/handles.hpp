// Points of a section that are dragged, and the inputs that follow.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "geometry/polyline.hpp"

#include <optional>
#include <string>
#include <vector>

namespace delabole {

struct Handle {
    std::string name;  // "crest"; of a point that the case gives by coordinates its name: "scene.outline[2]"
    std::vector<std::string> inputs;  // one or two, by the names of named_inputs: what a drag changes
    Point at;                         // m, in the axes of the section's figure
    // This is the point from which all others are measured: a drag leaves those where they are seen.
    bool is_origin = false;
    std::optional<Point> from{};  // the other end of a line that has the dip which the handle turns
};

// Returns toe (the origin of the section: if it has no elevation, a drag leaves the crest in its place), crest, bench,
// failure plane, tension crack and water level of a slope, as far as the model has them; the tops of blocks and columns
// that are given one by one; the base and joints of columns, the joint sets of a section; rows and ends of bolts; and
// every point given by two lengths x and y: corners of outlines, of water tables and of lines. On a stereonet these are
// the poles of face and joint sets, and the friction circle. Empty for an impossible slope.
std::vector<Handle> handles_of(const CaseModel& model);

// Finds the values of the handle's inputs that bring it nearest to the point, by Gauss-Newton steps within the ranges
// of the inputs. Throws std::invalid_argument for an unknown name.
std::vector<Condition> dragged(const CaseModel& model, const std::string& name, const Point& to);

}  // namespace delabole
