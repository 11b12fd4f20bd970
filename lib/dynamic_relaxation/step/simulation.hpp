// Dynamic relaxation of rigid blocks (Cundall 1971; chapter 5 of the thesis): Newton's equations of motion with
// springs, friction and dashpots at the corners, integrated explicitly until the blocks rest or fail.
//
// Time stepping is leap-frog integration of (I) with velocities half a step behind positions and a first kick half as
// long, so that free motion is exact to second order. Simulation::step shows the parts of a step.
//
// Limits: rigid blocks in plane motion; rock breaks only where a bond represents it (bonds.hpp). Explicit contact
// requires overlaps: they shift the critical tilt of a single block to tan(tilt) = b/a - (W/(k b)) sqrt(1 + (b/a)^2),
// and that of systems accordingly.
#pragma once

#include "dynamic_relaxation/blocks/block_sweep.hpp"
#include "dynamic_relaxation/contact/contact_forces.hpp"
#include "dynamic_relaxation/scene/settings.hpp"
#include "dynamic_relaxation/step/outcome.hpp"
#include "dynamic_relaxation/step/state.hpp"
#include "dynamic_relaxation/wide/team.hpp"

#include <atomic>
#include <cmath>
#include <functional>
#include <optional>
#include <span>

namespace delabole {

struct HeldByBolt;
struct StaticSolveSettings;

class Simulation {
  public:
    // The scene must be valid. A static start or a trial without corners ends before it has an answer if another
    // thread sets `stop`, which may be null: the outcome of such a run means nothing.
    Simulation(RelaxationScene scene, RelaxationSettings settings, const std::atomic<bool>* stop = nullptr);
    // Continues from a state of the same scene and settings, exact to the last bit.
    Simulation(RelaxationScene scene, RelaxationSettings settings, RelaxationState state);
    // Begins preloaded from the state in which a run of the same blocks, with other strengths or other gravity, came to
    // rest.
    Simulation(RelaxationScene scene, RelaxationSettings settings, const ConsolidatedState& from,
               const std::atomic<bool>* stop = nullptr);

    // From now on nothing ends static solves early.
    void let_finish() { stop_ = nullptr; }

    void step();
    bool running() const { return outcome() == RelaxationOutcome::undecided && !out_of_time(); }

    RelaxationOutcome outcome() const { return static_cast<RelaxationOutcome>(state_.outcome); }
    const RelaxationScene& scene() const { return scene_; }
    const RelaxationSettings& settings() const { return settings_; }
    const RelaxationState& state() const { return state_; }
    const Bodies& bodies() const { return bodies_; }
    const std::vector<Bond>& bonds() const { return bonds_.list(); }

    // s; whatever is scheduled up to this time is done now, because no later step ends nearer to it.
    double reached() const { return state_.time + state_.step / 2; }
    double tilt() const;          // of gravity, now
    double tilt_of_base() const;  // against gravity: gravity's tilt plus the rotation of fixed blocks
    std::vector<BlockOutcome> block_outcomes() const;
    EnergyBalance energy_balance() const;
    double kinetic_energy() const;
    RelaxationResult result() const;

  private:
    // Whether joints that are closed in the initial geometry have their peak strengths, or what another run left them.
    enum class JointsAtStart { whole, as_left };
    // Whether bolts pull with their pretension in a static solve, or stretch.
    enum class BoltsAtStart { pulling, stretching };

    // Holds what the public constructors have in common; each prepares the rest.
    Simulation(RelaxationState state, RelaxationScene scene, RelaxationSettings settings,
               const std::atomic<bool>* stop);

    bool stopped() const { return stop_ != nullptr && *stop_; }
    // A block that nothing has moved for some checks is at rest until the unbalanced force on it exceeds this share of
    // its weight, far below the ratio that counts as equilibrium: it is not moved, and costs almost no time.
    double rest_ratio() const { return 1e-3 * settings_.equilibrium_ratio; }
    static bool rests(std::uint32_t checks_at_rest) { return checks_at_rest >= checks_before_rest; }
    static constexpr std::uint32_t checks_before_rest = 4;

