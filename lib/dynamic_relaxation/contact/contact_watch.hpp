// Keeps the contacts of a run up to date with no more checks of pairs than motion makes necessary.
//
// Blocks that could touch soon are paired through the grid once in a while. Each pair was checked once, and what was
// found holds until its two blocks have moved against each other by a distance of the pair's own: its margin, within
// which every contact was found, or the distance between the blocks if that is more. Blocks that fall side by side, and
// the slope that a splinter flies off, are not checked again. So that not even pairs need be asked at every step,
// each block has a distance of its own up to which none of its pairs can be due.
//
// The list has the contacts of find_contacts (contacts.hpp), but those that a pair has on top depend on when it was
// last checked. Checks depend on motion alone: neither on threads nor on when a run was interrupted.
#pragma once

#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/contact/contact_laws.hpp"
#include "dynamic_relaxation/contact/contact_list.hpp"
#include "dynamic_relaxation/contact/contacts.hpp"
#include "dynamic_relaxation/contact/pair_search.hpp"
#include "dynamic_relaxation/scene/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace delabole {

struct WatchedPair {
    std::uint32_t first;
    std::uint32_t second;
    std::uint32_t begin;  // of its contacts in the list, which go up to those of the next pair
    // When last checked:
    PairPose pose;
    double distance;  // m, as in PairContacts
    // m, motion of the blocks against each other up to which the contacts then found are all; negative before the first
    // check.
    double holds;
};

struct WatchState {
    std::vector<WatchedPair> pair = {};  // in increasing order
    // For each block, m:
    std::vector<double> travelled = {};         // no point of it has moved farther since the start
    std::vector<double> due = {};               // no pair of it is due up to this distance
    std::vector<double> neighbours_until = {};  // up to this distance, all that it can touch are pairs
    std::vector<double> step_until = {};        // the stable step of the block is good enough up to this distance
    std::vector<double> stable_step = {};       // s, of the block's springs alone
    double step = 0;                            // s, pairs are checked in time for steps up to this
    std::uint64_t searches = 0;                 // for pairs
    std::uint64_t pair_checks = 0;              // at pairs, for contacts
};

struct MovingScene {
    const std::vector<Motion>& motion;
    const std::vector<char>& removed;
};

class ContactWatch {
  public:
    ContactWatch(const RelaxationScene& scene, const Bodies& bodies, const RelaxationSettings& settings);

    // Everything is to be checked, as before the first step.
    static void start(std::size_t blocks, WatchState& state);
    // For a longer step, all pairs have to be asked, and blocks that it takes past what they can touch searched for.
    void prepare_for(double step, const std::vector<Motion>& motion, WatchState& state) const;
    // Finds again what is not in the state.
    void resume(const WatchState& state, const ContactList& list);

    // Brings the list up to date, and the stable steps. Returns whether any block was due.
    bool update(const MovingScene& scene, const Bonds& bonds, const std::vector<BondMemory>& bond_memory,
                WatchState& state, ContactList& list);

    // Results of the last update:
    struct Dropped {
        RelaxationContact contact;
        ContactMemory memory;
    };
    const std::vector<Dropped>& dropped() const { return dropped_; }
    bool list_changed() const { return list_changed_; }
    // Blocks with a contact that has come, gone or changed its law, in increasing order.
    const std::vector<std::uint32_t>& changed_blocks() const { return changed_blocks_; }
    double worst_overlap() const { return worst_overlap_; }  // of the pairs looked at, in shortest edges

    double stable_step() const { return stable_step_; }  // s, of all blocks

  private:
    // New contacts of a pair.
    struct Replacement {
        std::size_t pair;
        ContactRange found;
    };

    void list_due_blocks(const WatchState& state);
    double margin_of(const WatchedPair& pair, const MovingScene& scene, double step) const;
    double used_up(const WatchedPair& pair, const std::vector<Motion>& motion) const;
    static double turned_since(const WatchedPair& pair, const std::vector<Motion>& motion);
    void search(const MovingScene& scene, const std::vector<BlockPair>& bonded, WatchState& state, ContactList& list);
    void visit(std::size_t number, const MovingScene& scene, WatchState& state, const ContactList& list);
    void check_pair(std::size_t number, double margin, const MovingScene& scene, WatchState& state,
                    const ContactList& list);
    bool is_as_before(const ContactRange& before, const ContactList& list) const;
    void assemble(WatchState& state, ContactList& list);
    void replace(const Replacement& by, const ContactRange& range, const ContactList& list, ContactList& renewed);
    void renew_stable_steps(const MovingScene& scene, const Bonds& bonds, const std::vector<BondMemory>& bond_memory,
                            WatchState& state, const ContactList& list);
    static ContactRange contacts_of(std::size_t number, const WatchState& state, const ContactList& list);
    void index_pairs(const WatchState& state);

    const Bodies& bodies_;
    PairSearch pair_search_;
    double least_margin_;
    double gravity_;
    double overlap_limit_;
    double share_in_collision_;               // of the stable step
    std::vector<double> reach_at_rest_ = {};  // of each block
    ContactLaws laws_ = {};
    // Pairs of each block: begin_[block] to begin_[block + 1] in of_block_.
    std::vector<std::uint32_t> begin_ = {};
    std::vector<std::uint32_t> of_block_ = {};
    bool first_ = false;
    double stable_step_ = std::numeric_limits<double>::infinity();  // s, the least of all blocks

    // Used by one update:
    PairContacts now_ = {};    // of the pair looked at
    PairContacts found_ = {};  // of all whose contacts have changed
    std::vector<Replacement> replacement_ = {};
    std::vector<Dropped> dropped_ = {};
    std::vector<std::uint32_t> due_blocks_ = {};
    std::span<const ShiftedPair> shifted_ = {};
    std::vector<std::uint32_t> changed_blocks_ = {};
    bool list_changed_ = false;
    double worst_overlap_ = 0;
};

}  // namespace delabole
