// The checks of a run at intervals of steps: whether it is over, whether a crack has opened, which blocks rest.
#include "dynamic_relaxation/contact/corner_choice.hpp"
#include "dynamic_relaxation/statics/face_assembly.hpp"
#include "dynamic_relaxation/statics/static_check.hpp"
#include "dynamic_relaxation/step/loads.hpp"
#include "dynamic_relaxation/step/simulation.hpp"
#include "limit_equilibrium/bound/lp_bound.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace delabole {

namespace {

// Steps between two checks of the balance of forces.
constexpr std::uint64_t steps_between_checks = 50;
// Steps between two measurements of the overlap of blocks: together they cost less than a hundredth of the run.
constexpr std::uint64_t steps_between_audits = 5000;

// J/m; energy that lifts every free block by its settlement on the softest joint.
double energy_of_settlements(const RelaxationScene& scene, const Bodies& bodies) {
    const auto softest =
        std::ranges::min_element(scene.material, {}, [](const JointMaterial& joint) { return joint.normal_stiffness; });
    double energy = 0;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        const double weight = bodies.fixed[block] != 0 ? 0 : bodies.mass[block] * scene.gravity.acceleration;
        energy += weight * weight / softest->normal_stiffness;
    }
    return energy;
}

}  // namespace

void Simulation::decide() {
    const bool last = out_of_time();
    if ((state_.steps % steps_between_checks != 0 && !last) || outcome() != RelaxationOutcome::undecided) {
        return;
    }
    let_blocks_rest();
    let_blocks_leave();
    detect_crack();
    account_for_base_slip(bodies_, up(), state_);
    const double kinetic = kinetic_energy();
    const bool growing = kinetic > state_.kinetic_then;
    state_.kinetic_then = kinetic;
    const double unbalanced = std::exchange(state_.unbalanced, 0.0);
    // The last check may be only a few steps after the one before it.
    const double lately = std::max(unbalanced, std::exchange(state_.unbalanced_then, unbalanced));
    const auto at_rest = [&](double ratio) {
        return !growing && !carried_along() && ratio < settings_.equilibrium_ratio &&
               // The last step was made under the final loads.
               state_.time - state_.last_step > last_scheduled_time(scene_, settings_) && holds_at_rest();
    };
    std::optional<bool> by_faces;
    const auto faces_hold = [&] { return by_faces ? *by_faces : by_faces.emplace(held_by_faces()); };
    const MotionExtremes farthest = farthest_motion(bodies_, state_, state_.origin);
    const auto decide = [&](RelaxationOutcome outcome) { state_.outcome = static_cast<std::uint64_t>(outcome); };
    if (!std::isfinite(kinetic)) {
        decide(RelaxationOutcome::motion_not_finite);
        return;
    }
    const double in_thresholds = farthest.in_thresholds(settings_);
    if (in_thresholds > 1 && state_.onset_time < 0) {
        state_.onset_time = state_.time;
    }
    if (settings_.stop_at_onset && state_.onset_time >= 0) {
        // Failing blocks accelerate; a block that has been pushed may lean beyond the threshold, slow down and fall
        // back. On a belt nothing accelerates.
        const bool moves_on = growing && in_thresholds > state_.in_thresholds_then;
        if (in_thresholds <= 1) {
            state_.onset_time = -1;
        } else if (in_thresholds > far_beyond_onset || moves_on || scene_.belt || last) {
            decide(RelaxationOutcome::onset);
            return;
        }
    }
    state_.in_thresholds_then = in_thresholds;
    const bool collapsed = farthest.rotation > settings_.collapse_rotation ||
                           farthest.displacement > settings_.collapse_displacement ||
                           std::ranges::find(state_.removed, has_left) != state_.removed.end();
    if (collapsed && (settings_.stop_at_collapse || last)) {
        decide(RelaxationOutcome::collapse);
    } else if (at_rest(last && !settings_.stop_at_equilibrium ? lately : unbalanced) && !try_corners(faces_hold) &&
               (last || settings_.stop_at_equilibrium)) {
        decide(collapsed                                           ? RelaxationOutcome::collapse
               : settings_.stop_at_onset && state_.onset_time >= 0 ? RelaxationOutcome::onset
               : faces_hold()                                      ? RelaxationOutcome::equilibrium
                                                                   : RelaxationOutcome::held_by_corners);
    } else if (last && state_.onset_time >= 0) {
        // Blocks have moved past the thresholds and have not come to rest since.
        decide(RelaxationOutcome::onset);
    }
}

std::vector<double> Simulation::weights() const {
    std::vector<double> weight(bodies_.size(), std::numeric_limits<double>::infinity());
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        weight[block] = held_[block] != 0 ? weight[block] : 1 / scales_.inverse_weight[block];
    }
    return weight;
}

