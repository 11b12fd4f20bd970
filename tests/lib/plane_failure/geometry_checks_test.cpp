// Every named refusal of the plane-failure model, and nothing unnamed: no NaN, no hang, no answer for a mass that is
// not there.
#include "plane_failure/critical.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/required.hpp"
#include "plane_failure/sensitivity.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>

namespace delabole {
namespace {

using Check = PlaneFailureCheck;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// Returns the check by analyse and factor_of_safety of the textbook slope after a change.
template <class Change>
Check after(Change change) {
    PlaneFailure<> problem = textbook_slope();
    change(problem);
    const Check check = analyse(problem).check;
    EXPECT_EQ(factor_of_safety(problem).check, check);
    if (check != Check::valid) {
        EXPECT_TRUE(std::isnan(factor_of_safety(problem).value));
        EXPECT_EQ(sensitivities(problem).check, check);
        EXPECT_TRUE(sensitivities(problem).derivatives.empty());
    }
    return check;
}

TensionCrack<> crack(double dip_degrees, CrackPosition<> position) {
    return {degrees(dip_degrees), position};
}

TEST(Checks, PlaneDoesNotDaylight) {
    EXPECT_EQ(after([](auto& p) { p.failure_plane.dip = degrees(61); }), Check::plane_does_not_daylight);
    EXPECT_EQ(after([](auto& p) { p.failure_plane.dip = p.slope.face_dip; }), Check::plane_does_not_daylight);
    EXPECT_EQ(after([](auto& p) {
                  p.tension_crack->position = CrackOfDepth<>{0};
                  p.failure_plane.dip = std::nextafter(p.slope.face_dip, 0);
              }),
              Check::valid);
}

TEST(Checks, PlaneDaylightsAboveCrest) {
    EXPECT_EQ(after([](auto& p) { p.failure_plane.daylight_height = 12; }), Check::plane_daylights_above_crest);
    EXPECT_EQ(after([](auto& p) { p.failure_plane.daylight_height = 13; }), Check::plane_daylights_above_crest);
}

TEST(Checks, PlaneNeverSurfaces) {
    EXPECT_EQ(after([](auto& p) {
                  p.tension_crack.reset();
                  p.slope.upper_surface_dip = degrees(35);
              }),
              Check::plane_never_surfaces);
    // On the same ground a crack bounds a mass.
    EXPECT_EQ(after([](auto& p) { p.slope.upper_surface_dip = degrees(50); }), Check::valid);
}

TEST(Checks, CrackFlatterThanPlane) {
    EXPECT_EQ(after([](auto& p) { p.tension_crack->dip = degrees(34); }), Check::crack_flatter_than_plane);
    EXPECT_EQ(after([](auto& p) { p.tension_crack->dip = p.failure_plane.dip; }), Check::crack_flatter_than_plane);
}

TEST(Checks, CrackBelowPlane) {
    // The plane surfaces 10.2 m behind the crest.
    EXPECT_EQ(after([](auto& p) { p.tension_crack = crack(90, CrackAtDistance<>{10.3}); }), Check::crack_below_plane);
    EXPECT_EQ(after([](auto& p) { p.tension_crack = crack(90, CrackBaseBelowCrest<>{-0.1}); }),
              Check::crack_below_plane);
}

// The bench falls below the plane, the ground behind rises above it again: two masses, whatever places the crack.
TEST(Checks, MassCutInTwoByTheBench) {
    const auto cut_in_two = [](CrackPosition<> position) {
        return after([&](auto& p) {
            p.slope.bench = Bench<>{6, degrees(-40)};
            p.slope.upper_surface_dip = degrees(80);
            p.slope.toe_elevation = 0;
            p.tension_crack = crack(90, position);
        });
    };
    EXPECT_EQ(cut_in_two(CrackAtDistance<>{12}), Check::crack_below_plane);
    EXPECT_EQ(cut_in_two(CrackOfDepth<>{8}), Check::crack_below_plane);  // deeper than at the crest
    EXPECT_EQ(cut_in_two(CrackBaseBelowCrest<>{-1.2}), Check::crack_below_plane);
    EXPECT_EQ(cut_in_two(CrackBaseElevation<>{13.2}), Check::crack_below_plane);
}

TEST(Checks, CrackBaseBelowDaylight) {
    EXPECT_EQ(after([](auto& p) { p.tension_crack = crack(90, CrackAtDistance<>{-7}); }),
              Check::crack_base_below_daylight);
    EXPECT_EQ(after([](auto& p) { p.tension_crack = crack(90, CrackBaseBelowCrest<>{12}); }),
              Check::crack_base_below_daylight);
    // A flat crack far up meets the plane in front of the slope.
    EXPECT_EQ(after([](auto& p) { p.tension_crack = crack(40, CrackAtDistance<>{1}); }),
              Check::crack_base_below_daylight);
    // A crack in the face that is no steeper than the face dips out of the rock.
    EXPECT_EQ(after([](auto& p) { p.tension_crack = crack(50, CrackAtDistance<>{-1}); }),
              Check::crack_base_below_daylight);
}

TEST(Checks, CrackDeeperThanMass) {
    EXPECT_EQ(after([](auto& p) { p.tension_crack = crack(90, CrackOfDepth<>{7.2}); }), Check::crack_deeper_than_mass);
    EXPECT_EQ(after([](auto& p) { p.tension_crack = crack(90, CrackOfDepth<>{7.1}); }), Check::valid);
}

TEST(Checks, CrackNeverSurfaces) {
    // From a base under the crest the crack rises more flatly than the ground behind it.
    EXPECT_EQ(after([](auto& p) {
                  p.slope.upper_surface_dip = degrees(55);
                  p.tension_crack = crack(50, CrackBaseBelowCrest<>{1});
              }),
              Check::crack_never_surfaces);
}

// A crack given by its top or depth is a line; where it leaves the rock on its way down it is no crack.
TEST(Checks, CrackThroughAir) {
    // Ground falling into the slope more steeply than the overhanging crack.
    const auto falling = [](CrackPosition<> position) {
        return after([&](auto& p) {
            p.slope.upper_surface_dip = degrees(-55);
            p.tension_crack = crack(140, position);
        });
    };
    EXPECT_EQ(falling(CrackAtDistance<>{1}), Check::crack_never_surfaces);
    EXPECT_EQ(falling(CrackOfDepth<>{3}), Check::crack_never_surfaces);
    EXPECT_EQ(after([](auto& p) {
                  p.slope.upper_surface_dip = degrees(-30);
                  p.tension_crack = crack(140, CrackAtDistance<>{1});
              }),
              Check::valid);
    // A crack from the steep upper surface that comes out of it above the bench.
    EXPECT_EQ(after([](auto& p) {
                  p.slope.bench = Bench<>{20, degrees(30)};
                  p.slope.upper_surface_dip = degrees(80);
                  p.tension_crack = crack(60, CrackAtDistance<>{21});
              }),
              Check::crack_never_surfaces);
    EXPECT_EQ(after([](auto& p) {
                  p.slope.bench = Bench<>{20, degrees(30)};
                  p.slope.upper_surface_dip = degrees(80);
                  p.tension_crack = crack(85, CrackAtDistance<>{21});
              }),
              Check::valid);
}

TEST(Checks, MassVanishes) {
    // The mass is so small that its area underflows.
    EXPECT_EQ(after([](auto& p) {
                  p.slope.height = 1e-170;
                  p.tension_crack = crack(90, CrackOfDepth<>{0});
              }),
              Check::mass_vanishes);
}

TEST(Checks, WaterNeedsCrack) {
    for (const Water<>& water :
         {Water<>(CrackAndBaseWater<>{9810, FilledRatio<>{0.5}}), Water<>(CrackOnlyWater<>{9810, WaterDepth<>{0}}),
          Water<>(CustomWater<>{{{0, 1}, {1, 0}}, {}})}) {
        EXPECT_EQ(after([&](auto& p) {
                      p.tension_crack.reset();
                      p.water = water;
                  }),
                  Check::water_needs_crack);
    }
}

TEST(Checks, WaterAboveCrack) {
    for (const Water<>& water :
         {Water<>(CrackAndBaseWater<>{9810, WaterDepth<>{4.4}}), Water<>(CrackOnlyWater<>{9810, WaterDepth<>{4.4}}),
          Water<>(BasePeakMidHeightWater<>{9810, WaterDepth<>{7.7}}),
          Water<>(PeakAtToeWater<>{9810, WaterDepth<>{12.1}}),
          Water<>(PeakAtToeWater<>{9810, WaterElevation<>{12.1}})}) {
        EXPECT_EQ(after([&](auto& p) {
                      p.slope.toe_elevation = 0;
                      p.water = water;
                  }),
                  Check::water_above_crack);
    }
}

TEST(Checks, WaterPointsNotIncreasing) {
    for (const Water<>& water :
         {Water<>(PiezometricLineWater<>{9810, {}}), Water<>(PiezometricLineWater<>{9810, {{0, 1}}}),
          Water<>(PiezometricLineWater<>{9810, {{0, 1}, {0, 2}}}),
          Water<>(PiezometricLineWater<>{9810, {{1, 1}, {0, 2}}}), Water<>(CustomWater<>{{}, {{0.5, 1}, {0.5, 2}}}),
          Water<>(CustomWater<>{{{0.5, 1}, {0.2, 2}}, {}}), Water<>(CustomWater<>{{{0.5, 1}}, {}}),
          Water<>(CustomWater<>{{}, {{0.5, 1}}})}) {
        EXPECT_EQ(after([&](auto& p) { p.water = water; }), Check::water_points_not_increasing);
    }
    EXPECT_EQ(after([](auto& p) { p.water = CustomWater<>{}; }), Check::valid);
}

TEST(Checks, PondAboveCrest) {
    EXPECT_EQ(after([](auto& p) { p.pond = Pond<>{12.01, 9810}; }), Check::pond_above_crest);
    EXPECT_EQ(after([](auto& p) { p.pond = Pond<>{12, 9810}; }), Check::valid);
}

TEST(Checks, ElevationWithoutDatum) {
    EXPECT_EQ(after([](auto& p) { p.tension_crack = crack(90, CrackBaseElevation<>{7}); }),
              Check::elevation_without_datum);
    EXPECT_EQ(after([](auto& p) {
                  p.water = PeakAtToeWater<>{9810, WaterElevation<>{7}};
              }),
              Check::elevation_without_datum);
}

TEST(Checks, FrictionNotBelowNinetyDegrees) {
    EXPECT_EQ(after([](auto& p) {
                  p.strength = SteppedSurface<>{0, degrees(45), degrees(45)};
              }),
              Check::friction_not_below_90_deg);
    EXPECT_EQ(after([](auto& p) {
                  p.strength = PattonBilinear<>{degrees(45), degrees(45), 1e5};
              }),
              Check::friction_not_below_90_deg);
}

TEST(Checks, BoltHeadAboveCrest) {
    EXPECT_EQ(after([](auto& p) { p.bolt = {{1e3, 0, 12.1, BoltAction::passive}}; }), Check::bolt_head_above_crest);
}

TEST(Checks, EveryNumberOutOfRangeIsRefused) {
    PlaneFailure<> problem = textbook_slope();
    problem.slope.bench = Bench<>{3, 0.1};
    problem.slope.toe_elevation = 1;
    problem.failure_plane.daylight_height = 1;
    problem.water = PiezometricLineWater<>{9810, {{0, 1}, {9, 2}}};
    problem.tension_cutoff = TensionCutoff<>{1e3};
    problem.pond = Pond<>{1, 9810};
    problem.seismic = SeismicLoad<>{0.1, 0.1};
    problem.surcharge = {{1e3, 0, 1}};
    problem.line_load = {{1e3, 1, 1}};
    problem.bolt = {{1e3, 1, 1, BoltAction::active}};
    ASSERT_EQ(analyse(problem).check, Check::valid);
    std::vector<std::pair<double*, Interval>> numbers;
    for_each_number(problem, [&](double& number, const FieldInfo& info) { numbers.emplace_back(&number, info.range); });
    ASSERT_EQ(numbers.size(), 32U);
    for (const auto& [number, range] : numbers) {
        const double kept = *number;
        std::vector<double> bad = {not_a_number, infinity, -infinity};
        if (std::isfinite(range.lower)) {
            bad.push_back(range.lower_open ? range.lower : std::nextafter(range.lower, -infinity));
        }
        if (std::isfinite(range.upper)) {
            bad.push_back(range.upper_open ? range.upper : std::nextafter(range.upper, infinity));
        }
        for (const double value : bad) {
            *number = value;
            EXPECT_EQ(analyse(problem).check, Check::input_out_of_range) << value;
            EXPECT_EQ(
                find_critical_geometry(problem, {CriticalFeature::both, SearchCondition::given_water, {}, {}}).check,
                Check::input_out_of_range);
            EXPECT_TRUE(profile_after_failure(problem).empty() || !std::isnan(profile_after_failure(problem)[0].x()));
            // Without the range checks a bad number may still have an answer, but never a silent NaN.
            const FactorOfSafety unchecked = factor_of_safety(problem);
            if (unchecked.check == Check::valid) {
                EXPECT_FALSE(std::isnan(unchecked.value)) << value;
            }
        }
        *number = kept;
    }
}

// NaN in an input that matters must not pass for an answer if ranges are not checked.
TEST(Checks, NotANumberIsNeverAnAnswer) {
    const auto unchecked = [](auto change) {
        PlaneFailure<> problem = textbook_slope();
        problem.water = CrackAndBaseWater<>{9810, WaterDepth<>{3}};
        change(problem);
        return factor_of_safety(problem).check;
    };
    EXPECT_NE(unchecked([](auto& p) { p.rock.unit_weight = not_a_number; }), Check::valid);
    EXPECT_NE(unchecked([](auto& p) { p.strength = Coulomb<>{not_a_number, 0.5}; }), Check::valid);
    EXPECT_NE(unchecked([](auto& p) { p.strength = Coulomb<>{0, not_a_number}; }), Check::valid);
    EXPECT_NE(unchecked([](auto& p) { p.water = CrackOnlyWater<>{9810, WaterDepth<>{not_a_number}}; }), Check::valid);
    EXPECT_NE(unchecked([](auto& p) { p.water = PeakAtToeWater<>{not_a_number, FilledRatio<>{0.5}}; }), Check::valid);
    EXPECT_NE(unchecked([](auto& p) { p.seismic = SeismicLoad<>{not_a_number, 0}; }), Check::valid);
    EXPECT_NE(unchecked([](auto& p) { p.slope.upper_surface_dip = not_a_number; }), Check::valid);
    EXPECT_NE(unchecked([](auto& p) { p.bolt = {{not_a_number, 0, 1, BoltAction::active}}; }), Check::valid);
    // These numbers are in range, but their forces overflow.
    EXPECT_EQ(unchecked([](auto& p) {
                  p.slope.height = 1e160;
                  p.tension_crack->position = CrackOfDepth<>{4};
              }),
              Check::input_out_of_range);
}

TEST(Checks, NamesMatchTheirValues) {
    EXPECT_EQ(enum_names(Check{}).size(), static_cast<std::size_t>(Check::input_out_of_range) + 1);
    EXPECT_EQ(enum_names(Check{})[static_cast<std::size_t>(Check::crack_below_plane)], "crack_below_plane");
    EXPECT_EQ(enum_names(Check{})[static_cast<std::size_t>(Check::water_needs_crack)], "water_needs_crack");
    EXPECT_EQ(enum_names(Check{})[static_cast<std::size_t>(Check::input_out_of_range)], "input_out_of_range");
}

TEST(Fuzz, ValidResultsHoldNumbers) {
    RandomProblem random(99);
    std::map<Check, int> seen;
    for (int count = 0; count < 100000; ++count) {
        const PlaneFailure<> problem = random.next();
        const PlaneFailureResult result = analyse(problem);
        ++seen[result.check];
        if (result.check != Check::valid) {
            continue;
        }
        for_each_named_number(result, [&](const std::string& path, const FieldInfo&, double value) {
            EXPECT_FALSE(std::isnan(value)) << path;
        });
        EXPECT_GE(result.factor_of_safety, 0);
        EXPECT_GT(result.section_area, 0);
        EXPECT_GT(result.sliding_area, 0);
        EXPECT_GE(result.crack_depth, 0);
        EXPECT_GE(result.base_water_force, 0);
        EXPECT_GE(result.crack_water_force, 0);
        for (const Point& point : profile_after_failure(problem)) {
            EXPECT_TRUE(std::isfinite(point.x()) && std::isfinite(point.y()));
        }
        if (::testing::Test::HasFailure()) {
            for_each_named_number(problem, [](const std::string& path, const FieldInfo&, double value) {
                std::cout << path << " " << value << "\n";
            });
            return;
        }
    }
    EXPECT_GT(seen[Check::valid], 40000);
    EXPECT_GE(seen.size(), 8U);  // the sweep meets most refusals too
}

// Searches end, and answer with a number or a reason, over the same ranges.
TEST(Fuzz, SearchesEnd) {
    RandomProblem random(101);
    int found = 0;
    int missed = 0;
    for (int count = 0; count < 1000; ++count) {
        PlaneFailure<> problem = random.next();
        // As much as the search lets the plane bear where nothing is given.
        problem.tension_cutoff = problem.tension_cutoff.value_or(TensionCutoff<>{std::numeric_limits<double>::max()});
        for (const CriticalFeature feature :
             {CriticalFeature::tension_crack, CriticalFeature::failure_plane, CriticalFeature::both}) {
            const CriticalGeometry critical =
                find_critical_geometry(problem, {feature, SearchCondition::given_water, {}, {}});
            if (critical.check == Check::valid) {
                ++found;
                EXPECT_GE(critical.factor_of_safety, 0);
                const FactorOfSafety again = factor_of_safety(critical.problem);
                ASSERT_EQ(again.check, Check::valid);
                EXPECT_EQ(again.value, critical.factor_of_safety);
                const FactorOfSafety given = factor_of_safety(problem);
                // The given crack is one of those searched; a scan may miss a narrow dip, but seldom.
                if (given.check == Check::valid && problem.tension_crack) {
                    missed += critical.factor_of_safety > given.value * (1 + 1e-9) + 1e-9 ? 1 : 0;
                }
            }
            EXPECT_LT(critical.evaluations, 100000);
        }
        const Required required = required_value({problem, {}, {}}, "rock.unit_weight", 1);
        EXPECT_FALSE(std::isnan(required.value));
    }
    EXPECT_GT(found, 1000);
    // Measured over three times as many: 27 of 7377; loads that come and go with the crack make several dips.
    EXPECT_LE(missed, found / 100);
    std::cout << "missed " << missed << " of " << found << "\n";
}

}  // namespace
}  // namespace delabole
