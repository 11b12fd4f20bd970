#include "dynamic_relaxation/contact/bonds.hpp"

#include "dynamic_relaxation/contact/by_block.hpp"
#include "dynamic_relaxation/contact/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace delabole {

namespace {

// Distance of a block's centroid from the line of its face; a fixed block does not deform.
double depth_behind(const Bodies& bodies, std::size_t edge) {
    return bodies.fixed[bodies.block_of[edge]] != 0 ? 0 : bodies.normal(edge).dot(bodies.corner[edge]);
}

// Two contacts at the ends of the face.
FaceStiffness of_contacts(const JointMaterial& joint, double length, double mass, double viscous_damping) {
    const double lever_square = length * length / 4;
    const double normal_dashpot = 2 * viscous_damping * std::sqrt(mass * joint.normal_stiffness);
    const double shear_dashpot = 2 * viscous_damping * std::sqrt(mass * joint.shear_stiffness);
    return {2 * joint.normal_stiffness, 2 * joint.shear_stiffness, 2 * joint.normal_stiffness * lever_square,
            2 * normal_dashpot,         2 * shear_dashpot,         2 * normal_dashpot * lever_square};
}

FaceStiffness greater_of(const FaceStiffness& one, const FaceStiffness& other) {
    return {
        std::max(one.normal_stiffness, other.normal_stiffness),   std::max(one.shear_stiffness, other.shear_stiffness),
        std::max(one.bending_stiffness, other.bending_stiffness), std::max(one.normal_dashpot, other.normal_dashpot),
        std::max(one.shear_dashpot, other.shear_dashpot),         std::max(one.bending_dashpot, other.bending_dashpot)};
}

JointMaterial joint_of(const RelaxationScene& scene, const Bodies& bodies, const SharedFace& face) {
    return joint_between(scene, bodies, face.edge, face.other_edge);
}

// Materials of both sides of a face, the lesser index first.
using BothJoints = std::pair<std::size_t, std::size_t>;

BothJoints joints_of(const Bodies& bodies, const SharedFace& face) {
    return std::minmax(static_cast<std::size_t>(bodies.material[face.edge]),
                       static_cast<std::size_t>(bodies.material[face.other_edge]));
}

Bond make_bond(const SharedFace& face, const BondMaterial& material, const JointMaterial& joint, const Bodies& bodies,
               double viscous_damping) {
    const double spacing =
        material.spacing.value_or(depth_behind(bodies, face.edge) + depth_behind(bodies, face.other_edge));
    Bond bond{};
    bond.face = face;
    bond.normal_stiffness = material.young_modulus / spacing * face.length;
    bond.shear_stiffness = material.shear_modulus / spacing * face.length;
    bond.bending_stiffness = bond.normal_stiffness * face.length * face.length / 12;
    const double mass = 1 / (bodies.inverse_mass[face.block] + bodies.inverse_mass[face.other]);
    const double inertia = 1 / (bodies.inverse_inertia[face.block] + bodies.inverse_inertia[face.other]);
    bond.normal_dashpot = 2 * viscous_damping * std::sqrt(mass * bond.normal_stiffness);
    bond.shear_dashpot = 2 * viscous_damping * std::sqrt(mass * bond.shear_stiffness);
    bond.bending_dashpot = 2 * viscous_damping * std::sqrt(inertia * bond.bending_stiffness);
    bond.tension = material.tensile_strength;
    bond.cohesion = material.cohesion;
    bond.friction = std::tan(material.friction_angle);
    bond.of_joint = false;
    bond.stiffest = greater_of(bond, of_contacts(joint, face.length, mass, viscous_damping));
    bond.contact_stiffness = joint.normal_stiffness;
    return bond;
}

// Convex blocks touch along one line. The face is the whole part of it that the same joint as that of `part` follows,
// however corners divide it; lengths in between that another joint follows, or that a third block parts, do not count.
// `faces`: of find_shared_faces, whose blocks have the order of those of find_bonds.
SharedFace whole_face(const Bodies& bodies, const std::vector<SharedFace>& faces, const SharedFace& part) {
    double begin = -part.length / 2;
    double end = part.length / 2;
    double length = part.length;
    const auto blocks = [](const SharedFace& face) { return BlockPair(face.block, face.other); };
    for (auto at = std::ranges::lower_bound(faces, blocks(part), {}, blocks);
         at != faces.end() && blocks(*at) == blocks(part); ++at) {
        const SharedFace& face = *at;
        if ((face.edge != part.edge || face.other_edge != part.other_edge) &&
            joints_of(bodies, face) == joints_of(bodies, part)) {
            const double middle = part.along.dot(face.other_arm - part.other_arm);
            begin = std::min(begin, middle - face.length / 2);
            end = std::max(end, middle + face.length / 2);
            length += face.length;
        }
    }
    SharedFace whole = part;
    if (end - begin > part.length) {
        const PlanePoint<> shift = (begin + end) / 2 * part.along;
        whole.arm += shift;
        whole.other_arm += shift;
        whole.length = length;
    }
    return whole;
}

// A bond is as stiff as the two contacts, so that they take over where it opens as if they had been there before.
Bond make_joint_bond(const SharedFace& face, const JointMaterial& joint, const Bodies& bodies, double viscous_damping) {
    const double mass = 1 / (bodies.inverse_mass[face.block] + bodies.inverse_mass[face.other]);
    Bond bond{};
    bond.stiffest = of_contacts(joint, face.length, mass, viscous_damping);
    static_cast<FaceStiffness&>(bond) = bond.stiffest;
    bond.face = face;
    bond.tension = joint.tensile_strength;
    bond.cohesion = joint.cohesion;
    bond.friction = std::tan(joint.friction_angle);
    bond.of_joint = true;
    bond.contact_stiffness = joint.normal_stiffness;
    return bond;
}

bool has_strength_to_lose(const JointMaterial& joint) {
    return joint.tensile_strength > 0 || joint.cohesion > joint.residual_cohesion ||
           joint.residual_friction_angle.value_or(joint.friction_angle) < joint.friction_angle;
}

BlockPair blocks_of(const SharedFace& face) {
    return {std::min(face.block, face.other), std::max(face.block, face.other)};
}

// The shift at which contacts at both ends of the face carry the same as the rock's linear stress did.
OutlineShift shift_by(const Bond& bond, const FacePosition& at) {
    const SharedFace& face = bond.face;
    // Openings at the start and the end of the other block's edge.
    const std::array<double, 2> opening{at.opening + at.turn * face.length / 2, at.opening - at.turn * face.length / 2};
    const double even = -bond.normal_stiffness * at.opening / 2;
    const double tilting = bond.normal_stiffness * at.turn * face.length / 12;
    const std::array<double, 2> pressing{even - tilting, even + tilting};
    std::array<double, 2> shift{};
    for (std::size_t end = 0; end < 2; ++end) {
        const double held = pressing[end] > 0 ? -pressing[end] / bond.contact_stiffness : std::max(opening[end], 0.0);
        shift[end] = held - opening[end];
    }
    return outline_shift(face, shift);
}

// Returns the mode in which an overloaded bond breaks.
BondState state_under(const Bond& bond, const BondLoading& loading) {
    if (loading.worst() <= 1) {
        return BondState::whole;
    }
    if (loading.tension < loading.shear) {
        return BondState::broken_in_shear;
    }
    return bond.of_joint && bond.tension == 0 ? BondState::handed_over : BondState::broken_in_tension;
}

// A dashpot acts from half a step before its force is evaluated to half a step after: the energy balance takes half of
// its work with each of the two velocities. The velocities are those that led here, half a step ago.
ForceOnCorner advance_bond(const Bond& bond, BondMemory& memory, const Motion& block, const Motion& other,
                           double step) {
    const FacePosition at = locate(bond.face, block, other);
    const ContactVelocity<double> velocity = velocity_of<double>(at, block, other);
    const double opening = velocity.opening;
    const double shearing = velocity.shearing;
    const double bending = block.spin - other.spin;
    const auto account = [&] {
        memory.damping -=
            step / 2 * (memory.normal_drag * opening + memory.shear_drag * shearing + memory.bending_drag * bending);
    };
    account();
    memory.normal_drag = memory.shear_drag = memory.bending_drag = 0;
    memory.state = state_under(bond, loading_of(bond, at));
    if (memory.state != BondState::whole) {
        return {};
    }
    memory.normal_drag = -bond.normal_dashpot * opening;
    memory.shear_drag = -bond.shear_dashpot * shearing;
    memory.bending_drag = -bond.bending_dashpot * bending;
    account();
    const double normal = -bond.normal_stiffness * at.opening + memory.normal_drag;
    const double shear = -bond.shear_stiffness * at.slide + memory.shear_drag;
    const double moment = -bond.bending_stiffness * at.turn + memory.bending_drag;
    ForceOnCorner force;
    force.x = at.normal_x * normal + at.along_x() * shear;
    force.y = at.normal_y * normal + at.along_y() * shear;
    force.moment = at.arm_x * force.y - at.arm_y * force.x + moment;
    force.other_moment = at.other_arm_y * force.x - at.other_arm_x * force.y - moment;
    return force;
}

}  // namespace

