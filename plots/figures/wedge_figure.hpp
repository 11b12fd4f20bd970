// A wedge in three dimensions, in parallel projection seen from above and from in front of the face.
#pragma once

#include "kinematics/orientation.hpp"
#include "plots/drawing/figure.hpp"

#include <string>

namespace delabole {

// Corners in metres (east, north, up); the origin is the point where the line of intersection daylights in the face.
// Without a tension crack line_end, crack_1 and crack_2 are the same point.
struct WedgeDrawing {
    std::string title = {};
    double face_dip_direction;  // rad
    Direction face_normal;      // out of the rock
    Direction upper_normal;
    Direction crest_1;  // of plane 1 on the crest
    Direction crest_2;
    Direction crack_1;  // where the trace of plane 1 on the upper surface ends
    Direction crack_2;
    Direction line_end;
    bool cracked;
    Direction sliding;  // unit vector; zero: no arrow is drawn
};

// The wedge in the slope, with the edges inside the rock dashed.
Figure wedge_figure(const WedgeDrawing& drawing);

// The same wedge after sliding along its direction of sliding, with the planes that it has left.
Figure slid_wedge_figure(const WedgeDrawing& drawing);

}  // namespace delabole
