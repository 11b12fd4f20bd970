// The base friction models of chapter 3 (Tables 3.1 to 3.3) as they were cut, for drawings.
//
// A slope of columns that dip into it, cut from a slab of one material, lies on a belt and is stopped by a steel frame
// below it, behind it and, where there is rock in front of the toe, in front of that. What the thesis does not print is
// said beside it.
#pragma once

#include "cases/program/thesis/physical_models.hpp"
#include "dynamic_relaxation/scene/relaxation_parameters.hpp"

#include <optional>

namespace delabole {

// Lengths in metres.
struct BaseFrictionGeometry {
    double slope_angle;
    double slope_height;
    double joint_dip;  // into the slope
    double joint_spacing;
    std::optional<double> cross_joint_spacing;
    double slope_surface;  // of the ground behind the crest
    double depth;          // of rock below the toe, down to the frame
    double front;          // of rock in front of the toe
    double vertical_cut;   // height of the upright face from the toe up; 0: none
    bool horizontal_cut;   // at the toe's level
    bool saw_tooth;        // the joint through the crest
};

BaseFrictionGeometry geometry_of(const BaseFrictionState& state);

RelaxationSlope model_as_cut(const BaseFrictionGeometry& geometry);

}  // namespace delabole
