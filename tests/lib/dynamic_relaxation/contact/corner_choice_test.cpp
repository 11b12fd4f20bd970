// Where corners meet corners, nothing is held that cannot be, and nothing falls that is held.
#include "dynamic_relaxation/contact/corner_choice.hpp"

#include "dynamic_relaxation/contact/contact_law.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "dynamic_relaxation/study/strength_bound.hpp"
#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"
#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

using namespace relaxation_scenes;

PlanePoint<> at(double angle, double distance) {
    return distance * PlanePoint<>(std::cos(degrees(angle)), std::sin(degrees(angle)));
}

// A face of 60 deg, 12 m high, and a plane that comes out at its toe.
RelaxationStudy toe(const SlopeCut& plane, double friction, std::vector<SectionPoint> in_front) {
    RelaxationSlope slope{};
    std::vector<SectionPoint> outline{{-15, -8}, {35, -8}, {35, 12}, {12 / std::tan(degrees(60)), 12}, {0, 0}};
    outline.insert(outline.end(), in_front.begin(), in_front.end());
    slope.geometry = testing::section(std::move(outline), {plane});
    slope.geometry.intact_joint = "intact";
    slope.rock = {{"rock", 2600}};
    RelaxationJoint open{};
    open.friction_angle = friction;
    RelaxationJoint intact{};
    intact.friction_angle = degrees(45);
    intact.bond = BondMaterial{20e9, 8e9, 5e6, 5e6, degrees(45), {}};
    slope.joint = {{"joint", {}, open}, {"intact", {}, intact}};
    slope.frame = SlopeFrame{FrameSides::all_around, 5, {}, "joint"};
    RelaxationStudy study{};
    study.model.scene = slope;
    RelaxationNumerics settings{};
    settings.stop = RelaxationStop::onset;
    study.settings = settings;
    return study;
}

SlopeCut plane_from(double dip, double begin) {
    const PlanePoint<> from = at(dip, begin);
    const PlanePoint<> to = at(dip, 60);
    return testing::cut("plane", testing::line({{from.x(), from.y()}, {to.x(), to.y()}}));
}

SlopeCut plane_through(double dip, SectionPoint point) {
    JointSetCut set = testing::joint_set(degrees(dip), 100);
    set.through = point;
    return testing::cut("plane", set);
}

// tan(friction) at which the wedge above the plane moves: with its tip over the level ground and the upper end of its
// base down the plane, for the toe cannot go down into the ground in front. Equilibrium of forces and, about the toe,
// moments of a rigid block.
double limit(double dip) {
    const double base = 12 / std::sin(degrees(dip));
    const double centroid = 12 * (1 / std::tan(degrees(dip)) + 1 / std::tan(degrees(60))) / 3;
    const double above = centroid / base;  // normal force on the plane, of the weight
    double low = 0;
    double high = 2;
    for (int halving = 0; halving < 60; ++halving) {
        const double friction = (low + high) / 2;
        const double toe = 1 - above * (std::cos(degrees(dip)) + friction * std::sin(degrees(dip)));
        const double driving = above * (std::sin(degrees(dip)) - friction * std::cos(degrees(dip)));
        (driving > friction * toe ? low : high) = friction;
    }
    return std::atan(low);
}

RelaxationStudy with_corners_that_bear(RelaxationStudy study) {
    study.settings->corners_bear = OffOn::on;
    return study;
}

// The corners bear loads here, as those of steel do.
TEST(Toe, SlidesAndStandsTheSameHoweverItsPlaneIsDrawn) {
    for (const double dip : {20.0, 35.0, 50.0}) {
        const std::vector<std::pair<std::string, SlopeCut>> drawings{
            {"from the toe", plane_from(dip, 0)},
            {"on below the ground", plane_from(dip, -8)},
            {"through the section", plane_from(dip, -40)},
            {"a set", plane_through(dip, {0, 0})},
            {"a set by another point", plane_through(dip, {2, 2 * std::tan(degrees(dip))})}};
        for (const auto& [name, plane] : drawings) {
            // deg; what joints of finite stiffness cost is 0.03.
            for (const double beyond : {-3.0, -0.1, 0.1, 3.0}) {
                const RelaxationStudy study = toe(plane, limit(dip) + degrees(beyond), {{-15, 0}});
                EXPECT_EQ(run(with_corners_that_bear(study)).result.outcome,
                          beyond > 0 ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset)
                    << name << ", " << dip << ", " << beyond;
            }
        }
    }
}

