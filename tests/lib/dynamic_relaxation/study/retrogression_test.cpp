// Failure by stages, and the mean of slopes that differ by chance.
#include "dynamic_relaxation/study/retrogression.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "dynamic_relaxation/study/strength_bound.hpp"

#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

using testing::joint_set;

constexpr double area = 8;  // m2, of the wall

// A wall 4 m long and 2 m high in blocks of 1 m, tilted by 25 deg so that its level joints dip out of the slope.
RelaxationStudy wall(double friction) {
    RelaxationSlope slope{};
    slope.geometry =
        testing::section({{0, 0}, {4, 0}, {4, 2}, {0, 2}},
                         {{"upright", "joint", joint_set(degrees(90), 1)}, {"level", "joint", joint_set(0, 1)}});
    slope.rock = {{"slate", 2700}};
    RelaxationJoint joint{};
    joint.friction_angle = friction;
    slope.joint = {{"joint", {}, joint}};
    slope.frame = SlopeFrame{FrameSides::below_and_behind, 1, {}, "joint"};
    slope.tilt = degrees(25);
    RelaxationStudy study{};
    study.model.scene = slope;
    study.retrogression.emplace();
    return study;
}

double value_of(const ModelInterface& model, const Prediction& prediction, const std::string& name) {
    const auto place = place_of(model.outputs, name);
    return place && *place < prediction.outputs.size() ? prediction.outputs[*place] : -1;
}

TEST(Retrogression, LeavesAWallThatStands) {
    const RelaxationRun made = run(wall(degrees(30)));
    EXPECT_EQ(made.result.outcome, RelaxationOutcome::equilibrium);
    EXPECT_TRUE(made.stage.empty());
    ASSERT_TRUE(made.post_failure);
    // The share of an elastic movement of a millionth of a block is its fourth power.
    EXPECT_LT(made.post_failure->answer.failed_area, 1e-12);
}

TEST(Retrogression, TakesAwayAWallThatSlidesOnItsBase) {
    const RelaxationRun made = run(wall(degrees(20)));
    EXPECT_EQ(made.result.outcome, RelaxationOutcome::collapse);
    ASSERT_TRUE(made.post_failure);
    constexpr double rounding = 1e-9;
    EXPECT_NEAR(made.post_failure->answer.failed_area, area, rounding);
    const RetrogressionAnswer answer = *answer_of(made).retrogression;
    EXPECT_GE(answer.stages, 1);
    EXPECT_EQ(answer.total.blocks, 8);
    EXPECT_NEAR(answer.total.area, area, rounding);
    EXPECT_NEAR(answer.total.sliding_share, 1, rounding);
    // Blocks of 1 m slide; rotation by their settling on stiff contacts stays below a thousandth of the energy.
    EXPECT_LT(answer.total.rotation_share, 1e-3);
    double areas = 0;
    for (const RetrogressionStage& stage : answer.stage) {
        areas += stage.area;
    }
    EXPECT_NEAR(areas, area, rounding);
}

// The wall of eight blocks of 1 m2, whose front upper block fails first by turning about its lower corner and then all
// others by sliding.
TEST(Retrogression, TellsTheEnergyAndTheGroundOfEachStage) {
    const Bodies bodies = make_bodies(relaxation_scene(wall(degrees(30))));
    FailureStage first{{}, 0, std::vector<Motion>(bodies.size()), std::vector<Motion>(bodies.size())};
    FailureStage second = first;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (bodies.fixed[block] != 0) {
            continue;
        }
        const PlanePoint<>& centre = bodies.centroid[block];
        const bool turns = centre.x() < 1 && centre.y() > 1;
        FailureStage& stage = turns ? first : second;
        stage.block.push_back(block);
        stage.moved += 1;
        stage.onset[block].x = -1e-4;
        if (turns) {
            stage.onset[block].y = 1e-4;
            stage.onset[block].set_angle(2e-4);
        }
    }
    const RetrogressionAnswer answer = answer_of(bodies, {first, second});
    constexpr double rounding = 1e-9;
    EXPECT_NEAR(answer.first.rotation_share, 0.25, rounding);
    EXPECT_EQ(answer.largest.rotation_share, 0);
    EXPECT_NEAR(answer.total.rotation_share, 0.25 / area, rounding);
    const std::vector<Polyline> after = left_standing_after(bodies, {first, second});
    ASSERT_EQ(after.size(), 2U);
    ASSERT_EQ(after[0].size(), after[1].size());
    for (std::size_t index = 0; index < after[0].size(); ++index) {
        EXPECT_NEAR(after[0][index].y(), after[0][index].x() < 1 ? 1 : 2, rounding);
        EXPECT_NEAR(after[1][index].y(), 0, rounding);
    }
}

