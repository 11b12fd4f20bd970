#include "dynamic_relaxation/study/failed_at_rest.hpp"

#include "dynamic_relaxation/study/strength_bound.hpp"
#include "dynamic_relaxation/study/strength_reduction.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace delabole {

namespace {

// The state with displacements since `start` instead of since the static solve at the start.
RelaxationState since(RelaxationState state, std::vector<Motion> start) {
    state.origin = std::move(start);
    return state;
}

// Whether blocks rest beyond the threshold of onset from `start`, which is where they began: at rest in `begun_at` or
// else in the initial geometry.
bool rests_beyond_onset(const Simulation& simulation, const std::vector<Motion>& start,
                        const RelaxationState* begun_at) {
    const RelaxationScene& scene = simulation.scene();
    if (simulation.outcome() != RelaxationOutcome::equilibrium || scene.belt || !scene.motion.empty()) {
        return false;
    }
    RelaxationSettings settings = simulation.settings();
    const Bodies& bodies = simulation.bodies();
    // Whether a block has moved beyond the thresholds and its settlement. Some lean beyond the threshold before they
    // jam; their centroids move with it, by as much in radii.
    const auto any_is_beyond = [&](const std::vector<Motion>& settled) {
        constexpr double most_settlement = 0.1;  // radii or rad: more is motion that no strength prevents
        for (std::size_t block = 0; block < bodies.size(); ++block) {
            const auto moved_to = [&](const Motion& now) {
                const double displacement = std::hypot(now.x - start[block].x, now.y - start[block].y);
                return MotionExtremes{std::abs(now.angle - start[block].angle), displacement / bodies.radius[block]};
            };
            const MotionExtremes moved = moved_to(simulation.state().motion[block]);
            const MotionExtremes allowed = moved_to(settled[block]);
            if (bodies.fixed[block] == 0 && simulation.state().removed[block] == 0 &&
                (moved.rotation >
                     far_beyond_onset * settings.onset_rotation + std::min(allowed.rotation, most_settlement) ||
                 moved.displacement >
                     settings.onset_slide + moved.rotation + std::min(allowed.displacement, most_settlement))) {
                return true;
            }
        }
        return false;
    };
    if (!any_is_beyond(start)) {
        return false;
    }
    // Blocks on soft joints settle by as much, however strong these are.
    settings.creep = false;
    settings.start = RelaxationStart::preloaded;
    const RelaxationScene strong = with_multiplied_strength(scene, greatest_strength);
    const Simulation settled =
        begun_at != nullptr ? Simulation(strong, settings, ConsolidatedState{*begun_at}) : Simulation(strong, settings);
    const std::optional<StartBalance>& balance = settled.state().start_balance;
    return !balance || balance->unbalanced_ratio > settings.equilibrium_ratio || any_is_beyond(settled.state().motion);
}

// Whether blocks touch across joints that were open in the initial geometry.
bool has_closed_joints(const Simulation& simulation) {
    const ContactList& list = simulation.state().contacts;
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        const RelaxationContact contact = list.contact[index];
        if (contact.gap > opening_of_closed_joint(simulation.bodies(), contact.block, contact.other) &&
            list.memory[index].touching) {
            return true;
        }
    }
    return false;
}

// Moves the blocks of `state` as far along the mechanism as its thresholds of onset.
void move_to_onset(const Bodies& bodies, const RelaxationSettings& settings, std::vector<Motion> mechanism,
                   RelaxationState& state) {
    state.motion = std::move(mechanism);
    const double share = farthest_motion(bodies, state, state.origin).in_thresholds(settings);
    if (!(share > 0)) {
        return;  // only blocks that have left
    }
    for (Motion& motion : state.motion) {
        motion.x /= share;
        motion.y /= share;
        motion.set_angle(motion.angle / share);
    }
    state.base_slip.assign(bodies.size(), 0);
    state.dropped_slip.assign(bodies.size(), {});
    for (std::size_t index = 0; index < state.contacts.contact.size(); ++index) {
        auto [contact, law, memory, at] = contact_now(state.contacts, index, state.motion);
        memory.slip = memory.touching ? at.slide : 0;
        state.contacts.memory.set(index, memory);
    }
}

