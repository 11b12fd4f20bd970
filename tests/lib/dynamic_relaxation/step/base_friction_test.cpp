// Base friction stands for gravity as long as nothing moves, and for a velocity where gravity gives an acceleration.
#include "dynamic_relaxation/step/base_friction.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace delabole {
namespace {

using namespace relaxation_scenes;

constexpr double speed = 0.02;
const Belt sandpaper{speed, degrees(35)};

// Midpoint rule over a rectangle, fine enough for 1e-4 where the friction's direction changes within it.
BlockForce drag_by_strips(const Belt& belt, const PlanePoint<>& belt_velocity, double weight, double width,
                          double height, const Motion& motion) {
    constexpr int cells = 400;
    BlockForce sum;
    for (int column = 0; column < cells; ++column) {
        for (int row = 0; row < cells; ++row) {
            const PlanePoint<> arm = motion.turned(
                PlanePoint<>(((column + 0.5) / cells - 0.5) * width, ((row + 0.5) / cells - 0.5) * height));
            const PlanePoint<> past =
                belt_velocity - PlanePoint<>(motion.vx - motion.spin * arm.y(), motion.vy + motion.spin * arm.x());
            const PlanePoint<> force = std::tan(belt.friction_angle) * weight / (cells * cells) /
                                       std::max(past.norm(), belt_creep * speed) * past;
            sum.x += force.x();
            sum.y += force.y();
            sum.moment += arm.x() * force.y() - arm.y() * force.x();
        }
    }
    return sum;
}

TEST(BaseFriction, ResultantAndMomentOverTheArea) {
    RelaxationScene scene;
    scene.block = {{rectangle(0, 0, 0.05, 0.2), density}};
    scene.material = {joint(1e9, degrees(30))};
    const Bodies bodies = make_bodies(scene);
    const double weight = gravity * bodies.mass[0];
    const double friction = std::tan(sandpaper.friction_angle) * weight;
    const PlanePoint<> down(0, -speed);
    struct Turn {
        double spin;       // of the block's ends against its middle, in belt speeds
        double vy;         // in belt speeds
        double tolerance;  // as stated in the header
    };
    // These are slow turns, a block carried along while it turns, and one that turns about a point of its own.
    for (const Turn& turn : {Turn{0, 0, 1e-12}, Turn{0.1, 0, 1e-6}, Turn{0.2, 0, 1e-6}, Turn{-0.5, 0.2, 1e-3},
                             Turn{3, -1, 1e-2}, Turn{2, 0.3, 2e-2}}) {
        Motion motion;
        motion.set_angle(0.3);
        motion.vy = turn.vy * speed;
        motion.spin = turn.spin * speed / bodies.radius[0];
        const BlockForce drag = belt_drag(sandpaper, down, weight, bodies, 0, motion);
        const BlockForce strips = drag_by_strips(sandpaper, down, weight, 0.05, 0.2, motion);
        const double tolerance = (turn.tolerance + 2e-5) * friction;
        EXPECT_NEAR(drag.x, strips.x, tolerance) << turn.spin;
        EXPECT_NEAR(drag.y, strips.y, tolerance) << turn.spin;
        EXPECT_NEAR(drag.moment, strips.moment, tolerance * bodies.radius[0]) << turn.spin;
        // Friction takes energy from what moves over the belt.
        EXPECT_LE(drag.x * (motion.vx - down.x()) + drag.y * (motion.vy - down.y()) + drag.moment * motion.spin, 0);
    }
}

// Below a thousandth of the speed the resultant is that of a block that does not turn, and the moment linear.
TEST(BaseFriction, GoesOverFromTheQuadratureToSlowTurning) {
    RelaxationScene scene;
    scene.block = {{rectangle(0, 0, 0.05, 0.2), density}};
    scene.material = {joint(1e9, degrees(30))};
    const Bodies bodies = make_bodies(scene);
    const auto drag = [&](double turning) {
        Motion motion;
        motion.set_angle(0.3);
        motion.vx = 0.1 * speed;
        motion.spin = turning * std::hypot(0.1, 1.0) * speed / bodies.radius[0];
        BlockForce force = belt_drag(sandpaper, PlanePoint<>(0, -speed), 1, bodies, 0, motion);
        force.moment /= motion.spin;
        return force;
    };
    const BlockForce slow = drag(0.999e-3);
    const BlockForce fast = drag(1.001e-3);
    // The tolerance is of second order in the turning.
    EXPECT_NEAR(slow.x, fast.x, 1e-6);
    EXPECT_NEAR(slow.y, fast.y, 1e-6);
    EXPECT_LT(slow.moment, 0);
    EXPECT_NEAR(slow.moment, fast.moment, 1e-5 * std::abs(fast.moment));
    EXPECT_NEAR(drag(-0.5e-3).moment, slow.moment, 1e-12 * std::abs(slow.moment));
}

TEST(BaseFriction, IsGravityForABlockThatDoesNotMove) {
    RelaxationScene scene = scene_of({});
    const Bodies bodies = make_bodies(scene);
    const BlockForce drag =
        belt_drag(sandpaper, speed * PlanePoint<>(-0.6, -0.8), bodies.mass[0] * gravity, bodies, 0, {});
    const double force = std::tan(sandpaper.friction_angle) * bodies.mass[0] * gravity;
    EXPECT_NEAR(drag.x, -0.6 * force, 1e-12 * force);
    EXPECT_NEAR(drag.y, -0.8 * force, 1e-12 * force);
    EXPECT_EQ(drag.moment, 0);
}

RelaxationSettings moving(double duration) {
    RelaxationSettings settings = unlimited(duration);
    settings.local_damping = 0;
    return settings;
}

// The block is far above its base and touches nothing.
RelaxationScene block_afloat(const Belt& belt) {
    OnPlane plane;
    plane.width = 0.05;
    RelaxationScene scene = scene_of(plane);
    scene.block[1].outline = rectangle(-1, -10, 2, 1);
    scene.belt = belt;
    return scene;
}

TEST(BaseFriction, CarriesAFreeBlockWithTheBelt) {
    Simulation simulation(block_afloat(sandpaper), moving(0.1));
    const double acceleration = std::tan(sandpaper.friction_angle) * gravity;
    double fastest = 0;
    while (simulation.running()) {
        simulation.step();
        fastest = std::max(fastest, -simulation.state().motion[0].vy);
        // Until it has nearly the belt's speed, after 2.9 ms, it falls like a stone under that acceleration.
        if (simulation.state().time < 0.9 * speed / acceleration) {
            EXPECT_NEAR(-simulation.state().motion[0].vy, acceleration * simulation.state().time,
                        // Velocities stand half a step back.
                        acceleration * simulation.state().step);
        }
    }
    EXPECT_NEAR(-simulation.state().motion[0].vy, speed, 1e-6 * speed);
    EXPECT_LE(fastest, speed * (1 + 1e-9));
}

TEST(BaseFriction, OfAFastBeltIsGravity) {
    const double acceleration = std::tan(sandpaper.friction_angle) * gravity;
    for (const double fast : {1.0, 10.0, 100.0}) {
        Simulation simulation(block_afloat({fast, sandpaper.friction_angle}), moving(0.05));
        while (simulation.running()) {
            simulation.step();
        }
        const double time = simulation.state().time;
        EXPECT_NEAR(-simulation.state().motion[0].y, acceleration * time * time / 2,
                    2 * acceleration * simulation.state().step * time)
            << fast;
    }
}

RelaxationStudy row_study(std::vector<RelaxationRowBlock> blocks, double friction, double lower, bool on_belt) {
    RelaxationRow row{};
    row.density = 1330;
    row.interface.friction_angle = row.base.friction_angle = degrees(friction);
    row.block = std::move(blocks);
    RelaxationStudy study{};
    study.model.scene = row;
    if (on_belt) {
        study.model.base_friction = Belt{speed, degrees(35)};
    }
    RelaxationNumerics numerics{};
    numerics.quality = RelaxationQuality::draft;
    numerics.stiffness_ratio = 1e5;
    numerics.onset_slide = 1e-3;  // just beyond the limit blocks creep over the belt's model
    study.settings = numerics;
    study.critical = TiltSearch{degrees(lower), degrees(lower + 2), degrees(0.06), {}, {}};
    return study;
}

// A block that topples, one that slides, and two that lean on each other (eq. 8 of the thesis: 18.63 deg).
TEST(BaseFriction, HasTheLimitingStatesOfGravity) {
    const RelaxationRowBlock slender{0.025, 0.075, {}};
    struct Row {
        std::vector<RelaxationRowBlock> blocks;
        double friction;
        double lower;  // deg
    };
    for (const Row& row :
         {Row{{slender}, 30, 17.3}, Row{{{0.05, 0.05, {}}}, 25, 23.9}, Row{{slender, slender}, 20, 17.6}}) {
        const CriticalValue gravity = find_critical(row_study(row.blocks, row.friction, row.lower, false));
        const CriticalValue belt = find_critical(row_study(row.blocks, row.friction, row.lower, true));
        ASSERT_EQ(gravity.status, CriticalStatus::found);
        ASSERT_EQ(belt.status, CriticalStatus::found);
        // Each within half its bracket; what soft joints shift, 1e-5 rad, is less by far.
        EXPECT_NEAR(belt.value(), gravity.value(), degrees(0.06)) << row.friction;
    }
}

// Bray: velocities under base friction are as accelerations under gravity. A block that slides down a slope has, under
// gravity, a = g (sin d - tan(phi) cos d). On the belt the components of drag along and normal to the slope are in the
// ratio of V sin d - v to V cos d, and friction on the slope holds where that is tan(phi): v = V (sin d - tan(phi) cos
// d).
TEST(BaseFriction, GivesVelocitiesWhereGravityGivesAccelerations) {
    OnPlane plane;
    plane.width = 0.05;
    plane.tilt = degrees(40);
    plane.friction = degrees(25);
    const double share = std::sin(plane.tilt) - std::tan(plane.friction) * std::cos(plane.tilt);
    const auto velocity_at = [&](bool on_belt, double belt_speed, double time) {
        RelaxationScene scene = scene_of(plane);
        if (on_belt) {
            scene.belt = Belt{belt_speed, sandpaper.friction_angle};
        }
        Simulation simulation(scene, moving(time));
        while (simulation.running()) {
            simulation.step();
        }
        return -simulation.state().motion[0].vx;
    };
    // The dashpots of the contacts are small: they take a thousandth of the energy.
    EXPECT_NEAR(velocity_at(false, 0, 0.02), gravity * share * 0.02, 2e-3 * gravity * share * 0.02);
    EXPECT_NEAR(velocity_at(false, 0, 0.04), gravity * share * 0.04, 2e-3 * gravity * share * 0.04);
    // The same after any time, in proportion to the belt: inertia has no say.
    for (const double belt : {speed, speed / 4}) {
        EXPECT_NEAR(velocity_at(true, belt, 0.02), belt * share, 1e-3 * belt);
        EXPECT_NEAR(velocity_at(true, belt, 0.04), belt * share, 1e-3 * belt);
    }
}

// A toppling block is farther over the farther the belt has run, whatever its speed: the run is a row of states of
// balance.
TEST(BaseFriction, DoesNotKnowInertia) {
    OnPlane plane;
    plane.width = 0.025;
    plane.height_to_width = 3;
    plane.tilt = degrees(25);
    plane.friction = degrees(40);
    const auto rotation_after = [&](double belt_speed) {
        constexpr double belt_way = 0.02;
        RelaxationScene scene = scene_of(plane);
        scene.belt = Belt{belt_speed, sandpaper.friction_angle};
        Simulation simulation(scene, moving(belt_way / belt_speed));
        while (simulation.running()) {
            simulation.step();
        }
        return simulation.state().motion[0].angle;
    };
    const double slow = rotation_after(speed / 4);
    EXPECT_GT(slow, 0.05);
    // v^2 / (2 tan(phi) g b) is 1e-3 at the greater speed.
    EXPECT_NEAR(rotation_after(speed), slow, 0.02 * slow);
}

}  // namespace
}  // namespace delabole
