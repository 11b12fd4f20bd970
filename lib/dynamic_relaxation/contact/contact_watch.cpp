#include "dynamic_relaxation/contact/contact_watch.hpp"

#include "dynamic_relaxation/blocks/neighbours.hpp"
#include "dynamic_relaxation/contact/by_block.hpp"
#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/time_step.hpp"
#include "numerics/constants.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace delabole {

namespace {

// Contacts are found within this distance, in shortest edges of the scene or, if that is more, of the two blocks.
constexpr double margin_in_edges_of_scene = 0.01;
constexpr double margin_in_edges = 0.0002;
// Where blocks move fast the distance is larger, so that a contact is found at least this many steps before it closes.
constexpr double steps_ahead = 8;
// rad; the corners found to bear on an edge stay valid up to this rotation of the blocks against each other, because
// the search allows for a lean of 20 deg.
constexpr double turn_of_same_corners = 0.1;
// Neighbours are searched for within this fraction of the block's radius or of the median radius, whichever is less, or
// within the distance that the block moves in this number of steps, if that is more.
constexpr double reach_in_radii = 0.25;
constexpr double steps_between_searches = 64;
// A spring that begins or ends to act between two steps does so a fraction of a step late or early. Measured losses of
// an impact's energy: up to 5 % at 0.6 of the stable step, 3 % at 0.4 and less than 2 % at 0.3.
constexpr double step_fraction_in_collision = 0.3;
// Impacts count from the speed of a free fall through this fraction of the block's radius. Slower ones convert little
// energy compared with what friction dissipates in a moving slope, and short steps for them would double the time of a
// run.
constexpr double fall_in_radii = 0.02;
// A block that has moved by this fraction of its radius rests on other places of its neighbours, and its stable step
// has changed.
constexpr double distance_of_same_step = 0.01;

double least_of(const std::vector<double>& numbers) {
    return *std::min_element(numbers.begin(), numbers.end());
}

// Speed at which the corner leaves the edge, m/s, along the normal of the edge.
double opening_of(const RelaxationContact& contact, const std::vector<Motion>& motion) {
    const Motion& block = motion[contact.block];
    const Motion& other = motion[contact.other];
    return velocity_of<double>(locate(contact, block, other), block, other).opening;
}

}  // namespace

ContactWatch::ContactWatch(const RelaxationScene& scene, const Bodies& bodies, const RelaxationSettings& settings)
    : bodies_(bodies),
      pair_search_(scene, bodies, settings.viscous_damping),
      least_margin_(margin_in_edges_of_scene *
                    *std::min_element(bodies.shortest_edge.begin(), bodies.shortest_edge.end())),
      gravity_(scene.gravity.acceleration),
      overlap_limit_(settings.overlap_limit),
      share_in_collision_(std::min(1.0, step_fraction_in_collision / settings.step_fraction)) {
    const double median = median_of_free(bodies, bodies.radius).value_or(infinity);
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        reach_at_rest_.push_back(bodies.fixed[block] != 0 ? 0
                                                          : reach_in_radii * std::min(bodies.radius[block], median));
    }
}

void ContactWatch::start(std::size_t blocks, WatchState& state) {
    state.travelled.assign(blocks, 0);
    state.due.assign(blocks, -infinity);
    state.neighbours_until.assign(blocks, -infinity);
    state.step_until.assign(blocks, -infinity);
    state.stable_step.assign(blocks, infinity);
}

void ContactWatch::prepare_for(double step, const std::vector<Motion>& motion, WatchState& state) const {
    state.step = step;
    std::fill(state.due.begin(), state.due.end(), -infinity);
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        const double speed = fastest_point<double>(motion[block], bodies_.radius[block]);
        if (state.neighbours_until[block] - state.travelled[block] < steps_ahead * speed * step) {
            state.neighbours_until[block] = -infinity;
        }
    }
}

void ContactWatch::resume(const WatchState& state, const ContactList& list) {
    laws_.resume(list);
    stable_step_ = least_of(state.stable_step);
    index_pairs(state);
}

