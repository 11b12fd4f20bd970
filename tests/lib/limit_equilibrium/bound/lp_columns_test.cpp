// The bound by linear programming on stepped bases, against the recursion, and on columns cut by cross joints.
#include "limit_equilibrium/bound/block_assembly.hpp"
#include "limit_equilibrium/bound/lp_bound.hpp"
#include "tests/lib/limit_equilibrium/bound/least_support.hpp"
#include "tests/lib/limit_equilibrium/columns/reference_recursion.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace delabole;

ColumnScene<> block_scene(double base_dip, const std::vector<double>& heights, double width, double step) {
    ColumnScene<> scene{};
    BlockColumns<> layout{degrees(90) - base_dip, {}};
    for (const double height : heights) {
        layout.block.push_back({height, width, step, {}});
    }
    scene.columns = layout;
    scene.rock = {25e3};
    scene.water = Dry{};
    return scene;
}

// Thesis, Appendix A: friction of 41.1415 deg by the recursion.
ColumnScene<> appendix_a() {
    return block_scene(degrees(21.8), {1, 2, 3, 4, 3.1, 2.2, 1.3, 0.4}, 1, 0.5);
}

// Goodman & Bray (1976), 16 blocks: 38.1512 deg by the recursion.
ColumnScene<> goodman_bray() {
    std::vector<double> heights;
    for (int number = 1; number <= 16; ++number) {
        heights.push_back(number <= 10 ? 4.0 * number : 40.0 - 6.0 * (number - 10));
    }
    return block_scene(degrees(30), heights, 10, 1);
}

BlockFriction equal_friction(double angle) {
    return {angle, angle};
}

double limit_by_programme(const ColumnSlope<>& slope, double upper_part) {
    const LpBound bound = least_strength_factor(assemble_columns(slope, equal_friction(degrees(45)), upper_part));
    EXPECT_EQ(bound.status, LpStatus::optimal);
    EXPECT_LT(bound.residuals.imbalance, 1e-9);
    return std::atan(bound.value) / degrees(1);
}

double limit_by_recursion(const ColumnSlope<>& slope) {
    return std::atan(1 / test::factor_of_safety(slope, 1, 1)) / degrees(1);
}

// The recursion puts interblock forces on the tops of the joints, where the toppling columns press. The programme may
// put them low, and then finds forces for far less friction; held to the tops it agrees.
void expect_bracket(const ColumnScene<>& scene, double recursion, double programme) {
    const ColumnSlope<> slope = make_columns(scene);
    EXPECT_NEAR(limit_by_recursion(slope), recursion, 1e-4);  // printed digits
    // This is our own number, which forces and mechanism bound from both sides (LpResiduals).
    EXPECT_NEAR(limit_by_programme(slope, whole_joint), programme, 1e-4);
    double last = programme - 1e-4;
    for (const double upper_part : {0.5, 0.1, 0.01, 1e-4}) {
        const double limit = limit_by_programme(slope, upper_part);
        EXPECT_GT(limit, last);
        EXPECT_LT(limit, recursion);
        last = limit;
    }
    // The remaining part is an error of first order: about 2 deg for a tenth.
    EXPECT_NEAR(limit_by_programme(slope, 1e-6), limit_by_recursion(slope), 3e-5);
}

TEST(LpColumns, BracketOfAppendixA) {
    expect_bracket(appendix_a(), 41.1415, 32.6572);
}

TEST(LpColumns, BracketOfGoodmanAndBray) {
    expect_bracket(goodman_bray(), 38.1512, 33.4454);
}

// Verification deck: P by the recursion at its limit, the lowest column sliding; the programme's resultants are the
// same once they act on the tops.
TEST(LpColumns, ForcesOnTopsAreThoseOfTheRecursion) {
    const Assembly assembly = assemble_columns(make_columns(appendix_a()), equal_friction(degrees(45)), 1e-6);
    const LpBound bound = least_strength_factor(assembly);
    ASSERT_EQ(bound.status, LpStatus::optimal);
    const std::vector<double> expected = {1.857481, 0.989456, 0.567051, 0.111377, 0, 0, 0};
    std::vector<double> thrusts;
    for (std::size_t index = 0; index < assembly.contacts.size(); ++index) {
        if (assembly.contacts[index].other) {
            thrusts.push_back(bound.forces[index].normal() / 25e3);
        }
    }
    ASSERT_EQ(thrusts.size(), expected.size());
    for (std::size_t index = 0; index < expected.size(); ++index) {
        EXPECT_NEAR(thrusts[index], expected[index], 1e-5) << index;  // as the joint's part, 1e-6, times its length
    }
}

