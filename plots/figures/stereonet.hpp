// Stereonets, lower hemisphere, north up: poles with the zones in which they slide or topple, and planes with their
// lines of intersection. The zones assume level ground behind the crest.
#pragma once

#include "kinematics/parameters.hpp"
#include "kinematics/stereonet.hpp"
#include "plots/drawing/figure.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

struct DrawnJointSet {
    std::string name = {};
    Orientation mean;
    std::vector<Orientation> planes = {};  // sampled or measured; may be empty
    std::vector<double> weights = {};      // of the planes; empty: all alike
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
    std::vector<Orientation> without_set = {};     // measured planes that belong to no set
    std::vector<double> weights_without_set = {};  // empty: all alike
    bool measured = false;                         // the planes, else they are sampled
    double kernel_concentration = customary_kernel_concentration;
    std::size_t grid_side = 121;  // of the density grid
};

// Poles with the contours of their density; means as large marks; face, daylight envelope, friction circle, zones of
// planar sliding and flexural toppling. Of each set the first 1000 sampled planes count in the density and the first
// 150 are drawn; measured ones all.
Figure pole_figure(const StereonetDrawing& drawing);

// The measured poles alone with Kamb's contours, from 3 standard deviations above what uniform poles would give.
Figure kamb_figure(const StereonetDrawing& drawing);

// Strikes of planes in classes of 10 deg, both ends of each, the area of a petal proportional to its weight.
Figure rosette_figure(const std::string& title, const std::vector<Orientation>& planes,
                      const std::vector<double>& weights);

// Great circles of the face and of the mean planes, their intersections with the zones of wedge sliding and of the axes
// of direct toppling, friction circle. Labels of neighbours are gathered: "1–3, 5" is the first three and the fifth.
Figure plane_figure(const StereonetDrawing& drawing);

// A wedge on the net: great circles of its surfaces, the line along which its planes meet and where it slides.
struct WedgeNet {
    std::string title = {};
    NetProjection projection = NetProjection::equal_area;
    Orientation face;  // a dip above 90 deg is an overhang
    Orientation upper_surface;
    std::vector<DrawnJointSet> planes = {};  // without poles
    LineOrientation line;
    std::optional<LineOrientation> sliding = {};  // absent, or upwards: not drawn
};
Figure wedge_net_figure(const WedgeNet& net);

}  // namespace delabole
