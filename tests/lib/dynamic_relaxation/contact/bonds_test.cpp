// Bonds are elastic, objective, keep the energy balance, make beams of rows of blocks, and break where beams crack.
#include "dynamic_relaxation/contact/bonds.hpp"
#include "dynamic_relaxation/checkpoint/checkpoint.hpp"
#include "dynamic_relaxation/step/history.hpp"
#include "dynamic_relaxation/step/scene_check.hpp"
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

using namespace relaxation_scenes;

constexpr double length = 2;
constexpr double depth = 0.2;
constexpr double young = 1e11;
constexpr double shear_modulus = 4e10;
constexpr double unbreakable = 1e12;

BondMaterial rock(double tensile_strength = unbreakable, double cohesion = unbreakable) {
    return {young, shear_modulus, tensile_strength, cohesion, degrees(30)};
}

// Blocks 0 to n - 1 along x out of a wall at x = 0, which is block n.
RelaxationScene cantilever(std::size_t blocks, double tensile_strength = unbreakable) {
    RelaxationScene scene;
    const double width = length / static_cast<double>(blocks);
    for (std::size_t block = 0; block < blocks; ++block) {
        scene.block.push_back({rectangle(static_cast<double>(block) * width, 0, width, depth), density});
    }
    scene.block.push_back(fixed_block(rectangle(-depth, -depth, depth, 3 * depth)));
    scene.material = {joint(1e6 * density * gravity * depth, degrees(30))};
    scene.material[0].bond = rock(tensile_strength);
    scene.bond = find_bonds(scene);
    return scene;
}

double tip_deflection(const RelaxationScene& scene) {
    const Simulation simulation(scene, {});
    const std::size_t last = scene.block.size() - 2;
    const CornerRange& range = simulation.bodies().range[last];
    const Motion& motion = simulation.state().motion[last];
    return -(motion.y + motion.turned_by(simulation.bodies().corner[range.begin + 1]).y());
}

TEST(Bonds, AreFoundAcrossFacesOfBondedJoints) {
    RelaxationScene scene = cantilever(4);
    ASSERT_EQ(scene.bond.size(), 4U);
    EXPECT_EQ(check_scene(scene).check, SceneCheck::valid);
    EXPECT_EQ(std::ranges::count_if(scene.bond, [](const FaceBond& bond) { return bond.other == 4; }), 1);
    scene.material[0].bond.reset();
    EXPECT_TRUE(find_bonds(scene).empty());
}

// A row of bonds is the trapezoidal rule for the beam's integral of the moment: with the moment of the own weight,
// w (L - x)^2 / 2, the deflection by bending is too large by 1 / n^2; that by shear, over a linear force, is exact.
TEST(Bonds, MakeABeamToSecondOrder) {
    const double load = density * gravity * depth;
    const double bending = load * std::pow(length, 4) / (8 * young * std::pow(depth, 3) / 12);
    const double shearing = load * length * length / (2 * shear_modulus * depth);
    double error_before = 0;
    for (const std::size_t blocks : {2U, 4U, 8U, 16U}) {
        const double deflection = tip_deflection(cantilever(blocks));
        const auto count = static_cast<double>(blocks);
        // The beam's slope, 1e-4, enters squared; balance is found to 1e-7 of a block's weight, which with the lever of
        // the whole beam is 1e-6.
        EXPECT_NEAR(deflection, bending * (1 + 1 / (count * count)) + shearing, 1e-5 * bending) << blocks;
        const double error = deflection - bending - shearing;
        if (error_before > 0) {
            EXPECT_NEAR(std::log2(error_before / error), 2, 0.01) << blocks;
        }
        error_before = error;
    }
}

