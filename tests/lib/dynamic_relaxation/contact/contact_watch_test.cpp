// Contacts are searched for where something has moved, and only there.
#include "dynamic_relaxation/contact/contact_watch.hpp"

#include "dynamic_relaxation/blocks/neighbours.hpp"
#include "dynamic_relaxation/checkpoint/checkpoint.hpp"
#include "dynamic_relaxation/contact/contact_law.hpp"
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>

namespace delabole {
namespace {

using relaxation_scenes::density;
using relaxation_scenes::fixed_block;
using relaxation_scenes::gravity;
using relaxation_scenes::joint;
using relaxation_scenes::rectangle;
using relaxation_scenes::unlimited;

RelaxationScene on_floor(std::vector<RelaxationBlock> blocks) {
    RelaxationScene scene;
    scene.block = std::move(blocks);
    scene.block.push_back(fixed_block(rectangle(-40, -2, 120, 2)));
    scene.material = {joint(1e5 * density * gravity, degrees(35))};
    return scene;
}

// A wall of square blocks that stands, and a splinter of 5 mm by 20 mm that falls beside it from 3 m.
RelaxationScene wall_and_splinter(int rows, int columns) {
    std::vector<RelaxationBlock> blocks;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            blocks.push_back({rectangle(column, row, 1, 1), density});
        }
    }
    const PlanePoint<> tip(-2, 3);
    blocks.push_back({{tip, tip + PlanePoint<>(0.005, 0.001), tip + PlanePoint<>(0.002, 0.02)}, density});
    return on_floor(std::move(blocks));
}

std::uint64_t looks_after_the_first(int rows, int columns) {
    RelaxationSettings settings = unlimited(1);
    // The step is the same for both walls: corners where four blocks meet bear 4e-5 s.
    settings.time_step = 2.5e-5;
    Simulation simulation(wall_and_splinter(rows, columns), settings);
    const std::uint64_t first = simulation.state().watch.pair_checks;
    while (simulation.running()) {
        simulation.step();
    }
    // The splinter has fallen, and lies or bounces on the floor.
    EXPECT_LT(simulation.state().motion[static_cast<std::size_t>(rows * columns)].y, -2);
    return simulation.state().watch.pair_checks - first;
}

TEST(ContactWatch, SplinterDoesNotMakeAWallBeSearchedAgain) {
    const std::uint64_t of_few = looks_after_the_first(1, 3);
    EXPECT_GT(of_few, 10U);
    EXPECT_EQ(looks_after_the_first(6, 40), of_few);
}

TEST(ContactWatch, BlocksThatFallSideBySideAreNotLookedAtAgain) {
    std::vector<RelaxationBlock> blocks;
    for (int column = 0; column < 10; ++column) {
        // The gaps are 0.1 mm, far less than the blocks fall in a step.
        blocks.push_back({rectangle(1.0001 * column, 30, 1, 1), density});
    }
    RelaxationSettings settings = unlimited(1.5);
    settings.start = RelaxationStart::dropped;
    Simulation simulation(on_floor(std::move(blocks)), settings);
    simulation.step();
    // Only the floor is far from the blocks: 9 pairs remain.
    const std::uint64_t first = simulation.state().watch.pair_checks;
    EXPECT_EQ(first, 9U);
    while (simulation.running()) {
        simulation.step();
    }
    EXPECT_LT(simulation.state().motion[0].y, -8);
    EXPECT_EQ(simulation.state().watch.pair_checks, first);
}

// Rubble of very different sizes: corners on an ellipse at random angles.
RelaxationScene rubble(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> any(0, 1);
    std::vector<RelaxationBlock> blocks;
    for (int index = 0; index < 24; ++index) {
        const PlanePoint<> centre(index % 4 + 0.1 * any(random), 0.6 + index / 4 + 0.1 * any(random));
        const double size = 0.45 * std::pow(10, -1.5 * any(random));
        const int count = 3 + static_cast<int>(4 * any(random));
        Polygon<> outline;
        for (int corner = 0; corner < count; ++corner) {
            const double at = 2 * std::acos(-1.0) * (corner + 0.7 * any(random)) / count;
            outline.emplace_back(centre + size * PlanePoint<>(std::cos(at), 0.6 * std::sin(at)));
        }
        blocks.push_back({outline, density});
    }
    return on_floor(std::move(blocks));
}

std::string after(const RelaxationScene& scene, const RelaxationSettings& settings, int steps, int stop) {
    Simulation simulation(scene, settings);
    for (int step = 0; step < stop; ++step) {
        simulation.step();
    }
    RestoredState restored = restore_checkpoint(checkpoint_of(scene, settings, simulation.state()), scene, settings);
    EXPECT_EQ(restored.check, CheckpointCheck::ok);
    Simulation rest(scene, settings, std::move(restored.state));
    for (int step = stop; step < steps; ++step) {
        rest.step();
    }
    return checkpoint_of(scene, settings, rest.state());
}

// A force drives the blocks deep into each other: both are due, and their contacts are replaced once.
TEST(ContactWatch, BlocksShotIntoEachOtherEndTheRun) {
    for (double force = 1e10; force < 1e12; force *= 1.15) {
        RelaxationScene scene;
        double height = 4;
        for (int column = 0; column < 4; ++column, height += 4) {
            scene.block.push_back({rectangle(10 * column, column, 10, height), density});
            scene.block.push_back(fixed_block(rectangle(10 * column, column - 20, 10, 20)));
        }
        scene.material = {joint(1e5 * density * gravity, degrees(42))};
        scene.force.push_back({0, PlanePoint<>(0, 4), force * PlanePoint<>(0.87, 0.5)});
        RelaxationSettings settings = unlimited(1);
        settings.start = RelaxationStart::dropped;
        Simulation simulation(scene, settings);
        while (simulation.running()) {
            simulation.step();
        }
        EXPECT_EQ(simulation.outcome(), RelaxationOutcome::overlap_too_large) << force;
    }
}

