#include "dynamic_relaxation/study/retrogression.hpp"

#include "dynamic_relaxation/blocks/shared_faces.hpp"
#include "dynamic_relaxation/step/rotation_share.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/study/post_failure.hpp"
#include "dynamic_relaxation/study/strength_bound.hpp"
#include "dynamic_relaxation/study/strength_reduction.hpp"
#include "dynamic_relaxation/study/study_run.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace delabole {

namespace {

// Adds a block to the stage. The members hold areas until all blocks are added, and shares of their sum afterwards.
void add_block(const Bodies& bodies, const FailureStage& stage, std::size_t index, RetrogressionStage& sum) {
    const std::size_t block = stage.block[index];
    const Motion& start = stage.start[block];
    const Motion& onset = stage.onset[block];
    const double area = area_of(bodies, block);
    const double rotation = onset.angle - start.angle;
    const double displacement = std::hypot(onset.x - start.x, onset.y - start.y);
    constexpr double farthest_pivot = 2;  // in radii
    const bool turns =
        index < stage.moved && displacement <= farthest_pivot * bodies.radius[block] * std::abs(rotation);
    sum.blocks += 1;
    sum.area += area;
    (!turns ? sum.sliding_share : rotation > 0 ? sum.toppling_share : sum.backward_share) += area;
}

void divide_by_area(RetrogressionStage& sum) {
    if (sum.area > 0) {
        sum.toppling_share /= sum.area;
        sum.backward_share /= sum.area;
        sum.sliding_share /= sum.area;
        sum.rotation_share /= sum.area;
    }
}

// Blocks that have only lost their support have not begun to fall at onset.
double rotation_share(const Bodies& bodies, const FailureStage& stage) {
    RotationShare share;
    for (std::size_t index = 0; index < stage.moved; ++index) {
        const std::size_t block = stage.block[index];
        share.add(bodies, block, stage.start[block], stage.onset[block]);
    }
    return share.value();
}

class Retrogression {
  public:
    Retrogression(const RelaxationStudy& study, const StudyWork& work, StudyProgress& progress)
        : study_(study),
          work_(work),
          progress_(progress),
          whole_(relaxation_scene(study)),
          settings_(settings_for(study, work, whole_)) {
        settings_.stop_at_onset = true;
        settings_.stop_at_equilibrium = true;
        settings_.creep = true;  // motion after onset does not matter
        for (FacePressure& pressure : whole_.pressure) {
            pressure.drains = true;  // a failure opens any face
        }
    }

    RelaxationRun run() {
        RelaxationRun made{whole_, settings_, {}, {}};
        made.in_stages = true;
        made.result.fault = check(whole_, settings_);
        if (made.result.fault.check != SceneCheck::valid) {
            return made;
        }
        bodies_ = make_bodies(whole_);
        faces_ = find_shared_faces(bodies_);
        gone_.assign(bodies_.size(), 0);
        for (const FailureStage& stage : progress_.stage) {
            take_away(stage);
        }
        const double most = study_.retrogression->most_stages.value_or(static_cast<double>(whole_.block.size()));
        do {
            made.scene = scene_without_what_failed();
        } while (run_stage(made) && static_cast<double>(progress_.stage.size()) < most && any_left());
        if (made.result.outcome == RelaxationOutcome::onset && !any_left()) {
            made.result.outcome = RelaxationOutcome::collapse;
        }
        for (const FailureStage& stage : progress_.stage) {
            made.result.cost.steps += stage.steps;
            made.result.cost.contacts_evaluated += stage.contacts_evaluated;
        }
        made.stage = progress_.stage;
        // Afterwards `progress` holds the complete last run, so that a continuation finds the same end.
        progress_.state = cut_short_ ? std::nullopt : at_rest_ ? at_rest_ : made.end;
        if (made.failed()) {
            progress_.stage.pop_back();
        }
        made.post_failure = survey(made.end->origin, made.end->motion, gone_);
        made.early_failure = early_failure(made);
        return made;
    }

  private:
    RelaxationScene scene_without_what_failed() const {
        RelaxationScene scene = whole_;
        for (std::size_t block = 0; block < gone_.size(); ++block) {
            if (gone_[block] != 0) {
                scene.removal.push_back({block, -1});
            }
        }
        return scene;
    }

    bool any_left() const {
        for (std::size_t block = 0; block < gone_.size(); ++block) {
            if (gone_[block] == 0 && !whole_.block[block].fixed) {
                return true;
            }
        }
        return false;
    }

    void take_away(const FailureStage& stage) {
        for (const std::uint64_t block : stage.block) {
            gone_[block] = taken_away;
        }
    }

