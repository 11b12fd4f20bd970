#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "dynamic_relaxation/scene/bolts.hpp"

#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/study/strength_reduction.hpp"
#include "dynamic_relaxation/study/study_run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace delabole {

RelaxationSettings settings_for(const RelaxationStudy& study, const StudyWork& work, const RelaxationScene& scene) {
    RelaxationSettings settings = relaxation_settings(study, scene);
    // Fewer blocks are computed before another thread has woken up.
    constexpr std::size_t blocks_worth_a_thread = 500;
    settings.threads =
        std::clamp<std::size_t>(scene.block.size() / blocks_worth_a_thread, 1, std::max(work.threads, 1U));
    return settings;
}

bool go_on(Simulation& simulation, const StudyWork& work, const std::function<bool(double)>& watch,
           const std::function<void()>& keep, const std::function<void()>& seen) {
    constexpr std::uint64_t block_steps_between_checks = 200000;
    const std::uint64_t between = std::clamp<std::uint64_t>(
        block_steps_between_checks / std::max<std::uint64_t>(1, simulation.scene().block.size()), 1, 500);
    const double duration = simulation.settings().duration;
    while (simulation.running()) {
        if (simulation.state().steps % between == 0) {
            const bool stop = !watch(simulation.state().time / duration);
            if (work.keep_due && work.keep_due()) {
                keep();
            }
            if (stop) {
                return false;
            }
        }
        seen();
        simulation.step();
    }
    return true;
}

Simulation begun_or_resumed(const RelaxationScene& scene, const RelaxationSettings& settings,
                            std::optional<RelaxationState> state, const std::atomic<bool>* stop) {
    return state ? Simulation(scene, settings, std::move(*state)) : Simulation(scene, settings, stop);
}

