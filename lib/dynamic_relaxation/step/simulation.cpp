#include "dynamic_relaxation/step/simulation.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/contact/corner_choice.hpp"
#include "dynamic_relaxation/contact/time_step.hpp"
#include "dynamic_relaxation/statics/static_solver.hpp"
#include "dynamic_relaxation/step/base_friction.hpp"
#include "dynamic_relaxation/step/bolt_forces.hpp"
#include "dynamic_relaxation/step/loads.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace delabole {

namespace {

// Contact margin as a fraction of the scene's shortest edge.
constexpr double margin_in_shortest_edges = 0.01;

// Displacements that change the force of the stiffest spring by 1e-12 of a block's weight.
std::vector<double> unnoticed_displacements(const RelaxationScene& scene, const Bodies& bodies) {
    constexpr double share_of_weight = 1e-12;
    double stiffest = 0;
    for (const JointMaterial& joint : scene.material) {
        stiffest = std::max({stiffest, joint.normal_stiffness, joint.shear_stiffness});
    }
    const double gravity = scene.gravity.acceleration > 0 ? scene.gravity.acceleration : 1;
    std::vector<double> displacements;
    for (const double mass : bodies.mass) {
        displacements.push_back(share_of_weight * mass * gravity / stiffest);
    }
    return displacements;
}

// Local damping that opposes a spring's oscillation acts as a stiffer spring, up to 1 + `local_damping` times: at 0.2
// the greatest share allowed, 0.8, is stable, and with more damping the stable share decreases in proportion. On a belt
// friction damps oscillations, and any share is stable.
double share_of_stable_step(const RelaxationScene& scene, const RelaxationSettings& settings) {
    constexpr double most = 0.8 * 1.2;
    return scene.belt ? settings.step_fraction : std::min(settings.step_fraction, most / (1 + settings.local_damping));
}

Bodies bodies_of(const RelaxationScene& scene, const RelaxationSettings& settings) {
    Bodies bodies = make_bodies(scene);
    if (settings.mass_scaling) {
        scale_masses(bodies);
    }
    return bodies;
}

double shortest_edge(const Bodies& bodies) {
    return *std::min_element(bodies.shortest_edge.begin(), bodies.shortest_edge.end());
}

}  // namespace

Simulation::Simulation(RelaxationState state, RelaxationScene scene, RelaxationSettings settings,
                       const std::atomic<bool>* stop)
    : scene_(std::move(scene)),
      settings_(settings),
      stop_(stop),
      bodies_(bodies_of(scene_, settings_)),
      state_(std::move(state)),
      team_(std::max<std::size_t>(settings_.threads, 1)),
      contact_forces_(bodies_, team_),
      bonds_(scene_, bodies_, settings_.viscous_damping, team_),
      contact_watch_(scene_, bodies_, settings_) {}

Simulation::Simulation(RelaxationScene scene, RelaxationSettings settings, const std::atomic<bool>* stop)
    : Simulation(RelaxationState{}, std::move(scene), settings, stop) {
    state_.motion.resize(bodies_.size());
    state_.removed.resize(bodies_.size(), 0);
    state_.base_slip.resize(bodies_.size(), 0);
    state_.dropped_slip.resize(bodies_.size());
    state_.checks_at_rest.resize(bodies_.size(), 0);
    state_.bond.resize(scene_.bond.size());
    state_.bolt.resize(scene_.bolt.size());
    state_.noticed.resize(bodies_.size());
    ContactWatch::start(bodies_.size(), state_.watch);
    take_away_what_is_not_there();
    prepare();
    begin(JointsAtStart::whole);
}

Simulation::Simulation(RelaxationScene scene, RelaxationSettings settings, RelaxationState state)
    : Simulation(std::move(state), std::move(scene), settings, nullptr) {
    prepare();
    contact_forces_.renew();
    contact_watch_.resume(state_.watch, state_.contacts);
}

Simulation::Simulation(RelaxationScene scene, RelaxationSettings settings, const ConsolidatedState& from,
                       const std::atomic<bool>* stop)
    : Simulation(begun_at(from.at_rest), std::move(scene), settings, stop) {
    settings_.start = RelaxationStart::preloaded;
    prepare();
    begin(JointsAtStart::as_left);
    contact_forces_.renew();
}

