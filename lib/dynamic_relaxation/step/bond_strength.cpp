#include "dynamic_relaxation/step/bond_strength.hpp"

#include "dynamic_relaxation/step/loads.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace delabole {

namespace {

// `settles`: not yet at rest, but much slower than before.
enum class Standing { rests, settles, creeps, failed, run_failed, interrupted };

class WeakeningSlope {
  public:
    WeakeningSlope(const RelaxationScene& scene, const RelaxationSettings& settings, const StrengthReduction& reduction,
                   const std::function<bool()>& watch)
        : given_(scene.bond_material),
          settings_(settings),
          reduction_(reduction),
          watch_(watch),
          bodies_(make_bodies(scene)),
          failed_distance_((reduction.failed_distance + reduction.loose_distance) / 2) {
        settings_.stop_at_onset = false;
        settings_.stop_at_equilibrium = true;
        settings_.collapse_rotation = settings_.collapse_displacement = std::numeric_limits<double>::infinity();
        made_.end.scene = scene;
        made_.end.unbroken.resize(scene.block.size());
    }

    // Continues the run with bonds of this share of their strength until the slope rests or has failed.
    Standing settle(double share, double longest_run) {
        ++made_.runs;
        weaken(share);
        settings_.duration = made_.end.state.time + longest_run;
        late_ = made_.end.state.time + longest_run / 2;
        fastest_early_ = fastest_late_ = 0;
        while (true) {
            made_.end.state.outcome = static_cast<std::uint64_t>(RelaxationOutcome::undecided);
            Simulation simulation = begun_ ? Simulation(made_.end.scene, settings_, std::move(made_.end.state))
                                           : Simulation(made_.end.scene, settings_);
            begun_ = true;
            const std::uint64_t steps_before = simulation.state().steps;
            const bool has_loose_block = run_until_loose(simulation);
            made_.steps += simulation.state().steps - steps_before;
            made_.end.state = simulation.state();
            if (interrupted_) {
                return Standing::interrupted;
            }
            if (moved_area(made_.end.state) > reduction_.failed_area) {
                return Standing::failed;
            }
            if (has_loose_block) {
                take_loose_blocks_away();
                continue;
            }
            if (rests_) {
                return Standing::rests;
            }
            switch (simulation.outcome()) {
            case RelaxationOutcome::equilibrium:
            case RelaxationOutcome::held_by_corners:
                return Standing::rests;
            case RelaxationOutcome::undecided:
            case RelaxationOutcome::onset:  // the slope has moved, and its time is over
                ++made_.creeping;
                return fastest_late_ < fastest_early_ / 2 ? Standing::settles : Standing::creeps;
            default:
                return Standing::run_failed;
            }
        }
    }

    // Takes the present state as the unbroken one: displacements count from here, and runs begin here.
    void take_as_unbroken() {
        made_.end.unbroken = made_.end.state.motion;
        unbroken_ = made_.end;
        failed_distance_ = reduction_.failed_distance;
    }
    void go_back_to_unbroken() { made_.end = unbroken_; }

    // The next share in the sequence at which the present load breaks a bond; empty if there is none down to the
    // weakest.
    std::optional<double> next_breaking(double share) {
        while (share * reduction_.ratio >= reduction_.weakest) {
            share *= reduction_.ratio;
            weaken(share);
            const std::vector<Bond> bonds = make_bonds(made_.end.scene, bodies_, settings_.viscous_damping);
            for (std::size_t index = 0; index < bonds.size(); ++index) {
                const SharedFace& face = bonds[index].face;
                const std::vector<Motion>& motion = made_.end.state.motion;
                if (made_.end.state.bond[index].state == BondState::whole &&
                    loading_of(bonds[index], locate(face, motion[face.block], motion[face.other])).worst() > 1) {
                    return share;
                }
            }
        }
        return std::nullopt;
    }

    CriticalStrength& made() { return made_; }

  private:
    void weaken(double share) {
        for (std::size_t index = 0; index < given_.size(); ++index) {
            made_.end.scene.bond_material[index].tensile_strength = share * given_[index].tensile_strength;
            made_.end.scene.bond_material[index].cohesion = share * given_[index].cohesion;
        }
    }

