// The moment check: where the normal force acts, and whether the mass overturns about the lower end of its base.
#include "plane_failure/plane_failure.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

namespace delabole {
namespace {

// Sums of a few products: rounding of a dozen operations.
constexpr double rounding = 1e-13;

// Dry triangle toe, crest, outcrop. Its centroid is the mean of its corners; the weight's line meets the base at the
// centroid's x. The base's shear passes through the lower end, so the normal force has to balance the weight's moment:
// N s = W x_c, s = x_c / cos(p): the very point.
TEST(Moments, DryTriangleByHand) {
    PlaneFailure<> problem = textbook_slope();
    problem.slope = {10, degrees(60), 0, {}, {}};
    problem.failure_plane.dip = degrees(30);
    problem.tension_crack.reset();
    const double crest = 10 / std::tan(degrees(60));
    const double outcrop = 10 / std::tan(degrees(30));
    const double centroid = (0 + crest + outcrop) / 3;
    const PlaneFailureResult result = analyse(problem);
    ASSERT_EQ(result.check, PlaneFailureCheck::valid);
    EXPECT_NEAR(result.normal_force_position, centroid / outcrop, rounding);
    EXPECT_NEAR(result.restoring_moment / (result.weight * centroid), 1, rounding);
    EXPECT_EQ(result.overturning_moment, 0);
    EXPECT_TRUE(std::isinf(result.overturning_factor));
}

// Rock 10 m high with a vertical face, a crack 1 m behind it, on a plane of 15 deg: a column. Full of water to the top
// it overturns: V acts at a third of z above the crack's base.
TEST(Moments, TallThinMassWithAFullCrackOverturns) {
    PlaneFailure<> problem = textbook_slope();
    problem.slope = {10, degrees(90), 0, {}, {}};
    problem.failure_plane.dip = degrees(15);
    problem.tension_crack = TensionCrack<>{degrees(90), CrackAtDistance<>{1}};
    problem.strength = Coulomb<>{500e3, degrees(40)};
    problem.water = CrackOnlyWater<>{10e3, FilledRatio<>{1}};
    const PlaneFailureResult result = analyse(problem);
    ASSERT_EQ(result.check, PlaneFailureCheck::valid);
    const double t = std::tan(degrees(15));
    const double z = 10 - t;
    // Trapezoid of heights 10 and z and width 1.
    const double weight = 26e3 * (10 + z) / 2;
    const double centroid = (10 + 2 * z) / (10 + z) / 3;
    const double water = 10e3 * z * z / 2;
    EXPECT_NEAR(result.restoring_moment / (weight * centroid), 1, rounding);
    EXPECT_NEAR(result.overturning_moment / (water * (t + z / 3)), 1, rounding);
    EXPECT_LT(result.overturning_factor, 1);
    EXPECT_LT(result.normal_force_position, 0);
    EXPECT_GT(result.factor_of_safety, 1);
    EXPECT_EQ(result.outcome, PlaneFailureOutcome::overturns);
    // Five metres thick it stands.
    problem.tension_crack = TensionCrack<>{degrees(90), CrackAtDistance<>{5}};
    EXPECT_EQ(analyse(problem).outcome, PlaneFailureOutcome::stable);
}

// The Hoek-Bray triangle of base water: two thirds of the way up, L^2 p / 3.
TEST(Moments, WaterByHand) {
    PlaneFailure<> problem = textbook_slope();
    const PlaneFailureResult dry = analyse(problem);
    problem.water = CrackAndBaseWater<>{9.81e3, WaterDepth<>{3}};
    const PlaneFailureResult wet = analyse(problem);
    const double base = wet.sliding_area;
    const double from_base = 9.81e3 * 3 * base * base / 3;
    const double from_crack = wet.crack_water_force * (wet.crack_base_height + 1);
    EXPECT_NEAR(wet.overturning_moment / (from_base + from_crack), 1, rounding);
    EXPECT_NEAR(wet.restoring_moment / dry.restoring_moment, 1, rounding);
}

// A pond pushes the face back and lifts the base: both triangles act at a third of their wetted lengths.
TEST(Moments, PondByHand) {
    PlaneFailure<> problem = textbook_slope();
    const PlaneFailureResult dry = analyse(problem);
    problem.pond = Pond<>{6, 9.81e3};  // below the bottom of the crack, 7.65 m
    const PlaneFailureResult ponded = analyse(problem);
    const double wetted = 6 / std::sin(degrees(60));
    const double force = 9.81e3 * 6 * wetted / 2;
    EXPECT_NEAR((ponded.restoring_moment - dry.restoring_moment) / (force * wetted / 3), 1, 100 * rounding);
    const double lifted = 6 / std::sin(degrees(35));
    EXPECT_NEAR(ponded.overturning_moment / (9.81e3 * 6 * lifted / 2 * lifted / 3), 1, 10 * rounding);
}

TEST(Moments, LoadsByHand) {
    const PlaneFailureResult bare = analyse(textbook_slope());
    const double crest = 12 / std::tan(degrees(60));
    PlaneFailure<> problem = textbook_slope();
    problem.surcharge = {{10e3, 1, 3}};
    EXPECT_NEAR(analyse(problem).restoring_moment, bare.restoring_moment + 20e3 * (crest + 2), 1e-6);
    problem = textbook_slope();
    problem.line_load = {{10e3, degrees(180), 2}};  // out of the slope, at crest level
    EXPECT_NEAR(analyse(problem).overturning_moment, 10e3 * 12, 1e-6);
    problem = textbook_slope();
    problem.bolt = {{10e3, 0, 8, BoltAction::active}};  // horizontal into the slope, 8 m above the toe
    EXPECT_NEAR(analyse(problem).restoring_moment, bare.restoring_moment + 80e3, 1e-6);
    problem = textbook_slope();
    problem.seismic = SeismicLoad<>{0.1, 0};
    const PlaneFailureResult shaken = analyse(problem);
    EXPECT_GT(shaken.overturning_moment, 0.1 * bare.weight * 12 / 3);
    EXPECT_LT(shaken.overturning_moment, 0.1 * bare.weight * 12);
    // Heights count from where the plane daylights.
    problem = textbook_slope();
    problem.failure_plane.daylight_height = 5;
    const PlaneFailureResult higher = analyse(problem);
    problem.bolt = {{10e3, 0, 8, BoltAction::active}};
    EXPECT_NEAR(analyse(problem).restoring_moment, higher.restoring_moment + 30e3, 1e-6);
}

// Position and factor are ratios of moments: similar problems share them.
TEST(Moments, Similarity) {
    RandomProblem random(23);
    int compared = 0;
    for (int count = 0; count < 1000; ++count) {
        PlaneFailure<> problem = random.next();
        const PlaneFailureResult before = analyse(problem);
        for_each_number(problem, [](double& number, const FieldInfo& info) {
            number *= info.dimension == Dimension::length             ? 4
                      : info.dimension == Dimension::stress           ? 4
                      : info.dimension == Dimension::force_per_length ? 16
                                                                      : 1;
        });
        const PlaneFailureResult after = analyse(problem);
        ASSERT_EQ(before.check, after.check);
        if (before.check == PlaneFailureCheck::valid) {
            ++compared;
            EXPECT_EQ(before.outcome, after.outcome);
            EXPECT_EQ(before.overturning_factor, after.overturning_factor);  // powers of two change no bit
            EXPECT_EQ(before.normal_force_position, after.normal_force_position);
        }
    }
    EXPECT_GT(compared, 300);
}

}  // namespace
}  // namespace delabole
