// Stepped surfaces at the limits of water, of what is searched and of what there is to find.
#include "limit_equilibrium/stepped_path/stepped_path.hpp"
#include "plane_failure/plane_failure.hpp"
#include "tests/lib/limit_equilibrium/stepped_path/every_stepped_path.hpp"
#include "tests/lib/limit_equilibrium/stepped_path/west_face.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace delabole {
namespace {

// Steps that run down below the toe stand in water that reaches no higher than it.
TEST(SteppedPath, WaterAtTheToeIsTheLimitOfWaterAboveIt) {
    for (const auto mechanism :
         {SteppedPathMechanism::toppling, SteppedPathMechanism::slide_head_toppling, SteppedPathMechanism::sliding}) {
        SteppedPath path = west_face(mechanism);
        path.steps = {degrees(-20), 8, degrees(26.5), 0};
        path.columns->spacing = 4;
        const auto at = [&](double depth) {
            path.water = WaterTable<>{9.81e3, WaterDepth<>{depth}};
            return analyse(path).factor_of_safety;
        };
        const double least = at(1e-6);
        EXPECT_TRUE(at(0) == least || std::abs(at(0) - least) < 1e-6 * least);  // per micrometre some 1e-8
        path.slope.toe_elevation = 100;
        path.water = WaterTable<>{9.81e3, WaterElevation<>{40}};
        const double below = analyse(path).factor_of_safety;
        path.water = Dry{};
        EXPECT_EQ(below, analyse(path).factor_of_safety);
    }
}

// A push steadies squat columns that water turns, so that less push from above may ask more of the toe. If surfaces may
// come out further behind the crest there are more of them, and none is stronger.
TEST(SteppedPath, ColumnsThatAPushSteadiesHideNoWeakerSurface) {
    SteppedPath known = west_face(SteppedPathMechanism::toppling);
    known.search = {SteppedPathMechanism::toppling, 3.682571386414936, std::nullopt};
    known.slope = {18.95182868537451, 1.1019895428700304, 0, std::nullopt, std::nullopt};
    known.steps = {-0.484615727983778, 7.995699246386037, 0.48357044722635795, 34205.85497250976};
    known.columns = PathColumns{-1.355928569880374, 3.9989737544090103, 0.3410203734495386};
    known.rock = {15722.832491810772};
    known.water = WaterTable<>{9.81e3, WaterDepth<>{8.117920095331034}};
    known.search.greatest_retreat = 12;
    const double of_fewer = analyse(known).factor_of_safety;
    known.search.greatest_retreat = 15.447053944406456;
    EXPECT_LE(analyse(known).factor_of_safety, of_fewer * (1 + 1e-9));
}

// On ground that falls behind the crest joints come out closer than on level ground.
TEST(SteppedPath, ExtentCountsWhereTheNextJointComesOut) {
    SteppedPath path = west_face(SteppedPathMechanism::toppling);
    path.columns->spacing = 3;
    path.water = Dry{};
    const double level = path.search.greatest_retreat.value_or(path.slope.height);
    for (const double dip : {-20.0, 0.0, 20.0}) {
        path.slope.upper_surface_dip = degrees(dip);
        path.search.greatest_retreat = level;
        const SteppedPathResult all = analyse(path);
        ASSERT_EQ(all.extent, PathExtent::greatest) << dip;
        const double pitch =
            3 / (std::sin(degrees(85)) + std::cos(degrees(85)) * std::tan(degrees(dip)));  // between outcrops
        for (const double share : {0.01, 0.99}) {
            path.search.greatest_retreat = all.retreat + share * pitch;
            EXPECT_NEAR(analyse(path).retreat, all.retreat, 1e-9 * all.retreat) << dip;
            EXPECT_EQ(analyse(path).extent, PathExtent::greatest) << dip << ' ' << share;
        }
    }
}

SteppedPath slope_with_risers(double face_dip, double height, const PathSteps& steps, const PathRisers& risers) {
    SteppedPath path{};
    path.search.mechanism = SteppedPathMechanism::sliding;
    path.slope = {height, face_dip, 0, std::nullopt, std::nullopt};
    path.steps = steps;
    path.risers = risers;
    path.rock = {26e3};
    path.water = Dry{};
    return path;
}

// The factor of a plane through the toe without a crack.
double factor_of_plane(const SteppedPath& path, double dip, const Coulomb<>& strength) {
    PlaneFailure<> plane{};
    plane.slope = path.slope;
    plane.failure_plane = {dip, std::nullopt};
    plane.rock = path.rock;
    plane.strength = strength;
    plane.water = Dry{};
    return analyse(plane).factor_of_safety;
}

// Risers that come out in the face, in front of the crest, bound the steps as those behind it do. The factor
// of the surface found was computed from its polygon, with the water's pressure integrated numerically; without those
// risers the least factor is 1.108.
TEST(SteppedPath, RisersInFrontOfTheCrestCount) {
    SteppedPath path = slope_with_risers(degrees(42.636866679054286), 60,
                                         {degrees(6.633452068812284), 9.633539296304061, degrees(15.199846), 7159.35},
                                         {degrees(79.02384049897009), 4.0071455738108295, degrees(8.775577), 0});
    path.slope.upper_surface_dip = degrees(4.09092950032365);
    path.water = WaterTable<>{9.81e3, WaterDepth<>{29.91252840503225}};
    const SteppedPathResult result = analyse(path);
    EXPECT_NEAR(result.factor_of_safety, 0.7846033, 1e-7);  // error of that integration
    const auto in_front = [&](const Point& point) { return point.x() < 60 / std::tan(path.slope.face_dip) / 2; };
    EXPECT_GT(std::ranges::count_if(result.surface, in_front), 2) << "risers and the foot";
}

TEST(SteppedPath, AStepThatComesOutBehindTheCrestIsAPlaneFailure) {
    SteppedPath path =
        slope_with_risers(degrees(80), 60, {degrees(40), 5, degrees(38), 10e3}, {degrees(85), 38, degrees(35), 0});
    path.search.greatest_retreat = 200;
    path.rock_bridges = RockBridges{1, 0.7, 1e6, degrees(45), 1e6};  // risers are too strong to open
    const SteppedPathResult result = analyse(path);
    EXPECT_NEAR(result.factor_of_safety, factor_of_plane(path, degrees(40), Coulomb<>{10e3, degrees(38)}), 1e-12);
    EXPECT_NEAR(result.retreat, 60 / std::tan(degrees(40)) - 60 / std::tan(degrees(80)), 1e-9);
    EXPECT_NEAR(result.lower_angle, degrees(40), 1e-12);
    EXPECT_NEAR(result.upper_angle, degrees(40), 1e-12);
    EXPECT_EQ(result.lower_steps, 0);
    EXPECT_EQ(result.lower_roughness, 0);
    path.risers->spacing = 1e3;  // none meets the step
    path.search.least_width = 5;
    EXPECT_NEAR(analyse(path).factor_of_safety, result.factor_of_safety, 1e-12);
}

TEST(SteppedPath, WhatSlidesOnASingleRiserHasAFactorOfItsOwn) {
    SteppedPath path =
        slope_with_risers(degrees(85), 60, {degrees(10), 3, degrees(38), 0}, {degrees(60), 5, degrees(30), 0});
    const SteppedPathResult result = analyse(path);
    EXPECT_GT(result.factor_of_safety, 4);
    EXPECT_NEAR(result.factor_on_riser, std::tan(degrees(30)) / std::tan(degrees(60)), 1e-12);
    path.search.mechanism = SteppedPathMechanism::slide_head_toppling;
    path.columns = PathColumns{degrees(-70), 5, degrees(30)};
    EXPECT_NEAR(analyse(path).factor_on_riser, result.factor_on_riser, 1e-12);
    // A riser through the toe.
    path.risers = PathRisers{degrees(60), 60 * (std::cos(degrees(60)) - std::sin(degrees(60)) / std::tan(degrees(85))),
                             degrees(30), 50e3};
    EXPECT_NEAR(analyse(path).factor_on_riser, factor_of_plane(path, degrees(60), Coulomb<>{50e3, degrees(30)}), 1e-9);
    path.risers->dip = degrees(86);
    EXPECT_TRUE(std::isinf(analyse(path).factor_on_riser)) << "steeper than the face";
}

// One mass of 5 m on a step through the toe, with a vertical crack behind it, and water 8 m above the toe.
TEST(SteppedPath, WaterStandsBehindAVerticalFaceAtItsLevel) {
    SteppedPath path =
        slope_with_risers(degrees(90), 10, {degrees(30), 20, degrees(45), 0}, {degrees(90), 5, degrees(35), 0});
    path.search.greatest_retreat = 5;
    path.water = WaterTable<>{9.81e3, WaterDepth<>{8}};
    const double knee = 5 * std::tan(degrees(30));
    const double weight = 26e3 * (50 - 5 * knee / 2);
    const double in_crack = 9.81e3 * (8 - knee) * (8 - knee) / 2;
    const double below = 9.81e3 * (8 + (8 - knee)) / 2 * 5 / std::cos(degrees(30));
    const double resisting = weight * std::cos(degrees(30)) - below - in_crack * std::sin(degrees(30));
    const double driving = weight * std::sin(degrees(30)) + in_crack * std::cos(degrees(30));
    // Sums of a few terms.
    EXPECT_NEAR(analyse(path).factor_of_safety, resisting / driving, 1e-12);
}

// On a vertical face the x of what lies in it is rounding.
TEST(SteppedPath, AVerticalFaceIsTheLimitOfSteepOnes) {
    std::mt19937 random(23);
    int found = 0;
    for (int count = 0; count < 600; ++count) {
        SteppedPath path = random_path(random, static_cast<SteppedPathMechanism>(count % 3));
        if (count % 2 == 0) {
            path.water = WaterTable<>{9.81e3, WaterDepth<>{path.slope.height * 0.6}};
        } else if (count % 5 == 0) {
            path.water = Dry{};
        }
        path.slope.face_dip = degrees(90 - 1e-6);
        const SteppedPathResult steep = analyse(path);
        path.slope.face_dip = degrees(90);
        const SteppedPathResult vertical = analyse(path);
        ASSERT_EQ(vertical.check, steep.check) << count;
        ASSERT_EQ(vertical.surface.empty(), steep.surface.empty()) << count;
        if (steep.surface.empty()) {
            continue;
        }
        ++found;
        // The crest moves by 1.7e-8 of the height, and the factor by up to a hundred times that where forces nearly
        // cancel.
        EXPECT_NEAR(vertical.factor_of_safety, steep.factor_of_safety, 1e-5 * steep.factor_of_safety) << count;
        EXPECT_NEAR(vertical.failed_area, steep.failed_area, 1e-6 * steep.failed_area) << count;
    }
    EXPECT_GT(found, 200);
}

TEST(SteppedPath, NoToeIsWeakerThanTheOneFound) {
    std::mt19937 random(24);
    int found = 0;
    int before_surface = 0;
    for (int count = 0; count < 400; ++count) {
        const SteppedPath problem = random_path(
            random, count % 2 == 0 ? SteppedPathMechanism::toppling : SteppedPathMechanism::slide_head_toppling);
        const PathLattice lattice(problem);
        if (lattice.check != SteppedPathCheck::valid) {
            continue;
        }
        const double least = least_of_all(problem, lattice, all_toe_paths(lattice));
        const double toe = least_stable_toe(problem, lattice).value;
        if (std::isfinite(least) && least > 0) {
            ++found;
            before_surface += toe < least_stable_path(problem, lattice).factor_of_safety ? 1 : 0;
            EXPECT_NEAR(toe, least, 1e-9 * least) << count;  // factors are known to some 1e-14
        } else {
            EXPECT_EQ(toe, least) << count;
        }
    }
    EXPECT_GT(found, 100);
    EXPECT_GT(before_surface, 20);
}

// The column at the toe slides with the water on its base and on the joint behind it, which comes out in the face.
TEST(SteppedPath, AColumnAtTheToeSlidesByItself) {
    SteppedPath path{};
    path.search = {SteppedPathMechanism::toppling, std::nullopt, std::nullopt};
    path.slope = {20, degrees(75.5), 0, std::nullopt, std::nullopt};
    path.steps = {degrees(25.6), 3.55, degrees(31.5), 0};
    path.columns = PathColumns{degrees(-73), 5.4, degrees(14.8)};
    path.rock = {26e3};
    path.water = WaterTable<>{9.81e3, WaterDepth<>{4.9}};
    const SteppedPathResult result = analyse(path);
    EXPECT_EQ(result.limit, LimitState::found);
    EXPECT_GT(result.factor_of_safety, 1.2);

    // Corners of the column: the toe, the upper end of its base, and where the joint comes out in the face.
    const double dip = path.steps.dip;
    const Point up_joint(-std::cos(degrees(73)), std::sin(degrees(73)));
    const double base = 5.4 / std::sin(degrees(73) + dip);
    const Point end = base * Point(std::cos(dip), std::sin(dip));
    const Point face(std::cos(path.slope.face_dip), std::sin(path.slope.face_dip));
    const double along_joint =
        (face.x() * end.y() - face.y() * end.x()) / (up_joint.x() * face.y() - up_joint.y() * face.x());  // to the face
    const Point top = end + along_joint * up_joint;
    const double weight = 26e3 * (end.x() * top.y() - end.y() * top.x()) / 2;
    ASSERT_GT(top.y(), 4.9);
    const double wetted = (4.9 - end.y()) / up_joint.y();
    const double on_joint = 9.81e3 * (4.9 - end.y()) * wetted / 2;
    // The water on the base stands below the face in front of where the face rises above its level.
    const double emerges = 4.9 / std::tan(path.slope.face_dip);
    const auto depth = [&](double x) { return std::min(4.9, x * std::tan(path.slope.face_dip)) - x * std::tan(dip); };
    const double under = 9.81e3 / std::cos(dip) *
                         (emerges * depth(emerges) / 2 + (end.x() - emerges) * (depth(emerges) + depth(end.x())) / 2);
    const double out = dip + degrees(73) - degrees(90);  // of the push on the joint, from the base
    const double driving = weight * std::sin(dip) + on_joint * std::cos(out);
    const double into = weight * std::cos(dip) - under - on_joint * std::sin(out);
    EXPECT_NEAR(result.factor_of_toe, std::tan(degrees(31.5)) * into / driving, 1e-9);
    path.search.mechanism = SteppedPathMechanism::sliding;
    path.risers = PathRisers{degrees(80), 5, degrees(30), 0};
    EXPECT_TRUE(std::isinf(analyse(path).factor_of_toe)) << "without columns";
}

// The mass as a whole moves at 70 times its strength, but the column at its toe is weaker than it has to be.
TEST(SteppedPath, WhatIsAbruptIsNoFactorOfSafetyOfAStudy) {
    SteppedPath path{};
    path.search = {SteppedPathMechanism::slide_head_toppling, std::nullopt, std::nullopt};
    path.slope = {20, degrees(55.64438955887434), degrees(-3.186416036319697), std::nullopt, std::nullopt};
    path.steps = {degrees(0.6304307923638177), 5.2664586760248575, degrees(37.64473806679253), 0};
    path.risers = PathRisers{degrees(82.3147237440595), 7.509649641096513, degrees(30.85864155560274), 0};
    path.columns = PathColumns{degrees(-85.00802408118074), 6.188028939018238, degrees(11.108692284117943)};
    path.rock = {26e3};
    path.water = WaterTable<>{9.81e3, WaterDepth<>{10.99854425133449}};
    const SteppedPathResult result = analyse(path);
    ASSERT_EQ(result.limit, LimitState::abrupt);
    EXPECT_GT(result.factor_of_safety, 60);
    EXPECT_NEAR(result.factor_of_toe, 0.851, 5e-4);  // printed digits of a recursion written apart from the library
    const ModelInterface model = model_interface(path);
    const Prediction prediction = model.predict({});
    ASSERT_TRUE(prediction.failure.empty());
    const Interval range = model.bounded_outputs.front().range(prediction);
    EXPECT_EQ(range.upper, result.factor_of_safety);
    EXPECT_EQ(range.lower, -std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace delabole
