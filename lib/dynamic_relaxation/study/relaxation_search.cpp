// Searches for a critical value: the scene at each value, and the loading path to it.
#include "dynamic_relaxation/step/loads.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/study/failed_at_rest.hpp"
#include "dynamic_relaxation/study/runs_ahead.hpp"
#include "dynamic_relaxation/study/strength_reduction.hpp"
#include "dynamic_relaxation/study/study_run.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace delabole {

namespace {

constexpr double own_ratio = 1;  // of strength or weight, as given in the case

// Whether a run that ended shows that the blocks do not stand.
bool shows_failure(RelaxationOutcome outcome) {
    return is_failure(outcome) || outcome == RelaxationOutcome::held_by_corners;
}

// How many runs a search makes ahead. Threads save more time so than within a run, whose statics uses only one of them,
// unless there are very many blocks.
std::size_t runs_ahead(const StudyWork& work, const RelaxationScene& scene) {
    constexpr std::size_t very_many = 5000;
    return scene.block.size() < very_many ? std::max(work.threads, 1U) - 1 : 0;
}

class PathSearch {
  public:
    PathSearch(const RelaxationStudy& study, const CriticalPlan& plan, LoadingPath path, const StudyWork& work,
               StudyProgress& whole, SearchProgress& progress)
        : study_(study),
          plan_(plan),
          path_(path),
          work_(work),
          whole_(whole),
          progress_(progress),
          scene_(relaxation_scene(study)),
          reduced_(materials_of_joints(study.model.scene, scene_, plan.joint)),
          settings_(settings_for(study, work, scene_)),
          ahead_(runs_ahead(work, scene_), [this](double value, const std::atomic<bool>& stop) {
              return run_at(value, Needed::verdict, {}, &stop, [&](Simulation& simulation) {
                  const auto goes_on = [&](double) { return !stop; };
                  return go_on(
                             simulation, {}, goes_on, [] {}, [] {}) &&
                         !stop;
              });
          }) {
        // A search needs neither the motion after onset nor the time until then.
        settings_.stop_at_onset = true;
        settings_.creep = initial_contact(study) == InitialContact::drawn || !any_is_drawn_apart(scene_);
        settings_.stop_at_equilibrium = true;
        if (path_ == LoadingPath::preloaded || path_ == LoadingPath::gravity || path_ == LoadingPath::sudden) {
            for (Removal& removal : scene_.removal) {
                removal.time = -1;
            }
            settings_.start = start_of_path();
        }
        // Statics decides on these paths and does not depend on inertia: light blocks need not shorten the steps.
        settings_.mass_scaling =
            settings_.mass_scaling || path_ == LoadingPath::consolidated || path_ == LoadingPath::preloaded;
    }

    PathValue find() {
        PathValue value = searched();
        take_up_failed(value);
        count_costs(value);
        return value;
    }

    // A single run from the initial geometry, of so many steps at most.
    CriticalProbe run_once(double value, std::uint64_t most_steps) {
        settings_.most_steps = std::min(settings_.most_steps, static_cast<std::size_t>(most_steps));
        return probe_at(value, Needed::run);
    }

    void multiply_stiffness(double factor) {
        for (JointMaterial& material : scene_.material) {
            material.normal_stiffness *= factor;
            material.shear_stiffness *= factor;
        }
    }

    // Sets the watch, which receives the share of the path's work done, including that of the present run.
    void tell(const std::function<bool(double)>& watch) { watch_ = watch; }

  private:
    enum class Needed { verdict, run };  // statics may give the verdict without a run

