// The static start of a run, runs that begin from a state at rest, and blocks that are absent at the start.
#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/contact_transition.hpp"
#include "dynamic_relaxation/statics/static_solver.hpp"
#include "dynamic_relaxation/step/bolt_forces.hpp"
#include "dynamic_relaxation/step/loads.hpp"
#include "dynamic_relaxation/step/simulation.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace delabole {

namespace {

// Earlier dissipation and slip belong to the run before.
ContactMemory with_no_energy_yet(ContactMemory memory) {
    memory.damping = memory.friction = memory.slip = 0;
    memory.normal_drag = memory.shear_drag = 0;
    memory.tried = false;
    return memory;
}

BondMemory with_no_energy_yet(BondMemory memory) {
    memory.damping = 0;
    memory.normal_drag = memory.shear_drag = memory.bending_drag = 0;
    return memory;
}

// Joints lose their peak strength where they are open at rest, as they do in motion.
void lose_strength_where_open(const Bodies& bodies, const std::vector<Motion>& motion, ContactList& list) {
    constexpr double as_balanced = 1e-7;  // of the shortest edge: static solves leave closed joints open by less
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        auto [contact, law, memory, at] = contact_now(list, index, motion);
        if (memory.touching || memory.beneath || memory.broken || !has_peak(law)) {
            continue;
        }
        const double shortest = std::min(bodies.shortest_edge[contact.block], bodies.shortest_edge[contact.other]);
        memory.broken = at.gap > as_balanced * shortest;
        list.memory.set(index, memory);
    }
}

}  // namespace

RelaxationState Simulation::begun_at(const RelaxationState& at_rest) {
    RelaxationState state;
    const std::size_t blocks = at_rest.motion.size();
    state.time = at_rest.time;
    state.motion = at_rest.motion;
    for (Motion& motion : state.motion) {
        motion.vx = motion.vy = motion.spin = 0;
    }
    state.removed = at_rest.removed;
    state.base_slip.resize(blocks, 0);
    state.dropped_slip.resize(blocks);
    state.checks_at_rest.resize(blocks, 0);
    state.noticed.resize(blocks);
    state.contacts = at_rest.contacts;
    for (std::size_t index = 0; index < state.contacts.memory.size(); ++index) {
        state.contacts.memory.set(index, with_no_energy_yet(state.contacts.memory[index]));
    }
    for (const BondMemory& bond : at_rest.bond) {
        state.bond.push_back(with_no_energy_yet(bond));
    }
    state.bolt = at_rest.bolt;
    ContactWatch::start(blocks, state.watch);
    // Contacts that form from now on do not belong to the initial geometry.
    state.watch.searches = 1;
    return state;
}

void Simulation::take_away_what_is_not_there() {
    for (const Removal& removal : scene_.removal) {
        if (removal.time >= 0) {
            continue;
        }
        state_.removed[removal.block] = taken_away;
        for (std::size_t index = 0; index < state_.bond.size(); ++index) {
            const SharedFace& face = bonds_.list()[index].face;
            if (face.block == removal.block || face.other == removal.block) {
                state_.bond[index].state = BondState::block_removed;
            }
        }
    }
}

StaticSolveSettings Simulation::static_solve_settings() const {
    StaticSolveSettings limits{};
    limits.tolerance = settings_.equilibrium_ratio / 10;
    limits.finest = rest_ratio() / 1000;
    // Blocks that jam only after they have leaned a little move farther here than between two searches of the run.
    limits.farthest = 5 * margin_;
    limits.corners_bear = corners_may_bear();
    limits.stop = stop_;
    if (last_scheduled_time(scene_, settings_) <= state_.time) {
        // Creep without a balance shows nothing but onset: it may stop earlier if the blocks are put back after it.
        constexpr double jammed_by_then = 0.01;
        limits.creep = settings_.creep ? Creep::left : Creep::put_back;
        limits.nearest = settings_.creep;
        limits.creep_rotation =
            settings_.creep ? settings_.onset_rotation : std::min(settings_.onset_rotation, jammed_by_then);
        limits.creep_slide = settings_.creep ? settings_.onset_slide : std::min(settings_.onset_slide, jammed_by_then);
    }
    if (limits.creep == Creep::left) {
        double largest = 0;
        for (std::size_t block = 0; block < bodies_.size(); ++block) {
            largest = held_[block] != 0 ? largest : std::max(largest, bodies_.radius[block]);
        }
        limits.farthest += std::min((limits.creep_rotation + limits.creep_slide) * largest, 20 * margin_);
    }
    return limits;
}

// Bolts are put in where blocks have come to rest under their pretension alone, so that settlement does not stretch
// them; in the initial geometry where blocks do not come to rest without them, or only far from there.
void Simulation::start_in_equilibrium_with_bolts(JointsAtStart joints) {
    if (joints == JointsAtStart::as_left) {
        start_in_equilibrium(joints, BoltsAtStart::stretching);
        return;
    }
    const bool may_pull_more = std::ranges::any_of(
        scene_.bolt, [](const BoltSegment& segment) { return segment.pretension < segment.capacity; });
    std::optional<RelaxationState> before = may_pull_more ? std::optional(state_) : std::nullopt;
    const bool balanced = start_in_equilibrium(joints, BoltsAtStart::pulling);
    const std::vector<Motion> unmoved(bodies_.size());
    if (!before || (balanced && farthest_motion(bodies_, state_, unmoved).in_thresholds(settings_) < 1)) {
        put_in_bolts(scene_, bodies_, state_);
        return;
    }
    go_on_from(std::move(*before));
    start_in_equilibrium(joints, BoltsAtStart::stretching);
}

