// A single rectangular block on an inclined plane: Ashby's static chart (thesis 4.1, Fig 4.1), and the motion of the
// block at its onset as a rigid body, per metre run.
//
// The faces are normal to the base. Forces, D down the plane and N into it, with W the weight, a the height, b the
// width, i the inclination, P and U the water forces on the faces and under the base:
//
//     D = W [(1 + k_v) sin i + k_h cos i] + P_behind - P_front
//     N = W [(1 + k_v) cos i - k_h sin i] - U
//
// Static criteria: the block slides if D > C + N tan(phi), C the cohesive force; it topples if the moment about the toe
// is positive. Fig 4.1(b) superposes these two and is wrong wherever it says "slides and topples": during one motion
// the reaction for the other is not the static one.
//
// Onset of motion, released from rest. Each contact of the base is tried with the accelerations it implies; k is the
// radius of gyration about the toe, k^2 = (a^2 + b^2) / 3:
//     slides                 the reaction of the translating block lies within the base
//     topples                the block turns about the toe, and |shear| <= N' tan(phi) with its reaction N'
//     slides and topples     the block turns about a toe that slips, shear = N' tan(phi)
//     lifts off              equilibrium requires the plane to pull
// Cohesion holds a closed base only: an edge has no area. Dry and without earthquake the boundary between topples and
// slides-and-topples is
//     tan(phi) = [4 sin i - 3 cos d sin(i - d)] / [4 cos i + 3 sin d sin(i - d)],  d = atan(b / a)
// and that between slides and slides-and-topples is phi = d: with phi below d a block slides and never topples, however
// steep the plane (Sagaseta 1986; Bray & Goodman 1981 for the four regions).
//
// Limits: no added mass of water; water depths are measured along the faces and turn with the plane. Accuracy: closed
// form, a few units in the last place of the largest force.
#pragma once

#include "parameters/lengths.hpp"
#include "parameters/model_interface.hpp"
#include "plane_failure/parameters.hpp"

#include <optional>
#include <string_view>

namespace delabole {

struct BlockBody {
    double height;
    double width;
    double unit_weight;
    static constexpr auto fields() {
        return FieldTable{
            number<&BlockBody::height>(Dimension::length, extent_range(), "height, normal to the base"),
            number<&BlockBody::width>(Dimension::length, extent_range(), "width, along the base"),
            number<&BlockBody::unit_weight>(Dimension::unit_weight, more_than(0), "unit weight of the rock")};
    }
};

struct BlockBase {
    double inclination;
    double friction_angle;
    double cohesion;
    static constexpr auto fields() {
        return FieldTable{
            number<&BlockBase::inclination>(Dimension::angle, right_open(0, degrees(90)), "inclination of the base"),
            number<&BlockBase::friction_angle>(Dimension::angle, within(0, degrees(89.9)),
                                               "angle of friction of the base"),
            number<&BlockBase::cohesion>(Dimension::stress, at_least(0), "cohesion of the base")};
    }
};

// Pressures at heel and toe follow from the depths; under the base the pressure varies linearly between them.
struct BlockWater {
    double unit_weight;
    double depth_behind;
    std::optional<double> depth_in_front;
    static constexpr auto fields() {
        return FieldTable{
            number<&BlockWater::unit_weight>(Dimension::unit_weight, more_than(0), "unit weight of water"),
            number<&BlockWater::depth_behind>(Dimension::length, distance_range(),
                                              "water on the upper face, measured along it from the base"),
            number<&BlockWater::depth_in_front>(
                Dimension::length, distance_range(),
                "water on the lower face, measured along it from the base; absent: none")};
    }
};

struct SingleBlock {
    BlockBody block;
    BlockBase base;
    std::optional<BlockWater> water;
    std::optional<SeismicLoad<>> seismic;

    static constexpr std::string_view kind = "single_block";
    static constexpr auto fields() {
        return FieldTable{section<&SingleBlock::block>("the block"), section<&SingleBlock::base>("the plane"),
                          section<&SingleBlock::water>("water behind, in front and below; absent: dry"),
                          section<&SingleBlock::seismic>("pseudo-static earthquake load; absent: none")};
    }
};

enum class SingleBlockCheck {
    valid,
    water_above_block,   // a depth of water exceeds the height
    input_out_of_range,  // a number outside the range of its field, or not finite
};

enum class BlockMotion { stable, slides, topples, slides_and_topples, lifts_off };

struct SingleBlockResult {
    SingleBlockCheck check = SingleBlockCheck::input_out_of_range;  // the rest is meaningful only if valid
    BlockMotion static_mode{};                                      // superposition of the two criteria
    BlockMotion onset_mode{};                                       // of the rigid body released from rest
    double factor_of_safety{};               // against sliding; infinite if no force drives, 0 if the block lifts off
    double overturning_factor{};             // restoring over overturning moment about the toe; likewise
    double critical_sliding_inclination{};   // 90 deg: slides at no inclination
    double critical_toppling_inclination{};  // 90 deg: topples at no inclination
    double weight{};
    double driving_force{};         // D
    double normal_force{};          // N, effective
    double reaction_position{};     // of the static reaction: 0 at the toe, 1 at the heel
    double toe_acceleration{};      // down the plane, over the acceleration of gravity
    double angular_acceleration{};  // times the height, over the acceleration of gravity; positive toppling

    static constexpr auto fields() {
        using R = SingleBlockResult;
        using D = Dimension;
        return FieldTable{
            section<&R::static_mode>("the static criteria superposed"),
            section<&R::onset_mode>("motion of the rigid body released from rest"),
            number<&R::factor_of_safety>("factor of safety against sliding"),
            number<&R::overturning_factor>("restoring over overturning moment about the toe"),
            number<&R::critical_sliding_inclination>(D::angle,
                                                     "inclination at which the block begins to slide; 90 deg: none"),
            number<&R::critical_toppling_inclination>(D::angle,
                                                      "inclination at which the block begins to topple; 90 deg: none"),
            number<&R::weight>(D::force_per_length, "weight"),
            number<&R::driving_force>(D::force_per_length, "force down the plane"),
            number<&R::normal_force>(D::force_per_length, "effective force into the plane"),
            number<&R::reaction_position>("where the static reaction acts: 0 toe, 1 heel"),
            number<&R::toe_acceleration>("acceleration of the toe down the plane, over that of gravity"),
            number<&R::angular_acceleration>("angular acceleration times height over the acceleration of gravity")};
    }
};

SingleBlockResult analyse(const SingleBlock& problem);

// Friction angle above which a dry block turns about a toe that does not slip. `slenderness_angle` d = atan(b / a) and
// the inclination lie in (0, 90 deg), the inclination above d.
double toe_slip_friction_angle(double inclination, double slenderness_angle);

// Inputs: every number of the problem. Outputs: every number of SingleBlockResult.
ModelInterface model_interface(const SingleBlock& problem);

}  // namespace delabole