TEST(Bonds, CrackAtTheWallUnderTheLoadOfBeamTheory) {
    const double load = density * gravity * depth;
    const double fibre_stress = load * length * length / 2 * 6 / (depth * depth);
    for (const RelaxationStart start : {RelaxationStart::preloaded, RelaxationStart::ramped}) {
        RelaxationSettings settings = until_onset();
        settings.start = start;
        // The ramp lasts many periods of the beam, 20 ms, so that it hardly overshoots.
        settings.ramp_time = start == RelaxationStart::ramped ? 0.5 : 0;
        settings.duration = 3;
        // A ramp causes a dynamic excess of about period / ramp time.
        const double band = start == RelaxationStart::ramped ? 0.05 : 1e-4;
        const RelaxationResult holds = relax(cantilever(4, (1 + band) * fibre_stress), settings);
        EXPECT_EQ(holds.outcome, RelaxationOutcome::equilibrium);
        EXPECT_EQ(holds.broken_bonds, 0U);
        Simulation breaks(cantilever(4, (1 - band) * fibre_stress), settings);
        while (breaks.running()) {
            breaks.step();
        }
        EXPECT_EQ(breaks.outcome(), RelaxationOutcome::onset);
        for (std::size_t index = 0; index < 4; ++index) {
            const bool at_wall = breaks.scene().bond[index].other == 4;
            EXPECT_EQ(breaks.state().bond[index].state, at_wall ? BondState::broken_in_tension : BondState::whole);
        }
    }
}

Motion moved_rigidly(const PlanePoint<>& centroid, double angle, const PlanePoint<>& shift) {
    Motion motion;
    motion.set_angle(angle);
    const PlanePoint<> at = shift + motion.turned_by(centroid);
    motion.x = at.x();
    motion.y = at.y();
    return motion;
}

TEST(Bonds, FeelNothingOfRigidMotionAndTurnWithIt) {
    const RelaxationScene scene = cantilever(2);
    const Bodies bodies = make_bodies(scene);
    const std::vector<Bond> bonds = make_bonds(scene, bodies, 0);
    const auto between = std::ranges::find_if(bonds, [](const Bond& bond) { return bond.face.other == 1; });
    ASSERT_NE(between, bonds.end());
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(-3, 3);
    for (int run = 0; run < 200; ++run) {
        const double angle = any(random);
        const PlanePoint<> shift(any(random), any(random));
        const Motion one = moved_rigidly(bodies.centroid[0], angle, shift);
        Motion two = moved_rigidly(bodies.centroid[1], angle, shift);
        const FacePosition still = locate(between->face, one, two);
        // The tolerance is the rounding of displacements of some metres.
        EXPECT_LT(std::abs(still.opening) + std::abs(still.slide) + std::abs(still.turn), 1e-14);
        // A deformation in the axes of the second block, and the same one turned.
        const double turn = 1e-3 * any(random);
        const PlanePoint<> parted = 1e-3 * PlanePoint<>(any(random), any(random));
        const auto deformed = [&](double by, const PlanePoint<>& way) {
            Motion first = moved_rigidly(bodies.centroid[0], by, way);
            const PlanePoint<> moved = moved_rigidly({0, 0}, by, {0, 0}).turned(parted);
            first.x += moved.x();
            first.y += moved.y();
            first.set_angle(by + turn);
            return locate(between->face, first, moved_rigidly(bodies.centroid[1], by, way));
        };
        const double energy = elastic_energy(*between, deformed(0, {0, 0}));
        EXPECT_NEAR(elastic_energy(*between, deformed(angle, shift)), energy, 1e-9 * energy);
    }
}

// Forces at the ends of the bonds' faces carry the weight of each block and its moment.
TEST(Bonds, ForcesAtTheEndsOfTheirFacesBalanceTheBlocks) {
    const RelaxationScene scene = cantilever(4);
    const Simulation simulation(scene, {});
    const Bodies& bodies = simulation.bodies();
    std::vector<PlanePoint<>> sum(bodies.size(), PlanePoint<>(0, 0));
    std::vector<double> moment(bodies.size(), 0);
    for (const CornerForce& force : corner_forces(simulation.bonds(), bodies, simulation.state())) {
        for (const auto& [block, sign] : {std::pair(force.block, 1.0), std::pair(force.other, -1.0)}) {
            const Motion& moved = simulation.state().motion[block];
            const PlanePoint<> arm = force.at - bodies.centroid[block] - PlanePoint<>(moved.x, moved.y);
            sum[block] += sign * force.force;
            moment[block] += sign * (arm.x() * force.force.y() - arm.y() * force.force.x());
        }
    }
    // Balance is found to 1e-7 of a block's weight; forces on deformed faces turn with them, by 1e-4 and less.
    const double whole = density * gravity * length * depth;
    for (std::size_t block = 0; block + 1 < bodies.size(); ++block) {
        EXPECT_NEAR(sum[block].x(), 0, 1e-3 * whole) << block;
        EXPECT_NEAR(sum[block].y(), whole / 4, 1e-6 * whole) << block;
        EXPECT_NEAR(moment[block], 0, 1e-3 * whole * length) << block;
    }
}

