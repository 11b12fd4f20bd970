// Factors of safety by strength reduction against closed forms, and what they must not depend on.
#include "dynamic_relaxation/study/strength_reduction.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

constexpr double gravity = 9.80665;
constexpr double half_bracket = 0.0025;  // of the standard tolerance

RelaxationJoint joint_of(double friction_angle, double cohesion = 0) {
    RelaxationJoint joint{};
    joint.friction_angle = friction_angle;
    joint.cohesion = cohesion;
    return joint;
}

RelaxationStudy blocks_in_a_row(double tilt, RelaxationJoint interface, RelaxationJoint base,
                                std::vector<RelaxationRowBlock> blocks) {
    RelaxationRow row{};
    row.tilt = tilt;
    row.density = 2700;
    row.interface = interface;
    row.base = base;
    row.block = std::move(blocks);
    RelaxationStudy study{};
    study.model.scene = row;
    study.critical = ReductionSearch{};
    return study;
}

RelaxationStudy squat_block(double tilt, double friction_angle, double cohesion = 0, double size = 1) {
    return blocks_in_a_row(tilt, joint_of(friction_angle), joint_of(friction_angle, cohesion), {{2 * size, size, {}}});
}

CriticalAnswer with_joints(RelaxationStudy study, std::vector<std::string> joints) {
    std::get<ReductionSearch>(*study.critical).joints = std::move(joints);
    return find_critical(study);
}

TEST(StrengthReduction, ABlockOnAPlaneSlidesAtTheRatioOfTangents) {
    for (const double tilt : {10.0, 30.0, 38.0}) {
        const CriticalAnswer critical = find_critical(squat_block(degrees(tilt), degrees(40)));
        ASSERT_EQ(critical.status, CriticalStatus::found);
        EXPECT_EQ(critical.path, LoadingPath::consolidated);
        EXPECT_EQ(critical.consolidated_at, 1);
        // Friction that just holds is at the edge of both ends of the bracket.
        EXPECT_NEAR(critical.value(), std::tan(degrees(40)) / std::tan(degrees(tilt)), half_bracket);
        EXPECT_LE(critical.fails - critical.stands, 2 * half_bracket);
        ASSERT_TRUE(critical.failed);
        EXPECT_EQ(critical.failed->result.outcome, RelaxationOutcome::onset);
        EXPECT_EQ(critical.failed->result.block[0].movement, BlockMovement::slides_forward);
    }
}

// The block settles by more than twice the threshold of onset, and by as much however strong its joint is. That is no
// failure.
TEST(StrengthReduction, SoftJointsSettle) {
    RelaxationStudy study = squat_block(degrees(30), degrees(40));
    const double weight = 2700 * gravity * 2;
    const double radius = std::sqrt(1.25);
    auto& row = std::get<RelaxationRow>(study.model.scene);
    row.base.normal_stiffness = weight / 2 / (0.025 * radius);  // at each of two corners
    row.base.shear_stiffness = row.base.normal_stiffness;
    EXPECT_NEAR(find_critical(study).value(), std::tan(degrees(40)) / std::tan(degrees(30)), half_bracket);
}

TEST(StrengthReduction, AFactorFromAConsolidatedStateIsTriedWithoutItsHistory) {
    RelaxationStudy study = squat_block(degrees(30), degrees(40));
    const CriticalAnswer found = find_critical(study);
    const auto tried = try_other_path(study, found);
    ASSERT_TRUE(tried);
    EXPECT_TRUE(tried->stands);
    EXPECT_EQ(tried->value, 0.98 * found.stands);
    CriticalAnswer jammed = found;  // claims that forces of its history held the block beyond its friction
    jammed.stands = 1.1 * found.fails;
    ASSERT_TRUE(try_other_path(study, jammed));
    EXPECT_FALSE(try_other_path(study, jammed)->stands);
    CriticalAnswer without = found;
    without.status = CriticalStatus::undecided;
    EXPECT_FALSE(try_other_path(study, without));
    CriticalAnswer preloaded = found;
    preloaded.path = LoadingPath::preloaded;
    EXPECT_FALSE(try_other_path(study, preloaded));
    std::get<ReductionSearch>(*study.critical).paths = PathChoice::all;
    EXPECT_FALSE(try_other_path(study, found));
}

