// Dynamic relaxation: how the run ended, its energy balance and each block, for reports.
#include "cases/program/case/model_cases.hpp"
#include "cases/program/models/relaxation/checkpoint_file.hpp"
#include "cases/program/models/relaxation/critical_report.hpp"
#include "cases/program/models/relaxation/ensemble_report.hpp"
#include "cases/program/models/relaxation/figures.hpp"
#include "cases/program/reader/units.hpp"
#include "cases/program/results/model_reports.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "dynamic_relaxation/study/strength_bound.hpp"
#include "dynamic_relaxation/study/strength_reduction.hpp"
#include "dynamic_relaxation/study/study_run.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/atomic_file.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace delabole {

namespace {

// Share of the work, for the progress shown, that a run takes beside a search.
constexpr double share_of_run = 0.2;

std::string block_name(std::size_t index) {
    return "block " + std::to_string(index + 1);
}

// Empty if the run ended as intended.
std::string run_in_words(const RelaxationRun& made) {
    if (made.unfinished()) {
        return std::string(made.failed() ? "the blocks failed but did not come to rest within "
                                         : "the blocks neither came to rest nor failed within ") +
               (made.result.cost.steps >= made.settings.most_steps
                    ? std::to_string(made.settings.most_steps) + " steps: raise settings.most_steps"
                    : value_in_words(made.settings.duration, Dimension::time) + ": raise settings.duration");
    }
    switch (made.result.outcome) {
    case RelaxationOutcome::interrupted:
        return "the run ended at " + value_in_words(made.result.time, Dimension::time) + " of model time";
    case RelaxationOutcome::overlap_too_large: {
        std::string text = "stopped because an overlap passed settings.overlap_limit";
        if (made.result.overlap && made.result.overlap->share > made.settings.overlap_limit) {
            const BlockOverlap& overlap = *made.result.overlap;
            return text + ": " + block_name(overlap.block) + " and " + block_name(overlap.other) + " lie " +
                   value_in_words(overlap.depth, Dimension::length) + " deep in each other, over " +
                   value_in_words(overlap.area, Dimension::area);
        }
        if (made.result.deepest) {
            const ContactName& contact = *made.result.deepest;
            text += ": corner " + std::to_string(contact.corner + 1) + " of " + block_name(contact.block) +
                    " is in face " + std::to_string(contact.edge + 1) + " of " + block_name(contact.other) + " by " +
                    value_in_words(contact.overlap, Dimension::length);
        }
        return text;
    }
    case RelaxationOutcome::energy_not_balanced:
        return "the energy balance has a residual of " +
               number_in_words(100 * made.result.energy_balance.residual_share()) +
               " % of the energy converted, more than the " + number_in_words(100 * most_energy_lacking) +
               " % that are accepted: lower settings.step_fraction";
    case RelaxationOutcome::motion_not_finite:
        return "stopped because the motion diverged (non-finite): lower settings.step_fraction";
    default:
        return {};
    }
}

// If time steps were divided, the mean step is shorter than the given one.
void append_divided_step_warning(const RelaxationRun& made, Analysis& analysis) {
    const std::optional<double>& given = made.settings.time_step;
    const std::uint64_t steps = made.result.cost.steps;
    constexpr double rounding = 1e-9;
    if (!given || steps == 0 || made.result.time >= (1 - rounding) * *given * static_cast<double>(steps)) {
        return;
    }
    analysis.warnings.push_back("settings.time_step, " + value_in_words(*given, Dimension::time) +
                                ", is longer than springs and dashpots bear and was divided: steps of " +
                                value_in_words(made.result.time / static_cast<double>(steps), Dimension::time) +
                                " in the mean were made");
}

// Saves a study's progress in the checkpoint at intervals, and when the work is told to end.
class Keeper {
  public:
    Keeper(const AnalysisWork& work, const RelaxationStudy& study, KeepFrames frames)
        : work_(work), study_(study), frames_(frames) {}