TEST(Toe, SlidesHoweverItIsLoaded) {
    for (const RelaxationStart start :
         {RelaxationStart::preloaded, RelaxationStart::dropped, RelaxationStart::ramped}) {
        for (const double begin : {0.0, -40.0}) {
            RelaxationStudy study = toe(plane_from(35, begin), degrees(10), {{-15, 0}});
            study.settings->start = start;
            if (start == RelaxationStart::ramped) {
                study.settings->ramp_time = 0.2;
            }
            EXPECT_EQ(run(study).result.outcome, RelaxationOutcome::onset) << begin << ", " << word_of(start);
        }
    }
}

// Where the plane daylights in the face, above the toe, nothing obstructs it.
TEST(Toe, AboveTheGroundHoldsByFrictionAlone) {
    for (const double beyond : {-0.1, 0.1}) {
        EXPECT_EQ(run(toe(plane_through(35, {0, 0.2}), degrees(35 + beyond), {{-15, 0}})).result.outcome,
                  beyond > 0 ? RelaxationOutcome::equilibrium : RelaxationOutcome::onset);
    }
}

// Two planes come out at the toe. The wedge above the upper one slides on it; the thin wedge between the planes does
// not catch its tip.
TEST(Toe, ThinWedgeBetweenTwoPlanesHoldsNothing) {
    const double upper = 41;
    for (const double lower : {30.0, 36.0, 39.0}) {
        for (const double friction : {34.0, 40.9, 41.1}) {
            RelaxationStudy study = toe(plane_through(upper, {0, 0}), degrees(friction), {{-15, 0}});
            SlopeCut second = plane_through(lower, {0, 0});
            second.name = "lower plane";
            std::get<RelaxationSlope>(study.model.scene).geometry.cut.push_back(second);
            const std::optional<double> bound = greatest_strength_reduction(relaxation_scene(study));
            ASSERT_TRUE(bound);
            EXPECT_NEAR(*bound, std::tan(degrees(friction)) / std::tan(degrees(upper)), 1e-6) << lower;
            EXPECT_EQ(run(study).result.outcome == RelaxationOutcome::equilibrium, friction > upper)
                << lower << ", " << friction;
        }
    }
}

// Statics of faces alone sees a block on a plane; it tells what stands on its corner from what stands by itself.
TEST(Toe, StandsOnItsCornerAloneBelowTheFrictionOfItsPlane) {
    const double plane = std::tan(degrees(35));
    for (const double friction : {20.0, 34.0, 36.0}) {
        for (const SlopeCut& cut : {plane_from(35, 0), plane_from(35, -8), plane_through(35, {0, 0.2})}) {
            const RelaxationScene scene = relaxation_scene(toe(cut, degrees(friction), {{-15, 0}}));
            const std::optional<double> bound = greatest_strength_reduction(scene);
            ASSERT_TRUE(bound);
            // Below the plane the rock is bonded and in place: nothing else can fail.
            EXPECT_NEAR(*bound, std::tan(degrees(friction)) / plane, 1e-6) << friction;
        }
    }
}