TEST(StrengthReduction, CohesionIsDividedLikeFriction) {
    const double tilt = degrees(35);
    const double cohesion = 10e3;
    const double weight = 2700 * gravity * 2;
    RelaxationStudy study = squat_block(tilt, degrees(30), cohesion);
    const double expected =
        (cohesion * 2 + weight * std::cos(tilt) * std::tan(degrees(30))) / (weight * std::sin(tilt));
    // Cohesion that a slip takes away acts over the whole face until then.
    const CriticalAnswer brittle = find_critical(study);
    ASSERT_EQ(brittle.status, CriticalStatus::found);
    EXPECT_NEAR(brittle.value(), expected, half_bracket);
    // A joint that keeps its cohesion carries at the limit at both corners at once.
    std::get<RelaxationRow>(study.model.scene).base.residual_cohesion = cohesion;
    const CriticalAnswer plastic = find_critical(study);
    ASSERT_EQ(plastic.status, CriticalStatus::found);
    EXPECT_NEAR(plastic.value(), expected, half_bracket);
}

TEST(StrengthReduction, BelowOneTheBlocksAreConsolidatedAtTheLeastStrengthThatHolds) {
    const CriticalAnswer critical = find_critical(squat_block(degrees(40), degrees(30)));
    ASSERT_EQ(critical.status, CriticalStatus::found);
    EXPECT_EQ(critical.consolidated_at, 0.5);
    EXPECT_NEAR(critical.value(), std::tan(degrees(30)) / std::tan(degrees(40)), half_bracket);
    RelaxationStudy never = squat_block(degrees(40), degrees(1));
    const CriticalAnswer fails = find_critical(never);
    EXPECT_EQ(fails.status, CriticalStatus::fails_everywhere);
    EXPECT_EQ(fails.last, 0.1);
    ASSERT_TRUE(fails.failed);
}

// What friction does not hold does not depend on it: a column that leans on nothing turns by its weight alone.
TEST(StrengthReduction, AColumnThatStandsByItsShapeStandsEverywhere) {
    RelaxationStudy study = squat_block(0, degrees(40));
    EXPECT_EQ(find_critical(study).status, CriticalStatus::stands_everywhere);
}

TEST(StrengthReduction, LengthsAndDensityMakeNoDifference) {
    const CriticalAnswer one = find_critical(squat_block(degrees(30), degrees(40)));
    for (const double size : {1e-2, 1e3}) {
        const CriticalAnswer other = find_critical(squat_block(degrees(30), degrees(40), 0, size));
        EXPECT_EQ(other.stands, one.stands);
        EXPECT_EQ(other.fails, one.fails);
    }
}

// Two columns press on each other: the lower one slides, the upper one pushes it. Only the joints named give way.
TEST(StrengthReduction, OnlyTheJointsNamedAreReduced) {
    const double tilt = degrees(20);
    RelaxationStudy study =
        blocks_in_a_row(tilt, joint_of(degrees(35)), joint_of(degrees(35)), {{2, 1, {}}, {2, 1, {}}});
    // Both slide together as one: the joint between them carries nothing.
    const double together = std::tan(degrees(35)) / std::tan(tilt);
    EXPECT_NEAR(find_critical(study).value(), together, half_bracket);
    EXPECT_NEAR(with_joints(study, {"base"}).value(), together, half_bracket);
    EXPECT_EQ(with_joints(study, {"interface"}).status, CriticalStatus::stands_everywhere);
}

TEST(StrengthReduction, DividesEveryStrengthAndNothingElse) {
    RelaxationScene scene;
    JointMaterial joint{1e9, 2e9, degrees(40), degrees(30), 5e3, 2e3};
    joint.bond = BondMaterial{5e9, 2e9, 4e5, 6e5, degrees(45), {}};
    scene.material = {joint, {1e9, 1e9, degrees(89.9)}};
    const RelaxationScene half = with_reduced_strength(scene, std::vector<std::size_t>{0}, 2);
    EXPECT_DOUBLE_EQ(std::tan(half.material[0].friction_angle), std::tan(degrees(40)) / 2);
    EXPECT_DOUBLE_EQ(std::tan(*half.material[0].residual_friction_angle), std::tan(degrees(30)) / 2);
    EXPECT_EQ(half.material[0].cohesion, 2.5e3);
    EXPECT_EQ(half.material[0].tensile_strength, 1e3);
    EXPECT_EQ(half.material[0].normal_stiffness, 1e9);
    EXPECT_EQ(half.material[0].shear_stiffness, 2e9);
    EXPECT_DOUBLE_EQ(std::tan(half.material[0].bond->friction_angle), 0.5);
    EXPECT_EQ(half.material[0].bond->cohesion, 3e5);
    EXPECT_EQ(half.material[0].bond->tensile_strength, 2e5);
    EXPECT_EQ(half.material[0].bond->young_modulus, 5e9);
    EXPECT_EQ(half.material[1].friction_angle, degrees(89.9));
    // Raised strength stays below the limit above which scenes are refused.
    const RelaxationScene strong = with_reduced_strength(scene, std::vector<std::size_t>{0, 1}, 1e-4);
    EXPECT_LE(strong.material[0].friction_angle, degrees(89.9));
    EXPECT_EQ(strong.material[1].friction_angle, degrees(89.9));
}