    bool goes_on(double share, const std::string& what, bool may_end_sooner = false) {
        ended_ = work_.watch && !work_.watch(share, what, may_end_sooner);
        return !ended_;
    }
    bool due() const {
        return !work_.checkpoint.empty() && (ended_ || Clock::now() - last_ >= work_.between_checkpoints);
    }
    void keep(const StudyProgress& progress) {
        write_checkpoint(work_.checkpoint, study_, frames_, progress);
        last_ = Clock::now();
    }
    StudyProgress take_up() const {
        if (work_.checkpoint.empty()) {
            return {};
        }
        KeptProgress kept = read_checkpoint(work_.checkpoint, study_, frames_);
        if (kept.of_other) {
            throw OutputError(work_.checkpoint,
                              "what an interrupted run has left there " + kept.refusal +
                                  ", and would be lost: run that one to its end, remove the file, or name another "
                                  "folder (--out)");
        }
        if (work_.say && !kept.refusal.empty()) {
            work_.say("warning: " + work_.checkpoint.string() + ' ' + kept.refusal + ": the run starts anew");
        } else if (work_.say && kept.found) {
            work_.say("going on from " + work_.checkpoint.string());
        }
        return std::move(kept.progress);
    }

  private:
    using Clock = std::chrono::steady_clock;

    const AnalysisWork& work_;
    const RelaxationStudy& study_;
    KeepFrames frames_;
    bool ended_ = false;
    Clock::time_point last_ = Clock::now();
};

// Whether any free block was still present at the end.
bool any_free_block_left(const RelaxationRun& made) {
    for (std::size_t block = 0; block < made.scene.block.size(); ++block) {
        if (!made.scene.block[block].fixed && made.end->removed[block] == 0) {
            return true;
        }
    }
    return false;
}

// Points on inclined faces are given to some digits.
bool is_in_or_on(const Polygon<>& convex, const PlanePoint<>& point) {
    const double near = 0.01 * std::sqrt(area_properties(convex).area);
    for (std::size_t corner = 0; corner < convex.size(); ++corner) {
        const PlanePoint<> along = convex[(corner + 1) % convex.size()] - convex[corner];
        if (left_of(along).dot(point - convex[corner]) < -near * along.norm()) {
            return false;
        }
    }
    return true;
}

// Warns of narrow joints that would have had cohesion or tensile strength had they been drawn closed.
void append_warning_of_open_joints(const RelaxationScene& scene, Analysis& analysis) {
    constexpr double narrow = 20 * closed_joint;
    const Bodies bodies = make_bodies(scene);
    std::size_t open = 0;
    double widest = 0;
    std::pair<std::size_t, std::size_t> blocks;
    for (const SharedFace& face : find_shared_faces(bodies, narrow)) {
        const JointMaterial joint = joint_between(scene, bodies, face.edge, face.other_edge);
        const auto [at_start, at_end] = opening_in_drawing(bodies, face);
        const double opening = std::max(at_start, at_end);
        if ((joint.cohesion == 0 && joint.tensile_strength == 0) ||
            !(opening > opening_of_closed_joint(bodies, face.block, face.other))) {
            continue;
        }
        ++open;
        blocks = opening > widest ? std::pair<std::size_t, std::size_t>(face.block, face.other) : blocks;
        widest = std::max(widest, opening);
    }
    if (open > 0) {
        analysis.warnings.push_back(
            number_in_words(static_cast<double>(open)) + (open == 1 ? " joint is" : " joints are") +
            " open in the initial geometry, by up to " + value_in_words(widest, Dimension::length) + " (" +
            block_name(blocks.first) + " and " + block_name(blocks.second) +
            "), and so without cohesion and tensile strength: joints count as closed up to a thousandth of the "
            "shortest edge of their blocks");
    }
}

// Warns where the two faces of a joint have different strengths and neither is the weaker one in all of them.
void append_warning_of_unlike_faces(const RelaxationScene& scene, Analysis& analysis) {
    const Bodies bodies = make_bodies(scene);
    const std::vector<SharedFace> faces = find_shared_faces(bodies);
    const auto is_unlike = [&](const SharedFace& face) {
        const JointMaterial& one = scene.material[bodies.material[face.edge]];
        const JointMaterial& two = scene.material[bodies.material[face.other_edge]];
        return !holds_at_least(one, two) && !holds_at_least(two, one);
    };
    if (const auto first = std::ranges::find_if(faces, is_unlike); first != faces.end()) {
        analysis.warnings.push_back("the joints of the faces at which " + block_name(first->block) + " and " +
                                    block_name(first->other) +
                                    " touch differ, and neither is the weaker one in every strength: the lesser value "
                                    "of each counts, which is on the safe side");
    }
}

// Warns of differences between the start of the run and the initial geometry, and of forces on fixed blocks or outside
// their blocks.
void append_start_warnings(const RelaxationRun& made, Analysis& analysis) {
    for (std::size_t index = 0; index < made.scene.force.size(); ++index) {
        const PointForce& force = made.scene.force[index];
        const RelaxationBlock& block = made.scene.block[force.block];
        if (block.fixed) {
            analysis.warnings.push_back(indexed("force", index) + " has no effect: " + block_name(force.block) +
                                        " is fixed");
        } else if (!is_in_or_on(block.outline, force.at)) {
            analysis.warnings.push_back(indexed("force", index) + " acts outside " + block_name(force.block) +
                                        ", as if by a lever");
        }
    }
    const std::optional<StartBalance>& start = made.result.start_balance;
    if (start && start->cut_short && start->unbalanced_ratio > made.settings.equilibrium_ratio) {
        analysis.warnings.push_back("the static solve of the start was ended early, with a block out of balance by " +
                                    number_in_words(100 * start->unbalanced_ratio) +
                                    " % of its load: at first they settle, as if dropped");
    }
    append_warning_of_open_joints(made.scene, analysis);
    append_warning_of_unlike_faces(made.scene, analysis);
    if (std::ranges::none_of(made.scene.block, &RelaxationBlock::fixed) && !made.scene.belt) {
        analysis.warnings.emplace_back("no block is fixed: all of them fall");
    }
    // Fraction of the block's radius. The deformation of springs is less, as is the displacement of blocks that slide
    // or rotate until equilibrium.
    constexpr double unexpected = 5e-3;
    std::size_t farthest = 0;
    double greatest = 0;
    const Bodies bodies = make_bodies(made.scene);
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        const Motion& origin = made.end->origin[block];
        const double share = std::hypot(origin.x, origin.y) / bodies.radius[block];
        if (share > greatest) {
            greatest = share;
            farthest = block;
        }
    }
    if (greatest > unexpected) {
        analysis.warnings.push_back(
            "the static solve of the start closed gaps of the initial geometry, or found equilibrium only elsewhere: " +
            block_name(farthest) + " begins " + value_in_words(greatest * bodies.radius[farthest], Dimension::length) +
            " from where it is drawn; displacements count from there");
    }
}

