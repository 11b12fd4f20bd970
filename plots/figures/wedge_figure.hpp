// A wedge in three dimensions, in parallel projection seen from above and from in front of the face.
#pragma once

#include "kinematics/orientation.hpp"
#include "plots/drawing/figure.hpp"

#include <string>

namespace delabole {

// Corners in metres (east, north, up), the origin where the line of intersection comes out of the face. Without a crack
// line_end, crack_1 and crack_2 are one point.
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
    Direction sliding;  // unit vector; zero: none is drawn
};

// The wedge in the slope, edges inside the rock dashed.
Figure wedge_figure(const WedgeDrawing& drawing);

// The same wedge slid out along its direction of sliding, with the planes that it leaves.
Figure slid_wedge_figure(const WedgeDrawing& drawing);

}  // namespace delabole