TEST(LpColumns, ForcesOfTheBoundActLow) {
    const Assembly assembly = assemble_columns(make_columns(appendix_a()), equal_friction(degrees(45)), whole_joint);
    const LpBound bound = least_strength_factor(assembly);
    ASSERT_EQ(bound.status, LpStatus::optimal);
    for (std::size_t index = 0; index < assembly.contacts.size(); ++index) {
        const Contact& contact = assembly.contacts[index];
        // The joints above the columns that the mechanism tips, 2 to 4.
        if (contact.other && contact.body >= 1 && contact.body <= 3) {
            EXPECT_LT(bound.forces[index].position, 0.5 * contact.length()) << contact.body;
        }
    }
}

// Weight, water, earthquake and bolts of a slope: the recursion's forces are among those the programme may choose, as
// long as they keep to strength and faces, so that it never needs more friction.
TEST(LpColumns, NeverAsksForMoreThanTheRecursion) {
    ColumnScene<> scene = goodman_bray();
    for (const double filled : {0.0, 0.2, 0.4}) {
        for (const double seismic : {0.0, 0.05, 0.1}) {
            scene.water = FilledJointsWater<>{9.81e3, filled};
            scene.seismic = SeismicLoad<>{};
            scene.seismic->horizontal_coefficient = seismic;
            for (const double bolt : {0.0, 2e6}) {
                scene.bolt = {{1, bolt, 0, 2}};
                const ColumnSlope<> slope = make_columns(scene);
                ASSERT_EQ(slope.check, ColumnCheck::valid);
                const LpBound bound =
                    least_strength_factor(assemble_columns(slope, equal_friction(degrees(45)), whole_joint));
                ASSERT_EQ(bound.status, LpStatus::optimal);
                EXPECT_LE(bound.value, 1 / test::factor_of_safety(slope, 1, 1));
            }
        }
    }
}

// A single column: moments about its toe corner, or sliding, are the whole of it.
TEST(LpColumns, LoadsOfOneColumnArriveWhole) {
    ColumnScene<> scene = block_scene(degrees(20), {6}, 2, 0);
    scene.seismic = SeismicLoad<>{};
    scene.seismic->horizontal_coefficient = 0.15;
    scene.point_load = {{1, 4e4, degrees(120), 5}};
    const ColumnSlope<> slope = make_columns(scene);
    ASSERT_EQ(slope.check, ColumnCheck::valid);
    const Column<>& column = slope.columns.front();
    const Assembly assembly = assemble_columns(slope, {degrees(89), 0}, whole_joint);
    // Support along the base's dip at 6 m above it, against toppling.
    const Point up_dip(std::cos(slope.base_dip), std::sin(slope.base_dip));
    const Point normal(-up_dip.y(), up_dip.x());
    ASSERT_GT(column.overturning_moment, 0);
    EXPECT_NEAR(least_support_force(assembly, 0, 6 * normal, up_dip), column.overturning_moment / 6,
                1e-9 * column.weight);
}

// West face of Old Delabole, 1967, with the wedge on joint A at 70 deg above its columns.
ColumnSlope<> slide_head_slope(double filled) {
    ColumnScene<> scene{};
    scene.slope = SlopeSection<>{225 * 0.3048, degrees(70), 0, {}, {}};
    scene.columns = ContinuousColumns<>{degrees(85), 2, degrees(21), 75 * 0.3048};
    scene.rock = {27e3};
    scene.water = Dry{};
    scene.slide_head = SlideHead<>{degrees(70), degrees(35), 2e4, HeadWater<>{9.81e3, filled}};
    return make_columns(scene);
}

