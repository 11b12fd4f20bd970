// Moving blocks inside a report, with controls for play, pause, single steps, position, speed and the blocks' labels.
// The last frame is a plain SVG drawing, which is shown alone on paper and where no script runs.
//
// The scene is rotated so that gravity points down. Positions are rounded to 1e-4 of the diagonal of the picture,
// rotations to 1e-4 rad.
#pragma once

#include "geometry/polyline.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace delabole {

// A crack, drawn bold on a block and moving with it, from a given frame on.
struct AnimatedCrack {
    Point from;  // m, in the initial geometry
    Point to;
    std::size_t first_frame;
};

struct AnimatedBlock {
    Polyline outline =
        {};  // m, in the initial geometry; not shown with fewer than three corners or a number that is not finite
    std::string label = {};
    bool fixed = false;
    std::vector<AnimatedCrack> cracks = {};
};

struct BlockPose {
    Point displacement = {0, 0};  // m, of the centroid from its initial position; if not finite the block is not shown
    double rotation = 0;          // rad, from the initial position, anticlockwise
    double colour = 0;            // the value that sets its colour, at least 0: speed, displacement, ...
    bool present = true;          // false: the block was removed
};

// A bar across joints in one frame, drawn with its force and marked if it has yielded.
struct AnimatedBar {
    Point from = {0, 0};  // m, in that frame, in the axes of the initial geometry
    Point to = {0, 0};
    double force = 0;  // in the unit of the animation, at least 0
    bool yielded = false;
    bool present = true;  // false: not shown
};

struct AnimationFrame {
    double time = 0;                     // s, increasing
    double tilt = 0;                     // rad, of the initial geometry's x axis, which dips towards -x
    std::vector<BlockPose> poses = {};   // as many as blocks
    std::vector<AnimatedBar> bars = {};  // the same bars in each frame
};

struct BlockAnimation {
    std::vector<AnimatedBlock> blocks = {};
    std::vector<AnimationFrame> frames = {};
    std::string outcome = {};   // "collapse at 2.31 s"
    std::string colour = {};    // what the colours mean: "speed"
    std::string unit = {};      // "m/s"
    std::string bar_unit = {};  // of the bars' forces, "kN/m"
    std::string caption = {};
};

// The drawing, the controls (hidden until the script runs) and the data. The page has to hold animation_style and,
// after all animations, animation_script (page.hpp). If there is no frame or no block to show, a box says so.
std::string animation_html(const BlockAnimation& animation);

}  // namespace delabole
