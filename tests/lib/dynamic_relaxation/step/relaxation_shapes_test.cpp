// Awkward polygons, and scenes that must agree with each other: mirrored, moved far away, drawn in another frame.
#include "dynamic_relaxation/step/scene_check.hpp"
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace delabole {
namespace {

using namespace relaxation_scenes;

double lowest(const RelaxationState& state, const Bodies& bodies, std::size_t block) {
    double y = std::numeric_limits<double>::infinity();
    for (std::size_t corner = bodies.range[block].begin; corner < bodies.range[block].end; ++corner) {
        y = std::min(y, moved_corner(bodies, state.motion, corner).y());
    }
    return y;
}

RelaxationScene on_floor(std::vector<RelaxationBlock> blocks, double friction, double stiffness_ratio = 1e6) {
    RelaxationScene scene;
    scene.block = std::move(blocks);
    scene.block.push_back(fixed_block(rectangle(-20, -2, 40, 2)));
    scene.material = {joint(stiffness_ratio * density * gravity, degrees(friction))};
    return scene;
}

TEST(Corners, FourBricksMeetInAPointAndStand) {
    for (const auto start : {RelaxationStart::preloaded, RelaxationStart::dropped}) {
        const RelaxationScene scene = on_floor({{rectangle(0, 0, 1, 1), density},
                                                {rectangle(1, 0, 1, 1), density},
                                                {rectangle(0, 1, 1, 1), density},
                                                {rectangle(1, 1, 1, 1), density}},
                                               30);
        RelaxationSettings settings;
        settings.start = start;
        const RelaxationResult result = relax(scene, settings);
        EXPECT_EQ(result.outcome, RelaxationOutcome::equilibrium);
        for (std::size_t block = 0; block < 4; ++block) {
            // Settlements of W/2k to 2 W/k, and as much again on a drop.
            EXPECT_LT(result.block[block].displacement, 1e-5) << block;
            EXPECT_LT(std::abs(result.block[block].rotation), 1e-5) << block;
        }
    }
}

// Blocks that touch only at their corners do not fly apart.
TEST(Corners, OnACornerDoNotExplode) {
    const double side = std::sqrt(0.5);
    const auto diamond = [&](double x, double y) {
        return Polygon<>{{x, y}, {x + side, y + side}, {x, y + 2 * side}, {x - side, y + side}};
    };
    const std::vector<std::vector<RelaxationBlock>> packs{
        // A block stands on the very corner of one that is not beside it.
        {{rectangle(0, 0, 1, 1), density}, {rectangle(1, 1, 1, 1), density}},
        // A point stands on a point.
        {{diamond(0, 0), density}, {diamond(0, 2 * side), density}},
        // A blunt point stands on a blunt point.
        {{{{0, 0}, {1.5, 1}, {0, 2}, {-1.5, 1}}, density}, {{{0, 2}, {1.5, 3}, {0, 4}, {-1.5, 3}}, density}},
        // A point stands on the corner of a block.
        {{rectangle(0, 0, 1, 1), density}, {diamond(1, 1), density}},
        // A point stands where two blocks meet.
        {{rectangle(0, 0, 1, 1), density}, {rectangle(1, 0, 1, 1), density}, {diamond(1, 1), density}},
        // Wedges lie point to point in a row.
        {{{{0, 0}, {1, 0.5}, {0, 1}}, density}, {{{1, 0.5}, {2, 0}, {2, 1}}, density}},
    };
    for (std::size_t index = 0; index < packs.size(); ++index) {
        const RelaxationScene scene = on_floor(packs[index], 30, 1e5);
        Simulation simulation(scene, unlimited(2));
        while (simulation.running()) {
            simulation.step();
        }
        const RelaxationResult result = simulation.result();
        EXPECT_TRUE(ends_as_blocks_do(result.outcome)) << index;
        EXPECT_LT(energy_error(result, 1e-6 * density * gravity), 0.02) << index;
        EXPECT_LE(result.energy_balance.kinetic, result.energy_balance.applied + 1e-6 * density * gravity) << index;
        for (std::size_t block = 0; block + 1 < scene.block.size(); ++block) {
            // No block sinks, and none is farther away than it can have fallen over.
            EXPECT_GT(lowest(simulation.state(), simulation.bodies(), block), -1e-3) << index;
            EXPECT_LT(result.block[block].displacement, 4) << index;
        }
    }
}

// A block with a sliver of an edge at its toe stands as one without, until the corner that bears is another.
TEST(Slivers, AndNearlyParallelEdges) {
    for (const double sliver : {1e-4, 1e-3, 1e-2}) {
        for (const bool steep : {false, true}) {
            // The toe is cut off: along the base by `sliver`, and as much up, or ten times.
            const double up = steep ? 10 * sliver : sliver;
            const auto outcome = [&](double share) {
                RelaxationScene scene = on_floor({{{{sliver, 0}, {1, 0}, {1, 3}, {0, 3}, {0, up}}, density}}, 60, 1e7);
                const AreaProperties<> area = area_properties(scene.block[0].outline);
                const double limit = (area.centroid.x() - sliver) / area.centroid.y();
                scene.gravity.tilt = scene.gravity.final_tilt = std::atan(share * limit);
                return relax(scene, until_onset()).outcome;
            };
            EXPECT_EQ(outcome(0.995), RelaxationOutcome::equilibrium) << sliver << " " << steep;
            EXPECT_EQ(outcome(1.005), RelaxationOutcome::onset) << sliver << " " << steep;
        }
    }
    for (const double bend : {0.0, 1e-10, 1e-6, 1e-3}) {
        // A base that is bent downward in its middle by so little that it bears there or at its ends.
        const auto outcome = [&](double share) {
            RelaxationScene scene = on_floor({{{{0, 0}, {0.5, -bend}, {1, 0}, {1, 1}, {0, 1}}, density}}, 60, 1e5);
            for (PlanePoint<>& vertex : scene.block[0].outline) {
                vertex.y() += bend;
            }
            scene.gravity.tilt = scene.gravity.final_tilt = std::atan(share);
            return relax(scene, until_onset()).outcome;
        };
        // Its limit is 1 as long as the bend is small: a lean of 2 bend over the half base.
        EXPECT_EQ(outcome(0.98), RelaxationOutcome::equilibrium) << bend;
        EXPECT_EQ(outcome(1.02), RelaxationOutcome::onset) << bend;
    }
}

Polygon<> mirrored(Polygon<> outline) {
    for (PlanePoint<>& vertex : outline) {
        vertex.x() = -vertex.x();
    }
    std::reverse(outline.begin(), outline.end());
    return outline;
}

// Two columns and a wedge on them do not fit well.
RelaxationScene irregular(double tilt) {
    RelaxationScene scene = on_floor({{{{0, 0}, {1, 0}, {1, 2.9}, {0, 3.1}}, density},
                                      {{{1, 0}, {2.1, 0}, {2.0, 2.7}, {1, 2.9}}, density},
                                      {{{-1.5, 0}, {-0.2, 0}, {0, 1.2}, {-0.8, 1.5}}, density}},
                                     35, 1e6);
    scene.gravity.tilt = scene.gravity.final_tilt = tilt;
    return scene;
}

TEST(Mirror, ImagesBehaveAsImages) {
    for (const double tilt : {5.0, 15.0, 22.0, 30.0}) {
        const RelaxationScene scene = irregular(degrees(tilt));
        RelaxationScene image = scene;
        for (RelaxationBlock& block : image.block) {
            block.outline = mirrored(block.outline);
        }
        image.gravity.tilt = image.gravity.final_tilt = -scene.gravity.tilt;
        const RelaxationResult one = relax(scene, until_onset());
        const RelaxationResult other = relax(image, until_onset());
        EXPECT_EQ(one.outcome, other.outcome) << tilt;
        for (std::size_t block = 0; block < 3; ++block) {
            // Sums are formed in another order; a block that fails leaves its start as an exponential of time, so that
            // the last digits of the first step are a few per mille at onset.
            const double size = std::abs(one.block[block].rotation) + one.block[block].displacement;
            EXPECT_NEAR(one.block[block].rotation, -other.block[block].rotation, 5e-3 * size + 1e-9)
                << tilt << " block " << block;
            EXPECT_NEAR(one.block[block].base_slip, -other.block[block].base_slip, 5e-3 * size + 1e-9)
                << tilt << " block " << block;
        }
    }
}

TEST(Translation, ByAMillionSizesChangesNothing) {
    for (const double tilt : {5.0, 15.0, 22.0, 30.0}) {
        const RelaxationScene scene = irregular(degrees(tilt));
        const RelaxationResult one = relax(scene, until_onset());
        for (const PlanePoint<>& way : {PlanePoint<>(1e6, -2e6), PlanePoint<>(-1048576, 1048576)}) {
            RelaxationScene far = scene;
            for (RelaxationBlock& block : far.block) {
                for (PlanePoint<>& vertex : block.outline) {
                    vertex += way;
                }
            }
            const RelaxationResult other = relax(far, until_onset());
            EXPECT_EQ(one.outcome, other.outcome) << tilt;
            for (std::size_t block = 0; block < 3; ++block) {
                // The initial geometry is itself rounded to 1e-10 m, a ten-thousandth of the overlaps.
                const double size = std::abs(one.block[block].rotation) + one.block[block].displacement;
                EXPECT_NEAR(one.block[block].rotation, other.block[block].rotation, 0.02 * size + 1e-8)
                    << tilt << " block " << block;
            }
        }
    }
}

TEST(Frame, InclinedDrawingOrTiltedGravity) {
    for (const double tilt : {5.0, 15.0, 22.0, 30.0}) {
        const RelaxationScene level = irregular(degrees(tilt));
        RelaxationScene inclined = level;
        // A scene that dips to -x is turned anticlockwise.
        const double sine = std::sin(degrees(tilt));
        const double cosine = std::cos(degrees(tilt));
        for (RelaxationBlock& block : inclined.block) {
            for (PlanePoint<>& vertex : block.outline) {
                vertex = PlanePoint<>(cosine * vertex.x() - sine * vertex.y(), sine * vertex.x() + cosine * vertex.y());
            }
        }
        inclined.gravity.tilt = inclined.gravity.final_tilt = 0;
        const RelaxationResult one = relax(level, until_onset());
        const RelaxationResult other = relax(inclined, until_onset());
        EXPECT_EQ(one.outcome, other.outcome) << tilt;
        for (std::size_t block = 0; block < 3; ++block) {
            // The tolerance is that of mirror images.
            const double size = std::abs(one.block[block].rotation) + one.block[block].displacement;
            EXPECT_NEAR(one.block[block].rotation, other.block[block].rotation, 5e-3 * size + 1e-9) << tilt;
            EXPECT_NEAR(one.block[block].displacement, other.block[block].displacement, 5e-3 * size + 1e-9) << tilt;
            EXPECT_NEAR(one.block[block].base_slip, other.block[block].base_slip, 5e-3 * size + 1e-9) << tilt;
        }
    }
}

// Corners on an ellipse at random angles: convex, with edges short and long.
Polygon<> random_polygon(std::mt19937& random, const PlanePoint<>& centre) {
    std::uniform_real_distribution<double> any(0, 1);
    const int count = 3 + static_cast<int>(5 * any(random));
    std::vector<double> angle;
    angle.reserve(static_cast<std::size_t>(count));
    for (int index = 0; index < count; ++index) {
        angle.push_back(2 * std::acos(-1.0) * (index + 0.8 * any(random)) / count);
    }
    const double width = 0.2 + 0.25 * any(random);
    const double height = 0.2 + 0.25 * any(random);
    Polygon<> outline;
    for (const double at : angle) {
        outline.emplace_back(centre + PlanePoint<>(width * std::cos(at), height * std::sin(at)));
    }
    return outline;
}

TEST(Fuzz, HeapsOfPolygonsDoNotExplodeOrSink) {
    std::mt19937 random(20260);
    std::uniform_real_distribution<double> any(0, 1);
    for (int trial = 0; trial < 300; ++trial) {
        const std::size_t count = 2 + static_cast<std::size_t>(11 * any(random));
        std::vector<RelaxationBlock> blocks;
        for (std::size_t index = 0; index < count; ++index) {
            // The blocks stand in three files, each in a square of its own.
            const std::size_t file = index % 3;
            const std::size_t floor = index / 3;
            const PlanePoint<> centre(static_cast<double>(file) + 0.05 * any(random),
                                      0.5 + static_cast<double>(floor) + 0.05 * any(random));
            blocks.push_back({random_polygon(random, centre), density * (0.3 + any(random))});
        }
        const RelaxationScene scene = on_floor(std::move(blocks), 60 * any(random), std::pow(10, 4 + any(random)));
        RelaxationSettings settings = unlimited(0.7);
        settings.start = RelaxationStart::dropped;
        settings.local_damping = trial % 2 == 0 ? 0.2 : 0;
        // The limit allows the 0.03 m below, of edges of down to 0.1 m.
        settings.overlap_limit = 0.3;
        ASSERT_EQ(check_start(scene).check, SceneCheck::valid) << "trial " << trial;
        Simulation simulation(scene, settings);
        while (simulation.running()) {
            simulation.step();
        }
        const EnergyBalance energy_balance = simulation.energy_balance();
        EXPECT_TRUE(ends_as_blocks_do(simulation.outcome())) << "trial " << trial;
        ASSERT_TRUE(std::isfinite(energy_balance.kinetic)) << "trial " << trial;
        // No energy is gained; what is lost beyond the balance is that of impacts which last some eight steps.
        EXPECT_GT(energy_balance.residual(), -0.02 * energy_balance.turnover()) << "trial " << trial;
        EXPECT_LT(energy_balance.residual(), 0.05 * energy_balance.turnover()) << "trial " << trial;
        for (std::size_t block = 0; block < count; ++block) {
            // A fall from 4 m onto the softest springs goes b sqrt(2 h W / k b) = 0.03 m deep.
            EXPECT_GT(lowest(simulation.state(), simulation.bodies(), block), -0.03)
                << "trial " << trial << " block " << block;
        }
    }
}

}  // namespace
}  // namespace delabole
