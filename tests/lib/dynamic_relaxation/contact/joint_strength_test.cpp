// Cohesion and tensile strength of joints without rock across them: spread over the face, not at its two corners.
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include "dynamic_relaxation/checkpoint/checkpoint.hpp"
#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <string>

namespace delabole {
namespace {

using namespace relaxation_scenes;

struct Strength {
    double cohesion;  // Pa
    double tension;   // Pa
};

// Numbers of extra vertices on the base of the block and on the ground below it.
struct Vertices {
    int of_block = 0;
    int of_ground = 0;
};

RelaxationScene scene_of(const OnPlane& plane, const Strength& strength, const Vertices& vertices = {}) {
    RelaxationScene scene = relaxation_scenes::scene_of(plane);
    scene.material[0].cohesion = strength.cohesion;
    scene.material[0].tensile_strength = strength.tension;
    Polygon<>& block = scene.block[0].outline;
    for (int vertex = 1; vertex <= vertices.of_block; ++vertex) {
        block.insert(block.begin() + vertex, {plane.width * vertex / (vertices.of_block + 1), 0});
    }
    Polygon<>& ground = scene.block[1].outline;
    for (int vertex = 1; vertex <= vertices.of_ground; ++vertex) {
        ground.insert(ground.begin() + 2 + vertex, {plane.width * (1 - (vertex - 0.4) / vertices.of_ground), 0});
    }
    scene.bond = find_bonds(scene);
    return scene;
}

// The block stands at 0.998 of the tilt and fails at 1.002: of 20 deg that is 0.04 deg.
void expect_limit(const OnPlane& plane, const Strength& strength, double limit, const std::string& what,
                  const Vertices& vertices = {}) {
    for (const double part : {0.998, 1.002}) {
        OnPlane tilted = plane;
        tilted.tilt = part * limit;
        const RelaxationResult result = relax(scene_of(tilted, strength, vertices), until_onset());
        EXPECT_EQ(result.outcome, part < 1 ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset)
            << what << ", part " << part << " of " << limit;
        EXPECT_LT(energy_error(result, 1e-6 * density * gravity), 0.02) << what;
        EXPECT_EQ(result.broken_bonds, 0U) << "no rock";
    }
}

double sliding_limit(const OnPlane& plane, double cohesion) {
    const double share = cohesion * plane.width / plane.weight();
    return root([&](double tilt) { return std::sin(tilt) - std::cos(tilt) * std::tan(plane.friction) - share; });
}

// At two corners the heel of the tallest, with less weight on it, slips first: at 27.9 instead of 36.0 deg.
TEST(JointStrength, CohesionHoldsUpToLimitEquilibrium) {
    const double unit = density * gravity;
    for (const double slenderness : {0.2, 0.5, 0.9}) {
        for (const double friction : {0.0, 20.0}) {
            for (const double tension : {0.0, 2e4}) {
                OnPlane plane;
                plane.height_to_width = slenderness;
                plane.friction = degrees(friction);
                const double cohesion = 0.3 * unit * slenderness;
                expect_limit(plane, {cohesion, tension}, sliding_limit(plane, cohesion),
                             "a/b " + std::to_string(slenderness) + ", friction " + std::to_string(friction) +
                                 ", tension " + std::to_string(tension));
            }
        }
    }
}

// (W sin a / 2 - W cos b / 6) = t b^2 / 6, where that is more than the weight alone holds.
TEST(JointStrength, TensionHoldsTheMomentOfTheElasticSection) {
    OnPlane plane;
    plane.friction = degrees(40);
    for (const double slenderness : {2.0, 4.04}) {
        for (const double limit : {30.0, 50.0}) {
            plane.height_to_width = slenderness;
            const double tension =
                plane.weight() * (3 * slenderness * std::sin(degrees(limit)) - std::cos(degrees(limit)));
            expect_limit(plane, {100 * tension, tension}, degrees(limit),
                         "a/b " + std::to_string(slenderness) + ", " + std::to_string(limit) + " deg");
        }
    }
}

// The elastic section of a column of 4.04 m with 53 kPa parts at 7.1 deg: below atan(b / a) = 13.9 deg, up to which its
// weight alone holds it. At two corners it stood to 20.7 deg.
TEST(JointStrength, TensionOfLittleUseDoesNotHoldAColumn) {
    OnPlane plane;
    plane.height_to_width = 4.04;
    plane.friction = degrees(40);
    for (const double tension : {0.0, 1.0, 53e3, 100e3}) {
        expect_limit(plane, {530e3, tension}, std::atan(1 / 4.04), std::to_string(tension));
    }
}

// At two corners the heel, with less weight on it, slipped first and left its peak: at 24.6 deg, half as high as wide.
TEST(JointStrength, PeakFrictionHoldsTheWholeFace) {
    for (const double height_to_width : {0.1, 0.5, 1.0}) {
        for (const double part : {0.998, 1.002}) {
            OnPlane plane;
            plane.height_to_width = height_to_width;
            plane.friction = degrees(30);
            plane.tilt = part * plane.friction;
            RelaxationScene scene = relaxation_scenes::scene_of(plane);
            scene.material[0].residual_friction_angle = degrees(15);
            scene.bond = find_bonds(scene);
            EXPECT_EQ(relax(scene, until_onset()).outcome,
                      part < 1 ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset)
                << height_to_width;
        }
    }
}

TEST(JointStrength, CarriesAHangingBlockByItsWholeFace) {
    for (const double part : {0.998, 1.002}) {
        OnPlane plane;
        RelaxationScene scene;
        // The block touches over half of its width.
        scene.block = {{rectangle(0, -1, 1, 1), density},
                       fixed_block(rectangle(-0.75, 0, 1, 1)),
                       fixed_block(rectangle(0.75, 0, 1, 1))};
        scene.material = {joint(plane.stiffness(), degrees(30))};
        scene.material[0].tensile_strength = plane.weight() / 0.5 / part;
        scene.bond = find_bonds(scene);
        EXPECT_EQ(relax(scene, until_onset()).outcome,
                  part < 1 ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset);
    }
}

// The springs of the joint hold t^2 L^2 / (4 k) when it tears, of which its contacts, open, keep nothing.
TEST(JointStrength, TornGivesUpTheEnergyOfItsSprings) {
    RelaxationScene scene;
    scene.block = {{rectangle(0, -1, 1, 1), density}, fixed_block(rectangle(-1, 0, 3, 1))};
    scene.material = {joint(1e9, degrees(30))};
    constexpr double tension = 5e6;
    scene.material[0].tensile_strength = tension;
    scene.bond = find_bonds(scene);
    scene.force = {{0, {0.5, -0.5}, {0, -1.2 * tension}}};
    RelaxationSettings settings;
    settings.start = RelaxationStart::dropped;
    settings.duration = 0.02;
    const double torn = tension * tension / (4 * 1e9);
    for (const double damping : {0.0, 0.2}) {
        settings.viscous_damping = settings.local_damping = damping;
        settings.step_fraction = RelaxationSettings{}.step_fraction;
        EXPECT_LT(std::abs(relax(scene, settings).energy_balance.residual()), 1e-9 * torn) << "rounding";
        // It tears in the first step in which it is overloaded: short steps stretch it by about a hundredth.
        settings.step_fraction = 0.01;
        EXPECT_NEAR(relax(scene, settings).energy_balance.bonds, torn, 0.05 * torn);
    }
}

TEST(JointStrength, IsThatOfTheFaceHoweverManyVerticesItHas) {
    OnPlane plane;
    plane.height_to_width = 0.9;
    plane.friction = degrees(20);
    const double cohesion = 0.3 * density * gravity * 0.9;
    OnPlane column;
    column.height_to_width = 4.04;
    column.friction = degrees(40);
    const double tension = column.weight() * (3 * 4.04 * std::sin(degrees(30)) - std::cos(degrees(30)));
    for (const Vertices& vertices : {Vertices{1, 0}, Vertices{3, 0}, Vertices{0, 2}, Vertices{2, 3}}) {
        const std::string what = std::to_string(vertices.of_block) + ", " + std::to_string(vertices.of_ground);
        EXPECT_EQ(scene_of(plane, {cohesion, 0}, vertices).bond.size(), 1U);
        expect_limit(plane, {cohesion, 0}, sliding_limit(plane, cohesion), "slides, " + what, vertices);
        expect_limit(column, {100 * tension, tension}, degrees(30), "bends, " + what, vertices);
        expect_limit(column, {530e3, 0}, std::atan(1 / 4.04), "overturns, " + what, vertices);
    }
}

// A base on the ground with one joint at both ends and another without strength between: W sin = c l + W cos tan(phi).
TEST(JointStrength, IsThatOfTheLengthItRunsAlong) {
    OnPlane plane;
    plane.height_to_width = 0.2;
    plane.friction = degrees(20);
    const double cohesion = 0.3 * density * gravity * 0.2;
    const double limit = sliding_limit(plane, 0.75 * cohesion);
    for (const double part : {0.998, 1.002}) {
        OnPlane tilted = plane;
        tilted.tilt = part * limit;
        RelaxationScene scene = scene_of(tilted, {cohesion, 0}, {3, 0});
        scene.material.push_back(joint(scene.material[0].normal_stiffness, plane.friction - 1e-9));
        scene.block[0].joint = {0, 1, 0, 0, 0, 0, 0};
        scene.bond = find_bonds(scene);
        ASSERT_EQ(scene.bond.size(), 1U);
        EXPECT_EQ(relax(scene, until_onset()).outcome,
                  part < 1 ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset);
    }
}

TEST(JointStrength, IsSpreadWhereItCanBeLost) {
    const auto bonds = [](const std::function<void(JointMaterial&)>& change) {
        RelaxationScene scene = relaxation_scenes::scene_of(OnPlane{});
        change(scene.material[0]);
        return find_bonds(scene).size();
    };
    EXPECT_EQ(bonds([](JointMaterial&) {}), 0U);
    EXPECT_EQ(bonds([](JointMaterial& one) { one.cohesion = 1; }), 1U);
    EXPECT_EQ(bonds([](JointMaterial& one) { one.tensile_strength = 1; }), 1U);
    EXPECT_EQ(bonds([](JointMaterial& one) { one.residual_friction_angle = one.friction_angle / 2; }), 1U);
    // Perfectly plastic corners add up to limit equilibrium themselves.
    EXPECT_EQ(bonds([](JointMaterial& one) { one.cohesion = one.residual_cohesion = 1; }), 0U);
    // The lesser cohesion of two joints in contact counts.
    RelaxationScene scene = relaxation_scenes::scene_of(OnPlane{});
    scene.material.push_back(joint(scene.material[0].normal_stiffness, degrees(50)));
    scene.block[1].joint = {1, 1, 1, 1};
    scene.material[1].cohesion = 1;
    EXPECT_TRUE(find_bonds(scene).empty());
    scene.material[0].cohesion = 1;
    ASSERT_EQ(find_bonds(scene).size(), 1U);
    EXPECT_FALSE(find_bonds(scene)[0].of_rock);
}

TEST(JointStrength, OfTwoFacesTheLesserOfEachStrengthCounts) {
    RelaxationScene scene = relaxation_scenes::scene_of(OnPlane{});
    JointMaterial one = joint(1e9, degrees(28));
    one.cohesion = 1e6;
    one.residual_cohesion = 2e5;
    one.tensile_strength = 1e5;
    one.bond = BondMaterial{20e9, 8e9, 50e3, 15e3, degrees(40)};
    JointMaterial other = joint(2e9, degrees(30));
    other.residual_friction_angle = degrees(25);
    other.cohesion = 3e5;
    other.residual_cohesion = 3e5;
    scene.material = {one, other};
    scene.block[1].joint = {1, 1, 1, 1};
    const Bodies bodies = make_bodies(scene);
    const JointMaterial both = joint_between(scene, bodies, bodies.range[0].begin, bodies.range[1].begin + 2);
    EXPECT_EQ(both, joint_between(scene, bodies, bodies.range[1].begin + 2, bodies.range[0].begin));
    EXPECT_EQ(both.normal_stiffness, 1e9);
    EXPECT_EQ(both.friction_angle, degrees(28));
    EXPECT_EQ(both.residual_friction_angle, degrees(25));
    EXPECT_EQ(both.cohesion, 3e5);
    EXPECT_EQ(both.residual_cohesion, 2e5);
    EXPECT_EQ(both.tensile_strength, 0);
    EXPECT_FALSE(both.bond);
    scene.material[1].bond = BondMaterial{30e9, 6e9, 5e3, 100e3, degrees(20)};
    EXPECT_EQ(joint_between(scene, bodies, bodies.range[0].begin, bodies.range[1].begin + 2).bond,
              (BondMaterial{20e9, 6e9, 5e3, 15e3, degrees(20)}));
    EXPECT_EQ(joint_between(scene, bodies, bodies.range[0].begin, bodies.range[0].begin), one);
}

// Squares that hold together by their joints alone, and fall apart on a slope.
RelaxationScene weak_wall(std::size_t columns, std::size_t rows, double tension) {
    RelaxationScene scene;
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            scene.block.push_back({rectangle(static_cast<double>(column), static_cast<double>(row), 1, 1), density});
        }
    }
    scene.block.push_back(fixed_block(rectangle(-2, -1, static_cast<double>(columns) + 4, 1)));
    scene.material = {joint(1e9, degrees(20))};
    scene.material[0].cohesion = 4e4;
    scene.material[0].tensile_strength = tension;
    scene.gravity.tilt = scene.gravity.final_tilt = degrees(40);
    scene.bond = find_bonds(scene);
    return scene;
}