TEST(StrengthReduction, MaterialsThatScatterBelongToTheirJoints) {
    RelaxationStudy study = blocks_in_a_row(degrees(20), joint_of(degrees(30)), joint_of(degrees(40)),
                                            {{1, 1, {}}, {1, 1, {}}, {1, 1, {}}});
    auto& row = std::get<RelaxationRow>(study.model.scene);
    row.scatter = RelaxationScatter{7, 0, degrees(1)};
    const RelaxationScene scene = relaxation_scene(study);
    const std::vector<std::size_t> of_base = materials_of_joints(study.model.scene, scene, {"base"});
    for (std::size_t material = 0; material + 1 < scene.material.size(); ++material) {
        // Scatter is cut off at twice its deviation, far from the middle between the two.
        EXPECT_EQ(std::ranges::count(of_base, material), scene.material[material].friction_angle > degrees(35) ? 1 : 0)
            << material;
    }
    EXPECT_EQ(of_base.back(), scene.material.size() - 1);  // of the plane itself
    EXPECT_EQ(materials_of_joints(study.model.scene, scene, {}).size(), scene.material.size());
    EXPECT_EQ(joint_names(study.model.scene), (std::vector<std::string>{"interface", "base"}));
}

TEST(LoadingPaths, OfOneBlockAllButTheSuddenOneAgree) {
    RelaxationStudy study = squat_block(degrees(30), degrees(40));
    std::get<ReductionSearch>(*study.critical).paths = PathChoice::all;
    const CriticalAnswer critical = find_critical(study);
    ASSERT_EQ(critical.worst_status(), CriticalStatus::found);
    ASSERT_EQ(critical.other.size(), 3U);
    const double expected = std::tan(degrees(40)) / std::tan(degrees(30));
    EXPECT_NEAR(critical.value(), expected, half_bracket);
    for (const PathValue& other : critical.other) {
        // Statically determinate: the path does not matter. Dropped on its springs the block is pressed less at times.
        const double less = other.path == LoadingPath::sudden ? 0.5 : half_bracket;
        EXPECT_LT(other.value(), expected + half_bracket) << word_of(other.path);
        EXPECT_GT(other.value(), expected - less) << word_of(other.path);
    }
    const std::vector<Quantity> outputs = outputs_of_run(study);
    for (const char* name : {"factor_of_safety", "factor_of_safety_preloaded", "factor_of_safety_gravity",
                             "factor_of_safety_sudden", "factor_of_safety_spread"}) {
        EXPECT_TRUE(place_of(outputs, name)) << name;
    }
    // A fit gets the same numbers.
    const Prediction prediction = model_interface(study).predict({});
    const ModelInterface model = model_interface(study);
    ASSERT_EQ(prediction.outputs.size(), model.outputs.size());
    const auto output = [&](std::string_view name) { return prediction.outputs[*place_of(model.outputs, name)]; };
    EXPECT_EQ(output("factor_of_safety"), critical.value());
    EXPECT_EQ(output("factor_of_safety_spread"), critical.values()[4]);
    EXPECT_EQ(output("path_deviation.factor_of_safety"), critical.values()[5]);
}

TEST(LoadingPaths, SpreadAndDeviateAsTheirValuesSay) {
    CriticalAnswer answer;
    answer.stands = answer.fails = 1;
    EXPECT_EQ(answer.values(), std::vector<double>{1});
    answer.other.resize(2);
    answer.other[0].stands = answer.other[0].fails = 2;
    answer.other[1].stands = answer.other[1].fails = 4;
    const std::vector<double> values = answer.values();
    EXPECT_EQ((std::vector<double>{values.begin(), values.begin() + 4}), (std::vector<double>{1, 2, 4, 3}));
    EXPECT_NEAR(values[4], std::sqrt((1 + 9) / 2.0), 1e-15);  // about the first of them
}

TEST(LoadingPaths, StagesAreOnePathAndWhatTheyTakeAwayIsMissingOnOthers) {
    RelaxationStudy study = blocks_in_a_row(degrees(30), joint_of(degrees(40)), joint_of(degrees(40)),
                                            {{2, 1, BlockHold::free}, {2, 1, {}}});
    study.model.removal = {{1, 0.1}};
    std::get<ReductionSearch>(*study.critical).paths = PathChoice::all;
    const CriticalAnswer critical = find_critical(study);
    ASSERT_EQ(critical.worst_status(), CriticalStatus::found);
    ASSERT_EQ(critical.other.size(), 4U);
    EXPECT_EQ(critical.other.back().path, LoadingPath::stages);
    const double expected = std::tan(degrees(40)) / std::tan(degrees(30));
    for (const PathValue& other : critical.other) {
        if (other.path != LoadingPath::sudden) {
            EXPECT_NEAR(other.value(), expected, half_bracket) << word_of(other.path);
        }
        ASSERT_TRUE(other.failed);
        EXPECT_EQ(other.failed->result.block[0].movement, BlockMovement::removed);
    }
    EXPECT_NEAR(critical.value(), expected, half_bracket);
}