namespace {

bool ends_with_duration(const RelaxationStudy& study) {
    const RelaxationNumerics numerics = study.settings.value_or(RelaxationNumerics{});
    const RelaxationStop stop = numerics.stop.value_or(RelaxationStop::equilibrium);
    return numerics.watch || stop == RelaxationStop::collapse || stop == RelaxationStop::duration;
}

// Why a run has no answer; empty if it has one.
std::string_view failure_of(const RelaxationRun& made) {
    if (made.unfinished()) {
        return word_of(RelaxationOutcome::undecided);
    }
    switch (made.result.outcome) {
    case RelaxationOutcome::equilibrium:
    case RelaxationOutcome::held_by_corners:
    case RelaxationOutcome::onset:
    case RelaxationOutcome::collapse:
    case RelaxationOutcome::undecided:
        return {};
    case RelaxationOutcome::scene_not_valid:
        return word_of(made.result.fault.check);
    default:
        return word_of(made.result.outcome);
    }
}

// Numbers of blocks of a slope change with its joint spacing, and those of stages with the blocks: neither can be
// compared between runs.
RelaxationAnswer without_blocks_of_slope(RelaxationAnswer answer, const RelaxationStudy& study) {
    if (std::holds_alternative<RelaxationSlope>(study.model.scene)) {
        answer.block.clear();
    }
    if (answer.retrogression) {
        answer.retrogression->stage.clear();
    }
    return answer;
}

// The prediction from a run and a search, both with an answer.
Prediction prediction_of(const RelaxationStudy& study, const RelaxationRun& made,
                         const std::optional<CriticalAnswer>& critical) {
    std::vector<double> outputs = output_values(without_blocks_of_slope(answer_of(made), study));
    if (critical) {
        std::ranges::move(critical->values(), std::back_inserter(outputs));
    }
    return {{}, std::move(outputs), made.post_failure ? made.post_failure->left_standing : Polyline{}};
}

// Whether the blocks fail at the strength as given: by the factor of safety, if that was searched for, or by the run.
bool fails_as_given(const RelaxationRun& made, const CriticalPlan* plan,
                    const std::optional<CriticalAnswer>& critical) {
    if (plan != nullptr && plan->parameter == CriticalParameter::strength_reduction) {
        const bool found = critical->status == CriticalStatus::found;
        if (found || (critical->status == CriticalStatus::fails_everywhere && plan->lower <= 1)) {
            return !found || critical->value() < 1;
        }
        if (critical->status == CriticalStatus::stands_everywhere && plan->upper >= 1) {
            return false;
        }
    }
    return made.in_stages ? !made.stage.empty() : made.failed() || made.result.onset_time.has_value();
}

// The answer of a member of an ensemble, with critical values at the bounds at which their search ended.
EnsembleMember member_answer(const RelaxationStudy& study, const RelaxationRun& made,
                             std::optional<CriticalAnswer> critical) {
    EnsembleMember member;
    if (const std::string_view failure = failure_of(made); !failure.empty()) {
        member.prediction.failure = failure;
        return member;
    }
    std::optional<CriticalPlan> plan;
    if (critical) {
        plan = critical_plan(study);
        const CriticalStatus status = critical->worst_status();
        if (!found_or_at_bound(*plan, *critical)) {
            member.prediction.failure = word_of(status);
            return member;
        }
        member.ended_at = status == CriticalStatus::found ? std::string_view() : word_of(status);
    }
    member.fails = fails_as_given(made, plan ? &*plan : nullptr, critical);
    const auto take_at_bound = [&](PathValue& value) {
        if (value.status != CriticalStatus::found) {
            const bool stands = value.status == CriticalStatus::stands_everywhere;
            value.stands = value.fails = stands ? plan->should_fail() : plan->should_stand();
            value.status = CriticalStatus::found;
            (stands == plan->stands_low() ? member.at_upper : member.at_lower) = true;
        }
    };
    if (critical) {
        take_at_bound(*critical);
        std::ranges::for_each(critical->other, take_at_bound);
    }
    member.prediction = prediction_of(study, made, critical);
    return member;
}

// Why the slope of a study cannot be cut; empty if it can, or there is none.
std::string_view fault_of_slope(const RelaxationStudy& study) {
    const auto* slope = std::get_if<RelaxationSlope>(&study.model.scene);
    const SlopeCheck check = slope != nullptr ? slope_scene(*slope).check : SlopeCheck::valid;
    return check == SlopeCheck::valid ? std::string_view() : word_of(check);
}

EnsembleMember predict_member(const RelaxationStudy& study) {
    if (const std::string_view fault = fault_of_slope(study); !fault.empty()) {
        return {{fault, {}, {}}};
    }
    const RelaxationRun made = run(study);
    const bool searches = study.critical && failure_of(made).empty();
    return member_answer(study, made, searches ? std::optional(find_critical(study)) : std::nullopt);
}

// The prediction of a study without an ensemble. A bound is no value here: the words of the search tell it.
Prediction predict_once(const RelaxationStudy& study) {
    EnsembleMember one = predict_member(study);
    return one.ended_at.empty() ? std::move(one.prediction) : Prediction{one.ended_at, {}, {}};
}

Prediction predict(RelaxationStudy study, std::span<const Assignment> assignments) {
    assign(study.model, assignments);
    if (!in_range(study.model)) {
        return {"input_out_of_range", {}, {}};
    }
    return study.ensemble
               ? prediction_of(predict_ensemble(study, predict_member(member_of(study, 0)), predict_member, {}))
               : predict_once(study);
}

RelaxationAnswer shape_of_answer(const RelaxationStudy& study) {
    RelaxationAnswer shape{};
    shape.block.resize(number_of_blocks(study));
    shape.bolt.resize(all_bolts(study.model).size());
    if (const auto* slope = std::get_if<RelaxationSlope>(&study.model.scene)) {
        shape.post_failure.emplace();
        shape.post_failure->joint.resize(slope->joint.size());
        shape.early_failure = shape.post_failure;
    }
    if (study.retrogression) {
        shape.retrogression.emplace();
    }
    return shape;
}

// A search that ended at one of its bounds gives a bound of the output. At the critical value itself the blocks stand.
// Several paths do not say which of them ended there, and a weight does not say on which side of it the limit lies. An
// ensemble has such a word only if all its members have it.
std::vector<OutputBound> bounds_of(const CriticalPlan& plan, std::size_t output) {
    if (plan.path.size() > 1 || plan.parameter == CriticalParameter::weight) {
        return {};
    }
    const std::string_view stands = word_of(CriticalStatus::stands_everywhere);
    const std::string_view fails = word_of(CriticalStatus::fails_everywhere);
    if (plan.stands_low()) {
        return {{stands, output, at_least(plan.upper)}, {fails, output, less_than(plan.lower)}};
    }
    return {{stands, output, at_most(plan.lower)}, {fails, output, more_than(plan.upper)}};
}

std::vector<char> removed_in(const MotionFrame& frame) {
    std::vector<char> removed(frame.outcome.size());
    std::ranges::transform(frame.outcome, removed.begin(), [](const BlockOutcome& outcome) {
        return outcome.movement == BlockMovement::removed ? taken_away
               : outcome.movement == BlockMovement::left  ? has_left
                                                          : char{0};
    });
    return removed;
}

void find_early_failure(const RelaxationStudy& study, const std::vector<MotionFrame>& frames, RelaxationRun& made) {
    if (!made.post_failure || frames.empty() || made.result.failed_at_rest()) {  // of which frames show nothing
        return;
    }
    const auto at = [&](const MotionFrame& frame) {
        return post_failure_of(study, made, frame.motion, removed_in(frame));
    };
    const double half = made.post_failure->answer.failed_area / 2;
    const auto after = std::partition_point(
        frames.begin(), frames.end(), [&](const MotionFrame& frame) { return at(frame)->answer.failed_area <= half; });
    const MotionFrame& early = after == frames.begin() ? *after : *(after - 1);
    made.early_failure = at(early);
    made.early_time = early.time;
}

}  // namespace

