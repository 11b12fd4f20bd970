// Whether a state is an equilibrium that its joints can hold. The check uses only the motion of the blocks and the
// memory of contacts, independently of the equations by which a static solver or a run has reached the state.
#pragma once

#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"

#include <span>
#include <vector>

namespace delabole {

// Shares of the weight of the block, or of the lighter one of two free blocks, except for bonds.
struct StaticCheck {
    double unbalanced = 0;      // greatest force, with moment over radius, that loads and springs leave on a block
    double beyond_tension = 0;  // greatest pull of a contact
    double beyond_shear = 0;    // greatest shear force of a contact in excess of its friction and cohesion
    double bonds = 0;           // greatest loading of a whole bond, as a share of its strength

    // `tolerance`: for rounding and for motion that has yet to die out, as a share of a weight.
    bool holds(double tolerance) const {
        return unbalanced <= tolerance && beyond_tension <= tolerance && beyond_shear <= tolerance &&
               bonds <= 1 + tolerance;
    }
};

// Dashpots and inertia are left out. Blocks that are `held` may have any force. `list` must have all contacts that
// touch, `inverse_weight` (m/N) and `loads` have a value for each block.
StaticCheck check_statics(const Bodies& bodies, const std::vector<char>& held, std::span<const BlockForce> loads,
                          std::span<const double> inverse_weight, std::span<const Bond> bonds,
                          std::span<const BondMemory> bond_memory, const std::vector<Motion>& motion,
                          const ContactList& list);

}  // namespace delabole