std::ptrdiff_t broken(const Simulation& simulation) {
    return std::ranges::count_if(simulation.state().bond,
                                 [](const BondMemory& memory) { return is_broken(memory.state); });
}

TEST(JointStrength, GoesOnFromCheckpointsAndForAnyNumberOfThreads) {
    for (const double tension : {0.0, 2e4}) {
        const RelaxationScene scene = weak_wall(18, 16, tension);
        ASSERT_GT(scene.bond.size(), 512U);
        RelaxationSettings settings;
        settings.start = RelaxationStart::dropped;
        Simulation whole(scene, settings);
        settings.threads = 2;
        Simulation divided(scene, settings);
        constexpr int steps = 500;
        std::string middle;
        for (int step = 0; step < steps; ++step) {
            if (step == steps / 2) {
                middle = checkpoint_of(scene, whole.settings(), whole.state());
            }
            whole.step();
            divided.step();
        }
        const std::string end = checkpoint_of(scene, whole.settings(), whole.state());
        EXPECT_GT(broken(whole), 0);
        EXPECT_LT(broken(whole), static_cast<std::ptrdiff_t>(scene.bond.size()));
        EXPECT_TRUE(checkpoint_of(scene, divided.settings(), divided.state()) == end);
        RestoredState restored = restore_checkpoint(middle, scene, whole.settings());
        ASSERT_EQ(restored.check, CheckpointCheck::ok);
        Simulation rest(scene, whole.settings(), std::move(restored.state));
        for (int step = steps / 2; step < steps; ++step) {
            rest.step();
        }
        EXPECT_TRUE(checkpoint_of(scene, rest.settings(), rest.state()) == end);
    }
}