TEST(Retrogression, EndsAfterTheStagesAskedFor) {
    RelaxationStudy study = wall(degrees(20));
    study.retrogression->most_stages = 1;
    EXPECT_EQ(run(study).stage.size(), 1U);
}

// Without the lower block at the face the upper one leans on its neighbour's upright side alone, which no friction
// makes a hold; without the upper one nothing falls.
TEST(Retrogression, LetsBlocksFallThatHaveLostTheirHold) {
    const RelaxationScene scene = relaxation_scene(wall(degrees(30)));
    const Bodies bodies = make_bodies(scene);
    const std::vector<SharedFace> faces = find_shared_faces(bodies);
    const auto block_at = [&](double x, double y) {
        for (std::size_t block = 0; block < bodies.size(); ++block) {
            if (bodies.fixed[block] == 0 && (bodies.centroid[block] - PlanePoint<>(x, y)).norm() < 0.01) {
                return block;
            }
        }
        return bodies.size();
    };
    const std::size_t lower = block_at(0.5, 0.5);
    const std::size_t upper = block_at(0.5, 1.5);
    ASSERT_LT(lower, bodies.size());
    ASSERT_LT(upper, bodies.size());
    std::vector<char> gone(bodies.size(), 0);
    gone[upper] = 1;
    EXPECT_TRUE(blocks_without_hold(scene, bodies, faces, gone).empty());
    gone[upper] = 0;
    gone[lower] = 1;
    EXPECT_EQ(blocks_without_hold(scene, bodies, faces, gone), std::vector<std::size_t>{upper});
}

// A run that was stopped at any place goes on to the same answer.
TEST(Retrogression, GoesOnFromWhereItWasStopped) {
    const RelaxationStudy study = wall(degrees(20));
    const RelaxationRun whole = run(study);
    StudyProgress progress;
    int looks = 0;
    StudyWork work;
    work.watch = [&](double) { return ++looks != 2; };
    run(study, work, progress);
    StudyProgress in_its_start;
    const std::atomic<bool> stop = true;
    StudyWork ended;
    ended.stop = &stop;
    EXPECT_EQ(run(study, ended, in_its_start).result.outcome, RelaxationOutcome::interrupted);
    EXPECT_FALSE(in_its_start.state) << "of a static solve that was ended";
    for (StudyProgress* const left : {&progress, &in_its_start}) {
        const RelaxationRun resumed = run(study, {}, *left);
        EXPECT_EQ(resumed.result.outcome, whole.result.outcome);
        ASSERT_EQ(resumed.stage.size(), whole.stage.size());
        for (std::size_t stage = 0; stage < whole.stage.size(); ++stage) {
            EXPECT_EQ(resumed.stage[stage].block, whole.stage[stage].block);
            EXPECT_EQ(resumed.stage[stage].steps, whole.stage[stage].steps);
        }
    }
}

// The motion itself is the other way to the ground left standing: the run lasts until what is left rests. All blocks
// slide off the end of the floor.
TEST(Rest, FollowsACollapseUntilWhatIsLeftRests) {
    RelaxationStudy study = wall(degrees(20));
    study.retrogression.reset();
    RelaxationNumerics numerics{};
    numerics.quality = RelaxationQuality::draft;
    numerics.stop = RelaxationStop::rest;
    numerics.taken_away_below = -4;
    study.settings = numerics;
    const RelaxationRun made = run(study);
    EXPECT_EQ(made.result.outcome, RelaxationOutcome::collapse);
    ASSERT_TRUE(made.post_failure);
    constexpr double rounding = 1e-9;
    EXPECT_NEAR(made.post_failure->answer.failed_area, area, rounding);
    for (const BlockOutcome& block : made.result.block) {
        EXPECT_TRUE(block.movement == BlockMovement::left || block.movement == BlockMovement::fixed);
    }
    EXPECT_LT(made.result.time, 60);

    study.settings->duration = 0.5;
    const RelaxationRun falling = run(study);
    EXPECT_TRUE(falling.failed());
    EXPECT_TRUE(falling.unfinished()) << "nothing rests yet";
    EXPECT_FALSE(made.unfinished());
    study.settings->taken_away_below = 1.5;
    EXPECT_EQ(check(study).check, SceneCheck::setting_out_of_range) << "above the lower blocks";
}

