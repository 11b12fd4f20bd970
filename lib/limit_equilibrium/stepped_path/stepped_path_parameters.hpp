// Case of the model "stepped_path": a slope cut by joint sets along which a failure surface may step.
//
// Section, per metre run. Origin at the toe, x into the slope, y up. Dips are positive out of the slope and negative
// into it. Three sets: `steps` (cleavage, bedding), of which one plane daylights at the toe; `risers`, steep and out of
// the slope, of which one joint passes through the crest; `columns`, steep and into the slope, of which one joint
// passes through the toe.
#pragma once

#include "limit_equilibrium/columns/column_parameters.hpp"
#include "parameters/fields.hpp"
#include "parameters/lengths.hpp"
#include "plane_failure/parameters.hpp"
#include "water/water.hpp"

#include <optional>
#include <string_view>
#include <variant>

namespace delabole {

// `sliding`: one rigid mass on steps, whose risers open. `toppling`: columns that rotate or slide on steps, with a
// crack behind the last one. `slide_head_toppling`: toppling, or toppling with a wedge behind the last column that
// slides on a riser and pushes it, whichever fails first.
enum class SteppedPathMechanism { sliding, toppling, slide_head_toppling };

struct SteppedPathSearch {
    SteppedPathMechanism mechanism;
    std::optional<double> least_width;
    std::optional<double> greatest_retreat;
    static constexpr auto fields() {
        using S = SteppedPathSearch;
        return FieldTable{
            section<&S::mechanism>("how the mass fails"),
            number<&S::least_width>(
                Dimension::length, distance_range(),
                "horizontal width that the failing mass has at least, behind the crest and in front of each riser of a "
                "sliding mass: what is smaller is no failure of the slope; absent: one whole block, the width between "
                "two risers, or between two joints of the columns where they topple without a wedge"),
            number<&S::greatest_retreat>(Dimension::length, extent_range(),
                                         "horizontal distance behind the crest at which the surface comes out at most; "
                                         "absent: the height of the slope")};
    }
};

struct PathSteps {
    double dip;
    double spacing;
    double friction_angle;
    double cohesion;
    static constexpr auto fields() {
        using S = PathSteps;
        return FieldTable{number<&S::dip>(Dimension::angle, between(degrees(-60), degrees(60)),
                                          "of the planes, positive out of the slope, negative into it"),
                          number<&S::spacing>(Dimension::length, extent_range(),
                                              "normal spacing of the planes on which the surface may step; where they "
                                              "lie closer than matters, how finely levels are searched"),
                          number<&S::friction_angle>(Dimension::angle, right_open(0, degrees(90)), "of the planes"),
                          number<&S::cohesion>(Dimension::stress, at_least(0), "of the planes")};
    }
};

struct PathRisers {
    double dip;
    double spacing;
    double friction_angle;
    double cohesion;
    static constexpr auto fields() {
        using R = PathRisers;
        return FieldTable{
            number<&R::dip>(Dimension::angle, left_open(0, degrees(90)), "of the joints, out of the slope"),
            number<&R::spacing>(Dimension::length, extent_range(),
                                "normal spacing of the joints, one of which passes through the crest"),
            number<&R::friction_angle>(Dimension::angle, right_open(0, degrees(90)),
                                       "of the joints, for what slides on one"),
            number<&R::cohesion>(Dimension::stress, at_least(0), "of the joints, for what slides on one")};
    }
};

struct PathColumns {
    double dip;
    double spacing;
    double friction_angle;
    static constexpr auto fields() {
        using C = PathColumns;
        return FieldTable{
            number<&C::dip>(Dimension::angle, within(degrees(-90), degrees(-30)),
                            "of the joints between columns, into the slope: negative"),
            number<&C::spacing>(Dimension::length, extent_range(),
                                "normal spacing of the joints, one of which passes through the toe"),
            number<&C::friction_angle>(Dimension::angle, right_open(0, degrees(90)), "of the joints between columns")};
    }
};

// Where joints end before they meet others, the surface passes through intact rock.
struct RockBridges {
    double step_persistence;
    double riser_persistence;
    double cohesion;
    double friction_angle;
    double tensile_strength;
    static constexpr auto fields() {
        using B = RockBridges;
        return FieldTable{
            number<&B::step_persistence>(within(0, 1), "share of the length along steps that is joint, not rock"),
            number<&B::riser_persistence>(within(0, 1), "the same along risers"),
            number<&B::cohesion>(Dimension::stress, at_least(0), "of the rock"),
            number<&B::friction_angle>(Dimension::angle, right_open(0, degrees(90)), "of the rock"),
            number<&B::tensile_strength>(Dimension::stress, at_least(0), "of the rock, where a riser opens")};
    }
};

// Below a plane the rock is massive and its joints are closed: no surface passes there. The plane itself is taken to be
// as strong as that rock; sliding along it is a case of plane failure.
struct MassiveRock {
    double boundary_dip;
    double boundary_height;
    static constexpr auto fields() {
        using M = MassiveRock;
        return FieldTable{
            number<&M::boundary_dip>(
                Dimension::angle, within(degrees(-60), degrees(89)),
                "of the plane, positive out of the slope; between the dips of the steps and of the risers"),
            number<&M::boundary_height>(Dimension::length, position_range(),
                                        "height above the toe at which the plane meets the face or, below the toe, the "
                                        "face's continuation downwards")};
    }
};

// A water surface drawn down to the toe: straight from there to its level at a given distance, horizontal behind.
struct WaterDrawnDown {
    double unit_weight;
    WaterLevel<> level;
    double reach;
    static constexpr std::string_view kind = "drawn_down";
    static constexpr auto fields() {
        using W = WaterDrawnDown;
        return FieldTable{water_unit_weight_field(&W::unit_weight),
                          inlined(&W::level, "level behind, above the toe; full is the height of the slope"),
                          number<&W::reach>(Dimension::length, extent_range(),
                                            "horizontal distance from the toe to where the water stands at its level")};
    }
};

using SteppedPathWater = std::variant<Dry, WaterTable<>, WaterDrawnDown>;

struct SteppedPath {
    SteppedPathSearch search;
    SlopeSection<> slope;
    PathSteps steps;
    std::optional<PathRisers> risers;
    std::optional<PathColumns> columns;
    Rock<> rock;
    std::optional<RockBridges> rock_bridges;
    std::optional<MassiveRock> massive_rock;
    SteppedPathWater water;