// With the columns held fast the wedge is one block between two fixed faces, which the thrust's own derivation solves.
TEST(LpColumns, WedgeAboveTheColumnsPushesAsDerived) {
    for (const double filled : {0.0, 0.5}) {
        const ColumnSlope<> slope = slide_head_slope(filled);
        ASSERT_EQ(slope.check, ColumnCheck::valid);
        const double joint_friction = std::tan(degrees(30));
        Assembly assembly = assemble_columns(slope, equal_friction(degrees(30)), whole_joint);
        ASSERT_EQ(assembly.check, AssemblyCheck::valid);
        // The wedge alone, resting on its joint; what it lacks is a force on its face, sheared as it slides down past
        // it.
        Assembly alone;
        alone.check = AssemblyCheck::valid;
        alone.bodies = {assembly.bodies.back()};
        for (Contact contact : assembly.contacts) {
            if (!contact.other && contact.body + 1 == assembly.bodies.size()) {
                contact.body = 0;
                alone.contacts = {contact};
            }
        }
        ASSERT_EQ(alone.contacts.size(), 1U);
        const SlideHeadThrust<> thrust = slide_head_thrust(*slope.slide_head, slope.base_dip, joint_friction, 1.0);
        ASSERT_EQ(thrust.state, SlideHeadState::pushes);
        const Point up_dip(std::cos(slope.base_dip), std::sin(slope.base_dip));
        const Point up_joint(-up_dip.y(), up_dip.x());
        // The support acts where the wedge's loads meet the joint, so that only forces matter.
        const double support =
            least_support_force(alone, 0, alone.bodies[0].centroid, up_dip + joint_friction * up_joint);
        EXPECT_NEAR(support, thrust.force * std::hypot(1, joint_friction), 1e-9 * thrust.force);

        const LpBound whole = least_strength_factor(assembly);
        ASSERT_EQ(whole.status, LpStatus::optimal);
        EXPECT_LT(whole.residuals.imbalance, 1e-9);
        EXPECT_LE(whole.value, 1 / test::factor_of_safety(slope, joint_friction, joint_friction));
    }
}

TEST(LpColumns, CutColumnsAreNoStrongerThanWholeOnes) {
    for (const ColumnScene<>& scene : {appendix_a(), goodman_bray()}) {
        const ColumnSlope<> slope = make_columns(scene);
        const double width = slope.columns.front().width;
        const double whole =
            least_strength_factor(assemble_columns(slope, equal_friction(degrees(45)), whole_joint)).value;
        // Every force state of cut columns is, summed over their joints, one of whole columns.
        for (const double spacing : {5.0, 2.0, 1.0, 0.5}) {
            for (const double offset : {0.0, 0.5}) {
                const Assembly cut = assemble_blocks(slope, {spacing * width, offset * spacing * width, degrees(45)},
                                                     equal_friction(degrees(45)));
                const LpBound bound = least_strength_factor(cut);
                ASSERT_EQ(bound.status, LpStatus::optimal);
                EXPECT_LT(bound.residuals.imbalance, 1e-9);
                EXPECT_GE(bound.value, whole * (1 - 1e-9));
            }
        }
        // Joints above all columns cut nothing.
        const LpBound uncut =
            least_strength_factor(assemble_blocks(slope, {100 * width, 0, degrees(45)}, equal_friction(degrees(45))));
        EXPECT_NEAR(uncut.value, whole, 1e-10);
    }
}

bool stands_with(Assembly assembly, double strength) {
    for (Contact& contact : assembly.contacts) {
        contact.friction_angle = std::atan(strength * std::tan(contact.friction_angle));
    }
    const LpBound tilt = largest_tilt(assembly);
    EXPECT_EQ(tilt.status, LpStatus::optimal);
    return tilt.value >= 0;
}

// A little more friction than the answer holds a random slope of blocks, a little less does not; where it has no answer
// hardly any friction is enough.
TEST(LpColumns, RandomBlocksStandJustAboveTheAnswer) {
    RandomProblem random(3010);
    int limited = 0;
    int hopeless = 0;
    for (int repeat = 0; repeat < 60; ++repeat) {
        const double width = std::exp(random.uniform(-2, 3));
        std::vector<double> heights;
        for (int column = 0; column < 6; ++column) {
            heights.push_back(width * std::exp(random.uniform(0, 2)));
        }
        const ColumnSlope<> slope =
            make_columns(block_scene(degrees(random.uniform(3, 30)), heights, width, 0.3 * width));
        ASSERT_EQ(slope.check, ColumnCheck::valid);
        const CrossJoints joints{width * random.uniform(0.5, 4), 0, degrees(random.uniform(5, 60))};
        const Assembly assembly =
            assemble_blocks(slope, joints, {degrees(random.uniform(5, 60)), degrees(random.uniform(5, 60))});
        const LpBound bound = least_strength_factor(assembly);
        if (bound.status == LpStatus::infeasible) {
            ++hopeless;
            EXPECT_FALSE(stands_with(assembly, 100));
            continue;
        }
        ASSERT_EQ(bound.status, LpStatus::optimal);
        ++limited;
        EXPECT_TRUE(stands_with(assembly, bound.value * (1 + 1e-8)));
        EXPECT_FALSE(stands_with(assembly, bound.value * (1 - 1e-8)));
    }
    // The sample has both kinds of slopes.
    EXPECT_GT(limited, 10);
    EXPECT_GT(hopeless, 5);
}