// Stages of excavation leave gaps, too.
bool may_be_apart(const RelaxationScene& scene, InitialContact contact) {
    return contact == InitialContact::perhaps_none || !scene.removal.empty();
}

constexpr std::size_t quickly_asked = 2000;  // blocks of which statics tells in about a second

// The state in which blocks have failed by statics, if it has to be asked and finds no forces that hold them.
std::optional<RelaxationState> failed_by_statics(const Simulation& simulation, InitialContact contact) {
    const RelaxationOutcome outcome = simulation.outcome();
    const RelaxationSettings& settings = simulation.settings();
    const Bodies& bodies = simulation.bodies();
    const std::vector<Motion> unmoved(bodies.size());
    const MotionExtremes moved = farthest_motion(bodies, simulation.state(), unmoved);
    bool open = outcome == RelaxationOutcome::undecided || outcome == RelaxationOutcome::overlap_too_large ||
                outcome == RelaxationOutcome::energy_not_balanced;
    if (outcome == RelaxationOutcome::equilibrium) {
        constexpr double beyond_settlement = 0.002;  // rad, or of a radius: blocks as stiff as usual settle by a third
        open = bodies.size() <= quickly_asked || std::max(moved.rotation, moved.displacement) > beyond_settlement ||
               !simulation.scene().bolt.empty();
    }
    if (!open || settings.corners_bear) {
        return std::nullopt;
    }
    const bool within_onset = moved.in_thresholds(settings) < 1;
    std::optional<StaticMechanism> mechanism = mechanism_of_statics(simulation.scene(), simulation.state().time);
    bool some_landed = false;
    if (mechanism &&
        (mechanism->at_any_strength == true || (may_be_apart(simulation.scene(), contact) && within_onset))) {
        some_landed = has_closed_joints(simulation);
        mechanism = some_landed ? mechanism_where_blocks_landed(simulation, *mechanism) : mechanism;
    }
    if (!mechanism) {
        return std::nullopt;
    }
    RelaxationState state = since(simulation.state(), unmoved);
    // If blocks have landed, the farthest motion is theirs, and the blocks at fault may not have moved.
    if (within_onset || some_landed) {
        move_to_onset(bodies, settings, std::move(mechanism->motion), state);
    }
    return state;
}

}  // namespace

bool any_is_drawn_apart(const RelaxationScene& scene) {
    const Bodies bodies = make_bodies(scene);
    std::vector<char> faces = bodies.fixed;
    for (const SharedFace& face : find_shared_faces(bodies)) {
        faces[face.block] = faces[face.other] = 1;
    }
    return std::ranges::find(faces, 0) != faces.end();
}

std::optional<RelaxationState> failed_at_rest(const Simulation& simulation, InitialContact contact,
                                              const RelaxationState* begun_at) {
    const std::vector<Motion> unmoved(simulation.bodies().size());
    const std::vector<Motion>& start = begun_at != nullptr ? begun_at->motion : unmoved;
    std::optional<RelaxationState> failed;
    const bool begun_in_contact =
        begun_at != nullptr || contact == InitialContact::drawn || !has_closed_joints(simulation);
    if (begun_in_contact && rests_beyond_onset(simulation, start, begun_at)) {
        failed = since(simulation.state(), start);
    } else {
        failed = failed_by_statics(simulation, contact);
    }
    if (failed) {
        failed->onset_time = begun_at != nullptr ? begun_at->time : 0;
    }
    return failed;
}

bool fails_by_statics(const RelaxationScene& scene, const RelaxationSettings& settings, InitialContact contact) {
    if (scene.block.size() > quickly_asked || settings.corners_bear || may_be_apart(scene, contact)) {
        return false;
    }
    const std::optional<StaticMechanism> mechanism = mechanism_of_statics(scene);
    return mechanism && mechanism->at_any_strength == false;
}

RelaxationResult result_of(const Simulation& at_rest, const RelaxationState& failed) {
    RelaxationResult result = at_rest.result();
    RelaxationResult moved = Simulation(at_rest.scene(), at_rest.settings(), failed).result();
    result.block = std::move(moved.block);
    result.onset_time = moved.onset_time;
    if (at_rest.settings().stop_at_onset) {
        result.outcome = RelaxationOutcome::onset;
    }
    return result;
}

}  // namespace delabole