void append_run_warnings(const RelaxationRun& made, Analysis& analysis) {
    append_start_warnings(made, analysis);
    append_divided_step_warning(made, analysis);
    const RelaxationResult& result = made.result;
    if (result.outcome == RelaxationOutcome::equilibrium && result.onset_time.value_or(0) > 0) {
        analysis.warnings.push_back("the blocks came to rest only after the onset of failure at " +
                                    value_in_words(*result.onset_time, Dimension::time) +
                                    ": this is equilibrium of another shape than the initial geometry");
    }
    if (result.outcome == RelaxationOutcome::equilibrium && !any_free_block_left(made)) {
        analysis.warnings.emplace_back("all free blocks have been taken away: nothing is left to move");
    }
    if (made.ends_with_duration && made.settings.local_damping > 0 && !made.scene.belt && result.onset_time) {
        analysis.warnings.push_back("local damping slows what fails by " +
                                    number_in_words(100 * made.settings.local_damping) +
                                    " %: settings.local_damping = 0 gives motion in true time");
    }
    constexpr double large_residual = 0.02;
    const double residual = result.energy_balance.residual_share();
    if (std::abs(residual) > large_residual) {
        analysis.warnings.push_back("the energy balance is off by " + number_in_words(100 * residual) +
                                    " % of the energy that was turned over: lower settings.step_fraction");
    }
}

// Greatest number of blocks for which the bound is computed: it takes 25 s for 478 blocks.
constexpr std::size_t most_blocks_in_programme = 500;

bool is_small_enough(const RelaxationScene& scene) {
    return static_cast<std::size_t>(std::ranges::count(scene.block, false, &RelaxationBlock::fixed)) <=
           most_blocks_in_programme;
}

constexpr std::string_view corners_hold =
    "only because corners bear on corners: faces alone do not hold them. Corners "
    "of rock crush or chip: this is no evidence that the slope stands. Where a joint ends in a corner of other blocks, "
    "as at the toe of a slope with level ground in front of it, blocks cannot slide out: lower that ground a little to "
    "see them move, or set settings.corners_bear = \"on\" to count on corners";

// The bound applies only if the strength of all joints is reduced equally.
std::optional<double> bound_of_statics(const RelaxationStudy& study, const CriticalPlan& plan,
                                       const RelaxationScene& scene) {
    if (plan.parameter != CriticalParameter::strength_reduction || !is_small_enough(scene) ||
        materials_of_joints(study.model.scene, scene, plan.joint).size() < scene.material.size()) {
        return std::nullopt;
    }
    const std::optional<double> bound = greatest_strength_reduction(scene, &interrupt_flag());
    answer_interrupt();
    // No strength holds what touches nothing as drawn.
    return initial_contact(study) == InitialContact::perhaps_none && bound == 0.0 ? std::nullopt : bound;
}

