// Input of a relaxation case beyond its scene: numerical settings, a critical value, a history; and the answer of a
// run.
#pragma once

#include "dynamic_relaxation/scene/relaxation_parameters.hpp"
#include "dynamic_relaxation/step/history.hpp"
#include "dynamic_relaxation/step/simulation.hpp"
#include "dynamic_relaxation/study/critical.hpp"
#include "dynamic_relaxation/study/critical_request.hpp"
#include "dynamic_relaxation/study/ensemble.hpp"
#include "dynamic_relaxation/study/post_failure.hpp"
#include "dynamic_relaxation/study/retrogression.hpp"
#include "parameters/model_interface.hpp"

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

namespace delabole {

enum class RelaxationStop { equilibrium, onset, collapse, duration, rest };

enum class OffOn { off, on };

// RelaxationSettings explains each member; unset: the value there, or that of the quality.
struct RelaxationNumerics {
    std::optional<RelaxationQuality> quality;
    std::optional<double> stiffness_ratio;
    std::optional<double> step_fraction;
    std::optional<double> time_step;
    std::optional<double> viscous_damping;
    std::optional<double> local_damping;
    std::optional<OffOn> kinetic_damping;
    std::optional<OffOn> mass_scaling;
    std::optional<RelaxationStart> start;
    std::optional<double> ramp_time;
    std::optional<double> consolidation_time;
    std::optional<double> equilibrium_ratio;
    std::optional<double> onset_rotation;
    std::optional<double> onset_slide;
    std::optional<double> collapse_rotation;
    std::optional<double> collapse_displacement;
    std::optional<RelaxationStop> stop;
    std::optional<double> duration;
    std::optional<double> watch;
    std::optional<double> most_steps;
    std::optional<double> taken_away_below;
    std::optional<double> crack_opening;
    std::optional<double> overlap_limit;
    std::optional<OffOn> corners_bear;
    static constexpr auto fields() {
        using N = RelaxationNumerics;
        constexpr RelaxationSettings standard{};
        return FieldTable{
            section<&N::quality>("sets step_fraction, stiffness_ratio and equilibrium_ratio where they are absent; "
                                 "absent: standard"),
            absent_is(accuracy_of(RelaxationQuality::standard).stiffness_ratio,
                      number<&N::stiffness_ratio>(within(1e3, 1e10),
                                                  "normal stiffness times width over weight of the heaviest block")),
            absent_is(standard.step_fraction,
                      number<&N::step_fraction>(within(0.01, 0.8), "share of the greatest stable step")),
            number<&N::time_step>(Dimension::time, more_than(0),
                                  "divided where it is more than the share of the stable step; absent: the share"),
            absent_is(standard.viscous_damping,
                      number<&N::viscous_damping>(within(0, 2), "dashpots of contacts, share of critical")),
            absent_is(standard.local_damping,
                      number<&N::local_damping>(
                          right_open(0, 1),
                          "share of the unbalanced force that acts against the velocity: failing blocks "
                          "accelerate that much less; 0 with a record of shaking, unless given")),
            section<&N::kinetic_damping>("all velocities to zero at energy peaks; absent: off"),
            section<&N::mass_scaling>(
                "light blocks have the inertia of heavy ones: quicker to equilibrium, motion wrong; absent: off"),
            section<&N::start>("springs at the start; absent: preloaded"),
            absent_is(standard.ramp_time, number<&N::ramp_time>(Dimension::time, at_least(0), "of a ramped start")),
            absent_is(standard.consolidation_time,
                      number<&N::consolidation_time>(Dimension::time, at_least(0),
                                                     "in which blocks held at first do not move")),
            absent_is(standard.equilibrium_ratio,
                      number<&N::equilibrium_ratio>(between(0, 1), "greatest unbalanced force over weight at rest")),
            absent_is(standard.onset_rotation,
                      number<&N::onset_rotation>(Dimension::angle, more_than(0), "more is onset of failure")),
            absent_is(standard.onset_slide,
                      number<&N::onset_slide>(more_than(0), "displacement in block radii, likewise")),
            absent_is(standard.collapse_rotation,
                      number<&N::collapse_rotation>(Dimension::angle, more_than(0), "more is collapse")),
            absent_is(standard.collapse_displacement,
                      number<&N::collapse_displacement>(more_than(0), "in block radii, likewise")),
            section<&N::stop>("what ends the run: equilibrium or a collapse; onset, equilibrium or a collapse; a "
                              "collapse alone; the duration, whether or not there is a verdict; or rest, where "
                              "collapsed blocks, too, lie still; absent: equilibrium"),
            absent_is(standard.duration, number<&N::duration>(Dimension::time, more_than(0), "longest model time")),
            number<&N::watch>(Dimension::time, more_than(0),
                              "model time for which motion is followed whatever comes of it, past equilibrium, onset "
                              "and collapse, in place of stop and duration; absent: the run ends at its verdict"),
            absent_is(static_cast<double>(standard.most_steps),
                      number<&N::most_steps>(within(1, 1e12), "longest run, a whole number")),
            number<&N::taken_away_below>(Dimension::length,
                                         "level in the section; a block that comes to lie below it has left the slope "
                                         "and is removed; absent: all stay"),
            number<&N::crack_opening>(more_than(0),
                                      "in shortest edges; neighbours that part by more show the first tension crack; "
                                      "absent: 0.01 for rows and stepped bases, none looked for else"),
            absent_is(standard.overlap_limit,
                      number<&N::overlap_limit>(within(0.02, 1), "of the shortest edge; a run with more is stopped")),
            section<&N::corners_bear>(
                "whether blocks that rest only because corners bear on corners are in equilibrium, as blocks of steel "
                "are, rather than held_by_corners, which no search takes for standing; absent: off")};
    }
};

struct RelaxationStudy {
    Relaxation model;
    std::optional<RelaxationNumerics> settings;
    std::optional<CriticalRequest> critical;
    std::optional<HistoryRequest> history;
    std::optional<PostFailureRequest> post_failure;
    std::optional<RetrogressionRequest> retrogression;
    std::optional<EnsembleRequest> ensemble;

