// Strength divided by a factor, for a factor of safety of the strength that joints and intact rock have.
//
// Divided are, of a joint, peak and residual cohesion, tensile strength and the tangents of the peak and of the
// residual friction angle; of the intact rock that bonds the joint, cohesion, tensile strength and the tangent of the
// friction angle. Not divided are stiffnesses and moduli, weight, water, forces and shaking, and the friction of a belt
// that drives the blocks. A factor below 1 raises strength.
//
// Reference: Zienkiewicz, O.C., Humpheson, C. & Lewis, R.W. (1975) Associated and non-associated visco-plasticity and
// plasticity in soil mechanics. Geotechnique 25, 671-689.
#pragma once

#include "dynamic_relaxation/scene/relaxation_parameters.hpp"
#include "dynamic_relaxation/scene/scene.hpp"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace delabole {

// `factor` is more than 0. No friction angle is raised beyond 89.9 deg, near which scenes are refused. Two faces in
// contact have the properties of the one with less friction, as reduced.
RelaxationScene with_reduced_strength(RelaxationScene scene, std::span<const std::size_t> materials, double factor);

// Names by which a case knows its joints, in their order: those of a jointed slope; "interface" and "base" of a row or
// columns; "1", "2", ... of blocks.
std::vector<std::string> joint_names(const BlockScene& scene);

// The scene's materials that come from the named joints of `made_of`, from all where none is named. Scatter makes more
// materials than there are joints.
std::vector<std::size_t> materials_of_joints(const BlockScene& made_of, const RelaxationScene& scene,
                                             const std::vector<std::string>& names);

}  // namespace delabole