bool ContactWatch::update(const MovingScene& scene, const Bonds& bonds, const std::vector<BondMemory>& bond_memory,
                          WatchState& state, ContactList& list) {
    list_due_blocks(state);
    // In most steps no block is due.
    if (due_blocks_.empty()) {
        return false;
    }
    dropped_.clear();
    changed_blocks_.clear();
    shifted_ = bonds.shifted();
    worst_overlap_ = 0;
    const bool new_neighbours = std::any_of(due_blocks_.begin(), due_blocks_.end(), [&](std::uint32_t block) {
        return state.travelled[block] > state.neighbours_until[block];
    });
    first_ = list_changed_ = state.searches == 0;
    if (new_neighbours) {
        // The search restarts the measured motion of all blocks, so that every block needs a new distance at the end.
        due_blocks_.resize(bodies_.size());
        std::iota(due_blocks_.begin(), due_blocks_.end(), 0U);
        search(scene, bonds.joined(bond_memory), state, list);
        for (std::size_t number = 0; number < state.pair.size(); ++number) {
            visit(number, scene, state, list);
        }
    } else {
        for (const std::uint32_t block : due_blocks_) {
            state.due[block] = infinity;
        }
        for (const std::uint32_t block : due_blocks_) {
            for (std::uint32_t entry = begin_[block]; entry < begin_[block + 1]; ++entry) {
                visit(of_block_[entry], scene, state, list);
            }
        }
    }
    if (!replacement_.empty()) {
        assemble(state, list);
    }
    std::sort(changed_blocks_.begin(), changed_blocks_.end());
    changed_blocks_.erase(std::unique(changed_blocks_.begin(), changed_blocks_.end()), changed_blocks_.end());
    renew_stable_steps(scene, bonds, bond_memory, state, list);
    return true;
}

void ContactWatch::list_due_blocks(const WatchState& state) {
    // Few blocks are due: the loop first tests so many at a time for any that is.
    constexpr std::size_t together = 64;
    due_blocks_.clear();
    for (std::size_t begin = 0; begin < bodies_.size(); begin += together) {
        const std::size_t end = std::min(begin + together, bodies_.size());
        unsigned any = 0;
        for (std::size_t block = begin; block < end; ++block) {
            any |= state.travelled[block] > state.due[block] ? 1U : 0U;
        }
        for (std::size_t block = begin; any != 0 && block < end; ++block) {
            if (state.travelled[block] > state.due[block]) {
                due_blocks_.push_back(static_cast<std::uint32_t>(block));
            }
        }
    }
}

double ContactWatch::margin_of(const WatchedPair& pair, const MovingScene& scene, double step) const {
    const Motion& first = scene.motion[pair.first];
    const Motion& second = scene.motion[pair.second];
    const double closing = std::abs(first.vx - second.vx) + std::abs(first.vy - second.vy) +
                           std::abs(first.spin) * bodies_.radius[pair.first] +
                           std::abs(second.spin) * bodies_.radius[pair.second];
    const double shortest = std::min(bodies_.shortest_edge[pair.first], bodies_.shortest_edge[pair.second]);
    const double time = steps_ahead * step;
    return std::max({least_margin_, margin_in_edges * shortest, (closing + gravity_ * time / 2) * time});
}

double ContactWatch::used_up(const WatchedPair& pair, const std::vector<Motion>& motion) const {
    const Motion& first = motion[pair.first];
    const Motion& second = motion[pair.second];
    const PairPose& then = pair.pose;
    return std::abs(first.x - second.x - then.x) + std::abs(first.y - second.y - then.y) +
           std::abs(first.angle - then.first_angle) * bodies_.radius[pair.first] +
           std::abs(second.angle - then.second_angle) * bodies_.radius[pair.second];
}

double ContactWatch::turned_since(const WatchedPair& pair, const std::vector<Motion>& motion) {
    return std::abs(motion[pair.first].angle - pair.pose.first_angle) +
           std::abs(motion[pair.second].angle - pair.pose.second_angle);
}

ContactRange ContactWatch::contacts_of(std::size_t number, const WatchState& state, const ContactList& list) {
    return {state.pair[number].begin,
            number + 1 < state.pair.size() ? state.pair[number + 1].begin : list.contact.size()};
}

void ContactWatch::visit(std::size_t number, const MovingScene& scene, WatchState& state, const ContactList& list) {
    WatchedPair& pair = state.pair[number];
    const double margin = margin_of(pair, scene, state.step);
    double left = pair.holds - used_up(pair, scene.motion);
    // rad; without contacts the distance stays valid however the blocks rotate.
    double turn_left = contacts_of(number, state, list).size() == 0
                           ? infinity
                           : turn_of_same_corners - turned_since(pair, scene.motion);
    // Motion left until the blocks may overlap more than the limit allows.
    const double too_deep =
        overlap_limit_ * std::min(bodies_.shortest_edge[pair.first], bodies_.shortest_edge[pair.second]);
    double deep_left = pair.distance + too_deep - (pair.holds - left);
    // A value that is not a number counts as used up.
    if (!(left >= std::max(pair.holds, margin) / 2) || !(turn_left >= turn_of_same_corners / 2) || !(deep_left >= 0)) {
        check_pair(number, margin, scene, state, list);
        left = pair.holds;
        turn_left = now_.contact.empty() ? infinity : turn_of_same_corners;
        deep_left = pair.distance + too_deep;
    }
    // The pair is visited again well before the allowed motion is used up. A fixed block gets no share of it.
    const double spare = left - std::max(pair.holds, margin) / 4;
    const double spare_turn = turn_left - turn_of_same_corners / 4;
    const bool both = bodies_.fixed[pair.first] == 0 && bodies_.fixed[pair.second] == 0;
    const auto give = [&](std::uint32_t block) {
        const double whole = std::min({spare, spare_turn * bodies_.radius[block], deep_left});
        const double share = both ? whole / 2 : bodies_.fixed[block] == 0 ? whole : 0;
        state.due[block] = std::min(state.due[block], state.travelled[block] + share);
    };
    give(pair.first);
    give(pair.second);
}

