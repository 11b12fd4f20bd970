// Input of dynamic relaxation in a case file: a scene of blocks with their joints, and its loads.
//
// Section axes, per metre run: x into the slope, y up in the section, which dips towards -x by the scene's
// tilt. Blocks are counted from 1: in a row and on a stepped base from the toe up, then the fixed blocks below. SI
// units and radians.
#pragma once

#include "dynamic_relaxation/scene/slope_parameters.hpp"
#include "jointed_slope/slope_geometry.hpp"
#include "parameters/fields.hpp"
#include "parameters/lengths.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

namespace delabole {

enum class BlockHold { free, fixed, held_at_first };

inline constexpr std::string_view hold_meaning =
    "fixed moves only as prescribed, held_at_first not before settings.consolidation_time; absent: free";

// Intact rock, until it breaks, across faces that lie on each other in the initial geometry (bonds.hpp).
struct RelaxationBond {
    double young_modulus;
    double shear_modulus;
    double tensile_strength;
    double cohesion;
    double friction_angle;
    std::optional<double> spacing;
    static constexpr auto fields() {
        using B = RelaxationBond;
        return std::tuple{
            number("young_modulus", &B::young_modulus, Dimension::stress, more_than(0),
                   "of the plane: E in plane stress, E / (1 - nu^2) in plane strain"),
            number("shear_modulus", &B::shear_modulus, Dimension::stress, more_than(0), "of the rock"),
            number("tensile_strength", &B::tensile_strength, Dimension::stress, at_least(0), "of the rock"),
            number("cohesion", &B::cohesion, Dimension::stress, at_least(0), "of the rock"),
            number("friction_angle", &B::friction_angle, Dimension::angle, right_open(0, degrees(90)), "of the rock"),
            number("spacing", &B::spacing, Dimension::length, more_than(0),
                   "over which the rock deforms; absent: of the blocks' centroids from the face")};
    }
};

// Strength applies to the shared length of two faces, stiffness to one corner on one edge.
struct RelaxationJoint {
    double friction_angle;
    std::optional<double> residual_friction_angle;
    std::optional<double> cohesion;
    std::optional<double> tensile_strength;
    std::optional<double> normal_stiffness;
    std::optional<double> shear_stiffness;
    std::optional<RelaxationBond> bond;
    std::optional<double> residual_cohesion = {};
    static constexpr auto fields() {
        using J = RelaxationJoint;
        return std::tuple{number("friction_angle", &J::friction_angle, Dimension::angle, right_open(0, degrees(90)),
                                 "peak friction angle"),
                          number("residual_friction_angle", &J::residual_friction_angle, Dimension::angle,
                                 right_open(0, degrees(90)), "after the first slip or opening; absent: as the peak"),
                          number("cohesion", &J::cohesion, Dimension::stress, at_least(0),
                                 "lost with the first slip or opening; absent: none"),
                          number("residual_cohesion", &J::residual_cohesion, Dimension::stress, at_least(0),
                                 "what of the cohesion is not lost; absent: none"),
                          number("tensile_strength", &J::tensile_strength, Dimension::stress, at_least(0),
                                 "lost with the first opening; absent: none"),
                          number("normal_stiffness", &J::normal_stiffness, Dimension::stiffness, more_than(0),
                                 "of a corner on an edge; absent: by settings.stiffness_ratio"),
                          number("shear_stiffness", &J::shear_stiffness, Dimension::stiffness, more_than(0),
                                 "of a corner on an edge; absent: as the normal stiffness"),
                          section("bond", &J::bond, "rock that holds until it breaks; absent: an open joint")};
    }
};

struct RelaxationRowBlock {
    double width;
    double height;
    std::optional<BlockHold> hold;
    static constexpr auto fields() {
        using B = RelaxationRowBlock;
        return std::tuple{number("width", &B::width, Dimension::length, more_than(0), "along the base"),
                          number("height", &B::height, Dimension::length, more_than(0), "normal to the base"),
                          section("hold", &B::hold, hold_meaning)};
    }
};

struct RelaxationColumn {
    double width;
    double height;
    double step_above;
    std::optional<BlockHold> hold;
    static constexpr auto fields() {
        using C = RelaxationColumn;
        return std::tuple{number("width", &C::width, Dimension::length, more_than(0), "along the base"),
                          number("height", &C::height, Dimension::length, more_than(0), "normal to the base"),
                          number("step_above", &C::step_above, Dimension::length, at_least(0),
                                 "from its base up to that of the next column"),
                          section("hold", &C::hold, hold_meaning)};
    }
};

// Scatter of laboratory blocks. Each height and the friction angle of each base and each interface are drawn from
// normal distributions about the given values, cut off at twice the deviation; cohesion and stiffness are as given.
struct RelaxationScatter {
    double seed;
    double height_deviation;
    double friction_deviation;
    static constexpr auto fields() {
        using S = RelaxationScatter;
        return std::tuple{number("seed", &S::seed, Dimension::ratio, within(0, 1e9), "of the random numbers"),
                          number("height_deviation", &S::height_deviation, Dimension::ratio, right_open(0, 0.5),
                                 "standard deviation of a height over the height"),
                          number("friction_deviation", &S::friction_deviation, Dimension::angle,
                                 right_open(0, degrees(20)), "standard deviation of a friction angle")};
    }
};

// Blocks side by side on one plane, from the toe up; the plane is the last block.
struct RelaxationRow {
    double tilt;
    double density;
    RelaxationJoint interface;
    RelaxationJoint base;
    std::optional<RelaxationScatter> scatter;
    std::vector<RelaxationRowBlock> block;
    static constexpr std::string_view kind = "row";
    static constexpr auto fields() {
        using R = RelaxationRow;
        return std::tuple{
            number("tilt", &R::tilt, Dimension::angle, between(degrees(-90), degrees(90)), "dip of the plane, to -x"),
            number("density", &R::density, Dimension::density, more_than(0), "of the rock"),
            section("interface", &R::interface, "joints between the blocks"),
            section("base", &R::base, "joint below the blocks"),
            section("scatter", &R::scatter, "of heights and friction; absent: none"),
            section("block", &R::block, "blocks from the toe up")};
    }
};

// Columns, each on a fixed block of its own, from the toe up.
struct RelaxationColumns {
    double tilt;
    double density;
    RelaxationJoint interface;
    RelaxationJoint base;
    std::optional<RelaxationScatter> scatter;
    std::vector<RelaxationColumn> block;
    static constexpr std::string_view kind = "stepped_base";
    static constexpr auto fields() {
        using C = RelaxationColumns;
        return std::tuple{
            number("tilt", &C::tilt, Dimension::angle, between(degrees(-90), degrees(90)), "dip of the bases, to -x"),
            number("density", &C::density, Dimension::density, more_than(0), "of the rock"),
            section("interface", &C::interface, "joints between the columns"),
            section("base", &C::base, "joints below the columns"),
            section("scatter", &C::scatter, "of heights and friction; absent: none"),
            section("block", &C::block, "columns from the toe up")};
    }
};

struct RelaxationVertex {
    double x;
    double y;
    std::optional<double> joint;
    static constexpr auto fields() {
        using V = RelaxationVertex;
        return std::tuple{number("x", &V::x, Dimension::length, any_number(), "in the initial geometry"),
                          number("y", &V::y, Dimension::length, any_number(), "in the initial geometry"),
                          number("joint", &V::joint, Dimension::ratio, at_least(1),
                                 "number of the joint along the edge to the next vertex; absent: the block's")};
    }
};

struct RelaxationPolygon {
    double density;
    std::optional<BlockHold> hold;
    std::optional<double> joint;
    std::vector<RelaxationVertex> vertex;
    static constexpr auto fields() {
        using P = RelaxationPolygon;
        return std::tuple{number("density", &P::density, Dimension::density, more_than(0), "of the rock"),
                          section("hold", &P::hold, hold_meaning),
                          number("joint", &P::joint, Dimension::ratio, at_least(1),
                                 "number of the joint along its edges; absent: the first"),
                          section("vertex", &P::vertex, "corners, convex and anticlockwise")};
    }
};

// Any convex blocks. Two faces in contact have the properties of the joint with less friction.
struct RelaxationPolygons {
    double tilt;
    std::vector<RelaxationJoint> joint;
    std::vector<RelaxationPolygon> block;

