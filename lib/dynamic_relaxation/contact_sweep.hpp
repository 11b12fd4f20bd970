// Contacts one after the other, four at a time where they bear: what a step spends its time on.
#pragma once

#include "dynamic_relaxation/bodies.hpp"
#include "dynamic_relaxation/contacts.hpp"

#include <cstddef>

namespace delabole {

// What a sweep reads and changes: arrays of the blocks, and those of the list of contacts.
struct ContactSweep {
    const Motion* motion;
    const double* way;  // of each block, since the start; no point of it has come farther
    const char* moved;  // since its contacts were last evaluated; null: all have
    double step;
    const RelaxationContact* contact;
    const ContactLaw* law;
    ContactMemory* memory;
    ForceOnCorner* force;
    double* open_until;

    // Neither touches nor can have come to.
    [[gnu::always_inline]] bool stays_open(std::size_t index) const {
        return open_until[index] >= 0 && way[contact[index].block] + way[contact[index].other] <= open_until[index];
    }
    [[gnu::always_inline]] bool concerned(std::size_t index) const {
        return moved == nullptr || moved[contact[index].block] != 0 || moved[contact[index].other] != 0;
    }
};

void evaluate_contact(const ContactSweep& sweep, std::size_t index);

// Evaluates contacts of blocks that have moved, except those that stay open. Returns how many. The same bits come out
// wherever ranges begin and end, if contacts of a pair of blocks are in one.
std::size_t evaluate_contacts(ContactSweep sweep, std::size_t begin, std::size_t end);

// Adds up all forces besides, in the order of the list: what has been read need not be read again for it. `sum`: of
// each block, zero at first.
std::size_t evaluate_and_sum_contacts(ContactSweep sweep, std::size_t begin, std::size_t end, BlockForce* sum);

}  // namespace delabole
