// The ends of the ranges of dynamic relaxation: shapes of blocks, friction, sizes, unit weights, stiffness, steps,
// gaps. Each has the outcome it must have: limit equilibrium's, or a refusal (relaxation_refusals_test.cpp).
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include <gtest/gtest.h>

#include <array>

namespace delabole {
namespace {

using namespace relaxation_scenes;

// Tangent of the tilt at which the heel's spring is spent and the toe's carries all.
double toppling_law(const OnPlane& plane) {
    const double slope = 1 / plane.height_to_width;
    return slope - std::sqrt(1 + slope * slope) / plane.stiffness_ratio;
}

// This energy is far below what a fall by a hair turns over.
double rounding(const OnPlane& plane) {
    return 1e-6 * plane.weight() * plane.width;
}

// The smaller of the limits of sliding and toppling decides, also on the kind of failure.
TEST(Shapes, FromFlatToSlenderFailWhereTheyMust) {
    for (const double slenderness : {0.05, 0.3, 1.0, 5.0, 20.0, 100.0}) {
        for (const double friction : {0.3, 30.0, 60.0, 89.0}) {
            OnPlane plane;
            plane.height_to_width = slenderness;
            plane.friction = degrees(friction);
            // A slender block needs joints that are stiffer as the square of its slenderness.
            plane.stiffness_ratio = std::max(1e6, 1e5 * slenderness * slenderness / 9);
            const double topples = toppling_law(plane);
            const double slides = std::tan(plane.friction);
            const double limit = std::min(topples, slides);
            // The toppling law holds to 0.5 %. A sliding block must reach its threshold before the time is out.
            const double off = slides < topples ? 0.02 : 0.005;
            const auto with_tilt = [&](double tangent) {
                plane.tilt = std::atan(tangent);
                RelaxationSettings settings = until_onset();
                settings.onset_rotation = 2e-3;  // tall blocks take long to turn
                return relax(scene_of(plane), settings);
            };
            const std::string what = "a/b " + std::to_string(slenderness) + ", friction " + std::to_string(friction);
            EXPECT_EQ(with_tilt((1 - off) * limit).outcome, RelaxationOutcome::equilibrium) << what;
            const RelaxationResult fails = with_tilt((1 + off) * limit);
            EXPECT_EQ(fails.outcome, RelaxationOutcome::onset) << what;
            EXPECT_EQ(fails.block[0].movement,
                      slides < topples ? BlockMovement::slides_forward : BlockMovement::rotates)
                << what;
            EXPECT_LT(energy_error(fails, rounding(plane)), 0.02) << what;
        }
    }
}

// Two blocks whose angles of friction add up to more and more: below 90 deg they fail as the limit equilibrium of two
// blocks says, beyond it friction alone carries no more; nothing must break down in between.
TEST(Friction, ThroughNinetyDegreesInAll) {
    double before = 0;
    for (const double friction : {0.0, 5.0, 20.0, 35.0, 44.9, 45.0, 45.1, 60.0, 80.0, 89.0, 89.9}) {
        const auto at_tilt = [&](double tilt) {
            RelaxationScene scene;
            for (const double left : {0.0, 1.0}) {
                scene.block.push_back({rectangle(left, 0, 1, 3), density});
            }
            scene.block.push_back(fixed_block(rectangle(-3, -1, 8, 1)));
            scene.material = {joint(1e6 * density * gravity * 3, degrees(friction))};
            scene.gravity.tilt = scene.gravity.final_tilt = degrees(tilt);
            return relax(scene, until_onset());
        };
        // Greatest tilt that stands, in half degrees.
        double stands = 0;
        for (double tilt = 0.5; tilt < 40; tilt += 0.5) {
            const RelaxationResult result = at_tilt(tilt);
            ASSERT_TRUE(result.outcome == RelaxationOutcome::onset || result.outcome == RelaxationOutcome::equilibrium)
                << "friction " << friction << ", tilt " << tilt;
            EXPECT_LT(energy_error(result, 1e-6 * density * gravity), 0.02)
                << "friction " << friction << ", tilt " << tilt;
            if (result.outcome != RelaxationOutcome::equilibrium) {
                break;
            }
            stands = tilt;
        }
        // More friction never fails earlier, to the half degree that is resolved, and the two together stand no longer
        // than one block of 2 x 3 m.
        EXPECT_GE(stands, before) << "friction " << friction;
        EXPECT_LE(stands, 33.69) << "friction " << friction;
        EXPECT_LE(stands, friction) << "friction " << friction;
        before = stands;
    }
    EXPECT_GT(before, 18.0);  // one block alone: 18.4
}

RelaxationResult toppling_block(double width, double unit_weight_factor, double tilt, double duration_factor) {
    OnPlane plane;
    plane.height_to_width = 3;
    plane.width = width;
    plane.friction = degrees(40);
    plane.tilt = degrees(tilt);
    plane.density *= unit_weight_factor;
    RelaxationSettings settings = until_onset();
    settings.duration = 60 * duration_factor;
    return relax(scene_of(plane), settings);
}

// Under one gravity, lengths times s and times sqrt(s) leave everything else as it is; stiffness goes with the length,
// because k b / W does. Where s is a power of four no rounding changes either, and every bit agrees.
TEST(Similarity, OfLengths) {
    for (const double tilt : {17.0, 18.3, 18.5, 25.0}) {
        const RelaxationResult one = toppling_block(1, 1, tilt, 1);
        for (const int power : {-5, -2, 2, 6}) {
            const double length = std::pow(4.0, power);
            const RelaxationResult other = toppling_block(length, 1, tilt, std::sqrt(length));
            EXPECT_EQ(one.outcome, other.outcome) << length;
            EXPECT_EQ(one.cost.steps, other.cost.steps) << length;
            EXPECT_EQ(one.time * std::sqrt(length), other.time) << length;
            EXPECT_EQ(one.block[0].rotation, other.block[0].rotation) << length;
            EXPECT_EQ(one.block[0].displacement * length, other.block[0].displacement) << length;
            EXPECT_EQ(one.energy_balance.applied * length * length * length, other.energy_balance.applied) << length;
        }
        for (const double length : {1e-3, 0.0254, 50.0, 5000.0}) {
            const RelaxationResult other = toppling_block(length, 1, tilt, std::sqrt(length));
            EXPECT_EQ(one.outcome, other.outcome) << length;
            // A block on one edge leaves its start as an exponential of time: rounding grows with it, a thousandfold
            // until 0.01 rad are reached, and the step at which a check finds them differs by 50 steps.
            EXPECT_NEAR(one.block[0].rotation, other.block[0].rotation, 0.01 * std::abs(one.block[0].rotation) + 1e-12)
                << length;
        }
    }
}

// Unit weights of 0.1 to 100 kN/m3, stiffness along: mass drops out.
TEST(Similarity, OfUnitWeights) {
    for (const double tilt : {18.3, 18.5}) {
        const RelaxationResult one = toppling_block(1, 1, tilt, 1);
        for (const double factor : {1 / 256.0, 1 / 64.0, 0.25, 4.0}) {
            const RelaxationResult other = toppling_block(1, factor, tilt, 1);
            EXPECT_EQ(one.outcome, other.outcome) << factor;
            EXPECT_EQ(one.cost.steps, other.cost.steps) << factor;
            EXPECT_EQ(one.block[0].rotation, other.block[0].rotation) << factor;
            EXPECT_EQ(one.energy_balance.applied * factor, other.energy_balance.applied) << factor;
        }
        for (const double unit_weight : {0.1e3, 1e3, 100e3}) {
            const RelaxationResult other = toppling_block(1, unit_weight / (density * gravity), tilt, 1);
            EXPECT_EQ(one.outcome, other.outcome) << unit_weight;
        }
    }
}

TEST(Stiffness, FromSoftToHard) {
    for (const double ratio : {1e2, 1e3, 1e5, 1e8, 1e12}) {
        OnPlane plane;
        plane.height_to_width = 2;
        plane.friction = degrees(50);
        plane.stiffness_ratio = ratio;
        const auto at = [&](double share) {
            plane.tilt = std::atan(share * toppling_law(plane));
            RelaxationSettings settings = until_onset();
            settings.onset_rotation = 2e-3;  // stiff springs take many steps
            return relax(scene_of(plane), settings);
        };
        const RelaxationResult stands = at(0.995);
        EXPECT_EQ(stands.outcome, RelaxationOutcome::equilibrium) << ratio;
        // The two base springs carry what lever arms say: overlaps far above rounding for every stiffness.
        ASSERT_TRUE(stands.deepest) << ratio;
        const double toe = plane.weight() * std::cos(plane.tilt) * (1 + 2 * std::tan(plane.tilt)) / 2;
        // Arms change by the lean of the block, 1/ratio, near the limit; rounding is 1e-16 of 1e-12.
        EXPECT_NEAR(stands.deepest->overlap * plane.stiffness(), toe, (5 / ratio + 1e-3) * toe) << ratio;
        const RelaxationResult fails = at(ratio > 1e10 ? 1.1 : 1.005);
        EXPECT_EQ(fails.outcome, RelaxationOutcome::onset) << ratio;
        EXPECT_LT(energy_error(fails, rounding(plane)), 0.02) << ratio;
    }
}

// A step that is given is divided where it is above the share of the stable one; the answer does not depend on it.
TEST(Step, FromSmallToAboveTheStableOne) {
    OnPlane plane;
    plane.height_to_width = 2;
    plane.friction = degrees(50);
    plane.stiffness_ratio = 1e5;
    const double stable = [&] {
        RelaxationSettings settings;
        settings.step_fraction = 0.8;
        Simulation simulation(scene_of(plane), settings);
        simulation.step();
        return simulation.state().step / settings.step_fraction;
    }();
    const double law = toppling_law(plane);
    for (const double share : {0.05, 0.2, 0.4, 0.6, 1.0, 1.2, 50.0}) {
        RelaxationSettings settings = until_onset();
        settings.time_step = share * stable;
        for (const bool fails : {false, true}) {
            plane.tilt = std::atan((fails ? 1.005 : 0.995) * law);
            const RelaxationResult result = relax(scene_of(plane), settings);
            EXPECT_EQ(result.outcome, fails ? RelaxationOutcome::onset : RelaxationOutcome::equilibrium) << share;
            EXPECT_LE(result.cost.step, settings.step_fraction * stable * 1.0001) << share;
            // A whole number of steps makes one step as asked for.
            const double parts = *settings.time_step / result.cost.step;
            EXPECT_NEAR(parts, std::round(parts), 1e-9 * parts) << share;
            EXPECT_LT(energy_error(result, rounding(plane)), 0.02) << share;
        }
    }
}

// Blocks in a row are drawn a little apart or into each other: nothing flies off, and no falling block gains energy.
TEST(Gaps, AndOverlapsInADrawing) {
    constexpr double ratio = 1e4;  // W/k = 1e-4: an overlap of 1e-3 is the most that is accepted
    for (const double gap : {-1e-3, -5e-4, -1e-6, 0.0, 1e-9, 1e-6, 1e-3}) {
        for (const auto start : {RelaxationStart::preloaded, RelaxationStart::dropped}) {
            RelaxationScene scene;
            for (int index = 0; index < 3; ++index) {
                scene.block.push_back({rectangle(index * (1 + gap), gap, 1, 1), density});
            }
            scene.block.push_back(fixed_block(rectangle(-3, -1, 9, 1)));
            scene.material = {joint(ratio * density * gravity, degrees(40))};
            scene.gravity.tilt = scene.gravity.final_tilt = degrees(10);
            RelaxationSettings settings;
            settings.start = start;
            const RelaxationResult result = relax(scene, settings);
            // The tilt is far from any limit of a single block, so that it settles, wherever that is.
            EXPECT_EQ(result.outcome, RelaxationOutcome::equilibrium) << gap;
            for (std::size_t block = 0; block < 3; ++block) {
                // An overlap throws a block up by v^2/2g = k o^2 / 2 W, 5e-3 m here at most, each with friction.
                EXPECT_LT(result.block[block].displacement, 0.03) << gap << " block " << block;
                EXPECT_LT(std::abs(result.block[block].rotation), 0.01) << gap << " block " << block;
            }
            EXPECT_LT(energy_error(result, 1e-6 * density * gravity), 0.02) << gap;
        }
    }
}

// The faces differ from the vertical by up to 0.01 deg, and by a hair.
TEST(Faces, NearlyVertical) {
    for (const double lean : {-0.01, -1e-4, -1e-8, 0.0, 1e-8, 1e-4, 0.01}) {
        const double offset = 3 * std::tan(degrees(lean));
        const auto at_tilt = [&](double tilt) {
            RelaxationScene scene;
            for (const double left : {0.0, 1.0}) {
                scene.block.push_back(
                    {{{left, 0}, {left + 1, 0}, {left + 1 + offset, 3}, {left + offset, 3}}, density});
            }
            scene.block.push_back(fixed_block(rectangle(-3, -1, 8, 1)));
            scene.material = {joint(1e7 * density * gravity * 3, degrees(20)),
                              joint(1e7 * density * gravity * 3, degrees(20))};
            scene.gravity.tilt = scene.gravity.final_tilt = degrees(tilt);
            return relax(scene, until_onset()).outcome;
        };
        // Upright faces have 18.629; a lean changes it by about as much as itself, and the blocks jam late.
        EXPECT_EQ(at_tilt(18.629 - 0.04), RelaxationOutcome::equilibrium) << lean;
        EXPECT_EQ(at_tilt(18.629 + 0.04), RelaxationOutcome::onset) << lean;
    }
}

TEST(Sizes, SmallBesideLarge) {
    // This is the most that is accepted: a pebble of 2 mm and a block of 90 m on one floor, each by itself.
    RelaxationScene scene;
    scene.block = {{rectangle(0, 0, 45, 45), density}, {rectangle(-1, 0, 2e-3, 2e-3), density}};
    scene.block.push_back(fixed_block(rectangle(-10, -10, 120, 10)));
    scene.material = {joint(1e4 * density * gravity * 45, degrees(30))};
    for (const bool slides : {false, true}) {
        scene.gravity.tilt = scene.gravity.final_tilt = degrees(slides ? 30.1 : 29.9);
        RelaxationSettings settings = until_onset();
        settings.onset_slide = 1e-3;
        const RelaxationResult result = relax(scene, settings);
        EXPECT_EQ(result.outcome, slides ? RelaxationOutcome::onset : RelaxationOutcome::equilibrium);
    }
}

}  // namespace
}  // namespace delabole