std::vector<Bond> make_bonds(const RelaxationScene& scene, const Bodies& bodies, double viscous_damping) {
    std::vector<Bond> bonds;
    bonds.reserve(scene.bond.size());
    const bool any_of_joint = std::ranges::any_of(scene.bond, [](const FaceBond& bond) { return !bond.of_rock; });
    const std::vector<SharedFace> faces = any_of_joint ? find_shared_faces(bodies) : std::vector<SharedFace>();
    for (const FaceBond& bond : scene.bond) {
        const std::optional<SharedFace> face = shared_face(bodies, bodies.range[bond.block].begin + bond.edge,
                                                           bodies.range[bond.other].begin + bond.other_edge);
        const JointMaterial joint = joint_of(scene, bodies, *face);
        bonds.push_back(bond.of_rock
                            ? make_bond(*face, *joint.bond, joint, bodies, viscous_damping)
                            : make_joint_bond(whole_face(bodies, faces, *face), joint, bodies, viscous_damping));
    }
    return bonds;
}

std::vector<FaceBond> find_bonds(const RelaxationScene& scene) {
    std::vector<FaceBond> bonds;
    if (std::ranges::none_of(scene.material,
                             [](const JointMaterial& joint) { return joint.bond || has_strength_to_lose(joint); })) {
        return bonds;
    }
    const Bodies bodies = make_bodies(scene);
    BlockPair pair(0, 0);
    std::vector<BothJoints> spread;  // joints with a bond of the whole face of this pair
    for (const SharedFace& face : find_shared_faces(bodies)) {
        if (pair != BlockPair(face.block, face.other)) {
            pair = BlockPair(face.block, face.other);
            spread.clear();
        }
        const JointMaterial joint = joint_of(scene, bodies, face);
        const bool known = std::ranges::find(spread, joints_of(bodies, face)) != spread.end();
        if (joint.bond || (has_strength_to_lose(joint) && !known)) {
            bonds.push_back({face.block, face.edge - bodies.range[face.block].begin, face.other,
                             face.other_edge - bodies.range[face.other].begin, joint.bond.has_value()});
            if (!joint.bond) {
                spread.push_back(joints_of(bodies, face));
            }
        }
    }
    return bonds;
}