    static constexpr std::string_view kind = "relaxation";
    static constexpr auto fields() {
        using S = RelaxationStudy;
        return FieldTable{
            inlined(&S::model, "blocks, joints and loads"),
            section<&S::settings>("numerical settings, none of them a property of the rock"),
            section<&S::critical>("value between standing and failing"),
            section<&S::history>("tables over time"),
            section<&S::post_failure>("when a block of a jointed slope counts as failed, and a joint as open"),
            section<&S::retrogression>("of a jointed slope: what fails is taken away until the rest stands; absent: "
                                       "the blocks are followed as they move"),
            section<&S::ensemble>("of a jointed slope: numbers are means over several that differ by chance")};
    }
};

RelaxationScene relaxation_scene(const RelaxationStudy& study);
// Number of the scene's blocks, including fixed ones. Values may be out of their ranges; a slope that cannot be cut has
// no blocks.
std::size_t number_of_blocks(const RelaxationStudy& study);
RelaxationSettings relaxation_settings(const RelaxationStudy& study);
// The same settings for a study whose scene is given, so that a slope is not cut again.
RelaxationSettings relaxation_settings(const RelaxationStudy& study, const RelaxationScene& scene);
// The stiffness ratio of the settings, or of their quality. Joints that give their own stiffness do not follow it.
double stiffness_ratio_of(const RelaxationStudy& study);

// The result as outputs: numbers that a run does not have are infinite or 0.
struct RelaxationAnswer : RelaxationResult {
    static constexpr double infinite = std::numeric_limits<double>::infinity();
    std::optional<PostFailureAnswer> post_failure = {};     // of a jointed slope
    std::optional<PostFailureAnswer> early_failure = {};    // of a jointed slope
    std::optional<RetrogressionAnswer> retrogression = {};  // if requested

