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

// Bodies are the free blocks in their order.
Assembly assembly_of(const RelaxationScene& scene, const Bodies& bodies, const std::vector<SharedFace>& faces) {
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
    for (const SharedFace& face : faces) {
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

Assembly assembly_of(const RelaxationScene& scene) {
    const Bodies bodies = make_bodies(scene);
    return assembly_of(scene, bodies, find_shared_faces(bodies));
}

// Nothing where the linear programme has no answer, or the flag was set before one of the two programmes.
std::optional<bool> stands(const Assembly& assembly, const std::atomic<bool>* stop) {
    // A horizontal force of 0 lies between the greatest that the blocks bear to one side and to the other.
    constexpr double rounding = 1e-9;
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

// One body of the assembly among the others that are left, as if these were fixed.
Assembly alone(const Assembly& assembly, std::size_t body, const std::vector<char>& gone) {
    Assembly made{AssemblyCheck::valid, {assembly.bodies[body]}, {}};
    for (const Contact& contact : assembly.contacts) {
        Contact own = contact;
        if (contact.other == body && gone[contact.body] == 0) {
            std::swap(own.start, own.end);
        } else if (contact.body != body || (contact.other && gone[*contact.other] != 0)) {
            continue;
        }
        own.body = 0;
        own.other.reset();
        made.contacts.push_back(own);
    }
    return made;
}

}  // namespace

std::optional<double> greatest_strength_reduction(const RelaxationScene& scene, const std::atomic<bool>* stop) {
    if (!is_static(scene)) {
        return std::nullopt;
    }
    const LpBound bound = least_strength_factor(assembly_of(scene), stop);
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
    return stands(assembly_of(scene), stop);
}

std::vector<std::size_t> blocks_without_hold(const RelaxationScene& scene, const Bodies& bodies,
                                             const std::vector<SharedFace>& faces, const std::vector<char>& gone) {
    std::vector<std::size_t> block_of;
    std::vector<char> body_gone;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (bodies.fixed[block] == 0) {
            block_of.push_back(block);
            body_gone.push_back(gone[block]);
        }
    }
    std::vector<char> bared(bodies.size(), 0);
    for (const SharedFace& face : faces) {
        bared[face.block] |= gone[face.other];
        bared[face.other] |= gone[face.block];
    }
    const Assembly assembly = assembly_of(scene, bodies, faces);
    std::vector<std::size_t> falling;
    for (std::size_t body = 0; body < block_of.size(); ++body) {
        const std::size_t block = block_of[body];
        if (bared[block] != 0 && gone[block] == 0 && stands(alone(assembly, body, body_gone), nullptr) == false) {
            falling.push_back(block);
        }
    }
    return falling;
}

}  // namespace delabole
