// Factors of safety of slopes whose weakest joint, or whose motion, is easily missed.
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "dynamic_relaxation/study/failed_at_rest.hpp"
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "dynamic_relaxation/study/strength_bound.hpp"
#include "dynamic_relaxation/study/strength_reduction.hpp"

#include "tests/lib/dynamic_relaxation/relaxation_scenes.hpp"
#include "tests/support/jointed_slopes.hpp"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace delabole {
namespace {

constexpr double within_bracket = 0.0025;  // half of the standard tolerance

// A slope of 10 m with a face of 68 deg on which rock slides along the joints of the cuts. Joint "weak" has 20 deg of
// friction, "strong" 45 deg.
RelaxationStudy two_joints(std::vector<SlopeCut> cuts, double sliver_share = SlopeGeometry::standard_sliver_share) {
    RelaxationSlope slope{};
    slope.rock = {{"rock", 2600}};
    slope.joint = {{"strong", {}, {}}, {"weak", {}, {}}};
    slope.joint[0].strength.friction_angle = degrees(45);
    slope.joint[1].strength.friction_angle = degrees(20);
    slope.frame = SlopeFrame{FrameSides::below_and_behind, 2, {}, "strong"};
    slope.geometry = testing::section({{0, 0}, {20, 0}, {20, 10}, {4, 10}}, std::move(cuts));
    slope.geometry.intact_joint = "strong";
    slope.geometry.sliver_share = sliver_share;
    RelaxationStudy study{};
    study.model.scene = slope;
    study.critical = ReductionSearch{};
    return study;
}

SlopeCut plane(const std::string& joint, double dip, double height) {
    const double rise = 30 * std::tan(degrees(dip));
    return {joint, joint, testing::line({{-30, height - rise}, {30, height + rise}})};
}

// The walls of a seam of 0.5 mm, of 40 deg of friction, are nearer to each other than a closed joint may be drawn open.
TEST(WeakestJoint, TheWallsOfAThinSeamDoNotTouch) {
    using namespace relaxation_scenes;
    for (const auto& [pieces, layers] : {std::pair(1, 1), std::pair(3, 1), std::pair(1, 2), std::pair(2, 4)}) {
        constexpr double seam = 0.0005;
        RelaxationScene scene;
        scene.block = {{rectangle(0, seam, 1, 0.5), density}, fixed_block(rectangle(-3, -1, 7, 1))};
        for (int piece = 0; piece < pieces * layers; ++piece) {
            const double left = 1.0 * (piece % pieces) / pieces;
            const double bottom = seam * (piece / pieces) / layers;  // NOLINT(bugprone-integer-division): the layer
            scene.block.push_back({rectangle(left, bottom, 1.0 / pieces, seam / layers), density});
            scene.block.back().joint = {1, 1, 1, 1};
        }
        scene.material = {joint(1e6 * density * gravity, degrees(40)), joint(1e6 * density * gravity, degrees(10))};
        const auto at = [&](double tilt) {
            scene.gravity.tilt = scene.gravity.final_tilt = degrees(tilt);
            return scene;
        };
        const double expected = std::tan(degrees(10)) / std::tan(degrees(15));
        EXPECT_NEAR(*greatest_strength_reduction(at(15)), expected, 1e-4)
            << "accuracy of the bound, and the lost edges";
        // Drawn inclined, with rounded coordinates.
        RelaxationScene inclined = at(0);
        for (RelaxationBlock& block : inclined.block) {
            for (PlanePoint<>& vertex : block.outline) {
                constexpr double digits = 1e7;
                vertex = (digits * (Eigen::Rotation2Dd(degrees(15)) * vertex)).array().round() / digits;
            }
        }
        EXPECT_NEAR(*greatest_strength_reduction(inclined), expected, 1e-3) << pieces << ' ' << layers;
        for (const double tilt : {9.9, 10.1}) {
            Simulation run(at(tilt), until_onset());
            while (run.running()) {
                run.step();
            }
            const bool failed = run.outcome() == RelaxationOutcome::onset || failed_at_rest(run, InitialContact::drawn);
            EXPECT_EQ(failed, tilt > 10) << pieces;
        }
    }
}

// A fault with gouge that daylights in the face and ends in rock beyond a crack from the crest: all between face, fault
// and crack slides, as along a joint without thickness.
TEST(WeakestJoint, AFaultThatEndsBeyondACrackIsNotLost) {
    const double expected = std::tan(degrees(20)) / std::tan(degrees(30));
    const auto fault = [](std::optional<double> thickness, double end) {
        const auto at = [](double x) { return SectionPoint{x, 1 + (x - 0.4) * std::tan(degrees(30))}; };
        SlopeCut cut{"fault", "weak", testing::line({at(-1), at(end)})};
        std::get<LineCut>(cut.trace).thickness = thickness;
        std::get<LineCut>(cut.trace).gouge = thickness ? std::optional<std::string>("rock") : std::nullopt;
        return cut;
    };
    const SlopeCut crack{"crack", "strong", testing::line({{10, 11}, {10, 4.5}})};
    for (const std::optional<double> thickness : {std::optional<double>(), std::optional(0.1)}) {
        for (const double end : {10.0, 12.0}) {  // on the crack, and beyond it
            for (const bool crack_first : {false, true}) {
                std::vector<SlopeCut> cuts{fault(thickness, end), crack};
                if (crack_first) {
                    std::swap(cuts[0], cuts[1]);
                }
                const CriticalAnswer found = find_critical(two_joints(std::move(cuts), 0.001));
                EXPECT_EQ(found.status, CriticalStatus::found) << thickness.value_or(0) << ' ' << end;
                EXPECT_NEAR(found.value(), expected, within_bracket) << thickness.value_or(0) << ' ' << end;
            }
        }
    }
}

// All above the weak plane slides on it, whatever is cut beside it, and in whatever order.
TEST(WeakestJoint, AWeakPlaneIsNotLostBesideAStrongOne) {
    const double expected = std::tan(degrees(20)) / std::tan(degrees(35));
    const auto factor = [](std::vector<SlopeCut> cuts) { return find_critical(two_joints(std::move(cuts))).value(); };
    for (const double apart : {0.1, 0.04, 0.005, 0.0}) {
        // Slivers and corners within the snap distance leave one of the two planes.
        const SlopeCut weak = plane("weak", 35, 1);
        const SlopeCut strong = plane("strong", 35, 1 + apart);
        EXPECT_NEAR(factor({weak, strong}), expected, within_bracket) << apart;
        EXPECT_NEAR(factor({strong, weak}), expected, within_bracket) << apart;
    }
    const auto beds = [](const std::string& joint) {
        JointSetCut set = testing::joint_set(degrees(35), 2);
        set.through = SectionPoint{0, 1};
        return SlopeCut{"beds", joint, set};
    };
    EXPECT_NEAR(factor({beds("strong"), plane("weak", 35, 1)}), expected, within_bracket);
    EXPECT_NEAR(factor({plane("strong", 35, 1), beds("weak")}), expected, within_bracket);
    // It follows a bed and then steepens.
    const double tangent = std::tan(degrees(35));
    const SlopeCut bent{"bent", "weak", testing::line({{-5, 1 - 5 * tangent}, {8, 1 + 8 * tangent}, {9, 11}})};
    EXPECT_NEAR(factor({plane("strong", 35, 1), bent}), expected, within_bracket);
    // A part of the plane is weak.
    const SlopeCut part{"part", "weak", testing::line({{-5, 1 - 5 * tangent}, {4, 1 + 4 * tangent}})};
    const double partly = factor({plane("strong", 35, 1), part});
    EXPECT_GT(partly, 1.2 * expected);
    EXPECT_LT(partly, 0.9 / tangent);
    EXPECT_NEAR(factor({part, plane("strong", 35, 1)}), partly, 2 * within_bracket);
}

// The rock slides on the bottom of the section, on which a weak plane was drawn: there the frame's joint met it alone.
TEST(WeakestJoint, AWeakPlaneAlongTheFrameCounts) {
    const double tilt = degrees(15);
    const double expected = std::tan(degrees(20)) / std::tan(tilt);
    const auto factor = [&](std::vector<SlopeCut> cuts, double cohesion = 0) {
        RelaxationStudy study = two_joints(std::move(cuts));
        auto& slope = std::get<RelaxationSlope>(study.model.scene);
        slope.tilt = tilt;
        slope.frame->sides = FrameSides::below;
        slope.geometry.outline = {{0, 0}, {6, 0}, {6, 2}, {0, 2}};
        if (cohesion > 0) {
            slope.joint[0].strength.friction_angle = degrees(20);
            slope.joint[0].strength.cohesion = cohesion;
        }
        return find_critical(study).value();
    };
    const double strong = std::tan(degrees(45)) / std::tan(tilt);
    EXPECT_NEAR(factor({plane("strong", 0, 0)}), strong, within_bracket);
    // Nearer than 7 cm a sliver is left above the frame, which is merged with the rock above the joint.
    for (const double height : {-0.0002, 0.0, 0.0002, 0.005, 0.05, 0.5}) {
        EXPECT_NEAR(factor({plane("weak", 0, height)}), expected, within_bracket) << height;
    }
    JointSetCut beds = testing::joint_set(0, 1);
    beds.through = SectionPoint{0, 2};
    EXPECT_NEAR(factor({{"beds", "weak", beds}}), expected, within_bracket);
    EXPECT_NEAR(factor({plane("strong", 0, 0), plane("weak", 0, 0)}), expected, within_bracket);
    // Half of the bottom is weak. The lower half carries 0.567 of the weight, if pressures are linear.
    const double lower_half = 0.5 + 1.5 * std::tan(tilt) / 6;
    const auto with_share = [&](double share) { return share * expected + (1 - share) * strong; };
    const SlopeCut low{"half", "weak", testing::line({{-1, 0}, {3, 0}})};
    const SlopeCut high{"half", "weak", testing::line({{3, 0}, {7, 0}})};
    // Contacts at the ends of faces stand for a linear pressure to a few percent.
    EXPECT_NEAR(factor({low}), with_share(lower_half), 0.03 * strong);
    EXPECT_NEAR(factor({high}), with_share(1 - lower_half), 0.03 * strong);
    // The joint with less cohesion counts where both have the same friction.
    EXPECT_NEAR(factor({plane("weak", 0, 0)}, 1e6), expected, within_bracket);
    EXPECT_NEAR(factor({plane("strong", 0, 0), plane("weak", 0, 0)}, 1e6), expected, within_bracket);
}

// A wedge of 3 m2 at the crest of a slope of 30 m, on a plane of 60 deg; the other two blocks have 830 m2 each.
TEST(WeakestJoint, AWedgeBesideFewLargeBlocksIsNoSliver) {
    RelaxationStudy study = two_joints({{"flat", "strong", testing::line({{-5, 15}, {65, 15}})},
                                        {"steep", "weak", testing::line({{4.5843, 26}, {6.8937, 30}})}});
    auto& slope = std::get<RelaxationSlope>(study.model.scene);
    slope.geometry.outline = {{0, 0}, {60, 0}, {60, 30}, {5.29, 30}};
    slope.geometry.intact_joint.reset();
    EXPECT_NEAR(find_critical(study).value(), std::tan(degrees(20)) / std::tan(degrees(60)), within_bracket);
}

// Beside the weak plane lies a joint with as much friction or less, which a bond or cohesion makes stronger.
TEST(WeakestJoint, AnOpenJointCountsBesideOneThatIsBonded) {
    const double expected = std::tan(degrees(20)) / std::tan(degrees(35));
    RelaxationJoint bonded{};
    bonded.friction_angle = degrees(20);
    bonded.bond = BondMaterial{20e9, 8e9, 2e6, 3e6, degrees(40)};
    RelaxationJoint less_friction = bonded;
    less_friction.friction_angle = degrees(15);
    RelaxationJoint cohesive{};
    cohesive.friction_angle = degrees(15);
    cohesive.cohesion = 1e6;
    for (const RelaxationJoint& other : {bonded, less_friction, cohesive}) {
        for (const bool first : {true, false}) {
            const SlopeCut open = plane("weak", 35, 1);
            const SlopeCut beside = plane("other", 35, 1);
            RelaxationStudy study = two_joints(first ? std::vector{beside, open} : std::vector{open, beside});
            auto& slope = std::get<RelaxationSlope>(study.model.scene);
            slope.joint.push_back(SlopeJoint{"other", {}, other});
            EXPECT_NEAR(find_critical(study).value(), expected, within_bracket) << first;
            const auto along = slope_scene(slope).section.along_each_other;
            ASSERT_EQ(along.size(), 1U) << first;
            EXPECT_EQ(*along.begin(), std::pair(std::size_t{1}, std::size_t{2}));
            // Reduced alone, the joint that does not count would leave a slope that stands at every factor.
            ReductionSearch other_alone{};
            other_alone.joints = {"other"};
            study.critical = other_alone;
            EXPECT_NEAR(find_critical(study).value(), expected, within_bracket) << first;
        }
    }
}

TEST(WeakestJoint, OfEqualPeaksTheOneThatIsWeakerAfterSlipCounts) {
    for (const bool first : {true, false}) {
        const SlopeCut lasting = plane("weak", 35, 1);
        const SlopeCut losing = plane("losing", 35, 1);
        RelaxationStudy study = two_joints(first ? std::vector{lasting, losing} : std::vector{losing, lasting});
        auto& slope = std::get<RelaxationSlope>(study.model.scene);
        slope.joint.push_back({"losing", {}, slope.joint[1].strength});
        slope.joint[2].strength.residual_friction_angle = degrees(10);
        std::set<std::size_t> joints;
        for (const RelaxationBlock& block : slope_scene(slope).block) {
            joints.insert(block.joint.begin(), block.joint.end());
        }
        EXPECT_EQ(joints, (std::set<std::size_t>{0, 2})) << first;
        EXPECT_EQ(joints_reduced(slope, {"losing"}), (std::vector<std::string>{"losing", "weak"}));
    }
}

// Rock behind a bench is divided from its corner, at 50.7 deg to the right, where the side is free. A weak plane 2 cm
// above that division leaves a sliver, which is no reason to lose the plane.
TEST(WeakestJoint, AWeakPlaneIsNotLostBesideADivisionOfIntactRock) {
    RelaxationStudy study = two_joints({{"weak", "weak", testing::line({{7, 6.24}, {8, 5.02}, {10.5, 1.97}})}});
    auto& slope = std::get<RelaxationSlope>(study.model.scene);
    slope.frame->sides = FrameSides::below;
    slope.geometry.outline = {{0, 0}, {10, 0}, {10, 10}, {9, 10}, {8, 5}, {4, 5}};
    EXPECT_NEAR(find_critical(study).value(), std::tan(degrees(20)) / 1.22, within_bracket);
}

// A block slides on a plane at 48 deg that daylights above level ground.
RelaxationStudy block_above_ground(double height, SlopeJoint plane) {
    RelaxationSlope slope{};
    slope.rock = {{"rock", 2650}};
    plane.name = "plane";
    slope.joint = {plane, {"crack", {}, {}}, {"intact", {}, {}}};
    slope.joint[2].strength.friction_angle = degrees(45);
    slope.frame = SlopeFrame{FrameSides::all_around, 3, {}, "intact"};
    const SectionPoint foot{height * 8 / 28, height};
    const SectionPoint head{17, height + (17 - foot.x) * std::tan(degrees(48))};
    slope.geometry = testing::section(
        {{-15, -8}, {45, -8}, {45, 28}, {8, 28}, {0, 0}, {-15, 0}},
        {{"plane", "plane", testing::line({foot, head})}, {"crack", "crack", testing::line({head, {17, 28}})}});
    slope.geometry.intact_joint = "intact";
    slope.fixed = {{{{-50, -50}, {90, -50}, {90, 90}, {17, 90}, head, foot, {-50, height}}}};
    RelaxationStudy study{};
    study.model.scene = slope;
    study.critical = ReductionSearch{};
    return study;
}

// The static solver lets the block creep until its tip leans on the ground, where it rests. Linear programmes of
// statics find that the slope does not stand as drawn, but not where the ground shakes, and they count tensile strength
// that has been broken.
TEST(WeakestJoint, ABlockThatCreepsOntoTheGroundInFrontDoesNotStand) {
    const double tangent = std::tan(degrees(48));
    for (const double height : {0.25, 0.5}) {
        SlopeJoint plane{};
        plane.strength.friction_angle = degrees(47);
        RelaxationStudy study = block_above_ground(height, plane);
        // The contact at the tip, which leaves its edge, bears less and less: 1 % where it is near the ground.
        const double expected = std::tan(degrees(47)) / tangent;
        EXPECT_NEAR(find_critical(study).value(), expected, 0.01) << height;
        study.model.shaking = {{0, 0, 0}};
        EXPECT_NEAR(find_critical(study).value(), expected, 0.01) << height;
        plane.strength.friction_angle = degrees(35);
        plane.strength.cohesion = 5e3;
        plane.strength.tensile_strength = 1e6;
        // (c L + N tan phi) / T is 0.664; less if an end of the joint parts before the block slides.
        const CriticalAnswer with_tension = find_critical(block_above_ground(height, plane));
        EXPECT_LT(with_tension.stands, 0.664 + within_bracket) << height;
        EXPECT_GT(with_tension.fails, 0.99 * std::tan(degrees(35)) / tangent) << height;
    }
}

// A plane and a crack end where they meet, inside the rock: the block between them slides, whether they are lines or
// joints of sets, each in a region of its own, and whichever is cut first.
TEST(WeakestJoint, JointsOfSetsThatEndInsideRockCutABlockOut) {
    const SlopeCut plane{"plane", "plane",
                         testing::one_joint(degrees(35), {0, 0}, {{-30, -30}, {10.2, -30}, {10.2, 30}, {-30, 30}})};
    const SlopeCut crack{"crack", "crack",
                         testing::one_joint(degrees(90), {10, 0}, {{-30, 6.5}, {60, 6.5}, {60, 30}, {-30, 30}})};
    for (std::vector<SlopeCut> cuts : {std::vector{plane, crack}, std::vector{crack, plane}}) {
        RelaxationSlope slope{};
        slope.rock = {{"rock", 2650}};
        slope.joint = {{"plane", {}, {}}, {"crack", {}, {}}, {"intact", {}, {}}};
        slope.joint[0].strength.friction_angle = slope.joint[2].strength.friction_angle = degrees(45);
        slope.joint[2].strength.cohesion = slope.joint[2].strength.tensile_strength = 5e6;
        slope.frame = SlopeFrame{FrameSides::all_around, 3, {}, "plane"};
        slope.geometry = testing::section({{-15, -8}, {45, -8}, {45, 12}, {7, 12}, {0, 0}, {-15, 0}}, std::move(cuts));
        slope.geometry.intact_joint = "intact";
        RelaxationStudy study{};
        study.model.scene = slope;
        study.critical = ReductionSearch{};
        EXPECT_NEAR(find_critical(study).value(), 1 / std::tan(degrees(35)), within_bracket);
    }
}

// Two joints that follow each other on one plane each keep their own friction, wherever outlines begin.
TEST(WeakestJoint, APlaneOfTwoJointsHasTheStrengthOfEach) {
    const double tangent = std::tan(degrees(35));
    const auto factor = [&](std::vector<SlopeCut> cuts) {
        RelaxationStudy study = two_joints(std::move(cuts));
        return find_critical(study).value();
    };
    const auto on_plane = [&](const std::string& joint, double from, double to) {
        return SlopeCut{joint, joint, testing::line({{from, 1 + from * tangent}, {to, 1 + to * tangent}})};
    };
    const double one_after_the_other = factor({on_plane("strong", -5, 6), on_plane("weak", 6, 30)});
    EXPECT_NEAR(factor({on_plane("strong", -5, 30), on_plane("weak", 6, 30)}), one_after_the_other, 2 * within_bracket);
    EXPECT_NEAR(factor({on_plane("weak", 6, 30), on_plane("strong", -5, 6)}), one_after_the_other, 2 * within_bracket);
}

// A short free length of a grouted bolt turns towards the direction of slip long before onset, by which it would hold
// the block like a dowel. It counts as tension along its axis. No joint of a bolt whose grout holds less bears more.
TEST(WeakestJoint, AGroutedBoltHoldsAlongItsAxis) {
    for (const double height : {0.5, 2.0}) {
        const double dip = degrees(48);
        const double plunge = degrees(20);
        const double friction = std::tan(degrees(47));
        SlopeJoint plane{};
        plane.strength.friction_angle = degrees(47);
        RelaxationStudy study = block_above_ground(height, plane);
        const double head_x = 9.0 * 8 / 28;
        BoltBar bar{plunge, 14, 1, 1e9, 6e5, 6e5, 0.2, {}};
        study.model.bolt = {{head_x, 9, bar}};
        // Foot and head of the block's plane, then the crest.
        const double foot_x = height * 8 / 28;
        const double head_y = height + (17 - foot_x) * std::tan(dip);
        const Polygon<> block{{foot_x, height}, {17, head_y}, {17, 28}, {8, 28}};
        const double weight = 2650 * Gravity{}.acceleration * area_properties(block).area;
        const auto expected = [&](double tension) {
            return friction * (weight * std::cos(dip) + tension * std::sin(dip + plunge)) /
                   (weight * std::sin(dip) - tension * std::cos(dip + plunge));
        };
        // The bracket, and contacts at the tip as without a bolt.
        EXPECT_NEAR(find_critical(study).value(), expected(6e5), 0.01);
        // It bears as much if it was not tensioned.
        study.model.bolt[0].bar.pretension.reset();
        EXPECT_NEAR(find_critical(study).value(), expected(6e5), 0.01);
        // The bolt crosses the plane at this distance from its head.
        const double along =
            (head_x - foot_x - (9 - height) / std::tan(dip)) / (-std::cos(plunge) - std::sin(plunge) / std::tan(dip));
        study.model.bolt[0].bar.grout = Grout<double>{4e4, 1e6};
        EXPECT_NEAR(find_critical(study).value(), expected(4e4 * (14 - along)), 0.01) << height;
    }
}

// Blocks above and below two planes that cross at 0.8 deg meet in one point. It carries no more friction than the
// weaker plane.
TEST(WeakestJoint, PlanesThatNearlyCoincideCrossWithTheWeakerStrength) {
    for (const bool weak_first : {true, false}) {
        std::vector<SlopeCut> cuts{plane("weak", 35.8, 0.9), plane("strong", 35, 1)};
        if (!weak_first) {
            std::swap(cuts[0], cuts[1]);
        }
        const RelaxationStudy study = two_joints(std::move(cuts), 0);
        // The joint's own 0.8 deg are not resolved: faces that bend by less than 1.15 deg are one.
        const double expected = std::tan(degrees(20)) / std::tan(degrees(35.8));
        EXPECT_LT(find_critical(study).value(), 1.05 * expected);
        EXPECT_LT(*greatest_strength_reduction(relaxation_scene(study)), 1.05 * expected);
    }
}

// Rounded to a micrometre, they bend the trace by far less than the snap distance, 2 mm.
TEST(WeakestJoint, PointsOnAStraightTraceDivideNoBlock) {
    const double tangent = std::tan(degrees(35));
    std::vector<SectionPoint> points;
    for (const double x : {-5.0, 2.3, 5.7, 11.1, 30.0}) {
        points.push_back({x, std::round(1e6 * (1 + x * tangent)) / 1e6});
    }
    const RelaxationStudy drawn = two_joints({{"bed", "strong", testing::line(points)}});
    EXPECT_EQ(number_of_blocks(drawn), number_of_blocks(two_joints({plane("strong", 35, 1)})));
}

// 4 m/s2 for 9 s, as a record and as a constant load.
TEST(WeakestJoint, ARecordOfShakingActsAtEachStrength) {
    RelaxationStudy study = two_joints({plane("strong", 35, 1)});
    study.model.shaking = {{0, 4, 0}};
    const double share = 4 / 9.80665;
    const double tangent = std::tan(degrees(35));
    const double expected = (1 - share * tangent) / (tangent + share);
    EXPECT_NEAR(find_critical(study).value(), expected, within_bracket);
    study.model.shaking.push_back({9, 4, 0});
    const CriticalAnswer shaken = find_critical(study);
    EXPECT_EQ(shaken.path, LoadingPath::preloaded);
    EXPECT_NEAR(shaken.value(), expected, within_bracket);
    std::get<ReductionSearch>(*study.critical).paths = PathChoice::all;
    for (const PathValue& other : find_critical(study).other) {
        EXPECT_NE(other.path, LoadingPath::consolidated);
    }
}

// A joint shears at cohesion + N tan(friction), N not below the tension; the bound counted that sum from the greatest
// tension on. With 1 MPa of tensile strength it was 7.18 instead of 2.45.
TEST(WeakestJoint, TheBoundOfStaticsHoldsNoMoreShearByTension) {
    using namespace relaxation_scenes;
    const OnPlane plane{.height_to_width = 0.25, .width = 4, .friction = degrees(30), .tilt = degrees(40)};
    RelaxationScene scene = relaxation_scenes::scene_of(plane);
    scene.material[0].cohesion = 30e3;
    const double driving = plane.weight() * std::sin(plane.tilt);
    const double expected =
        (30e3 * plane.width + plane.weight() * std::cos(plane.tilt) * std::tan(plane.friction)) / driving;
    for (const double tension : {0.0, 1e4, 1e6}) {
        scene.material[0].tensile_strength = tension;
        scene.bond = find_bonds(scene);
        EXPECT_NEAR(*greatest_strength_reduction(scene), expected, 1e-6 * expected) << tension;  // of the programme
    }
}

// Half of the base is open. The bound gave the whole of it the rock's strength, a factor of 2.93.
TEST(WeakestJoint, TheBoundOfStaticsBondsNoOpenFace) {
    using namespace relaxation_scenes;
    const OnPlane plane{.height_to_width = 0.25, .width = 4, .friction = degrees(20), .tilt = degrees(40)};
    RelaxationScene scene = relaxation_scenes::scene_of(plane);
    scene.material.push_back(scene.material[0]);
    scene.material[1].bond = BondMaterial{20e9, 8e9, 10e3, 30e3, degrees(40)};
    scene.block[0].outline.insert(scene.block[0].outline.begin() + 1, PlanePoint<>(2, 0));
    scene.block[0].joint = {0, 1, 0, 0, 0};
    scene.block[1].joint = {1, 1, 1, 1};
    scene.bond = find_bonds(scene);
    ASSERT_EQ(scene.bond.size(), 1U);
    const double driving = plane.weight() * std::sin(plane.tilt);
    const double normal = plane.weight() * std::cos(plane.tilt);
    // The bonded half can at most carry all of the weight; friction of the open half holds at least this.
    const double most = (30e3 * 2 + normal * std::tan(degrees(40))) / driving;
    const double least = normal * std::tan(degrees(20)) / driving;
    const double bound = *greatest_strength_reduction(scene);
    EXPECT_LT(bound, most);
    EXPECT_GT(bound, least);
}

}  // namespace
}  // namespace delabole
