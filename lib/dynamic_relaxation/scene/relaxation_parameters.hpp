// Input of dynamic relaxation in a case file: a scene of blocks with their joints, and its loads.
//
// Section axes, per metre run: x into the slope, y up in the section, which dips towards -x by the scene's
// tilt. Blocks are counted from 1: in a row and on a stepped base from the toe up, then the fixed blocks below. SI
// units and radians.
#pragma once

#include "dynamic_relaxation/scene/scene.hpp"
#include "dynamic_relaxation/scene/slope_parameters.hpp"
#include "jointed_slope/slope_geometry.hpp"
#include "parameters/fields.hpp"
#include "parameters/lengths.hpp"
#include "support/bolt_pattern.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace delabole {

enum class BlockHold { free, fixed, held_at_first };

inline constexpr std::string_view hold_meaning =
    "fixed moves only as prescribed, held_at_first not before settings.consolidation_time; absent: free";

// Strength applies to the shared length of two faces, stiffness to one corner on one edge.
struct RelaxationJoint {
    double friction_angle;
    std::optional<double> residual_friction_angle;
    std::optional<double> cohesion;
    std::optional<double> tensile_strength;
    std::optional<double> normal_stiffness;
    std::optional<double> shear_stiffness;
    std::optional<BondMaterial> bond;
    std::optional<double> residual_cohesion = {};
    static constexpr auto fields() {
        using J = RelaxationJoint;
        return FieldTable{
            number<&J::friction_angle>(Dimension::angle, right_open(0, degrees(90)), "peak friction angle"),
            number<&J::residual_friction_angle>(Dimension::angle, right_open(0, degrees(90)),
                                                "after the first slip or opening; absent: as the peak"),
            number<&J::cohesion>(Dimension::stress, at_least(0), "lost with the first slip or opening; absent: none"),
            number<&J::residual_cohesion>(Dimension::stress, at_least(0),
                                          "what of the cohesion is not lost; absent: none"),
            number<&J::tensile_strength>(Dimension::stress, at_least(0), "lost with the first opening; absent: none"),
            number<&J::normal_stiffness>(Dimension::stiffness, more_than(0),
                                         "of a corner on an edge; absent: by settings.stiffness_ratio"),
            number<&J::shear_stiffness>(Dimension::stiffness, more_than(0),
                                        "of a corner on an edge; absent: as the normal stiffness"),
            section<&J::bond>("rock that holds until it breaks; absent: an open joint")};
    }
};

struct RelaxationRowBlock {
    double width;
    double height;
    std::optional<BlockHold> hold;
    static constexpr auto fields() {
        return FieldTable{number<&RelaxationRowBlock::width>(Dimension::length, more_than(0), "along the base"),
                          number<&RelaxationRowBlock::height>(Dimension::length, more_than(0), "normal to the base"),
                          section<&RelaxationRowBlock::hold>(hold_meaning)};
    }
};

struct RelaxationColumn {
    double width;
    double height;
    double step_above;
    std::optional<BlockHold> hold;
    static constexpr auto fields() {
        return FieldTable{number<&RelaxationColumn::width>(Dimension::length, more_than(0), "along the base"),
                          number<&RelaxationColumn::height>(Dimension::length, more_than(0), "normal to the base"),
                          number<&RelaxationColumn::step_above>(Dimension::length, at_least(0),
                                                                "from its base up to that of the next column"),
                          section<&RelaxationColumn::hold>(hold_meaning)};
    }
};