    static constexpr std::string_view kind = "stepped_path";
    static constexpr auto fields() {
        return FieldTable{
            section<&SteppedPath::search>("which mechanism, and what counts as a failure"),
            section<&SteppedPath::slope>("the ground surface; no bench"),
            section<&SteppedPath::steps>("the flat set, on which the mass slides or its columns stand"),
            section<&SteppedPath::risers>("the steep set out of the slope; absent: none"),
            section<&SteppedPath::columns>("the steep set into the slope, which cuts columns; absent: none"),
            section<&SteppedPath::rock>("the rock mass"),
            section<&SteppedPath::rock_bridges>("rock between the ends of joints; absent: joints persist"),
            section<&SteppedPath::massive_rock>(
                "rock without open joints, which no surface reaches; absent: joints run all the way down"),
            section<&SteppedPath::water>("water in the joints, at rest below a surface")};
    }
};

enum class SteppedPathCheck {
    valid,
    risers_needed,   // sliding and wedges need risers
    columns_needed,  // toppling needs the joints between columns
    bench_not_covered,
    ground_too_steep,         // the ground behind the crest is as steep as the face, the steps or the risers
    steps_steeper_than_face,  // the steps do not daylight
    joints_too_close,         // in direction: steps, risers and columns have to cross
    boundary_not_between,     // the boundary of massive rock is flatter than the steps or steeper than the risers
    elevation_without_datum,
    no_path,         // no surface along the joints daylights within the allowed retreat
    too_many_nodes,  // more than 100 000 crossings of joints
    input_out_of_range,
};

}  // namespace delabole
