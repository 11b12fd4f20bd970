// Keeps the contacts of a run up to date with no more checks of pairs than motion makes necessary.
//
// Blocks that could soon touch are paired through the grid at intervals. The result of a check of a pair holds until
// its two blocks have moved against each other by a distance of the pair's own: its margin, within which every contact
// was found, or the distance between the blocks if that is more. Blocks that fall side by side, or a slope that a
// splinter flies off, are not checked again. Each block also has a distance up to which none of its pairs can be due,
// so that not even the pairs need a test at every step.
//
// The list has the contacts of find_contacts (contacts.hpp); the additional contacts of a pair depend on when it was
// last checked. Checks depend on motion alone, neither on threads nor on interruptions of the run.
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
    std::uint32_t begin;  // first of its contacts in the list; they end where those of the next pair begin
    // State at the last check:
    PairPose pose;
    double distance;  // m, as in PairContacts
    // m, motion of the blocks against each other up to which the contacts found then are complete; negative before the
    // first check.
    double holds;
};

struct WatchState {
    std::vector<WatchedPair> pair = {};  // in increasing order
    // For each block, m:
    std::vector<double> travelled = {};         // no point of the block has moved farther since the start
    std::vector<double> due = {};               // no pair of the block is due up to this distance
    std::vector<double> neighbours_until = {};  // up to this distance, all blocks that it can touch are paired with it
    std::vector<double> step_until = {};        // the stable step of the block stays valid up to this distance
    std::vector<double> stable_step = {};       // s, of the springs on the block alone
    double step = 0;                            // s, pairs are checked in time for steps up to this length
    std::uint64_t searches = 0;                 // number of searches for pairs
    std::uint64_t pair_checks = 0;              // number of checks of pairs for contacts
};

struct MovingScene {
    const std::vector<Motion>& motion;
    const std::vector<char>& removed;
};

class ContactWatch {
  public:
    ContactWatch(const RelaxationScene& scene, const Bodies& bodies, const RelaxationSettings& settings);

    // Marks every pair for checking, as before the first step.
    static void start(std::size_t blocks, WatchState& state);
    // Before a longer step, marks all pairs for a test, and asks for a new search if the step takes a block beyond its
    // known neighbours.
    void prepare_for(double step, const std::vector<Motion>& motion, WatchState& state) const;
    // Computes again what the state does not hold.
    void resume(const WatchState& state, const ContactList& list);

    // Updates the list and the stable steps. Returns whether any block was due.
    bool update(const MovingScene& scene, const Bonds& bonds, const std::vector<BondMemory>& bond_memory,
                WatchState& state, ContactList& list);

    // Results of the last update:
    struct Dropped {
        RelaxationContact contact;
        ContactMemory memory;
    };
    const std::vector<Dropped>& dropped() const { return dropped_; }
    bool list_changed() const { return list_changed_; }
    // Blocks with a contact that was added, removed or given another law, in increasing order.
    const std::vector<std::uint32_t>& changed_blocks() const { return changed_blocks_; }
    double worst_overlap() const { return worst_overlap_; }  // of the pairs checked, in shortest edges

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

    // Used within one update:
    PairContacts now_ = {};    // contacts of the pair being checked
    PairContacts found_ = {};  // contacts of all pairs whose contacts have changed
    std::vector<Replacement> replacement_ = {};
    std::vector<Dropped> dropped_ = {};
    std::vector<std::uint32_t> due_blocks_ = {};
    std::span<const ShiftedPair> shifted_ = {};
    std::vector<std::uint32_t> changed_blocks_ = {};
    bool list_changed_ = false;
    double worst_overlap_ = 0;
};

}  // namespace delabole