// Rock bears loads on faces only: below the friction of the plane just its tip would hold the wedge.
TEST(Toe, DoesNotStandOnItsCorner) {
    const double dip = 35;
    for (const SlopeCut& plane : {plane_from(dip, 0), plane_from(dip, -8), plane_from(dip, -40),
                                  plane_through(dip, {0, 0}), plane_through(dip, {2, 2 * std::tan(degrees(dip))})}) {
        const std::vector<std::pair<double, RelaxationOutcome>> outcomes{{10, RelaxationOutcome::onset},
                                                                         {20, RelaxationOutcome::held_by_corners},
                                                                         {34.9, RelaxationOutcome::held_by_corners},
                                                                         {35.1, RelaxationOutcome::equilibrium}};
        for (const auto& [friction, outcome] : outcomes) {
            const RelaxationResult result = run(toe(plane, degrees(friction), {{-15, 0}})).result;
            EXPECT_EQ(result.outcome, outcome) << friction;
            const auto held = std::ranges::count(result.block, BlockMovement::held_by_corners, &BlockOutcome::movement);
            EXPECT_EQ(held > 0, outcome == RelaxationOutcome::held_by_corners) << friction;
        }
    }
}

TEST(Toe, HasTheFactorOfSafetyOfItsPlane) {
    for (const double friction : {20.0, 50.0}) {
        RelaxationStudy study = toe(plane_through(35, {0, 0}), degrees(friction), {{-15, 0}});
        study.critical = ReductionSearch{};
        const CriticalAnswer found = find_critical(study);
        ASSERT_EQ(found.status, CriticalStatus::found) << friction;
        EXPECT_TRUE(found.held_by_corners) << friction;
        // Within the bracket.
        EXPECT_NEAR(found.value(), std::tan(degrees(friction)) / std::tan(degrees(35)), 0.005) << friction;
        ASSERT_TRUE(found.failed) << friction;
        EXPECT_EQ(found.failed->result.outcome, RelaxationOutcome::held_by_corners) << friction;
    }
}

// Energy that came from nowhere may have moved blocks to where they stand, but a search needs no energy balance to see
// that corners alone hold them.
TEST(Toe, FailsInASearchEvenIfEnergyIsNotBalanced) {
    const auto outcome_with = [](double friction, bool creep) {
        const RelaxationStudy study = toe(plane_from(35, 0), degrees(friction), {{-15, 0}});
        const RelaxationScene scene = relaxation_scene(study);
        RelaxationSettings settings = relaxation_settings(study);
        settings.stop_at_equilibrium = true;
        settings.creep = creep;
        RelaxationState state = Simulation(scene, settings).state();
        state.energy_balance.applied += 1e9;  // J/m; the wedge weighs 1.6 MN/m
        Simulation run(scene, settings, std::move(state));
        while (run.running()) {
            run.step();
        }
        return run.outcome();
    };
    EXPECT_EQ(outcome_with(20, true), RelaxationOutcome::held_by_corners);
    EXPECT_EQ(outcome_with(20, false), RelaxationOutcome::energy_not_balanced);
    EXPECT_EQ(outcome_with(36, true), RelaxationOutcome::energy_not_balanced);
}

// Friction 20 deg and as much tensile strength as cohesion: limit equilibrium is c L / (W sin) + tan(friction) /
// tan(dip), tension or not.
TEST(Toe, TensileStrengthOfItsPlaneAddsNoFriction) {
    const double dip = 35;
    const double area = 12 * 12 * (1 / std::tan(degrees(dip)) - 1 / std::tan(degrees(60))) / 2;
    const double by_friction = std::tan(degrees(20)) / std::tan(degrees(dip));
    for (const double factor : {0.95, 1.05}) {
        RelaxationStudy study = toe(plane_from(dip, 0), degrees(20), {{-15, 0}});
        RelaxationJoint& joint = std::get<RelaxationSlope>(study.model.scene).joint[0].strength;
        joint.cohesion = (factor - by_friction) * area * 2600 * gravity * std::pow(std::sin(degrees(dip)), 2) / 12;
        joint.tensile_strength = *joint.cohesion;
        const RelaxationOutcome outcome = run(study).result.outcome;
        EXPECT_EQ(outcome == RelaxationOutcome::equilibrium, factor > 1) << word_of(outcome);
    }
}