    double onset() const { return onset_time.value_or(infinite); }
    double crack_time() const { return first_crack ? first_crack->time : infinite; }
    double crack_tilt() const { return first_crack ? first_crack->tilt : infinite; }
    double crack_block() const {
        return first_crack ? static_cast<double>(std::min(first_crack->block, first_crack->other) + 1) : 0;
    }
    double crack_neighbour() const {
        return first_crack ? static_cast<double>(std::max(first_crack->block, first_crack->other) + 1) : 0;
    }
    double bonds_broken() const { return static_cast<double>(broken_bonds); }
    double unbalanced_at_start() const { return start_balance ? start_balance->unbalanced_ratio : infinite; }
    double greatest_overlap() const { return deepest ? deepest->overlap : 0; }
    double overlap_area() const { return overlap ? overlap->area : 0; }
    double steps() const { return static_cast<double>(cost.steps); }
    double contacts_evaluated() const { return static_cast<double>(cost.contacts_evaluated); }
    double time_step() const { return cost.step; }
    static constexpr auto fields() {
        using R = RelaxationAnswer;
        return FieldTable{
            section<&R::outcome>("how the run ended"),
            number("onset_time", &R::onset, Dimension::time, any_number(),
                   "of failure; infinite: no onset; 0: the blocks rest, but not as drawn"),
            number<&R::time>(Dimension::time, "model time at the end"),
            number("tilt", &R::tilt_of_base, Dimension::angle, any_number(),
                   "of gravity and a turned base together, at the end"),
            number<&R::crack_time>(Dimension::time, "of the first tension crack; infinite: none seen"),
            number<&R::crack_tilt>(Dimension::angle,
                                   "of gravity and a turned base together at that time; infinite: none seen"),
            number<&R::crack_block>("number of the lower block beside it; 0: none seen"),
            number<&R::crack_neighbour>("number of the other; 0: none seen"),
            number("broken_bonds", &R::bonds_broken, Dimension::ratio, any_number(), "bonds that broke"),
            number<&R::unbalanced_at_start>("greatest unbalanced force on a block, with moment over radius, over its "
                                            "load in a preloaded start; infinite: not preloaded"),
            number<&R::unbalanced_ratio>("greatest unbalanced force on a block over its weight at the end"),
            number<&R::greatest_overlap>(Dimension::length, "of a corner and an edge at the end"),
            number<&R::overlap_area>(Dimension::area,
                                     "that two blocks have in common, of the two that lay deepest in each other"),
            section("energy", &R::energy_balance, "the energy balance"),
            number<&R::steps>("time steps made"),
            number<&R::time_step>(Dimension::time, "the last one"),
            number<&R::contacts_evaluated>("contact forces computed in all"),
            section<&R::post_failure>("what of the slope has failed and what is left standing"),
            section<&R::early_failure>("the same while no more than half of that area had failed: crest cracks and "
                                       "movements before the crest itself goes"),
            section<&R::retrogression>("masses that failed one after the other"),
            section<&R::block>("each block at the end"),
            section<&R::bolt>("each bolt at the end")};
    }
};

// Called from time to time with the share of the work done, 0 to 1; if it returns false, the work ends as interrupted.
using RelaxationWatch = std::function<bool(double share)>;

// The state of the search on one path so far.
struct SearchProgress {
    std::vector<CriticalProbe> probe = {};             // verdicts, in their order
    std::optional<RelaxationState> probe_state = {};   // of the run in progress, if any
    std::optional<RelaxationState> consolidated = {};  // from which runs begin; absent on other paths, or until found
    std::optional<RelaxationState> failed = {};  // after the last verdict that the blocks fail; absent if by statics
};

// All results of a study so far, from which it continues exact to the last bit.
struct StudyProgress {
    std::optional<RelaxationState> state = {};  // of the run at the case's own values; absent before its first step
    double next_line = 0;                       // s of model time, of the next line of the history
    RelaxationHistory history = {};
    MotionRecord record = {};
    MotionRecord slope = {};                  // motion of a jointed slope
    std::vector<FailureStage> stage = {};     // finished stages of retrogression; `state` is of the next one
    std::vector<SearchProgress> search = {};  // on the paths of the plan that have begun
};

// Frames take memory and time: they are kept only for pictures of moving blocks.
enum class KeepFrames { no, yes };

// How a study is run. The answer does not depend on it, except on a watch that ends the work.
struct StudyWork {
    RelaxationWatch watch = {};
    KeepFrames frames = KeepFrames::no;
    unsigned threads = 1;
    const std::atomic<bool>* stop = nullptr;  // ends a static start, which calls no watch; may be null
    std::function<bool()> keep_due = {};      // called after each call of the watch
    std::function<void(const StudyProgress&)> keep = {};
};

struct RelaxationRun {
    RelaxationScene scene;
    RelaxationSettings settings;
    RelaxationResult result;
    RelaxationHistory history;                  // empty if none is requested
    std::vector<MotionFrame> frames = {};       // empty if none are kept
    std::optional<RelaxationState> end{};       // absent if the scene is not valid
    std::optional<PostFailure> post_failure{};  // of a jointed slope, at the end
    // State at the last of some dozens of times, spread evenly over the run, at which no more than half of the finally
    // failed area had failed.
    std::optional<PostFailure> early_failure{};
    double early_time = 0;              // s
    bool ends_with_duration = false;    // the duration is the intended end, also of an undecided run
    bool in_stages = false;             // by retrogression
    std::vector<FailureStage> stage{};  // failed stages of retrogression; `end` and `result` are of the run after them