    static constexpr std::string_view kind = "blocks";
    static constexpr auto fields() {
        using P = RelaxationPolygons;
        return std::tuple{number("tilt", &P::tilt, Dimension::angle, between(degrees(-90), degrees(90)),
                                 "of gravity against the section, as if that dipped to -x"),
                          section("joint", &P::joint, "properties of joints, counted from 1"),
                          section("block", &P::block, "the blocks, counted from 1")};
    }
};

struct SlopeJoint {
    std::string name;
    std::optional<double> water_share;
    RelaxationJoint strength;
    static constexpr auto fields() {
        using J = SlopeJoint;
        return std::tuple{section("name", &J::name, "by which cuts refer to it"),
                          number("water_share", &J::water_share, Dimension::ratio, within(0, 1),
                                 "of the pressure below the water table that acts in it; absent: 1"),
                          inlined(&J::strength, "strength and stiffness")};
    }
};

// A section cut into blocks by joints; see jointed_slope/jointed_section.hpp and
// dynamic_relaxation/scene/slope_scene.hpp.
struct RelaxationSlope {
    std::optional<double> tilt;
    SlopeGeometry geometry;
    std::vector<SlopeRock> rock;
    std::vector<SlopeJoint> joint;
    std::optional<SlopeFrame> frame;
    std::optional<SlopeWater> water;
    std::vector<SlopeArea> fixed;
    std::vector<SlopeStage> stage;

