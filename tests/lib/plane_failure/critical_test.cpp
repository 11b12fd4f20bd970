// Critical geometry, required values and optimum bolts against closed forms, published numbers and brute force.
#include "plane_failure/critical.hpp"
#include "numerics/scalar_search.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/required.hpp"
#include "tests/lib/plane_failure/closed_forms.hpp"
#include "tests/lib/plane_failure/critical_searches.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace delabole {
namespace {

constexpr CriticalSearch<> both_search = {CriticalFeature::both, SearchCondition::given_water, {}, {}};

// --- Crack ---

TEST(CriticalCrack, DryClosedForm) {
    for (const double face : {45.0, 60.0, 75.0, 89.0}) {
        for (const double plane : {20.0, 35.0, 42.0}) {
            PlaneFailure<> problem = textbook_slope();
            problem.slope.face_dip = degrees(face);
            problem.failure_plane.dip = degrees(plane);
            const CriticalGeometry critical = find_critical_geometry(problem, crack_search);
            ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
            EXPECT_FALSE(critical.at_boundary);
            const PlaneFailureResult result = analyse(critical.problem);
            // A root of the slope: good to rounding over the slope's own slope, far better than 1e-10 of the height.
            EXPECT_NEAR(result.crack_depth / 12, closed_form::critical_crack_depth_ratio(degrees(face), degrees(plane)),
                        1e-10);
            EXPECT_NEAR(result.crack_distance_behind_crest / 12,
                        closed_form::critical_crack_distance_ratio(degrees(face), degrees(plane)), 1e-10);
            EXPECT_EQ(result.factor_of_safety, critical.factor_of_safety);
        }
    }
}

TEST(CriticalCrack, ClosedFormAgreesWithTheSearch) {
    for (const double crack_dip : {65.0, 75.0, 90.0, 110.0}) {
        for (const double plane_dip : {20.0, 35.0, 50.0}) {
            PlaneFailure<> level = textbook_slope();
            level.water = Dry{};
            level.failure_plane.dip = degrees(plane_dip);
            level.tension_crack->dip = degrees(crack_dip);
            PlaneFailure<> tilted = level;
            tilted.slope.upper_surface_dip = 1e-12;  // the closed form is for level ground only: this one is searched
            const CriticalSearch<> crack{CriticalFeature::tension_crack, SearchCondition::dry_slope, {}, {}};
            const CriticalGeometry closed = find_critical_geometry(level, crack);
            const CriticalGeometry searched = find_critical_geometry(tilted, crack);
            ASSERT_EQ(closed.check, PlaneFailureCheck::valid);
            EXPECT_LT(closed.evaluations, searched.evaluations);
            EXPECT_NEAR(closed.factor_of_safety, searched.factor_of_safety, 1e-10);  // the tilt, times 100 at most
            const auto base = [](const CriticalGeometry& geometry) {
                return std::get<CrackBaseBelowCrest<>>(geometry.problem.tension_crack->position).base_below_crest;
            };
            EXPECT_NEAR(base(closed), base(searched), 1e-8) << crack_dip << " " << plane_dip;  // m, of 12
        }
    }
}

TEST(CriticalCrack, SauMauPing) {
    PlaneFailure<> problem = textbook_slope();
    problem.slope = {60, degrees(50), 0, {}, {}};
    const CriticalGeometry critical = find_critical_geometry(problem, crack_search);
    ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
    EXPECT_NEAR(analyse(critical.problem).crack_depth, 14.01, 0.005);  // half a unit of the last printed digit
}

TEST(CriticalCrack, DryConditionIgnoresTheWaterButKeepsIt) {
    PlaneFailure<> problem = textbook_slope();
    problem.water = CrackAndBaseWater<>{9.81e3, FilledRatio<>{1}};
    problem.pond = Pond<>{1, 9.81e3};
    const CriticalGeometry dry =
        find_critical_geometry(problem, {CriticalFeature::tension_crack, SearchCondition::dry_slope, {}, {}});
    ASSERT_EQ(dry.check, PlaneFailureCheck::valid);
    EXPECT_NEAR(analyse(dry.problem).crack_depth / 12,
                closed_form::critical_crack_depth_ratio(degrees(60), degrees(35)), 1e-10);
    EXPECT_TRUE(dry.problem.pond.has_value());
    EXPECT_EQ(dry.problem.water.index(), problem.water.index());
}

double least_on_grid(PlaneFailure<> problem, int points) {
    const double outcrop = 12.0;  // level ground: the highest base is at the crest's level
    double least = std::numeric_limits<double>::infinity();
    for (int index = 1; index <= points; ++index) {
        problem.tension_crack->position = CrackBaseBelowCrest<>{12 - outcrop * index / points};
        const FactorOfSafety result = factor_of_safety(problem);
        if (result.check == PlaneFailureCheck::valid) {
            least = std::min(least, result.value);
        }
    }
    return least;
}

TEST(CriticalCrack, WaterAgainstBruteForce) {
    for (const double crack_dip : {90.0, 70.0, 110.0}) {
        for (const double filled : {0.2, 0.5, 0.9, 1.0}) {
            for (const double cohesion : {5e3, 25e3, 100e3}) {
                PlaneFailure<> problem = textbook_slope();
                problem.tension_cutoff = TensionCutoff<>{1e12};  // as much as the search lets the plane bear
                problem.tension_crack->dip = degrees(crack_dip);
                problem.strength = Coulomb<>{cohesion, degrees(37)};
                problem.water = CrackAndBaseWater<>{9.81e3, FilledRatio<>{filled}};
                const CriticalGeometry critical = find_critical_geometry(problem, crack_search);
                ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
                const double grid = least_on_grid(problem, 20000);
                EXPECT_LE(critical.factor_of_safety, grid + 1e-12);  // rounding of two evaluations
                // The minimum is half a step of the grid away, and the factor is at most this curved there.
                EXPECT_NEAR(critical.factor_of_safety, grid, 1e-4 * (1 + grid));
            }
        }
    }
}

// A depth of water larger than the crack has no answer: the least factor lies where the crack is just full.
TEST(CriticalCrack, EndOfTheValuesIsFound) {
    PlaneFailure<> problem = textbook_slope();
    problem.strength = Coulomb<>{5e3, degrees(37)};
    problem.water = CrackAndBaseWater<>{9.81e3, WaterDepth<>{6.5}};
    const CriticalGeometry critical = find_critical_geometry(problem, crack_search);
    ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
    const double grid = least_on_grid(problem, 200000);
    EXPECT_LE(critical.factor_of_safety, grid + 1e-12);
    EXPECT_NEAR(critical.factor_of_safety, grid, 1e-4);  // one step of 0.06 mm times the slope there
}

TEST(CriticalCrack, BoundaryIsFlagged) {
    // Without cohesion all masses behind a crack in the face are similar: the factor is constant, no worse than a grid.
    PlaneFailure<> problem = textbook_slope();
    problem.strength = Coulomb<>{0, degrees(37)};
    problem.water = CrackOnlyWater<>{9.81e3, FilledRatio<>{1}};
    const CriticalGeometry critical = find_critical_geometry(problem, crack_search);
    ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
    EXPECT_LE(critical.factor_of_safety, least_on_grid(problem, 2000) + 1e-12);
    PlaneFailure<> dry = textbook_slope();
    EXPECT_FALSE(find_critical_geometry(dry, crack_search).at_boundary);
    dry.tension_crack.reset();
    const CriticalGeometry narrow = find_critical_geometry(
        dry, {CriticalFeature::failure_plane, SearchCondition::given_water, degrees(50), degrees(52)});
    ASSERT_EQ(narrow.check, PlaneFailureCheck::valid);
    EXPECT_TRUE(narrow.at_boundary);
    EXPECT_EQ(find_critical_geometry(
                  dry, {CriticalFeature::failure_plane, SearchCondition::given_water, degrees(52), degrees(50)})
                  .check,
              PlaneFailureCheck::mass_vanishes);
}

// --- Plane ---

// Culmann: the bisector of face and friction angle is the plane that needs the most cohesion for FS = 1; at other
// cohesions the plane of least factor of safety is another, closer to the face where there is less cohesion.
TEST(CriticalPlane, UncrackedClosedForm) {
    for (const double face : {50.0, 70.0, 89.0}) {
        for (const double cohesion : {2e3, 25e3, 200e3}) {
            PlaneFailure<> problem = textbook_slope();
            problem.slope.face_dip = degrees(face);
            problem.tension_crack.reset();
            problem.strength = Coulomb<>{cohesion, degrees(30)};
            const CriticalGeometry critical = find_critical_geometry(problem, plane_search);
            ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
            EXPECT_FALSE(critical.at_boundary);
            const double dip = closed_form::critical_plane_dip(26e3, 12.0, degrees(face), cohesion, degrees(30));
            const double factor =
                closed_form::critical_plane_factor_of_safety(26e3, 12.0, degrees(face), cohesion, degrees(30));
            EXPECT_NEAR(critical.problem.failure_plane.dip, dip, 1e-10);
            EXPECT_NEAR(critical.factor_of_safety / factor, 1, 1e-13);  // a smooth minimum, rounding only
            // The bisector with the friction mobilised is the same plane.
            const double mobilised = std::atan(std::tan(degrees(30)) / factor);
            EXPECT_NEAR(closed_form::critical_plane_dip(degrees(face), mobilised), dip, 1e-12);
            // With the full friction angle it is not, except at FS = 1.
            const double full = closed_form::critical_plane_dip(degrees(face), degrees(30));
            EXPECT_EQ(std::abs(full - dip) < degrees(0.5), std::abs(factor - 1) < 0.05) << factor;
            // And it is the least of a fine grid.
            for (int index = 1; index < 1000; ++index) {
                problem.failure_plane.dip = degrees(face) * index / 1000;
                const FactorOfSafety other = factor_of_safety(problem);
                if (other.check == PlaneFailureCheck::valid) {
                    EXPECT_GE(other.value, factor * (1 - 1e-13));
                }
            }
        }
    }
}

TEST(CriticalPlane, FrictionAloneGoesToTheSteepestPlane) {
    PlaneFailure<> problem = textbook_slope();
    problem.tension_crack.reset();
    problem.strength = Coulomb<>{0, degrees(30)};
    const CriticalGeometry critical = find_critical_geometry(problem, plane_search);
    ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
    EXPECT_TRUE(critical.at_boundary);
    EXPECT_NEAR(critical.problem.failure_plane.dip, degrees(60 - 0.01), 1e-12);
}

TEST(CriticalBoth, AgainstBruteForce) {
    for (const double filled : {0.0, 0.5, 1.0}) {
        for (const double cohesion : {10e3, 50e3}) {
            PlaneFailure<> problem = textbook_slope();
            problem.tension_cutoff = TensionCutoff<>{1e12};  // as much as the search lets the plane bear
            problem.slope.face_dip = degrees(75);
            problem.strength = Coulomb<>{cohesion, degrees(30)};
            problem.water = CrackAndBaseWater<>{9.81e3, FilledRatio<>{filled}};
            const CriticalGeometry critical = find_critical_geometry(problem, both_search);
            ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
            double grid = std::numeric_limits<double>::infinity();
            for (int index = 1; index < 400; ++index) {
                problem.failure_plane.dip = degrees(1) + (degrees(74.99) - degrees(1)) * index / 400;
                grid = std::min(grid, least_on_grid(problem, 400));
            }
            EXPECT_LE(critical.factor_of_safety, grid + 1e-12) << filled << " " << cohesion;
            EXPECT_NEAR(critical.factor_of_safety, grid, 1e-2 * (1 + grid));  // the grid is 0.2 deg and 3 cm wide
        }
    }
}

// --- Scalar searches ---

TEST(ScalarSearch, KinkJumpAndGap) {
    const auto kink = minimise_scalar([](double x) { return std::abs(x - 0.3); },
                                      [](double x) { return x < 0.3 ? -1.0 : 1.0; }, 0, 1, 11);
    EXPECT_NEAR(kink.position, 0.3, 1e-15);
    // The function falls to the left of a jump at 0.43; its slopes have one sign only.
    const auto jump =
        minimise_scalar([](double x) { return x < 0.43 ? -x : 1 - x; }, [](double) { return -1.0; }, 0, 0.9, 10);
    EXPECT_NEAR(jump.position, 0.43, 1e-12);
    EXPECT_FALSE(jump.at_boundary);
    // No values above 0.537.
    const double none = std::numeric_limits<double>::infinity();
    const auto gap = minimise_scalar([&](double x) { return x <= 0.537 ? -x : none; },
                                     [&](double x) { return x <= 0.537 ? -1.0 : none; }, 0, 1, 11);
    EXPECT_NEAR(gap.position, 0.537, 1e-15);
    EXPECT_TRUE(gap.at_boundary);
    // A hole between two finite ends of a bracket must not reach GSL, which would end the process.
    const auto hole = find_root([&](double x) { return x > 0.4 && x < 0.6 ? none : x - 0.5; }, {0, 1});
    EXPECT_FALSE(hole.position.has_value());
    EXPECT_EQ(hole.sign_changes, 0);
    // A jump over zero is no root, a steep passage is one.
    EXPECT_FALSE(find_root([](double x) { return x < 0.43 ? -1.0 : 2.0; }, {0, 1}).position.has_value());
    EXPECT_FALSE(find_root([](double x) { return x < 0.43 ? -1e3 : x; }, {0, 1}).position.has_value());
    const auto beside_a_pole = find_root([](double x) { return x < 0.43 ? -1.0 : 1 / (0.9 + 1e-13 - x); }, {0, 0.9});
    EXPECT_FALSE(beside_a_pole.position.has_value());
    EXPECT_NEAR(*beside_a_pole.jump, 0.43, 1e-12);
    const auto steep = find_root([](double x) { return std::tanh(1e8 * (x - 0.43)); }, {0, 1});
    ASSERT_TRUE(steep.position.has_value());
    EXPECT_NEAR(*steep.position, 0.43, 1e-15);
    EXPECT_TRUE(steep.rises);
}

// --- Required values ---

PlaneFailure<> wet_slope() {
    PlaneFailure<> problem = textbook_slope();
    problem.water = CrackAndBaseWater<>{9.81e3, WaterDepth<>{3}};
    return problem;
}

TEST(RequiredValue, CohesionAndFriction) {
    const PlaneFailure<> problem = wet_slope();
    const PlaneFailureResult result = analyse(problem);
    for (const double target : {0.9, 1.0, 1.5}) {
        const double cohesion =
            (target * result.driving_force - result.normal_force * std::tan(degrees(37))) / result.sliding_area;
        const Required found = required_value({problem, {}, {}}, "strength.cohesion", target);
        ASSERT_EQ(found.status, RequiredStatus::found);
        EXPECT_NEAR(found.value / cohesion, 1, 1e-12);  // the difference cancels to a tenth
        const double friction =
            std::atan((target * result.driving_force - 25e3 * result.sliding_area) / result.normal_force);
        EXPECT_NEAR(required_value({problem, {}, {}}, "strength.friction_angle", target).value / friction, 1, 1e-12);
    }
}

// c A + (W cos p - u z - v z^2 sin p) t = F (W sin p + v z^2 cos p): a quadratic in the depth of water.
TEST(RequiredValue, WaterDepth) {
    const PlaneFailure<> problem = wet_slope();
    const PlaneFailureResult result = analyse(problem);
    const double s = std::sin(degrees(35));
    const double c = std::cos(degrees(35));
    const double t = std::tan(degrees(37));
    const double u = 9.81e3 * result.sliding_area / 2;
    const double v = 9.81e3 / 2;
    const double qa = v * (s * t + 1.2 * c);
    const double qb = u * t;
    const double qc = 1.2 * result.weight * s - 25e3 * result.sliding_area - result.weight * c * t;
    const double depth = (-qb + std::sqrt(qb * qb - 4 * qa * qc)) / (2 * qa);
    const Required found = required_value({problem, {}, {}}, "water.water_depth", 1.2);
    ASSERT_EQ(found.status, RequiredStatus::found);
    EXPECT_NEAR(found.value, depth, 1e-12);
    EXPECT_EQ(found.dimension, Dimension::length);
    // Down to 0.9 the crack does not hold enough water.
    const Required never = required_value({problem, {}, {}}, "water.water_depth", 0.9);
    EXPECT_EQ(never.status, RequiredStatus::always_exceeded);
    PlaneFailure<> full = problem;
    full.water = CrackAndBaseWater<>{9.81e3, FilledRatio<>{1}};
    EXPECT_NEAR(never.lowest_factor_of_safety, factor_of_safety(full).value, 1e-9);  // the edge is bisected
    EXPECT_NEAR(never.highest_factor_of_safety, factor_of_safety(textbook_slope()).value, 1e-12);
}

TEST(RequiredValue, BoltForce) {
    PlaneFailure<> problem = wet_slope();
    problem.bolt = {{1e3, degrees(10), 5, BoltAction::active}};
    PlaneFailure<> bare = problem;
    bare.bolt.clear();
    const PlaneFailureResult result = analyse(bare);
    const double t = std::tan(degrees(37));
    // R0 + T sin t = F (S0 - T cos).
    const double force = (1.5 * result.driving_force - result.resisting_force) /
                         (std::sin(degrees(45)) * t + 1.5 * std::cos(degrees(45)));
    const Required found = required_value({problem, {}, {}}, "bolt[1].force", 1.5);
    ASSERT_EQ(found.status, RequiredStatus::found);
    EXPECT_NEAR(found.value / force, 1, 1e-12);
    EXPECT_EQ(required_value({problem, {}, {}}, "bolt[2].force", 1.5).status, RequiredStatus::unknown_parameter);
}

// An elevation has answers only between toe and crest; far above zero the search must still find them.
TEST(RequiredValue, ElevationsFarFromZero) {
    PlaneFailure<> problem = textbook_slope();
    problem.slope.toe_elevation = 4321;
    problem.tension_crack->position = CrackBaseElevation<>{4321 + 7.0};
    const double low = factor_of_safety(problem).value;
    problem.tension_crack->position = CrackBaseElevation<>{4321 + 8.0};
    const double high = factor_of_safety(problem).value;
    problem.tension_crack->position = CrackBaseElevation<>{4321 + 9.0};
    const double target = (low + high) / 2;
    const Required found = required_value({problem, {}, {}}, "tension_crack.base_elevation", target);
    ASSERT_TRUE(found.status == RequiredStatus::found || found.status == RequiredStatus::several);
    problem.tension_crack->position = CrackBaseElevation<>{found.value};
    EXPECT_NEAR(factor_of_safety(problem).value, target, 1e-9);  // an elevation of 4 km is known to 1e-12 m
}

// The factor falls and rises again as the crack moves: two cracks give 5 % above the least, the smaller is returned.
TEST(RequiredValue, SeveralRoots) {
    PlaneFailure<> problem = textbook_slope();
    const CriticalGeometry critical = find_critical_geometry(problem, crack_search);
    const double position = analyse(critical.problem).crack_distance_behind_crest;
    const Required found =
        required_value({problem, {}, {}}, "tension_crack.distance_behind_crest", 1.01 * critical.factor_of_safety);
    EXPECT_EQ(found.status, RequiredStatus::several);
    EXPECT_LT(found.value, position);
    problem.tension_crack->position = CrackAtDistance<>{found.value};
    EXPECT_NEAR(factor_of_safety(problem).value, 1.01 * critical.factor_of_safety, 1e-12);
}

// With the crack of the slope without bolts, 13.4 m behind the crest, 2593 kN/m were said to be enough: 1.43.
TEST(RequiredValue, HoldsTheCriticalCrackOfItsOwnValue) {
    PlaneFailure<> problem = textbook_slope();
    problem.slope.upper_surface_dip = degrees(8);
    problem.water = CrackAndBaseWater<>{9.81e3, WaterDepth<>{3}};
    problem.bolt = {{1e5, degrees(10), 5, BoltAction::active}};
    PlaneFailureStudy<> study{
        problem, CriticalSearch<>{CriticalFeature::tension_crack, SearchCondition::given_water, {}, {}}, {}};
    const double before = analyse(resolve(study).problem).crack_distance_behind_crest;
    for (const std::string parameter : {"bolt[1].force", "strength.cohesion"}) {
        const Required found = required_value(study, parameter, 1.8);
        ASSERT_EQ(found.status, RequiredStatus::found) << parameter;
        PlaneFailureStudy<> again = study;
        (parameter == "strength.cohesion" ? std::get<Coulomb<>>(again.model.strength).cohesion
                                          : again.model.bolt[0].force) = found.value;
        const PlaneFailureResult result = analyse(resolve(again).problem);
        EXPECT_NEAR(result.factor_of_safety, 1.8, 1e-9) << parameter;
        EXPECT_GT(std::abs(result.crack_distance_behind_crest - before), 0.1) << "the crack has moved";
    }
}

// --- Optimum bolt ---

TEST(OptimumBoltPlunge, AgainstAFineGrid) {
    for (const BoltAction action : {BoltAction::active, BoltAction::passive}) {
        for (const double force : {50e3, 400e3}) {
            PlaneFailure<> problem = wet_slope();
            problem.bolt = {{force, 0, 5, action}};
            const OptimumBolt optimum = optimum_bolt_plunge(problem);
            double best = 0;
            for (int index = 0; index <= 12500; ++index) {
                problem.bolt[0].plunge = degrees(-35 + 0.01 * index);
                best = std::max(best, factor_of_safety(problem).value);
            }
            EXPECT_GE(optimum.factor_of_safety, best - 1e-13);
            EXPECT_NEAR(optimum.factor_of_safety, best, 1e-7);  // half of 0.01 deg squared
            if (action == BoltAction::active) {
                EXPECT_NEAR(std::tan(optimum.plunge + degrees(35)), std::tan(degrees(37)) / optimum.factor_of_safety,
                            1e-12);
            } else {
                EXPECT_NEAR(optimum.plunge, degrees(37 - 35), 1e-12);  // R + T (cos + sin tan phi): the friction angle
            }
        }
    }
}

TEST(OptimumBoltPlunge, WithoutABoltOrWithOneThatHoldsEverything) {
    EXPECT_EQ(optimum_bolt_plunge(textbook_slope()).factor_of_safety, 0);
    PlaneFailure<> problem = textbook_slope();
    problem.bolt = {{1e9, 0, 5, BoltAction::active}};
    EXPECT_TRUE(std::isinf(optimum_bolt_plunge(problem).factor_of_safety));
}

}  // namespace
}  // namespace delabole