bool has_record_of_shaking(const RelaxationStudy& study) {
    return study.model.shaking.size() > 1;
}

bool has_stages(const RelaxationStudy& study) {
    const auto* slope = std::get_if<RelaxationSlope>(&study.model.scene);
    return !study.model.removal.empty() || (slope != nullptr && !slope->stage.empty());
}

InitialContact initial_contact(const RelaxationStudy& study) {
    return std::holds_alternative<RelaxationPolygons>(study.model.scene) ? InitialContact::perhaps_none
                                                                         : InitialContact::drawn;
}

SceneFault check(const RelaxationStudy& study) {
    const RelaxationScene scene = relaxation_scene(study);
    return check(scene, relaxation_settings(study, scene));
}

RelaxationRun run(const RelaxationStudy& study, const StudyWork& work, StudyProgress& progress) {
    if (study.retrogression) {
        return run_in_stages(study, work, progress);
    }
    RelaxationRun made{relaxation_scene(study), {}, {}, {}};
    made.settings = settings_for(study, work, made.scene);
    made.result.fault = check(made.scene, made.settings);
    if (made.result.fault.check != SceneCheck::valid) {
        return made;
    }
    const bool is_slope = std::holds_alternative<RelaxationSlope>(study.model.scene);
    const bool resumed = progress.state.has_value();
    Simulation simulation = begun_or_resumed(made.scene, made.settings, std::exchange(progress.state, {}), work.stop);
    if (!resumed && work.stop != nullptr && *work.stop) {
        made = ended_at(study, simulation);
        made.result.outcome = RelaxationOutcome::interrupted;
        return made;
    }
    simulation.let_finish();
    const bool ended = go_on(
        simulation, work, [&](double share) { return !work.watch || work.watch(share); },
        [&] {
            progress.state = simulation.state();
            work.keep(progress);
        },
        [&] {
            if (study.history && simulation.reached() >= progress.next_line) {
                const double interval = study.history->interval;
                progress.history.push_back(history_line(*study.history, simulation));
                progress.next_line = (std::floor(simulation.reached() / interval) + 1) * interval;
            }
            if (work.frames == KeepFrames::yes) {
                progress.record.record(simulation);
            }
            if (is_slope) {
                progress.slope.record(simulation, FrameParts::motion);
            }
        });
    progress.state = simulation.state();
    made = ended_at(study, simulation);
    const bool rests = made.result.outcome == RelaxationOutcome::equilibrium && !made.result.onset_time;
    if (auto failed = rests ? failed_at_rest(simulation, initial_contact(study)) : std::nullopt) {
        made.result = result_of(simulation, *failed);
        made.end = std::move(failed);
        made.post_failure = post_failure_of(study, made, made.end->motion, made.end->removed);
    }
    if (study.history) {
        made.history = progress.history;
        made.history.push_back(history_line(*study.history, simulation));
    }
    if (work.frames == KeepFrames::yes) {
        MotionRecord record = progress.record;
        record.add_last(simulation);
        made.frames = std::move(record.frame);
    }
    find_early_failure(study, progress.slope.frame, made);
    if (!ended) {
        made.result.outcome = RelaxationOutcome::interrupted;
    }
    return made;
}

RelaxationRun ended_at(const RelaxationStudy& study, const Simulation& simulation) {
    RelaxationRun made{simulation.scene(), simulation.settings(), simulation.result(), {}};
    made.ends_with_duration = ends_with_duration(study);
    made.end = simulation.state();
    made.post_failure = post_failure_of(study, made, made.end->motion, made.end->removed);
    return made;
}

