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

// Whether the loads are those of the initial geometry for good, and the blocks present those of this time.
bool is_static(const RelaxationScene& scene, double time) {
    return scene.motion.empty() && !scene.belt &&
           std::ranges::all_of(scene.removal, [&](const Removal& removal) { return removal.time < time; }) &&
           (scene.shaking.empty() || (scene.shaking.size() == 1 && scene.shaking.front().time <= 0)) &&
           (scene.gravity.rate == 0 || scene.gravity.final_tilt == scene.gravity.tilt);
}

std::vector<char> all_removed(const RelaxationScene& scene) {
    std::vector<char> removed(scene.block.size(), 0);
    for (const Removal& removal : scene.removal) {
        removed[removal.block] = taken_away;
    }
    return removed;
}

std::vector<BlockForce> all_loads(const RelaxationScene& scene, const Bodies& bodies, const std::vector<char>& removed,
                                  const std::vector<Motion>& motion) {
    RelaxationSettings at_once;
    at_once.start = RelaxationStart::dropped;
    std::vector<BlockForce> load(bodies.size());
    sum_loads(scene, pressures_left(scene, bodies, removed), at_once, bodies, 0, bodies.fixed, motion, load);
    return load;
}

// The blocks as they are drawn, under all loads and without those that are taken away.
class DrawnBlocks {
  public:
    explicit DrawnBlocks(const RelaxationScene& scene)
        : scene_(scene),
          bodies_(make_bodies(scene)),
          removed_(all_removed(scene)),
          faces_(find_shared_faces(bodies_, closed_joint, removed_)),
          unmoved_(bodies_.size()),
          load_(all_loads(scene, bodies_, removed_, unmoved_)) {}

    // Faces, tips on edges and bolts, with all strengths multiplied.
    FaceAssembly assembly(double factor) const {
        const RelaxationScene scene = with_multiplied_strength(scene_, factor);
        const BlocksUnderLoad blocks{scene, bodies_, bodies_.fixed, removed_, unmoved_, load_};
        FaceAssembly made = face_assembly(blocks, faces_);
        add_tips_on_edges(blocks, faces_, made);
        add_bolts(blocks, made);
        return made;
    }

  private:
    const RelaxationScene& scene_;
    Bodies bodies_;
    std::vector<char> removed_;
    std::vector<SharedFace> faces_;
    std::vector<Motion> unmoved_;
    std::vector<BlockForce> load_;
};

std::vector<Motion> motion_of_blocks(const LeastImbalance& found, const FaceAssembly& made, std::size_t blocks) {
    std::vector<Motion> motion(blocks);
    for (std::size_t body = 0; body < found.mechanism.size(); ++body) {
        const VirtualMotion& moved = found.mechanism[body];
        Motion& of_block = motion[made.block_of[body]];
        of_block.x = moved.displacement.x();
        of_block.y = moved.displacement.y();
        of_block.set_angle(moved.rotation);
    }
    return motion;
}

// Whether the assembly stands. Returns nothing if the linear programme has no answer.
std::optional<bool> stands(const Assembly& assembly) {
    const LeastImbalance found = least_imbalance(assembly);
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
    if (!is_static(scene, 0) || !scene.bolt.empty()) {
        return std::nullopt;
    }
    const DrawnBlocks blocks(scene);
    constexpr double most = 1e6;  // blocks that stand with less strength stand without
    constexpr double accuracy = 1e-6;
    double standing = 0;
    double failing = infinity;
    for (double factor = 1; failing > (1 + accuracy) * standing;) {
        const std::optional<bool> holds = stands(blocks.assembly(1 / factor).assembly);
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

std::optional<StaticMechanism> mechanism_of_statics(const RelaxationScene& scene, double time) {
    if (!is_static(scene, time)) {
        return std::nullopt;
    }
    const DrawnBlocks blocks(scene);
    const FaceAssembly made = blocks.assembly(1);
    const LeastImbalance found = least_imbalance(made.assembly);
    if (found.status != LpStatus::optimal || found.stands()) {
        return std::nullopt;
    }
    // The greatest strength is asked last: linear programmes with it take longest, and blocks often stand with less.
    std::optional<bool> held;
    for (const double factor : {4.0, 30.0, greatest_strength}) {
        held = stands(blocks.assembly(factor).assembly);
        if (held == true) {
            break;
        }
    }
    return StaticMechanism{motion_of_blocks(found, made, scene.block.size()),
                           held ? std::optional(!*held) : std::nullopt};
}

std::optional<StaticMechanism> mechanism_where_blocks_landed(const Simulation& at_rest,
                                                             const StaticMechanism& as_drawn) {
    const RelaxationScene& scene = at_rest.scene();
    const Bodies& bodies = at_rest.bodies();
    const RelaxationState& state = at_rest.state();
    std::vector<Motion> motion(bodies.size());
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        const Motion& now = state.motion[block];
        const MotionExtremes moved{std::abs(now.angle), std::hypot(now.x, now.y) / bodies.radius[block]};
        motion[block] = moved.in_thresholds(at_rest.settings()) > 1 ? now : Motion{};
    }
    std::vector<SharedFace> faces = find_shared_faces(bodies, closed_joint, state.removed);
    std::erase_if(faces, [&](const SharedFace& face) {
        return locate(face, motion[face.block], motion[face.other]).opening >
               opening_of_closed_joint(bodies, face.block, face.other);
    });
    const std::vector<BlockForce> load = all_loads(scene, bodies, state.removed, motion);
    const BlocksUnderLoad blocks{scene, bodies, bodies.fixed, state.removed, motion, load};
    FaceAssembly made = face_assembly(blocks, faces);
    add_corners_on_edges(blocks, state.contacts, made, 1);
    add_tips_on_edges(blocks, faces, made);
    add_bolts(blocks, made);
    const LeastImbalance found = least_imbalance(made.assembly);
    if (found.status != LpStatus::optimal) {
        return as_drawn;
    }
    return found.stands() ? std::nullopt
                          : std::optional(StaticMechanism{motion_of_blocks(found, made, bodies.size()), false});
}

std::vector<std::size_t> blocks_without_hold(const RelaxationScene& scene, const Bodies& bodies,
                                             const std::vector<SharedFace>& faces, const std::vector<char>& gone) {
    std::vector<char> bared(bodies.size(), 0);
    for (const SharedFace& face : faces) {
        bared[face.block] |= gone[face.other];
        bared[face.other] |= gone[face.block];
    }
    // A block that has lost a neighbour does not balance on a tip.
    const std::vector<Motion> unmoved(bodies.size());
    const std::vector<BlockForce> load = all_loads(scene, bodies, gone, unmoved);
    const auto [assembly, block_of] = face_assembly({scene, bodies, bodies.fixed, gone, unmoved, load}, faces);
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