void Simulation::prepare() {
    bonds_.resume(state_.bond);
    pressure_ = pressures_left(scene_, bodies_, state_.removed);
    margin_ = margin_in_shortest_edges * shortest_edge(bodies_);
    longest_step_ = std::sqrt(shortest_edge(bodies_) / std::max(scene_.gravity.acceleration, 1e-3)) / 20;
    load_.resize(bodies_.size());
    double stiffest = 0;
    for (const JointMaterial& joint : scene_.material) {
        stiffest = std::max(stiffest, joint.normal_stiffness);
    }
    // The speed of a spring that oscillates with the force that still counts as balanced.
    const double gravity = scene_.gravity.acceleration > 0 ? scene_.gravity.acceleration : 1;
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        scales_.inverse_radius.push_back(1 / bodies_.radius[block]);
        scales_.inverse_weight.push_back(1 / (bodies_.mass[block] * gravity));
    }
    for (const double mass : bodies_.inertial_mass) {
        scales_.rest_speed.push_back(rest_ratio() * gravity * std::sqrt(mass / stiffest));
    }
    scales_.unnoticed = unnoticed_displacements(scene_, bodies_);
    hold_blocks();
    if (settings_.crack_opening) {
        watched_ = find_shared_faces(bodies_);
        std::erase_if(watched_, [&](const SharedFace& face) {
            return bodies_.fixed[face.block] != 0 || bodies_.fixed[face.other] != 0;
        });
    }
}

void Simulation::begin(JointsAtStart joints) {
    if (is_preloaded(settings_.start)) {
        start_in_equilibrium_with_bolts(joints);
    } else {
        state_.origin = state_.motion;
        put_in_bolts(scene_, bodies_, state_);
    }
    if (last_scheduled_time(scene_, settings_) > 0) {
        forget_tried(state_.contacts.memory);
    }
    // The first step evaluates all contacts.
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        state_.noticed.notice(block, state_.motion[block]);
    }
    find_contacts_where_due();
    state_.energy_balance.bonds = 0;
    state_.energy_balance.elastic_at_start = bonds_.elastic_energy(state_.motion, state_.bond);
    // Slip on the way to a balance belongs to the initial state of the blocks; slip of creeping blocks does not.
    const bool crept = settings_.creep && state_.start_balance &&
                       state_.start_balance->unbalanced_ratio > static_solve_settings().tolerance;
    for (std::size_t index = 0; index < state_.contacts.contact.size(); ++index) {
        auto [contact, law, memory, at] = contact_now(state_.contacts, index, state_.motion);
        memory.friction = 0;  // edges exchanged at corners while springs were preloaded
        memory.slip = crept ? memory.slip : 0;
        state_.contacts.memory.set(index, memory);
        // Initial geometry with an overlap: the springs that bear in the first step are compressed before it.
        if (!is_preloaded(settings_.start) && contact.gap < 0 && !memory.beneath && !memory.yields) {
            memory.touching = true;
        }
        state_.energy_balance.elastic_at_start += elastic_energy(law, contact, memory, at);
    }
}

void Simulation::step() {
    follow_schedules();
    break_bonds();
    find_contacts_where_due();
    apply_contact_forces();
    apply_loads();
    integrate();
    decide();
    audit();
}

void Simulation::hold_blocks() {
    held_ = bodies_.fixed;
    held_for_consolidation_ = consolidating();
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        if (state_.removed[block] != 0 || (scene_.block[block].held_at_first && held_for_consolidation_)) {
            held_[block] = 1;
        }
    }
}

double Simulation::tilt() const {
    return tilt_at(scene_.gravity, state_.time);
}

void Simulation::follow_schedules() {
    bool changed = consolidating() != held_for_consolidation_;
    for (const Removal& removal : scene_.removal) {
        if (state_.removed[removal.block] == 0 && state_.time >= removal.time) {
            take_away(removal.block, taken_away);
            changed = true;
        }
    }
    if (changed) {
        hold_blocks();
        pressure_ = pressures_left(scene_, bodies_, state_.removed);
    }
    for (const PrescribedMotion& motion : scene_.motion) {
        Motion& moved = state_.motion[motion.block];
        const Motion before = moved;
        prescribe(motion, bodies_, state_.time, moved);
        if (moved.vx != before.vx || moved.vy != before.vy || moved.spin != before.spin) {
            fastest_.reset();
            state_.watch.due[motion.block] = -std::numeric_limits<double>::infinity();
        }
    }
}