TEST(JointStrength, BooksOfAWallThatFallsApartBalance) {
    RelaxationSettings settings;
    settings.start = RelaxationStart::dropped;
    settings.local_damping = 0;
    settings.duration = 0.4;
    for (const double tension : {0.0, 2e4}) {
        // Explicit steps of 0.6 of the stable one leave this error in any run of colliding blocks.
        EXPECT_LT(energy_error(relax(weak_wall(4, 4, tension), settings), 0), 0.02) << tension;
    }
}

RelaxationStudy block_in_a_row(double height, const RelaxationJoint& base, const CriticalRequest& critical) {
    RelaxationRow row{};
    row.tilt = degrees(25);
    row.density = density;
    row.interface.friction_angle = degrees(40);
    row.base = base;
    row.block = {{1, height, {}}};
    RelaxationStudy study{};
    study.model.scene = row;
    study.settings = RelaxationNumerics{};
    study.settings->stop = RelaxationStop::onset;
    study.critical = critical;
    return study;
}

// A slope cut by one set of joints, its base and its back fixed; coordinates in m.
RelaxationStudy sheared_slope(double tension) {
    RelaxationJoint joint{};
    joint.friction_angle = degrees(21.4);
    joint.cohesion = 40e3;
    joint.tensile_strength = tension;
    RelaxationPolygons blocks{0, {joint}, {}};
    const std::vector<Polygon<>> outlines{{{0, 0}, {0.22, 0}, {4.55, 11.4}, {1.36, 11.4}},
                                          {{0.22, 0}, {3.64, 0}, {7.97, 11.4}, {4.55, 11.4}},
                                          {{3.64, 0}, {7.06, 0}, {11.38, 11.4}, {7.97, 11.4}},
                                          {{7.06, 0}, {10.47, 0}, {14.8, 11.4}, {11.38, 11.4}},
                                          {{10.47, 0}, {13.89, 0}, {17.35, 9.12}, {17.35, 11.4}, {14.8, 11.4}},
                                          {{13.89, 0}, {17.31, 0}, {17.35, 0.13}, {17.35, 9.12}},
                                          {{17.31, 0}, {17.35, 0}, {17.35, 0.13}},
                                          rectangle(-3, -2, 22.35, 2),
                                          rectangle(17.35, 0, 2, 11.4)};
    for (const Polygon<>& outline : outlines) {
        RelaxationPolygon block{density, {}, {}, {}};
        if (blocks.block.size() + 2 >= outlines.size()) {
            block.hold = BlockHold::fixed;
        }
        for (const PlanePoint<>& vertex : outline) {
            block.vertex.push_back({vertex.x(), vertex.y(), {}});
        }
        blocks.block.push_back(std::move(block));
    }
    RelaxationStudy study{};
    study.model.scene = std::move(blocks);
    study.settings = RelaxationNumerics{};
    study.settings->stop = RelaxationStop::onset;
    study.critical = ReductionSearch{};
    return study;
}