    bool is_free(const RelaxationState& state, std::size_t block) const {
        return bodies_.fixed[block] == 0 && state.removed[block] == 0;
    }

    bool has_moved(const RelaxationState& state, std::size_t block, double distance) const {
        const Motion& now = state.motion[block];
        const Motion& then = made_.end.unbroken[block];
        return is_free(state, block) && std::hypot(now.x - then.x, now.y - then.y) > distance;
    }

    bool is_loose(const RelaxationState& state, std::size_t block) const {
        return has_moved(state, block, reduction_.loose_distance);
    }

    double moved_area(const RelaxationState& state) const {
        double area = 0;
        for (std::size_t block = 0; block < bodies_.size(); ++block) {
            if (has_moved(state, block, failed_distance_)) {
                area += bodies_.mass[block] / made_.end.scene.block[block].density;
            }
        }
        return area;
    }

    // Mass-weighted root mean square of the free blocks' velocity.
    double speed(const RelaxationState& state) const {
        double mass = 0;
        double sum = 0;
        for (std::size_t block = 0; block < bodies_.size(); ++block) {
            if (is_free(state, block)) {
                const Motion& motion = state.motion[block];
                mass += bodies_.mass[block];
                sum += bodies_.mass[block] * (motion.vx * motion.vx + motion.vy * motion.vy);
            }
        }
        return mass > 0 ? std::sqrt(sum / mass) : 0;
    }

    bool run_until_loose(Simulation& simulation) {
        constexpr std::uint64_t steps_between_checks = 100;
        // An oscillating slope is at rest for an instant now and then.
        constexpr int checks_before_rest = 5;
        const double scheduled = last_scheduled_time(made_.end.scene, settings_);
        int checks_at_rest = 0;
        rests_ = false;
        while (simulation.running()) {
            simulation.step();
            const RelaxationState& state = simulation.state();
            if (state.steps % steps_between_checks != 0) {
                continue;
            }
            if (watch_ && !watch_()) {
                interrupted_ = true;
                return false;
            }
            if (moved_area(state) > reduction_.failed_area) {
                return false;
            }
            for (std::size_t block = 0; block < bodies_.size(); ++block) {
                if (is_loose(state, block)) {
                    return true;
                }
            }
            const double speed_now = speed(state);
            double& fastest = state.time < late_ ? fastest_early_ : fastest_late_;
            fastest = std::max(fastest, speed_now);
            checks_at_rest = state.time > scheduled && speed_now < reduction_.rest_speed ? checks_at_rest + 1 : 0;
            if (checks_at_rest == checks_before_rest) {
                checks_at_rest = 0;
                if (!simulation.try_corners()) {
                    rests_ = true;
                    return false;
                }
            }
        }
        return false;
    }

    void take_loose_blocks_away() {
        for (std::size_t block = 0; block < bodies_.size(); ++block) {
            if (is_loose(made_.end.state, block)) {
                made_.end.loose.push_back(block);
                made_.end.scene.removal.push_back({block, made_.end.state.time});
            }
        }
    }

    std::vector<BondMaterial> given_;
    RelaxationSettings settings_;
    StrengthReduction reduction_;
    const std::function<bool()>& watch_;
    Bodies bodies_;
    double failed_distance_;  // m; larger while the unbroken slope settles than for a slope that breaks
    CriticalStrength made_ = {};
    ReducedSlope unbroken_ = {};
    bool begun_ = false;
    bool interrupted_ = false;
    bool rests_ = false;
    double late_ = 0;           // s, when the second half of the run begins
    double fastest_early_ = 0;  // m/s, in the first half
    double fastest_late_ = 0;
};

// Status of the search if a run did not come to rest.
StrengthStatus status_of(Standing standing, StrengthStatus failed) {
    switch (standing) {
    case Standing::interrupted:
        return StrengthStatus::interrupted;
    case Standing::run_failed:
        return StrengthStatus::run_failed;
    default:
        return failed;
    }
}

// Whether the unbroken slope stands; if not, the search is over.
bool begins(WeakeningSlope& slope, const StrengthReduction& reduction) {
    CriticalStrength& made = slope.made();
    const Standing standing = slope.settle(reduction.strongest, reduction.longest_run / 2);
    if (standing != Standing::rests && standing != Standing::settles) {
        made.status = status_of(standing, StrengthStatus::fails_however_strong);
        made.stands = std::numeric_limits<double>::infinity();
        made.fails = reduction.strongest;
        return false;
    }
    slope.take_as_unbroken();
    made.stands = reduction.strongest;
    return true;
}

}  // namespace