RelaxationRun run(const RelaxationStudy& study, const StudyWork& work) {
    StudyProgress progress;
    return run(study, work, progress);
}

RelaxationAnswer answer_of(const RelaxationRun& run) {
    RelaxationAnswer answer{run.result};
    if (run.post_failure) {
        answer.post_failure = run.post_failure->answer;
        answer.early_failure = run.early_failure.value_or(*run.post_failure).answer;
    }
    if (run.in_stages) {
        answer.retrogression = answer_of(make_bodies(run.scene), run.stage);
    }
    return answer;
}

std::optional<PostFailure> post_failure_of(const RelaxationStudy& study, const RelaxationRun& run,
                                           const std::vector<Motion>& motion, const std::vector<char>& removed) {
    if (!std::holds_alternative<RelaxationSlope>(study.model.scene) || !run.end) {
        return {};
    }
    const Bodies bodies = make_bodies(run.scene);
    std::vector<char> excavated(removed.size());
    std::vector<char> failed(removed.size());
    for (std::size_t block = 0; block < removed.size(); ++block) {
        excavated[block] = removed[block] == taken_away ? 1 : 0;
        failed[block] = removed[block] == has_left ? 1 : 0;
    }
    return post_failure({bodies, run.end->origin, motion, excavated, joint_names(study.model.scene), failed},
                        study.post_failure.value_or(PostFailureRequest{}));
}

EnsemblePrediction run_ensemble(const RelaxationStudy& study, const RelaxationRun& made,
                                const std::optional<CriticalAnswer>& critical, const RelaxationWatch& watch) {
    return predict_ensemble(study, member_answer(study, made, critical), predict_member, watch);
}

bool found_or_at_bound(const CriticalPlan& plan, const CriticalAnswer& critical) {
    const auto is_known = [&](const PathValue& value) {
        const bool at_bound =
            value.status == CriticalStatus::stands_everywhere || value.status == CriticalStatus::fails_everywhere;
        return value.status == CriticalStatus::found || (at_bound && plan.parameter != CriticalParameter::weight);
    };
    return is_known(critical) && std::ranges::all_of(critical.other, is_known);
}

std::vector<Quantity> outputs_of_run(const RelaxationStudy& study) {
    std::vector<Quantity> outputs = outputs_of(shape_of_answer(study));
    std::optional<CriticalPlan> plan;
    if (study.critical) {
        plan = critical_plan(study);
        std::ranges::move(outputs_of_search(*plan), std::back_inserter(outputs));
    }
    return study.ensemble ? outputs_of_ensemble(std::move(outputs), plan) : outputs;
}

ModelInterface model_interface(const RelaxationStudy& study) {
    ModelInterface model;
    model.inputs = inputs_of(study.model);
    model.outputs = outputs_of(without_blocks_of_slope(shape_of_answer(study), study));
    const std::size_t critical = model.outputs.size();
    std::optional<CriticalPlan> plan;
    if (study.critical) {
        plan = critical_plan(study);
        model.bounds = bounds_of(*plan, critical);
        std::ranges::move(outputs_of_search(*plan), std::back_inserter(model.outputs));
    }
    if (study.ensemble) {
        model.outputs = outputs_of_ensemble(std::move(model.outputs), plan);
        if (plan) {
            model.bounded_outputs = bounded_outputs(*plan, critical, model.outputs);
        }
    }
    model.predict = [study](std::span<const Assignment> assignments) { return predict(study, assignments); };
    model.costly = true;
    return model;
}

std::vector<double> CriticalAnswer::values() const {
    std::vector<double> found{value()};
    std::ranges::transform(other, std::back_inserter(found), [](const PathValue& one) { return one.value(); });
    if (!other.empty()) {
        const Eigen::Map<const Eigen::ArrayXd> all(found.data(), static_cast<Eigen::Index>(found.size()));
        const double spread = all.maxCoeff() - all.minCoeff();
        const double deviation = (all - value()).matrix().norm() / std::sqrt(static_cast<double>(other.size()));
        found.insert(found.end(), {spread, deviation});
    }
    return found;
}

CriticalStatus CriticalAnswer::worst_status() const {
    if (status != CriticalStatus::found) {
        return status;
    }
    const auto bad =
        std::ranges::find_if(other, [](const PathValue& one) { return one.status != CriticalStatus::found; });
    return bad == other.end() ? CriticalStatus::found : bad->status;
}

}  // namespace delabole
