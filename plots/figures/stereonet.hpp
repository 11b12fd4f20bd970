// Stereonets, lower hemisphere, north up: poles with the zones of sliding and toppling, and planes with their lines of
// intersection. The zones assume level ground behind the crest.
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
    std::vector<double> weights = {};      // of the planes; empty: all equal
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
    std::vector<double> weights_without_set = {};  // empty: all equal
    bool measured = false;                         // true: the planes were measured; false: they were sampled
    double kernel_concentration = customary_kernel_concentration;
    std::size_t grid_side = 121;  // of the density grid
};

// Poles with the contours of their density and large marks for the means; face, daylight envelope, friction circle,
// zones of planar sliding and flexural toppling. For each set the density uses the first 1000 sampled planes and the
// figure shows the first 150; measured planes are all used and shown.
Figure pole_figure(const StereonetDrawing& drawing);

// The measured poles alone with Kamb's contours, from 3 standard deviations above the density of uniform poles.
Figure kamb_figure(const StereonetDrawing& drawing);

// Strikes of planes in classes of 10 deg, both directions of each strike; the area of a petal is proportional to its
// weight.
Figure rosette_figure(const std::string& title, const std::vector<Orientation>& planes,
                      const std::vector<double>& weights);

// Great circles of the face and of the mean planes, and the friction circle; lines of intersection with the zone of
// wedge sliding and that of the axes of direct toppling. Neighbouring lines share a label: "1–3, 5" stands for the
// first three and the fifth.
Figure plane_figure(const StereonetDrawing& drawing);

// A wedge on the net: great circles of its surfaces, the line of intersection of its planes and the direction of
// sliding.
struct WedgeNet {
    std::string title = {};
    NetProjection projection = NetProjection::equal_area;
    Orientation face;  // a dip above 90 deg is an overhang
    Orientation upper_surface;
    std::vector<DrawnJointSet> planes = {};  // without their poles
    LineOrientation line;
    std::optional<LineOrientation> sliding = {};  // not drawn if absent or directed upwards
};
Figure wedge_net_figure(const WedgeNet& net);

}  // namespace delabole
