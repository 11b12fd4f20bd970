// Strength that bonded rock needs to stand, by reduction, and where it cracks.
#include "dynamic_relaxation/step/bond_strength.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "dynamic_relaxation/study/cracks.hpp"
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace delabole {
namespace {

using namespace relaxation_scenes;

constexpr double length = 2;
constexpr double depth = 0.2;
constexpr double unit_strength = 1e5;  // Pa

void bond(RelaxationScene& scene) {
    scene.material = {joint(1e6 * density * gravity * depth, degrees(30))};
    scene.material[0].bond = 0;
    scene.bond_material = {{1e11, 4e10, unit_strength, 10 * unit_strength, degrees(30), {}}};
    scene.bond = find_bonds(scene);
}

// Blocks 0 to n - 1 along x out of a wall at x = 0, which is block n.
RelaxationScene cantilever(std::size_t blocks) {
    RelaxationScene scene;
    const double width = length / static_cast<double>(blocks);
    for (std::size_t block = 0; block < blocks; ++block) {
        scene.block.push_back({rectangle(static_cast<double>(block) * width, 0, width, depth), density});
    }
    scene.block.push_back(fixed_block(rectangle(-depth, -depth, depth, 3 * depth)));
    bond(scene);
    return scene;
}

// Bending stress at the wall over the unit.
double needed_share() {
    return 3 * density * gravity * length * length / depth / unit_strength;
}

StrengthReduction reduction(double failed_area) {
    return {1e3, 1e-2, 0.95, 0.05 * depth, failed_area, 2 * depth, 1e-5, 2};
}

RelaxationSettings settings() {
    RelaxationSettings made;
    made.local_damping = 0.7;
    made.equilibrium_ratio = 1e-4;
    return made;
}

TEST(BondStrength, OfACantileverIsThatOfBeamTheory) {
    const CriticalStrength critical = find_critical_strength(cantilever(4), settings(), reduction(0.1));
    ASSERT_EQ(critical.status, StrengthStatus::found);
    // The bracket of one step, and the balance found to 1e-4 of a block's weight.
    EXPECT_LT(critical.fails, needed_share());
    EXPECT_GT(critical.stands, needed_share() * (1 - 1e-3));
    EXPECT_NEAR(critical.fails, 0.95 * critical.stands, 1e-9 * critical.stands);
    // At rest unbroken, and at the one share that breaks the wall.
    EXPECT_EQ(critical.runs, 2U);
    EXPECT_TRUE(critical.end.loose.empty());
}

TEST(BondStrength, CracksAtTheWall) {
    const StrengthReduction given = reduction(0.1);
    const CriticalStrength critical = find_critical_strength(cantilever(4), settings(), given);
    EXPECT_EQ(crack_path(critical.end).broken, 1U);

    const Bodies bodies = make_bodies(critical.end.scene);
    const std::vector<BrokenBond> broken = broken_bonds(critical.end.scene, bodies, critical.end.state);
    ASSERT_EQ(broken.size(), 1U);
    EXPECT_NEAR((broken[0].to - broken[0].from).norm(), depth, 1e-12);
    EXPECT_GT(broken[0].time, 0);
    EXPECT_LT(broken[0].time, critical.end.state.time);
}

TEST(BondStrength, AtOnceIsTheSameForOneBond) {
    const auto status = [](double share) {
        return run_at_strength(cantilever(4), settings(), reduction(0.1), share).status;
    };
    EXPECT_EQ(status(1.01 * needed_share()), StrengthStatus::stands_however_weak);
    EXPECT_EQ(status(0.99 * needed_share()), StrengthStatus::found);
}

TEST(BondStrength, IsAStressOverTheWeight) {
    RelaxationScene heavy = cantilever(4);
    for (RelaxationBlock& block : heavy.block) {
        block.density *= 2;
    }
    heavy.bond_material[0].tensile_strength *= 2;
    heavy.bond_material[0].cohesion *= 2;
    const StrengthReduction given = reduction(0.1);
    EXPECT_EQ(find_critical_strength(heavy, settings(), given).fails,
              find_critical_strength(cantilever(4), settings(), given).fails);
}

// The whole cantilever is smaller than what counts as failed.
TEST(BondStrength, ALooseBlockIsNoFailure) {
    const CriticalStrength critical = run_at_strength(cantilever(1), settings(), reduction(1), needed_share() / 2);
    EXPECT_EQ(critical.status, StrengthStatus::stands_however_weak);
    ASSERT_EQ(critical.end.loose.size(), 1U);
    EXPECT_EQ(critical.end.loose[0], 0U);
    EXPECT_EQ(critical.end.state.removed[0], 1);
}

// Two blocks glued together slide down what is steeper than their friction.
TEST(BondStrength, MayNotHelp) {
    RelaxationScene scene;
    scene.block = {{rectangle(0, 0, 1, 1), density}, {rectangle(1, 0, 1, 1), density}};
    scene.block.push_back(fixed_block(rectangle(-20, -1, 30, 1)));
    bond(scene);
    std::erase_if(scene.bond, [](const FaceBond& made) { return made.other == 2; });
    ASSERT_EQ(scene.bond.size(), 1U);
    const auto status = [&](double tilt) {
        scene.gravity.tilt = scene.gravity.final_tilt = tilt;
        return find_critical_strength(scene, settings(), reduction(1.5)).status;
    };
    EXPECT_EQ(status(degrees(31)), StrengthStatus::fails_however_strong);
    EXPECT_EQ(status(degrees(29)), StrengthStatus::stands_however_weak);
}

TEST(Cracks, JointsAreOpenWhereFacesHaveParted) {
    RelaxationScene scene;
    scene.block = {{rectangle(0, 0, 1, 2), density}, {rectangle(1, 0, 1, 2), density}};
    scene.block.push_back(fixed_block(rectangle(-3, -1, 8, 1)));
    scene.material = {joint(1e9, degrees(30))};
    const Bodies bodies = make_bodies(scene);
    RelaxationState state;
    state.motion.resize(3);
    state.removed.resize(3, 0);
    EXPECT_TRUE(open_joints(scene, bodies, state, 1e-3).empty());
    state.motion[1].x = 0.01;
    const std::vector<OpenJoint> open = open_joints(scene, bodies, state, 1e-3);
    ASSERT_EQ(open.size(), 1U);
    EXPECT_NEAR(open[0].opening, 0.01, 1e-12);  // rounding
    EXPECT_NEAR((open[0].to - open[0].from).norm(), 2, 1e-12);
    EXPECT_TRUE(open_joints(scene, bodies, state, 0.02).empty());
    // Slid past each other, they are no joint any more.
    state.motion[1].y = 3;
    EXPECT_TRUE(open_joints(scene, bodies, state, 1e-3).empty());
}

}  // namespace
}  // namespace delabole
