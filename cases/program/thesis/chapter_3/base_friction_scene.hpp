// The base friction models of chapter 3 (Tables 3.1 to 3.3) as scenes of dynamic relaxation.
//
// A slope of columns that dip into it, cut from a slab of one material, lies on a belt and is stopped by a steel frame
// below it, behind it and, where there is rock in front of the toe, in front of that. Columns break where bonds across
// them do: faces normal to the joints, shifted from column to column by a share of their spacing that comes back
// nowhere, so that no plane is prepared through the columns. What the thesis does not print is said beside it.
#pragma once

#include "cases/program/thesis/physical_models.hpp"
#include "dynamic_relaxation/step/bond_strength.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <cstddef>
#include <optional>

namespace delabole {

// What of a state makes its scene: states that are alike in it are one scene. Lengths in metres.
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
    // Friction of a horizontal cut at the toe's level; absent: none.
    std::optional<double> cut_friction;
    std::size_t columns_removed;  // from the toe
    bool saw_tooth;               // the joint through the crest

    bool operator==(const BaseFrictionGeometry&) const = default;
};

// Of the mixture (2.3.3.1, 3.2) and the frame. Strength is not printed: that of the scene is a unit, 1 kPa.
struct ModelMixture {
    double friction;        // rad
    double frame_friction;  // rad, on steel
    double tin_friction;    // rad
    double saw_tooth;       // rad, inclination of the teeth
    double density;         // kg/m3
    double cohesion;        // over the tensile strength
    double face_spacing;    // along a column, between faces at which it may break, over its width
    double young_modulus;   // Pa
};

ModelMixture model_mixture();

BaseFrictionGeometry geometry_of(const BaseFrictionState& state, const ModelMixture& mixture);

RelaxationStudy base_friction_study(const BaseFrictionGeometry& geometry, const ModelMixture& mixture);

StrengthReduction strength_reduction_of(const BaseFrictionGeometry& geometry);

}  // namespace delabole
