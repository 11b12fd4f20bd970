// Moving blocks inside a report: play, pause, step, scrub, speed and, when asked for, the blocks' labels. The last
// frame is a plain SVG drawing, which stands there alone where no script runs and on paper.
//
// The scene is turned so that gravity points down. Positions are kept to 1e-4 of what is seen, rotations to 1e-4 rad.
#pragma once

#include "geometry/polyline.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace delabole {

// Drawn bold on a block, with which it goes, from a frame on.
struct AnimatedCrack {
    Point from;  // m, in the drawing
    Point to;
    std::size_t first_frame;
};

struct AnimatedBlock {
    Polyline outline =
        {};  // m, in the drawing; with fewer than three corners or a number that is not finite: not shown
    std::string label = {};
    bool fixed = false;
    std::vector<AnimatedCrack> cracks = {};
};

struct BlockPose {
    Point displacement = {0, 0};  // m, of the centroid since the drawing; not finite: the block is not shown
    double rotation = 0;          // rad since the drawing, anticlockwise
    double colour = 0;            // what it is coloured by, at least 0: its speed, displacement, ...
    bool present = true;          // false: removed
};

// A bar across joints in one frame, drawn with its force; marked where it has yielded.
struct AnimatedBar {
    Point from = {0, 0};  // m, where it is in that frame, in the axes of the drawing
    Point to = {0, 0};
    double force = 0;  // in the unit of the animation, at least 0
    bool yielded = false;
    bool present = true;  // false: not shown
};

struct AnimationFrame {
    double time = 0;                     // s, increasing
    double tilt = 0;                     // rad, of the drawing's x axis, which dips towards -x
    std::vector<BlockPose> poses = {};   // as many as blocks
    std::vector<AnimatedBar> bars = {};  // the same ones in each frame
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

// The drawing, the controls (hidden until the script runs) and the data, for a page that holds animation_style and,
// after all animations, animation_script (page.hpp). Without a frame or a block to show: a box that says
// so.
std::string animation_html(const BlockAnimation& animation);

}  // namespace delabole
