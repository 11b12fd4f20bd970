#include "dynamic_relaxation/contact/contact_forces.hpp"

#include "dynamic_relaxation/contact/by_block.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace delabole {

ContactForces::ContactForces(const Bodies& bodies, Team& team)
    : bodies_(bodies), team_(team), loop_(contact_loops().front()), force_(bodies.size()), summed_(bodies.size(), 0) {}

// The index is not needed where all contacts are evaluated in their order.
void ContactForces::index(const ContactList& list) {
    if (!std::exchange(list_is_new_, false)) {
        return;
    }
    const auto blocks_of = [](const ContactBlocks& contact) { return contact.pair(); };
    index_by_block(bodies_.size(), list.contact.blocks(), blocks_of, begin_, of_block_);
    evaluated_.assign(list.contact.size(), round_ - 1);
    divide(list);
    sum_all(list);
}

// Contacts of one pair of blocks are consecutive and read each other's memories when a corner hands over: they stay in
// one part.
void ContactForces::divide(const ContactList& list) {
    const auto same_pair = [&](std::size_t index) {
        return list.contact.blocks()[index - 1].pair() == list.contact.blocks()[index].pair();
    };
    part_begin_.assign(team_.size() + 1, list.contact.size());
    for (std::size_t part = 0; part < team_.size(); ++part) {
        std::size_t begin = part_begin(list.contact.size(), part, team_.size());
        while (begin > 0 && begin < list.contact.size() && same_pair(begin)) {
            ++begin;
        }
        part_begin_[part] = begin;
    }
}

std::size_t ContactForces::evaluate_all(const ContactSweep& sweep) {
    std::vector<std::size_t> counts(team_.size(), 0);
    team_.run(
        [&](std::size_t part) { counts[part] = loop_.evaluate(sweep, part_begin_[part], part_begin_[part + 1]); });
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

std::size_t ContactForces::apply(const std::vector<Motion>& motion, const std::vector<double>& travelled,
                                 const std::vector<char>& moved, double step, ContactList& list) {
    // If at least one block in so many is awake, it costs less to evaluate all contacts in their order.
    constexpr std::size_t many = 8;
    ++round_;
    std::size_t moved_count = 0;
    unsigned any_still = 0;
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        moved_count += moved[block] != 0 ? 1 : 0;
        any_still |= moved[block] == 0 && bodies_.fixed[block] == 0 ? 1U : 0U;
    }
    const ContactSweep sweep = sweep_of(motion, travelled, any_still != 0 ? moved.data() : nullptr, step, list);
    if (many * moved_count <= bodies_.size()) {
        index(list);
        return evaluate_and_sum_of_moved(moved, sweep, list);
    }
    if (team_.size() == 1) {
        std::fill(force_.begin(), force_.end(), BlockForce{});
        return loop_.evaluate_and_sum(sweep, 0, list.contact.size(), force_.data());
    }
    index(list);
    const std::size_t evaluated = evaluate_all(sweep);
    sum_all(list);
    return evaluated;
}

std::size_t ContactForces::evaluate_and_sum_of_moved(const std::vector<char>& moved, const ContactSweep& sweep,
                                                     const ContactList& list) {
    moved_blocks_.clear();
    for (std::uint32_t block = 0; block < bodies_.size(); ++block) {
        if (moved[block] != 0) {
            moved_blocks_.push_back(block);
        }
    }
    std::size_t count = 0;
    for (const std::uint32_t block : moved_blocks_) {
        for (std::uint32_t entry = begin_[block]; entry < begin_[block + 1]; ++entry) {
            const std::uint32_t index = of_block_[entry];
            if (std::exchange(evaluated_[index], round_) != round_ && !sweep.stays_open(index)) {
                evaluate_contact(sweep, index);
                ++count;
            }
        }
    }
    for (const std::uint32_t block : moved_blocks_) {
        sum_block(block, list);
        for (std::uint32_t entry = begin_[block]; entry < begin_[block + 1]; ++entry) {
            const ContactBlocks& contact = list.contact.blocks()[of_block_[entry]];
            sum_block(contact.block == block ? contact.other : contact.block, list);
        }
    }
    return count;
}

void ContactForces::sum_all(const ContactList& list) {
    team_.run([&](std::size_t part) {
        for (std::size_t block = part_begin(bodies_.size(), part, team_.size());
             block < part_begin(bodies_.size(), part + 1, team_.size()); ++block) {
            force_[block] = sum_of(block, list);
        }
    });
}

void ContactForces::sum_block(std::size_t block, const ContactList& list) {
    if (std::exchange(summed_[block], round_) != round_) {
        force_[block] = sum_of(block, list);
    }
}

BlockForce ContactForces::sum_of(std::size_t block, const ContactList& list) const {
    BlockForce sum;
    for (std::uint32_t entry = begin_[block]; entry < begin_[block + 1]; ++entry) {
        const ContactBlocks& contact = list.contact.blocks()[of_block_[entry]];
        const ForceOnCorner& force = list.force[of_block_[entry]];
        sum += contact.block == block ? force.on_block() : force.on_other();
    }
    return sum;
}

}  // namespace delabole