    PathValue searched() {
        PathValue value;
        value.path = path_;
        double should_stand = plan_.should_stand();
        if (path_ == LoadingPath::consolidated) {
            if (!consolidate(value)) {
                return value;
            }
            const double at = *value.consolidated_at;
            should_stand = at >= plan_.lower && at <= plan_.upper ? at : should_stand;
        }
        CriticalValue& found = value;
        const double should_fail = should_stand == plan_.should_fail() ? plan_.should_stand() : plan_.should_fail();
        found = bisect(should_stand, should_fail);
        if (plan_.has_two_limits() && found.status == CriticalStatus::fails_everywhere) {
            found = bisect(should_fail, should_stand);
            const std::vector<double> between = values_between();
            for (auto at = between.begin(); at != between.end() && found.status == CriticalStatus::fails_everywhere;
                 ++at) {
                found = bisect(*at, should_fail);
            }
        } else if (plan_.has_two_limits() && found.status == CriticalStatus::stands_everywhere &&
                   should_stand != plan_.should_stand()) {
            const CriticalValue other = bisect(should_stand, plan_.should_stand());
            const bool tells = other.status == CriticalStatus::found || other.status == CriticalStatus::interrupted;
            found = tells ? other : found;
        }
        return value;
    }

    CriticalValue bisect(double from, double to) {
        const auto search = [&](const CriticalSearchProbe& probe) {
            return find_critical(probe, from, to, plan_.tolerance,
                                 plan_.is_ratio() ? BracketMean::geometric : BracketMean::arithmetic);
        };
        std::vector<CriticalProbe> verdicts;
        const std::size_t threads = std::exchange(settings_.threads, ahead_.most() > 0 ? 1 : settings_.threads);
        const CriticalValue found = search([&](double at) {
            if (const auto known = standing_.find(at); known != standing_.end()) {
                return verdicts.emplace_back(known->second);
            }
            if (ahead_.most() > 0 && runs_ == progress_.probe.size()) {
                std::vector<double> next = asked_next(search, verdicts, ahead_.most());
                std::erase_if(next, [&](double value) { return standing_.contains(value); });
                ahead_.make(at, next);
            }
            const CriticalProbe made = probe_at(at, Needed::verdict);
            if (made.outcome == RelaxationOutcome::equilibrium) {
                standing_.emplace(at, made);
            }
            return verdicts.emplace_back(made);
        });
        ahead_.stop();
        settings_.threads = threads;
        return found;
    }

    RelaxationStart start_of_path() const {
        switch (path_) {
        case LoadingPath::sudden:
            return RelaxationStart::dropped;
        case LoadingPath::gravity:
            return settings_.start == RelaxationStart::ramped ? RelaxationStart::ramped : RelaxationStart::stepped;
        default:
            return RelaxationStart::preloaded;
        }
    }

    RelaxationScene scene_at(double value) const {
        RelaxationScene scene = scene_;
        switch (plan_.parameter) {
        case CriticalParameter::tilt:
            scene.gravity.tilt = scene.gravity.final_tilt = value;
            scene.gravity.rate = 0;
            break;
        case CriticalParameter::friction:
            for (JointMaterial& material : scene.material) {
                material.friction_angle = value;
                material.residual_friction_angle.reset();
            }
            break;
        case CriticalParameter::strength_reduction:
            return with_reduced_strength(std::move(scene), reduced_, value);
        case CriticalParameter::weight:
            scene.gravity.acceleration *= value;
            break;
        }
        return scene;
    }

    // The values at which the blocks may come to rest first, in the order in which they are tried. Blocks that do not
    // stand as given are kept as near to failure as those that do: they rest at the greatest of 1/2, 1/4, ... at which
    // they can, since forces that jam them would stay from a strength far greater than their own.
    std::vector<double> consolidation_values() const {
        std::vector<double> values;
        if (!plan_.is_ratio() || plan_.upper < own_ratio) {
            values.push_back(plan_.should_stand());
        } else {
            for (double ratio = own_ratio; ratio > plan_.lower; ratio /= 2) {
                values.push_back(ratio);
            }
            values.push_back(std::min(plan_.lower, own_ratio));
        }
        if (plan_.has_two_limits()) {
            std::vector<double> further = values_between();
            further.insert(further.begin(), {plan_.lower, plan_.upper});
            std::ranges::copy_if(further, std::back_inserter(values),
                                 [&](double value) { return std::ranges::find(values, value) == values.end(); });
        }
        return values;
    }