bool Simulation::try_corners(const std::function<bool()>& faces_hold) {
    if (without_corners_) {
        return false;
    }
    const CornerMotion blocks{bodies_, state_.motion};
    std::vector<std::uint32_t> concerned = end_trial(blocks, state_.contacts);
    // A search asks whether the faces alone hold the blocks, for which it does not matter on which edges corners bear.
    if (concerned.empty() && (corners_may_bear() || !settings_.creep)) {
        ContactList exchanged = state_.contacts;
        concerned = try_other_edges(blocks, weights(), exchanged);
        if (!corners_may_bear() && !concerned.empty() && faces_hold()) {
            note_tried(exchanged.memory, state_.contacts.memory);
            concerned.clear();
        } else {
            state_.contacts = std::move(exchanged);
            state_.held_by_corners.clear();
        }
    }
    for (const std::uint32_t block : concerned) {
        state_.checks_at_rest[block] = 0;
        state_.noticed.notice(block, state_.motion[block]);
    }
    return !concerned.empty();
}

// Whether blocks may stand on corners, because the case says so or because statics cannot tell what faces hold: a
// belt's resistance changes direction with the motion.
bool Simulation::corners_may_bear() const {
    return settings_.corners_bear || scene_.belt;
}

// Whether the faces alone hold the blocks in their present positions and under the present loads (corner_choice.hpp),
// or corners may bear; records the blocks that would move. After onset only touching contacts count; before it, the
// faces of the initial geometry do, because a minute rotation opens one end of them or the other, and bolts bear from
// nothing up to their capacity, of which little is needed as long as corners bear. Cases that the linear programme
// cannot solve are left to the trial in which corners give way, or held by corners if none does.
bool Simulation::held_by_faces() {
    if (corners_may_bear() || without_corners_ ||
        !relies_on_corners({bodies_, state_.motion}, weights(), state_.contacts)) {
        return true;
    }
    const bool before_onset = state_.onset_time < 0;
    const std::vector<SharedFace> faces =
        before_onset ? find_shared_faces(bodies_, closed_joint, state_.removed) : std::vector<SharedFace>();
    std::vector<BlockForce> load = load_;
    if (before_onset && !scene_.bolt.empty()) {
        sum_loads(scene_, pressure_, settings_, bodies_, state_.time, held_, state_.motion, load);
    }
    const BlocksUnderLoad blocks{scene_, bodies_, held_, state_.removed, state_.motion, load};
    const JointHistory history{state_.bond, state_.contacts};
    FaceAssembly made = face_assembly(blocks, faces, &history);
    add_corners_on_edges(blocks, state_.contacts, made);
    if (before_onset) {
        add_bolts(blocks, made);
    }
    const LeastImbalance found = least_imbalance(made.assembly);
    if (found.status != LpStatus::optimal || found.stands()) {
        return !moves_without_corners(found.status == LpStatus::optimal);
    }
    constexpr double moves = 1e-3;  // of the greatest displacement
    state_.held_by_corners.assign(bodies_.size(), 0);
    for (std::size_t body = 0; body < made.block_of.size(); ++body) {
        const std::size_t block = made.block_of[body];
        const VirtualMotion& motion = found.mechanism[body];
        if (motion.displacement.norm() + std::abs(motion.rotation) * bodies_.radius[block] > moves) {
            state_.held_by_corners[block] = 1;
        }
    }
    return false;
}

// Whether blocks move on when every corner that bears on a corner gives way, and those that bear next, too; records
// the blocks that do. A trial that comes to no end within its limits is inconclusive unless a block has moved a tenth
// of the thresholds of onset.
bool Simulation::moves_without_corners(bool forces_exist) {
    constexpr int most_rounds = 8;
    constexpr std::uint64_t most_contacts = 50'000'000;  // evaluated in a round: a second or two
    constexpr double well_on_their_way = 0.1;            // of the thresholds of onset
    RelaxationSettings settings = settings_;
    settings.stop_at_onset = settings.stop_at_equilibrium = settings.stop_at_collapse = true;
    settings.duration += state_.time;
    settings.most_steps = std::numeric_limits<std::size_t>::max();
    ConsolidatedState from{state_};
    std::set<std::pair<std::uint32_t, std::uint32_t>> given_way;
    for (int round = 0; round < most_rounds; ++round) {
        if (!give_way_at_corners({bodies_, from.at_rest.motion}, weights(), from.at_rest.contacts, given_way)) {
            return round == 0 && !forces_exist;
        }
        Simulation trial(scene_, settings, from, stop_);
        trial.without_corners_ = true;
        while (trial.running() && trial.state_.contacts_evaluated < most_contacts && !stopped()) {
            trial.step();
        }
        from.at_rest = std::move(trial.state_);
        if (trial.outcome() != RelaxationOutcome::equilibrium || stopped()) {
            from.at_rest.origin = state_.motion;
            break;
        }
    }
    const auto outcome = static_cast<RelaxationOutcome>(from.at_rest.outcome);
    const MotionExtremes farthest = farthest_motion(bodies_, from.at_rest, from.at_rest.origin);
    if (outcome == RelaxationOutcome::equilibrium || farthest.in_thresholds(settings_) < well_on_their_way) {
        return false;
    }
    constexpr double moves = 0.1;  // of the greatest displacement
    state_.held_by_corners.assign(bodies_.size(), 0);
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        const Motion& now = from.at_rest.motion[block];
        const PlanePoint<> displacement(now.x - state_.motion[block].x, now.y - state_.motion[block].y);
        state_.held_by_corners[block] =
            held_[block] == 0 && displacement.norm() > moves * farthest.displacement * bodies_.radius[block] ? 1 : 0;
    }
    return true;
}

