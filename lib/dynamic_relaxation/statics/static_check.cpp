#include "dynamic_relaxation/statics/static_check.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace delabole {

namespace {

// Adds a force that acts on a block at the end of an arm from its centroid.
void act(double x, double y, double arm_x, double arm_y, BlockForce& on) {
    on.x += x;
    on.y += y;
    on.moment += arm_x * y - arm_y * x;
}

}  // namespace

StaticCheck check_statics(const Bodies& bodies, const std::vector<char>& held, std::span<const BlockForce> loads,
                          std::span<const double> inverse_weight, std::span<const Bond> bonds,
                          std::span<const BondMemory> bond_memory, const std::vector<Motion>& motion,
                          const ContactList& list) {
    StaticCheck check;
    std::vector<BlockForce> net(loads.begin(), loads.end());
    const auto share_of_lighter = [&](std::size_t block, std::size_t other) {
        return std::max(held[block] != 0 ? 0 : inverse_weight[block], held[other] != 0 ? 0 : inverse_weight[other]);
    };
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const auto [contact, law, memory, at] = contact_now(list, index, motion);
        if (!memory.touching) {
            continue;
        }
        const double weight = contact_weight(law, contact, at, memory.insists);
        const double pressing = -law.normal_stiffness * at.gap;
        const double along = -law.shear_stiffness * memory.shear;
        const double strength = shear_strength(law, std::max(pressing, 0.0), memory.broken);
        const double share = weight * share_of_lighter(contact.block, contact.other);
        check.beyond_tension = std::max(check.beyond_tension, -share * pressing);
        check.beyond_shear = std::max(check.beyond_shear, share * (std::abs(along) - strength));
        const double x = weight * (at.normal_x * pressing + at.along_x() * along);
        const double y = weight * (at.normal_y * pressing + at.along_y() * along);
        act(x, y, at.arm_x, at.arm_y, net[contact.block]);
        act(-x, -y, at.other_arm_x, at.other_arm_y, net[contact.other]);
    }
    for (std::size_t index = 0; index < bonds.size(); ++index) {
        const Bond& bond = bonds[index];
        if (bond_memory[index].state != BondState::whole) {
            continue;
        }
        const FacePosition at = locate(bond.face, motion[bond.face.block], motion[bond.face.other]);
        check.bonds = std::max(check.bonds, loading_of(bond, at).worst());
        const double normal = -bond.normal_stiffness * at.opening;
        const double along = -bond.shear_stiffness * at.slide;
        const double x = at.normal_x * normal + at.along_x() * along;
        const double y = at.normal_y * normal + at.along_y() * along;
        act(x, y, at.arm_x, at.arm_y, net[bond.face.block]);
        act(-x, -y, at.other_arm_x, at.other_arm_y, net[bond.face.other]);
        net[bond.face.block].moment -= bond.bending_stiffness * at.turn;
        net[bond.face.other].moment += bond.bending_stiffness * at.turn;
    }
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (held[block] == 0) {
            const BlockForce& left = net[block];
            check.unbalanced = std::max(
                check.unbalanced,
                inverse_weight[block] * (std::hypot(left.x, left.y) + std::abs(left.moment) / bodies.radius[block]));
        }
    }
    return check;
}

}  // namespace delabole