// Scatter of laboratory blocks. Each height and the friction angle of each base and each interface are drawn from
// normal distributions about the given values, cut off at twice the deviation; cohesion and stiffness are as given.
struct RelaxationScatter {
    double seed;
    double height_deviation;
    double friction_deviation;
    static constexpr auto fields() {
        return FieldTable{number<&RelaxationScatter::seed>(within(0, 1e9), "of the random numbers"),
                          number<&RelaxationScatter::height_deviation>(
                              right_open(0, 0.5), "standard deviation of a height over the height"),
                          number<&RelaxationScatter::friction_deviation>(Dimension::angle, right_open(0, degrees(20)),
                                                                         "standard deviation of a friction angle")};
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
        return FieldTable{number<&RelaxationRow::tilt>(Dimension::angle, between(degrees(-90), degrees(90)),
                                                       "dip of the plane, to -x"),
                          number<&RelaxationRow::density>(Dimension::density, more_than(0), "of the rock"),
                          section<&RelaxationRow::interface>("joints between the blocks"),
                          section<&RelaxationRow::base>("joint below the blocks"),
                          section<&RelaxationRow::scatter>("of heights and friction; absent: none"),
                          section<&RelaxationRow::block>("blocks from the toe up")};
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
        return FieldTable{number<&RelaxationColumns::tilt>(Dimension::angle, between(degrees(-90), degrees(90)),
                                                           "dip of the bases, to -x"),
                          number<&RelaxationColumns::density>(Dimension::density, more_than(0), "of the rock"),
                          section<&RelaxationColumns::interface>("joints between the columns"),
                          section<&RelaxationColumns::base>("joints below the columns"),
                          section<&RelaxationColumns::scatter>("of heights and friction; absent: none"),
                          section<&RelaxationColumns::block>("columns from the toe up")};
    }
};

struct RelaxationVertex {
    double x;
    double y;
    std::optional<double> joint;
    static constexpr auto fields() {
        return FieldTable{
            number<&RelaxationVertex::x>(Dimension::length, "in the initial geometry"),
            number<&RelaxationVertex::y>(Dimension::length, "in the initial geometry"),
            number<&RelaxationVertex::joint>(
                at_least(1), "number of the joint along the edge to the next vertex; absent: the block's")};
    }
};

struct RelaxationPolygon {
    double density;
    std::optional<BlockHold> hold;
    std::optional<double> joint;
    std::vector<RelaxationVertex> vertex;
    static constexpr auto fields() {
        using P = RelaxationPolygon;
        return FieldTable{number<&P::density>(Dimension::density, more_than(0), "of the rock"),
                          section<&P::hold>(hold_meaning),
                          number<&P::joint>(at_least(1), "number of the joint along its edges; absent: the first"),
                          section<&P::vertex>("corners, convex and anticlockwise")};
    }
};

// Any convex blocks. Two faces in contact have the lesser friction, cohesion and tensile strength of their joints.
struct RelaxationPolygons {
    double tilt;
    std::vector<RelaxationJoint> joint;
    std::vector<RelaxationPolygon> block;

    static constexpr std::string_view kind = "blocks";
    static constexpr auto fields() {
        return FieldTable{number<&RelaxationPolygons::tilt>(Dimension::angle, between(degrees(-90), degrees(90)),
                                                            "of gravity against the section, as if that dipped to -x"),
                          section<&RelaxationPolygons::joint>("properties of joints, counted from 1"),
                          section<&RelaxationPolygons::block>("the blocks, counted from 1")};
    }
};