// Dropped blocks open the plane for a moment: its cohesion is lost, and friction alone does not hold.
TEST(Toe, IsJudgedByTheStrengthThatItsPlaneHasLeft) {
    RelaxationStudy study = toe(plane_from(35, 0), degrees(20), {{-15, 0}});
    RelaxationJoint& joint = std::get<RelaxationSlope>(study.model.scene).joint[0].strength;
    joint.cohesion = 40e3;
    EXPECT_EQ(run(study).result.outcome, RelaxationOutcome::equilibrium);
    study.settings->start = RelaxationStart::dropped;
    EXPECT_NE(run(study).result.outcome, RelaxationOutcome::equilibrium);
}

// In the corner between its plane and a wall there is no way out for the tip.
TEST(Toe, AgainstAWallIsHeldByItsCorner) {
    for (const double begin : {0.0, -8.0}) {
        const RelaxationStudy study = toe(plane_from(35, begin), degrees(10), {{0, 6}, {-15, 6}});
        EXPECT_EQ(run(study).result.outcome, RelaxationOutcome::held_by_corners) << begin;
        EXPECT_EQ(run(with_corners_that_bear(study)).result.outcome, RelaxationOutcome::equilibrium) << begin;
    }
}

RelaxationScene on_floor(std::vector<Polygon<>> outlines, double friction, double tilt = 0) {
    RelaxationScene scene;
    for (Polygon<>& outline : outlines) {
        scene.block.push_back({std::move(outline), density});
    }
    scene.block.push_back(fixed_block(rectangle(-20, -2, 40, 2)));
    scene.material = {joint(1e6 * density * gravity, degrees(friction))};
    scene.gravity.tilt = scene.gravity.final_tilt = degrees(tilt);
    return scene;
}

Polygon<> diamond(double x, double y) {
    const double half = std::sqrt(0.5);
    return {{x, y}, {x + half, y + half}, {x, y + 2 * half}, {x - half, y + half}};
}

TEST(CornerOnCorner, HoldsNothingThatEitherEdgeLetsGo) {
    // A brick stands on the very corner of another; a block slides off knife edges to either side.
    EXPECT_EQ(relax(on_floor({rectangle(0, 0, 1, 1), rectangle(1, 1, 1, 1)}, 30), until_onset()).outcome,
              RelaxationOutcome::onset);
    RelaxationScene knives = on_floor({diamond(0, 0), diamond(0, 2 * std::sqrt(0.5))}, 30);
    knives.block[0].fixed = true;
    EXPECT_EQ(relax(knives, until_onset()).outcome, RelaxationOutcome::onset);
}

// Wherever the tip of a wedge at the corner of the ground has come, and however it has turned, the ground's corner is
// below the wedge's face by as much as the contact of the tip takes it to be.
TEST(CornerOnCorner, KnowsHowDeepTheOtherEdgeIs) {
    RelaxationScene scene = on_floor({{{0, 0}, at(35, 20), at(58, 20)}}, 30);
    scene.block[1].outline = {{0, 0}, {-20, 0}, at(215, 17)};
    const Bodies bodies = make_bodies(scene);
    const PlanePoint<> tip = bodies.corner[bodies.range[0].begin];
    std::size_t compared = 0;
    for (const double turn : {-0.04, -0.02, -0.011, 0.0, 0.004, 0.03}) {
        std::vector<Motion> motion(2);
        motion[0].set_angle(turn);
        const PlanePoint<> to = PlanePoint<>(-0.02, -0.001) - motion[0].turned_by(tip);
        motion[0].x = to.x();
        motion[0].y = to.y();
        const ContactList list = find_contacts(scene, bodies, motion, {0, 0}, {0.1, 0.2, true}, {});
        for (std::size_t index = 0; index < list.contact.size(); ++index) {
            const RelaxationContact contact = list.contact[index];
            const ContactLaw law = list.law_of(contact);
            if (law.alone < 2 || contact.block != 0) {
                continue;
            }
            const std::size_t end = law.rival > 0 ? contact.edge : bodies.range[1].after(contact.edge);
            const PlanePoint<> place = bodies.centroid[1] + bodies.corner[end] - bodies.centroid[0] - to;
            const std::size_t face = law.rival > 0 ? bodies.range[0].before(contact.corner) : contact.corner;
            const PlanePoint<> start = motion[0].turned(bodies.corner[face]);
            const double depth = -motion[0].turned(bodies.normal(face)).dot(place - start);
            const ContactPosition now = locate(contact, motion[0], motion[1]);
            EXPECT_NEAR(place_at_rival<double>(law, contact.to_end, now).overlap, depth, 1e-12) << turn;  // rounding
            ++compared;
        }
    }
    EXPECT_EQ(compared, 6U);
}

