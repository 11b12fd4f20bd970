// Strength reduction: strength of joints and intact rock divided by a factor, for a factor of safety.
//
// The division applies to a joint's peak and residual cohesion, its tensile strength and the tangents of its peak and
// residual friction angles; for the intact rock that bonds the joint, to cohesion, tensile strength and the tangent of
// the friction angle. It does not apply to stiffnesses and moduli, weight, water, forces and shaking, nor to the
// friction of a belt that drives the blocks. A factor below 1 raises strength.
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
// contact have the lesser strengths of both after the reduction.
RelaxationScene with_reduced_strength(RelaxationScene scene, std::span<const std::size_t> materials, double factor);

// Blocks that do not stand with so many times their strength do not stand with any. Cones of still greater friction are
// half planes but for some digits, with which linear programmes of a thousand blocks have no end.
inline constexpr double greatest_strength = 100;

// Every joint and the rock in it so many times as strong.
RelaxationScene with_multiplied_strength(const RelaxationScene& scene, double factor);

// Names of the joints in a case, in their order: those of a jointed slope; "interface" and "base" of a row or columns;
// "1", "2", ... of blocks.
std::vector<std::string> joint_names(const BlockScene& scene);

// The joints named and those that run along them in a slope, which are reduced together: of two joints along each other
// only the weaker one is in the scene.
std::vector<std::string> joints_reduced(const BlockScene& made_of, std::vector<std::string> names);

// The scene's materials that come from the joints reduced with those named, or from all joints if none is named.
// Scatter makes more materials than there are joints.
std::vector<std::size_t> materials_of_joints(const BlockScene& made_of, const RelaxationScene& scene,
                                             const std::vector<std::string>& names);

}  // namespace delabole
