// The critical crack and plane where loads make the factor of safety jump, against brute force.
#include "plane_failure/critical.hpp"
#include "plane_failure/plane_failure.hpp"
#include "tests/lib/plane_failure/critical_searches.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace delabole {
namespace {

// 12 m high, with one to four loads behind the crest, often on a bench.
PlaneFailure<> loaded_slope(RandomProblem& random) {
    PlaneFailure<> problem = textbook_slope();
    problem.tension_cutoff = TensionCutoff<>{1e12};  // as much as the search lets the plane bear
    problem.slope.face_dip = degrees(random.uniform(50, 88));
    problem.failure_plane.dip = degrees(random.uniform(20, 45));
    problem.slope.upper_surface_dip = degrees(random.chance(0.5) ? 0 : random.uniform(-10, 15));
    if (random.chance(0.5)) {
        problem.slope.bench = Bench<>{random.uniform(0.5, 5), degrees(random.uniform(-10, 60))};
    }
    problem.strength = Coulomb<>{random.uniform(2e3, 40e3), degrees(random.uniform(15, 40))};
    if (random.chance(0.4)) {
        problem.water = CrackAndBaseWater<>{9.81e3, FilledRatio<>{random.uniform(0, 1)}};
    }
    const int loads = 1 + random.pick(4);
    for (int load = 0; load < loads; ++load) {
        const double distance = random.uniform(0, 8);
        if (random.chance(0.5)) {
            problem.line_load.push_back({random.uniform(10e3, 400e3), degrees(random.uniform(0, 180)), distance});
        } else {
            problem.surcharge.push_back({random.uniform(-20e3, 200e3), distance, distance + random.uniform(0.2, 6)});
        }
    }
    return problem;
}

std::vector<double> positions_of_loads(const PlaneFailure<>& problem) {
    std::vector<double> distances = {0, problem.slope.bench ? problem.slope.bench->width : 0};
    for (const LineLoad<>& load : problem.line_load) {
        distances.push_back(load.distance_behind_crest);
    }
    for (const Surcharge<>& surcharge : problem.surcharge) {
        distances.insert(distances.end(), {surcharge.from_distance, surcharge.to_distance});
    }
    return distances;
}

// Cracks by their tops, evenly over the face and 40 m of ground, and close to both sides of every load.
double least_by_brute_force(PlaneFailure<> problem) {
    std::vector<double> tops;
    constexpr int points = 6000;
    for (int index = 0; index <= points; ++index) {
        tops.push_back(-10 + 50.0 * index / points);
    }
    for (const double distance : positions_of_loads(problem)) {
        tops.insert(tops.end(), {distance - 1e-7, distance + 1e-7});
    }
    double least = std::numeric_limits<double>::infinity();
    for (const double top : tops) {
        problem.tension_crack->position = CrackAtDistance<>{top};
        const FactorOfSafety result = factor_of_safety(problem);
        if (result.check == PlaneFailureCheck::valid) {
            least = std::min(least, result.value);
        }
    }
    return least;
}

TEST(CriticalLoads, CrackAgainstBruteForce) {
    RandomProblem random(77);
    for (int count = 0; count < 200; ++count) {
        const PlaneFailure<> problem = loaded_slope(random);
        const CriticalGeometry critical = find_critical_geometry(problem, crack_search);
        ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
        const double least = least_by_brute_force(problem);
        // Brute force puts the crack 1e-7 m beside a load, the search 1e-12 of its range.
        EXPECT_LE(critical.factor_of_safety, least * (1 + 1e-6)) << count;
        EXPECT_EQ(factor_of_safety(critical.problem).value, critical.factor_of_safety) << count;
    }
}

// A line load that drives the mass adds to it only where the crack opens behind: the least mass that carries it.
TEST(CriticalLoads, CrackOpensJustBehindALineLoad) {
    PlaneFailure<> problem = textbook_slope();
    problem.line_load = {{300e3, degrees(120), 0.37}};
    const CriticalGeometry critical = find_critical_geometry(problem, crack_search);
    ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
    EXPECT_NEAR(analyse(critical.problem).crack_distance_behind_crest, 0.37, 1e-9);  // 1e-12 of the range
    EXPECT_GE(analyse(critical.problem).crack_distance_behind_crest, 0.37);
    EXPECT_FALSE(critical.at_boundary);
}

TEST(CriticalLoads, PlaneWithoutCrackAgainstBruteForce) {
    RandomProblem random(78);
    for (int count = 0; count < 60; ++count) {
        PlaneFailure<> problem = loaded_slope(random);
        problem.water = Dry{};
        problem.tension_crack.reset();
        CriticalSearch<> search = plane_search;
        search.lower_dip = degrees(16);  // steeper than the ground behind the crest
        const CriticalGeometry critical = find_critical_geometry(problem, search);
        ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
        double least = std::numeric_limits<double>::infinity();
        const double upper = problem.slope.face_dip - degrees(0.01);
        constexpr int points = 20000;
        for (int index = 0; index <= points; ++index) {
            problem.failure_plane.dip = degrees(16) + (upper - degrees(16)) * index / points;
            const FactorOfSafety result = factor_of_safety(problem);
            if (result.check == PlaneFailureCheck::valid) {
                least = std::min(least, result.value);
            }
        }
        EXPECT_LE(critical.factor_of_safety, least * (1 + 1e-9)) << count;
    }
}

// A crack in the face just in front of a bolt's head leaves the bolt out of the mass.
TEST(CriticalLoads, CrackInFrontOfABoltAgainstBruteForce) {
    RandomProblem random(83);
    for (int count = 0; count < 40; ++count) {
        PlaneFailure<> problem = loaded_slope(random);
        problem.slope.bench.reset();
        problem.water = CrackAndBaseWater<>{9.81e3, FilledRatio<>{random.uniform(0.7, 1)}};
        problem.bolt = {
            {random.uniform(1e5, 1e6), degrees(random.uniform(-5, 30)), random.uniform(5, 11.5), BoltAction::active}};
        const CriticalGeometry critical = find_critical_geometry(problem, crack_search);
        ASSERT_EQ(critical.check, PlaneFailureCheck::valid);
        const double head = (problem.bolt[0].head_height - 12) / std::tan(problem.slope.face_dip);
        double least = std::numeric_limits<double>::infinity();
        for (const double beside : {-1e-6, 1e-6}) {
            problem.tension_crack->position = CrackAtDistance<>{head + beside};
            const FactorOfSafety result = factor_of_safety(problem);
            least = result.check == PlaneFailureCheck::valid ? std::min(least, result.value) : least;
        }
        EXPECT_LE(critical.factor_of_safety, least * (1 + 1e-6)) << count;  // as far from the jump as brute force is
    }
}

// All lengths, cohesion and pressures times 8, line loads times 64: the same slope.
TEST(CriticalLoads, Similarity) {
    RandomProblem random(79);
    for (int count = 0; count < 40; ++count) {
        const PlaneFailure<> problem = loaded_slope(random);
        PlaneFailure<> larger = problem;
        for_each_number(larger, [](double& number, const FieldInfo& info) {
            switch (info.dimension) {
            case Dimension::length:
            case Dimension::stress:
                number *= 8;
                break;
            case Dimension::force_per_length:
                number *= 64;
                break;
            default:
                break;
            }
        });
        const CriticalGeometry one = find_critical_geometry(problem, crack_search);
        const CriticalGeometry other = find_critical_geometry(larger, crack_search);
        ASSERT_EQ(one.check, other.check);
        // Rounding of the search, which takes roots of heights: powers of two are exact elsewhere.
        EXPECT_NEAR(other.factor_of_safety, one.factor_of_safety, 1e-9 * one.factor_of_safety) << count;
    }
}

}  // namespace
}  // namespace delabole
