// The laws of contacts and loads at their thresholds, against limit equilibrium and the equation of motion.
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"

#include "dynamic_relaxation/blocks/joint_water.hpp"
#include "dynamic_relaxation/scene/scenes.hpp"
#include "dynamic_relaxation/step/loads.hpp"
#include "tests/support/brick_pack.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace delabole {
namespace {

using namespace relaxation_scenes;

TEST(Cohesion, HoldsUntilItsLengthIsSpent) {
    for (const double friction : {0.0, 20.0}) {
        for (const double share : {0.1, 0.5}) {  // c b / W
            const OnPlane plane = flat(friction);
            const double tangent = std::tan(plane.friction);
            const double limit = root([&](double tilt) { return std::sin(tilt) - std::cos(tilt) * tangent - share; });
            expect_threshold(
                [&](double part) {
                    OnPlane tilted = plane;
                    tilted.tilt = part * limit;
                    RelaxationScene scene = scene_of(tilted);
                    scene.material[0].cohesion = share * plane.weight() / plane.width;
                    return scene;
                },
                "friction " + std::to_string(friction) + ", c b/W " + std::to_string(share));
        }
    }
}

// By the law of contacts alone, without the bond that find_bonds makes of cohesion (joint_strength_test.cpp): the heel
// of a tall block, with less weight on it, slips first; where the toe cannot take over what it loses, the
// block goes at W sin = (W cos - (a/b) W sin) tan(phi) + c b, below what both corners could bear at once.
TEST(Cohesion, OfATallBlockFailsFromTheHeel) {
    OnPlane plane;
    plane.friction = degrees(20);
    const double limit = root([&](double tilt) {
        return std::sin(tilt) - (std::cos(tilt) - std::sin(tilt)) * std::tan(plane.friction) - 0.5;
    });
    expect_threshold(
        [&](double part) {
            OnPlane tilted = plane;
            tilted.tilt = part * limit;
            RelaxationScene scene = scene_of(tilted);
            scene.material[0].cohesion = 0.5 * plane.weight() / plane.width;
            return scene;
        },
        "tall");
}

TEST(Cohesion, IsNotFoundAgainAfterAFall) {
    OnPlane plane = flat(10, degrees(20));
    for (const double height : {0.0, 0.01}) {
        RelaxationScene scene = scene_of(plane);
        scene.material[0].cohesion = 10 * plane.weight() / plane.width;
        for (PlanePoint<>& vertex : scene.block[0].outline) {
            vertex.y() += height;
        }
        RelaxationSettings settings;
        settings.start = RelaxationStart::dropped;
        const RelaxationResult result = relax(scene, settings);
        EXPECT_EQ(result.outcome, height > 0 ? RelaxationOutcome::collapse : RelaxationOutcome::equilibrium) << height;
    }
}

// Of a slender block the toe presses more and the heel slips first. Cohesion that is lost there brings the block down
// early; what remains lets it stand up to limit equilibrium, W sin = W cos tan(phi) + c b, and after a slip, too.
TEST(ResidualCohesion, LetsABlockStandUpToLimitEquilibrium) {
    const double cohesion = 0.3;  // c b / W
    for (const double slenderness : {0.2, 0.9}) {
        OnPlane plane = flat(20);
        plane.height_to_width = slenderness;
        const double limit =
            root([&](double tilt) { return std::sin(tilt) - std::cos(tilt) * std::tan(plane.friction) - cohesion; });
        const auto scene_at = [&](double part, double remains) {
            OnPlane tilted = plane;
            tilted.tilt = part * limit;
            RelaxationScene scene = scene_of(tilted);
            scene.material[0].cohesion = cohesion * plane.weight() / plane.width;
            scene.material[0].residual_cohesion = remains * scene.material[0].cohesion;
            return scene;
        };
        expect_threshold([&](double part) { return scene_at(part, 1); }, "a/b " + std::to_string(slenderness));
        // The slip is less than the threshold.
        RelaxationScene shaken = scene_at(0.8, 1);
        shaken.shaking = {{0.1, {0, 0}}, {0.15, {3, 0}}, {0.2, {0, 0}}};
        EXPECT_EQ(relax(shaken, until_onset()).outcome, RelaxationOutcome::equilibrium) << slenderness;
        shaken.material[0].residual_cohesion = 0;
        EXPECT_EQ(relax(shaken, until_onset()).outcome, RelaxationOutcome::onset) << slenderness;
    }
}

TEST(PeakFriction, DropsToTheResidualWithTheFirstSlip) {
    const auto scene_at = [](double tilt, bool shaken) {
        RelaxationScene scene = scene_of(flat(35, degrees(tilt)));
        scene.material[0].residual_friction_angle = degrees(25);
        if (shaken) {
            scene.shaking = {{0.1, {0, 0}}, {0.15, {3, 0}}, {0.2, {0, 0}}};
        }
        return scene;
    };
    expect_threshold([&](double part) { return scene_at(35 * part, false); }, "peak");
    // Shaken once beyond the peak, it goes on where it stood before.
    EXPECT_EQ(relax(scene_at(30, false), until_onset()).outcome, RelaxationOutcome::equilibrium);
    EXPECT_EQ(relax(scene_at(30, true), until_onset()).outcome, RelaxationOutcome::onset);
    // Below the residual it comes to rest again, a few centimetres on.
    EXPECT_EQ(relax(scene_at(24, true), RelaxationSettings()).outcome, RelaxationOutcome::equilibrium);
    // Under the residual friction angle it slides.
    RelaxationSettings settings = unlimited(0.5);
    settings.local_damping = 0;
    const RelaxationResult slides = relax(scene_at(40, false), settings);
    const double acceleration = gravity * (std::sin(degrees(40)) - std::cos(degrees(40)) * std::tan(degrees(25)));
    // The first slip waits until the springs are stretched: some 1e-3 s.
    EXPECT_NEAR(slides.block[0].displacement, acceleration * slides.time * slides.time / 2,
                0.005 * slides.block[0].displacement);
}

// W sin + V = (W cos - U) tan(phi): uplift under the base, even or falling off to the toe, thrust on the upper face.
TEST(WaterPressure, LowersTheTiltAtWhichABlockSlides) {
    OnPlane plane = flat(35);
    plane.height_to_width = 0.2;
    struct Water {
        double at_toe;  // under the base, over W/b
        double at_heel;
        double at_crack_foot;  // on the upper face, over W/b, falling off to nothing at the top
    };
    for (const Water& water : {Water{0.3, 0.3, 0}, Water{0, 0.4, 0}, Water{0, 0.4, 1.0}, Water{0, 0, 1.0}}) {
        const double uplift = (water.at_toe + water.at_heel) / 2;
        const double thrust = water.at_crack_foot * plane.height_to_width / 2;
        const double limit = root([&](double tilt) {
            return std::sin(tilt) + thrust - (std::cos(tilt) - uplift) * std::tan(plane.friction);
        });
        expect_threshold(
            [&](double part) {
                OnPlane tilted = plane;
                tilted.tilt = part * limit;
                RelaxationScene scene = scene_of(tilted);
                const double unit = plane.weight() / plane.width;
                scene.pressure = {{0, 0, water.at_toe * unit, water.at_heel * unit},
                                  {0, 1, water.at_crack_foot * unit, 0}};
                return scene;
            },
            "uplift " + std::to_string(uplift) + ", thrust " + std::to_string(thrust));
    }
}

struct Resultant {
    PlanePoint<> force{0, 0};
    double moment = 0;  // about the drawing's origin
};

Resultant resultant_on(std::size_t block, const std::vector<FacePressure>& pressures, const Bodies& bodies) {
    Resultant sum;
    for (const FacePressure& pressure : pressures) {
        if (pressure.block == block) {
            const FaceForce force = force_of(pressure, bodies, Motion{});
            const PlanePoint<> at = bodies.centroid[block] + force.arm;
            sum.force += force.force;
            sum.moment += at.x() * force.force.y() - at.y() * force.force.x();
        }
    }
    return sum;
}

// The faces share all or a part of each; they are level, inclined, or straight with a corner on one of them.
TEST(JointWater, PressesBothBlocksAlikeAlongOneLine) {
    const Polygon<> column = rectangle(0, 0, 1, 3);
    const Polygon<> cornered{{1, 1}, {3, 1}, {3, 5}, {1, 5}, {1, 2.5}};
    for (const Polygon<>& neighbour : {rectangle(1, 0, 1, 3), rectangle(1, 1, 2, 4), cornered}) {
        for (const double turn : {0.0, 33.0}) {
            RelaxationScene scene;
            scene.block = {{column, density}, {neighbour, density}};
            for (RelaxationBlock& block : scene.block) {
                for (PlanePoint<>& vertex : block.outline) {
                    vertex = {std::cos(degrees(turn)) * vertex.x() - std::sin(degrees(turn)) * vertex.y(),
                              std::sin(degrees(turn)) * vertex.x() + std::cos(degrees(turn)) * vertex.y()};
                }
            }
            const Bodies bodies = make_bodies(scene);
            const double bottom = neighbour[0].y();
            for (const bool from_first : {true, false}) {
                // Anticlockwise the column's face runs up, its neighbour's down.
                const std::vector<FacePressure> pressures =
                    pressures_of(from_first ? JointWater{0, 1, 6e3, 1e3} : JointWater{1, 0, 1e3, 6e3}, bodies);
                EXPECT_EQ(pressures.size(), neighbour.size() == 5 ? 4U : 2U);
                const Resultant on_column = resultant_on(0, pressures, bodies);
                const Resultant on_neighbour = resultant_on(1, pressures, bodies);
                const double thrust = (6e3 + 1e3) / 2 * (3 - bottom);
                // Rounding of coordinates of a few metres.
                const double rounding = 1e-12 * thrust;
                EXPECT_NEAR((on_column.force + on_neighbour.force).norm(), 0, rounding);
                EXPECT_NEAR(on_column.moment + on_neighbour.moment, 0, 10 * rounding);
                EXPECT_NEAR(on_column.force.norm(), thrust, rounding);
                // A trapezium's centre of pressure above its foot, (p + 2 q) / (p + q) / 3 of the height.
                const double height = bottom + (3 - bottom) * (6e3 + 2 * 1e3) / (3 * (6e3 + 1e3));
                EXPECT_NEAR(on_column.moment, height * thrust, 10 * rounding);
            }
        }
    }
}

TEST(JointWater, IsNotBetweenBlocksThatShareNoFace) {
    RelaxationScene scene;
    scene.block = {
        {rectangle(0, 0, 1, 1), density}, {rectangle(1, 1, 1, 1), density}, {rectangle(3, 0, 1, 1), density}};
    const Bodies bodies = make_bodies(scene);
    EXPECT_TRUE(pressures_of({0, 1, 1, 1}, bodies).empty());  // a corner on a corner
    EXPECT_TRUE(pressures_of({0, 2, 1, 1}, bodies).empty());
}

// A wall without friction: p h / 2 = W tan(phi) where the pressure falls off from p at the foot to nothing.
TEST(JointWater, PushesABlockAwayFromAWall) {
    OnPlane plane = flat(30);
    plane.height_to_width = 0.2;
    const double limit = plane.weight() * std::tan(plane.friction) / (plane.height_to_width / 2);
    for (const bool wall_first : {false, true}) {
        expect_threshold(
            [&](double part) {
                RelaxationScene scene = scene_of(plane);
                scene.block.push_back(fixed_block(rectangle(1, 0, 1, 1)));
                scene.material.push_back(joint(plane.stiffness(), 0));
                scene.block[2].joint = {0, 1, 1, 1};
                const double foot = part * limit;
                const Bodies bodies = make_bodies(scene);
                scene.pressure =
                    pressures_of(wall_first ? JointWater{2, 0, 0, foot} : JointWater{0, 2, foot, 0}, bodies);
                return scene;
            },
            wall_first ? "wall" : "block");
    }
}

TEST(PointForce, AtTheThresholdOfSliding) {
    const OnPlane plane = flat(30);
    for (const double dip : {-20.0, 0.0, 20.0}) {
        // F cos = (W + F sin) tan(phi)
        const double tangent = std::tan(plane.friction);
        const double limit = plane.weight() * tangent / (std::cos(degrees(dip)) - std::sin(degrees(dip)) * tangent);
        for (const double sense : {-1.0, 1.0}) {
            expect_threshold(
                [&](double part) {
                    RelaxationScene scene = scene_of(plane);
                    scene.force = {
                        {0,
                         {0.5, 0.0},
                         {sense * part * limit * std::cos(degrees(dip)), -part * limit * std::sin(degrees(dip))}}};
                    return scene;
                },
                "dip " + std::to_string(dip));
        }
    }
}

TEST(Shaking, ByAConstantAccelerationSlidesBeyondFriction) {
    const OnPlane plane = flat(25);
    for (const double sense : {-1.0, 1.0}) {
        const auto scene_at = [&](double part) {
            RelaxationScene scene = scene_of(plane);
            scene.shaking = {{0, {sense * part * gravity * std::tan(plane.friction), 0}}};
            return scene;
        };
        expect_threshold(scene_at, "shaking");
        // The ground leaves the block behind.
        EXPECT_LT(sense * relax(scene_at(1.5), until_onset()).block[0].base_slip, 0);
    }
}

// The resultant of gravity and inertia leans by atan(a / (g + v)) out of the slope, against friction less the tilt.
double sliding_acceleration(double friction, double tilt, double vertical) {
    return (gravity + vertical) * std::tan(friction - tilt);
}

TEST(Shaking, IsHorizontalAndVerticalForGravityHoweverTheDrawingIsTilted) {
    for (const double tilt : {0.0, 10.0, 20.0}) {
        for (const double vertical : {0.0, 0.4 * gravity, -0.4 * gravity}) {
            const OnPlane plane = flat(30, degrees(tilt));
            const double limit = sliding_acceleration(plane.friction, plane.tilt, vertical);
            const auto scene_at = [&](double part) {
                RelaxationScene scene = scene_of(plane);
                scene.shaking = {{0, {part * limit, vertical}}};
                return scene;
            };
            expect_threshold(scene_at, "tilt " + std::to_string(tilt) + ", vertical " + std::to_string(vertical));
        }
    }
    EXPECT_NEAR(sliding_acceleration(degrees(30), degrees(20), 0), 1.729, 5e-4);  // by hand, printed digits
}

// The block turns about the toe, on the side that inertia points to, if the resultant leans by the diagonal, b / a.
TEST(Shaking, TurnsASlenderBlockOver) {
    for (const double tilt : {0.0, 8.0}) {
        for (const double vertical : {0.0, 0.3 * gravity}) {
            OnPlane plane;
            plane.height_to_width = 4;
            plane.friction = degrees(50);
            plane.tilt = degrees(tilt);
            const double limit = sliding_acceleration(std::atan(1 / plane.height_to_width), plane.tilt, vertical);
            const auto scene_at = [&](double part) {
                RelaxationScene scene = scene_of(plane);
                scene.shaking = {{0, {part * limit, vertical}}};
                return scene;
            };
            expect_threshold(scene_at, "tilt " + std::to_string(tilt) + ", vertical " + std::to_string(vertical));
        }
    }
}

// Ground that falls away faster than gravity leaves the block behind.
TEST(Shaking, DownwardByMoreThanGravityLiftsABlock) {
    for (const double tilt : {0.0, 20.0}) {
        RelaxationScene scene = scene_of(flat(30, degrees(tilt)));
        scene.shaking = {{0, {0, -1.5 * gravity}}};
        RelaxationSettings settings = unlimited(0.2);
        settings.local_damping = 0;
        const RelaxationResult result = relax(scene, settings);
        // The springs' work, 1e-6 of the width each, is far below a thousandth of the displacement.
        const double way = 0.5 * gravity * result.time * result.time / 2;
        EXPECT_NEAR(result.block[0].displacement, way, 1e-3 * way) << tilt;
        EXPECT_LT(energy_error(result, 0), 0.02) << tilt;
    }
}

// The axes of shaking turn with gravity.
TEST(Shaking, TurnsWithGravity) {
    RelaxationScene scene = scene_of({});
    scene.gravity.final_tilt = degrees(30);
    scene.gravity.rate = degrees(10);
    scene.shaking = {{1, {2, 1}}, {3, {2, 1}}};
    for (const double time : {1.0, 2.5, 3.0}) {
        const PlanePoint<> down = gravity_at(scene.gravity, time) / gravity;
        const PlanePoint<> shaking = shaking_at(scene, time);
        // Sines and cosines are rounded.
        EXPECT_NEAR(shaking.dot(down), -1, 1e-14) << time;
        EXPECT_NEAR(shaking.x() * -down.y() + shaking.y() * down.x(), 2, 1e-14) << time;
    }
}

TEST(Shaking, OfARecordEndsWithIt) {
    RelaxationScene scene = scene_of({});
    const auto at = [&](double time) { return shaking_at(scene, time).x(); };
    scene.shaking = {{1, {2, 0}}, {3, {4, 0}}};
    EXPECT_EQ(at(0.999), 0);
    EXPECT_EQ(at(1), 2);
    EXPECT_EQ(at(2), 3);
    EXPECT_EQ(at(3), 4);
    EXPECT_EQ(at(3.001), 0);
    scene.shaking = {{1, {2, 0}}};
    EXPECT_EQ(at(0.999), 0);
    EXPECT_EQ(at(1e6), 2);
    scene.shaking = {};
    EXPECT_EQ(at(0), 0);
    // A fixed block keeps its velocity.
    const PrescribedMotion motion{1, {{1, {2, 0}}, {3, {4, 0}}}};
    Motion moved;
    prescribe(motion, make_bodies(scene), 1e6, moved);
    EXPECT_EQ(moved.vx, 4);
}

// Beyond friction while it lasts, which is as long as a block of a metre takes to slide a few millimetres.
TEST(Shaking, ABlockComesToRestAfterIt) {
    const OnPlane plane = flat(30, degrees(10));
    const double limit = sliding_acceleration(plane.friction, plane.tilt, 0);
    RelaxationScene scene = scene_of(plane);
    scene.shaking = {{0.1, {1.5 * limit, 0}}, {0.15, {1.5 * limit, 0}}};
    const RelaxationResult result = relax(scene, RelaxationSettings());
    EXPECT_EQ(result.outcome, RelaxationOutcome::equilibrium);
    EXPECT_LT(result.block[0].base_slip, -1e-4);
    EXPECT_LT(energy_error(result, 1e-6 * density * gravity), 0.02);
    scene.shaking.pop_back();
    EXPECT_EQ(relax(scene, RelaxationSettings()).outcome, RelaxationOutcome::collapse);
}

// The belt takes the place of gravity and dips as it would: the belt's drag is the weight, at most.
TEST(Shaking, OnABeltIsAlongItsDirection) {
    RelaxationScene upright = scene_of(flat(30));
    upright.belt = Belt{0.1, degrees(30)};
    RelaxationScene tilted = upright;
    tilted.gravity.tilt = tilted.gravity.final_tilt = degrees(20);
    tilted.shaking = upright.shaking = {{0, {2, 1}}};
    const auto load_of = [](const RelaxationScene& scene) {
        const Bodies bodies = make_bodies(scene);
        std::vector<BlockForce> load(bodies.size());
        sum_loads(scene, scene.pressure, RelaxationSettings(), bodies, 0, bodies.fixed,
                  std::vector<Motion>(bodies.size()), load);
        return PlanePoint<>(load[0].x, load[0].y);
    };
    const PlanePoint<> load = load_of(upright);
    const PlanePoint<> turned = load_of(tilted);
    const double cosine = std::cos(degrees(20));
    const double sine = std::sin(degrees(20));
    // Drag and inertia turn together, but for rounding and the quadrature of the drag over the block's area.
    EXPECT_NEAR(turned.x(), cosine * load.x() + sine * load.y(), 1e-6 * load.norm());
    EXPECT_NEAR(turned.y(), cosine * load.y() - sine * load.x(), 1e-6 * load.norm());
}

}  // namespace
}  // namespace delabole
