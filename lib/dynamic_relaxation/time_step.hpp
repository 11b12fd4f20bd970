// The greatest stable step of a system of blocks on springs.
#pragma once

#include "dynamic_relaxation/contacts.hpp"

#include <vector>

namespace delabole {

// s; 2 / (bound on the greatest circular frequency). The bound is the greatest eigenvalue over all blocks of
// (mass matrix)^-1 (sum of the stiffnesses of all contacts of the list), those with free blocks counted twice: no
// system of such blocks can be stiffer, whichever of the contacts close. Infinite without contacts.
double stable_step(const Bodies& bodies, const std::vector<Motion>& motion, const ContactList& list);

}  // namespace delabole