    // Blocks that fail at both bounds may stand between them. The values are tried in this order.
    std::vector<double> values_between() const {
        std::vector<double> values;
        const double own = plan_.is_ratio() ? own_ratio : scene_.gravity.tilt;
        if (own > plan_.lower && own < plan_.upper) {
            values.push_back(own);
        }
        for (const double share : {0.5, 0.25, 0.75, 0.125, 0.375, 0.625, 0.875}) {
            values.push_back(plan_.is_ratio() ? plan_.lower * std::pow(plan_.upper / plan_.lower, share)
                                              : plan_.lower + share * (plan_.upper - plan_.lower));
        }
        return values;
    }

    // Returns false, and sets the status, if the blocks come to rest at none of these.
    bool consolidate(PathValue& value) {
        constexpr std::size_t long_enough = 100'000;  // steps; at their very limit blocks creep for longer
        const bool may_be_cut = last_scheduled_time(scene_, settings_) <= 0;
        const std::vector<double> values = consolidation_values();
        const std::size_t given = settings_.most_steps;
        std::optional<CriticalValue> undecided;  // the first
        for (const double at : values) {
            settings_.most_steps = may_be_cut && at != values.back() ? std::min(given, long_enough) : given;
            const CriticalProbe probe = probe_at(at, Needed::verdict);
            settings_.most_steps = given;
            if (probe.outcome == RelaxationOutcome::equilibrium) {
                value.consolidated_at = at;
                standing_.emplace(at, probe);
                return true;
            }
            static_cast<CriticalValue&>(value) = find_critical([&](double) { return probe; }, at, at, plan_.tolerance);
            // A stronger slope may come to rest even if blocks of this one crushed each other.
            if (value.status == CriticalStatus::interrupted || value.status == CriticalStatus::not_valid) {
                return false;
            }
            if (value.status == CriticalStatus::undecided && !undecided) {
                undecided = value;
            }
        }
        static_cast<CriticalValue&>(value) = undecided.value_or(value);
        return false;
    }

    CriticalProbe probe_at(double value, Needed needed) {
        const std::size_t number = runs_++;
        if (number < progress_.probe.size()) {
            return progress_.probe[number];
        }
        const double expected = 5 + std::ceil(std::log2(std::max(2.0, (plan_.upper - plan_.lower) / plan_.tolerance)));
        const auto goes_on = [&](double share) {
            return !watch_ || watch_(std::min(1.0, (static_cast<double>(number) + share) / expected));
        };
        const auto waits = [&] {
            const bool on = goes_on(0);
            if (work_.keep_due && work_.keep_due()) {
                work_.keep(whole_);
            }
            return on;
        };
        std::optional<SearchRun> made = needed == Needed::verdict ? ahead_.take(value, waits) : std::nullopt;
        bool kept = false;
        if (!made) {
            const std::atomic<bool>* stop = progress_.probe_state ? nullptr : work_.stop;
            made = run_at(value, needed, std::exchange(progress_.probe_state, {}), stop, [&](Simulation& simulation) {
                if (stop != nullptr && *stop) {
                    return false;
                }
                simulation.let_finish();
                const auto keep = [&] {
                    progress_.probe_state = simulation.state();
                    work_.keep(whole_);
                    progress_.probe_state.reset();
                    kept = true;
                };
                return go_on(simulation, work_, goes_on, keep, [] {});
            });
        }
        const CriticalProbe& probe = made->probe;
        if (probe.outcome == RelaxationOutcome::interrupted) {
            if (!kept) {
                waits();
            }
            return probe;
        }
        if (probe.without_run || shows_failure(probe.outcome)) {
            progress_.failed = std::move(made->end);
        } else if (probe.outcome == RelaxationOutcome::equilibrium && path_ == LoadingPath::consolidated &&
                   !progress_.consolidated) {
            progress_.consolidated = std::move(made->end);
        }
        return progress_.probe.emplace_back(probe);
    }