// Toes keep their half of the cohesion when heels lift off. Joints with a tensile strength of 1 Pa lost all of it
// there, and the slope had a factor of 2.91.
TEST(JointStrength, OfTheEndThatStaysPressedIsKept) {
    const CriticalAnswer without = find_critical(sheared_slope(0));
    const CriticalAnswer with = find_critical(sheared_slope(1));
    ASSERT_EQ(without.status, CriticalStatus::found);
    ASSERT_EQ(with.status, CriticalStatus::found);
    EXPECT_NEAR(with.value(), without.value(), 0.005) << "a bracket";
    EXPECT_NEAR(without.value(), 3.658, 0.005) << "regression";
}

// A push leans a column against a stop, so that its heel is open at rest by 2 mm, and then ends: the heel closes, but
// its half of the cohesion is gone.
TEST(JointStrength, OfAnEndThatIsOpenAtRestIsLost) {
    OnPlane plane;
    plane.height_to_width = 2;
    plane.friction = degrees(20);
    RelaxationScene scene = scene_of(plane);
    constexpr double cohesion = 20e3;
    scene.material[0].cohesion = cohesion;
    scene.material.push_back(joint(plane.stiffness(), degrees(5)));
    scene.block.push_back(fixed_block(rectangle(-1.004, 1.5, 1, 1)));
    scene.block.back().joint = {1, 1, 1, 1};
    scene.bond = find_bonds(scene);
    const auto pushed = [&](double share_of_weight, double height) {
        RelaxationScene made = scene;
        made.force = {{0, {0.5, height}, {share_of_weight * plane.weight(), 0}}};
        return made;
    };
    const auto at_end = [](Simulation&& simulation) {
        while (simulation.running()) {
            simulation.step();
        }
        return std::pair(simulation.outcome(), simulation.state());
    };
    const RelaxationSettings settings = until_onset();
    const auto [leaning, with_open_heel] = at_end(Simulation(pushed(-0.32, 1.9), settings));
    ASSERT_EQ(leaning, RelaxationOutcome::equilibrium);
    const auto [upright, closed_again] = at_end(Simulation(scene, settings, ConsolidatedState{with_open_heel}));
    ASSERT_EQ(upright, RelaxationOutcome::equilibrium);
    const double left = std::tan(plane.friction) + cohesion * plane.width / 2 / plane.weight();
    for (const double share : {0.95, 1.05}) {
        const RelaxationOutcome sheared =
            at_end(Simulation(pushed(share * left, 0), settings, ConsolidatedState{closed_again})).first;
        EXPECT_EQ(sheared, share < 1 ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset) << share;
    }
}

