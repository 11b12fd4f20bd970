// Tests where bonded rock has broken, and which joints stand open.
#include "dynamic_relaxation/study/cracks.hpp"
#include "dynamic_relaxation/step/simulation.hpp"
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

using namespace relaxation_scenes;

constexpr double length = 2;
constexpr double depth = 0.2;

// Four blocks along x out of a wall at x = 0, glued together.
RelaxationScene cantilever(double tensile_strength) {
    RelaxationScene scene;
    for (int block = 0; block < 4; ++block) {
        scene.block.push_back({rectangle(block * length / 4, 0, length / 4, depth), density});
    }
    scene.block.push_back(fixed_block(rectangle(-depth, -depth, depth, 3 * depth)));
    scene.material = {joint(1e6 * density * gravity * depth, degrees(30))};
    scene.material[0].bond = BondMaterial{1e11, 4e10, tensile_strength, 10 * tensile_strength, degrees(30), {}};
    scene.bond = find_bonds(scene);
    return scene;
}

// Bending stress at the wall, by beam theory.
constexpr double stress_at_wall = 3 * density * gravity * length * length / depth;

RelaxationState end_of_run(const RelaxationScene& scene) {
    RelaxationSettings settings;
    settings.local_damping = 0.7;
    settings.start = RelaxationStart::ramped;
    settings.ramp_time = 0.1;
    settings.duration = 0.2;
    Simulation simulation(scene, settings);
    while (simulation.running()) {
        simulation.step();
    }
    return simulation.state();
}

TEST(Cracks, ACantileverBreaksAtTheWall) {
    const RelaxationScene scene = cantilever(0.95 * stress_at_wall);
    const Bodies bodies = make_bodies(scene);
    const RelaxationState end = end_of_run(scene);
    const std::vector<BrokenBond> broken = broken_bonds(scene, bodies, end);
    ASSERT_EQ(broken.size(), 1U);
    EXPECT_NEAR(broken[0].from.x(), 0, 1e-12);  // rounding
    EXPECT_NEAR(broken[0].to.x(), 0, 1e-12);
    EXPECT_NEAR((broken[0].to - broken[0].from).norm(), depth, 1e-12);
    EXPECT_GT(broken[0].time, 0);
    EXPECT_LT(broken[0].time, end.time);
}

TEST(Cracks, StrongEnoughItStaysWhole) {
    // The ramp sets it swinging by some percent, which local damping takes out.
    const RelaxationScene scene = cantilever(1.2 * stress_at_wall);
    EXPECT_TRUE(broken_bonds(scene, make_bodies(scene), end_of_run(scene)).empty());
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
    // Blocks that have slid past each other have no joint between them.
    state.motion[1].y = 3;
    EXPECT_TRUE(open_joints(scene, bodies, state, 1e-3).empty());
}

}  // namespace
}  // namespace delabole
