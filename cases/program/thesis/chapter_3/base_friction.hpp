// The base friction models of chapter 3 (Tables 3.1 to 3.3) as scenes of dynamic relaxation.
//
// A slope of columns that dip into it, cut from a slab of one material, lies on a belt and is stopped by a steel frame
// below it, behind it and, where there is rock in front of the toe, in front of that. Columns break where bonds across
// them do: faces normal to the joints, shifted from column to column by a share of their spacing that comes back
// nowhere, so that no plane is prepared through the columns. What the thesis does not print is said beside it.
//
// As runs they tell what strength each slope needs to stand; one strength is fitted to half of the scenes, the other
// half is predicted.
#pragma once

#include "cases/program/thesis/physical_models.hpp"
#include "dynamic_relaxation/step/bond_strength.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace delabole {

// The geometry of a state; states with the same geometry are one scene. Lengths in metres.
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

// Properties of the mixture (2.3.3.1, 3.2) and the frame. Strength is not printed: the scene has a unit of it, 1 kPa.
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

// States that are one scene come together. Scenes are in the order in which Table 3.2 first has them. Every other one,
// from the first, is fitted, the rest predicted: so decided before any result was seen. Twins stay in one half.
struct BaseFrictionScene {
    BaseFrictionGeometry geometry;
    std::vector<std::size_t> state;  // indices of the table's rows
    bool fitted;
};

std::vector<BaseFrictionScene> base_friction_scenes(const std::vector<BaseFrictionState>& states,
                                                    const ModelMixture& mixture);

struct SceneNeed {
    CriticalStrength critical;
    CrackPath path;  // where it failed

    bool known() const { return critical.status < StrengthStatus::run_failed; }
    bool failed() const {
        return critical.status == StrengthStatus::found || critical.status == StrengthStatus::fails_however_strong;
    }
    double strength() const;  // kPa; infinite where it fails however strong, 0 where it stands however weak
};

SceneNeed needed_strength(const BaseFrictionGeometry& geometry, const ModelMixture& mixture,
                          const std::function<bool()>& watch = {});

// The scene with the strength all at once, kPa.
SceneNeed run_with_strength(const BaseFrictionGeometry& geometry, const ModelMixture& mixture, double strength,
                            const std::function<bool()>& watch = {});

// That a slope fails: a logistic in the logarithm of the strength it needs over the strength there is. Slabs are not
// alike, and a share of tests goes against any prediction, as 3(L) and 4(R) do, which are one scene.
double failure_probability(double needed, double strength);

struct StrengthFit {
    double strength;  // kPa
    double misfit;    // - log likelihood; a slope in limiting equilibrium counts half as failed
    double lower;     // kPa, between which the misfit is no more than 1.92 above the least: 95 %
    double upper;
    long evaluations;
};

// Fits the strength to the scenes whose need is known.
StrengthFit fit_strength(const std::vector<BaseFrictionState>& states, const std::vector<BaseFrictionScene>& scenes,
                         const std::vector<SceneNeed>& needs);

}  // namespace delabole
