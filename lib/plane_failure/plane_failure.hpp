// Plane failure by limit equilibrium (Hoek & Bray; thesis 2.3.2 (c)), per metre run, with a moment check.
//
// Limits: one plane and at most one crack, both without thickness; stresses on the plane enter as their mean. Curved
// strength laws are therefore evaluated at the mean effective normal stress.
#pragma once

#include "geometry/polyline.hpp"
#include "parameters/model_interface.hpp"
#include "plane_failure/check.hpp"
#include "plane_failure/parameters.hpp"
#include "plane_failure/study.hpp"

namespace delabole {

// The factor of safety is NaN unless `check` is valid; it is infinite if no force drives the mass.
struct FactorOfSafety {
    PlaneFailureCheck check;
    double value;
};

// Computes geometry, water and force balance in under 100 ns, without checking the ranges of single fields.
FactorOfSafety factor_of_safety(const PlaneFailure<>& problem);

// `input_out_of_range` if a number is not finite or outside the range of its field, otherwise `valid`.
PlaneFailureCheck check_ranges(const PlaneFailure<>& problem);

enum class PlaneFailureOutcome {
    stable,
    slides,     // factor of safety below 1
    overturns,  // about the lower end of the base, while the strength would still hold it
    slides_and_overturns,
    lifts_off,  // the base would have to bear more tension than it can: the factor of safety is 0
};

struct PlaneFailureResult {
    PlaneFailureCheck check = PlaneFailureCheck::input_out_of_range;  // the rest is meaningful only if valid
    PlaneFailureOutcome outcome{};
    CrackLocation crack_location{};
    double factor_of_safety{};
    double friction_margin{};              // atan(resisting / normal force) less atan(driving / normal force)
    double plane_dip{};                    // differs from the input after a critical search
    double crack_dip{};                    // 90 deg if there is no crack
    double crack_depth{};                  // vertical, at the crack itself
    double crack_distance_behind_crest{};  // of its top; without a crack, of the point at which the plane daylights
    double crack_base_height{};            // above the toe
    double crack_top_height{};
    double crack_base_below_crest{};
    double sliding_area{};  // m2 of base per metre run: its length
    double section_area{};  // of the sliding mass
    double weight{};
    double base_water_force{};   // U
    double crack_water_force{};  // V
    double normal_force{};       // effective
    double driving_force{};
    double resisting_force{};
    double normal_force_position{};  // position of the normal force on the base: 0 at its lower end, 1 at its upper
    double restoring_moment{};       // about the lower end of the base
    double overturning_moment{};
    double overturning_factor{};  // restoring over overturning moment; infinite if no moment overturns

    static constexpr auto fields() {
        using R = PlaneFailureResult;
        using D = Dimension;
        return FieldTable{
            section<&R::outcome>("what the slope does"),
            section<&R::crack_location>("which surface the crack opens in"),
            number<&R::factor_of_safety>("factor of safety against sliding"),
            number<&R::friction_margin>(D::angle,
                                        "atan(resisting/normal) - atan(driving/normal): 0 at a factor of safety of 1"),
            number<&R::plane_dip>(D::angle, "dip of the failure plane"),
            number<&R::crack_dip>(D::angle, "dip of the tension crack"),
            number<&R::crack_depth>(D::length, "vertical depth of the tension crack"),
            number<&R::crack_distance_behind_crest>(D::length, "crest to top of crack, horizontally"),
            number<&R::crack_base_height>(D::length, "bottom of the crack above the toe"),
            number<&R::crack_top_height>(D::length, "top of the crack above the toe"),
            number<&R::crack_base_below_crest>(D::length, "bottom of the crack below crest level"),
            number<&R::sliding_area>(D::length, "area of the base per metre run"),
            number<&R::section_area>(D::area, "area of the sliding mass in section"),
            number<&R::weight>(D::force_per_length, "weight of the sliding mass"),
            number<&R::base_water_force>(D::force_per_length, "water force on the base"),
            number<&R::crack_water_force>(D::force_per_length, "water force in the crack"),
            number<&R::normal_force>(D::force_per_length, "effective normal force on the base"),
            number<&R::driving_force>(D::force_per_length, "force down the plane"),
            number<&R::resisting_force>(D::force_per_length, "available shear resistance"),
            number<&R::normal_force_position>("where the normal force acts: 0 lower, 1 upper end of the base"),
            number<&R::restoring_moment>(D::moment_per_length,
                                         "moment against overturning about the lower end of the base"),
            number<&R::overturning_moment>(D::moment_per_length,
                                           "moment towards overturning about the lower end of the base"),
            number<&R::overturning_factor>("restoring over overturning moment")};
    }
};

// Checks ranges, then computes all members of the result.
PlaneFailureResult analyse(const PlaneFailure<>& problem);

// The present ground, from the toe to beyond the end of the mass.
Polyline ground_profile(const PlaneFailure<>& problem);

// Numbers of the single bolts, from 0, that do not run from the moving mass through the ground into the rock behind it.
std::vector<std::size_t> bolts_that_hold_nothing(const PlaneFailure<>& problem);

// The rows of each pattern of bolts, the lowest first; empty if the problem is not valid.
std::vector<std::vector<BoltRow>> support_rows(const PlaneFailure<>& problem);

// The ground that a failure leaves standing: toe, plane, crack, remaining ground. Empty if the problem is not valid.
Polyline profile_after_failure(const PlaneFailure<>& problem);

// The problem that a study analyses: its own, with the critical geometry inserted if a search is requested. `check` is
// that of the search.
struct ResolvedStudy {
    PlaneFailureCheck check;
    PlaneFailure<> problem;
    bool critical_at_boundary;      // the least factor of safety lies at the edge of the searched range
    double least_factor_of_safety;  // least factor of safety under the condition of the search; 0 without a search
};
ResolvedStudy resolve(const PlaneFailureStudy<>& study);

// Inputs: every number of the study's problem. Outputs: every number of PlaneFailureResult, and the two elevations if
// the study has a datum. Conditions and free parameters are applied before a critical search.
ModelInterface model_interface(const PlaneFailureStudy<>& study);

}  // namespace delabole
