// Kinematic feasibility of sliding and toppling for every joint set and every pair of sets, at the mean orientations
// and as the share of sampled orientations. Criteria and sources: kinematics/criteria.hpp.
//
// Measured poles are used as they are: a set selected by a window, or found in the poles (kinematics/poles.hpp),
// consists of its poles, and its shares are shares of them by weight. If no joint set is given, sets are found. Pairs
// of sets are drawn from both independently of one another. In addition, every pole and every intersection of two poles
// is counted.
//
// Limits: the result shows which movements geometry and friction allow, not which of them happens. Cohesion, water,
// spacing, persistence and the height of the slope are not considered. The sets are sampled independently of one
// another.
#pragma once

#include "kinematics/criteria.hpp"
#include "kinematics/parameters.hpp"
#include "kinematics/poles.hpp"
#include "parameters/model_interface.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

// Time and the number of answers grow with the square of the number of sets.
inline constexpr std::size_t most_joint_sets = 30;

// The time of the search for sets grows with the square of the number of poles.
inline constexpr std::size_t most_poles = 10'000;
// If there are more poles, this many evenly chosen ones are intersected.
inline constexpr std::size_t most_poles_intersected = 1'000;
// The number is 8 unless the case sets another, at most 12.
std::size_t most_sets_searched(const Kinematics& model);

enum class KinematicsCheck {
    valid,
    no_joint_set,         // neither sets nor poles
    too_many_joint_sets,  // more than most_joint_sets
    joint_set_without_name,
    joint_set_name_repeated,
    lower_dip_above_upper_dip,
    survey_without_planes,
    too_many_poles,  // more than most_poles
    window_without_poles,
    no_set_found,        // the poles may as well be uniformly scattered
    setting_not_whole,   // sample_count, seed or most_sets
    input_out_of_range,  // a number outside the range of its field, or not finite
};

struct MechanismFeasibility {
    Feasibility at_mean;
    double critical_friction_angle;
    double feasible_share;
    static constexpr auto fields() {
        using M = MechanismFeasibility;
        return FieldTable{section<&M::at_mean>("verdict at the mean orientation"),
                          number<&M::critical_friction_angle>(
                              Dimension::angle, "feasible at the mean below this friction angle; 0: at none"),
                          number<&M::feasible_share>("share of the sampled orientations that is feasible")};
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
    std::optional<FisherStatistics> measured;
    static constexpr auto fields() {
        using J = JointSetFeasibility;
        return FieldTable{
            section<&J::name>("name of the set"),
            section<&J::mean>("mean orientation"),
            number<&J::apparent_dip>(Dimension::angle,
                                     "dip of the mean in the section across the face; negative: into the slope"),
            number<&J::angular_standard_deviation>(Dimension::angle, "angular standard deviation of the sampled poles"),
            section<&J::planar_sliding>("sliding on one plane of the set"),
            section<&J::flexural_toppling>("flexural toppling of its layers"),
            section<&J::toppling_base>("base of direct toppling, at the mean"),
            number<&J::toppling_base_share>("share of the sampled planes that can be a base of direct toppling"),
            section<&J::measured>("statistics of its measured poles")};
    }
};

struct PairFeasibility {
    std::string first;
    std::string second;
    LineOrientation intersection;  // of the means; 0, 0 if they are parallel
    MechanismFeasibility wedge_sliding;
    SlidingContact wedge_contact;
    double wedge_limiting_friction_angle;
    Feasibility direct_toppling;
    double direct_toppling_share;
    std::string toppling_base;  // the set whose mean can be a base, the flattest if several; empty: none
    static constexpr auto fields() {
        return FieldTable{
            section<&PairFeasibility::first>("first set"),
            section<&PairFeasibility::second>("second set"),
            section<&PairFeasibility::intersection>("line of intersection of the mean planes"),
            section<&PairFeasibility::wedge_sliding>("sliding of the wedge between both sets"),
            section<&PairFeasibility::wedge_contact>("planes that carry the wedge, at the mean"),
            number<&PairFeasibility::wedge_limiting_friction_angle>(
                Dimension::angle,
                "friction angle at which the dry cohesionless mean wedge is in limiting equilibrium; 0: cannot slide"),
            section<&PairFeasibility::direct_toppling>("toppling of columns between both sets, at the mean"),
            number<&PairFeasibility::direct_toppling_share>(
                "share of the samples in which columns and a base of another set go together"),
            section<&PairFeasibility::toppling_base>("set of the base at the mean orientations; empty: none")};
    }
};

// All measured poles, each counted once.
struct PoleCounts {
    double count;
    double planar_sliding;
    double flexural_toppling;
    double toppling_base;
    double intersections;
    double wedge_sliding;
    double wedge_sliding_secondary;  // of these, in the secondary zone of kinematics/stereonet.hpp
    double toppling_axis;
    double without_set;
    static constexpr auto fields() {
        return FieldTable{
            number<&PoleCounts::count>("measured poles"),
            number<&PoleCounts::planar_sliding>("poles of planes that can slide"),
            number<&PoleCounts::flexural_toppling>("poles of layers that can topple"),
            number<&PoleCounts::toppling_base>("poles of planes that can be a base of direct toppling"),
            number<&PoleCounts::intersections>(
                "lines along which two of the planes meet, those of 1000 planes where there are more"),
            number<&PoleCounts::wedge_sliding>("lines of wedges that can slide, in both zones"),
            number<&PoleCounts::wedge_sliding_secondary>(
                "of these, lines that plunge less than the friction angle: the wedge slides on one steeper plane"),
            number<&PoleCounts::toppling_axis>("lines that can be the axis of toppling columns"),
            number<&PoleCounts::without_set>("poles that belong to no set")};
    }
};

struct KinematicsResult {
    KinematicsCheck check = KinematicsCheck::input_out_of_range;  // the rest is empty unless valid
    std::vector<JointSetFeasibility> joint_set{};                 // in the order of the input
    std::vector<PairFeasibility> pair{};                          // 1-2, 1-3, ... 2-3, ...
    std::optional<PoleCounts> poles{};                            // set if there are measured poles
    std::vector<std::vector<Orientation>> sampled{};              // the planes drawn from each set, or measured in it
    std::vector<std::vector<double>> sampled_weights{};           // one for each of the same planes
    std::vector<Orientation> without_set{};                       // measured planes that belong to no set
    std::vector<double> weights_without_set{};
    std::vector<std::vector<std::size_t>> sets_of_pole{};  // of each measured plane; windows may overlap
    std::vector<double> information_criterion{};           // of PoleClusters, if sets were searched for
    std::vector<bool> too_small{};                         // likewise
    static constexpr auto fields() {
        using R = KinematicsResult;
        return FieldTable{section<&R::joint_set>("every joint set"), section<&R::pair>("every pair of joint sets"),
                          section<&R::poles>("all measured poles")};
    }
};

KinematicsCheck check_input(const KinematicsStudy& study);

// All measured planes, survey by survey.
std::vector<Orientation> measured_planes(const Kinematics& model);

// Time grows with the number of samples times the number of pairs.
KinematicsResult analyse(const KinematicsStudy& study);

// Inputs: every number of the model, "joint_set[1].upper_dip". Outputs: every number of KinematicsResult,
// "joint_set[1].planar_sliding.feasible_share", "pair[2].wedge_sliding.critical_friction_angle".
ModelInterface model_interface(const KinematicsStudy& study);

}  // namespace delabole
