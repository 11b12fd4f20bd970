// The sum of all contact forces on each block, updated only where blocks have moved since the last step.
//
// A touching contact is evaluated again once one of its blocks has moved far enough to change a spring's force by 1e-12
// of the block's weight, or has new contacts (NoticedMotion). Nothing is put to sleep, and forces are never older than
// that. An open contact is evaluated again once its blocks have moved far enough to close it.
#pragma once

#include "dynamic_relaxation/blocks/bodies.hpp"
#include "dynamic_relaxation/contact/contact_sweep.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"
#include "dynamic_relaxation/wide/team.hpp"

#include <cstdint>
#include <vector>

namespace delabole {

class ContactForces {
  public:
    ContactForces(const Bodies& bodies, Team& team);

    // Must be called whenever the list of contacts is new.
    void renew() { list_is_new_ = true; }

    // Evaluates contacts of blocks that have moved and adds up the forces. `travelled`: distance that no point of the
    // block has exceeded since the start. `moved`: as from NoticedMotion. Returns the number of contacts evaluated. The
    // result is the same to the bit however the work is divided, because the forces on a block are added in the order
    // of the list.
    std::size_t apply(const std::vector<Motion>& motion, const std::vector<double>& travelled,
                      const std::vector<char>& moved, double step, ContactList& list);

    const std::vector<BlockForce>& on_blocks() const { return force_; }

  private:
    // The sweep's `moved` is null if all blocks have moved.
    std::size_t evaluate_and_sum_of_moved(const std::vector<char>& moved, const ContactSweep& sweep,
                                          const ContactList& list);
    std::size_t evaluate_all(const ContactSweep& sweep);
    void sum_all(const ContactList& list);
    void sum_block(std::size_t block, const ContactList& list);
    BlockForce sum_of(std::size_t block, const ContactList& list) const;
    void divide(const ContactList& list);
    void index(const ContactList& list);

    const Bodies& bodies_;
    Team& team_;
    ContactLoop loop_;  // the fastest one that this processor runs
    std::vector<BlockForce> force_;
    std::vector<std::uint32_t> moved_blocks_ = {};
    // Contacts of each block in the order of the list: begin_[block] to begin_[block + 1] in of_block_.
    std::vector<std::uint32_t> begin_ = {};
    std::vector<std::uint32_t> of_block_ = {};
    std::vector<std::size_t> part_begin_ = {};   // contacts of each member; twins stay together
    std::vector<std::uint64_t> evaluated_ = {};  // round in which a contact was last evaluated
    std::vector<std::uint64_t> summed_ = {};     // round in which a block's forces were last added up
    std::uint64_t round_ = 0;
    bool list_is_new_ = true;
};

}  // namespace delabole
