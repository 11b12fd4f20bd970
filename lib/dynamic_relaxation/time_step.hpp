// The greatest stable step of a system of blocks on springs.
#pragma once

#include "dynamic_relaxation/bonds.hpp"
#include "dynamic_relaxation/contacts.hpp"

#include <vector>

namespace delabole {

// s; the least over all blocks of the greatest step that leap-frog with dashpots half a step behind bears,
//   step^2 stiffness / 4 + step damping / 2 = 1,
// where stiffness and damping are the greatest eigenvalues of (mass matrix)^-1 (sum over all contacts of the list and
// all whole bonds, each
// taken with the contacts that would replace it), those with free blocks counted twice: no system of such blocks can be
// stiffer, whichever of the contacts close. Without damping it is 2 / (circular frequency). Infinite without any.
double stable_step(const Bodies& bodies, const std::vector<Motion>& motion, const ContactList& list, const Bonds& bonds,
                   const std::vector<BondMemory>& bond_memory);

}  // namespace delabole
