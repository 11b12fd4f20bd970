#include "dynamic_relaxation/contact_forces.hpp"

#include "dynamic_relaxation/by_block.hpp"
#include "dynamic_relaxation/contact_law.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

// The loop over contacts is compiled twice, for all processors and for those with wider registers, and the right one is
// taken at the start of the program. Both give the same bits: multiplications and additions are never contracted.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define DELABOLE_FOR_EACH_PROCESSOR __attribute__((target_clones("avx2", "default")))
#else
#define DELABOLE_FOR_EACH_PROCESSOR
#endif

namespace delabole {

ContactForces::ContactForces(const Bodies& bodies, std::vector<double> unnoticed, Team& team)
    : bodies_(bodies),
      team_(team),
      unnoticed_(std::move(unnoticed)),
      force_(bodies.size()),
      moved_(bodies.size(), 0),
      summed_(bodies.size(), 0) {}

// Not needed where all contacts are gone through in their order.
void ContactForces::index(const ContactList& list) {
    if (!std::exchange(list_is_new_, false)) {
        return;
    }
    const auto blocks_of = [](const RelaxationContact& contact) { return contact.pair(); };
    index_by_block(bodies_.size(), list.contact, blocks_of, begin_, of_block_);
    evaluated_.assign(list.contact.size(), round_ - 1);
    divide(list);
    sum_all(list);
}

// Contacts of one pair of blocks follow each other and read each other's memories when a corner hands over: they stay
// in one part.
void ContactForces::divide(const ContactList& list) {
    const auto same_pair = [&](std::size_t index) {
        const RelaxationContact& one = list.contact[index - 1];
        const RelaxationContact& two = list.contact[index];
        return std::minmax(one.block, one.other) == std::minmax(two.block, two.other);
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

void ContactForces::notice(const std::vector<Motion>& motion, std::vector<SeenPose>& seen) {
    moved_blocks_.clear();
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        const Motion& now = motion[block];
        SeenPose& then = seen[block];
        const double way = std::abs(now.x - then.x) + std::abs(now.y - then.y) +
                           std::abs(now.angle - then.angle) * bodies_.radius[block];
        // Not a number counts as moved.
        moved_[block] = way <= unnoticed_[block] ? 0 : 1;
        if (moved_[block] != 0) {
            then = {now.x, now.y, now.angle};
            moved_blocks_.push_back(static_cast<std::uint32_t>(block));
        }
    }
}

inline void ContactForces::add(const RelaxationContact& contact, const ForceOnCorner& force) {
    BlockForce& own = force_[contact.block];
    own.x += force.x;
    own.y += force.y;
    own.moment += force.moment;
    BlockForce& other = force_[contact.other];
    other.x -= force.x;
    other.y -= force.y;
    other.moment += force.other_moment;
}

[[gnu::always_inline]] inline ForceOnCorner ContactForces::evaluate(std::size_t index, const Round& round,
                                                                    ContactList& list) {
    const RelaxationContact& contact = list.contact[index];
    double open_by = 0;
    const ForceOnCorner force =
        advance_contact(list.law_of(contact), contact, list.memory[index], list.memory.data(),
                        round.motion[contact.block], round.motion[contact.other], round.step, open_by);
    // The corner may be farther from the other block's centroid than that block's own corners are, but not twice as
    // far.
    list.open_until[index] = open_by > 0 ? round.way[contact.block] + round.way[contact.other] + open_by / 2 : not_open;
    list.force[index] = force;
    return force;
}

DELABOLE_FOR_EACH_PROCESSOR
std::size_t ContactForces::evaluate_part(std::size_t begin, std::size_t end, const Round& round,
                                         ContactList& list) const {
    std::size_t count = 0;
    for (std::size_t index = begin; index < end; ++index) {
        if (!stays_open(index, round, list) && concerned(list.contact[index])) {
            evaluate(index, round, list);
            ++count;
        }
    }
    return count;
}

std::size_t ContactForces::evaluate_all(const Round& round, ContactList& list) {
    std::vector<std::size_t> counts(team_.size(), 0);
    team_.run(
        [&](std::size_t part) { counts[part] = evaluate_part(part_begin_[part], part_begin_[part + 1], round, list); });
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

// In one pass: what has been read need not be read again to add it up.
DELABOLE_FOR_EACH_PROCESSOR
std::size_t ContactForces::evaluate_and_sum(const Round& round, ContactList& list) {
    std::fill(force_.begin(), force_.end(), BlockForce{});
    std::size_t count = 0;
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const RelaxationContact& contact = list.contact[index];
        if (stays_open(index, round, list)) {
            continue;
        }
        if (concerned(contact)) {
            add(contact, evaluate(index, round, list));
            ++count;
        } else {
            add(contact, list.force[index]);
        }
    }
    return count;
}

std::size_t ContactForces::apply(const std::vector<Motion>& motion, const std::vector<double>& way, double step,
                                 std::vector<SeenPose>& seen, ContactList& list) {
    // From this share of the blocks on it costs less to go through all contacts in their order.
    constexpr std::size_t many = 8;
    ++round_;
    notice(motion, seen);
    const Round round{motion, way, step};
    std::size_t count = 0;
    if (many * moved_blocks_.size() > bodies_.size()) {
        if (team_.size() == 1) {
            return evaluate_and_sum(round, list);
        }
        index(list);
        count = evaluate_all(round, list);
        sum_all(list);
        return count;
    }
    index(list);
    for (const std::uint32_t block : moved_blocks_) {
        for (std::uint32_t entry = begin_[block]; entry < begin_[block + 1]; ++entry) {
            const std::uint32_t index = of_block_[entry];
            if (std::exchange(evaluated_[index], round_) != round_ && !stays_open(index, round, list)) {
                evaluate(index, round, list);
                ++count;
            }
        }
    }
    for (const std::uint32_t block : moved_blocks_) {
        sum_block(block, list);
        for (std::uint32_t entry = begin_[block]; entry < begin_[block + 1]; ++entry) {
            const RelaxationContact& contact = list.contact[of_block_[entry]];
            sum_block(contact.block == block ? contact.other : contact.block, list);
        }
    }
    return count;
}

void ContactForces::sum_all(const ContactList& list) {
    if (team_.size() > 1) {
        team_.run([&](std::size_t part) {
            for (std::size_t block = part_begin(bodies_.size(), part, team_.size());
                 block < part_begin(bodies_.size(), part + 1, team_.size()); ++block) {
                force_[block] = sum_of(block, list);
            }
        });
        return;
    }
    std::fill(force_.begin(), force_.end(), BlockForce{});
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        add(list.contact[index], list.force[index]);
    }
}

void ContactForces::sum_block(std::size_t block, const ContactList& list) {
    if (std::exchange(summed_[block], round_) != round_) {
        force_[block] = sum_of(block, list);
    }
}

BlockForce ContactForces::sum_of(std::size_t block, const ContactList& list) const {
    BlockForce sum;
    for (std::uint32_t entry = begin_[block]; entry < begin_[block + 1]; ++entry) {
        const RelaxationContact& contact = list.contact[of_block_[entry]];
        const ForceOnCorner& force = list.force[of_block_[entry]];
        if (contact.block == block) {
            sum.x += force.x;
            sum.y += force.y;
            sum.moment += force.moment;
        } else {
            sum.x -= force.x;
            sum.y -= force.y;
            sum.moment += force.other_moment;
        }
    }
    return sum;
}

}  // namespace delabole