void append_bound_of_statics(const RelaxationStudy& study, const RelaxationScene& scene, double bound,
                             const CriticalAnswer& critical, Analysis& analysis) {
    analysis.outputs.push_back({"critical.bound_of_statics",
                                "greatest factor at which faces can take forces in equilibrium, on whatever path",
                                Dimension::ratio, bound, false});
    constexpr double model_error = 0.01;  // blocks rotate and joints deform before they fail
    constexpr double well_below = 0.95;
    const auto is_brittle = [&](std::size_t index) {
        const JointMaterial& joint = scene.material[index];
        return joint.residual_cohesion < joint.cohesion ||
               joint.residual_friction_angle.value_or(joint.friction_angle) < joint.friction_angle;
    };
    if (critical.status == CriticalStatus::found && critical.value() < well_below * bound &&
        std::ranges::any_of(make_bodies(scene).material, is_brittle)) {
        analysis.warnings.push_back("statics finds forces up to a factor of " + number_in_words(bound) +
                                    ": joints lose strength where they slip first, and what they held is left to the "
                                    "rest; residual_cohesion and residual_friction_angle of a joint are what it keeps");
    }
    if (critical.status == CriticalStatus::found && critical.value() > (1 + model_error) * bound) {
        const bool may_be_apart = initial_contact(study) == InitialContact::perhaps_none;
        analysis.warnings.push_back("beyond a factor of " + number_in_words(bound) + " the blocks rest " +
                                    (may_be_apart ? "on blocks that they did not touch as drawn, or " : std::string()) +
                                    std::string(corners_hold));
    }
}

std::string joint_key(const RelaxationStudy& study, std::size_t material) {
    if (std::holds_alternative<RelaxationPolygons>(study.model.scene) ||
        std::holds_alternative<RelaxationSlope>(study.model.scene)) {
        return indexed("scene.joint", material);
    }
    return material == 0 ? "scene.interface" : "scene.base";
}

}  // namespace

RelaxationStudyAnswer analyse_case(const RelaxationStudy& study, const AnalysisWork& work) {
    RelaxationStudyAnswer answer;
    if (const auto* slope = std::get_if<RelaxationSlope>(&study.model.scene)) {
        answer.slope = slope_scene(*slope);
    }
    const std::size_t blocks = answer.slope ? answer.slope->block.size() : number_of_blocks(study);
    const double of_first = study.ensemble ? 1 / study.ensemble->runs : 1;
    const double share = of_first * (study.critical ? share_of_run : 1);
    StudyWork how{.threads = work.threads, .stop = &interrupt_flag()};
    how.frames = blocks <= most_drawn_blocks && !study.retrogression ? KeepFrames::yes : KeepFrames::no;
    Keeper keeper(work, study, how.frames);
    const bool to_its_end = study.settings.value_or(RelaxationNumerics{}).watch.has_value();
    how.watch = [&](double done) { return keeper.goes_on(share * done, "dynamic relaxation", !to_its_end); };
    how.keep_due = [&] { return keeper.due(); };
    how.keep = [&](const StudyProgress& now) { keeper.keep(now); };
    StudyProgress progress = keeper.take_up();
    answer.run = run(study, how, progress);
    const RelaxationOutcome outcome = answer.run.result.outcome;
    if (outcome == RelaxationOutcome::scene_not_valid) {
        return answer;
    }
    if (study.critical && outcome != RelaxationOutcome::interrupted) {
        // The nearer to the critical value, the longer a verdict takes: the pace does not tell the time left.
        how.watch = [&](double done) {
            return keeper.goes_on(share + (of_first - share) * done,
                                  human_name(name_of_critical(parameter_of(*study.critical))), true);
        };
        answer.plan = critical_plan(study);
        answer.critical = find_critical(study, how, progress);
        const StudyWork last_of_all{.watch = [&](double) { return how.watch(1); }, .stop = how.stop};
        answer.other_path = try_other_path(study, *answer.critical, last_of_all);
        answer.fails_if_softer = fails_if_softer(study, *answer.critical, last_of_all);
        answer.bound_of_statics = bound_of_statics(study, *answer.plan, answer.run.scene);
    }
    const bool has_answer = outcome != RelaxationOutcome::interrupted && run_in_words(answer.run).empty() &&
                            (!answer.critical || found_or_at_bound(*answer.plan, *answer.critical));
    if (study.ensemble && has_answer) {
        answer.ensemble = run_ensemble(study, answer.run, answer.critical,
                                       [&](double done) { return keeper.goes_on(done, "the slopes of the ensemble"); });
    }
    return answer;
}

