// Stereonets, lower hemisphere, north up: poles with the zones in which they slide or topple, and planes with their
// lines of intersection. The zones assume level ground behind the crest.
#pragma once

#include "kinematics/parameters.hpp"
#include "kinematics/stereonet.hpp"
#include "plots/drawing/figure.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace delabole {

struct DrawnJointSet {
    std::string name = {};
    Orientation mean;
    std::vector<Orientation> planes = {};  // sampled or measured; may be empty
};

struct DrawnIntersection {
    std::string label = {};
    LineOrientation line;
};

struct StereonetDrawing {
    std::string title = {};
    NetProjection projection = NetProjection::equal_area;
    SlopeOrientation slope;
    double friction_angle;
    LateralLimit lateral_limit;
    std::vector<DrawnJointSet> joint_set = {};
    std::vector<DrawnIntersection> intersection = {};
    std::string planes_are = "sampled";  // or "measured": how the legend calls the poles
    double kernel_concentration = customary_kernel_concentration;
    std::size_t grid_side = 121;  // of the density grid
};

// Poles with the contours of their density; means as large marks; face, daylight envelope, friction circle, zones of
// planar sliding and flexural toppling. Of each set the first 1000 planes count in the density, every one alike, and
// the first 150 are drawn.
Figure pole_figure(const StereonetDrawing& drawing);

// Great circles of the face and of the mean planes, their intersections with the zones of wedge sliding and of the axes
// of direct toppling, friction circle. Labels of neighbours are gathered: "1–3, 5" is the first three and the fifth.
Figure plane_figure(const StereonetDrawing& drawing);

}  // namespace delabole
