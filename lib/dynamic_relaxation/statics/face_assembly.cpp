#include "dynamic_relaxation/statics/face_assembly.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/corner_choice.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace delabole {

namespace {

struct FaceStrength {
    double friction_angle;
    double cohesion;
    double tensile_strength;
    bool bears_compression = true;
};

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;  // of blocks or edges, the lesser number first

// This is how much of its peak strength the joint of a pair still has.
struct StrengthLeft {
    bool torn = false;  // an end has slipped or opened: residual friction, no tensile strength
    double whole = 0;   // N/m, of cohesion above the residual one: of the ends that still have it
    double lost = 0;    // N/m, of the others

    double share() const { return whole + lost > 0 ? whole / (whole + lost) : torn ? 0 : 1; }
};

using StrengthsLeft = std::map<std::pair<std::size_t, std::size_t>, StrengthLeft>;  // the lesser number first

// Pairs whose strength is spread over the face as long as it is whole have their contacts after that.
StrengthsLeft strengths_left(const BlocksUnderLoad& blocks, const JointHistory& history) {
    StrengthsLeft left;
    const ContactList& list = history.contacts;
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const auto [contact, law, memory, at] = contact_now(list, index, blocks.motion);
        if (!memory.touching && !memory.broken) {
            continue;
        }
        StrengthLeft& of_pair = left[std::minmax<std::size_t>(contact.block, contact.other)];
        of_pair.torn |= memory.broken;
        (memory.broken ? of_pair.lost : of_pair.whole) +=
            contact_weight(law, contact, at, memory.insists) * (law.cohesion - law.residual_cohesion);
    }
    for (std::size_t index = 0; index < blocks.scene.bond.size(); ++index) {
        const FaceBond& bond = blocks.scene.bond[index];
        if (!bond.of_rock && history.bond[index].state != BondState::whole) {
            left[std::minmax(bond.block, bond.other)].torn = true;
        }
    }
    return left;
}

// Edges of the faces that rock bridges.
Pairs bridged_faces(const BlocksUnderLoad& blocks, const JointHistory* history) {
    Pairs bridged;
    for (std::size_t index = 0; index < blocks.scene.bond.size(); ++index) {
        const FaceBond& bond = blocks.scene.bond[index];
        if (bond.of_rock && (history == nullptr || history->bond[index].state == BondState::whole)) {
            bridged.insert(std::minmax(blocks.bodies.range[bond.block].begin + bond.edge,
                                       blocks.bodies.range[bond.other].begin + bond.other_edge));
        }
    }
    return bridged;
}

// The strength of a bonded joint is that of the joint or of the rock, whichever is greater, not their sum.
FaceStrength strength_of(const BlocksUnderLoad& blocks, const SharedFace& face, const StrengthsLeft& left,
                         const Pairs& bridged) {
    const JointMaterial joint = joint_between(blocks.scene, blocks.bodies, face.edge, face.other_edge);
    FaceStrength strength{joint.friction_angle, joint.cohesion, joint.tensile_strength};
    if (const auto found = left.find(std::minmax<std::size_t>(face.block, face.other)); found != left.end()) {
        const StrengthLeft& of_pair = found->second;
        strength.cohesion = joint.residual_cohesion + of_pair.share() * (joint.cohesion - joint.residual_cohesion);
        if (of_pair.torn) {
            strength.tensile_strength = 0;
            strength.friction_angle = joint.residual_friction_angle.value_or(joint.friction_angle);
        }
    }
    if (joint.bond && bridged.contains(std::minmax<std::size_t>(face.edge, face.other_edge))) {
        strength.friction_angle = std::max(strength.friction_angle, joint.bond->friction_angle);
        strength.cohesion = std::max(strength.cohesion, joint.bond->cohesion);
        strength.tensile_strength = std::max(strength.tensile_strength, joint.bond->tensile_strength);
    }
    // The programme's faces shear at cohesion + (N + tensile strength) tan(friction).
    if (const double friction = std::tan(strength.friction_angle); friction > 0) {
        strength.tensile_strength = std::min(strength.tensile_strength, strength.cohesion / friction);
        strength.cohesion -= strength.tensile_strength * friction;
        strength.cohesion = std::max(0.0, strength.cohesion);  // less by rounding
    }
    return strength;
}

constexpr std::size_t held = static_cast<std::size_t>(-1);