    // Returns whether blocks failed and were removed.
    bool run_stage(RelaxationRun& made) {
        std::optional<RelaxationState> begun = std::exchange(progress_.state, {});
        at_rest_.reset();
        const std::atomic<bool>* stop = begun ? nullptr : work_.stop;
        Simulation simulation = begun_or_resumed(made.scene, settings_, std::move(begun), stop);
        cut_short_ = stop != nullptr && *stop;
        simulation.let_finish();
        const bool ended =
            !cut_short_ &&
            go_on(
                simulation, work_, [&](double share) { return !work_.watch || work_.watch(share_done(share)); },
                [&] {
                    progress_.state = simulation.state();
                    work_.keep(progress_);
                },
                [] {});
        made.end = simulation.state();
        made.result = simulation.result();
        if (auto failed = ended ? failed_at_rest(simulation, initial_contact(study_)) : std::nullopt) {
            made.result = result_of(simulation, *failed);
            at_rest_ = std::exchange(made.end, std::move(failed));
        }
        if (!ended) {
            made.result.outcome = RelaxationOutcome::interrupted;
        }
        if (made.result.outcome != RelaxationOutcome::onset) {
            return false;
        }
        FailureStage stage{{},
                           0,
                           made.end->origin,
                           made.end->motion,
                           made.result.time,
                           made.result.cost.steps,
                           made.result.cost.contacts_evaluated};
        for (std::size_t block = 0; block < made.result.block.size(); ++block) {
            if (has_failed(made.result.block[block].movement)) {
                stage.block.push_back(block);
            }
        }
        if (stage.block.empty()) {
            made.result.outcome = RelaxationOutcome::undecided;
            return false;
        }
        stage.moved = stage.block.size();
        take_away(stage);
        add_blocks_without_hold(stage);
        progress_.stage.push_back(std::move(stage));
        made.result.cost = {};
        return true;
    }

    void add_blocks_without_hold(FailureStage& stage) {
        std::vector<std::size_t> falling;
        do {
            falling = blocks_without_hold(scene_without_what_failed(), bodies_, faces_, gone_);
            for (const std::size_t block : falling) {
                stage.block.push_back(block);
                gone_[block] = taken_away;
            }
        } while (!falling.empty());
    }

    // The number of stages to come is unknown.
    double share_done(double of_stage) const {
        const auto stages = static_cast<double>(progress_.stage.size());
        return (stages + of_stage / (stages + 2)) / (stages + 1);
    }

    PostFailure survey(const std::vector<Motion>& start, const std::vector<Motion>& now,
                       const std::vector<char>& failed) const {
        const std::vector<char> none(bodies_.size(), 0);
        return post_failure({bodies_, start, now, none, joint_names(study_.model.scene), failed},
                            study_.post_failure.value_or(PostFailureRequest{}));
    }

    // The failure at the onset of the stage in which half of the finally failed area has been removed.
    PostFailure early_failure(const RelaxationRun& made) const {
        const double half = made.post_failure->answer.failed_area / 2;
        std::vector<char> failed(bodies_.size(), 0);
        double area = 0;
        for (const FailureStage& stage : made.stage) {
            for (const std::uint64_t block : stage.block) {
                area += area_of(bodies_, block);
            }
            if (area > half) {
                return survey(stage.start, stage.onset, failed);
            }
            for (const std::uint64_t block : stage.block) {
                failed[block] = 1;
            }
        }
        return *made.post_failure;
    }

    const RelaxationStudy& study_;
    const StudyWork& work_;
    StudyProgress& progress_;
    bool cut_short_ = false;                       // the static start of the last run was stopped
    std::optional<RelaxationState> at_rest_ = {};  // of the last stage, if its blocks failed at rest
    RelaxationScene whole_;
    RelaxationSettings settings_;
    Bodies bodies_ = {};
    std::vector<SharedFace> faces_ = {};
    std::vector<char> gone_ = {};  // blocks that failed in the stages so far
};

}  // namespace

RelaxationRun run_in_stages(const RelaxationStudy& study, const StudyWork& work, StudyProgress& progress) {
    return Retrogression(study, work, progress).run();
}

RetrogressionAnswer answer_of(const Bodies& bodies, const std::vector<FailureStage>& stages) {
    RetrogressionAnswer answer{};
    answer.stages = static_cast<double>(stages.size());
    for (const FailureStage& stage : stages) {
        RetrogressionStage& sum = answer.stage.emplace_back();
        for (std::size_t index = 0; index < stage.block.size(); ++index) {
            add_block(bodies, stage, index, sum);
            add_block(bodies, stage, index, answer.total);
        }
        divide_by_area(sum);
        sum.rotation_share = rotation_share(bodies, stage);
        answer.total.rotation_share += sum.area * sum.rotation_share;
    }
    divide_by_area(answer.total);
    if (!stages.empty()) {
        answer.first = answer.stage.front();
        answer.largest = *std::ranges::max_element(answer.stage, {}, &RetrogressionStage::area);
    }
    return answer;
}

std::vector<Polyline> left_standing_after(const Bodies& bodies, const std::vector<FailureStage>& stages) {
    const std::vector<Motion> unmoved(bodies.size());
    const std::vector<char> none(bodies.size(), 0);
    const std::vector<std::string> no_joints;
    std::vector<char> failed(bodies.size(), 0);
    std::vector<Polyline> after;
    for (const FailureStage& stage : stages) {
        for (const std::uint64_t block : stage.block) {
            failed[block] = 1;
        }
        after.push_back(post_failure({bodies, unmoved, unmoved, none, no_joints, failed}, {}).left_standing);
    }
    return after;
}

}  // namespace delabole
