// The stepped surface that fails first: against every surface of small lattices, against models that know one surface,
// and by what must not change.
#include "limit_equilibrium/stepped_path/stepped_path.hpp"
#include "geometry/polygon.hpp"
#include "limit_equilibrium/stepped_base/stepped_base.hpp"
#include "plane_failure/plane_failure.hpp"
#include "tests/lib/limit_equilibrium/stepped_path/every_stepped_path.hpp"
#include "tests/lib/limit_equilibrium/stepped_path/west_face.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace delabole {
namespace {

TEST(SteppedPath, NoSurfaceOfColumnsIsWeakerThanTheOneFound) {
    std::mt19937 random(19);
    int found = 0;
    std::size_t tried = 0;
    for (int count = 0; count < 400; ++count) {
        const SteppedPath problem = random_path(
            random, count % 2 == 0 ? SteppedPathMechanism::toppling : SteppedPathMechanism::slide_head_toppling);
        const PathLattice lattice(problem);
        if (lattice.check != SteppedPathCheck::valid) {
            continue;
        }
        const CriticalPath critical = least_stable_path(problem, lattice);
        const std::vector<LatticePath> paths = all_column_paths(lattice);
        const double least = least_of_all(problem, lattice, paths);
        tried += paths.size();
        if (std::isfinite(least) && least > 0) {
            ++found;
            // Factors are known to some 1e-14.
            EXPECT_NEAR(critical.factor_of_safety, least, 1e-9 * least) << count;
        } else {
            EXPECT_EQ(critical.factor_of_safety, least) << count;
        }
    }
    EXPECT_GT(found, 150);
    EXPECT_GT(tried, 20000U);
}

TEST(SteppedPath, NoSlidingSurfaceIsWeakerThanTheOneFound) {
    std::mt19937 random(20);
    int found = 0;
    int in_front = 0;
    int on_steps = 0;
    for (int count = 0; count < 400; ++count) {
        SteppedPath problem = random_path(random, SteppedPathMechanism::sliding);
        if (count % 4 == 0) {  // steep steps that come out behind the crest, and risers too strong to open
            problem.steps.dip += degrees(20);
            problem.search.greatest_retreat = 60;
            problem.rock_bridges = RockBridges{0.9, 0.5, 500e3, degrees(40), 1e6};
        }
        const PathLattice lattice(problem);
        if (lattice.check != SteppedPathCheck::valid) {
            continue;
        }
        const CriticalPath critical = least_stable_path(problem, lattice);
        const double least = least_of_all(problem, lattice, all_sliding_paths(lattice));
        if (std::isfinite(least) && least > 0) {
            ++found;
            in_front += lattice.riser_outcrop[critical.path.first].x() < lattice.crest.x() ? 1 : 0;
            on_steps += critical.path.ends_on_step ? 1 : 0;
            EXPECT_NEAR(critical.factor_of_safety, least, 1e-9 * least) << count;
        } else {
            EXPECT_EQ(critical.factor_of_safety, least) << count;
        }
    }
    EXPECT_GT(found, 150);
    EXPECT_GT(in_front, 30) << "begin at a riser in front of the crest";
    EXPECT_GT(on_steps, 20) << "end on a step";
}

// Compares with every surface of the same joints without the massive rock that stays above its boundary.
TEST(SteppedPath, OverMassiveRockTheWeakestSurfaceOfThoseAboveIsFound) {
    std::mt19937 random(22);
    const auto between = [&](double lower, double upper) {
        return std::uniform_real_distribution<>(lower, upper)(random);
    };
    int found = 0;
    int changed = 0;
    for (int count = 0; count < 300; ++count) {
        const auto mechanism = static_cast<SteppedPathMechanism>(count % 3);
        SteppedPath problem = random_path(random, mechanism);
        const PathLattice whole(problem);
        const double without = whole.check == SteppedPathCheck::valid
                                   ? least_stable_path(problem, whole).factor_of_safety
                                   : std::numeric_limits<double>::infinity();
        problem.massive_rock = MassiveRock{degrees(between(26, 49)), between(-15, 10)};
        const PathLattice lattice(problem);
        if (lattice.check != SteppedPathCheck::valid) {
            continue;
        }
        const double dip = problem.massive_rock->boundary_dip;
        const double height = problem.massive_rock->boundary_height;
        const double at_face = height / std::tan(problem.slope.face_dip);
        const auto above = [&](const Point& point) {
            return point.y() - height - (point.x() - at_face) * std::tan(dip) > -1e-6;
        };
        const bool slides = mechanism == SteppedPathMechanism::sliding;
        std::vector<LatticePath> paths = slides ? all_sliding_paths(whole) : all_column_paths(whole);
        std::erase_if(paths, [&](const LatticePath& path) {
            for (std::size_t index = 0; index < path.level.size(); ++index) {
                const Point deepest = slides ? deepest_of_sliding(whole, path, index)
                                             : whole.cells[path.first + index - 1][path.level[index]].base_to;
                if (!above(deepest)) {
                    return true;
                }
            }
            return path.wedge && !above(whole.wedges[path.first + path.level.size() - 2][*path.wedge].corner);
        });
        const CriticalPath critical = least_stable_path(problem, lattice);
        const double least = least_of_all(problem, whole, paths);
        if (std::isfinite(least) && least > 0) {
            ++found;
            changed += least > without * (1 + 1e-9) ? 1 : 0;
            EXPECT_NEAR(critical.factor_of_safety, least, 1e-9 * least) << count;  // factors are known to some 1e-14
        } else {
            EXPECT_EQ(critical.factor_of_safety, least) << count;
        }
        for (const Point& point : analyse(problem).surface) {
            EXPECT_TRUE(above(point)) << count;
        }
    }
    EXPECT_GT(found, 60);
    EXPECT_GT(changed, 20);
}

TEST(SteppedPath, MassiveRockBelowEverySurfaceChangesNothing) {
    for (const auto mechanism :
         {SteppedPathMechanism::sliding, SteppedPathMechanism::toppling, SteppedPathMechanism::slide_head_toppling}) {
        SteppedPath path = west_face(mechanism);
        path.columns->spacing = 5;
        const SteppedPathResult without = analyse(path);
        path.massive_rock = MassiveRock{degrees(45), -200};
        const SteppedPathResult with = analyse(path);
        EXPECT_EQ(with.factor_of_safety, without.factor_of_safety);
        EXPECT_EQ(with.surface, without.surface);
    }
}

// Compares with sums over many short pieces of an edge, while the closed form needs no pieces.
TEST(SteppedPath, WaterOnEdgesIsTheIntegralOfItsPressure) {
    std::mt19937 random(21);
    const auto between = [&](double lower, double upper) {
        return std::uniform_real_distribution<>(lower, upper)(random);
    };
    for (int count = 0; count < 200; ++count) {
        SteppedPath problem = random_path(random, SteppedPathMechanism::sliding);
        const double level = between(1, 50);
        const double reach = between(5, 60);
        problem.water = WaterDrawnDown{1e4, WaterDepth<>{level}, reach};
        const PathLattice lattice(problem);
        if (lattice.check != SteppedPathCheck::valid) {
            continue;
        }
        const Point from(between(0, 40), between(-10, 20));
        const Point to = count % 10 == 0 ? Point(from.x(), between(-10, 40)) : Point(between(0, 40), between(-10, 40));
        constexpr int pieces = 20000;
        const double length = (to - from).norm();
        const double crest = problem.slope.height / std::tan(problem.slope.face_dip);
        double force = 0;
        double moment = 0;
        for (int piece = 0; piece < pieces; ++piece) {
            const double share = (piece + 0.5) / pieces;
            const Point point = from + share * (to - from);
            const double ground =
                std::min(point.x() * std::tan(problem.slope.face_dip),
                         problem.slope.height + (point.x() - crest) * std::tan(problem.slope.upper_surface_dip));
            const double surface = std::min({ground, level, level * point.x() / reach});
            const double pressure = 1e4 * std::max(0.0, surface - point.y());
            force += pressure * length / pieces;
            moment += pressure * length / pieces * share * length;
        }
        const PathLattice::EdgeWater water = lattice.water_on(from, to);
        // Midpoints err by the square of a piece, and by a piece where the surface bends.
        EXPECT_NEAR(water.force, force, 1e-3 + 1e-6 * force) << count;
        EXPECT_NEAR(water.force * water.position, moment, 1e-1 + 1e-6 * moment) << count;
    }
}

// One step plane that daylights at the toe and one crack: plane failure, with Jennings' strength.
TEST(SteppedPath, OnePlaneAndOneCrackAreAPlaneFailure) {
    SteppedPath path{};
    path.search = {SteppedPathMechanism::sliding, 5.0, 11.0};
    path.slope = {30, degrees(65), degrees(5), std::nullopt, std::nullopt};
    path.steps = {degrees(35), 100, degrees(30), 20e3};
    path.risers = PathRisers{degrees(90), 10, degrees(30), 0};
    path.rock = {26e3};
    path.water = Dry{};

    PlaneFailure<> plane{};
    plane.slope = path.slope;
    plane.failure_plane = {degrees(35), std::nullopt};
    // Risers are 10 m apart along the level, from the crest on.
    plane.tension_crack = TensionCrack<>{degrees(90), CrackAtDistance<>{10}};
    plane.rock = path.rock;
    plane.strength = Coulomb<>{20e3, degrees(30)};
    plane.water = Dry{};
    const SteppedPathResult result = analyse(path);
    ASSERT_EQ(result.check, SteppedPathCheck::valid);
    EXPECT_NEAR(result.factor_of_safety, analyse(plane).factor_of_safety, 1e-12);
    EXPECT_NEAR(result.failed_area, analyse(plane).section_area, 1e-9);
    EXPECT_NEAR(result.retreat, 10, 1e-9);
    EXPECT_NEAR(result.lower_angle, degrees(35), 1e-12);
    EXPECT_EQ(result.lower_steps, 0);

    path.rock_bridges = RockBridges{0.9, 1, 1e6, degrees(45), 0};
    const double friction = 0.9 * std::tan(degrees(30)) + 0.1 * std::tan(degrees(45));
    plane.strength = Coulomb<>{0.9 * 20e3 + 0.1 * 1e6, std::atan(friction)};
    EXPECT_NEAR(analyse(path).factor_of_safety, analyse(plane).factor_of_safety, 1e-12);

    // Bridges on the crack resist by their tension, here normal to the crack: cos 35 deg of it along the plane.
    path.rock_bridges->riser_persistence = 0.5;
    path.rock_bridges->tensile_strength = 100e3;
    const double depth = 30 + 10 * std::tan(degrees(5)) - (30 / std::tan(degrees(65)) + 10) * std::tan(degrees(35));
    const double driving = analyse(plane).weight * std::sin(degrees(35));
    EXPECT_NEAR(analyse(path).factor_of_safety,
                analyse(plane).factor_of_safety + 0.5 * 100e3 * depth * std::cos(degrees(35)) / driving, 1e-9);
}

// Bases normal to the joints, each one step above the one below: the columns of stepped_base.hpp, cut off behind the
// uppermost one that moves there, and then pushed by its wedge.
TEST(SteppedPath, BasesNormalToTheJointsAreThoseOfTheSteppedBase) {
    SteppedBase<> base{};
    base.scene.slope = SlopeSection<>{92.5, degrees(56.6), degrees(4), std::nullopt, std::nullopt};
    base.scene.columns = ContinuousColumns<>{degrees(60), 10, degrees(30) + std::atan(0.1), std::nullopt};
    base.scene.rock = {25e3};
    base.scene.water = Dry{};
    base.joints = {degrees(38.15)};
    base.bases = {degrees(34), 5e3};
    const SteppedBaseResult known = analyse(base);
    ASSERT_EQ(known.limit, LimitState::found);

    SteppedPath path{};
    path.search = {SteppedPathMechanism::toppling, 0.0, 200.0};
    path.slope = *base.scene.slope;
    path.steps = {degrees(30), 1, degrees(34), 5e3};
    path.columns = PathColumns{degrees(-60), 10, degrees(38.15)};
    path.rock = base.scene.rock;
    path.water = Dry{};
    const PathLattice lattice(path);
    ASSERT_EQ(lattice.check, SteppedPathCheck::valid);
    LatticePath same{1, {}, {}};
    for (std::size_t column = 0; column < static_cast<std::size_t>(known.uppermost_moving); ++column) {
        same.level.push_back(column);
    }
    EXPECT_NEAR(factor_of_safety(path, lattice, same).value, known.factor_of_safety, 1e-9);
    // Every level is offered to the search, that of the stepped base among them.
    EXPECT_LE(least_stable_path(path, lattice).factor_of_safety, known.factor_of_safety * (1 + 1e-9));

    // A wedge from the end of the base after seven columns, on a joint through it.
    const double rise = 7 * 1.0;
    const Point end = 70 * Point(std::cos(degrees(30)), std::sin(degrees(30))) +
                      rise * Point(-std::sin(degrees(30)), std::cos(degrees(30)));
    std::get<ContinuousColumns<>>(base.scene.columns).base_end_height = end.y();
    base.scene.slide_head = SlideHead<>{degrees(65), degrees(30), 10e3, std::nullopt};
    const SteppedBaseResult pushed = analyse(base);
    ASSERT_EQ(pushed.limit, LimitState::found);
    ASSERT_EQ(pushed.uppermost_moving, 7);
    path.search.mechanism = SteppedPathMechanism::slide_head_toppling;
    const Point crest(92.5 / std::tan(degrees(56.6)), 92.5);
    const Point normal(std::sin(degrees(65)), -std::cos(degrees(65)));
    path.risers = PathRisers{degrees(65), normal.dot(end - crest), degrees(30), 10e3};
    ASSERT_GT(path.risers->spacing, 0);
    const PathLattice with_wedges(path);
    ASSERT_EQ(with_wedges.check, SteppedPathCheck::valid);
    same.level = {0, 1, 2, 3, 4, 5, 6};
    const auto& wedges = with_wedges.wedges[6];
    const auto wedge = std::ranges::find(wedges, 1U, &PathWedge::riser);
    ASSERT_NE(wedge, wedges.end());
    EXPECT_NEAR((wedge->corner - end).norm(), 0, 1e-9);
    same.wedge = static_cast<std::size_t>(wedge - wedges.begin());
    EXPECT_NEAR(factor_of_safety(path, with_wedges, same).value, pushed.factor_of_safety, 1e-9);
}

class EveryMechanism : public testing::TestWithParam<SteppedPathMechanism> {};

TEST_P(EveryMechanism, SlopesAlikeInShapeAndLoadHaveOneFactorOfSafety) {
    SteppedPath path = west_face(GetParam());
    path.columns->spacing = 3;  // else they do not topple without a wedge
    const SteppedPathResult small = analyse(path);
    ASSERT_TRUE(std::isfinite(small.factor_of_safety));
    SteppedPath large = path;
    for (double* length :
         {&large.slope.height, &large.steps.spacing, &large.risers->spacing, &large.columns->spacing}) {
        *length *= 7;
    }
    large.water = WaterTable<>{9.81e3, WaterDepth<>{7 * 40}};
    for (double* cohesion : {&large.steps.cohesion, &large.risers->cohesion}) {
        *cohesion *= 7;
    }
    EXPECT_NEAR(analyse(large).factor_of_safety, small.factor_of_safety, 1e-9);
    EXPECT_NEAR(analyse(large).failed_area, 49 * small.failed_area, 1e-6 * small.failed_area);

    SteppedPath heavy = path;
    heavy.rock.unit_weight *= 3;
    heavy.water = WaterTable<>{3 * 9.81e3, WaterDepth<>{40}};
    for (double* cohesion : {&heavy.steps.cohesion, &heavy.risers->cohesion}) {
        *cohesion *= 3;
    }
    EXPECT_NEAR(analyse(heavy).factor_of_safety, small.factor_of_safety, 1e-9);
}

// A choice of more surfaces never gives a higher factor of safety.
TEST_P(EveryMechanism, FinerStepsAndNarrowerMassesAreNoStronger) {
    SteppedPath path = west_face(GetParam());
    path.columns->spacing = GetParam() == SteppedPathMechanism::toppling ? 4 : 8;
    double before = std::numeric_limits<double>::infinity();
    for (const double spacing : {8.0, 4.0, 2.0, 1.0}) {
        path.steps.spacing = spacing;
        const double factor = analyse(path).factor_of_safety;
        EXPECT_LE(factor, before * (1 + 1e-9)) << spacing;
        before = factor;
    }
    before = 0;
    for (const double width : {0.0, 3.0, 6.0, 12.0, 24.0}) {
        path.search.least_width = width;
        const SteppedPathResult result = analyse(path);
        EXPECT_GE(result.factor_of_safety, before * (1 - 1e-9)) << width;
        EXPECT_GE(result.retreat, width - 1e-6);
        before = result.factor_of_safety;
    }
}

// The failed mass lies entirely above the surface it leaves.
TEST_P(EveryMechanism, WhatFailsLiesBetweenTheGroundBeforeAndAfter) {
    SteppedPath path = west_face(GetParam());
    path.columns->spacing = 4;
    const SteppedPathResult result = analyse(path);
    Polygon<> between(result.surface.begin(), result.surface.end());
    between.emplace_back(path.slope.height / std::tan(path.slope.face_dip), path.slope.height);
    EXPECT_NEAR(area_properties(between).area, result.failed_area, 1e-9 * result.failed_area);
    EXPECT_NEAR(result.toppling_share + result.sliding_share + result.slide_head_share, 1, 1e-12);
    const Polyline profile = profile_after_failure(path, result);
    EXPECT_EQ(profile.front(), Point(0, 0));
    EXPECT_GT(profile.back().x(), result.surface.back().x());
}

INSTANTIATE_TEST_SUITE_P(SteppedPath, EveryMechanism,
                         testing::Values(SteppedPathMechanism::sliding, SteppedPathMechanism::toppling,
                                         SteppedPathMechanism::slide_head_toppling),
                         [](const auto& instance) { return std::string(word_of(instance.param)); });

// A rigid mass leaves along its steps: the riser opens by the sine of the angle between both, and the mass rises.
TEST(SteppedPath, ASlidingMassOpensOneCrackAndDoesNotSink) {
    const SteppedPathResult result = analyse(west_face(SteppedPathMechanism::sliding));
    EXPECT_EQ(result.crest_cracks, 1);
    EXPECT_NEAR(result.crest_opening, std::sin(degrees(72.5 + 6)), 1e-12);
    EXPECT_NEAR(result.crest_sinking, -std::sin(degrees(6)), 1e-12);
    // Weight does no work on a mass that water lifts over steps into the slope.
    EXPECT_EQ(result.toppling_work_share + result.sliding_work_share + result.slide_head_work_share, 0);
    EXPECT_EQ(result.crest_turning, 0);
}

// A wedge slides down its joint; columns that topple turn forwards.
TEST(SteppedPath, AWedgeSinksAndColumnsTurnForwards) {
    const SteppedPathResult pushed = analyse(west_face(SteppedPathMechanism::slide_head_toppling));
    ASSERT_GT(pushed.slide_head_share, 0);
    EXPECT_NEAR(pushed.upper_angle, degrees(72.5), 1e-9);
    EXPECT_GT(pushed.crest_sinking, 0.3);
    // Stout columns rise as the wedge turns them or pushes them up their bases, so that weight drives the wedge alone.
    EXPECT_NEAR(pushed.slide_head_work_share, 1, 1e-12);
    EXPECT_LE(pushed.crest_sinking, std::sin(degrees(72.5)) + 1e-12);
    EXPECT_EQ(pushed.crest_turning, 0);
    SteppedPath thin = west_face(SteppedPathMechanism::toppling);
    thin.columns->spacing = 3;
    thin.water = Dry{};
    const SteppedPathResult toppled = analyse(thin);
    ASSERT_EQ(toppled.toppling_share, 1);
    EXPECT_LT(toppled.crest_turning, -0.1);
    EXPECT_EQ(toppled.toppling_work_share, 1);
    EXPECT_EQ(toppled.slide_head_work_share, 0);
    EXPECT_GE(toppled.crest_cracks, 2);
    EXPECT_EQ(toppled.extent, PathExtent::greatest);
}

// Steps into the slope hold a mass without water whatever its friction; so do columns too stout to topple.
TEST(SteppedPath, WhatNothingDrivesHoldsAtAnyStrength) {
    for (const auto mechanism : {SteppedPathMechanism::sliding, SteppedPathMechanism::toppling}) {
        SteppedPath path = west_face(mechanism);
        path.water = Dry{};
        const SteppedPathResult result = analyse(path);
        EXPECT_EQ(result.limit, LimitState::holds_at_any_strength);
        EXPECT_EQ(result.factor_of_safety, std::numeric_limits<double>::infinity());
        EXPECT_TRUE(result.surface.empty());
        EXPECT_EQ(model_interface(path).predict({}).failure, "holds_at_any_strength");
    }
}

TEST(SteppedPath, ImpossibleCasesSayWhy) {
    const auto check = [](const auto& change) {
        SteppedPath path = west_face(SteppedPathMechanism::slide_head_toppling);
        change(path);
        return analyse(path).check;
    };
    EXPECT_EQ(check([](SteppedPath& path) { path.risers.reset(); }), SteppedPathCheck::risers_needed);
    EXPECT_EQ(check([](SteppedPath& path) { path.columns.reset(); }), SteppedPathCheck::columns_needed);
    EXPECT_EQ(check([](SteppedPath& path) { path.slope.bench = Bench<>{5, 0}; }), SteppedPathCheck::bench_not_covered);
    EXPECT_EQ(check([](SteppedPath& path) { path.slope.upper_surface_dip = degrees(71); }),
              SteppedPathCheck::ground_too_steep);
    EXPECT_EQ(check([](SteppedPath& path) { path.slope.face_dip = degrees(30), path.steps.dip = degrees(35); }),
              SteppedPathCheck::steps_steeper_than_face);
    EXPECT_EQ(check([](SteppedPath& path) { path.risers->dip = degrees(2), path.steps.dip = degrees(1.5); }),
              SteppedPathCheck::joints_too_close);
    EXPECT_EQ(check([](SteppedPath& path) {
                  path.water = WaterTable<>{9.81e3, WaterElevation<>{100}};
              }),
              SteppedPathCheck::elevation_without_datum);
    for (const double dip : {-6.0, 72.5}) {
        EXPECT_EQ(check([&](SteppedPath& path) {
                      path.massive_rock = MassiveRock{degrees(dip), 0};
                  }),
                  SteppedPathCheck::boundary_not_between);
    }
    EXPECT_EQ(check([](SteppedPath& path) {
                  path.massive_rock = MassiveRock{degrees(45), 60};
              }),
              SteppedPathCheck::no_path);
    EXPECT_EQ(check([](SteppedPath& path) { path.search.least_width = 100; }), SteppedPathCheck::no_path);
    // Wedges alone come out so far behind the crest, and they end below every column.
    EXPECT_EQ(check([](SteppedPath& path) {
                  path.slope.face_dip = degrees(49.5), path.steps.dip = degrees(47), path.risers->dip = degrees(88);
                  path.columns->dip = degrees(-59), path.columns->spacing = path.risers->spacing = 25;
              }),
              SteppedPathCheck::no_path);
    EXPECT_EQ(check([](SteppedPath& path) { path.steps.spacing = 1e-3; }), SteppedPathCheck::too_many_nodes);
    // A few levels, and so many columns and risers that the wedges between them took 2 GB.
    EXPECT_EQ(check([](SteppedPath& path) { path.search.greatest_retreat = 40'000; }),
              SteppedPathCheck::too_many_nodes);
    EXPECT_EQ(check([](SteppedPath& path) { path.rock.unit_weight = -1; }), SteppedPathCheck::input_out_of_range);
}

// From 1 mm to 5 km, with nearly vertical faces and joints, and any friction, there is an answer or a reason.
TEST(SteppedPath, ExtremesHaveAnAnswerOrAReason) {
    std::mt19937 random(22);
    const auto between = [&](double lower, double upper) {
        return std::uniform_real_distribution<>(lower, upper)(random);
    };
    int answered = 0;
    for (int count = 0; count < 600; ++count) {
        const auto mechanism = static_cast<SteppedPathMechanism>(count % 3);
        SteppedPath path = west_face(mechanism);
        const double height = std::pow(10, between(-3, 3.7));
        path.slope = {height, degrees(between(5, 90)), degrees(between(-60, 60)), std::nullopt, std::nullopt};
        path.steps = {degrees(between(-60, 60)), height * std::pow(10, between(-1.5, 1)), degrees(between(0, 89.9)),
                      between(0, 1) < 0.5 ? 0 : std::pow(10, between(0, 9))};
        path.risers =
            PathRisers{degrees(between(1, 90)), height * std::pow(10, between(-1.5, 1)), degrees(between(0, 89.9)), 0};
        path.columns =
            PathColumns{degrees(between(-90, -30)), height * std::pow(10, between(-1.5, 1)), degrees(between(0, 89.9))};
        path.rock = {std::pow(10, between(2, 5))};
        path.water = WaterTable<>{9.81e3, WaterDepth<>{height * between(0, 2)}};
        SteppedPathResult result = analyse(path);
        if (result.check != SteppedPathCheck::valid) {
            continue;
        }
        EXPECT_FALSE(std::isnan(result.factor_of_safety)) << count;
        EXPECT_GE(result.factor_on_riser, 0) << count;
        EXPECT_GE(result.factor_of_toe, 0) << count;
        result.factor_on_riser = result.factor_of_toe = 0;  // may be infinite
        EXPECT_GE(result.factor_of_safety, 0) << count;
        EXPECT_LT(result.searches, 100) << count;
        if (!result.surface.empty()) {
            ++answered;
            for (const double value : output_values(result)) {
                EXPECT_TRUE(std::isfinite(value)) << count;
            }
            EXPECT_GT(result.failed_area, 0) << count;
        }
    }
    EXPECT_GT(answered, 60);
}

}  // namespace
}  // namespace delabole