// Two bonded blocks afloat.
RelaxationScene pair_afloat() {
    RelaxationScene scene;
    scene.block = {{rectangle(0, 0, 1, 1), density}, {rectangle(1, 0.2, 2, 0.6), density}};
    scene.material = {joint(1e9, degrees(30))};
    scene.material[0].bond = BondMaterial{1e8, 4e7, unbreakable, unbreakable, degrees(30)};
    scene.gravity.acceleration = 0;
    scene.bond = find_bonds(scene);
    return scene;
}

struct Momentum {
    double x = 0;
    double y = 0;
    double angular = 0;
};

Momentum momentum_of(const Simulation& simulation) {
    Momentum sum;
    const Bodies& bodies = simulation.bodies();
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        const Motion& motion = simulation.state().motion[block];
        const double px = bodies.mass[block] * motion.vx;
        const double py = bodies.mass[block] * motion.vy;
        sum.x += px;
        sum.y += py;
        sum.angular += bodies.inertia[block] * motion.spin + (bodies.centroid[block].x() + motion.x) * py -
                       (bodies.centroid[block].y() + motion.y) * px;
    }
    return sum;
}

Simulation pushed_pair(double viscous_damping, double step_fraction) {
    RelaxationSettings settings = unlimited(0.4);
    settings.local_damping = 0;
    settings.viscous_damping = viscous_damping;
    settings.step_fraction = step_fraction;
    const RelaxationScene scene = pair_afloat();
    RelaxationState state = Simulation(scene, settings).state();
    state.motion[0].vx = 0.3;
    state.motion[0].vy = -0.2;
    state.motion[0].spin = 0.5;
    state.motion[1].spin = -0.2;
    state.motion[1].vy = 0.4;
    return {scene, settings, state};
}

TEST(Bonds, KeepMomentumAndEnergy) {
    for (const double damping : {0.0, 0.2}) {
        double error_before = 0;
        for (const double fraction : {0.2, 0.1}) {
            Simulation simulation = pushed_pair(damping, fraction);
            const Momentum before = momentum_of(simulation);
            const double energy = simulation.kinetic_energy();
            while (simulation.running()) {
                simulation.step();
            }
            const Momentum after = momentum_of(simulation);
            // The tolerance is the rounding over some thousand steps.
            EXPECT_NEAR(after.x, before.x, 1e-9 * density);
            EXPECT_NEAR(after.y, before.y, 1e-9 * density);
            // Velocities stand half a step before positions: the moment of momentum swings by a step's share.
            EXPECT_NEAR(after.angular, before.angular, 1e-3 * density);
            const EnergyBalance energy_balance = simulation.energy_balance();
            EXPECT_GT(damping > 0 ? energy_balance.dashpots : 1, 0.2 * (damping > 0 ? energy : 0));
            const double now = energy_balance.kinetic + energy_balance.elastic + energy_balance.dashpots;
            const double error = std::abs(now / energy - 1);
            // Elastic energy stands half a step after kinetic energy: up to half a step times the frequency.
            EXPECT_LT(error, fraction);
            if (damping > 0 && error_before > 0) {
                EXPECT_LT(error, error_before);
            }
            error_before = error;
        }
    }
}

// A block on a slope, held by its bond.
RelaxationScene block_on_slope(double cohesion, double bond_friction, double joint_friction, double tilt) {
    OnPlane plane;
    plane.friction = joint_friction;
    plane.tilt = tilt;
    RelaxationScene scene = scene_of(plane);
    // The bond is softer than the joint by four powers of ten.
    scene.material[0].bond = BondMaterial{1e7, 4e6, unbreakable, cohesion, bond_friction};
    scene.bond = find_bonds(scene);
    return scene;
}

