// Evaluates contacts in order, as many at a time as a register holds: this takes most of the time of a step.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace delabole {

// The arrays of the blocks and of the list of contacts that a sweep reads and changes.
struct ContactSweep {
    const Motion* motion;
    const double* travelled;  // of each block since the start; no point of it has moved farther
    const char* moved;        // whether contacts of a block are to be evaluated again; null: all blocks
    double step;
    const ContactBlocks* contact;
    const ContactCorner* corner;
    const ContactShapeOf<NumberGroup>* shape;
    const EdgeEnds* ends;
    const JointLaw* joint;
    ContactNumbersOf<NumberGroup>* numbers;
    ContactFlagsOf<FlagGroup>* flags;
    ForceOnCorner* force;
    double* open_until;

    // Whether the contact neither touches nor can have closed.
    [[gnu::always_inline]] bool stays_open(std::size_t index) const {
        return open_until[index] >= 0 &&
               travelled[contact[index].block] + travelled[contact[index].other] <= open_until[index];
    }
    [[gnu::always_inline]] bool concerned(std::size_t index) const {
        return moved == nullptr || moved[contact[index].block] != 0 || moved[contact[index].other] != 0;
    }
};

ContactSweep sweep_of(const std::vector<Motion>& motion, const std::vector<double>& travelled, const char* moved,
                      double step, ContactList& list);

void evaluate_contact(const ContactSweep& sweep, std::size_t index);

// A loop over contacts from `begin` to `end`, for processors of one kind. All loops give the same bits, wherever ranges
// begin and end, provided that the contacts of a pair of blocks are in one range.
struct ContactLoop {
    std::string_view name;
    // Evaluates contacts of blocks that have moved, except those that stay open. Returns the number evaluated.
    std::size_t (*evaluate)(ContactSweep sweep, std::size_t begin, std::size_t end);
    // Evaluates contacts and also adds up all forces in the order of the list, so that data already read need not be
    // read again. `sum`: force on each block, zero at first.
    std::size_t (*evaluate_and_sum)(ContactSweep sweep, std::size_t begin, std::size_t end, BlockForce* sum);
};

// Loops that this processor can run, the fastest one first.
std::span<const ContactLoop> contact_loops();

}  // namespace delabole