std::vector<std::size_t> bodies_of_blocks(const BlocksUnderLoad& blocks) {
    std::vector<std::size_t> body(blocks.held.size(), held);
    std::size_t next = 0;
    for (std::size_t block = 0; block < body.size(); ++block) {
        if (blocks.held[block] == 0 && blocks.removed[block] == 0) {
            body[block] = next++;
        }
    }
    return body;
}

bool both_there(const BlocksUnderLoad& blocks, std::size_t block, std::size_t other) {
    return blocks.removed[block] == 0 && blocks.removed[other] == 0;
}

bool has_moved(const BlocksUnderLoad& blocks, std::size_t block) {
    const Motion& motion = blocks.motion[block];
    return motion.x != 0 || motion.y != 0 || motion.angle != 0;
}

PlanePoint<> centroid_of(const BlocksUnderLoad& blocks, std::size_t block) {
    const Motion& motion = blocks.motion[block];
    return blocks.bodies.centroid[block] + PlanePoint<>(motion.x, motion.y);
}

// `half` points along the edge of `other`, which lies to the left of it.
void add_face(std::size_t block, std::size_t other, const PlanePoint<>& middle, const PlanePoint<>& half,
              const FaceStrength& strength, Assembly& assembly) {
    if (block == held && other == held) {
        return;
    }
    const PlanePoint<> to_start = block != held ? half : PlanePoint<>(-half);
    assembly.contacts.push_back({block != held ? block : other,
                                 block != held && other != held ? std::optional(other) : std::nullopt,
                                 middle + to_start, middle - to_start, strength.friction_angle, strength.cohesion,
                                 strength.tensile_strength, strength.bears_compression});
}

// Whether a corner bears on its edge and not on a corner of it.
bool is_on_edge(const Bodies& bodies, const ContactLaw& law, const RelaxationContact& contact,
                const ContactPosition& at) {
    return !is_on_corner(bodies, law, contact, at) || (law.alone == 0 && std::abs(law.rival_sine) < least_bend);
}

// Half the length of a face in place of a point, since the linear programme requires a length.
double half_of_point(const Bodies& bodies, std::size_t block, std::size_t other) {
    return 1e-6 * std::min(bodies.shortest_edge[block], bodies.shortest_edge[other]);
}

void add_tips(const BlocksUnderLoad& blocks, std::size_t block, std::size_t other, const std::vector<std::size_t>& body,
              const BlocksBetween& between, Assembly& assembly) {
    const Bodies& bodies = blocks.bodies;
    const double tolerance = opening_of_closed_joint(bodies, block, other);
    const auto friction_on = [&](std::size_t edge) {
        return blocks.scene.material[bodies.material[edge]].friction_angle;
    };
    const auto goes_on = [&](std::size_t edge, std::size_t beyond) {
        const PlanePoint<>& one = bodies.along[edge];
        const PlanePoint<>& two = bodies.along[beyond];
        return one.dot(two) > 0 && std::abs(one.x() * two.y() - one.y() * two.x()) < least_bend;
    };
    for (std::size_t edge = bodies.range[other].begin; edge < bodies.range[other].end; ++edge) {
        const PlanePoint<> start = bodies.centroid[other] + bodies.corner[edge];
        const PlanePoint<>& along = bodies.along[edge];
        const double first = goes_on(edge, bodies.range[other].before(edge)) ? -tolerance : tolerance;
        const double last =
            bodies.length[edge] - (goes_on(edge, bodies.range[other].after(edge)) ? -tolerance : tolerance);
        for (std::size_t corner = bodies.range[block].begin; corner < bodies.range[block].end; ++corner) {
            const PlanePoint<> point = bodies.centroid[block] + bodies.corner[corner];
            const double place = along.dot(point - start);
            const double gap = bodies.normal(edge).dot(point - start);
            if (std::abs(gap) <= tolerance && place > first && place < last && !between.part(corner, edge, gap)) {
                const double one = friction_on(corner);
                const double two = friction_on(bodies.range[block].before(corner));
                double friction = std::min(std::max(one, two), friction_on(edge));
                // On an edge that goes on as one face beyond this point, the weakest joint that meets there counts.
                if (place < tolerance) {
                    friction = std::min({one, two, friction, friction_on(bodies.range[other].before(edge))});
                } else if (place > bodies.length[edge] - tolerance) {
                    friction = std::min({one, two, friction, friction_on(bodies.range[other].after(edge))});
                }
                add_face(body[block], body[other], point, half_of_point(bodies, block, other) * along, {friction, 0, 0},
                         assembly);
            }
        }
    }
}

}  // namespace