    static constexpr std::string_view kind = "jointed_slope";
    static constexpr auto fields() {
        using S = RelaxationSlope;
        return std::tuple{number("tilt", &S::tilt, Dimension::angle, between(degrees(-90), degrees(90)),
                                 "of gravity against the section, as if that dipped to -x; absent: 0"),
                          inlined(&S::geometry, "outline and cuts"),
                          section("rock", &S::rock, "rocks; all is of the first where no line says otherwise"),
                          section("joint", &S::joint, "properties of joints; surfaces have those of the first"),
                          section("frame", &S::frame, "fixed blocks around the section"),
                          section("water", &S::water, "water in the joints"),
                          section("fixed", &S::fixed, "areas whose blocks are fixed"),
                          section("stage", &S::stage, "areas whose blocks are taken away: excavation in stages")};
    }
};

using BlockScene = std::variant<RelaxationRow, RelaxationColumns, RelaxationPolygons, RelaxationSlope>;

enum class TiltingFrame { gravity, base };

// A base that is either the frame of reference while gravity rotates, or is rotated as in a laboratory, about a pivot
// and with inertia.
struct Tilting {
    TiltingFrame turned;
    double final_tilt;
    double rate;
    std::optional<double> interval;
    std::optional<double> start;
    std::optional<double> pivot_x;
    std::optional<double> pivot_y;
    static constexpr auto fields() {
        using T = Tilting;
        return std::tuple{
            section("turned", &T::turned, "gravity in the section, or the fixed blocks under it"),
            number("final_tilt", &T::final_tilt, Dimension::angle, between(degrees(-90), degrees(90)), "tilt reached"),
            number("rate", &T::rate, Dimension::angular_speed, more_than(0), "speed of tilting"),
            number("interval", &T::interval, Dimension::time, at_least(0),
                   "between increments of gravity's tilt; absent: continuous"),
            number("start", &T::start, Dimension::time, at_least(0), "of tilting; absent: 0"),
            number("pivot_x", &T::pivot_x, Dimension::length, any_number(), "of the base; absent: 0"),
            number("pivot_y", &T::pivot_y, Dimension::length, any_number(), "of the base; absent: 0")};
    }
};

// The model lies on a belt, whose friction drives it instead of gravity: see base_friction.hpp.
struct BaseFriction {
    double belt_speed;
    double friction_angle;
    static constexpr auto fields() {
        using B = BaseFriction;
        return std::tuple{number("belt_speed", &B::belt_speed, Dimension::speed, more_than(0),
                                 "of the belt, with the direction gravity would have"),
                          number("friction_angle", &B::friction_angle, Dimension::angle, between(0, degrees(90)),
                                 "of the blocks on the belt")};
    }
};

struct ForceOnBlock {
    double block;
    double x;
    double y;
    double horizontal;
    double vertical;
    static constexpr auto fields() {
        using F = ForceOnBlock;
        return std::tuple{number("block", &F::block, Dimension::ratio, at_least(1), "number of the block"),
                          number("x", &F::x, Dimension::length, any_number(),
                                 "where it acts, in the initial geometry; moves with the block"),
                          number("y", &F::y, Dimension::length, any_number(), "where it acts, in the initial geometry"),
                          number("horizontal", &F::horizontal, Dimension::force_per_length, any_number(),
                                 "along x of the section, however it is tilted"),
                          number("vertical", &F::vertical, Dimension::force_per_length, any_number(),
                                 "along y of the section, likewise")};
    }
};

struct BoltBar {
    double plunge;
    double length;
    double spacing;
    double axial_stiffness;
    double capacity;
    std::optional<double> pretension;
    std::optional<double> free_length_at_joints;
    static constexpr auto fields() {
        using B = BoltBar;
        return std::tuple{
            number("plunge", &B::plunge, Dimension::angle, within(degrees(-90), degrees(90)),
                   "below the section's x axis"),
            number("length", &B::length, Dimension::length, extent_range(), "from its head to its end"),
            number("spacing", &B::spacing, Dimension::length, extent_range(), "along the slope, from bolt to bolt"),
            number("axial_stiffness", &B::axial_stiffness, Dimension::force, more_than(0), "modulus times area"),
            number("capacity", &B::capacity, Dimension::force, more_than(0), "tension at which it yields"),
            number("pretension", &B::pretension, Dimension::force, at_least(0), "at the start; absent: 0"),
            number("free_length_at_joints", &B::free_length_at_joints, Dimension::length, extent_range(),
                   "over which a grouted bolt stretches at each joint; absent: it stretches over its whole length")};
    }
};

struct RelaxationBolt {
    double head_x;
    double head_y;
    BoltBar bar;
    static constexpr auto fields() {
        return std::tuple{number("head_x", &RelaxationBolt::head_x, Dimension::length, any_number(),
                                 "its head, on the face of a block"),
                          number("head_y", &RelaxationBolt::head_y, Dimension::length, any_number(), "likewise"),
                          inlined(&RelaxationBolt::bar, "the bar")};
    }
};

struct BoltRows {
    double rows;
    double lowest_height;
    double row_spacing;
    BoltBar bar;
    static constexpr auto fields() {
        return std::tuple{
            number("rows", &BoltRows::rows, Dimension::ratio, within(1, 1000), "number of rows, a whole one"),
            number("lowest_height", &BoltRows::lowest_height, Dimension::length, any_number(),
                   "of the lowest heads above the section's lowest corner"),
            number("row_spacing", &BoltRows::row_spacing, Dimension::length, extent_range(), "from row to row"),
            inlined(&BoltRows::bar, "the bars")};
    }
};

struct WaterPressure {
    double block;
    double edge;
    double at_first;
    double at_second;
    static constexpr auto fields() {
        using P = WaterPressure;
        return std::tuple{
            number("block", &P::block, Dimension::ratio, at_least(1), "number of the block"),
            number("edge", &P::edge, Dimension::ratio, at_least(1),
                   "number of the face, anticlockwise from the first corner (of a row: 1 below, 2 up-slope)"),
            number("at_first", &P::at_first, Dimension::stress, at_least(0), "pressure at the face's first corner"),
            number("at_second", &P::at_second, Dimension::stress, at_least(0), "pressure at its second corner")};
    }
};

struct WaterInJoint {
    double block;
    double other;
    double at_first;
    double at_second;
    static constexpr auto fields() {
        using W = WaterInJoint;
        return std::tuple{
            number("block", &W::block, Dimension::ratio, at_least(1), "number of a block"),
            number("other", &W::other, Dimension::ratio, at_least(1), "number of a block whose face lies on its face"),
            number(
                "at_first", &W::at_first, Dimension::stress, at_least(0),
                "pressure at the end of what they share that comes first anticlockwise round the block (from a block "
                "of a row to the next one up: below; to the plane: at the toe)"),
            number("at_second", &W::at_second, Dimension::stress, at_least(0),
                   "pressure at its other end, linear between")};
    }
};

struct ShakingPoint {
    double time;
    double horizontal;
    double vertical;
    static constexpr auto fields() {
        using S = ShakingPoint;
        return std::tuple{number("time", &S::time, Dimension::time, at_least(0), "of the record, increasing"),
                          number("horizontal", &S::horizontal, Dimension::acceleration, any_number(),
                                 "of the ground into the slope, truly horizontal: normal to gravity, which a tilt "
                                 "turns in the section"),
                          number("vertical", &S::vertical, Dimension::acceleration, any_number(),
                                 "of the ground, upward against gravity")};
    }
};

struct VelocityPoint {
    double time;
    double horizontal;
    double vertical;
    static constexpr auto fields() {
        using V = VelocityPoint;
        return std::tuple{
            number("time", &V::time, Dimension::time, at_least(0), "of the record, increasing"),
            number("horizontal", &V::horizontal, Dimension::speed, any_number(), "of the centroid, along x"),
            number("vertical", &V::vertical, Dimension::speed, any_number(), "of the centroid, along y")};
    }
};

struct Turning {
    double rate;
    double start;
    double duration;
    double pivot_x;
    double pivot_y;
    static constexpr auto fields() {
        using T = Turning;
        return std::tuple{
            number("rate", &T::rate, Dimension::angular_speed, any_number(), "angular velocity, anticlockwise"),
            number("start", &T::start, Dimension::time, at_least(0), "of turning"),
            number("duration", &T::duration, Dimension::time, at_least(0), "of turning"),
            number("pivot_x", &T::pivot_x, Dimension::length, any_number(), "point turned about"),
            number("pivot_y", &T::pivot_y, Dimension::length, any_number(), "point turned about")};
    }
};

struct FixedBlockMotion {
    double block;
    std::optional<Turning> turning;
    std::vector<VelocityPoint> velocity;
    static constexpr auto fields() {
        using M = FixedBlockMotion;
        return std::tuple{
            number("fixed_block", &M::block, Dimension::ratio, at_least(1), "number of a fixed block"),
            section("turning", &M::turning, "about a point"),
            section("velocity", &M::velocity, "linear between, zero before the first, the last one kept")};
    }
};

struct BlockRemoval {
    double block;
    double time;
    static constexpr auto fields() {
        using R = BlockRemoval;
        return std::tuple{number("block", &R::block, Dimension::ratio, at_least(1), "number of the block"),
                          number("time", &R::time, Dimension::time, at_least(0), "at which it is taken away")};
    }
};

struct Relaxation {
    std::optional<double> gravity;
    std::optional<std::string> shaking_file;
    BlockScene scene;
    std::optional<Tilting> tilting;
    std::optional<BaseFriction> base_friction;
    std::vector<ForceOnBlock> force;
    std::vector<RelaxationBolt> bolt;
    std::vector<BoltRows> support;
    std::vector<WaterPressure> pressure;
    std::vector<WaterInJoint> joint_water;
    std::vector<ShakingPoint> shaking;
    std::vector<FixedBlockMotion> motion;
    std::vector<BlockRemoval> removal;
    static constexpr auto fields() {
        using R = Relaxation;
        return std::tuple{
            number("gravity", &R::gravity, Dimension::acceleration, at_least(0), "acceleration; absent: 9.80665 m/s2"),
            section("shaking_file", &R::shaking_file,
                    "CSV file with the record of shaking, beside the case, columns time_s, horizontal_m_per_s2, "
                    "vertical_m_per_s2; or shaking"),
            section("scene", &R::scene, "the blocks and their joints"),
            section("tilting", &R::tilting, "tilt that grows"),
            section("base_friction", &R::base_friction,
                    "a belt that drives the blocks, pressed on it by gravity; absent: gravity drives them"),
            section("force", &R::force, "point forces, along the axes of the section"),
            section("bolt", &R::bolt, "bolts and cables across joints"),
            section("support", &R::support, "rows of bolts, heads on the left of a jointed_slope's outline"),
            section("pressure", &R::pressure, "water on single faces of blocks"),
            section("joint_water", &R::joint_water,
                    "water between two blocks, on both, over what their faces share at the start"),
            section("shaking", &R::shaking,
                    "record of the ground's acceleration: linear between, zero before the first and after the last; "
                    "one alone: that acceleration from its time on"),
            section("motion", &R::motion, "prescribed motion of fixed blocks"),
            section("removal", &R::removal, "blocks taken away: excavation")};
    }
};

}  // namespace delabole