TEST(Rest, IsEquilibriumWhereNothingFails) {
    RelaxationStudy study = wall(degrees(30));
    study.retrogression.reset();
    study.settings.emplace().stop = RelaxationStop::rest;
    EXPECT_EQ(run(study).result.outcome, RelaxationOutcome::equilibrium);
}

TEST(Ensemble, BeginsWithTheSlopeAsDrawnAndShiftsTheJointsOfTheOthers) {
    RelaxationStudy study = wall(degrees(20));
    study.ensemble = EnsembleRequest{4, 0.1, degrees(1)};
    const auto& drawn = std::get<RelaxationSlope>(study.model.scene);
    const RelaxationStudy itself = member_of(study, 0);
    EXPECT_EQ(std::get<RelaxationSlope>(itself.model.scene).geometry, drawn.geometry);
    for (std::size_t member = 1; member < 4; ++member) {
        const RelaxationStudy other = member_of(study, member);
        const auto& slope = std::get<RelaxationSlope>(other.model.scene);
        EXPECT_NE(std::get<JointSetCut>(slope.geometry.cut[0].trace).offset,
                  std::get<JointSetCut>(drawn.geometry.cut[0].trace).offset);
        // The values are cut off at two standard deviations.
        EXPECT_NEAR(std::get<JointSetCut>(slope.geometry.cut[0].trace).spacing, 1, 0.2 + 1e-12);
        EXPECT_NEAR(slope.joint[0].strength.friction_angle, degrees(20), degrees(2) + 1e-12);
    }
}

TEST(Ensemble, OfWallsThatAllSlideHasTheirAreaAndNoDeviation) {
    RelaxationStudy study = wall(degrees(20));
    study.ensemble = EnsembleRequest{3, {}, {}};
    const ModelInterface model = model_interface(study);
    const Prediction prediction = model.predict({});
    ASSERT_EQ(prediction.failure, "");
    ASSERT_EQ(prediction.outputs.size(), model.outputs.size());
    constexpr double rounding = 1e-9;
    EXPECT_NEAR(value_of(model, prediction, "post_failure.failed_area"), area, rounding);
    EXPECT_NEAR(value_of(model, prediction, "ensemble_deviation.post_failure.failed_area"), 0, rounding);
    EXPECT_NEAR(value_of(model, prediction, "ensemble_deviation.profile"), 0, rounding);
}

// Members with the given factors of safety; below the lower bound of the search or above the upper one they end there.
EnsemblePrediction ensemble_of(const std::vector<double>& factors, double lower, double upper) {
    RelaxationStudy study = wall(degrees(20));
    study.ensemble = EnsembleRequest{static_cast<double>(factors.size()), {}, {}};
    study.critical = ReductionSearch{lower, upper, {}, {}, {}, {}};
    std::size_t next = 0;
    const auto member = [&](const RelaxationStudy&) {
        const double factor = factors[next++];
        EnsembleMember made;
        made.prediction.outputs = {std::clamp(factor, lower, upper)};
        made.fails = factor < 1;
        made.at_lower = factor < lower;
        made.at_upper = factor >= upper;
        made.ended_at = made.at_lower   ? word_of(CriticalStatus::fails_everywhere)
                        : made.at_upper ? word_of(CriticalStatus::stands_everywhere)
                                        : std::string_view();
        if (std::isnan(factor)) {
            made = {};
            made.prediction.failure = "undecided";
        }
        return made;
    };
    EnsembleMember first = member(study);
    return predict_ensemble(study, std::move(first), member, {});
}

constexpr double no_answer = std::numeric_limits<double>::quiet_NaN();