struct SlopeJoint {
    std::string name;
    std::optional<double> water_share;
    RelaxationJoint strength;
    static constexpr auto fields() {
        return FieldTable{section<&SlopeJoint::name>("by which cuts refer to it"),
                          number<&SlopeJoint::water_share>(
                              within(0, 1), "of the pressure below the water table that acts in it; absent: 1"),
                          inlined(&SlopeJoint::strength, "strength and stiffness")};
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
        return FieldTable{
            number<&S::tilt>(Dimension::angle, between(degrees(-90), degrees(90)),
                             "of gravity against the section, as if that dipped to -x; absent: 0"),
            inlined(&S::geometry, "outline and cuts"),
            section<&S::rock>("rocks; all is of the first where no line says otherwise"),
            section<&S::joint>("properties of joints; surfaces have those of the first"),
            section<&S::frame>("fixed blocks around the section"),
            section<&S::water>("water in the joints"),
            section<&S::fixed>("areas whose blocks are fixed"),
            section<&S::stage>("areas whose blocks are taken away: excavation in stages; faces that it uncovers are "
                               "drained")};
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
        return FieldTable{section<&T::turned>("gravity in the section, or the fixed blocks under it"),
                          number<&T::final_tilt>(Dimension::angle, between(degrees(-90), degrees(90)), "tilt reached"),
                          number<&T::rate>(Dimension::angular_speed, more_than(0), "speed of tilting"),
                          number<&T::interval>(Dimension::time, at_least(0),
                                               "between increments of gravity's tilt; absent: continuous"),
                          number<&T::start>(Dimension::time, at_least(0), "of tilting; absent: 0"),
                          number<&T::pivot_x>(Dimension::length, "of the base; absent: 0"),
                          number<&T::pivot_y>(Dimension::length, "of the base; absent: 0")};
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
        return FieldTable{
            number<&F::block>(at_least(1), "number of the block"),
            number<&F::x>(Dimension::length, "where it acts, in the initial geometry; moves with the block"),
            number<&F::y>(Dimension::length, "where it acts, in the initial geometry"),
            number<&F::horizontal>(Dimension::force_per_length, "along x of the section, however it is tilted"),
            number<&F::vertical>(Dimension::force_per_length, "along y of the section, likewise")};
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
    std::optional<Grout<double>> grout;
    static constexpr auto fields() {
        return FieldTable{
            number<&BoltBar::plunge>(Dimension::angle, within(degrees(-90), degrees(90)), "below the section's x axis"),
            number<&BoltBar::length>(Dimension::length, extent_range(), "from its head to its end"),
            number<&BoltBar::spacing>(Dimension::length, extent_range(), "along the slope, from bolt to bolt"),
            number<&BoltBar::axial_stiffness>(Dimension::force, more_than(0), "modulus times area"),
            number<&BoltBar::capacity>(Dimension::force, more_than(0), "tension at which it yields"),
            number<&BoltBar::pretension>(Dimension::force, at_least(0), "at the start; absent: 0"),
            number<&BoltBar::free_length_at_joints>(
                Dimension::length, extent_range(),
                "over which a grouted bolt stretches at each joint; absent: it stretches over its whole length"),
            section<&BoltBar::grout>(
                "along the whole bolt, with free_length_at_joints; absent: it has its capacity at each joint")};
    }
};

struct RelaxationBolt {
    double head_x;
    double head_y;
    BoltBar bar;
    static constexpr auto fields() {
        return FieldTable{number<&RelaxationBolt::head_x>(Dimension::length, "its head, on the face of a block"),
                          number<&RelaxationBolt::head_y>(Dimension::length, "likewise"),
                          inlined(&RelaxationBolt::bar, "the bar")};
    }
};

struct BoltRows {
    double rows;
    double lowest_height;
    double row_spacing;
    BoltBar bar;
    static constexpr auto fields() {
        return FieldTable{number<&BoltRows::rows>(within(1, 1000), "number of rows, a whole one"),
                          number<&BoltRows::lowest_height>(Dimension::length,
                                                           "of the lowest heads above the section's lowest corner"),
                          number<&BoltRows::row_spacing>(Dimension::length, extent_range(), "from row to row"),
                          inlined(&BoltRows::bar, "the bars")};
    }
};

struct WaterPressure {
    double block;
    double edge;
    double at_first;
    double at_second;
    static constexpr auto fields() {
        return FieldTable{
            number<&WaterPressure::block>(at_least(1), "number of the block"),
            number<&WaterPressure::edge>(
                at_least(1), "number of the face, anticlockwise from the first corner (of a row: 1 below, 2 up-slope)"),
            number<&WaterPressure::at_first>(Dimension::stress, at_least(0), "pressure at the face's first corner"),
            number<&WaterPressure::at_second>(Dimension::stress, at_least(0), "pressure at its second corner")};
    }
};

struct WaterInJoint {
    double block;
    double other;
    double at_first;
    double at_second;
    static constexpr auto fields() {
        using W = WaterInJoint;
        return FieldTable{
            number<&W::block>(at_least(1), "number of a block"),
            number<&W::other>(at_least(1), "number of a block whose face lies on its face"),
            number<&W::at_first>(Dimension::stress, at_least(0),
                                 "pressure at the end of what they share that comes first anticlockwise round the "
                                 "block (from a block of a row to the next one up: below; to the plane: at the toe)"),
            number<&W::at_second>(Dimension::stress, at_least(0), "pressure at its other end, linear between")};
    }
};

struct ShakingPoint {
    double time;
    double horizontal;
    double vertical;
    static constexpr auto fields() {
        return FieldTable{
            number<&ShakingPoint::time>(Dimension::time, at_least(0), "of the record, increasing"),
            number<&ShakingPoint::horizontal>(
                Dimension::acceleration,
                "of the ground into the slope, truly horizontal: normal to gravity, which a tilt turns in the section"),
            number<&ShakingPoint::vertical>(Dimension::acceleration, "of the ground, upward against gravity")};
    }
};

struct VelocityPoint {
    double time;
    double horizontal;
    double vertical;
    static constexpr auto fields() {
        return FieldTable{number<&VelocityPoint::time>(Dimension::time, at_least(0), "of the record, increasing"),
                          number<&VelocityPoint::horizontal>(Dimension::speed, "of the centroid, along x"),
                          number<&VelocityPoint::vertical>(Dimension::speed, "of the centroid, along y")};
    }
};

struct Turning {
    double rate;
    double start;
    double duration;
    double pivot_x;
    double pivot_y;
    static constexpr auto fields() {
        return FieldTable{number<&Turning::rate>(Dimension::angular_speed, "angular velocity, anticlockwise"),
                          number<&Turning::start>(Dimension::time, at_least(0), "of turning"),
                          number<&Turning::duration>(Dimension::time, at_least(0), "of turning"),
                          number<&Turning::pivot_x>(Dimension::length, "point turned about"),
                          number<&Turning::pivot_y>(Dimension::length, "point turned about")};
    }
};

struct FixedBlockMotion {
    double block;
    std::optional<Turning> turning;
    std::vector<VelocityPoint> velocity;
    static constexpr auto fields() {
        using M = FixedBlockMotion;
        return FieldTable{number("fixed_block", &M::block, Dimension::ratio, at_least(1), "number of a fixed block"),
                          section<&M::turning>("about a point"),
                          section<&M::velocity>("linear between, zero before the first, the last one kept")};
    }
};

struct BlockRemoval {
    double block;
    double time;
    static constexpr auto fields() {
        return FieldTable{number<&BlockRemoval::block>(at_least(1), "number of the block"),
                          number<&BlockRemoval::time>(Dimension::time, at_least(0), "at which it is taken away")};
    }
};

struct Relaxation {
    std::optional<double> gravity;
    std::optional<std::string> shaking_file;
    BlockScene scene;
    std::optional<Tilting> tilting;
    std::optional<Belt> base_friction;
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
        return FieldTable{
            absent_is(Gravity{}.acceleration,
                      number<&R::gravity>(Dimension::acceleration, at_least(0), "acceleration")),
            section<&R::shaking_file>("CSV file with the record of shaking, beside the case, columns time_s, "
                                      "horizontal_m_per_s2, vertical_m_per_s2; or shaking"),
            section<&R::scene>("the blocks and their joints"),
            section<&R::tilting>("tilt that grows"),
            section<&R::base_friction>(
                "a belt that drives the blocks, pressed on it by gravity; absent: gravity drives them"),
            section<&R::force>("point forces, along the axes of the section"),
            section<&R::bolt>("bolts and cables across joints"),
            section<&R::support>("rows of bolts, heads on the left of a jointed_slope's outline"),
            section<&R::pressure>("water on single faces of blocks"),
            section<&R::joint_water>(
                "water between two blocks, on both, over what their faces share at the start; gone where one "
                "of them is taken away"),
            section<&R::shaking>("record of the ground's acceleration: linear between, zero before the first and after "
                                 "the last; one alone: that acceleration from its time on"),
            section<&R::motion>("prescribed motion of fixed blocks"),
            section<&R::removal>("blocks taken away: excavation")};
    }
};

}  // namespace delabole