// A stack slides on the weakest of its faces, whatever the others are.
TEST(LpColumns, StackSlidesOnItsCrossJoint) {
    const ColumnSlope<> slope = make_columns(block_scene(degrees(10), {4}, 8, 0));
    const Assembly stack = assemble_blocks(slope, {1, 0, degrees(20)}, equal_friction(degrees(40)));
    EXPECT_EQ(stack.bodies.size(), 4U);
    const LpBound bound = least_strength_factor(stack);
    ASSERT_EQ(bound.status, LpStatus::optimal);
    EXPECT_NEAR(bound.value, std::tan(degrees(10)) / std::tan(degrees(20)), 1e-10);
}

TEST(LpColumns, CutsKeepWeightAndHeight) {
    const ColumnSlope<> slope = make_columns(goodman_bray());
    const Assembly cut = assemble_blocks(slope, {3, 1.5, degrees(30)}, equal_friction(degrees(30)));
    ASSERT_EQ(cut.check, AssemblyCheck::valid);
    double weight = 0;
    Point moment(0, 0);
    for (const Body& body : cut.bodies) {
        weight += body.weight;
        moment += body.weight * body.centroid;
    }
    double whole_weight = 0;
    Point whole_moment(0, 0);
    for (const Body& body : assemble_columns(slope, equal_friction(degrees(30)), whole_joint).bodies) {
        whole_weight += body.weight;
        whole_moment += body.weight * body.centroid;
    }
    EXPECT_NEAR(weight, whole_weight, 1e-12 * whole_weight);
    EXPECT_NEAR((moment - whole_moment).norm(), 0, 1e-12 * whole_moment.norm());
    double joint_length = 0;
    for (const Contact& contact : cut.contacts) {
        const bool along_columns = std::abs(contact.normal().y()) < std::cos(slope.base_dip) - 1e-6;
        joint_length += contact.other && along_columns ? contact.length() : 0;
    }
    double expected = 0;
    for (const Column<>& column : slope.columns) {
        expected += column.joint_length;
    }
    EXPECT_NEAR(joint_length, expected, 1e-9 * expected);
}

TEST(LpColumns, RefusesByName) {
    const BlockFriction friction = equal_friction(degrees(30));
    const CrossJoints joints{1, 0, degrees(30)};
    const ColumnSlope<> slope = make_columns(appendix_a());
    EXPECT_EQ(assemble_columns({}, friction, whole_joint).check, AssemblyCheck::columns_not_valid);
    EXPECT_EQ(assemble_blocks({}, joints, friction).check, AssemblyCheck::columns_not_valid);
    EXPECT_EQ(assemble_columns(slope, friction, 0).check, AssemblyCheck::input_out_of_range);
    EXPECT_EQ(assemble_blocks(slope, {0, 0, 0}, friction).check, AssemblyCheck::cross_joints_too_near);
    EXPECT_EQ(assemble_blocks(slope, {1, 1, 0}, friction).check, AssemblyCheck::cross_joints_too_near);
    EXPECT_EQ(assemble_blocks(slope, {1e-9, 0, 0}, friction).check, AssemblyCheck::cross_joints_too_near);
    ColumnScene<> wet = appendix_a();
    wet.water = FilledJointsWater<>{9.81e3, 0.5};
    EXPECT_EQ(assemble_blocks(make_columns(wet), joints, friction).check, AssemblyCheck::loads_beyond_weight);
    ColumnSlope<> flat = slope;
    flat.columns[2].height = 0;
    EXPECT_EQ(assemble_columns(flat, friction, whole_joint).check, AssemblyCheck::block_without_size);
}

}  // namespace
