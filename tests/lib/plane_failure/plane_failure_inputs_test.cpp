// What plane failure is given: water, loads and strengths in each of their forms; and what loops over models see of it.
#include "plane_failure/plane_failure.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

// A few dozen roundings of numbers without cancellation.
constexpr double rounding = 1e-13;

double factor(const PlaneFailure<>& problem) {
    const FactorOfSafety result = factor_of_safety(problem);
    EXPECT_EQ(result.check, PlaneFailureCheck::valid);
    return result.value;
}

PlaneFailure<> textbook_with_water(double depth) {
    PlaneFailure<> problem = textbook_slope();
    problem.water = CrackAndBaseWater<>{9.81e3, WaterDepth<>{depth}};
    return problem;
}

// --- Water forms against each other ---

TEST(WaterForms, CustomPressuresReproduceEachForm) {
    const PlaneFailureResult dry = analyse(textbook_slope());
    const double gamma = 9.81e3;
    const double z = dry.crack_depth;
    const double top = dry.crack_base_height;
    const auto compare = [](const Water<>& form, const CustomWater<>& custom) {
        PlaneFailure<> a = textbook_slope();
        PlaneFailure<> b = textbook_slope();
        a.water = form;
        b.water = custom;
        const PlaneFailureResult first = analyse(a);
        const PlaneFailureResult second = analyse(b);
        ASSERT_EQ(first.check, PlaneFailureCheck::valid);
        ASSERT_EQ(second.check, PlaneFailureCheck::valid);
        EXPECT_NEAR(first.base_water_force, second.base_water_force, rounding * 1e6);
        EXPECT_NEAR(first.crack_water_force, second.crack_water_force, rounding * 1e6);
        EXPECT_NEAR(first.factor_of_safety, second.factor_of_safety, rounding);
        EXPECT_NEAR(first.normal_force_position, second.normal_force_position, 10 * rounding);
    };
    compare(CrackAndBaseWater<>{gamma, WaterDepth<>{3}}, {{{0, gamma * 3}, {3 / z, 0}}, {{0, 0}, {1, gamma * 3}}});
    compare(CrackOnlyWater<>{gamma, FilledRatio<>{0.5}}, {{{0, gamma * z / 2}, {0.5, 0}}, {}});
    compare(BasePeakMidHeightWater<>{gamma, FilledRatio<>{0.8}}, {{}, {{0, 0}, {0.4, gamma * 0.4 * top}, {0.8, 0}}});
    compare(PeakAtToeWater<>{gamma, WaterDepth<>{top + 1}},
            {{{0, gamma}, {1 / z, 0}}, {{0, gamma * (top + 1)}, {1, gamma}}});
    compare(PeakAtToeWater<>{gamma, WaterDepth<>{top / 2}}, {{}, {{0, gamma * top / 2}, {0.5, 0}}});
    compare(PiezometricLineWater<>{gamma, {{0, top / 2}, {50, top / 2}}}, {{}, {{0, gamma * top / 2}, {0.5, 0}}});
}

TEST(WaterForms, LevelPiezometricLineIsPeakAtToe) {
    for (const double crack_dip : {90.0, 65.0, 120.0}) {
        for (const double level : {2.0, 7.0, 10.0, 11.9}) {
            PlaneFailure<> toe = textbook_slope();
            toe.tension_crack->dip = degrees(crack_dip);
            toe.slope.toe_elevation = 100;
            PlaneFailure<> line = toe;
            toe.water = PeakAtToeWater<>{9.81e3, WaterElevation<>{100 + level}};
            line.water = PiezometricLineWater<>{9.81e3, {{-5, level}, {3, level}, {7.5, level}, {60, level}}};
            EXPECT_NEAR(factor(toe), factor(line), 10 * rounding);  // 100 + level rounds by 1e-14
        }
    }
}

TEST(WaterForms, LevelAsDepthRatioAndElevation) {
    PlaneFailure<> problem = textbook_slope();
    problem.slope.toe_elevation = 500;
    const PlaneFailureResult dry = analyse(problem);
    problem.water = CrackAndBaseWater<>{9.81e3, WaterDepth<>{3}};
    const double by_depth = factor(problem);
    problem.water = CrackAndBaseWater<>{9.81e3, FilledRatio<>{3 / dry.crack_depth}};
    EXPECT_NEAR(factor(problem), by_depth, rounding);
    problem.water = CrackAndBaseWater<>{9.81e3, WaterElevation<>{500 + dry.crack_base_height + 3}};
    EXPECT_NEAR(factor(problem), by_depth, 1e-12);  // an elevation near 500 m is known to 6e-14 m
    problem.water = CrackAndBaseWater<>{9.81e3, WaterElevation<>{400}};
    problem.bolt.clear();
    EXPECT_EQ(factor(problem), factor(textbook_slope()));
}