TEST(Bonds, ShearWhereCohesionAndFrictionAreSpent) {
    const double tilt = degrees(25);
    const double friction = degrees(10);
    const double demand = density * gravity * (std::sin(tilt) - std::cos(tilt) * std::tan(friction));
    EXPECT_EQ(relax(block_on_slope(1.001 * demand, friction, degrees(5), tilt), until_onset()).broken_bonds, 0U);
    const RelaxationResult slides = relax(block_on_slope(0.999 * demand, friction, degrees(5), tilt), until_onset());
    EXPECT_EQ(slides.broken_bonds, 1U);
    EXPECT_EQ(slides.outcome, RelaxationOutcome::onset);
    EXPECT_EQ(slides.block[0].movement, BlockMovement::slides_forward);
}

// The joint is far stiffer than the rock and has enough friction: it takes over without a jerk.
TEST(Bonds, HandOverWhatTheyCarry) {
    const double tilt = degrees(25);
    RelaxationSettings settings;
    settings.start = RelaxationStart::ramped;
    settings.ramp_time = 0.5;
    const RelaxationScene scene = block_on_slope(100, 0, degrees(40), tilt);
    Simulation simulation(scene, settings);
    double fastest_before = 0;
    double fastest_after = 0;
    while (simulation.running()) {
        simulation.step();
        const bool whole = simulation.state().bond[0].state == BondState::whole;
        EXPECT_EQ(simulation.state().contacts.contact.empty(), whole);
        double& fastest = whole ? fastest_before : fastest_after;
        fastest = std::max(fastest, simulation.kinetic_energy());
    }
    EXPECT_EQ(simulation.outcome(), RelaxationOutcome::equilibrium);
    EXPECT_EQ(simulation.state().bond[0].state, BondState::broken_in_shear);
    const RelaxationResult result = simulation.result();
    // The rock is shortened by W cos(tilt) / (E b / (b / 2)); a jerk would throw the block as far.
    const double shortened = density * gravity * std::cos(tilt) / 2e7;
    EXPECT_LT(fastest_after, 2 * fastest_before + 1e-3 * density * gravity * shortened);
    EXPECT_LT(result.block[0].displacement, 4 * shortened);
    EXPECT_LT(energy_error(result, 0), 0.01);
    EXPECT_GE(result.energy_balance.bonds, 0);
}

// What the rock has shortened counts on every edge of the two blocks: the block slides over a vertex of the plane onto
// an edge that was not bonded, where it would lie a millimetre too deep, with a hundred times the energy that it has.
TEST(Bonds, LeaveNothingToBearOnOtherEdges) {
    for (const bool vertex_at_the_end : {true, false}) {
        RelaxationScene scene = block_on_slope(100, 0, degrees(5), degrees(25));
        Polygon<>& plane = scene.block[1].outline;
        plane.insert(plane.begin() + 3, {vertex_at_the_end ? -0.05 : 0.6, 0.0});
        scene.bond = find_bonds(scene);
        ASSERT_EQ(scene.bond.size(), vertex_at_the_end ? 1U : 2U);
        RelaxationSettings settings = unlimited(0.5);
        const RelaxationResult result = relax(scene, settings);
        EXPECT_EQ(result.broken_bonds, scene.bond.size());
        EXPECT_GT(result.block[0].displacement, 0.3);
        // The error is that of steps of 0.6 of the stable one, as above.
        EXPECT_LT(energy_error(result, 0), 0.02) << vertex_at_the_end;
    }
}

// The wall consists of squares on a fixed row, bonded weakly enough to fall apart on a slope.
RelaxationScene weak_wall(std::size_t columns, std::size_t rows) {
    RelaxationScene scene;
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t column = 0; column < columns; ++column) {
            scene.block.push_back({rectangle(static_cast<double>(column), static_cast<double>(row), 1, 1), density});
        }
    }
    scene.block.push_back(fixed_block(rectangle(-2, -1, static_cast<double>(columns) + 4, 1)));
    scene.material = {joint(1e9, degrees(20))};
    scene.material[0].bond = BondMaterial{1e9, 4e8, 2e4, 4e4, degrees(30)};
    scene.gravity.tilt = scene.gravity.final_tilt = degrees(40);
    scene.bond = find_bonds(scene);
    return scene;
}

RelaxationSettings dropped(std::size_t threads) {
    RelaxationSettings settings;
    settings.start = RelaxationStart::dropped;
    settings.threads = threads;
    return settings;
}

std::size_t number_broken(const Simulation& simulation) {
    return simulation.result().broken_bonds;
}