// Each plate lies within the bounding boxes of all others. Comparing them pair by pair took a check of a section cut
// every 2.5 mm 25 s.
TEST(ContactWatch, CrowdedPlatesAreNeighboursOnlyOfThoseBesideThem) {
    constexpr double thickness = 0.0025;
    constexpr std::size_t plates = 500;
    const PlanePoint<> along(std::cos(degrees(35)), std::sin(degrees(35)));
    const PlanePoint<> across(-along.y(), along.x());
    RelaxationScene scene;
    const auto add_plate = [&](double below, double begin, double length) {
        const PlanePoint<> corner = below * across + begin * along;
        scene.block.push_back(
            {{corner, PlanePoint<>(corner + length * along), PlanePoint<>(corner + length * along + thickness * across),
              PlanePoint<>(corner + thickness * across)},
             density});
    };
    for (std::size_t plate = 0; plate < plates; ++plate) {
        add_plate(thickness * static_cast<double>(plate), 0, 5);
    }
    add_plate(-thickness, -250, 500);  // covers more cells than blocks are sorted into
    scene.material = {joint(1e5 * density * gravity, degrees(30))};
    const Bodies bodies = make_bodies(scene);
    const std::vector<double> reach(bodies.size(), thickness / 10);
    std::vector<BlockPair> expected;
    for (std::uint32_t plate = 0; plate + 1 < plates; ++plate) {
        expected.emplace_back(plate, plate + 1);
    }
    expected.insert(expected.begin() + 1, BlockPair(0, plates));
    EXPECT_EQ(
        neighbouring_blocks(bodies, std::vector<Motion>(bodies.size()), std::vector<char>(bodies.size(), 0), reach),
        expected);
}

// Cells so far away have no number: a sanitizer ended the run of a case in which a force had a lever arm of 4e9 m.
TEST(ContactWatch, BlocksShotAwayAreNoNeighbours) {
    RelaxationScene scene;
    for (int block = 0; block < 20; ++block) {
        scene.block.push_back({rectangle(block, 0, 1, 1), density});
    }
    scene.material = {joint(1e5 * density * gravity, degrees(30))};
    const Bodies bodies = make_bodies(scene);
    std::vector<Motion> motion(bodies.size());
    const std::vector<char> removed(bodies.size(), 0);
    const std::vector<double> reach(bodies.size(), 0.01);
    EXPECT_EQ(neighbouring_blocks(bodies, motion, removed, reach).size(), 19U);
    for (const double away : {1e6, 1e16, 1e28, 1e300}) {
        motion[7].x = away;
        motion[7].y = -away;
        EXPECT_EQ(neighbouring_blocks(bodies, motion, removed, reach).size(), 17U) << away;
    }
}

// Checks for contacts, and all that follows from them, are part of the state.
TEST(ContactWatch, LooksTheSameOnAnyThreadsAndAfterARestart) {
    const RelaxationScene scene = rubble(7);
    RelaxationSettings settings = unlimited(1e3);
    settings.start = RelaxationStart::dropped;
    constexpr int steps = 6000;
    const std::string whole = after(scene, settings, steps, 0);
    for (const int stop : {1, 1717, 4041}) {
        EXPECT_TRUE(after(scene, settings, steps, stop) == whole) << stop;
    }
    settings.threads = 3;
    EXPECT_TRUE(after(scene, settings, steps, 0) == whole);
    Simulation simulation(scene, settings);
    for (int step = 0; step < steps; ++step) {
        simulation.step();
    }
    EXPECT_GT(simulation.state().watch.pair_checks, 5 * simulation.state().watch.pair.size());
    EXPECT_GT(simulation.state().watch.searches, 5U);
}

// A search of the whole scene finds no corner on its way into a block that the kept list does not know.
TEST(ContactWatch, KeepsEveryContactThatTouches) {
    std::size_t touching = 0;
    for (unsigned seed = 1; seed <= 5; ++seed) {
        RelaxationSettings settings = unlimited(1.2);
        settings.start = RelaxationStart::dropped;
        Simulation simulation(rubble(seed), settings);
        while (simulation.running()) {
            simulation.step();
            if (simulation.state().steps % 20 != 0) {
                continue;
            }
            const RelaxationState& state = simulation.state();
            const ContactList& kept = state.contacts;
            const ContactList fresh = find_contacts(simulation.scene(), simulation.bodies(), state.motion,
                                                    state.removed, {1e-6, 0.2, false, {}}, kept);
            for (std::size_t index = 0; index < fresh.contact.size(); ++index) {
                const RelaxationContact contact = fresh.contact[index];
                const ContactPosition at = locate(contact, state.motion[contact.block], state.motion[contact.other]);
                const double shortest = std::min(simulation.bodies().shortest_edge[contact.block],
                                                 simulation.bodies().shortest_edge[contact.other]);
                // The last step has been taken since the list was brought up to date: a tenth of a margin at most.
                if (at.gap > -1e-3 * shortest || contact_weight(fresh.law_of(contact), contact, at, false) == 0) {
                    continue;
                }
                ++touching;
                EXPECT_TRUE(std::ranges::any_of(
                    kept.contact.corners(),
                    [&](const ContactCorner& one) { return one.corner == contact.corner && one.edge == contact.edge; }))
                    << "seed " << seed << " step " << state.steps << " corner " << contact.corner << " edge "
                    << contact.edge << " gap " << at.gap / shortest;
            }
        }
    }
    EXPECT_GT(touching, 100U);
}

}  // namespace
}  // namespace delabole