FaceAssembly face_assembly(const BlocksUnderLoad& blocks, const std::vector<SharedFace>& faces,
                           const JointHistory* history) {
    const StrengthsLeft left = history == nullptr ? StrengthsLeft() : strengths_left(blocks, *history);
    const Pairs bridged = bridged_faces(blocks, history);
    const Bodies& bodies = blocks.bodies;
    const std::vector<std::size_t> body = bodies_of_blocks(blocks);
    FaceAssembly made;
    made.assembly.check = AssemblyCheck::valid;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (body[block] != held) {
            const double weight = bodies.mass[block] * blocks.scene.gravity.acceleration;
            const BlockForce& load = blocks.load[block];
            made.assembly.bodies.push_back(
                {weight, centroid_of(blocks, block), {Point(load.x, load.y + weight), load.moment}});
            made.block_of.push_back(block);
        }
    }
    for (const SharedFace& face : faces) {
        if (!both_there(blocks, face.block, face.other)) {
            continue;
        }
        const FacePosition at = locate(face, blocks.motion[face.block], blocks.motion[face.other]);
        const PlanePoint<> middle = centroid_of(blocks, face.block) + PlanePoint<>(at.arm_x, at.arm_y);
        const PlanePoint<> half = face.length / 2 * PlanePoint<>(at.along_x(), at.along_y());
        add_face(body[face.block], body[face.other], middle, half, strength_of(blocks, face, left, bridged),
                 made.assembly);
    }
    return made;
}

void add_corners_on_edges(const BlocksUnderLoad& blocks, const ContactList& list, FaceAssembly& made,
                          double least_gap) {
    const std::vector<std::size_t> body = bodies_of_blocks(blocks);
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const auto [contact, law, memory, at] = contact_now(list, index, blocks.motion);
        if (!memory.touching ||
            contact.gap <= least_gap * opening_of_closed_joint(blocks.bodies, contact.block, contact.other) ||
            !is_on_edge(blocks.bodies, law, contact, at)) {
            continue;
        }
        const PlanePoint<> point = centroid_of(blocks, contact.block) + PlanePoint<>(at.arm_x, at.arm_y);
        const double half = half_of_point(blocks.bodies, contact.block, contact.other);
        const double friction = memory.broken ? law.residual_friction : law.friction;
        add_face(body[contact.block], body[contact.other], point, half * PlanePoint<>(at.along_x(), at.along_y()),
                 {std::atan(friction), 0, 0}, made.assembly);
    }
}

void add_tips_on_edges(const BlocksUnderLoad& blocks, const std::vector<SharedFace>& faces, FaceAssembly& made) {
    Pairs facing;
    for (const SharedFace& face : faces) {
        facing.insert(std::minmax<std::size_t>(face.block, face.other));
    }
    const std::vector<std::size_t> body = bodies_of_blocks(blocks);
    const std::vector<BlockPair> touching = touching_blocks(blocks.bodies);
    const BlocksBetween between(blocks.bodies, touching, blocks.removed);
    for (const auto& [first, second] : touching) {
        if (both_there(blocks, first, second) && !has_moved(blocks, first) && !has_moved(blocks, second) &&
            !facing.contains(std::minmax<std::size_t>(first, second))) {
            add_tips(blocks, first, second, body, between, made.assembly);
            add_tips(blocks, second, first, body, between, made.assembly);
        }
    }
}

void add_bolts(const BlocksUnderLoad& blocks, FaceAssembly& made) {
    const std::vector<std::size_t> body = bodies_of_blocks(blocks);
    for (const BoltSegment& bolt : blocks.scene.bolt) {
        if (!both_there(blocks, bolt.block, bolt.other)) {
            continue;
        }
        // A face across the bolt, with the other block ahead of it.
        const double half = half_of_point(blocks.bodies, bolt.block, bolt.other);
        const PlanePoint<> along = (bolt.other_at - bolt.at).normalized();
        const PlanePoint<> arm = bolt.at - blocks.bodies.centroid[bolt.block];
        const PlanePoint<> at = centroid_of(blocks, bolt.block) + blocks.motion[bolt.block].turned(arm);
        add_face(body[bolt.block], body[bolt.other], at, half * PlanePoint<>(along.y(), -along.x()),
                 {0, 0, bolt.capacity / (2 * half), false}, made.assembly);
    }
}

}  // namespace delabole