// A triangle stands with its tip on the floor and leans against a wall, which it touches between 1 and 3 m. It is held
// if the wall bears at the top and tan(phi) is t or more, where the moment about the tip and the forces give, for a
// unit weight with its centre 2/3 m from the tip:
//     N (3 + t) = 2/3,  N = t (1 - t N)   =>   t^2 / 3 + 3 t = 2/3
TEST(Tip, OnAFloorBearsInStaticsToo) {
    RelaxationScene scene = on_floor({{{0, 0}, {1, 1}, {1, 3}}}, 30);
    scene.block.push_back(fixed_block(rectangle(1, 0, 2, 3)));
    const double least = (std::sqrt(9 + 8.0 / 9) - 3) * 1.5;
    const std::optional<double> bound = greatest_strength_reduction(scene);
    ASSERT_TRUE(bound);
    EXPECT_NEAR(*bound, std::tan(degrees(30)) / least, 1e-5);  // the tip is a face of 2e-6 shortest edges
    EXPECT_EQ(relax(scene, until_onset()).outcome, RelaxationOutcome::equilibrium);
}

// The toe of problem RJ-15, where three edges meet and a block squeezed between two of them relies on both.
RelaxationScene squeezed_at_the_toe() {
    const PlanePoint<> into(-7.984e-5, -3.174e-5);
    Polygon<> block{{4.349753, 1.039062}, {3.064174, 2.57115}, {0, 0}, {3.939231, 0.694593}};
    for (PlanePoint<>& vertex : block) {
        vertex += into;
    }
    RelaxationScene scene;
    scene.block = {fixed_block({{-4.349753, -1.039062}, {-3.064178, -2.57115}, {0, 0}, {-3.111448, 0}}),
                   {std::move(block), density}};
    scene.material = {joint(1e6 * density * gravity, degrees(30))};
    return scene;
}

RelaxationScene mirrored(RelaxationScene scene) {
    for (RelaxationBlock& block : scene.block) {
        for (PlanePoint<>& vertex : block.outline) {
            vertex.x() = -vertex.x();
        }
        std::ranges::reverse(block.outline);
    }
    return scene;
}

// Returns the normals of the edges that yield in a trial, in order, with x times the sense.
std::vector<std::pair<double, double>> edges_that_yield(const RelaxationScene& scene, double sense) {
    const Bodies bodies = make_bodies(scene);
    const std::vector<Motion> motion(2);
    ContactList list = find_contacts(scene, bodies, motion, {0, 0}, {0.1, 0.2, true}, {});
    try_other_edges({bodies, motion}, {std::numeric_limits<double>::infinity(), 1}, list);
    std::vector<std::pair<double, double>> normals;
    for (std::size_t index = 0; index < list.contact.size(); ++index) {
        if (list.memory[index].yields) {
            const PlanePoint<> normal = bodies.normal(list.contact[index].edge);
            normals.emplace_back(sense * normal.x(), normal.y());
        }
    }
    std::ranges::sort(normals);
    return normals;
}