void Simulation::take_away(std::size_t block, char why) {
    account_for_springs_of_removed(block);
    state_.energy_balance.kinetic_damping += kinetic_energy_of(block);
    state_.removed[block] = why;
    state_.motion[block].vx = state_.motion[block].vy = state_.motion[block].spin = 0;
    fastest_.reset();
    check_contacts_of(block);
}

void Simulation::account_for_springs_of_removed(std::size_t block) {
    for (std::size_t index = 0; index < state_.contacts.contact.size(); ++index) {
        const ContactBlocks& blocks = state_.contacts.contact.blocks()[index];
        if (blocks.block == block || blocks.other == block) {
            const auto [contact, law, memory, at] = contact_now(state_.contacts, index, state_.motion);
            state_.energy_balance.friction += elastic_energy(law, contact, memory, at);
        }
    }
    for (std::size_t index = 0; index < state_.bond.size(); ++index) {
        const SharedFace& face = bonds_.list()[index].face;
        BondMemory& memory = state_.bond[index];
        if (memory.state == BondState::whole && (face.block == block || face.other == block)) {
            state_.energy_balance.friction += bonds_.elastic_energy(index, state_.motion);
            memory.state = BondState::block_removed;
            memory.time = state_.time;
        }
    }
}

void Simulation::break_bonds() {
    if (bonds_.empty()) {
        return;
    }
    just_broken_ = bonds_.stretch(state_.motion, state_.last_step, state_.time, state_.bond);
    for (const std::size_t bond : just_broken_) {
        // Velocities, and with them kinetic energy, are those of half a step ago.
        state_.energy_balance.bonds += bonds_.elastic_energy(bond, state_.motion, state_.last_step / 2);
        check_contacts_of(bonds_.list()[bond].face.block);
        check_contacts_of(bonds_.list()[bond].face.other);
    }
}

double Simulation::fastest() {
    const auto find = [&] {
        double speed = 0;
        for (std::size_t block = 0; block < bodies_.size(); ++block) {
            speed = std::max(speed, fastest_point<double>(state_.motion[block], bodies_.radius[block]));
        }
        return speed;
    };
    if (!fastest_) {
        fastest_ = find();
    }
    assert(*fastest_ == find());
    return *fastest_;
}

// Marks the block for checks of neighbours, contacts and the stable step.
void Simulation::check_contacts_of(std::size_t block) {
    state_.watch.due[block] = state_.watch.neighbours_until[block] = state_.watch.step_until[block] =
        -std::numeric_limits<double>::infinity();
}

void Simulation::find_contacts_where_due() {
    const double last = state_.contacts.contact.empty() ? longest_step_ : std::min(state_.step, longest_step_);
    if (!check_contacts()) {
        return;
    }
    choose_step(last);
    constexpr double room_to_grow = 1.25;
    while (state_.step > state_.watch.step) {
        contact_watch_.prepare_for(room_to_grow * state_.step, state_.motion, state_.watch);
        check_contacts();
        choose_step(last);
    }
    if (state_.step < state_.watch.step / 2) {
        state_.watch.step = room_to_grow * state_.step;
    }
}

// Returns whether any blocks were due.
bool Simulation::check_contacts() {
    if (!contact_watch_.update({state_.motion, state_.removed}, bonds_, state_.bond, state_.watch, state_.contacts)) {
        return false;
    }
    for (const ContactWatch::Dropped& dropped : contact_watch_.dropped()) {
        state_.energy_balance.friction += dropped.memory.friction;
        state_.energy_balance.dashpots += dropped.memory.damping;
        note_base_slip(bodies_, state_.motion, dropped.contact, dropped.memory, up(), state_.dropped_slip);
    }
    for (const std::size_t bond : std::exchange(just_broken_, {})) {
        state_.energy_balance.bonds -= hand_over(bonds_.list()[bond], state_.bond[bond].state, bodies_, state_.motion,
                                                 state_.contacts, state_.last_step / 2);
    }
    if (contact_watch_.list_changed()) {
        contact_forces_.renew();
    }
    for (const std::uint32_t block : contact_watch_.changed_blocks()) {
        state_.noticed.notice(block, state_.motion[block]);
    }
    if (contact_watch_.worst_overlap() > settings_.overlap_limit) {
        state_.outcome = static_cast<std::uint64_t>(RelaxationOutcome::overlap_too_large);
    }
    return true;
}

