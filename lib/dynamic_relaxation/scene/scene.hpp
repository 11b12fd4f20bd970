// The input of dynamic relaxation: rigid convex blocks, the joints between them, and what loads them.
//
// Section axes, per metre run: x into the slope, y up. A scene may use any frame, for instance with the x axis along an
// inclined base: `gravity` then gives the downward direction. SI units and radians.
//
// Blocks touch at corners: a corner of one on an edge of another (Cundall 1971). Faces that lie on each other touch at
// the two ends of their shared length, each of which is a corner of one of them.
#pragma once

#include "geometry/polygon.hpp"
#include "parameters/fields.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace delabole {

// Intact rock, until it breaks, across faces of two blocks that lie on each other in the initial geometry (bonds.hpp).
struct BondMaterial {
    double young_modulus;
    double shear_modulus;
    double tensile_strength;
    double cohesion;
    double friction_angle;
    // Stiffness per area is modulus over spacing. The centroid of a fixed block counts as at no distance from the face.
    std::optional<double> spacing = {};

    bool operator==(const BondMaterial&) const = default;

    static constexpr auto fields() {
        using B = BondMaterial;
        return FieldTable{
            number<&B::young_modulus>(Dimension::stress, more_than(0),
                                      "of the plane: E in plane stress, E / (1 - nu^2) in plane strain"),
            number<&B::shear_modulus>(Dimension::stress, more_than(0), "of the rock"),
            number<&B::tensile_strength>(Dimension::stress, at_least(0), "of the rock"),
            number<&B::cohesion>(Dimension::stress, at_least(0), "of the rock"),
            number<&B::friction_angle>(Dimension::angle, right_open(0, degrees(90)), "of the rock"),
            number<&B::spacing>(Dimension::length, more_than(0),
                                "over which the rock deforms; absent: of the blocks' centroids from the face")};
    }
};

// Stiffness of one corner on one edge, whatever the length of the face: in the thesis 2e6 N/m for each inch of a
// column's height (5.3).
struct JointMaterial {
    double normal_stiffness;  // N/m per metre run, more than 0
    double shear_stiffness;   // N/m per metre run, more than 0
    double friction_angle;    // peak, 0 to below 90 deg
    // Applies after the first slip or opening, if there is a peak: Fig 5.4(c). Unset: the friction angle, as in Fig
    // 5.4(b).
    std::optional<double> residual_friction_angle = {};
    // Pa over the shared length of the faces, lost with the first slip or opening. Half of it acts at either end; it is
    // spread over the face as long as the joint has a bond of its own (FaceBond).
    double cohesion = 0;
    double tensile_strength = 0;  // Pa, of the joint's own bond, lost where an end lifts off
    // Intact rock that bridges faces of this joint until it breaks. Unset: the joint is open.
    std::optional<BondMaterial> bond = {};
    // Pa, the part of the cohesion that is not lost, at most all of it: then the joint is perfectly plastic in shear.
    double residual_cohesion = 0;

    bool operator==(const JointMaterial&) const = default;
};

// Two faces that lie on each other in the initial geometry, at least one of them of a free block.
struct FaceBond {
    std::size_t block;
    std::size_t edge;
    std::size_t other;
    std::size_t other_edge;
    // Whether rock bridges them, that of their joints. If not, the joint's own strength acts over the whole face
    // (bonds.hpp).
    bool of_rock;
};

struct RelaxationBlock {
    Polygon<> outline;                    // convex, anticlockwise, first vertex not repeated
    double density;                       // kg/m3, more than 0
    bool fixed = false;                   // moves only as prescribed
    bool held_at_first = false;           // does not move while the others consolidate (5.3.2)
    std::vector<std::size_t> joint = {};  // material of each edge, edge n from vertex n to n + 1; empty: material 0
};

// Gravity is acceleration (-sin tilt, -cos tilt): the frame of the scene is that of a base that dips towards -x by
// `tilt`.
struct Gravity {
    double acceleration = 9.80665;  // m/s2, at least 0
    double tilt = 0;                // initial value
    double final_tilt = 0;          // reached at `rate`, in increments; constant if equal to `tilt`
    double rate = 0;                // rad/s, at least 0
    double interval = 0;            // s between increments; 0: every step
    double start = 0;               // s; time of the first increment
};

struct PointForce {
    std::size_t block;
    PlanePoint<> at;     // in the initial geometry; moves with the block
    PlanePoint<> force;  // N/m, along the axes of the section; keeps its direction in them, also while gravity rotates
};

