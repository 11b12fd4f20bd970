// Patterns of bolts in limit equilibrium: what a row holds, and that whole patterns are the single bolts that they
// stand for.
#include "support/bolt_pattern.hpp"

#include "limit_equilibrium/columns/base_profile.hpp"
#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/required.hpp"
#include "plane_failure/sensitivity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace delabole {
namespace {

// Wyllie & Mah (2004), example 7.1, drained and without cohesion.
PlaneFailure<> road_cut() {
    PlaneFailure<> slope{};
    slope.slope = {12, degrees(60), 0, {}, {}};
    slope.failure_plane.dip = degrees(35);
    slope.tension_crack = TensionCrack<>{degrees(90), CrackAtDistance<>{4}};
    slope.rock.unit_weight = 26e3;
    slope.strength = Coulomb<>{0, degrees(37)};
    slope.water = Dry{};
    return slope;
}

// Four rows, 2 to 8 m above the toe, below the crack's bottom.
BoltPattern<> pattern_at(double plunge, double length) {
    return {4, 2, 2, 2.4, length, degrees(plunge), 240e3, {}};
}

// 4 rows of 240 kN every 2.4 m are the 400 kN/m of the example: recomputed from it 1.499 normal to the plane, 2.413 at
// a plunge of 2 deg, to the last digit printed.
TEST(BoltPattern, IsTheForceOfItsRows) {
    for (const auto& [plunge, printed] : {std::pair{55.0, 1.499}, std::pair{2.0, 2.413}}) {
        for (const BoltAction action : {BoltAction::active, BoltAction::passive}) {
            PlaneFailure<> single = road_cut();
            single.bolt = {{400e3, degrees(plunge), 5, action}};
            PlaneFailure<> rows = road_cut();
            rows.support = {{pattern_at(plunge, 30), action}};
            const PlaneFailureResult one = analyse(single);
            const PlaneFailureResult many = analyse(rows);
            EXPECT_NEAR(many.factor_of_safety / one.factor_of_safety, 1, 1e-13);
            // The mean height of the heads is that of the single bolt.
            EXPECT_NEAR(many.normal_force_position, one.normal_force_position, 1e-12);
            if (action == BoltAction::active) {
                EXPECT_NEAR(many.factor_of_safety, printed, 5e-4);
            }
        }
    }
}

// Along a bolt from a head at height h to the plane: h sin(f - p) / (sin f sin(p + q)).
TEST(BoltPattern, GroutHoldsByTheLengthsOnEitherSide) {
    PlaneFailure<> slope = road_cut();
    const double plunge = degrees(20);
    const double through = 6 * std::sin(degrees(25)) / (std::sin(degrees(60)) * std::sin(degrees(55)));
    const double bond = 40e3;
    const auto force_with = [&](double length, double plate) {
        slope.support = {{{1, 6, 1, 1, length, plunge, 200e3, Grout<>{bond, plate}}, BoltAction::active}};
        return support_rows(slope).front().front().force;
    };
    EXPECT_EQ(force_with(through - 0.001, 1e6), 0);
    EXPECT_NEAR(force_with(through + 2, 1e6), bond * 2, 1e-9 * bond);
    EXPECT_EQ(force_with(through + 10, 1e6), 200e3);
    EXPECT_NEAR(force_with(through + 10, 30e3), 30e3 + bond * through, 1e-9 * bond);
}

// Level bolts from 9 m above the toe pass over the plane's upper end, at 7.65 m, and through the crack.
TEST(BoltPattern, CrossesTheCrackAboveThePlane) {
    PlaneFailure<> slope = road_cut();
    const double through = 4 + (12 - 9) / std::tan(degrees(60));
    for (const double margin : {-1e-9, 1e-9}) {
        slope.support = {{{1, 9, 1, 1, through + margin, 0, 100e3, {}}, BoltAction::active}};
        EXPECT_EQ(support_rows(slope).front().front().force, margin > 0 ? 100e3 : 0);
    }
    slope.tension_crack.reset();
    slope.support.front().pattern.plunge = degrees(-30);
    slope.support.front().pattern.length = 1e3;
    EXPECT_EQ(support_rows(slope).front().front().force, 0) << "it leaves the ground behind the crest";
    slope.support.front().pattern.lowest_height = 12.001;
    EXPECT_EQ(analyse(slope).check, PlaneFailureCheck::bolt_head_above_crest);
}

// Behind the crest the ground falls: bolts above it hold nothing, nor do ends that come out of it.
TEST(BoltPattern, HoldsNothingInTheAir) {
    PlaneFailure<> slope = road_cut();
    slope.slope.upper_surface_dip = degrees(-20);
    const auto force_of = [&](const BoltPattern<>& pattern) {
        slope.support = {{pattern, BoltAction::active}};
        return support_rows(slope).front().front().force;
    };
    EXPECT_EQ(force_of({1, 11.9, 1, 1, 10, degrees(10), 200e3, {}}), 0) << "it meets the crack's line above the ground";
    slope.tension_crack.reset();
    slope.slope.upper_surface_dip = degrees(-30);
    // A level bolt from height h comes out of the ground where that has fallen to h.
    const double height = 8;
    const double through = height / std::tan(degrees(35)) - height / std::tan(degrees(60));
    const double in_ground = (12 - height) / std::tan(degrees(60)) + (12 - height) / std::tan(degrees(30));
    for (const double margin : {-1e-9, 1e-9}) {
        EXPECT_EQ(force_of({1, height, 1, 1, in_ground + margin, 0, 200e3, {}}), margin < 0 ? 200e3 : 0);
    }
    const double bond = 40e3;
    EXPECT_NEAR(force_of({1, height, 1, 1, 30, 0, 200e3, Grout<>{bond, 1e6}}), bond * (in_ground - through),
                1e-9 * bond);
    // Above a level bench two metres wide a bolt that rises by 20 deg comes out of the ground behind it.
    slope.slope.bench = Bench<>{2, 0};
    slope.slope.upper_surface_dip = degrees(10);
    const double to_bench = (12 - 11.5) / std::sin(degrees(20));
    EXPECT_NEAR(length_in_ground(slope.slope, 11.5, degrees(-20)), to_bench, 1e-12 * to_bench);
    EXPECT_TRUE(std::isinf(length_in_ground(slope.slope, 8.0, degrees(-9))));
    EXPECT_TRUE(std::isinf(length_in_ground(slope.slope, 8.0, degrees(90))));
}

TEST(BoltPattern, HasExactDerivatives) {
    PlaneFailure<> slope = road_cut();
    slope.support = {{{3, 2, 2, 2, 8, degrees(10), 500e3, Grout<>{40e3, 50e3}}, BoltAction::active}};
    for (const Sensitivity& input : sensitivities(slope).derivatives) {
        for (const auto& [name, step] : {std::pair{"support[1].length", 1e-5}, std::pair{"support[1].plunge", 1e-6}}) {
            if (input.parameter == name) {
                const bool is_length = std::string_view(name).ends_with("length");
                const auto factor_at = [&](double change) {
                    PlaneFailure<> varied = slope;
                    BoltPattern<>& pattern = varied.support[0].pattern;
                    (is_length ? pattern.length : pattern.plunge) += change;
                    return factor_of_safety(varied).value;
                };
                // Central differences: the error is of the square of the step.
                const double difference = (factor_at(step) - factor_at(-step)) / (2 * step);
                EXPECT_NEAR(input.derivative / difference, 1, 1e-6) << name;
                EXPECT_NE(difference, 0);
            }
        }
    }
}

TEST(RequiredValue, CablesSolvedTogether) {
    PlaneFailure<> slope = road_cut();
    slope.bolt = {{0, degrees(10), 3, BoltAction::active}};
    const Required one = required_value({slope, {}, {}}, "bolt[1].force", 1.5);
    slope.bolt.push_back({0, degrees(10), 6, BoltAction::active});
    const Required both = required_value({slope, {}, {}}, "bolt[1].force", 1.5, {"bolt[2].force"});
    ASSERT_EQ(both.status, RequiredStatus::found);
    EXPECT_NEAR(2 * both.value / one.value, 1, 1e-12);
    EXPECT_EQ(required_value({slope, {}, {}}, "bolt[1].force", 1.5, {"bolt[3].force"}).status,
              RequiredStatus::unknown_parameter);
}

SteppedBase<> columns() {
    SteppedBase<> problem{};
    problem.scene.slope = SlopeSection<>{40, degrees(65), 0, {}, {}};
    problem.scene.columns = ContinuousColumns<>{degrees(70), 5, degrees(35), {}};
    problem.scene.rock.unit_weight = 26e3;
    problem.scene.water = Dry{};
    problem.joints.friction_angle = degrees(28);
    problem.bases = {degrees(30), 0};
    return problem;
}

double factor_of(const SteppedBase<>& problem) {
    const SteppedBaseResult result = analyse(problem);
    EXPECT_EQ(result.check, ColumnCheck::valid);
    return result.factor_of_safety;
}

// A bolt may be moved along its line: to where that meets the column's toe side it is a bolt of that column.
TEST(BoltPattern, InColumnsIsABoltOfTheColumnAtItsHead) {
    const double base_dip = degrees(20);
    for (const double height : {3.0, 8.0, 15.0, 25.0}) {
        for (const double plunge : {degrees(5), degrees(30)}) {
            SteppedBase<> supported = columns();
            supported.scene.support = {{1, height, 1, 2, 100, plunge, 1200e3, {}}};
            ASSERT_NEAR(support_rows(supported.scene).front().front().force, 600e3, 1e-6);
            const double x = height / std::tan(degrees(65));
            const double u = x * std::cos(base_dip) + height * std::sin(base_dip);
            const double v = height * std::cos(base_dip) - x * std::sin(base_dip);
            const ColumnSlope<> slope = make_columns(columns().scene);
            std::size_t index = 0;
            while (u >= slope.columns[index].base_u + slope.columns[index].width) {
                ++index;
            }
            const Column<>& column = slope.columns[index];
            const double at_toe_side = v - column.base_v + (u - column.base_u) * std::tan(plunge + base_dip);
            ColumnSlope<> by_hand = slope;
            by_hand.columns[index].down_dip_force -= 600e3 * std::cos(plunge + base_dip);
            by_hand.columns[index].normal_force += 600e3 * std::sin(plunge + base_dip);
            by_hand.columns[index].overturning_moment -= 600e3 * at_toe_side * std::cos(plunge + base_dip);
            EXPECT_NEAR(factor_of(supported) / factor_of_safety(by_hand, strength_of(columns())).value, 1, 1e-10)
                << height << " m";
            EXPECT_GT(factor_of(supported), factor_of(columns()));
        }
    }
}

// Normal to the bases the length to them is the head's height above the base of its column.
TEST(BoltPattern, ReachesBehindTheColumns) {
    SteppedBase<> problem = columns();
    const double height = 10;
    const double x = height / std::tan(degrees(65));
    const double v = height * std::cos(degrees(20)) - x * std::sin(degrees(20));
    const double u = x * std::cos(degrees(20)) + height * std::sin(degrees(20));
    const ColumnSlope<> slope = make_columns(problem.scene);
    const auto column =
        std::ranges::find_if(slope.columns, [&](const Column<>& each) { return u < each.base_u + each.width; });
    for (const double margin : {-1e-9, 1e-9}) {
        problem.scene.support = {{1, height, 1, 1, v - column->base_v + margin, degrees(70), 100e3, {}}};
        EXPECT_EQ(support_rows(problem.scene).front().front().force, margin > 0 ? 100e3 : 0);
    }
    // Level, it has to pass the columns behind first.
    problem.scene.support = {{1, height, 1, 1, 4, 0, 100e3, {}}};
    EXPECT_EQ(support_rows(problem.scene).front().front().force, 0);
    problem.scene.support.front().length = 40;
    EXPECT_EQ(support_rows(problem.scene).front().front().force, 100e3);
}

TEST(BoltPattern, CablesInColumnsSolvedTogether) {
    SteppedBase<> problem = columns();
    problem.scene.bolt = {{2, 0, degrees(10), 3}, {4, 0, degrees(10), 8}};
    const Required both = required_value(problem, "bolt[1].force", 1.1, {"bolt[2].force"});
    ASSERT_EQ(both.status, RequiredStatus::found);
    problem.scene.bolt[0].force = problem.scene.bolt[1].force = both.value;
    EXPECT_NEAR(factor_of(problem), 1.1, 1e-9);
}

}  // namespace
}  // namespace delabole