double elastic_energy(const Bond& bond, const FacePosition& at) {
    return (bond.normal_stiffness * at.opening * at.opening + bond.shear_stiffness * at.slide * at.slide +
            bond.bending_stiffness * at.turn * at.turn) /
           2;
}

BondLoading loading_of(const Bond& bond, const FacePosition& at) {
    const double length = bond.face.length;
    // Stress at the end of an elastic section under this force and moment; springs over a face give it directly.
    const double tension =
        bond.of_joint
            ? (bond.normal_stiffness * at.opening + 6 * bond.bending_stiffness * std::abs(at.turn) / length) / length
            : bond.normal_stiffness * at.widest(length) / length;
    const double compression = -bond.normal_stiffness * at.opening / length;
    const double shear = bond.shear_stiffness * std::abs(at.slide) / length;
    const double strength = std::max(bond.cohesion + compression * bond.friction, 0.0);
    // Where the strength is zero, any load exceeds it, and a zero load does not.
    const auto share = [](double stress, double most) {
        return stress <= 0 ? 0 : most > 0 ? stress / most : std::numeric_limits<double>::infinity();
    };
    // Both corners would be in compression: N / 2 >= M / L.
    const bool closed = bond.of_joint && at.widest(length) <= 0;
    return {closed ? 0 : share(tension, bond.tension), share(shear, strength)};
}

Bonds::Bonds(const RelaxationScene& scene, const Bodies& bodies, double viscous_damping, Team& team)
    : team_(team),
      bond_(make_bonds(scene, bodies, viscous_damping)),
      force_(bond_.size()),
      breaks_(bond_.size(), 0),
      closed_(closing_shifts(bodies)) {
    if (bond_.empty()) {
        return;
    }
    force_on_block_.resize(bodies.size());
    const auto blocks_of = [](const Bond& bond) { return std::pair(bond.face.block, bond.face.other); };
    index_by_block(bodies.size(), bond_, blocks_of, begin_, of_block_);
}