// Returns whether a balance was found.
bool Simulation::start_in_equilibrium(JointsAtStart joints, BoltsAtStart bolts) {
    const StaticSolveSettings limits = static_solve_settings();
    std::vector<HeldByBolt> stretching;
    if (bolts == BoltsAtStart::pulling) {
        apply_loads();
    } else {
        sum_loads(scene_, pressure_, settings_, bodies_, state_.time, held_, state_.motion, load_);
        for (std::size_t index = 0; index < scene_.bolt.size(); ++index) {
            if (holds(scene_.bolt[index], state_.removed)) {
                stretching.push_back({scene_.bolt[index], state_.bolt[index]});
            }
        }
    }
    const bool first = joints == JointsAtStart::whole;
    if (settings_.start == RelaxationStart::stepped && bolts == BoltsAtStart::pulling) {
        return solve_in_steps(first, stretching, limits);
    }
    // Bolts that stretch pull with all of their pretension from the first step on.
    const bool may_step = first && stretching.empty() && may_need_steps();
    std::optional<RelaxationState> before = may_step ? std::optional(state_) : std::nullopt;
    if (solve_under(1, first, stretching, limits)) {
        return true;
    }
    if (!before || stopped()) {
        return false;
    }
    RelaxationState under_all_at_once = go_on_from(std::move(*before));
    StaticSolveSettings without_creep = limits;
    without_creep.creep = Creep::none;
    if (solve_in_steps(first, stretching, without_creep)) {
        return true;
    }
    go_on_from(std::move(under_all_at_once));
    return false;
}

RelaxationState Simulation::go_on_from(RelaxationState state) {
    state.contacts_evaluated = state_.contacts_evaluated;
    std::swap(state_, state);
    bonds_.resume(state_.bond);
    return state;
}

// Slender bonded columns lean far on each other before the full load is in balance, and rounds of the static solver
// diverge on the way; contacts with cohesion slip or open on the way that would hold the full load. Under loads that
// grow they converge. (Friction alone that cannot hold the full load cannot hold a part of it either.) Larger
// assemblies settle in the run at less cost.
bool Simulation::may_need_steps() const {
    constexpr std::ptrdiff_t few_enough = 400;
    return std::ranges::count(held_, 0) < few_enough &&
           (!bonds_.empty() ||
            std::ranges::any_of(scene_.material, [](const JointMaterial& joint) { return joint.cohesion > 0; }));
}

// If blocks find no balance under a part of the loads, the next step has all of them.
bool Simulation::solve_in_steps(bool first, std::span<const HeldByBolt> bolts, const StaticSolveSettings& limits) {
    constexpr int steps = 10;
    StaticSolveSettings on_the_way = limits;
    on_the_way.creep = Creep::none;
    bool balanced = true;
    for (int step = 1; step < steps && balanced; ++step, first = false) {
        balanced = solve_under(static_cast<double>(step) / steps, first, bolts, on_the_way);
    }
    return solve_under(1, first, bolts, limits);
}

// Bonds that cannot bear the loads break one after the other, the most overloaded first, while the rest finds its
// balance; without a balance the run continues from that state. Returns whether a balance was found.
bool Simulation::solve_under(double load_share, bool first, std::span<const HeldByBolt> bolts,
                             const StaticSolveSettings& limits) {
    std::vector<Eigen::Vector3d> loads;
    for (const BlockForce& load : load_) {
        loads.emplace_back(load_share * load.x, load_share * load.y, load_share * load.moment);
    }
    constexpr int most_continuations = 100;
    std::optional<StaticSolution> creeping;
    ContactList contacts_at_best;
    for (int continued = 0;; first = false) {
        find_contacts_within(2 * limits.farthest, first);
        StaticSolution found = solve_statically(bodies_, held_, loads, limits, creeping ? &*creeping : nullptr, bonds_,
                                                state_.bond, bolts, state_.motion, state_.contacts);
        state_.origin = found.most_balanced;
        state_.start_balance = StartBalance{found.ratio, found.cut_short};
        state_.contacts_evaluated += found.contacts_evaluated;
        if (found.ratio > limits.tolerance) {
            if (limits.creep != Creep::left && found.memory.size() == state_.contacts.contact.size()) {
                contacts_at_best = state_.contacts;
                contacts_at_best.memory = found.memory;
            }
            if (found.at_farthest && continued++ < most_continuations) {
                creeping = std::move(found);
                continue;
            }
            if (limits.creep != Creep::left && creeping) {
                state_.motion = found.most_balanced;
                state_.contacts = std::move(contacts_at_best);
            }
            return false;
        }
        creeping.reset();
        just_broken_ = bonds_.break_at_rest(state_.motion, state_.time, state_.bond);
        if (just_broken_.empty()) {
            lose_strength_where_open(bodies_, state_.motion, state_.contacts);
            return true;
        }
    }
}

void Simulation::find_contacts_within(double margin, bool first) {
    const std::vector<BlockPair> bonded = bonds_.joined(state_.bond);
    state_.contacts =
        find_contacts(scene_, bodies_, state_.motion, state_.removed,
                      {margin, settings_.viscous_damping, first, bonded, bonds_.shifted()}, state_.contacts);
    for (const std::size_t bond : std::exchange(just_broken_, {})) {
        hand_over(bonds_.list()[bond], state_.bond[bond].state, bodies_, state_.motion, state_.contacts);
    }
}

}  // namespace delabole
