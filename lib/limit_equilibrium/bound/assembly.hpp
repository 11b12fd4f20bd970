// Rigid bodies that touch along straight faces: what a row of blocks, a stepped base and a slope cut by cross joints
// have in common. Section axes, per metre run: x into the slope, y up, weight along -y.
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
    BodyLoad load;   // all that acts beside the weight: water, anchors, loads on top
};

// A plane face. Water pressure on it belongs to the loads of the bodies, its own forces are effective ones.
struct Contact {
    std::size_t body;                  // on the left of the way from `start` to `end`
    std::optional<std::size_t> other;  // on the right; none: the fixed base
    Point start;
    Point end;
    double friction_angle;
    double cohesion;              // Pa, over the whole face; it resists shear, not opening
    double tensile_strength = 0;  // Pa; half of the face's at each end

    double length() const { return (end - start).norm(); }
    Point along() const { return (end - start) / length(); }
    Point normal() const { return {-along().y(), along().x()}; }  // into `body`
};

struct Assembly {
    AssemblyCheck check = AssemblyCheck::no_bodies;  // of the builder
    std::vector<Body> bodies;
    std::vector<Contact> contacts;
};

// Forces of light bodies drown in the tolerances of linear programming beside those of heavy ones. Measured with one of
// the columns of Appendix A enlarged: right at a ratio of 1e8, wrong without a word at 1e9.
inline constexpr double greatest_weight_ratio = 1e7;

// The builder's reason where it had one, otherwise what is wrong with the bodies and contacts themselves.
AssemblyCheck check_assembly(const Assembly& assembly);

}  // namespace delabole