    static RelaxationState begun_at(const RelaxationState& at_rest);
    bool out_of_time() const { return reached() >= settings_.duration || state_.steps >= settings_.most_steps; }
    void prepare();
    void begin(JointsAtStart joints);
    void take_away_what_is_not_there();
    PlanePoint<> up() const { return {std::sin(tilt()), std::cos(tilt())}; }
    bool consolidating() const { return state_.time < settings_.consolidation_time; }
    double kinetic_energy_of(std::size_t block) const;  // J/m; 0 where it is held
    void hold_blocks();
    void follow_schedules();
    void break_bonds();
    StaticSolveSettings static_solve_settings() const;
    void start_in_equilibrium_with_bolts(JointsAtStart joints);
    bool start_in_equilibrium(JointsAtStart joints, BoltsAtStart bolts);
    // Returns the state left; what it took counts on.
    RelaxationState go_on_from(RelaxationState state);
    bool may_need_steps() const;
    bool solve_in_steps(bool first, std::span<const HeldByBolt> bolts, const StaticSolveSettings& limits);
    bool solve_under(double load_share, bool first, std::span<const HeldByBolt> bolts,
                     const StaticSolveSettings& limits);
    void account_for_springs_of_removed(std::size_t block);
    // `why`: taken_away or has_left.
    void take_away(std::size_t block, char why);
    void let_blocks_leave();
    double fastest();  // m/s, no point of any block is faster
    void find_contacts_where_due();
    void find_contacts_within(double margin, bool first);
    bool check_contacts();
    void check_contacts_of(std::size_t block);
    void choose_step(double last);
    void apply_contact_forces();
    void apply_loads();
    void integrate();
    void decide();
    void audit();
    void detect_crack();
    bool holds_at_rest() const;
    std::vector<double> weights() const;  // N/m, of each block; infinite where it is held
    bool corners_may_bear() const;
    bool held_by_faces();
    // Called at rest: what relies on corners on corners, and faces do not hold, has yet to rest on the other edges
    // (corner_choice.hpp). Returns whether a trial has begun or ended, so that the run has to go on.
    bool try_corners(const std::function<bool()>& faces_hold);
    bool moves_without_corners(bool forces_exist);
    bool carried_along();
    void let_blocks_rest();
    void take_velocities_away_at_peaks();

    RelaxationScene scene_;
    RelaxationSettings settings_;
    const std::atomic<bool>* stop_;
    Bodies bodies_;
    RelaxationState state_ = {};
    double margin_ = 0;        // m, of the smallest blocks
    double longest_step_ = 0;  // s, in free fall
    Team team_;
    ContactForces contact_forces_;
    Bonds bonds_;
    ContactWatch contact_watch_;
    std::vector<std::size_t> just_broken_ = {};  // bonds whose contacts are not yet found
    std::vector<SharedFace> watched_ = {};       // for the first tension crack
    std::vector<BlockForce> load_ = {};          // of the step
    bool loads_are_final_ = false;               // no further change of loads
    bool without_corners_ = false;               // a trial in which no corner bears on a corner
    BlockScales scales_ = {};
    std::vector<FacePressure> pressure_ = {};  // those of the scene that are left
    std::vector<char> held_ = {};              // fixed at present: fixed blocks, and those held for consolidation
    bool held_for_consolidation_ = false;
    std::vector<StepSums> sums_ = {};     // of the step
    std::optional<double> fastest_ = {};  // with the present velocities; empty: not yet computed
};

// Runs to the end. `watch` is called before each step and may end the run by returning false.
RelaxationResult relax(const RelaxationScene& scene, const RelaxationSettings& settings,
                       const std::function<bool(const Simulation&)>& watch = {});

}  // namespace delabole
