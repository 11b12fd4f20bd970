#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace delabole {
namespace {

constexpr double gravity = 9.80665;

RelaxationStudy one_block(double tilt, double friction, double width, double height) {
    RelaxationRow row{};
    row.tilt = tilt;
    row.density = 2700;
    row.interface = row.base = RelaxationJoint{friction, {}, {}, {}, {}, {}, {}};
    row.block = {{width, height, {}}};
    RelaxationStudy study{};
    study.model.scene = row;
    return study;
}

RelaxationNumerics undamped(double duration) {
    RelaxationNumerics settings{};
    settings.viscous_damping = 0;
    settings.local_damping = 0;
    settings.stop = RelaxationStop::collapse;
    settings.collapse_displacement = 100;
    settings.duration = duration;
    return settings;
}

double answer(const RelaxationStudy& study, std::string_view name) {
    const ModelInterface model = model_interface(study);
    const auto found = std::ranges::find(model.outputs, name, &Quantity::name);
    const Prediction prediction = model.predict({});
    EXPECT_EQ(prediction.failure, "") << name;
    return prediction.outputs.at(static_cast<std::size_t>(found - model.outputs.begin()));
}

RelaxationOutcome outcome_of(const RelaxationStudy& study) {
    return run(study).result.outcome;
}

// A square has its first vertex and another one of its base in the middle of an edge, and water on two of its edges.
TEST(RelaxationScene, VerticesOfStraightEdgesAreLeftOut) {
    RelaxationPolygons polygons{};
    polygons.joint = {RelaxationJoint{degrees(30), {}, {}, {}, {}, {}, {}},
                      RelaxationJoint{degrees(20), {}, {}, {}, {}, {}, {}}};
    polygons.block.resize(1);
    polygons.block[0].density = 2500;
    polygons.block[0].vertex = {{0, 1, {}}, {0, 0, {}}, {1, 0, {}}, {2, 0, {}}, {2, 1, 2}, {2, 2, {}}, {0, 2, {}}};
    RelaxationStudy study{};
    study.model.scene = polygons;
    study.model.pressure = {{1, 1, 0, 10}, {1, 3, 20, 40}, {1, 5, 7, 8}, {1, 7, 3, 4}, {1, 8, 1, 1}};
    const RelaxationScene scene = relaxation_scene(study);
    const RelaxationBlock& block = scene.block[0];
    // The joint changes half-way up the right side.
    const Polygon<> corners{{0, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}};
    EXPECT_EQ(block.outline, corners);
    EXPECT_EQ(block.joint, (std::vector<std::size_t>{0, 0, 1, 0, 0}));
    ASSERT_EQ(scene.pressure.size(), 5U);
    const auto presses = [&](std::size_t index, std::size_t edge, double begin, double end) {
        const FacePressure& pressure = scene.pressure[index];
        EXPECT_EQ(pressure.edge, edge) << index;
        EXPECT_EQ(pressure.part.value().begin, begin) << index;
        EXPECT_EQ(pressure.part.value().end, end) << index;
    };
    presses(0, 4, 1, 2);
    presses(1, 0, 1, 2);
    presses(2, 2, 0, 1);
    presses(3, 4, 0, 1);
    EXPECT_GE(scene.pressure[4].edge, corners.size());  // there is no such edge: the check of scenes refuses it
}

TEST(RelaxationScene, StiffnessIsOfTheHeaviestBlockUnlessGiven) {
    RelaxationStudy study = one_block(0, degrees(30), 1, 3);
    auto& row = std::get<RelaxationRow>(study.model.scene);
    row.block.push_back({1, 5, {}});
    study.settings.emplace().stiffness_ratio = 1e5;
    row.base.normal_stiffness = 4e9;
    row.base.shear_stiffness = 2e9;
    const RelaxationScene scene = relaxation_scene(study);
    // k b = 1e5 W for the second block; doubles round a few times on the way.
    EXPECT_NEAR(scene.material[0].normal_stiffness / (1e5 * 2700 * gravity * 5), 1, 1e-14);
    EXPECT_EQ(scene.material[0].shear_stiffness, scene.material[0].normal_stiffness);
    EXPECT_EQ(scene.material[1].normal_stiffness, 4e9);
    EXPECT_EQ(scene.material[1].shear_stiffness, 2e9);
}

TEST(RelaxationStudy, WatchFollowsTheMotionPastItsVerdict) {
    // A block of 1 m by 1 m on a plane of 40 deg with 20 deg of friction slides away.
    RelaxationStudy sliding = one_block(degrees(40), degrees(20), 1, 1);
    const RelaxationResult at_verdict = run(sliding).result;
    EXPECT_EQ(at_verdict.outcome, RelaxationOutcome::collapse);
    sliding.settings.emplace().watch = 2 * at_verdict.time;
    const RelaxationRun followed = run(sliding);
    EXPECT_EQ(followed.result.outcome, RelaxationOutcome::collapse);
    EXPECT_NEAR(followed.result.time, 2 * at_verdict.time, 1e-3) << "the last step may pass the end";
    EXPECT_GT(followed.result.block[0].displacement, 2 * at_verdict.block[0].displacement);
    EXPECT_FALSE(followed.unfinished());

    RelaxationStudy standing = one_block(degrees(10), degrees(40), 1, 1);
    standing.settings.emplace().watch = 0.2;
    const RelaxationRun at_rest = run(standing);
    EXPECT_EQ(at_rest.result.outcome, RelaxationOutcome::equilibrium);
    EXPECT_NEAR(at_rest.result.time, 0.2, 1e-3);

    // This is a third of the time to collapse but a tenth of the distance: beyond onset, which is a hundredth.
    sliding.settings->watch = 0.3 * at_verdict.time;
    const RelaxationRun begun = run(sliding);
    EXPECT_EQ(begun.result.outcome, RelaxationOutcome::onset);
    EXPECT_FALSE(begun.unfinished());
}

TEST(RelaxationScene, TheSameBlocksAsARowAndAsPolygonsBehaveAlike) {
    const RelaxationStudy row = one_block(degrees(18.6), degrees(40), 1, 3);
    RelaxationPolygons polygons{};
    polygons.tilt = degrees(18.6);
    polygons.joint = {{degrees(40), {}, {}, {}, {}, {}, {}}};
    polygons.block = {{2700, {}, {}, {{0, 0, {}}, {1, 0, {}}, {1, 3, {}}, {0, 3, {}}}},
                      {2700, BlockHold::fixed, {}, {{-3, -1, {}}, {4, -1, {}}, {4, 0, {}}, {-3, 0, {}}}}};
    RelaxationStudy drawn{};
    drawn.model.scene = polygons;
    const RelaxationResult one = run(row).result;
    const RelaxationResult other = run(drawn).result;
    EXPECT_EQ(one.outcome, RelaxationOutcome::collapse);
    EXPECT_EQ(other.outcome, RelaxationOutcome::collapse);
    EXPECT_EQ(one.time, other.time);
    EXPECT_EQ(one.block[0].rotation, other.block[0].rotation);
}

TEST(RelaxationStudy, ABlockSlidesFreelyAsTheEquationOfMotionSays) {
    RelaxationStudy study = one_block(degrees(25), 0, 2, 1);
    constexpr double duration = 0.4;
    study.settings = undamped(duration);
    const double time = answer(study, "time");
    // The run ends with the step that passes the duration; that step is exact for constant acceleration.
    EXPECT_NEAR(answer(study, "block[1].displacement"), gravity * std::sin(degrees(25)) * time * time / 2, 1e-9);
    EXPECT_NEAR(answer(study, "energy.residual_share"), 0, 1e-9);  // rounding of some thousand steps
}

TEST(RelaxationStudy, GravityTurnedReachesTheTiltAtWhichTheBlockOverturns) {
    RelaxationStudy study = one_block(degrees(18), degrees(40), 1, 3);
    study.model.tilting =
        Tilting{TiltingFrame::gravity, degrees(20), degrees(0.5), std::nullopt, std::nullopt, std::nullopt, {}};
    study.settings.emplace().stop = RelaxationStop::onset;
    // Onset is 0.01 rad past the limit of 18.435 deg and takes a second or two, in which the tilt grows by a degree.
    const double tilt = answer(study, "tilt");
    EXPECT_GT(tilt, degrees(18.43));
    EXPECT_LT(tilt, degrees(19.7));
    study.model.tilting->final_tilt = degrees(18.4);
    EXPECT_EQ(outcome_of(study), RelaxationOutcome::equilibrium);
}

TEST(RelaxationStudy, ABaseThatTurnsTakesItsBlockAlong) {
    RelaxationStudy study = one_block(degrees(15), degrees(40), 1, 3);
    // The base turns so slowly that the block, which goes on when it stops, has a hundredth of the energy to overturn.
    study.model.tilting =
        Tilting{TiltingFrame::base, degrees(17), degrees(0.5), std::nullopt, std::nullopt, std::nullopt, {}};
    const RelaxationResult standing = run(study).result;
    EXPECT_EQ(standing.outcome, RelaxationOutcome::equilibrium);
    // Seen from the base. Springs give by about 1e-6 of the block.
    EXPECT_NEAR(standing.block[0].rotation, 0, 1e-5);
    EXPECT_EQ(standing.block[0].movement, BlockMovement::stays);
    study.model.tilting->final_tilt = degrees(19);
    EXPECT_EQ(outcome_of(study), RelaxationOutcome::collapse);
}

// The plane once ended three widths in front of the row, and blocks fell off it.
TEST(RelaxationStudy, TheRowsPlaneGoesOnForAsLongAsABlockSlides) {
    const double tilt = degrees(30);
    const double friction = degrees(10);
    RelaxationStudy study = one_block(tilt, friction, 2, 1);
    study.settings = undamped(3);
    const double expected = gravity * (std::sin(tilt) - std::tan(friction) * std::cos(tilt)) * 3 * 3 / 2;
    ASSERT_GT(expected, 6 * 2.0);
    const BlockOutcome block = run(study).result.block[0];
    // The springs are stretched first, and the run ends at the step nearest to its duration.
    EXPECT_NEAR(block.displacement, expected, 2e-3 * expected);
    EXPECT_NEAR(block.rotation, 0, 1e-4);
}

// The stiffness once followed the extent of the blocks along x.
TEST(RelaxationStudy, DefaultStiffnessOfBlocksStaysWhenTheSceneIsDrawnTurned) {
    const auto stiffness = [](double turn) {
        RelaxationPolygons scene{};
        scene.tilt = degrees(10) + turn;
        scene.joint = {RelaxationJoint{degrees(30), {}, {}, {}, {}, {}, {}}};
        // Gravity that dips to -x by more is that of a drawing turned clockwise.
        const auto turned = [&](double x, double y) {
            return RelaxationVertex{
                x * std::cos(turn) + y * std::sin(turn), y * std::cos(turn) - x * std::sin(turn), {}};
        };
        scene.block = {RelaxationPolygon{2700, {}, {}, {turned(0, 0), turned(1, 0), turned(1, 3), turned(0, 3)}}};
        RelaxationStudy study{};
        study.model.scene = scene;
        return relaxation_scene(study).material.at(0).normal_stiffness;
    };
    const double level = stiffness(0);
    for (const double turn : {-60.0, 25.0, 70.0}) {
        EXPECT_NEAR(stiffness(degrees(turn)), level, 1e-12 * level) << turn;
    }
}

TEST(RelaxationStudy, WaterUnderTheBaseLiftsTheBlockOffAtItsOwnWeight) {
    RelaxationStudy study = one_block(0, degrees(30), 1, 1);
    const double weight_over_width = 2700 * gravity;
    const auto outcome_at = [&](double share) {
        study.model.pressure = {{1, 1, share * weight_over_width, share * weight_over_width}};
        return outcome_of(study);
    };
    EXPECT_EQ(outcome_at(0.99), RelaxationOutcome::equilibrium);
    EXPECT_EQ(outcome_at(1.01), RelaxationOutcome::collapse);
}

TEST(RelaxationStudy, APointForceTurnsTheBlockOverWhenItsMomentExceedsThatOfTheWeight) {
    RelaxationStudy study = one_block(0, degrees(60), 1, 3);
    const double weight = 2700 * gravity * 3;
    // A push at the top: F h = W b / 2.
    const double limit = weight / 6;
    const auto outcome_at = [&](double force) {
        study.model.force = {{1, 1, 3, -force, 0}};
        return outcome_of(study);
    };
    EXPECT_EQ(outcome_at(0.99 * limit), RelaxationOutcome::equilibrium);
    EXPECT_EQ(outcome_at(1.01 * limit), RelaxationOutcome::collapse);
}

TEST(RelaxationStudy, ShakingMovesABlockOnceItExceedsFriction) {
    RelaxationStudy study = one_block(0, degrees(20), 2, 1);
    const double limit = gravity * std::tan(degrees(20));
    const auto slip_at = [&](double acceleration) {
        study.model.shaking = {{0, acceleration, 0}, {0.5, acceleration, 0}, {0.501, 0, 0}};
        return run(study).result.block[0].base_slip;
    };
    EXPECT_NEAR(slip_at(0.9 * limit), 0, 1e-5);  // the give of the springs
    // Ground that accelerates into the slope leaves the block behind, towards -x: first 0.1 limit 0.5^2 / 2, then
    // friction brings it to rest within a tenth of that. Local damping holds it back by up to a fifth of what moves it.
    const double way = 0.1 * limit * 0.125 * 1.1;
    const double slip = slip_at(1.1 * limit);
    EXPECT_LT(slip, -0.5 * way);
    EXPECT_GT(slip, -1.1 * way);
}

TEST(RelaxationStudy, WhatStoodOnARemovedBlockFalls) {
    RelaxationPolygons polygons{};
    polygons.joint = {{degrees(30), {}, {}, {}, {}, {}, {}}};
    polygons.block = {{2700, {}, {}, {{0, 1, {}}, {1, 1, {}}, {1, 2, {}}, {0, 2, {}}}},
                      {2700, {}, {}, {{0, 0, {}}, {1, 0, {}}, {1, 1, {}}, {0, 1, {}}}},
                      {2700, BlockHold::fixed, {}, {{-3, -1, {}}, {4, -1, {}}, {4, 0, {}}, {-3, 0, {}}}}};
    RelaxationStudy study{};
    study.model.scene = polygons;
    EXPECT_EQ(outcome_of(study), RelaxationOutcome::equilibrium);
    study.model.removal = {{2, 0.1}};
    const RelaxationResult result = run(study).result;
    EXPECT_EQ(result.block[1].movement, BlockMovement::removed);
    EXPECT_EQ(result.outcome, RelaxationOutcome::collapse);
    EXPECT_GT(result.block[0].displacement, 0.5);
}

TEST(RelaxationStudy, CriticalValuesAreThoseOfLimitingEquilibrium) {
    RelaxationStudy study = one_block(degrees(10), degrees(40), 1, 3);
    study.critical = TiltSearch{degrees(10), degrees(30), degrees(0.001), {}, {}};
    // tan(tilt) = b/a - W/(k b) sqrt(1 + (b/a)^2) with k b / W = 1e6, and half the bracket. (simulation.hpp)
    const double slender = 1.0 / 3;
    EXPECT_NEAR(find_critical(study).value(), std::atan(slender - 1e-6 * std::hypot(1, slender)), degrees(0.001));
    // On a tilt of 10 deg a squat block needs 10 deg of friction.
    RelaxationStudy squat = one_block(degrees(10), degrees(40), 2, 1);
    squat.critical = FrictionSearch{degrees(5), degrees(15), degrees(0.01), {}, {}};
    EXPECT_NEAR(find_critical(squat).value(), degrees(10), degrees(0.02));
}

// A run says whether blocks stand or fail whatever it is told to stop at.
TEST(RelaxationStudy, VerdictsAreRightUnderEveryStop) {
    RelaxationStudy columns = one_block(degrees(20), degrees(35), 3, 25);
    auto& row = std::get<RelaxationRow>(columns.model.scene);
    row.block.resize(5, row.block.front());
    RelaxationStudy resting = one_block(degrees(20), degrees(35), 3, 3);
    for (const RelaxationStop stop : {RelaxationStop::equilibrium, RelaxationStop::onset, RelaxationStop::collapse,
                                      RelaxationStop::duration, RelaxationStop::rest}) {
        resting.settings.emplace().stop = stop;
        resting.settings->duration = 5;
        const RelaxationRun rests = run(resting);
        EXPECT_EQ(rests.result.outcome, RelaxationOutcome::equilibrium) << word_of(stop);
        EXPECT_FALSE(rests.unfinished()) << word_of(stop);
        columns.settings = resting.settings;
        columns.settings->quality = RelaxationQuality::draft;
        const RelaxationRun topples = run(columns);
        EXPECT_EQ(topples.result.outcome,
                  stop == RelaxationStop::onset ? RelaxationOutcome::onset : RelaxationOutcome::collapse)
            << word_of(stop);
        // The columns are still falling when the run ends after 5 s.
        EXPECT_EQ(topples.unfinished(), stop == RelaxationStop::rest) << word_of(stop);
        EXPECT_EQ(model_interface(columns).predict({}).failure, stop == RelaxationStop::rest ? "undecided" : "");
    }
}

// A block drawn with its heel in the air by 0.01 rad, as much as the threshold of onset, falls back onto its heel
// without failing; it topples at the tilt at which the diagonal of a block that leans so is vertical.
TEST(RelaxationStudy, ABlockThatFallsBackOntoItsHeelHasNotFailed) {
    constexpr double lean = 0.01;
    RelaxationPolygons polygons{};
    polygons.joint = {RelaxationJoint{degrees(45), {}, {}, {}, {}, {}, {}}};
    polygons.block.resize(2);
    polygons.block[0].density = polygons.block[1].density = 2500;
    polygons.block[0].hold = BlockHold::fixed;
    polygons.block[0].vertex = {{-5, -1, {}}, {5, -1, {}}, {5, 0, {}}, {-5, 0, {}}};
    const double cosine = std::cos(lean);
    const double sine = std::sin(lean);
    for (const Point& corner : Polyline{{0, 0}, {1, 0}, {1, 5}, {0, 5}}) {
        polygons.block[1].vertex.push_back(
            {cosine * corner.x() - sine * corner.y(), sine * corner.x() + cosine * corner.y(), {}});
    }
    RelaxationStudy study{};
    study.model.scene = polygons;
    study.settings.emplace().stop = RelaxationStop::onset;
    study.critical = TiltSearch{degrees(5), degrees(15), degrees(0.01), {}, {}};
    // It falls by 0.01 rad with its inertia, which local damping takes away only in part.
    EXPECT_NEAR(find_critical(study).value(), std::atan(0.2) - lean, degrees(0.05));
}

TEST(RelaxationStudy, ARunThatIsToldToEndIsInterrupted) {
    RelaxationStudy study = one_block(degrees(10), degrees(40), 1, 3);
    study.settings.emplace().stop = RelaxationStop::collapse;
    int calls = 0;
    StudyWork work;
    work.watch = [&](double share) {
        EXPECT_GE(share, 0);
        EXPECT_LE(share, 1);
        return ++calls < 4;
    };
    const RelaxationRun made = run(study, work);
    EXPECT_EQ(made.result.outcome, RelaxationOutcome::interrupted);
    EXPECT_EQ(calls, 4);
    study.critical = TiltSearch{degrees(10), degrees(30), {}, {}, {}};
    work.watch = [](double) { return false; };
    EXPECT_EQ(find_critical(study, work).status, CriticalStatus::interrupted);
}

TEST(RelaxationStudy, HistoryFollowsTheMotionAndItsEnergies) {
    RelaxationStudy study = one_block(degrees(25), 0, 2, 1);
    study.settings = undamped(0.4);
    study.history = HistoryRequest{0.1, {{1}}, {{1, 2}}};
    const RelaxationRun made = run(study);
    ASSERT_EQ(made.history.size(), 5U);
    const double weight = 2700 * 2 * gravity;
    for (const HistoryLine& line : made.history) {
        const double way = gravity * std::sin(degrees(25)) * line.time * line.time / 2;
        EXPECT_NEAR(line.block[0].x, -way, 1e-9);
        EXPECT_NEAR(line.base_slip[0], -way, gravity * line.time * made.result.cost.step);  // a step behind
        // The start is consolidated: the normal force is there from the start and stays.
        EXPECT_NEAR(line.contact[0].normal / (weight * std::cos(degrees(25))), 1, 1e-6);
        EXPECT_NEAR(line.contact[0].vertical / line.contact[0].normal, 1, 1e-6);  // on block 1, upwards
        // Velocities are half a step behind positions.
        const double fallen = weight * std::sin(degrees(25)) * way;
        EXPECT_NEAR(line.energy.kinetic, fallen, line.time > 0 ? 1.01 * fallen * made.result.cost.step / line.time : 0);
    }
}

TEST(RelaxationStudy, QualitiesSetStepStiffnessAndEquilibriumUnlessGiven) {
    RelaxationStudy study = one_block(degrees(10), degrees(40), 1, 3);
    double stiffness = 0;
    double step = 1;
    double ratio = 1;
    for (const RelaxationQuality quality :
         {RelaxationQuality::draft, RelaxationQuality::standard, RelaxationQuality::reference}) {
        study.settings.emplace().quality = quality;
        const RelaxationSettings settings = relaxation_settings(study);
        const double now = relaxation_scene(study).material[0].normal_stiffness;
        EXPECT_GT(now, stiffness);
        EXPECT_LT(settings.step_fraction, step);
        EXPECT_LT(settings.equilibrium_ratio, ratio);
        stiffness = now;
        step = settings.step_fraction;
        ratio = settings.equilibrium_ratio;
    }
    study.settings->step_fraction = 0.33;
    EXPECT_EQ(relaxation_settings(study).step_fraction, 0.33);
}

TEST(RelaxationStudy, ASearchThatEndsAtABoundTellsThatTheCriticalValueLiesBeyond) {
    RelaxationStudy study = one_block(degrees(10), degrees(40), 1, 3);
    const auto bound = [&](const CriticalRequest& request) {
        study.critical = request;
        const ModelInterface model = model_interface(study);
        const Prediction prediction = model.predict({});
        const auto found = std::ranges::find(model.bounds, prediction.failure, &OutputBound::failure);
        EXPECT_NE(found, model.bounds.end()) << prediction.failure;
        EXPECT_EQ(model.outputs[found->output].name, name_of_critical(parameter_of(request)));
        return found->within;
    };
    const auto expect = [](const Interval& found, const Interval& expected) {
        EXPECT_EQ(found.lower, expected.lower);
        EXPECT_EQ(found.upper, expected.upper);
        EXPECT_EQ(found.lower_open, expected.lower_open);
        EXPECT_EQ(found.upper_open, expected.upper_open);
    };
    // It overturns at atan(1 / 3), 18.4 deg; at 10 deg friction of 10 deg holds it.
    expect(bound(TiltSearch{degrees(5), degrees(16), {}, {}, {}}), at_least(degrees(16)));
    expect(bound(TiltSearch{degrees(20), degrees(30), {}, {}, {}}), less_than(degrees(20)));
    expect(bound(FrictionSearch{degrees(12), degrees(30), {}, {}, {}}), at_most(degrees(12)));
    expect(bound(FrictionSearch{degrees(2), degrees(8), {}, {}, {}}), more_than(degrees(8)));
    study.critical.reset();
    EXPECT_TRUE(model_interface(study).bounds.empty());
}

TEST(RelaxationStudy, PredictionsFailByName) {
    RelaxationStudy study = one_block(degrees(10), degrees(40), 1, 3);
    const ModelInterface model = model_interface(study);
    const auto input = [&](std::string_view name) {
        return static_cast<std::size_t>(std::ranges::find(model.inputs, name, &Quantity::name) - model.inputs.begin());
    };
    const std::vector<Assignment> negative{{input("scene.density"), -1}};
    EXPECT_EQ(model.predict(negative).failure, "input_out_of_range");
    const std::vector<Assignment> sliver{{input("scene.block[1].width"), 1e-8}};
    EXPECT_NE(model.predict(sliver).failure, "");
    const std::vector<Assignment> steep{{input("scene.tilt"), degrees(25)}};
    const Prediction prediction = model.predict(steep);
    EXPECT_EQ(prediction.failure, "");
    EXPECT_EQ(prediction.outputs.size(), model.outputs.size());
}

}  // namespace
}  // namespace delabole