    // The run begins from the consolidated state, if there is one, or goes on from `state`. `advance` takes it to its
    // end, or returns false.
    SearchRun run_at(double value, Needed needed, std::optional<RelaxationState> state, const std::atomic<bool>* stop,
                     const std::function<bool(Simulation&)>& advance) const {
        const RelaxationScene scene = scene_at(value);
        if (check(scene, settings_).check != SceneCheck::valid) {
            return {{RelaxationOutcome::scene_not_valid, 0}};
        }
        if (stop != nullptr && *stop) {
            return {{RelaxationOutcome::interrupted, 0}};
        }
        if (needed == Needed::verdict && !state && fails_by_statics(scene, settings_, initial_contact(study_))) {
            return {{RelaxationOutcome::onset, 0, 0, false, false, true}};
        }
        Simulation simulation = begun(scene, std::move(state), stop);
        const bool ended = advance(simulation);
        const RelaxationResult result = simulation.result();
        const RelaxationCost& cost = result.cost;
        if (!ended) {
            return {{RelaxationOutcome::interrupted, cost.steps, cost.contacts_evaluated}};
        }
        const bool balanced =
            result.start_balance && result.start_balance->unbalanced_ratio <= settings_.equilibrium_ratio;
        const RelaxationState* begun_at = progress_.consolidated ? &*progress_.consolidated : nullptr;
        std::optional<RelaxationState> failed = failed_at_rest(simulation, initial_contact(study_), begun_at);
        const RelaxationOutcome outcome = failed ? RelaxationOutcome::onset : simulation.outcome();
        const std::vector<Motion> unmoved(scene.block.size());
        constexpr double near_onset = 0.5;
        const MotionExtremes moved =
            farthest_motion(simulation.bodies(), simulation.state(), begun_at ? begun_at->motion : unmoved);
        const bool crept = balanced && moved.in_thresholds(settings_) > near_onset;
        return {{outcome, cost.steps, cost.contacts_evaluated, !balanced, crept},
                failed ? std::move(failed) : simulation.state()};
    }

    // A run that continues from a state may take as long as one from the start.
    RelaxationSettings settings_of_run() const {
        RelaxationSettings settings = settings_;
        if (progress_.consolidated) {
            settings.duration += progress_.consolidated->time;
        }
        return settings;
    }

    Simulation begun(const RelaxationScene& scene, std::optional<RelaxationState> state,
                     const std::atomic<bool>* stop) const {
        const RelaxationSettings settings = settings_of_run();
        return state                    ? Simulation(scene, settings, std::move(*state))
               : progress_.consolidated ? Simulation(scene, settings, ConsolidatedState{*progress_.consolidated}, stop)
                                        : Simulation(scene, settings, stop);
    }

    void count_costs(CriticalValue& value) const {
        value.runs = value.steps = value.contacts_evaluated = 0;
        for (const CriticalProbe& probe : progress_.probe) {
            value.runs += probe.without_run ? 0 : 1;
            value.steps += probe.steps;
            value.contacts_evaluated += probe.contacts_evaluated;
        }
    }

    // Gives the run that failed at the value found, which is still to be made where statics gave the verdict.
    void take_up_failed(PathValue& value) {
        if (value.status != CriticalStatus::found && value.status != CriticalStatus::fails_everywhere) {
            return;
        }
        const double at = value.status == CriticalStatus::found ? value.fails : value.last;
        if (!progress_.failed) {
            const RelaxationOutcome outcome = probe_at(at, Needed::run).outcome;
            value.held_by_corners = outcome == RelaxationOutcome::held_by_corners;
            value.status = outcome == RelaxationOutcome::interrupted ? CriticalStatus::interrupted : value.status;
        }
        if (progress_.failed) {
            RelaxationRun run{scene_at(at), settings_of_run(), {}, {}};
            const Simulation simulation(run.scene, run.settings, *progress_.failed);
            run.result = simulation.result();
            run.end = *progress_.failed;
            run.post_failure = post_failure_of(study_, run, run.end->motion, run.end->removed);
            value.failed = std::move(run);
        }
    }

