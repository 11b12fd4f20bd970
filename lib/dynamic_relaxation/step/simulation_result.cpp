// The energy balance of a run and its result.
#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/step/bolt_forces.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/step/simulation.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

double EnergyBalance::turnover() const {
    return std::abs(applied) + std::abs(prescribed) + kinetic + std::abs(elastic) + friction + std::abs(bonds) +
           dashpots + local_damping + kinetic_damping;
}

double EnergyBalance::residual_share() const {
    // Elastic energy is the difference of two sums over all springs. Overlaps have some twelve digits.
    constexpr double rounding = 1e-9;
    const double lacking = residual();
    return std::abs(lacking) <= rounding * std::abs(elastic_at_start) ? 0 : lacking / turnover();
}

double Simulation::kinetic_energy_of(std::size_t block) const {
    if (held_[block] != 0) {
        return 0;
    }
    const Motion& motion = state_.motion[block];
    return (bodies_.inertial_mass[block] * (motion.vx * motion.vx + motion.vy * motion.vy) +
            bodies_.inertia[block] * motion.spin * motion.spin) /
           2;
}

double Simulation::kinetic_energy() const {
    double sum = 0;
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        sum += kinetic_energy_of(block);
    }
    return sum;
}

EnergyBalance Simulation::energy_balance() const {
    EnergyBalance energy_balance = state_.energy_balance;
    energy_balance.kinetic = kinetic_energy();
    energy_balance.elastic = bonds_.elastic_energy(state_.motion, state_.bond) - energy_balance.elastic_at_start;
    for (const BondMemory& memory : state_.bond) {
        energy_balance.dashpots += memory.damping;
    }
    for (std::size_t index = 0; index < state_.contacts.contact.size(); ++index) {
        const auto [contact, law, memory, at] = contact_now(state_.contacts, index, state_.motion);
        energy_balance.friction += memory.friction;
        energy_balance.dashpots += memory.damping;
        energy_balance.elastic += elastic_energy(law, contact, memory, at);
    }
    return energy_balance;
}

std::vector<BlockOutcome> Simulation::block_outcomes() const {
    return delabole::block_outcomes(bodies_, up(), state_, settings_);
}

RelaxationResult Simulation::result() const {
    RelaxationResult result;
    result.outcome = outcome();
    result.time = state_.time;
    result.tilt = tilt();
    result.tilt_of_base = tilt_of_base();
    if (state_.onset_time >= 0) {
        result.onset_time = state_.onset_time;
    }
    result.start_balance = state_.start_balance;
    result.unbalanced_ratio = std::max(state_.unbalanced, state_.unbalanced_then);
    result.first_crack = state_.first_crack;
    for (std::size_t bond = 0; bond < scene_.bond.size(); ++bond) {
        result.broken_bonds += scene_.bond[bond].of_rock && is_broken(state_.bond[bond].state) ? 1 : 0;
    }
    result.energy_balance = energy_balance();
    result.deepest = deepest_contact(bodies_, state_);
    result.overlap = state_.overlap;
    result.cost = {state_.steps, state_.watch.pair_checks, state_.contacts_evaluated, state_.step};
    result.block = block_outcomes();
    result.bolt = bolt_outcomes(scene_, bolt_pulls(scene_, bodies_, state_));
    return result;
}

RelaxationResult relax(const RelaxationScene& scene, const RelaxationSettings& settings,
                       const std::function<bool(const Simulation&)>& watch) {
    RelaxationResult refused;
    refused.fault = check(scene, settings);
    if (refused.fault.check != SceneCheck::valid) {
        return refused;
    }
    Simulation simulation(scene, settings);
    while (simulation.running()) {
        if (watch && !watch(simulation)) {
            RelaxationResult result = simulation.result();
            result.outcome = RelaxationOutcome::interrupted;
            return result;
        }
        simulation.step();
    }
    return simulation.result();
}

}  // namespace delabole