TEST(Bonds, GoOnFromCheckpointsAndForAnyNumberOfThreads) {
    // More than 512 bonds are divided among the threads.
    const RelaxationScene scene = weak_wall(18, 16);
    ASSERT_GT(scene.bond.size(), 512U);
    Simulation whole(scene, dropped(1));
    Simulation divided(scene, dropped(2));
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
    EXPECT_GT(number_broken(whole), 0U);
    EXPECT_LT(number_broken(whole), scene.bond.size());
    EXPECT_TRUE(checkpoint_of(scene, divided.settings(), divided.state()) == end);
    RestoredState restored = restore_checkpoint(middle, scene, whole.settings());
    ASSERT_EQ(restored.check, CheckpointCheck::ok);
    Simulation rest(scene, whole.settings(), std::move(restored.state));
    EXPECT_LT(number_broken(rest), number_broken(whole)) << "nothing breaks in the second half";
    for (int step = steps / 2; step < steps; ++step) {
        rest.step();
    }
    EXPECT_TRUE(checkpoint_of(scene, rest.settings(), rest.state()) == end);
}

TEST(Bonds, BooksOfABreakingWallBalance) {
    RelaxationSettings settings = dropped(1);
    settings.local_damping = 0;
    settings.duration = 0.4;
    RelaxationScene scene = weak_wall(4, 4);
    // The bonds are now so strong that some hold.
    scene.material[0].bond->tensile_strength *= 1.5;
    scene.material[0].bond->cohesion *= 1.5;
    const RelaxationResult result = relax(scene, settings);
    EXPECT_GT(result.broken_bonds, 0U);
    EXPECT_LT(result.broken_bonds, scene.bond.size());
    // Explicit steps of 0.6 of the stable one leave this error in any run of colliding blocks.
    EXPECT_LT(energy_error(result, 0), 0.02);
}

// Bonds to a block that is taken away go with it.
TEST(Bonds, GoWithARemovedBlock) {
    RelaxationScene scene = cantilever(4);
    scene.removal = {{1, 0.001}};
    RelaxationSettings settings = until_onset();
    Simulation simulation(scene, settings);
    while (simulation.running()) {
        simulation.step();
    }
    EXPECT_EQ(simulation.outcome(), RelaxationOutcome::onset);
    EXPECT_EQ(std::ranges::count_if(simulation.state().bond,
                                    [](const BondMemory& memory) { return memory.state == BondState::block_removed; }),
              2);
    EXPECT_EQ(simulation.result().broken_bonds, 0U);
}

TEST(Bonds, OfNoUseAreRefused) {
    const auto fault = [](const std::function<void(RelaxationScene&)>& change) {
        RelaxationScene scene = cantilever(3);
        change(scene);
        return check_scene(scene).check;
    };
    EXPECT_EQ(fault([](RelaxationScene&) {}), SceneCheck::valid);
    EXPECT_EQ(fault([](RelaxationScene& one) { one.bond[0].edge = 0; }), SceneCheck::bond_without_face);
    EXPECT_EQ(fault([](RelaxationScene& one) { one.bond[0].edge = 9; }), SceneCheck::unknown_edge);
    EXPECT_EQ(fault([](RelaxationScene& one) { one.bond[0].other = 9; }), SceneCheck::unknown_block);
    EXPECT_EQ(fault([](RelaxationScene& one) { one.bond[0].other = one.bond[0].block; }), SceneCheck::unknown_block);
    EXPECT_EQ(fault([](RelaxationScene& one) { one.material[0].bond.reset(); }), SceneCheck::unknown_material);
    EXPECT_EQ(fault([](RelaxationScene& one) { one.material[0].bond->young_modulus = 0; }),
              SceneCheck::modulus_not_positive);
    EXPECT_EQ(fault([](RelaxationScene& one) { one.material[0].bond->spacing = 0; }), SceneCheck::modulus_not_positive);
    EXPECT_EQ(fault([](RelaxationScene& one) { one.material[0].bond->cohesion = -1; }), SceneCheck::strength_negative);
    EXPECT_EQ(fault([](RelaxationScene& one) { one.material[0].bond->friction_angle = 2; }),
              SceneCheck::friction_out_of_range);
    EXPECT_EQ(fault([](RelaxationScene& one) { one.material[0].bond->tensile_strength = std::nan(""); }),
              SceneCheck::number_not_finite);
}

}  // namespace
}  // namespace delabole