void ContactWatch::check_pair(std::size_t number, double margin, const MovingScene& scene, WatchState& state,
                              const ContactList& list) {
    WatchedPair& pair = state.pair[number];
    const ContactRange before = contacts_of(number, state, list);
    const BlockPair blocks(pair.first, pair.second);
    pair_search_.find(blocks, scene.motion, {margin, first_, shift_of(blocks, shifted_)}, list, before,
                      pair.holds >= 0 ? std::optional(pair.pose) : std::nullopt, now_);
    ++state.pair_checks;
    const Motion& first = scene.motion[pair.first];
    const Motion& second = scene.motion[pair.second];
    pair.pose = {first.x - second.x, first.y - second.y, first.angle, second.angle};
    pair.distance = now_.distance;
    pair.holds = std::max(margin, now_.distance);
    worst_overlap_ = std::max(worst_overlap_, now_.worst_overlap);
    if (is_as_before(before, list)) {
        return;
    }
    const std::size_t begin = found_.contact.size();
    found_.contact.insert(found_.contact.end(), now_.contact.begin(), now_.contact.end());
    found_.law.insert(found_.law.end(), now_.law.begin(), now_.law.end());
    found_.memory.insert(found_.memory.end(), now_.memory.begin(), now_.memory.end());
    replacement_.push_back({number, {begin, found_.contact.size()}});
    changed_blocks_.push_back(pair.first);
    changed_blocks_.push_back(pair.second);
}

bool ContactWatch::is_as_before(const ContactRange& before, const ContactList& list) const {
    if (now_.contact.size() != before.size()) {
        return false;
    }
    for (std::size_t index = 0; index < before.size(); ++index) {
        const RelaxationContact then = list.contact[before.begin + index];
        const RelaxationContact& now = now_.contact[index];
        const bool same_twin = now.twin == no_twin ? then.twin == no_twin : then.twin == before.begin + now.twin;
        if (now.corner != then.corner || now.edge != then.edge || !same_twin ||
            !(now_.law[index] == list.law_of(then))) {
            return false;
        }
    }
    return true;
}

// Pairs that have come apart lose their contacts; new pairs have yet to be checked.
void ContactWatch::search(const MovingScene& scene, const std::vector<BlockPair>& bonded, WatchState& state,
                          ContactList& list) {
    std::vector<double> reach = reach_at_rest_;
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        const double speed = fastest_point<double>(scene.motion[block], bodies_.radius[block]);
        reach[block] = std::max(reach[block], steps_between_searches * speed * state.step);
        // The other half is left for the margins.
        state.neighbours_until[block] = state.travelled[block] + reach[block] / 2;
        state.due[block] = infinity;
    }
    // Not before, so that the blocks are due as if their outlines were not shifted.
    reach_as_shifted(bodies_, shifted_, reach);
    const auto drop = [&](std::size_t begin, std::size_t end) {
        for (std::size_t index = begin; index < end; ++index) {
            const RelaxationContact contact = list.contact[index];
            dropped_.push_back({contact, list.memory[index]});
            changed_blocks_.push_back(contact.block);
            changed_blocks_.push_back(contact.other);
        }
    };
    const std::vector<WatchedPair> pairs_then = std::exchange(state.pair, {});
    ContactList kept = list_like(list);
    auto then = pairs_then.begin();
    ContactRange range{0, 0};
    for (const BlockPair& pair : neighbouring_blocks(bodies_, scene.motion, scene.removed, reach)) {
        if (std::binary_search(bonded.begin(), bonded.end(), pair)) {
            continue;
        }
        const std::size_t done = range.end;
        range = next_of_pair(list, done, pair);
        drop(done, range.begin);
        then = std::find_if(then, pairs_then.end(),
                            [&](const WatchedPair& one) { return BlockPair(one.first, one.second) >= pair; });
        const bool known = then != pairs_then.end() && BlockPair(then->first, then->second) == pair;
        state.pair.push_back(known ? *then : WatchedPair{pair.first, pair.second, 0, {}, 0, -infinity});
        state.pair.back().begin = static_cast<std::uint32_t>(kept.contact.size());
        append(list, range, kept);
    }
    drop(range.end, list.contact.size());
    list_changed_ = list_changed_ || !dropped_.empty();
    // Laws that no contact uses any more are removed.
    laws_.clear();
    for (ContactBlocks& contact : kept.contact.blocks()) {
        laws_.name(list.law_of(contact), kept, contact);
    }
    list = std::move(kept);
    index_pairs(state);
    ++state.searches;
}

