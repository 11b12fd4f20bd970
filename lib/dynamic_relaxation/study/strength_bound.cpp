#include "dynamic_relaxation/study/strength_bound.hpp"

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/step/loads.hpp"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace delabole {

namespace {

bool is_static(const RelaxationScene& scene) {
    return scene.motion.empty() && scene.removal.empty() && scene.shaking.empty() && !scene.belt &&
           (scene.gravity.rate == 0 || scene.gravity.final_tilt == scene.gravity.tilt);
}

struct FaceStrength {
    double friction_angle;
    double cohesion;
    double tensile_strength;
};

// Rock across a joint adds to its strength no more than it has itself.
FaceStrength strength_of(const RelaxationScene& scene, const Bodies& bodies, const SharedFace& face) {
    const JointMaterial& joint = scene.material[weaker_joint(scene, bodies, face.edge, face.other_edge)];
    FaceStrength strength{joint.friction_angle, joint.cohesion, joint.tensile_strength};
    for (const FaceBond& bond : scene.bond) {
        const bool here = bond.block == face.block && bond.other == face.other;
        const bool there = bond.block == face.other && bond.other == face.block;
        if (bond.material && (here || there)) {
            const BondMaterial& rock = scene.bond_material[*bond.material];
            strength.friction_angle = std::max(strength.friction_angle, rock.friction_angle);
            strength.cohesion = std::max(strength.cohesion, rock.cohesion);
            strength.tensile_strength = std::max(strength.tensile_strength, rock.tensile_strength);
        }
    }
    return strength;
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
        const FaceStrength joint = strength_of(scene, bodies, face);
        const PlanePoint<> middle = bodies.centroid[face.block] + face.arm;
        const PlanePoint<> half = face.length / 2 * face.along;
        // The face's edge has its own block, `other`, on its left.
        if (body[face.block]) {
            assembly.contacts.push_back({*body[face.block], body[face.other], middle + half, middle - half,
                                         joint.friction_angle, joint.cohesion, joint.tensile_strength});
        } else {
            assembly.contacts.push_back({*body[face.other],
                                         {},
                                         middle - half,
                                         middle + half,
                                         joint.friction_angle,
                                         joint.cohesion,
                                         joint.tensile_strength});
        }
    }
    return assembly;
}

}  // namespace

std::optional<double> greatest_strength_reduction(const RelaxationScene& scene, const std::atomic<bool>* stop) {
    if (!is_static(scene)) {
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

std::optional<bool> stands_on_faces(const RelaxationScene& scene, const std::atomic<bool>* stop) {
    if (!is_static(scene)) {
        return std::nullopt;
    }
    // A horizontal force of 0 lies between the greatest that the blocks bear to one side and to the other.
    constexpr double rounding = 1e-9;
    const Assembly assembly = assembly_of(scene, make_bodies(scene));
    for (const Assembly& seen : {assembly, mirrored(assembly)}) {
        if (stop != nullptr && *stop) {
            return std::nullopt;
        }
        const LpBound tilt = largest_tilt(seen);
        if (tilt.status == LpStatus::infeasible || (tilt.status == LpStatus::optimal && tilt.value < -rounding)) {
            return false;
        }
        if (tilt.status != LpStatus::optimal && tilt.status != LpStatus::unbounded) {
            return std::nullopt;
        }
    }
    return true;
}

}  // namespace delabole