// A crack and its water of the same depth must not be refused because of rounding.
TEST(WaterForms, BrimfulCrackIsAllowed) {
    for (int step = 0; step < 200; ++step) {
        PlaneFailure<> problem = textbook_slope();
        problem.tension_crack = TensionCrack<>{degrees(40.3 + 0.5 * step), CrackOfDepth<>{3.7}};
        problem.water = CrackAndBaseWater<>{9.81e3, WaterDepth<>{3.7}};
        EXPECT_EQ(factor_of_safety(problem).check, PlaneFailureCheck::valid) << step;
        problem.water = CrackAndBaseWater<>{9.81e3, WaterDepth<>{3.7 * (1 + 1e-9)}};
        EXPECT_EQ(factor_of_safety(problem).check, PlaneFailureCheck::water_above_crack) << step;
    }
}

// --- Loads ---

TEST(Loads, ActiveBoltIsALineLoadOfTheSameDirection) {
    for (const double plunge : {-30.0, -20.0, 0.0, 15.0, 55.0, 90.0}) {
        PlaneFailure<> bolt = textbook_slope();
        PlaneFailure<> load = textbook_slope();
        bolt.bolt = {{150e3, degrees(plunge), 3, BoltAction::active}};
        load.line_load = {{150e3, degrees(plunge), 2}};
        EXPECT_EQ(factor(bolt), factor(load));
    }
}

TEST(Loads, PassiveBoltAddsWhatAnActiveOneTakesAway) {
    PlaneFailure<> problem = textbook_slope();
    const PlaneFailureResult bare = analyse(problem);
    const double along = 150e3 * std::cos(degrees(35 + 10));
    const double across = 150e3 * std::sin(degrees(35 + 10));
    problem.bolt = {{150e3, degrees(10), 3, BoltAction::active}};
    const PlaneFailureResult active = analyse(problem);
    problem.bolt[0].action = BoltAction::passive;
    const PlaneFailureResult passive = analyse(problem);
    EXPECT_NEAR(active.driving_force, bare.driving_force - along, rounding * 1e6);
    EXPECT_NEAR(active.resisting_force, bare.resisting_force + across * std::tan(degrees(37)), rounding * 1e7);
    EXPECT_NEAR(passive.driving_force, bare.driving_force, rounding * 1e6);
    EXPECT_NEAR(passive.resisting_force, active.resisting_force + along, rounding * 1e7);
    // At FS = 1 the two ways of counting agree: a stable slope gains more from active bolts.
    EXPECT_GT(active.factor_of_safety, passive.factor_of_safety);
}

TEST(Loads, OnlyTheMassCarriesThem) {
    PlaneFailure<> whole = textbook_slope();
    PlaneFailure<> clipped = textbook_slope();
    whole.surcharge = {{20e3, 1, 4}};  // the crack is at 4 m
    clipped.surcharge = {{20e3, 1, 400}};
    EXPECT_NEAR(factor(whole), factor(clipped), rounding);
    clipped.surcharge = {{20e3, 4.001, 400}};
    EXPECT_EQ(factor(clipped), factor(textbook_slope()));
    clipped.surcharge.clear();
    clipped.line_load = {{20e3, degrees(90), 4.001}};
    EXPECT_EQ(factor(clipped), factor(textbook_slope()));
    clipped.line_load[0].distance_behind_crest = 3.999;
    EXPECT_NE(factor(clipped), factor(textbook_slope()));
    // Behind a crack in the face nothing stands on the mass.
    PlaneFailure<> face = textbook_slope();
    face.tension_crack = TensionCrack<>{degrees(90), CrackAtDistance<>{-1}};
    const double bare = factor(face);
    face.surcharge = {{20e3, 0, 100}};
    face.line_load = {{20e3, degrees(90), 0}};
    EXPECT_EQ(factor(face), bare);
}

TEST(Loads, UniformSurchargeIsTheWeightOfAsMuchRock) {
    PlaneFailure<> problem = textbook_slope();
    const PlaneFailureResult bare = analyse(problem);
    problem.surcharge = {{50e3, 0, 4}};
    const PlaneFailureResult loaded = analyse(problem);
    EXPECT_NEAR(loaded.driving_force, bare.driving_force + 200e3 * std::sin(degrees(35)), rounding * 1e7);
    EXPECT_NEAR(loaded.normal_force, bare.normal_force + 200e3 * std::cos(degrees(35)), rounding * 1e7);
}