// c A = W (sin - cos tan phi): weight at which cohesion no longer holds what friction does not.
TEST(LoadingPaths, WeightGrowsUntilCohesionIsSpent) {
    RelaxationStudy study = squat_block(degrees(35), degrees(30), 20e3);
    study.critical = WeightSearch{};
    const CriticalAnswer critical = find_critical(study);
    ASSERT_EQ(critical.status, CriticalStatus::found);
    EXPECT_EQ(name_of_critical(parameter_of(*study.critical)), "critical_weight_factor");
    const double weight = 2700 * gravity * 2;
    const double expected =
        20e3 * 2 / (weight * (std::sin(degrees(35)) - std::cos(degrees(35)) * std::tan(degrees(30))));
    EXPECT_LT(critical.value(), expected * 1.01);
    EXPECT_GT(critical.value(), 0.3 * expected);
}

// Columns on a joint through the toe. The first column joint leaves a tip of 0.08 m2 at the face: merged with the rock
// below, it would hold the whole slope up to a factor of 2.892.
TEST(StrengthReduction, ATipAtTheFaceLocksNoJoint) {
    const double friction = std::tan(degrees(28.693206877));
    RelaxationSlope slope{};
    slope.rock = {{"rock", 2600}};
    slope.joint = {{"joint", {}, {}}, {"intact", {}, {}}};
    slope.joint[0].strength.friction_angle = std::atan(friction);
    slope.joint[1].strength.friction_angle = degrees(45);
    slope.joint[1].strength.cohesion = 1e9;
    slope.joint[1].strength.tensile_strength = 1e9;
    slope.frame = SlopeFrame{FrameSides::all_around, 3.59, {}, "joint"};
    const double height = 17.952350177;
    slope.geometry = testing::section(
        {{-10.771, -8.976}, {35.687, -8.976}, {35.687, height}, {8.758, height}, {0, 0}, {0, -0.3}, {-10.771, -0.3}},
        {testing::cut("base", testing::line({{0, 0}, {107.060036, 79.61361}})),
         testing::cut("columns", testing::joint_set(degrees(-69.313001402), 2.976498671, 1.748350162))});
    slope.geometry.intact_joint = "intact";
    RelaxationStudy study{};
    study.model.scene = slope;
    study.settings = RelaxationNumerics{};
    study.settings->stop = RelaxationStop::onset;
    study.critical = ReductionSearch{};
    const CriticalAnswer critical = find_critical(study);
    ASSERT_EQ(critical.status, CriticalStatus::found);
    // A slope cut by the base joint alone has a factor of 0.735. Further joints cannot make it stronger.
    EXPECT_LT(critical.stands, friction / (79.61361 / 107.060036) + half_bracket);
    std::get<RelaxationSlope>(study.model.scene).geometry.sliver_share = 0;
    EXPECT_NEAR(find_critical(study).value(), critical.value(), 2 * half_bracket);
}

// Columns slide on joints through the face. A tenth of a percent beyond their limit they creep to onset by hundreds of
// settlements; followed one by one these steps took three million steps of motion after all.
TEST(StrengthReduction, CreepNearTheLimitIsFollowedToOnset) {
    RelaxationSlope slope{};
    slope.rock = {{"rock", 2650}};
    slope.joint = {{"joint", {}, {}}};
    slope.joint[0].strength.friction_angle = degrees(30);
    slope.frame = SlopeFrame{FrameSides::below_and_behind, 2, {}, "joint"};
    slope.geometry = testing::section({{0, 0}, {18.4, 0}, {18.4, 12}, {4.37, 12}},
                                      {testing::cut("columns", testing::joint_set(degrees(-79.8), 3)),
                                       testing::cut("base", testing::joint_set(degrees(36.7), 3))});
    RelaxationStudy study{};
    study.model.scene = slope;
    const double factor = std::tan(degrees(30)) / std::tan(degrees(36.7));
    ReductionSearch search{};
    search.lower = 0.99 * factor;
    search.upper = 1.001 * factor;
    search.tolerance = 0.011 * factor;
    study.critical = search;
    const CriticalAnswer critical = find_critical(study);
    EXPECT_EQ(critical.status, CriticalStatus::found);
    EXPECT_LT(critical.steps, 300'000U);  // some ten thousand
}

}  // namespace
}  // namespace delabole
