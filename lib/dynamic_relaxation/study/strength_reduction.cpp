#include "dynamic_relaxation/study/strength_reduction.hpp"

#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <type_traits>
#include <utility>

namespace delabole {

namespace {

double divided(double friction_angle, double factor) {
    constexpr double greatest = degrees(89.9);
    return std::min(std::atan(std::tan(friction_angle) / factor), std::max(friction_angle, greatest));
}

template <class Scene>
inline constexpr bool is_standing = std::is_same_v<Scene, RelaxationRow> || std::is_same_v<Scene, RelaxationColumns>;

}  // namespace

RelaxationScene with_reduced_strength(RelaxationScene scene, std::span<const std::size_t> materials, double factor) {
    for (const std::size_t index : materials) {
        JointMaterial& joint = scene.material[index];
        joint.friction_angle = divided(joint.friction_angle, factor);
        if (joint.residual_friction_angle) {
            joint.residual_friction_angle = divided(*joint.residual_friction_angle, factor);
        }
        joint.cohesion /= factor;
        joint.residual_cohesion /= factor;
        joint.tensile_strength /= factor;
        if (joint.bond) {
            joint.bond->friction_angle = divided(joint.bond->friction_angle, factor);
            joint.bond->cohesion /= factor;
            joint.bond->tensile_strength /= factor;
        }
    }
    return scene;
}

RelaxationScene with_multiplied_strength(const RelaxationScene& scene, double factor) {
    std::vector<std::size_t> all(scene.material.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return with_reduced_strength(scene, all, 1 / factor);
}

std::vector<std::string> joint_names(const BlockScene& scene) {
    return std::visit(
        [](const auto& blocks) {
            std::vector<std::string> names;
            if constexpr (is_standing<std::remove_cvref_t<decltype(blocks)>>) {
                names = {"interface", "base"};
            } else if constexpr (requires { blocks.joint.front().name; }) {
                for (const SlopeJoint& joint : blocks.joint) {
                    names.push_back(joint.name);
                }
            } else {
                for (std::size_t number = 1; number <= blocks.joint.size(); ++number) {
                    names.push_back(std::to_string(number));
                }
            }
            return names;
        },
        scene);
}

std::vector<std::string> joints_reduced(const BlockScene& made_of, std::vector<std::string> names) {
    const auto* slope = std::get_if<RelaxationSlope>(&made_of);
    if (slope == nullptr || names.empty()) {
        return names;
    }
    const auto has = [&](std::size_t joint) {
        return std::ranges::find(names, slope->joint[joint].name) != names.end();
    };
    const std::set<std::pair<std::size_t, std::size_t>> along = slope_scene(*slope).section.along_each_other;
    for (bool any = true; any;) {
        any = false;
        for (const auto& [one, other] : along) {
            if (has(one) != has(other)) {
                names.push_back(slope->joint[has(one) ? other : one].name);
                any = true;
            }
        }
    }
    return names;
}

std::vector<std::size_t> materials_of_joints(const BlockScene& made_of, const RelaxationScene& scene,
                                             const std::vector<std::string>& names) {
    std::vector<std::size_t> joints(scene.material.size());
    std::iota(joints.begin(), joints.end(), std::size_t{0});
    std::visit(
        [&](const auto& blocks) {
            if constexpr (is_standing<std::remove_cvref_t<decltype(blocks)>>) {
                if (!blocks.scatter) {
                    return;
                }
                auto alike = blocks;
                alike.scatter.reset();
                RelaxationStudy study{};
                study.model.scene = alike;
                const RelaxationScene unscattered = relaxation_scene(study);
                for (std::size_t block = 0; block < scene.block.size(); ++block) {
                    for (std::size_t edge = 0; edge < scene.block[block].joint.size(); ++edge) {
                        joints[scene.block[block].joint[edge]] = unscattered.block[block].joint[edge];
                    }
                }
            }
        },
        made_of);
    const std::vector<std::string> known = joint_names(made_of);
    const std::vector<std::string> reduced = joints_reduced(made_of, names);
    std::vector<std::size_t> materials;
    for (std::size_t material = 0; material < joints.size(); ++material) {
        if (reduced.empty() || std::ranges::find(reduced, known[joints[material]]) != reduced.end()) {
            materials.push_back(material);
        }
    }
    return materials;
}

}  // namespace delabole
