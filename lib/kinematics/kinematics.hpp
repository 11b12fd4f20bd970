// Kinematic feasibility of sliding and toppling for every joint set and every pair of sets, at the mean orientations
// and as the share of sampled orientations. Criteria and sources: kinematics/criteria.hpp.
//
// Limits: says which movements geometry and friction leave open, not which of them happens. Cohesion, water, spacing,
// persistence and the height of the slope play no part. The sets are sampled independently of one another.
#pragma once

#include "kinematics/criteria.hpp"
#include "kinematics/parameters.hpp"
#include "parameters/model_interface.hpp"

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// Time and the number of answers grow with the square of the number of sets.
inline constexpr std::size_t most_joint_sets = 30;

enum class KinematicsCheck {
    valid,
    no_joint_set,
    too_many_joint_sets,  // more than most_joint_sets
    joint_set_without_name,
    joint_set_name_repeated,
    lower_dip_above_upper_dip,
    setting_not_whole,   // sample_count or seed
    input_out_of_range,  // a number outside the range of its field, or not finite
};

constexpr std::array<std::string_view, 8> enum_names(KinematicsCheck) {
    return {"valid",
            "no_joint_set",
            "too_many_joint_sets",
            "joint_set_without_name",
            "joint_set_name_repeated",
            "lower_dip_above_upper_dip",
            "setting_not_whole",
            "input_out_of_range"};
}

struct MechanismFeasibility {
    Feasibility at_mean;
    double critical_friction_angle;
    double feasible_share;
    static constexpr auto fields() {
        using M = MechanismFeasibility;
        return std::tuple{section("at_mean", &M::at_mean, "verdict at the mean orientation"),
                          number("critical_friction_angle", &M::critical_friction_angle, Dimension::angle, any_number(),
                                 "feasible at the mean below this friction angle; 0: at none"),
                          number("feasible_share", &M::feasible_share, Dimension::ratio, any_number(),
                                 "share of the sampled orientations that is feasible")};
    }
};

struct JointSetFeasibility {
    std::string name;
    Orientation mean;
    double apparent_dip;                // of the mean, in the section across the face; negative: into the slope
    double angular_standard_deviation;  // of the sampled poles
    MechanismFeasibility planar_sliding;
    MechanismFeasibility flexural_toppling;
    Feasibility toppling_base;
    double toppling_base_share;
    static constexpr auto fields() {
        using J = JointSetFeasibility;
        return std::tuple{section("name", &J::name, "name of the set"),
                          section("mean", &J::mean, "mean orientation"),
                          number("apparent_dip", &J::apparent_dip, Dimension::angle, any_number(),
                                 "dip of the mean in the section across the face; negative: into the slope"),
                          number("angular_standard_deviation", &J::angular_standard_deviation, Dimension::angle,
                                 any_number(), "angular standard deviation of the sampled poles"),
                          section("planar_sliding", &J::planar_sliding, "sliding on one plane of the set"),
                          section("flexural_toppling", &J::flexural_toppling, "flexural toppling of its layers"),
                          section("toppling_base", &J::toppling_base, "base of direct toppling, at the mean"),
                          number("toppling_base_share", &J::toppling_base_share, Dimension::ratio, any_number(),
                                 "share of the sampled planes that can be a base of direct toppling")};
    }
};

struct PairFeasibility {
    std::string first;
    std::string second;
    LineOrientation intersection;  // of the means; 0, 0 where they are parallel
    MechanismFeasibility wedge_sliding;
    SlidingContact wedge_contact;
    double wedge_limiting_friction_angle;
    Feasibility direct_toppling;
    double direct_toppling_share;
    std::string toppling_base;  // the set whose mean is a base, the flattest if several; empty: none
    static constexpr auto fields() {
        using P = PairFeasibility;
        return std::tuple{
            section("first", &P::first, "first set"),
            section("second", &P::second, "second set"),
            section("intersection", &P::intersection, "line of intersection of the mean planes"),
            section("wedge_sliding", &P::wedge_sliding, "sliding of the wedge between both sets"),
            section("wedge_contact", &P::wedge_contact, "planes that carry the wedge, at the mean"),
            number(
                "wedge_limiting_friction_angle", &P::wedge_limiting_friction_angle, Dimension::angle, any_number(),
                "friction angle at which the dry cohesionless mean wedge is in limiting equilibrium; 0: cannot slide"),
            section("direct_toppling", &P::direct_toppling, "toppling of columns between both sets, at the mean"),
            number("direct_toppling_share", &P::direct_toppling_share, Dimension::ratio, any_number(),
                   "share of the samples in which columns and a base of another set go together"),
            section("toppling_base", &P::toppling_base, "set of the base at the mean orientations; empty: none")};
    }
};

struct KinematicsResult {
    KinematicsCheck check = KinematicsCheck::input_out_of_range;  // the rest is empty unless valid
    std::vector<JointSetFeasibility> joint_set{};                 // in the order of the input
    std::vector<PairFeasibility> pair{};                          // 1-2, 1-3, ... 2-3, ...
    std::vector<std::vector<Orientation>> sampled{};              // the planes drawn from each set
    static constexpr auto fields() {
        using R = KinematicsResult;
        return std::tuple{section("joint_set", &R::joint_set, "every joint set"),
                          section("pair", &R::pair, "every pair of joint sets")};
    }
};

KinematicsCheck check_input(const KinematicsStudy& study);

// Time grows with samples times pairs.
KinematicsResult analyse(const KinematicsStudy& study);

// Inputs: every number of the model, "joint_set[1].upper_dip". Outputs: every number of KinematicsResult,
// "joint_set[1].planar_sliding.feasible_share", "pair[2].wedge_sliding.critical_friction_angle".
ModelInterface model_interface(const KinematicsStudy& study);

}  // namespace delabole