// A whole bolt, or a grouted one where it crosses a joint: a spring that pulls two points of two blocks together
// (bolts.hpp).
struct BoltSegment {
    std::size_t bolt;  // number of the bolt that it belongs to
    std::size_t block;
    std::size_t other;
    PlanePoint<> at;        // on `block`, in the initial geometry
    PlanePoint<> other_at;  // on `other`
    double stiffness;       // N/m per metre run, more than 0
    double pretension;      // N/m, at most the capacity
    double capacity;        // N/m, at which it yields
};

// Part of an edge, m from its first vertex.
struct EdgePart {
    double begin;  // at least 0
    double end;    // more than `begin`
};

// Water pressure in a joint on one face of one block, linear from the edge's first vertex to its second and normal to
// the face wherever the block moves. The joint's other face has a pressure of its own (joint_water.hpp).
struct FacePressure {
    std::size_t block;
    std::size_t edge;
    double at_first;                    // Pa, at least 0; where the part begins
    double at_second;                   // Pa, at least 0; where it ends
    std::optional<EdgePart> part = {};  // loaded part; unset: the whole edge
    bool drains = false;                // goes with a block that is taken away from the face
};

struct TimedVector {
    double time;         // s, increasing
    PlanePoint<> value;  // linear between
};

struct PrescribedMotion {
    std::size_t block;  // a fixed one
    std::vector<TimedVector>
        velocity;  // m/s, of the centroid, section axes; zero before the first, then constant after the last
    double angular_velocity = 0;  // rad/s about `pivot`, from `start` for `duration`
    PlanePoint<> pivot = {0, 0};
    double start = 0;
    double duration = 0;
};

struct Removal {
    std::size_t block;
    double time;  // s; negative: the block is absent from the start
};

// A belt under the section that moves in gravity's direction and drives the blocks by friction instead of gravity,
// whose acceleration presses them onto it (base_friction.hpp).
struct Belt {
    double speed;
    double friction_angle;
    static constexpr auto fields() {
        return FieldTable{
            number("belt_speed", &Belt::speed, Dimension::speed, more_than(0),
                   "of the belt, with the direction gravity would have"),
            number<&Belt::friction_angle>(Dimension::angle, between(0, degrees(90)), "of the blocks on the belt")};
    }
};

struct RelaxationScene {
    std::vector<RelaxationBlock> block = {};
    std::vector<JointMaterial> material = {};
    Gravity gravity = {};
    std::vector<PointForce> force = {};
    std::vector<FacePressure> pressure = {};
    // Acceleration of the ground, m/s2: horizontal, towards +x in a section that is not tilted, and upward. Both
    // directions follow gravity's at that time, on a belt the belt's. It is zero before the first and after the last
    // value; a single value is constant. The scene is seen from the ground.
    std::vector<TimedVector> shaking = {};
    std::vector<PrescribedMotion> motion = {};
    std::vector<Removal> removal = {};
    std::vector<FaceBond> bond = {};
    std::optional<Belt> belt = {};
    std::vector<BoltSegment> bolt = {};
};

enum class SceneCheck {
    valid,
    no_free_block,
    no_block_left,  // all that are free are taken away
    number_not_finite,
    outline_not_convex,   // or clockwise, or with fewer than three vertices
    edge_too_short,       // below 1e-6 of the block's size
    sizes_too_different,  // edges of the scene differ by more than 1e5 : 1
    density_not_positive,
    stiffness_not_positive,
    stiffness_too_soft,   // a block would sink into its joint by more than a tenth of its size
    stiffness_too_stiff,  // rounding would hide overlaps
    friction_out_of_range,
    strength_negative,  // or a residual cohesion above the cohesion
    unknown_block,
    unknown_material,
    unknown_edge,
    times_not_increasing,
    motion_of_free_block,
    overlap_at_start,   // more than 10 times that under the block's own weight, and not of a closed joint
    load_out_of_range,  // gravity, rates, durations and water pressures are not negative
    setting_out_of_range,
    bond_without_face,     // the two faces do not lie on each other in the initial geometry
    modulus_not_positive,  // or spacing
    bolt_outside_blocks,   // its head or its end, or it crosses no joint
};

struct SceneFault {
    SceneCheck check = SceneCheck::valid;
    std::size_t index = 0;                  // of the block, material, force, ... at fault
    std::optional<std::size_t> other = {};  // the second block of an overlap
};

}  // namespace delabole
