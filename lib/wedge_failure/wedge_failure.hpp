// Wedge failure: sliding of the block between two planes that meet in a line which daylights in the face, with a
// tension crack, water, earthquake, loads and bolts (Hoek & Bray 1981, Rock Slope Engineering, appendix 2; Wyllie & Mah
// 2004, appendix III: the comprehensive solution). The equations are derived with vectors: wedge_failure/geometry.hpp
// for the block, wedge_failure/stability.hpp for the forces, with their limits and accuracy.
//
// Departures from the printed solution: strengths may be curved; an inertia force and passive bolts are added; the
// signs of the sides come from block theory and not from a table of cases. For Coulomb strength and the same loads the
// answers are the same.
#pragma once

#include "numerics/required_value.hpp"
#include "parameters/model_interface.hpp"
#include "wedge_failure/geometry.hpp"
#include "wedge_failure/stability.hpp"

#include <string>
#include <vector>

namespace delabole {

struct WedgeFailureResult {
    WedgeFailureCheck check = WedgeFailureCheck::input_out_of_range;  // the rest is zero unless valid
    SlidingContact contact = SlidingContact::none;
    double factor_of_safety = 0;  // 0 if the wedge is lifted off both planes; infinite if no force drives it
    double line_plunge = 0;
    double line_trend = 0;
    double sliding_plunge = 0;  // negative if loads push the wedge upwards; 0 if it is lifted off
    double sliding_trend = 0;
    double volume = 0;
    double weight = 0;
    double area_1 = 0;
    double area_2 = 0;
    double crack_area = 0;
    double crack_depth = 0;
    double height_of_line = 0;
    double water_force_1 = 0;
    double water_force_2 = 0;
    double crack_water_force = 0;
    double normal_force_1 = 0;
    double normal_force_2 = 0;
    double driving_force = 0;
    double resisting_force = 0;
    static constexpr auto fields() {
        using R = WedgeFailureResult;
        using D = Dimension;
        return FieldTable{
            section<&R::contact>("planes on which the wedge slides; none: it is lifted off both"),
            number<&R::factor_of_safety>("resisting over driving force"),
            number<&R::line_plunge>(D::angle, "plunge of the line of intersection"),
            number<&R::line_trend>(D::angle, "trend of the line of intersection"),
            number<&R::sliding_plunge>(D::angle, "plunge of the direction of sliding"),
            number<&R::sliding_trend>(D::angle, "trend of the direction of sliding"),
            number<&R::volume>(D::volume, "volume of the wedge"),
            number<&R::weight>(D::force, "weight of the wedge"),
            number<&R::area_1>(D::area, "area of plane 1 under the wedge"),
            number<&R::area_2>(D::area, "area of plane 2 under the wedge"),
            number<&R::crack_area>(D::area, "area of the tension crack behind the wedge"),
            number<&R::crack_depth>(D::length, "vertical depth of the crack's foot below the upper surface"),
            number<&R::height_of_line>(
                D::length, "vertical height between the ends of the line of intersection, the crack disregarded"),
            number<&R::water_force_1>(D::force, "water force on plane 1"),
            number<&R::water_force_2>(D::force, "water force on plane 2"),
            number<&R::crack_water_force>(D::force, "water force in the crack"),
            number<&R::normal_force_1>(D::force, "effective normal force on plane 1"),
            number<&R::normal_force_2>(D::force, "effective normal force on plane 2"),
            number<&R::driving_force>(D::force, "force in the direction of sliding"),
            number<&R::resisting_force>(D::force, "available shear resistance")};
    }
};

// Checks ranges, then computes all members of the result.
WedgeFailureResult analyse(const WedgeFailure& problem);

// The value of one input at which the factor of safety takes a given value.
Required required_value(const WedgeFailure& problem, const std::string& parameter, double target,
                        const std::vector<std::string>& also = {});

// Inputs: every number of the problem. Outputs: every number of WedgeFailureResult.
ModelInterface model_interface(const WedgeFailureStudy& study);

}  // namespace delabole
