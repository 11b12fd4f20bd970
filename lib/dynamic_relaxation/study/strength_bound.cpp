#include "dynamic_relaxation/study/strength_bound.hpp"

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/statics/face_assembly.hpp"
#include "dynamic_relaxation/step/loads.hpp"
#include "dynamic_relaxation/study/strength_reduction.hpp"
#include "limit_equilibrium/bound/lp_bound.hpp"
#include "numerics/constants.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace delabole {

namespace {

// Whether the loads and the blocks present are those of the initial geometry for good.
bool is_static(const RelaxationScene& scene) {
    return scene.motion.empty() && !scene.belt &&
           std::ranges::all_of(scene.removal, [](const Removal& removal) { return removal.time < 0; }) &&
           (scene.shaking.empty() || (scene.shaking.size() == 1 && scene.shaking.front().time <= 0)) &&
           (scene.gravity.rate == 0 || scene.gravity.final_tilt == scene.gravity.tilt);
}

std::vector<char> removed_at_first(const RelaxationScene& scene) {
    std::vector<char> removed(scene.block.size(), 0);
    for (const Removal& removal : scene.removal) {
        removed[removal.block] |= removal.time < 0 ? 1 : 0;
    }
    return removed;
}

FaceAssembly assembly_of(const RelaxationScene& scene, const Bodies& bodies, const std::vector<SharedFace>& faces,
                         const std::vector<char>& removed, bool tips_bear) {
    RelaxationSettings at_once;
    at_once.start = RelaxationStart::dropped;
    const std::vector<Motion> unmoved(bodies.size());
    std::vector<BlockForce> load(bodies.size());
    sum_loads(scene, at_once, bodies, 0, bodies.fixed, unmoved, load);
    const BlocksUnderLoad blocks{scene, bodies, bodies.fixed, removed, unmoved, load};
    FaceAssembly made = face_assembly(blocks, faces);
    if (tips_bear) {
        add_tips_on_edges(blocks, faces, made);
        add_bolts(blocks, made);
    }
    return made;
}

// Whether the assembly stands with its strength divided by `reduction`. Returns nothing if the linear programme has no
// answer.
std::optional<bool> stands(const Assembly& assembly, double reduction = 1) {
    const LeastImbalance found = least_imbalance(assembly, 1 / reduction);
    return found.status == LpStatus::optimal ? std::optional(found.stands()) : std::nullopt;
}

// One body of the assembly among the others, as if these were fixed.
Assembly alone(const Assembly& assembly, std::size_t body) {
    Assembly made{AssemblyCheck::valid, {assembly.bodies[body]}, {}};
    for (const Contact& contact : assembly.contacts) {
        Contact own = contact;
        if (contact.other == body) {
            std::swap(own.start, own.end);
        } else if (contact.body != body) {
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
    // A reduction of strength would divide the capacity of bolts, too.
    if (!is_static(scene) || !scene.bolt.empty()) {
        return std::nullopt;
    }
    const Bodies bodies = make_bodies(scene);
    const Assembly assembly =
        assembly_of(scene, bodies, find_shared_faces(bodies), removed_at_first(scene), true).assembly;
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

std::optional<StaticMechanism> mechanism_of_statics(const RelaxationScene& scene) {
    if (!is_static(scene)) {
        return std::nullopt;
    }
    const Bodies bodies = make_bodies(scene);
    const std::vector<SharedFace> faces = find_shared_faces(bodies);
    const std::vector<char> removed = removed_at_first(scene);
    const auto [assembly, block_of] = assembly_of(scene, bodies, faces, removed, true);
    const LeastImbalance found = least_imbalance(assembly);
    if (found.status != LpStatus::optimal || found.stands()) {
        return std::nullopt;
    }
    const std::optional<bool> with_strength =
        stands(assembly_of(with_greatest_strength(scene), bodies, faces, removed, true).assembly);
    StaticMechanism mechanism{std::vector<Motion>(bodies.size()), with_strength != true};
    for (std::size_t body = 0; body < block_of.size(); ++body) {
        const VirtualMotion& moved = found.mechanism[body];
        Motion& motion = mechanism.motion[block_of[body]];
        motion.x = moved.displacement.x();
        motion.y = moved.displacement.y();
        motion.set_angle(moved.rotation);
    }
    return mechanism;
}

std::vector<std::size_t> blocks_without_hold(const RelaxationScene& scene, const Bodies& bodies,
                                             const std::vector<SharedFace>& faces, const std::vector<char>& gone) {
    std::vector<char> bared(bodies.size(), 0);
    for (const SharedFace& face : faces) {
        bared[face.block] |= gone[face.other];
        bared[face.other] |= gone[face.block];
    }
    // A block that has lost a neighbour does not balance on a tip.
    const auto [assembly, block_of] = assembly_of(scene, bodies, faces, gone, false);
    std::vector<std::size_t> falling;
    for (std::size_t body = 0; body < block_of.size(); ++body) {
        const std::size_t block = block_of[body];
        if (bared[block] != 0 && stands(alone(assembly, body)) == false) {
            falling.push_back(block);
        }
    }
    return falling;
}

}  // namespace delabole
