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
        constexpr Interval any = any_number();
        return std::tuple{
            section<&R::contact>("planes on which the wedge slides; none: it is lifted off both"),
            number("factor_of_safety", &R::factor_of_safety, D::ratio, any, "resisting over driving force"),
            number("line_plunge", &R::line_plunge, D::angle, any, "plunge of the line of intersection"),
            number("line_trend", &R::line_trend, D::angle, any, "trend of the line of intersection"),
            number("sliding_plunge", &R::sliding_plunge, D::angle, any, "plunge of the direction of sliding"),
            number("sliding_trend", &R::sliding_trend, D::angle, any, "trend of the direction of sliding"),
            number("volume", &R::volume, D::volume, any, "volume of the wedge"),
            number("weight", &R::weight, D::force, any, "weight of the wedge"),
            number("area_1", &R::area_1, D::area, any, "area of plane 1 under the wedge"),
            number("area_2", &R::area_2, D::area, any, "area of plane 2 under the wedge"),
            number("crack_area", &R::crack_area, D::area, any, "area of the tension crack behind the wedge"),
            number("crack_depth", &R::crack_depth, D::length, any,
                   "vertical depth of the crack's foot below the upper surface"),
            number("height_of_line", &R::height_of_line, D::length, any,
                   "vertical height between the ends of the line of intersection, the crack disregarded"),
            number("water_force_1", &R::water_force_1, D::force, any, "water force on plane 1"),
            number("water_force_2", &R::water_force_2, D::force, any, "water force on plane 2"),
            number("crack_water_force", &R::crack_water_force, D::force, any, "water force in the crack"),
            number("normal_force_1", &R::normal_force_1, D::force, any, "effective normal force on plane 1"),
            number("normal_force_2", &R::normal_force_2, D::force, any, "effective normal force on plane 2"),
            number("driving_force", &R::driving_force, D::force, any, "force in the direction of sliding"),
            number("resisting_force", &R::resisting_force, D::force, any, "available shear resistance")};
    }
};

// Checks ranges, then computes all members of the result.
WedgeFailureResult analyse(const WedgeFailure<>& problem);

// The value of one input at which the factor of safety takes a given value.
Required required_value(const WedgeFailure<>& problem, const std::string& parameter, double target,
                        const std::vector<std::string>& also = {});

// Inputs: every number of the problem. Outputs: every number of WedgeFailureResult.
ModelInterface model_interface(const WedgeFailureStudy<>& study);

}  // namespace delabole