TEST(CornerOnCorner, IsTriedTheSameMirrored) {
    const RelaxationScene scene = squeezed_at_the_toe();
    const std::vector<std::pair<double, double>> drawn = edges_that_yield(scene, 1);
    const std::vector<std::pair<double, double>> mirror = edges_that_yield(mirrored(scene), -1);
    ASSERT_FALSE(drawn.empty());
    ASSERT_EQ(drawn.size(), mirror.size());
    for (std::size_t index = 0; index < drawn.size(); ++index) {
        EXPECT_NEAR(drawn[index].first, mirror[index].first, 1e-9);  // other edges lie degrees apart
        EXPECT_NEAR(drawn[index].second, mirror[index].second, 1e-9);
    }
}

// Two layers of two bricks have joints that cross in one point; then a third joint passes through it.
TEST(CornerOnCorner, CrossingJointsHoldByTheirFriction) {
    const std::vector<Polygon<>> two{rectangle(0, 0, 2, 1), rectangle(2, 0, 2, 1), rectangle(0, 1, 2, 1),
                                     rectangle(2, 1, 2, 1)};
    const std::vector<Polygon<>> three{rectangle(0, 0, 2, 1),
                                       {{2, 0}, {3, 0}, {2, 1}},
                                       {{3, 0}, {4, 0}, {4, 1}, {2, 1}},
                                       {{0, 1}, {2, 1}, {1, 2}, {0, 2}},
                                       {{2, 1}, {2, 2}, {1, 2}},
                                       rectangle(2, 1, 2, 1)};
    for (const double tilt : {20.0, -20.0}) {
        EXPECT_EQ(relax(on_floor(two, 19.9, tilt), until_onset()).outcome, RelaxationOutcome::onset);
        EXPECT_EQ(relax(on_floor(two, 20.1, tilt), until_onset()).outcome, RelaxationOutcome::equilibrium);
    }
    // The third joint dips 25 deg against the slope.
    EXPECT_EQ(relax(on_floor(three, 19.9, 20), until_onset()).outcome, RelaxationOutcome::onset);
    EXPECT_EQ(relax(on_floor(three, 26, 20), until_onset()).outcome, RelaxationOutcome::equilibrium);
}

TEST(CornerOnCorner, BlockSlidesOffAnEndAndFalls) {
    RelaxationScene scene = on_floor({rectangle(-1.2, 0, 1, 1)}, 5, -20);
    scene.block[1].outline = rectangle(-4, -1, 4, 1);
    scene.block.push_back(fixed_block(rectangle(-4, -9, 30, 1)));
    Simulation simulation(scene, unlimited(1.7));
    while (simulation.running()) {
        simulation.step();
    }
    EXPECT_EQ(simulation.outcome(), RelaxationOutcome::undecided);
    EXPECT_LT(simulation.state().motion[0].y, -1);
    EXPECT_LT(energy_error(simulation.result(), density * gravity), 0.01);
}

TEST(CornerOnCorner, ShearReversesOverCrossingJoints) {
    RelaxationScene scene =
        on_floor({rectangle(0, 0, 2, 1), rectangle(2, 0, 2, 1), rectangle(0, 1, 2, 1), rectangle(2, 1, 2, 1)}, 25);
    PrescribedMotion shaken{4, {}};
    for (int time = 0; time <= 10; ++time) {
        // 0.6 g: bricks slide, and corners pass each other by some centimetres, to and fro.
        shaken.velocity.push_back({0.05 + 0.1 * time, {time % 2 == 0 ? 0.3 : -0.3, 0}});
    }
    shaken.velocity.push_back({1.2, {0, 0}});
    scene.motion = {shaken};
    RelaxationSettings settings = unlimited(3);
    settings.stop_at_equilibrium = true;
    Simulation simulation(scene, settings);
    while (simulation.running()) {
        simulation.step();
    }
    const RelaxationResult result = simulation.result();
    EXPECT_EQ(result.outcome, RelaxationOutcome::equilibrium);
    EXPECT_LT(energy_error(result, density * gravity), 0.01);
    for (std::size_t block = 0; block < 4; ++block) {
        EXPECT_NEAR(simulation.state().motion[block].y, 0, 1e-3) << block;
    }
}

}  // namespace
}  // namespace delabole