std::span<const std::uint32_t> Bonds::of_block(std::size_t block) const {
    return begin_.empty() ? std::span<const std::uint32_t>()
                          : std::span(of_block_).subspan(begin_[block], begin_[block + 1] - begin_[block]);
}

std::vector<BlockPair> Bonds::joined(const std::vector<BondMemory>& memory) const {
    std::vector<BlockPair> pairs;
    for (std::size_t index = 0; index < bond_.size(); ++index) {
        if (memory[index].state == BondState::whole) {
            pairs.push_back(blocks_of(bond_[index].face));
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

void Bonds::resume(const std::vector<BondMemory>& memory) {
    shifted_ = closed_;
    for (std::size_t index = 0; index < bond_.size(); ++index) {
        if (memory[index].shift != OutlineShift{}) {
            const BlockPair pair = blocks_of(bond_[index].face);
            const OutlineShift& since = memory[index].shift;
            const auto closed = std::ranges::lower_bound(closed_, pair, {}, &ShiftedPair::pair);
            if (closed != closed_.end() && closed->pair == pair) {
                OutlineShift& shift = shifted_[static_cast<std::size_t>(closed - closed_.begin())].shift;
                shift = {closed->shift.x + since.x, closed->shift.y + since.y, closed->shift.angle + since.angle};
            } else {
                shifted_.push_back({pair, since});
            }
        }
    }
    std::ranges::sort(shifted_, {}, &ShiftedPair::pair);
}

// All bonds of a pair see the same relative motion of the two blocks: the shift of the longest bond of those that broke
// last is used for the pair.
void Bonds::shift_outlines(const std::vector<std::size_t>& broken, const std::vector<Motion>& motion,
                           std::vector<BondMemory>& memory) {
    bool any = false;
    for (const std::size_t index : broken) {
        const Bond& bond = bond_[index];
        const auto stands_for = [&](std::size_t other) {
            return std::pair(bond.face.length, other) < std::pair(bond_[other].face.length, index);
        };
        const auto stands_before = [&](std::size_t other) {
            return other != index && blocks_of(bond_[other].face) == blocks_of(bond.face) &&
                   (memory[other].state == BondState::whole ||
                    (std::ranges::binary_search(broken, other) && !bond_[other].of_joint && stands_for(other)));
        };
        if (!bond.of_joint && std::ranges::none_of(of_block(bond.face.block), stands_before)) {
            memory[index].shift = shift_by(bond, locate(bond.face, motion[bond.face.block], motion[bond.face.other]));
            any = true;
        }
    }
    if (any) {
        resume(memory);
    }
}

std::vector<std::size_t> Bonds::stretch(const std::vector<Motion>& motion, double step, double time,
                                        std::vector<BondMemory>& memory) {
    constexpr std::size_t worth_dividing = 512;
    std::fill(breaks_.begin(), breaks_.end(), char{0});
    const auto advance = [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const SharedFace& face = bond_[index].face;
            force_[index] = {};
            if (memory[index].state == BondState::whole) {
                force_[index] = advance_bond(bond_[index], memory[index], motion[face.block], motion[face.other], step);
                breaks_[index] = memory[index].state == BondState::whole ? 0 : 1;
            }
        }
    };
    if (bond_.size() < worth_dividing) {
        advance(0, bond_.size());
    } else {
        team_.run([&](std::size_t part) {
            advance(part_begin(bond_.size(), part, team_.size()), part_begin(bond_.size(), part + 1, team_.size()));
        });
    }
    sum();
    std::vector<std::size_t> broken;
    for (std::size_t index = 0; index < bond_.size(); ++index) {
        if (breaks_[index] != 0) {
            memory[index].time = time;
            broken.push_back(index);
        }
    }
    shift_outlines(broken, motion, memory);
    return broken;
}

void Bonds::sum() {
    std::fill(force_on_block_.begin(), force_on_block_.end(), BlockForce{});
    for (std::size_t index = 0; index < bond_.size(); ++index) {
        const ForceOnCorner& force = force_[index];
        force_on_block_[bond_[index].face.block] += force.on_block();
        force_on_block_[bond_[index].face.other] += force.on_other();
    }
}

double Bonds::elastic_energy(std::size_t index, const std::vector<Motion>& motion, double ago) const {
    const Bond& bond = bond_[index];
    const Motion& block = motion[bond.face.block];
    const Motion& other = motion[bond.face.other];
    const FacePosition at = locate(bond.face, block, other);
    const auto [opening, shearing] = velocity_of<double>(at, block, other);
    return delabole::elastic_energy(bond, at) -
           ago * (bond.normal_stiffness * at.opening * opening + bond.shear_stiffness * at.slide * shearing +
                  bond.bending_stiffness * at.turn * (block.spin - other.spin));
}

double Bonds::elastic_energy(const std::vector<Motion>& motion, const std::vector<BondMemory>& memory) const {
    double sum = 0;
    for (std::size_t index = 0; index < bond_.size(); ++index) {
        if (memory[index].state == BondState::whole) {
            sum += elastic_energy(index, motion);
        }
    }
    return sum;
}

std::vector<std::size_t> Bonds::break_at_rest(const std::vector<Motion>& motion, double time,
                                              std::vector<BondMemory>& memory) {
    std::vector<std::size_t> changed;
    std::optional<std::size_t> worst;
    double most = 1;
    for (std::size_t index = 0; index < bond_.size(); ++index) {
        const Bond& bond = bond_[index];
        if (memory[index].state != BondState::whole) {
            continue;
        }
        const BondLoading loading =
            loading_of(bond, locate(bond.face, motion[bond.face.block], motion[bond.face.other]));
        const bool may_hand_over = bond.of_joint && (bond.tension == 0 || loading.shear > loading.tension);
        if (may_hand_over && loading.worst() > 1) {
            memory[index].state = BondState::handed_over;
            changed.push_back(index);
        } else if (loading.worst() > most) {
            most = loading.worst();
            worst = index;
        }
    }
    if (changed.empty() && worst) {
        const Bond& bond = bond_[*worst];
        const FacePosition at = locate(bond.face, motion[bond.face.block], motion[bond.face.other]);
        memory[*worst].state = state_under(bond, loading_of(bond, at));
        changed.push_back(*worst);
    }
    for (const std::size_t index : changed) {
        memory[index].time = time;
    }
    shift_outlines(changed, motion, memory);
    return changed;
}

// The contacts lie along the face; the straight face of either block may have several edges. Contacts of a joint get
// the state that they would have had without the bond. Contacts of rock share the shear force of the bond in proportion
// to their compression.
double hand_over(const Bond& bond, BondState state, const Bodies& bodies, const std::vector<Motion>& motion,
                 ContactList& list, double ago) {
    const SharedFace& face = bond.face;
    const bool keeps_cohesion = bond.of_joint && state != BondState::broken_in_shear;
    struct Taker {
        std::size_t contact;
        double pressing;  // N/m, without its weight
        double weight;
    };
    std::vector<Taker> takers;
    double pressed = 0;
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const RelaxationContact contact = list.contact[index];
        constexpr double straight = 0.9999;  // cosine; faces that lie on each other lean by less
        const double along = bodies.along[contact.edge].dot(face.along);
        if (!(contact.block == face.block && contact.other == face.other && along > straight) &&
            !(contact.block == face.other && contact.other == face.block && along < -straight)) {
            continue;
        }
        const auto [same, law, memory, at] = contact_now(list, index, motion);
        takers.push_back(
            {index, law.normal_stiffness * std::max(-at.gap, 0.0), contact_weight(law, contact, at, false)});
        pressed += takers.back().weight * takers.back().pressing;
    }
    const double held_by_rock = -bond.shear_stiffness * locate(face, motion[face.block], motion[face.other]).slide;
    double held = 0;
    for (const Taker& taker : takers) {
        auto [contact, law, memory, at] = contact_now(list, taker.contact, motion);
        memory.beneath = false;
        memory.broken = !keeps_cohesion;
        // An end that has just lifted off opens in the next step and then loses its cohesion.
        memory.touching = (taker.pressing > 0 && taker.weight > 0) || keeps_cohesion;
        memory.place = at.slide;
        const double most = shear_strength(law, taker.pressing, memory.broken) / law.shear_stiffness;
        // If the pair is named the other way round, edge and force both reverse, so that the sign is the same.
        const double slide =
            bond.of_joint ? at.slide : -held_by_rock * taker.pressing / (pressed * law.shear_stiffness);
        memory.shear = memory.touching ? std::clamp(slide, -most, most) : 0;
        const auto [opening, shearing] = velocity_of<double>(at, motion[contact.block], motion[contact.other]);
        const double power = law.shear_stiffness * memory.shear * shearing - taker.pressing * opening;
        held += elastic_energy(law, contact, memory, at) - (memory.touching ? ago * taker.weight * power : 0);
        list.memory.set(taker.contact, memory);
    }
    return held;
}

}  // namespace delabole