TEST(Ensemble, HasTheWordOfItsMembersOnlyIfAllHaveIt) {
    EXPECT_EQ(ensemble_of({0.05, 0.05, 0.05, 0.05}, 0.1, 10).failure, "fails_everywhere");
    EXPECT_EQ(ensemble_of({20, 20, 20, 20}, 0.1, 10).failure, "stands_everywhere");
    EXPECT_EQ(ensemble_of({no_answer, no_answer, no_answer, no_answer}, 0.1, 10).failure, "undecided");
    const EnsemblePrediction few = ensemble_of({20, no_answer, no_answer, 20}, 0.1, 10);
    EXPECT_EQ(few.failure, slopes_without_answer) << "of which no bound tells anything";
    EXPECT_EQ(few.first_cause, "undecided");
    EXPECT_EQ(few.without_answer, 2);
}

TEST(Ensemble, TakesMembersAtTheBoundsAtWhichTheirSearchesEnded) {
    const EnsemblePrediction mixed = ensemble_of({1.6, 1.6, 0.05, 20}, 0.1, 10);
    ASSERT_EQ(mixed.failure, "");
    constexpr double rounding = 1e-12;
    EXPECT_NEAR(mixed.mean.front(), (1.6 + 1.6 + 0.1 + 10) / 4, rounding);
    EXPECT_EQ(mixed.at_bounds->lower, 1);
    EXPECT_EQ(mixed.at_bounds->upper, 1);
    EXPECT_EQ(mixed.failing, 1);
    EXPECT_EQ(mixed.without_answer, 0);
}

// A block on a plane at 35 deg, of which the friction angle differs between the slopes.
RelaxationStudy block_on_a_plane() {
    RelaxationSlope slope{};
    slope.geometry = testing::section({{-10, -6}, {30, -6}, {30, 12}, {6.928203, 12}, {0, 0}, {-10, 0}},
                                      {testing::cut("plane", testing::line({{0.288675, 0.5}, {16.712377, 12}}))});
    slope.geometry.intact_joint = "intact";
    slope.rock = {{"rock", 2650}};
    RelaxationJoint intact = testing::joint_of_friction(45);
    intact.cohesion = intact.tensile_strength = 5e6;
    slope.joint = {{"joint", {}, testing::joint_of_friction(40)}, {"intact", {}, intact}};
    slope.frame = SlopeFrame{FrameSides::all_around, 3, {}, "joint"};
    RelaxationStudy study{};
    study.model.scene = slope;
    study.settings.emplace().stop = RelaxationStop::onset;
    study.critical = ReductionSearch{1, 3, 0.001, {}, {}, {}};
    study.ensemble = EnsembleRequest{6, {}, degrees(3)};
    return study;
}

// tan(friction angle) / tan(35 deg) of each member; that of the fifth is 0.963.
TEST(Ensemble, CountsAMemberThatFailsAtTheLeastFactorTried) {
    const RelaxationStudy study = block_on_a_plane();
    std::size_t below = 0;
    double sum = 0;
    for (std::size_t member = 0; member < 6; ++member) {
        const RelaxationStudy made = member_of(study, member);
        const double friction = std::get<RelaxationSlope>(made.model.scene).joint.front().strength.friction_angle;
        const double factor = std::tan(friction) / std::tan(degrees(35));
        below += factor < 1 ? 1 : 0;
        sum += std::max(1.0, factor);
    }
    ASSERT_EQ(below, 1U);
    const ModelInterface model = model_interface(study);
    const Prediction prediction = model.predict({});
    ASSERT_EQ(prediction.failure, "");
    ASSERT_EQ(prediction.outputs.size(), model.outputs.size());
    // The bracket is 0.001 wide, and the block settles on stiff contacts.
    EXPECT_NEAR(value_of(model, prediction, "factor_of_safety"), sum / 6, 0.002);
    EXPECT_EQ(value_of(model, prediction, "ensemble_without_answer"), 0);
    EXPECT_EQ(value_of(model, prediction, "ensemble_at_lower"), 1);
    EXPECT_EQ(value_of(model, prediction, "ensemble_at_upper"), 0);
    EXPECT_EQ(value_of(model, prediction, "ensemble_failing_share"), 1.0 / 6);
    EXPECT_GT(value_of(model, prediction, "post_failure.failed_area"), 0) << "of the one that fails as given";
    ASSERT_EQ(model.bounded_outputs.size(), 1U);
    const Interval range = model.bounded_outputs.front().range(prediction);
    EXPECT_EQ(range.upper, value_of(model, prediction, "factor_of_safety"));
    EXPECT_EQ(range.lower, -std::numeric_limits<double>::infinity()) << "the mean is at most that";
}

}  // namespace
}  // namespace delabole