// The factor of safety of a case is (c b + W cos tan(phi)) / (W sin), with W / b = 0.9 m of rock.
TEST(JointStrength, DividedIsAFactorOfSafety) {
    RelaxationJoint base{};
    base.friction_angle = degrees(20);
    base.cohesion = 7e3;
    const double weight = density * gravity * 0.9;
    const double expected =
        (7e3 + weight * std::cos(degrees(25)) * std::tan(degrees(20))) / (weight * std::sin(degrees(25)));
    const CriticalAnswer found = find_critical(block_in_a_row(0.9, base, ReductionSearch{}));
    ASSERT_EQ(found.status, CriticalStatus::found);
    EXPECT_NEAR(found.value(), expected, 0.0025 + 0.001) << "half the bracket, and the springs";
}

TEST(JointStrength, OfAColumnInACase) {
    RelaxationJoint base{};
    base.friction_angle = degrees(40);
    base.cohesion = 8e6;
    base.tensile_strength = 800e3;
    TiltSearch search{};
    search.lower = degrees(1);
    search.upper = degrees(80);
    const double limit = root(
        [&](double tilt) { return density * gravity * 4.04 * (3 * 4.04 * std::sin(tilt) - std::cos(tilt)) - 800e3; });
    const CriticalAnswer found = find_critical(block_in_a_row(4.04, base, search));
    ASSERT_EQ(found.status, CriticalStatus::found);
    EXPECT_NEAR(found.value(), limit, degrees(0.0025 + 0.001));
}

