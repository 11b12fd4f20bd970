#include "dynamic_relaxation/strength_bound.hpp"

#include "dynamic_relaxation/bodies.hpp"
#include "dynamic_relaxation/loads.hpp"
#include "dynamic_relaxation/shared_faces.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace delabole {

namespace {

bool has_only_friction_and_cohesion(const RelaxationScene& scene) {
    const bool joints = std::ranges::all_of(
        scene.material, [](const JointMaterial& joint) { return joint.tensile_strength == 0 && !joint.bond; });
    return joints && scene.bond.empty() && scene.motion.empty() && scene.removal.empty() && !scene.belt;
}

// The weaker joint of two faces decides, as in motion.
const JointMaterial& joint_of(const RelaxationScene& scene, const Bodies& bodies, const SharedFace& face) {
    const JointMaterial& one = scene.material[bodies.material[face.edge]];
    const JointMaterial& two = scene.material[bodies.material[face.other_edge]];
    return one.friction_angle < two.friction_angle ? one : two;
}

Assembly assembly_of(const RelaxationScene& scene, const Bodies& bodies) {
    RelaxationSettings at_once;
    at_once.start = RelaxationStart::dropped;
    std::vector<BlockForce> load(bodies.size());
    sum_loads(scene, at_once, bodies, 0, bodies.fixed, std::vector<Motion>(bodies.size()), load);
    Assembly assembly;
    assembly.check = AssemblyCheck::valid;
    std::vector<std::optional<std::size_t>> body(bodies.size());
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (bodies.fixed[block] == 0) {
            body[block] = assembly.bodies.size();
            const double weight = bodies.mass[block] * scene.gravity.acceleration;
            const BodyLoad beside{Point(load[block].x, load[block].y + weight), load[block].moment};
            assembly.bodies.push_back({weight, bodies.centroid[block], beside});
        }
    }
    for (const SharedFace& face : find_shared_faces(bodies)) {
        const JointMaterial& joint = joint_of(scene, bodies, face);
        const PlanePoint<> middle = bodies.centroid[face.block] + face.arm;
        const PlanePoint<> half = face.length / 2 * face.along;
        // The face's edge has its own block, `other`, on its left.
        if (body[face.block]) {
            assembly.contacts.push_back({*body[face.block], body[face.other], middle + half, middle - half,
                                         joint.friction_angle, joint.cohesion});
        } else {
            assembly.contacts.push_back(
                {*body[face.other], {}, middle - half, middle + half, joint.friction_angle, joint.cohesion});
        }
    }
    return assembly;
}

}  // namespace

std::optional<double> greatest_strength_reduction(const RelaxationScene& scene, const std::atomic<bool>* stop) {
    if (!has_only_friction_and_cohesion(scene)) {
        return std::nullopt;
    }
    const LpBound bound = least_strength_factor(assembly_of(scene, make_bodies(scene)), stop);
    switch (bound.status) {
    case LpStatus::optimal:
        return bound.value > 0 ? 1 / bound.value : std::numeric_limits<double>::infinity();
    case LpStatus::infeasible:
        return 0;
    default:
        return std::nullopt;
    }
}

}  // namespace delabole
