// Rigid bodies that touch along straight faces: the common form of a row of blocks, a stepped base and a slope cut by
// cross joints. Section axes, per metre run: x into the slope, y up, weight along -y.
#pragma once

#include "geometry/polyline.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace delabole {

enum class AssemblyCheck {
    valid,
    no_bodies,
    block_without_size,         // width or height not above 0
    weight_not_positive,        // a body without weight, or with a negative one
    weights_too_different,      // the heaviest over the lightest beyond greatest_weight_ratio
    contact_of_unknown_body,    // index beyond the bodies, or a body against itself
    contact_without_length,     // its two ends coincide
    friction_not_below_90_deg,  // or negative
    cohesion_negative,          // or tensile strength
    columns_not_valid,          // the columns given were refused by their own check
    loads_beyond_weight,        // cross joints cut columns under their own weight alone
    cross_joints_too_near,      // spacing or offset out of range, or more blocks than `most_blocks`
    input_out_of_range,         // not finite
};

// Force on a body at its centroid, N/m, and moment about it, anticlockwise, N.
struct BodyLoad {
    Point force{0, 0};
    double moment = 0;
};

struct Body {
    double weight;   // N/m
    Point centroid;  // where the weight acts
    BodyLoad load;   // all loads besides the weight: water, anchors, loads on top
};

// A plane face. Water pressure on it belongs to the loads of the bodies; the forces of the face are effective ones.
struct Contact {
    std::size_t body;                  // to the left of the direction from `start` to `end`
    std::optional<std::size_t> other;  // to the right; absent: the fixed base
    Point start;
    Point end;
    double friction_angle;
    double cohesion;                // Pa, over the whole face; it resists shear, not opening
    double tensile_strength = 0;    // Pa; half of the face's at each end
    bool bears_compression = true;  // and friction, which without it is as of no angle

    double length() const { return (end - start).norm(); }
    Point along() const { return (end - start) / length(); }
    Point normal() const { return {-along().y(), along().x()}; }  // into `body`
};

struct Assembly {
    AssemblyCheck check = AssemblyCheck::no_bodies;  // set by the builder
    std::vector<Body> bodies;
    std::vector<Contact> contacts;
};

// Beside the forces of heavy bodies those of light ones fall below the tolerances of linear programming. Measured with
// one of the columns of Appendix A enlarged: the result is correct at a ratio of 1e8 and wrong without a warning at
// 1e9.
inline constexpr double greatest_weight_ratio = 1e7;

// The builder's reason if there is one, otherwise any fault of the bodies and contacts themselves.
AssemblyCheck check_assembly(const Assembly& assembly);

}  // namespace delabole