    const RelaxationStudy& study_;
    const CriticalPlan& plan_;
    LoadingPath path_;
    const StudyWork& work_;
    StudyProgress& whole_;
    SearchProgress& progress_;
    RelaxationScene scene_;
    std::vector<std::size_t> reduced_;  // materials whose strength a search for the factor of safety divides
    RelaxationSettings settings_;
    std::function<bool(double)> watch_ = {};
    std::size_t runs_ = 0;
    // The probes of this search that stood. Those that failed are made again where they are asked for again: the last
    // one that failed is the one at the value reported.
    std::map<double, CriticalProbe> standing_ = {};
    RunsAhead ahead_;  // destroyed first: its runs read the other members
};

// A run from the initial geometry at a share of the ratio found to stand, with joints of a share of their stiffness, in
// twice as many steps as the runs of the search, at least a thousand. Interrupted where no ratio was found.
std::pair<double, RelaxationOutcome> tried_below(const RelaxationStudy& study, const CriticalPlan& plan,
                                                 LoadingPath path, const CriticalAnswer& found, double share,
                                                 double stiffness, const StudyWork& of_search) {
    const double value = found.stands < found.fails ? share * found.stands : found.stands / share;
    if (found.status != CriticalStatus::found) {
        return {value, RelaxationOutcome::interrupted};
    }
    constexpr std::uint64_t fewest_steps = 1000;
    constexpr std::uint64_t without_runs = 2;  // values tried over runs made, about
    const StudyWork work{.watch = of_search.watch, .stop = of_search.stop};
    StudyProgress whole;
    SearchProgress progress;
    PathSearch search(study, plan, path, work, whole, progress);
    search.multiply_stiffness(stiffness);
    return {value, search.run_once(value, std::max(without_runs * found.steps, fewest_steps)).outcome};
}

}  // namespace

CriticalAnswer find_critical(const RelaxationStudy& study, const StudyWork& work, StudyProgress& progress) {
    const CriticalPlan plan = critical_plan(study);
    const auto paths = static_cast<double>(plan.path.size());
    CriticalAnswer answer;
    for (std::size_t index = 0; index < plan.path.size(); ++index) {
        if (progress.search.size() == index) {
            progress.search.emplace_back();
        }
        PathSearch search(study, plan, plan.path[index], work, progress, progress.search[index]);
        if (work.watch) {
            search.tell([&](double share) { return work.watch((static_cast<double>(index) + share) / paths); });
        }
        PathValue value = search.find();
        const bool interrupted = value.status == CriticalStatus::interrupted;
        if (index == 0) {
            static_cast<PathValue&>(answer) = std::move(value);
        } else {
            answer.other.push_back(std::move(value));
        }
        if (interrupted) {
            break;
        }
    }
    return answer;
}

std::optional<OtherPath> try_other_path(const RelaxationStudy& study, const CriticalAnswer& found,
                                        const StudyWork& work) {
    const CriticalPlan plan = critical_plan(study);
    if (found.path != LoadingPath::consolidated || plan.path.size() != 1 || !plan.is_ratio()) {
        return std::nullopt;
    }
    const auto [value, outcome] = tried_below(study, plan, LoadingPath::preloaded, found, 0.98, 1, work);
    const bool stands = outcome == RelaxationOutcome::equilibrium;
    return stands || shows_failure(outcome) ? std::optional(OtherPath{value, stands}) : std::nullopt;
}

std::optional<double> fails_if_softer(const RelaxationStudy& study, const CriticalAnswer& found,
                                      const StudyWork& work) {
    constexpr std::size_t few_blocks = 200;
    const CriticalPlan plan = critical_plan(study);
    if (!plan.is_ratio() || relaxation_scene(study).block.size() > few_blocks) {
        return std::nullopt;
    }
    const auto [value, outcome] = tried_below(study, plan, found.path, found, 0.95, 0.1, work);
    return shows_failure(outcome) ? std::optional(value) : std::nullopt;
}

CriticalAnswer find_critical(const RelaxationStudy& study, const StudyWork& work) {
    StudyProgress progress;
    return find_critical(study, work, progress);
}

}  // namespace delabole
