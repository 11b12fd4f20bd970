// Dynamic relaxation against equations of motion, limit equilibrium, and the balances of energy and momentum.
#include "dynamic_relaxation/checkpoint/checkpoint.hpp"
#include "dynamic_relaxation/scene/scenes.hpp"
#include "dynamic_relaxation/step/simulation.hpp"
#include "parameters/fields.hpp"
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"
#include "tests/support/brick_pack.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

namespace delabole {
namespace {

constexpr double gravity = 9.80665;
constexpr double density = 2700;

Polygon<> rectangle(double left, double bottom, double width, double height) {
    return {{left, bottom}, {left + width, bottom}, {left + width, bottom + height}, {left, bottom + height}};
}

JointMaterial joint(double stiffness, double friction_angle) {
    return {stiffness, stiffness, friction_angle};
}

struct Row {
    std::size_t count = 1;
    double height_to_width = 3;
    double width = 1;
    double stiffness_ratio = 1e6;  // k b / W
    double interface_friction = degrees(20);
    double base_friction = degrees(40);
    double tilt = 0;
    double density = delabole::density;
};

RelaxationScene scene_of(const Row& row) {
    const StandingBlock block{row.width, row.height_to_width * row.width};
    const double stiffness = stiffness_of_ratio(row.stiffness_ratio, block, row.density, gravity);
    return row_scene({std::vector<StandingBlock>(row.count, block), row.density,
                      joint(stiffness, row.interface_friction), joint(stiffness, row.base_friction), row.tilt});
}

RelaxationSettings until_onset() {
    RelaxationSettings settings;
    settings.stop_at_onset = true;
    return settings;
}

// Greatest tilt that stands, to `width`.
double critical_tilt(Row row, const RelaxationSettings& settings, double stands, double fails, double width) {
    while (fails - stands > width) {
        row.tilt = (stands + fails) / 2;
        const RelaxationResult result = relax(scene_of(row), settings);
        EXPECT_NE(result.outcome, RelaxationOutcome::undecided) << "at " << row.tilt / degrees(1) << " deg";
        (result.outcome == RelaxationOutcome::equilibrium ? stands : fails) = row.tilt;
    }
    return (stands + fails) / 2;
}

TEST(FreeSlide, FollowsTheEquationOfMotion) {
    Row row;
    row.height_to_width = 0.5;
    row.base_friction = 0;
    row.tilt = degrees(30);
    RelaxationSettings settings;
    settings.local_damping = 0;
    settings.onset_slide = settings.collapse_displacement = 100;
    settings.duration = 0.5;
    const RelaxationResult result = relax(scene_of(row), settings);
    const double expected = gravity * std::sin(row.tilt) * result.time * result.time / 2;
    // Leap-frog is exact under a constant force; the error is the tilt of the block on its springs, W/(k b) = 1e-6.
    EXPECT_NEAR(result.block[0].displacement, expected, 1e-5 * expected);
}

TEST(FreeSlide, FrictionTakesItsShare) {
    Row row;
    row.height_to_width = 0.5;
    row.base_friction = degrees(20);
    row.tilt = degrees(30);
    RelaxationSettings settings;
    settings.local_damping = 0;
    settings.onset_slide = settings.collapse_displacement = 100;
    settings.duration = 0.5;
    const RelaxationResult result = relax(scene_of(row), settings);
    const double acceleration = gravity * (std::sin(row.tilt) - std::tan(row.base_friction) * std::cos(row.tilt));
    const double expected = acceleration * result.time * result.time / 2;
    // The first slip waits until the shear springs are stretched, some 1e-6 of the width.
    EXPECT_NEAR(result.block[0].displacement, expected, 1e-3 * expected);
    // Slip is counted from the second corner's first slip on.
    EXPECT_NEAR(result.block[0].base_slip, -result.block[0].displacement, 1e-3 * expected);
    EXPECT_NEAR(result.energy_balance.friction,
                density * 0.5 * gravity * std::cos(row.tilt) * std::tan(row.base_friction) * expected,
                2e-3 * result.energy_balance.friction);
}

// A block on springs without damping swings as a harmonic oscillator: y = -(W/2k)(1 - cos(sqrt(2k/m) t)).
TEST(TimeIntegration, IsOfSecondOrder) {
    Row row;
    row.height_to_width = 0.5;
    const RelaxationScene scene = scene_of(row);
    const double mass = density * 0.5;
    const double stiffness = scene.material[1].normal_stiffness;
    const double frequency = std::sqrt(2 * stiffness / mass);
    const double end = 20 / frequency;
    const auto error = [&](int steps) {
        RelaxationSettings settings;
        settings.start = RelaxationStart::dropped;
        settings.local_damping = settings.viscous_damping = 0;
        settings.step_fraction = 1;
        settings.stop_at_equilibrium = false;
        settings.time_step = end / steps;
        settings.most_steps = static_cast<std::size_t>(steps);
        Simulation simulation(scene, settings);
        while (simulation.running()) {
            simulation.step();
        }
        const double expected = -mass * gravity / (2 * stiffness) * (1 - std::cos(frequency * simulation.state().time));
        return simulation.state().motion[0].y - expected;
    };
    const double coarse = error(200);
    const double fine = error(400);
    // Second order: the error falls by four; terms of fourth order are a hundredth of it at 10 steps a radian.
    EXPECT_NEAR(coarse / fine, 4, 0.1);
}

// A force that keeps its direction on a point of a block that is otherwise free: a pendulum without weight.
TEST(TimeIntegration, OfRotationIsOfSecondOrder) {
    RelaxationScene scene;
    scene.block = {{rectangle(-1, -0.5, 2, 1), 1000}};
    scene.material = {joint(1e8, 0)};
    scene.gravity.acceleration = 0;
    scene.force = {{0, {1, 0}, {0, 1000}}};
    const double inertia = 1000 * 2 * (4 + 1) / 12.0;
    const double end = 1.5;
    const auto angle_after = [&](int steps) {
        RelaxationSettings settings;
        settings.local_damping = 0;
        settings.start = RelaxationStart::dropped;
        settings.onset_rotation = settings.collapse_rotation = 100;
        settings.onset_slide = settings.collapse_displacement = 100;
        settings.time_step = end / steps;
        settings.most_steps = static_cast<std::size_t>(steps);
        Simulation simulation(scene, settings);
        while (simulation.running()) {
            simulation.step();
        }
        return simulation.state().motion[0].angle;
    };
    // Reference: the same equation, angle'' = F cos(angle) / I, by Runge-Kutta with steps so short that they are exact
    // here.
    double angle = 0;
    double spin = 0;
    const int fine_steps = 20000;
    const double step = end / fine_steps;
    const auto acceleration = [&](double at) { return 1000 * std::cos(at) / inertia; };
    for (int index = 0; index < fine_steps; ++index) {
        const double k1 = acceleration(angle);
        const double k2 = acceleration(angle + step / 2 * spin);
        const double k3 = acceleration(angle + step / 2 * spin + step * step / 4 * k1);
        const double k4 = acceleration(angle + step * spin + step * step / 2 * k2);
        angle += step * spin + step * step / 6 * (k1 + k2 + k3);
        spin += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    const double coarse = angle_after(100) - angle;
    const double fine = angle_after(200) - angle;
    EXPECT_NEAR(coarse / fine, 4, 0.1);  // terms of fourth order are far below a percent at these steps
}

// The toppling block, free to turn, against the equation of motion about its toe.
TEST(FreeRotation, FollowsTheEquationOfMotion) {
    Row row;
    row.tilt = degrees(25);
    row.base_friction = degrees(60);
    row.stiffness_ratio = 1e7;
    RelaxationSettings settings;
    settings.local_damping = 0;
    settings.onset_rotation = 0.3;
    settings.stop_at_onset = true;
    const RelaxationResult result = relax(scene_of(row), settings);
    ASSERT_EQ(result.outcome, RelaxationOutcome::onset);
    // angle'' = m g r sin(tilt - atan(b/a) + angle) / I about the toe, from rest.
    const double arm = std::hypot(0.5, 1.5);
    const double factor = gravity * arm / ((1 + 9) / 12.0 + arm * arm);
    double angle = 0;
    double spin = 0;
    const double step = result.time / 20000;
    for (int index = 0; index < 20000; ++index) {
        const auto acceleration = [&](double at) { return factor * std::sin(row.tilt - std::atan(1 / 3.0) + at); };
        const double middle = angle + step / 2 * spin;
        const double middle_spin = spin + step / 2 * acceleration(angle);
        angle += step * middle_spin;
        spin += step * acceleration(middle);
    }
    // The heel's springs, compressed at the start, throw the block by their energy: of the order of W/(k b).
    EXPECT_NEAR(result.block[0].rotation, angle, 2e-3 * angle);
}

// tan(critical tilt) = b/a - (W / k b) sqrt(1 + (b/a)^2): the heel's spring is spent, the toe's carries all.
TEST(SingleBlock, ObeysTheThresholdLaw) {
    for (const double ratio : {1e3, 1e4, 1e6}) {
        for (const double slenderness : {1.5, 3.0, 8.0}) {
            for (const double heavy : {1.0, 10.0}) {
                Row row;
                row.height_to_width = slenderness;
                row.stiffness_ratio = ratio;
                row.base_friction = degrees(60);
                row.density = heavy * density;
                const double limit = std::atan(1 / slenderness);
                const double critical = critical_tilt(row, until_onset(), 0.9 * limit, 1.02 * limit, 1e-5);
                const double law = 1 / slenderness - std::sqrt(1 + 1 / (slenderness * slenderness)) / ratio;
                EXPECT_NEAR(std::tan(critical), law, 0.005 * law)
                    << "k b/W " << ratio << ", a/b " << slenderness << ", density " << row.density;
            }
        }
    }
}

TEST(TwoBlocks, BeginToTurnWhereLimitEquilibriumSays) {
    // phi = psi = 20 deg; the least of eqs (8) and (10). The blocks jam only after leaning a little, which
    // costs up to 0.011 deg at k b/W = 3e7.
    const std::array<std::pair<double, double>, 2> theory{{{3, 18.629}, {7, 8.831}}};
    for (const auto& [slenderness, tilt] : theory) {
        Row row;
        row.count = 2;
        row.height_to_width = slenderness;
        row.stiffness_ratio = 3e7;
        row.base_friction = degrees(20);
        const double critical =
            critical_tilt(row, until_onset(), degrees(tilt - 0.2), degrees(tilt + 0.2), degrees(0.005));
        EXPECT_NEAR(critical / degrees(1), tilt, 0.03) << "a/b " << slenderness;
    }
}

RelaxationScene appendix_a(double friction_angle, double stiffness_ratio) {
    StandingBlocks columns;
    for (const double height : {1.0, 2.0, 3.0, 4.0, 3.1, 2.2, 1.3, 0.4}) {
        columns.block.push_back({1, height, 0.5});
    }
    columns.density = 1000;
    columns.tilt = degrees(21.8);
    const double stiffness = stiffness_of_ratio(stiffness_ratio, columns.block[3], columns.density, gravity);
    columns.interface = columns.base = joint(stiffness, friction_angle);
    return column_scene(columns);
}

TEST(SteppedBase, OnsetIsNearTheRecursionsLimit) {
    // Appendix A: limiting friction 41.14 deg. Columns 1 and 2 mobilise their joint only after turning by some 1e-3,
    // which asks for up to 0.1 deg more friction at k b/W = 1e6.
    const RelaxationResult below = relax(appendix_a(degrees(41.0), 1e6), until_onset());
    ASSERT_EQ(below.outcome, RelaxationOutcome::onset);
    const RelaxationResult above = relax(appendix_a(degrees(41.3), 1e6), until_onset());
    EXPECT_EQ(above.outcome, RelaxationOutcome::equilibrium);
    // 2 to 5 topple, 6 to 8 stay (5.3.4.2); the crack opens between 5 and 6.
    for (const std::size_t column : {1U, 2U, 3U, 4U}) {
        EXPECT_GT(below.block[column].rotation, 1e-3) << "column " << column + 1;
    }
    for (const std::size_t column : {5U, 6U, 7U}) {
        EXPECT_EQ(below.block[column].movement, BlockMovement::stays) << "column " << column + 1;
        EXPECT_LT(std::abs(below.block[column].rotation), 1e-5) << "column " << column + 1;
    }
    EXPECT_LT(below.block[0].base_slip, -1e-3);  // 1 slides
}

TEST(Books, MomentumIsConserved) {
    // Three blocks in free fall, with corners that were pushed into faces a little: only they act on each other.
    RelaxationScene scene;
    const double overlap = 1e-6;
    scene.block = {{rectangle(0, 0, 1, 2), density},
                   {{{1 - overlap, 0.3}, {2, 0.3}, {2, 1.3}, {1.02, 1.3}}, density},
                   {{{0.2, 2 - overlap}, {1.7, 2.03}, {1.7, 2.5}, {0.2, 2.5}}, density}};
    scene.material = {joint(1e10, degrees(30))};
    RelaxationSettings settings;
    settings.start = RelaxationStart::dropped;
    settings.local_damping = 0;  // the only force without a counterpart
    settings.duration = 0.05;
    settings.onset_rotation = settings.onset_slide = settings.collapse_rotation = settings.collapse_displacement = 100;
    Simulation simulation(scene, settings);
    while (simulation.running()) {
        simulation.step();
    }
    const Bodies& bodies = simulation.bodies();
    double px = 0;
    double py = 0;
    double spin = 0;
    double mass = 0;
    double speed = 0;
    PlanePoint<> centre(0, 0);
    for (std::size_t block = 0; block < 3; ++block) {
        mass += bodies.mass[block];
        centre += bodies.mass[block] * bodies.centroid[block];
    }
    centre /= mass;
    // Velocities lag half a step behind.
    const double time = simulation.state().time - simulation.state().last_step / 2;
    for (std::size_t block = 0; block < 3; ++block) {
        const Motion& motion = simulation.state().motion[block];
        const double vy = motion.vy + gravity * time;
        px += bodies.mass[block] * motion.vx;
        py += bodies.mass[block] * vy;
        const PlanePoint<> arm = bodies.centroid[block] - centre;
        spin += bodies.mass[block] * (arm.x() * vy - arm.y() * motion.vx) + bodies.inertia[block] * motion.spin;
        speed += bodies.mass[block] * std::hypot(motion.vx, vy);
    }
    ASSERT_GT(speed, 1);  // they did push each other
    EXPECT_NEAR(px, 0, 1e-9 * speed);
    EXPECT_NEAR(py, 0, 1e-9 * speed);
    // Lever arms change as the blocks have drifted since, by 1e-4 of their length.
    EXPECT_NEAR(spin, 0, 1e-3 * speed);
}

// The design promises that "hundreds of randomised runs gave no blow-up" once contacts are keyed by corner and edge.
TEST(Books, BalanceInRandomisedDoubleBlocks) {
    std::mt19937 random(677);
    std::uniform_real_distribution<double> any(0, 1);
    double worst = 0;
    for (int trial = 0; trial < 400; ++trial) {
        Row row;
        row.count = 2;
        row.height_to_width = std::array{3.0, 5.0, 7.0, 10.0}[static_cast<std::size_t>(trial) % 4];
        row.stiffness_ratio = std::pow(10, 4 + 2 * any(random));
        row.base_friction = row.interface_friction = degrees(20);
        row.tilt = std::atan(1 / row.height_to_width) + degrees(4 * any(random));
        RelaxationScene scene = scene_of(row);
        for (PlanePoint<>& vertex : scene.block[1].outline) {
            vertex += PlanePoint<>(1e-3 * any(random), 1e-3 * any(random));  // gaps from 0 to 1e-3 b
        }
        RelaxationSettings settings;
        settings.start = trial % 2 == 0 ? RelaxationStart::preloaded : RelaxationStart::dropped;
        settings.stop_at_equilibrium = false;
        settings.duration = 1.0;
        const RelaxationResult result = relax(scene, settings);
        ASSERT_TRUE(relaxation_scenes::ends_as_blocks_do(result.outcome)) << "trial " << trial;
        // Pairs that stand preloaded turn over less than this share of what their springs hold, W^2 / k.
        const double weight = density * gravity * row.height_to_width;
        const double error = relaxation_scenes::energy_error(result, 1e-9 * weight / row.stiffness_ratio);
        worst = std::max(worst, error);
        EXPECT_LT(error, 0.02) << "trial " << trial;
        // Nothing can move faster than its fall allows.
        const double fall = 2 * 9.81 * row.height_to_width;
        EXPECT_LT(result.energy_balance.kinetic, density * row.height_to_width * 2 * fall / 2) << "trial " << trial;
    }
    RecordProperty("worst_energy_error", std::to_string(worst));
}

// Dashpots lag by half a step: a step chosen from the springs alone would let strong ones chatter for ever.
TEST(Damping, LetsBlocksRestHoweverStrong) {
    for (const double viscous : {0.0, 0.2, 0.5, 1.0, 2.0}) {
        for (const double local : {0.0, 0.2, 0.7}) {
            if (viscous == 0 && local == 0) {
                continue;
            }
            Row row;
            row.count = 2;
            row.stiffness_ratio = 1e4;
            row.base_friction = row.interface_friction = 0.35;
            row.tilt = 0.17;
            RelaxationSettings settings;
            settings.start = RelaxationStart::dropped;
            settings.viscous_damping = viscous;
            settings.local_damping = local;
            const RelaxationResult result = relax(scene_of(row), settings);
            EXPECT_EQ(result.outcome, RelaxationOutcome::equilibrium) << "viscous " << viscous << ", local " << local;
        }
    }
}

TEST(Tilting, InSmallIncrementsReachesTheStaticLimit) {
    Row row;
    row.tilt = degrees(18);
    RelaxationScene scene = scene_of(row);
    scene.gravity.final_tilt = degrees(19);
    scene.gravity.rate = degrees(0.1);
    scene.gravity.interval = 0.01;
    const RelaxationResult result = relax(scene, until_onset());
    ASSERT_EQ(result.outcome, RelaxationOutcome::onset);
    // Rotating gravity alone reaches the static limit, 18.43 deg; by the time 0.01 rad are reached, gravity has gone on
    // for some two seconds of 0.1 deg.
    EXPECT_GT(result.tilt, degrees(18.43));
    EXPECT_LT(result.tilt, degrees(18.75));
}

// The pack stands for ten seconds once it has settled for three: not a bit moves, and no contact is evaluated.
void expect_no_creep(const BrickPack& pack, RelaxationStart start) {
    const RelaxationScene scene = brick_pack_scene(pack);
    RelaxationSettings settings;
    settings.start = start;
    settings.stop_at_equilibrium = false;
    settings.duration = 13;
    Simulation simulation(scene, settings);
    std::vector<Motion> settled;
    std::uint64_t evaluated = 0;
    while (simulation.running()) {
        simulation.step();
        if (settled.empty() && simulation.state().time > 3) {
            settled = simulation.state().motion;
            evaluated = simulation.state().contacts_evaluated;
        }
    }
    ASSERT_EQ(simulation.outcome(), RelaxationOutcome::equilibrium);
    EXPECT_EQ(simulation.state().contacts_evaluated, evaluated);
    for (std::size_t block = 0; block < scene.block.size(); ++block) {
        const Motion& motion = simulation.state().motion[block];
        EXPECT_EQ(motion.x, settled[block].x) << "block " << block;
        EXPECT_EQ(motion.y, settled[block].y) << "block " << block;
        EXPECT_EQ(motion.angle, settled[block].angle) << "block " << block;
    }
}

TEST(Pack, DoesNotCreep) {
    expect_no_creep({8, 6, 1e5, degrees(40), degrees(20)}, RelaxationStart::preloaded);
}

// Other engines were measured with this pack: they creep by 0.07 to 73 mm, or collapse.
TEST(Pack, OfAThousandBricksDoesNotCreep) {
    expect_no_creep({22, 45, 1e5, degrees(40), degrees(20)}, RelaxationStart::dropped);
}

// Same bytes for any number of threads, while everything moves and after most has come to rest.
TEST(Pack, MovesAlikeWithAnyNumberOfThreads) {
    const RelaxationScene scene = brick_pack_scene({12, 25, 1e4, degrees(30), degrees(20)});
    ASSERT_GT(scene.block.size(), 256U);  // more than one group of blocks
    RelaxationSettings settings;
    settings.start = RelaxationStart::dropped;
    settings.most_steps = 400;
    std::string alone;
    for (const std::size_t threads : {1U, 2U, 3U}) {
        settings.threads = threads;
        Simulation simulation(scene, settings);
        while (simulation.running()) {
            simulation.step();
        }
        const std::string bytes = checkpoint_of(scene, settings, simulation.state());
        alone = alone.empty() ? bytes : alone;
        EXPECT_TRUE(bytes == alone) << threads << " threads";
    }
}

}  // namespace
}  // namespace delabole