// k_h and k_v turn and stretch gravity: a dry cohesionless mass then slides as on a plane steeper by the turn,
// FS = tan(phi) / tan(p + delta), tan(delta) = k_h / (1 + k_v); with cohesion the stretch divides it.
TEST(Loads, SeismicCoefficientsTiltGravity) {
    for (const double horizontal : {-0.2, 0.1, 0.4}) {
        for (const double vertical : {-0.3, 0.0, 0.25}) {
            PlaneFailure<> problem = textbook_slope();
            problem.seismic = SeismicLoad<>{horizontal, vertical};
            std::get<Coulomb<>>(problem.strength).cohesion = 0;
            const double turn = std::atan2(horizontal, 1 + vertical);
            EXPECT_NEAR(factor(problem), std::tan(degrees(37)) / std::tan(degrees(35) + turn), 10 * rounding);
        }
    }
    PlaneFailure<> heavier = textbook_slope();
    heavier.seismic = SeismicLoad<>{0, 1};
    PlaneFailure<> weaker = textbook_slope();
    std::get<Coulomb<>>(weaker.strength).cohesion /= 2;
    EXPECT_NEAR(factor(heavier), factor(weaker), rounding);
}

// --- Strength laws ---

double with_strength(const StrengthLaw<>& law) {
    PlaneFailure<> problem = textbook_with_water(3);
    problem.strength = law;
    return factor(problem);
}

TEST(Strength, SteppedSurfaceIsCoulombAtPhiPlusI) {
    EXPECT_EQ(with_strength(SteppedSurface<>{5e3, degrees(20), degrees(17)}),
              with_strength(Coulomb<>{5e3, degrees(20) + degrees(17)}));
}

TEST(Strength, PowerCurveOfExponentOneIsCoulomb) {
    // tau = c + a (sigma + d).
    EXPECT_NEAR(with_strength(PowerCurve<>{0.7, 1, 123e3, 10e3, 5e3}), with_strength(Coulomb<>{12e3, std::atan(0.7)}),
                rounding);
}

TEST(Strength, PattonIsContinuousAndBilinear) {
    const PlaneFailureResult result = analyse(textbook_with_water(3));
    const double stress = result.normal_force / result.sliding_area;
    const auto patton = [](double transition) {
        return with_strength(PattonBilinear<>{degrees(25), degrees(15), transition});
    };
    EXPECT_NEAR(patton(stress * (1 - 1e-12)), patton(stress * (1 + 1e-12)), 1e-11);
    EXPECT_EQ(patton(2 * stress), with_strength(Coulomb<>{0, degrees(25) + degrees(15)}));
    const double half = stress / 2 * (std::tan(degrees(40)) - std::tan(degrees(25)));
    EXPECT_NEAR(patton(stress / 2), with_strength(Coulomb<>{half, degrees(25)}), rounding);
    EXPECT_EQ(patton(0), with_strength(Coulomb<>{0, degrees(25)}));
}

TEST(Strength, BartonBandisWithItsCaps) {
    const PlaneFailureResult result = analyse(textbook_with_water(3));
    const double stress = result.normal_force / result.sliding_area;
    const auto barton = [](double jrc, double jcs) { return with_strength(BartonBandis<>{degrees(28), jrc, jcs}); };
    const auto friction = [](double degree) { return with_strength(Coulomb<>{0, degrees(degree)}); };
    EXPECT_NEAR(barton(10, 100 * stress), friction(28 + 10 * 2), rounding);  // two decades
    EXPECT_NEAR(barton(10, 0.1 * stress), friction(28), rounding);           // not below the residual angle
    EXPECT_NEAR(barton(20, 1e4 * stress), friction(70), rounding);           // 28 + 80 is held at 70
    EXPECT_NEAR(barton(0, 1e4 * stress), friction(28), rounding);
}

// A bolt under the mass, and one that runs out of the ground behind the crest before it meets the crack, hold nothing.
TEST(Bolts, HoldOnlyWhereTheyCrossTheSurfaceInTheGround) {
    PlaneFailure<> problem = textbook_slope();
    problem.failure_plane.daylight_height = 4;
    const double bare = factor(problem);
    problem.bolt = {{5e5, degrees(10), 2, BoltAction::active}, {5e5, degrees(-80), 11, BoltAction::active}};
    EXPECT_EQ(factor(problem), bare);
    EXPECT_EQ(bolts_that_hold_nothing(problem), (std::vector<std::size_t>{0, 1}));
    problem.bolt = {{5e5, degrees(10), 6, BoltAction::active}};
    EXPECT_GT(factor(problem), 1.1 * bare);
    EXPECT_TRUE(bolts_that_hold_nothing(problem).empty());
}