// One plane of 35 deg in a slope of 12 m, cohesive from end to end.
TEST(JointStrength, OfAPlaneInASlope) {
    const double dip = degrees(35);
    const PlanePoint<> toe(0.5 / std::tan(degrees(60)), 0.5);
    const PlanePoint<> top(toe.x() + 11.5 / std::tan(dip), 12);
    const double crest = 12 / std::tan(degrees(60));
    for (const double cohesion : {5e3, 20e3}) {
        RelaxationSlope slope{};
        slope.geometry = testing::section({{-10, -6}, {30, -6}, {30, 12}, {crest, 12}, {0, 0}, {-10, 0}},
                                          {testing::cut("plane", testing::line({{toe.x(), toe.y()}, {top.x(), 12}}))});
        slope.geometry.intact_joint = "joint";
        slope.rock = {{"rock", density}};
        RelaxationJoint plane{};
        plane.friction_angle = degrees(30);
        plane.cohesion = cohesion;
        slope.joint = {{"joint", {}, plane}};
        slope.frame = SlopeFrame{FrameSides::all_around, 3, {}, "joint"};
        slope.fixed = {{{{-11, -7}, {31, -7}, {31, 13}, {top.x(), 13}, {top.x(), 12}, {toe.x(), toe.y()}, {-11, 0.5}}}};
        RelaxationStudy study{};
        study.model.scene = slope;
        study.settings = RelaxationNumerics{};
        study.settings->stop = RelaxationStop::onset;
        study.critical = ReductionSearch{};
        const double weight = density * gravity * area_properties(Polygon<>{toe, top, {crest, 12}}).area;
        const double expected =
            (cohesion * (top - toe).norm() + weight * std::cos(dip) * std::tan(degrees(30))) / (weight * std::sin(dip));
        const CriticalAnswer found = find_critical(study);
        ASSERT_EQ(found.status, CriticalStatus::found) << cohesion;
        EXPECT_NEAR(found.value(), expected, 0.0025 + 0.001) << cohesion;
    }
}

}  // namespace
}  // namespace delabole
