#include "dynamic_relaxation/study/strength_bound.hpp"

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/statics/face_assembly.hpp"
#include "dynamic_relaxation/step/loads.hpp"
#include "dynamic_relaxation/study/strength_reduction.hpp"
#include "limit_equilibrium/bound/lp_bound.hpp"
#include "numerics/constants.hpp"

#include <cmath>
#include <utility>
#include <vector>

namespace delabole {

namespace {

// Bolts are excluded because their force depends on the motion of the blocks.
bool is_static(const RelaxationScene& scene) {
    return scene.bolt.empty() && scene.motion.empty() && scene.removal.empty() && scene.shaking.empty() &&
           !scene.belt && (scene.gravity.rate == 0 || scene.gravity.final_tilt == scene.gravity.tilt);
}

Assembly assembly_of(const RelaxationScene& scene, const Bodies& bodies, const std::vector<SharedFace>& faces,
                     bool tips_bear) {
    RelaxationSettings at_once;
    at_once.start = RelaxationStart::dropped;
    const std::vector<Motion> unmoved(bodies.size());
    std::vector<BlockForce> load(bodies.size());
    sum_loads(scene, at_once, bodies, 0, bodies.fixed, unmoved, load);
    const BlocksUnderLoad blocks{scene, bodies, bodies.fixed, unmoved, load};
    FaceAssembly made = face_assembly(blocks, faces);
    if (tips_bear) {
        add_tips_on_edges(blocks, faces, made);
    }
    return made.assembly;
}

// Whether the assembly stands with its strength divided by `reduction`. Returns nothing if the linear programme has no
// answer.
std::optional<bool> stands(const Assembly& assembly, double reduction = 1) {
    const LeastImbalance found = least_imbalance(assembly, 1 / reduction);
    return found.status == LpStatus::optimal ? std::optional(found.stands()) : std::nullopt;
}

// One body of the assembly among the remaining ones, as if these were fixed.
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
    const Bodies bodies = make_bodies(scene);
    const Assembly assembly = assembly_of(scene, bodies, find_shared_faces(bodies), true);
    constexpr double most = 1e6;  // blocks that stand with less strength stand without
    constexpr double accuracy = 1e-6;
    double standing = 0;
    double failing = infinity;
    for (double factor = 1; failing > (1 + accuracy) * standing;) {
        const std::optional<bool> holds = stands(assembly, factor);
        if (!holds || (stop != nullptr && *stop)) {
            return std::nullopt;
        }
        (*holds ? standing : failing) = factor;
        if (standing > most || failing < 1 / greatest_strength) {
            return standing > most ? infinity : 0;
        }
        constexpr double apart = 4;
        factor = standing == 0         ? failing / apart
                 : failing == infinity ? apart * standing
                                       : std::sqrt(standing * failing);
    }
    return standing;
}

bool lacks_forces(const RelaxationScene& scene) {
    if (!is_static(scene)) {
        return false;
    }
    const Bodies bodies = make_bodies(scene);
    const std::vector<SharedFace> faces = find_shared_faces(bodies);
    return stands(assembly_of(scene, bodies, faces, true)) == false &&
           stands(assembly_of(with_greatest_strength(scene), bodies, faces, true)) == true;
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
    // A block that has lost a neighbour does not balance on a tip.
    const Assembly assembly = assembly_of(scene, bodies, faces, false);
    std::vector<std::size_t> falling;
    for (std::size_t body = 0; body < block_of.size(); ++body) {
        const std::size_t block = block_of[body];
        if (bared[block] != 0 && gone[block] == 0 && stands(alone(assembly, body, body_gone)) == false) {
            falling.push_back(block);
        }
    }
    return falling;
}

}  // namespace delabole