void ContactWatch::assemble(WatchState& state, ContactList& list) {
    // A pair of blocks that overlap too much, or whose motion is not a number, was checked once from each of the two.
    std::ranges::stable_sort(replacement_, {}, &Replacement::pair);
    const auto of_one_pair = [](const Replacement& one, const Replacement& two) { return one.pair == two.pair; };
    replacement_.erase(std::unique(replacement_.begin(), replacement_.end(), of_one_pair), replacement_.end());
    ContactList renewed = list_like(list);
    renewed.ends = std::move(list.ends);
    renewed.joint = std::move(list.joint);
    // Contacts between the replaced pairs are copied in one piece.
    std::size_t taken = 0;
    std::uint32_t shift = 0;  // modulo 2^32
    std::size_t number = 0;
    const auto shift_pairs_up_to = [&](std::size_t last) {
        for (; number < last; ++number) {
            state.pair[number].begin += shift;
        }
    };
    for (const Replacement& by : replacement_) {
        const ContactRange range = contacts_of(by.pair, state, list);
        append(list, {taken, range.begin}, renewed);
        taken = range.end;
        shift_pairs_up_to(by.pair + 1);
        replace(by, range, list, renewed);
        shift = static_cast<std::uint32_t>(renewed.contact.size()) - static_cast<std::uint32_t>(taken);
    }
    append(list, {taken, list.contact.size()}, renewed);
    shift_pairs_up_to(state.pair.size());
    list = std::move(renewed);
    list_changed_ = true;
    replacement_.clear();
    found_.clear();
}

void ContactWatch::replace(const Replacement& by, const ContactRange& range, const ContactList& list,
                           ContactList& renewed) {
    const std::span<const RelaxationContact> now = part_of(found_.contact, by.found);
    for (std::size_t index = range.begin; index < range.end; ++index) {
        const RelaxationContact then = list.contact[index];
        if (std::none_of(now.begin(), now.end(), [&](const RelaxationContact& one) {
                return one.corner == then.corner && one.edge == then.edge;
            })) {
            dropped_.push_back({then, list.memory[index]});
        }
    }
    append(found_, by.found, laws_, renewed);
}

void ContactWatch::renew_stable_steps(const MovingScene& scene, const Bonds& bonds,
                                      const std::vector<BondMemory>& bond_memory, WatchState& state,
                                      const ContactList& list) {
    bool least_has_gone = false;
    const auto renew = [&](std::uint32_t block) {
        SpringsOnBlock springs(bodies_, block);
        double fastest = 0;  // m/s, greatest speed of a corner to or from its edge
        for (std::uint32_t entry = begin_[block]; entry < begin_[block + 1]; ++entry) {
            const ContactRange range = contacts_of(of_block_[entry], state, list);
            for (std::size_t index = range.begin; index < range.end; ++index) {
                const RelaxationContact contact = list.contact[index];
                springs.add(contact, list.law_of(contact), scene.motion);
                fastest = std::max(fastest, std::abs(opening_of(contact, scene.motion)));
            }
        }
        for (const std::uint32_t bond : bonds.of_block(block)) {
            if (bond_memory[bond].state == BondState::whole) {
                springs.add(bonds.list()[bond], scene.motion);
            }
        }
        least_has_gone |= state.stable_step[block] <= stable_step_;
        const double step = springs.stable_step();
        const bool collides = fastest * fastest > 2 * gravity_ * fall_in_radii * bodies_.radius[block];
        state.stable_step[block] = collides ? share_in_collision_ * step : step;
        stable_step_ = std::min(stable_step_, state.stable_step[block]);
        state.step_until[block] = state.travelled[block] + distance_of_same_step * bodies_.radius[block];
    };
    std::for_each(changed_blocks_.begin(), changed_blocks_.end(), renew);
    for (const std::uint32_t block : due_blocks_) {
        if (state.travelled[block] > state.step_until[block]) {
            renew(block);
        }
    }
    if (least_has_gone) {
        stable_step_ = least_of(state.stable_step);
    }
    assert(stable_step_ == least_of(state.stable_step));
    // For all other blocks `due` is already no more than these limits, which have not decreased.
    for (const std::uint32_t block : due_blocks_) {
        state.due[block] = std::min({state.due[block], state.neighbours_until[block], state.step_until[block]});
    }
}

void ContactWatch::index_pairs(const WatchState& state) {
    const auto blocks_of = [](const WatchedPair& pair) { return BlockPair(pair.first, pair.second); };
    index_by_block(bodies_.size(), state.pair, blocks_of, begin_, of_block_);
}

}  // namespace delabole