TEST(Strength, TensionCutOff) {
    PlaneFailure<> problem = textbook_slope();
    problem.seismic = SeismicLoad<>{3, 0};  // lifts the mass off: N negative
    const PlaneFailureResult lifted = analyse(problem);
    ASSERT_LT(lifted.normal_force, 0);
    EXPECT_EQ(lifted.outcome, PlaneFailureOutcome::lifts_off);
    const double tension = -lifted.normal_force / lifted.sliding_area;
    EXPECT_EQ(lifted.factor_of_safety, 0);
    std::get<Coulomb<>>(problem.strength).cohesion = 2 * tension;
    EXPECT_EQ(factor(problem), 0) << "cohesion bears no tension";
    problem.tension_cutoff = TensionCutoff<>{tension * (1 + 1e-9)};
    EXPECT_GT(factor(problem), 0);
    problem.tension_cutoff = TensionCutoff<>{tension * (1 - 1e-9)};
    EXPECT_EQ(factor(problem), 0);
    // The envelope itself ends at zero.
    problem.tension_cutoff = TensionCutoff<>{2 * tension};
    std::get<Coulomb<>>(problem.strength).cohesion = tension * std::tan(degrees(37)) * 0.999;
    EXPECT_EQ(factor(problem), 0);
}

// --- Profiles ---

TEST(Profile, AfterFailure) {
    PlaneFailure<> problem = textbook_slope();
    const Polyline behind = profile_after_failure(problem);
    ASSERT_EQ(behind.size(), 4U);
    EXPECT_EQ(behind[0], Point(0, 0));
    const double x = 12 / std::tan(degrees(60)) + 4;
    EXPECT_NEAR(behind[1].x(), x, rounding * 10);
    EXPECT_NEAR(behind[1].y(), x * std::tan(degrees(35)), rounding * 10);
    EXPECT_NEAR(behind[2].x(), x, rounding * 10);
    EXPECT_NEAR(behind[2].y(), 12, rounding * 10);
    EXPECT_GT(behind[3].x(), x);
    EXPECT_NEAR(behind[3].y(), 12, rounding * 10);

    problem.failure_plane.daylight_height = 2;
    problem.tension_crack = TensionCrack<>{degrees(90), CrackAtDistance<>{-2}};
    const Polyline face = profile_after_failure(problem);
    ASSERT_EQ(face.size(), 6U);  // toe, daylight, base, top, crest, end
    EXPECT_NEAR(face[1].y(), 2, rounding * 10);
    EXPECT_NEAR(face[3].y(), 12 - 2 * std::tan(degrees(60)), rounding * 100);
    EXPECT_NEAR(face[4].y(), 12, rounding * 10);

    problem.tension_crack = TensionCrack<>{degrees(30), CrackAtDistance<>{-2}};
    EXPECT_TRUE(profile_after_failure(problem).empty());
}

// --- The view of the loops ---

TEST(Interface, PredictsWhatAnalyseFinds) {
    PlaneFailureStudy<> study{textbook_with_water(3), {}, {}};
    study.model.slope.toe_elevation = 50;
    const ModelInterface model = model_interface(study);
    const auto index_of = [](const std::vector<Quantity>& quantities, std::string_view name) {
        std::size_t index = 0;
        while (index < quantities.size() && quantities[index].name != name) {
            ++index;
        }
        return index;
    };
    const std::size_t friction = index_of(model.inputs, "strength.friction_angle");
    ASSERT_LT(friction, model.inputs.size());
    const std::vector<Assignment> assignments = {{friction, degrees(30)}};
    const Prediction prediction = model.predict(assignments);
    ASSERT_TRUE(prediction.failure.empty());
    ASSERT_EQ(prediction.outputs.size(), model.outputs.size());
    std::get<Coulomb<>>(study.model.strength).friction_angle = degrees(30);
    const PlaneFailureResult result = analyse(study.model);
    EXPECT_EQ(prediction.outputs[index_of(model.outputs, "factor_of_safety")], result.factor_of_safety);
    EXPECT_EQ(prediction.outputs[index_of(model.outputs, "crack_base_elevation")], 50 + result.crack_base_height);
    EXPECT_EQ(prediction.profile.size(), 4U);
    const std::vector<Assignment> outside = {{friction, degrees(95)}};
    EXPECT_EQ(model.predict(outside).failure, "input_out_of_range");
}

}  // namespace
}  // namespace delabole