// Checks what contacts do not show: overlaps of blocks, and at the end the energy balance.
void Simulation::audit() {
    const bool ends = !running();
    if (!ends && state_.steps % steps_between_audits != 0) {
        return;
    }
    if (!std::isfinite(kinetic_energy())) {
        state_.outcome = static_cast<std::uint64_t>(RelaxationOutcome::motion_not_finite);
        return;
    }
    const std::optional<BlockOverlap> now = greatest_overlap(bodies_, state_.motion, state_.removed);
    if (now && now->share > (state_.overlap ? state_.overlap->share : 0)) {
        state_.overlap = now;
    }
    if (now && now->share > settings_.overlap_limit) {
        state_.outcome = static_cast<std::uint64_t>(RelaxationOutcome::overlap_too_large);
    }
    // Blocks that creep only serve to find out whether they stand. If they rest held by corners they do not, in
    // whatever way they came there; that they stand is believed only of motion whose energy is balanced.
    const bool fails_at_rest = settings_.creep && outcome() == RelaxationOutcome::held_by_corners;
    if (!ends || fails_at_rest || outcome() == RelaxationOutcome::overlap_too_large) {
        return;
    }
    const EnergyBalance energy = energy_balance();
    const double beside = energy.turnover() + energy.elastic_at_start;
    const double settlements = settlements_lacking * energy_of_settlements(scene_, bodies_);
    if (!(std::abs(energy.residual()) <= std::max(most_energy_lacking * beside, settlements))) {
        state_.outcome = static_cast<std::uint64_t>(RelaxationOutcome::energy_not_balanced);
    }
}

// Dashpots are left out, because they may hide a motion that has yet to die out.
bool Simulation::holds_at_rest() const {
    constexpr double yet_to_die_out = 10;
    return check_statics(bodies_, held_, load_, scales_.inverse_weight, bonds_.list(), state_.bond, state_.motion,
                         state_.contacts)
        .holds(yet_to_die_out * settings_.equilibrium_ratio);
}

// A block that a belt carries at a constant speed is balanced as well, but not at rest.
bool Simulation::carried_along() {
    return scene_.belt && fastest() > settings_.equilibrium_ratio * scene_.belt->speed;
}

double Simulation::tilt_of_base() const {
    return tilt() + (scene_.motion.empty() ? 0 : state_.motion[scene_.motion.front().block].angle);
}

void Simulation::detect_crack() {
    if (state_.first_crack || watched_.empty()) {
        return;
    }
    double widest = *settings_.crack_opening;
    for (const SharedFace& face : watched_) {
        const double opening = locate(face, state_.motion[face.block], state_.motion[face.other]).widest(face.length);
        if (opening > widest && state_.removed[face.block] == 0 && state_.removed[face.other] == 0) {
            widest = opening;
            state_.first_crack = FirstCrack{state_.time, tilt_of_base(), face.block, face.other};
        }
    }
}

void Simulation::let_blocks_leave() {
    if (!settings_.taken_away_below) {
        return;
    }
    bool changed = false;
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        const double top = bodies_.centroid[block].y() + state_.motion[block].y + bodies_.radius[block];
        if (held_[block] == 0 && top < *settings_.taken_away_below) {
            take_away(block, has_left);
            changed = true;
        }
    }
    if (changed) {
        hold_blocks();
    }
}

void Simulation::let_blocks_rest() {
    if (state_.time < last_scheduled_time(scene_, settings_)) {
        std::fill(state_.checks_at_rest.begin(), state_.checks_at_rest.end(), std::uint32_t{0});
        return;
    }
    for (std::size_t block = 0; block < bodies_.size(); ++block) {
        if (held_[block] != 0 || rests(state_.checks_at_rest[block]) || !rests(++state_.checks_at_rest[block])) {
            continue;
        }
        Motion& motion = state_.motion[block];
        state_.energy_balance.kinetic_damping += kinetic_energy_of(block);
        motion.vx = motion.vy = motion.spin = 0;
        fastest_.reset();
    }
}

}  // namespace delabole