std::string failure_in(const RelaxationStudyAnswer& answer) {
    const RelaxationResult& result = answer.run.result;
    return result.outcome == RelaxationOutcome::scene_not_valid ? std::string(word_of(result.fault.check))
                                                                : std::string();
}

Analysis named_outputs(const RelaxationStudy& study, const RelaxationStudyAnswer& answer) {
    Analysis analysis;
    const RelaxationRun& made = answer.run;
    append_outputs(analysis, answer_of(made));
    if (made.result.tilt == 0) {
        for (NamedOutput& output : analysis.outputs) {
            output.detail = output.detail || output.name == "tilt" || output.name == "crack_tilt";
        }
    }
    if (answer.slope) {
        append_cutting_warnings(std::get<RelaxationSlope>(study.model.scene), *answer.slope, answer.run.scene.material,
                                answer.plan, analysis);
    }
    const auto leave_unfinished = [&](std::string_view status, std::string why) {
        if (analysis.unfinished.empty() && !why.empty()) {
            analysis.status = status;
            analysis.unfinished = std::move(why);
        }
    };
    leave_unfinished(word_of(made.unfinished() ? RelaxationOutcome::undecided : made.result.outcome),
                     run_in_words(made));
    if (answer.critical) {
        append_critical(analysis, answer);
        if (answer.bound_of_statics) {
            append_bound_of_statics(study, answer.run.scene, *answer.bound_of_statics, *answer.critical, analysis);
        }
        if (!answer.ensemble) {
            leave_unfinished(word_of(answer.critical->worst_status()), search_in_words(*answer.plan, *answer.critical));
        }
    }
    append_run_warnings(made, analysis);
    if (made.result.outcome == RelaxationOutcome::held_by_corners) {
        const auto held =
            std::ranges::count(made.result.block, BlockMovement::held_by_corners, &BlockOutcome::movement);
        analysis.warnings.push_back("the blocks rest " + std::string(corners_hold) + ". Without them " +
                                    std::to_string(held) + (held == 1 ? " block" : " blocks") + " would move");
    }
    if (answer.has_means()) {
        take_means(study, answer, analysis);
    } else if (answer.ensemble) {
        leave_unfinished(answer.ensemble->failure, ensemble_failure_in_words(answer));
    }
    return analysis;
}

void append_case_figures(const RelaxationStudy& study, const RelaxationStudyAnswer& answer, const Sheet& sheet) {
    const RelaxationRun& made = answer.run;
    append_frames(made, sheet);
    append_bolt_forces(made, sheet);
    if (answer.critical) {
        append_critical_figures(*answer.plan, *answer.critical, sheet);
    }
    append_post_failure(std::get_if<RelaxationSlope>(&study.model.scene), made, sheet);
    append_block_figures(made, sheet);
    if (answer.slope) {
        append_section_figure(std::get<RelaxationSlope>(study.model.scene), *answer.slope, sheet);
    }
    if (study.history) {
        append_history(*study.history, made, sheet);
    }
}

void append_mechanism_figures(const RelaxationStudy& at_best, const MechanismFit&, const FitProblem&,
                              const Sheet& sheet) {
    append_block_figures(run(at_best), sheet);
}

Impossibility impossibility(const RelaxationStudy& study, std::string_view) {
    const SceneFault fault = check(study);
    Impossibility found = stated_impossibility(RelaxationStudy::kind, word_of(fault.check));
    if (found.keys.empty()) {
        return {{"scene"}, "the scene is not valid: " + human_name(word_of(fault.check))};
    }
    // The words and keys contain these placeholders.
    const std::array<std::pair<std::string_view, std::string>, 5> open{
        {{"{number}", std::to_string(fault.index + 1)},
         {"{block}", block_name(fault.index)},
         {"{other block}", block_name(fault.other.value_or(0))},
         {"{joint}", joint_key(study, fault.index)},
         {"{blocks}",
          fault.check == SceneCheck::unknown_block ? std::to_string(relaxation_scene(study).block.size()) : ""}}};
    const auto fill = [&](std::string& text) {
        for (const auto& [name, value] : open) {
            if (const std::size_t at = text.find(name); at != std::string::npos) {
                text.replace(at, name.size(), value);
            }
        }
    };
    fill(found.words);
    std::ranges::for_each(found.keys, fill);
    return found;
}

}  // namespace delabole