    bool failed() const { return is_failure(result.outcome); }
    // Whether the run reached its limit of time or steps before the requested end: a verdict, or blocks at rest.
    bool unfinished() const {
        const bool out_of_steps = result.cost.steps >= settings.most_steps;
        const bool to_rest = settings.stop_at_equilibrium && !settings.stop_at_collapse;
        return result.outcome == RelaxationOutcome::undecided
                   ? !ends_with_duration || out_of_steps
                   : to_rest && failed() && (out_of_steps || result.time + result.cost.step >= settings.duration);
    }
};

// Makes the same checks as relax().
SceneFault check(const RelaxationStudy& study);

// The run at the case's own values, continued from `progress`; afterwards `progress` holds the complete run.
RelaxationRun run(const RelaxationStudy& study, const StudyWork& work, StudyProgress& progress);
RelaxationRun run(const RelaxationStudy& study, const StudyWork& work = {});

RelaxationAnswer answer_of(const RelaxationRun& run);

// The part of a slope that has failed at a given time of a run. Empty for other scenes.
std::optional<PostFailure> post_failure_of(const RelaxationStudy& study, const RelaxationRun& run,
                                           const std::vector<Motion>& motion, const std::vector<char>& removed);

// The search `critical`, which must be set, with its omitted values filled in.
CriticalPlan critical_plan(const RelaxationStudy& study);

// Whether blocks are removed during the run.
bool has_stages(const RelaxationStudy& study);
// Whether the ground's acceleration changes with time. When blocks have come to rest the record is over: it has to act
// at each value that a search tries.
bool has_record_of_shaking(const RelaxationStudy& study);

// The critical value that a search found on one path.
struct PathValue : CriticalValue {
    LoadingPath path = LoadingPath::consolidated;
    std::optional<double> consolidated_at = {};  // value at which the blocks came to rest; absent on other paths
    // The run at `fails`, to onset or until it is held by corners; absent if no run failed.
    std::optional<RelaxationRun> failed = {};
};

// The answer on the first path of the plan, with those on the other paths.
struct CriticalAnswer : PathValue {
    std::vector<PathValue> other = {};

    // Values of the outputs of the search, in the order of outputs_of_search; requires that all paths have found one.
    std::vector<double> values() const;
    // The first status that is not `found`.
    CriticalStatus worst_status() const;
};

// The search `critical` on the paths of its plan, continued from `progress`. Each run begins from the initial geometry
// or from the consolidated state, never from another run: their order makes no difference.
CriticalAnswer find_critical(const RelaxationStudy& study, const StudyWork& work, StudyProgress& progress);
CriticalAnswer find_critical(const RelaxationStudy& study, const StudyWork& work = {});

// A run that tells whether the ratio found depends on the loading path: 2 % below the one at which the blocks were
// found to stand, from a consolidated state, on the path `preloaded`, which has no history.
struct OtherPath {
    double value;
    bool stands;
};
// Nothing where the search was on other paths, too, or on another one, found no value, or this run reached no verdict
// in twice as many steps as the runs of the search, at least a thousand.
std::optional<OtherPath> try_other_path(const RelaxationStudy& study, const CriticalAnswer& found,
                                        const StudyWork& work = {});

// Whether the ratio found depends on the stiffness of the joints, which is seldom known: 5 % below the one at which at
// most 200 blocks were found to stand, they fail with joints of a tenth of it. Returns that value; nothing if they
// stand, or as above.
std::optional<double> fails_if_softer(const RelaxationStudy& study, const CriticalAnswer& found,
                                      const StudyWork& work = {});

// All outputs of a run, as named numbers.
std::vector<Quantity> outputs_of_run(const RelaxationStudy& study);

// Names of the outputs of a search: the critical value and, if there are several paths, that on each of the others
// ("factor_of_safety_gravity"), the spread ("factor_of_safety_spread") and the deviation of the others from the first
// (path_deviation_prefix).
std::vector<Quantity> outputs_of_search(const CriticalPlan& plan);

// Whether a value is known on each path, if only by the bound beyond which it lies. A weight may lie on either side of
// its bounds.
bool found_or_at_bound(const CriticalPlan& plan, const CriticalAnswer& critical);

// Runs the ensemble of the study, which must have one. The run and the search of its first member are given. `watch`
// receives the share done.
EnsemblePrediction run_ensemble(const RelaxationStudy& study, const RelaxationRun& made,
                                const std::optional<CriticalAnswer>& critical, const RelaxationWatch& watch);

// Inputs: every number of the study's model. Outputs: every number of RelaxationAnswer and, if requested, those of the
// search; for a jointed slope the ground left standing is the predicted profile. A run that was stopped, or stayed
// undecided although it was to find equilibrium, is a failed prediction under the name of its outcome; a critical value
// that was not found is one under the name of its status. With an ensemble the outputs are those of
// outputs_of_ensemble.
ModelInterface model_interface(const RelaxationStudy& study);

}  // namespace delabole