void Simulation::choose_step(double last) {
    const double speed = fastest();
    // The step does not grow while blocks are fast, because their contacts would be found too late.
    const double seen_ahead = speed > 0 ? std::max(last, margin_ / (8 * speed)) : longest_step_;
    const double stable = 1 / std::hypot(1 / contact_watch_.stable_step(), 1 / stable_step_of_bolts(scene_, bodies_));
    double largest = std::min({share_of_stable_step(scene_, settings_) * stable, longest_step_, seen_ahead});
    if (scene_.belt) {
        largest = std::min(largest, longest_step(*scene_.belt, scene_.gravity));
    }
    state_.step = largest;
    if (settings_.time_step) {
        state_.step = *settings_.time_step / std::max(1.0, std::ceil(*settings_.time_step / largest));
    }
}

void Simulation::apply_contact_forces() {
    state_.contacts_evaluated += contact_forces_.apply(state_.motion, state_.watch.travelled, state_.noticed.moved,
                                                       state_.last_step, state_.contacts);
}

void Simulation::apply_loads() {
    if (loads_are_final_) {
        return;
    }
    sum_loads(scene_, pressure_, settings_, bodies_, state_.time, held_, state_.motion, load_);
    add_bolt_forces(scene_, bodies_, state_, load_);
    loads_are_final_ = !scene_.belt && scene_.force.empty() && scene_.bolt.empty() && scene_.pressure.empty() &&
                       state_.time > last_scheduled_time(scene_, settings_);
}

void Simulation::integrate() {
    // Sums are taken over the same groups of blocks in the same order, whichever thread adds up a group.
    constexpr std::size_t group_size = 256;
    const std::size_t groups = (bodies_.size() + group_size - 1) / group_size;
    sums_.resize(groups);
    const BlockSweep sweep{bodies_,
                           scales_,
                           held_.data(),
                           contact_forces_.on_blocks().data(),
                           bonds_.empty() ? nullptr : bonds_.on_blocks().data(),
                           load_.data(),
                           settings_.local_damping,
                           (state_.last_step + state_.step) / 2,
                           state_.step,
                           rest_ratio(),
                           checks_before_rest,
                           state_.motion.data(),
                           state_.watch.travelled.data(),
                           state_.checks_at_rest.data(),
                           state_.noticed,
                           bodies_.moved_base ? state_.motion[*bodies_.moved_base] : Motion{}};
    const auto move_groups = [&](std::size_t part) {
        for (std::size_t group = part_begin(groups, part, team_.size());
             group < part_begin(groups, part + 1, team_.size()); ++group) {
            sums_[group] = move_blocks(sweep, group * group_size, std::min((group + 1) * group_size, bodies_.size()));
        }
    };
    if (groups > 1) {
        team_.run(move_groups);
    } else {
        sums_.front() = move_blocks(sweep, 0, bodies_.size());
    }
    fastest_ = 0;
    for (const StepSums& group : sums_) {
        fastest_ = std::max(*fastest_, group.fastest);
        state_.energy_balance.applied += group.applied;
        state_.energy_balance.prescribed += group.prescribed;
        state_.energy_balance.local_damping += group.damped;
        state_.unbalanced = std::max(state_.unbalanced, group.unbalanced);
    }
    state_.time += state_.step;
    state_.last_step = state_.step;
    ++state_.steps;
    if (settings_.kinetic_damping) {
        take_velocities_away_at_peaks();
    }
}

void Simulation::take_velocities_away_at_peaks() {
    const double now = kinetic_energy();
    if (state_.kinetic_rising && now < state_.kinetic_before) {
        state_.energy_balance.kinetic_damping += now;
        for (std::size_t block = 0; block < bodies_.size(); ++block) {
            if (held_[block] == 0) {
                state_.motion[block].vx = state_.motion[block].vy = state_.motion[block].spin = 0;
            }
        }
        fastest_.reset();
        state_.last_step = 0;
        state_.kinetic_rising = false;
        state_.kinetic_before = 0;
        return;
    }
    state_.kinetic_rising = now > state_.kinetic_before;
    state_.kinetic_before = now;
}

}  // namespace delabole