double ReducedSlope::displacement(std::size_t block) const {
    return std::hypot(state.motion[block].x - unbroken[block].x, state.motion[block].y - unbroken[block].y);
}

CriticalStrength find_critical_strength(const RelaxationScene& scene, const RelaxationSettings& settings,
                                        const StrengthReduction& reduction, const std::function<bool()>& watch) {
    WeakeningSlope slope(scene, settings, reduction, watch);
    CriticalStrength& made = slope.made();
    if (!begins(slope, reduction)) {
        return std::move(made);
    }
    double share = reduction.strongest;
    while (const std::optional<double> next = slope.next_breaking(share)) {
        // The slope also stands at the share before: either no bond broke there, or it was tried.
        made.stands = *next / reduction.ratio;
        share = *next;
        const Standing standing = slope.settle(share, reduction.longest_run);
        if (standing != Standing::rests) {
            made.status = status_of(standing, StrengthStatus::found);
            made.fails = share;
            return std::move(made);
        }
        slope.go_back_to_unbroken();
    }
    made.status = StrengthStatus::stands_however_weak;
    made.stands = reduction.weakest;
    return std::move(made);
}

CriticalStrength run_at_strength(const RelaxationScene& scene, const RelaxationSettings& settings,
                                 const StrengthReduction& reduction, double share, const std::function<bool()>& watch) {
    WeakeningSlope slope(scene, settings, reduction, watch);
    CriticalStrength& made = slope.made();
    if (!begins(slope, reduction)) {
        return std::move(made);
    }
    const Standing standing = slope.settle(share, reduction.longest_run);
    if (standing == Standing::rests) {
        made.status = StrengthStatus::stands_however_weak;
        made.stands = share;
    } else {
        made.status = status_of(standing, StrengthStatus::found);
        made.fails = share;
    }
    return std::move(made);
}

CrackPath crack_path(const ReducedSlope& slope) {
    struct Turned {
        PlanePoint<> at;
        double by;
    };
    const Bodies bodies = make_bodies(slope.scene);
    const std::vector<Bond> bonds = make_bonds(slope.scene, bodies, 0);
    CrackPath path;
    std::vector<Turned> turned;
    double sum = 0;
    double most = 0;
    for (std::size_t index = 0; index < bonds.size(); ++index) {
        if (!is_broken(slope.state.bond[index].state)) {
            continue;
        }
        ++path.broken;
        const SharedFace& face = bonds[index].face;
        const double turn = std::abs(slope.state.motion[face.block].angle - slope.state.motion[face.other].angle);
        turned.push_back({bodies.centroid[face.other] + face.other_arm, turn});
        sum += turn;
        most = std::max(most, turn);
    }
    if (path.broken < 2 || !(sum > 0)) {
        return path;
    }
    for (const Turned& bond : turned) {
        path.middle += bond.by / sum * bond.at;
    }
    double xx = 0;
    double xy = 0;
    double yy = 0;
    for (const Turned& bond : turned) {
        const PlanePoint<> arm = bond.at - path.middle;
        xx += bond.by * arm.x() * arm.x();
        xy += bond.by * arm.x() * arm.y();
        yy += bond.by * arm.y() * arm.y();
    }
    // The principal axis of greatest spread does not depend on whether the crack crosses columns or follows them.
    path.inclination = std::atan2(2 * xy, xx - yy) / 2;
    const PlanePoint<> along(std::cos(path.inclination), std::sin(path.inclination));
    double first = 0;
    double last = 0;
    constexpr double counts = 0.1;
    for (const Turned& bond : turned) {
        if (bond.by > counts * most) {
            const double place = along.dot(bond.at - path.middle);
            first = std::min(first, place);
            last = std::max(last, place);
        }
    }
    path.length = last - first;
    return path;
}

}  // namespace delabole
