// Runs that begin from a state at rest, and blocks that are not there at the start.
#include "dynamic_relaxation/simulation.hpp"

#include <utility>

namespace delabole {

namespace {

// What dissipated or slipped before belongs to the run before.
ContactMemory with_new_books(ContactMemory memory) {
    memory.damping = memory.friction = memory.slip = 0;
    memory.normal_drag = memory.shear_drag = 0;
    memory.tried = false;
    return memory;
}

BondMemory with_new_books(BondMemory memory) {
    memory.damping = 0;
    memory.normal_drag = memory.shear_drag = memory.bending_drag = 0;
    return memory;
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
    state.calm.resize(blocks, 0);
    state.noticed.resize(blocks);
    state.contacts = at_rest.contacts;
    for (std::size_t index = 0; index < state.contacts.memory.size(); ++index) {
        state.contacts.memory.set(index, with_new_books(state.contacts.memory[index]));
    }
    for (const BondMemory& bond : at_rest.bond) {
        state.bond.push_back(with_new_books(bond));
    }
    ContactWatch::start(blocks, state.watch);
    // Contacts that come about from now on are none of the initial geometry's.
    state.watch.searches = 1;
    return state;
}

void Simulation::take_away_what_is_not_there() {
    for (const Removal& removal : scene_.removal) {
        if (removal.time >= 0) {
            continue;
        }
        state_.removed[removal.block] = 1;
        for (std::size_t index = 0; index < state_.bond.size(); ++index) {
            const SharedFace& face = bonds_.list()[index].face;
            if (face.block == removal.block || face.other == removal.block) {
                state_.bond[index].state = BondState::block_removed;
            }
        }
    }
}

}  // namespace delabole
