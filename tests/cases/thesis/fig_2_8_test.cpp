#include "cases/program/thesis/chapter_2/chapter_2.hpp"

#include "tests/lib/plane_failure/closed_forms.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace delabole {
namespace {

// The printed formulas of the thesis, 2.3.2 (c), evaluated as they stand.
double printed_factor(double unit_weight, double z, double water_depth, double cohesion) {
    const double height = 225 * 0.3048;
    const double plane = degrees(40);
    const double area = (height - z) / std::sin(plane);
    const double uplift = 9810 * water_depth * (height - z) / std::sin(plane) / 2;
    const double thrust = 9810 * water_depth * water_depth / 2;
    const double weight = closed_form::weight_crack_in_face(unit_weight, height, z, degrees(70), plane);
    const double resistance =
        cohesion * area + (weight * std::cos(plane) - uplift - thrust * std::sin(plane)) * std::tan(degrees(66));
    return resistance / (weight * std::sin(plane) + thrust * std::cos(plane));
}

TEST(Fig28, SolutionMeetsThePrintedStatementsByThePrintedFormulas) {
    for (const double unit_weight : {25e3, 26e3, 27e3, 28e3}) {
        const Fig28Solution solution = solve_fig_2_8(FilledFraction::of_z_below_crest, unit_weight);
        ASSERT_TRUE(solution.z) << unit_weight;
        EXPECT_EQ(solution.state.crack_location, CrackLocation::face);
        // The root is found to rounding; the formulas are well conditioned there.
        EXPECT_NEAR(printed_factor(unit_weight, *solution.z, *solution.z * 2 / 3, fig_2_8_cohesion), 1, 1e-12);
        EXPECT_NEAR(printed_factor(unit_weight, *solution.z, *solution.z / 2, 0), solution.factor_half_full, 1e-12);
        EXPECT_GT(solution.factor_half_full, 1);
        // This is what the text of the reproduction says.
        EXPECT_NEAR(350 + solution.state.crack_base_height / 0.3048, 425, 11);
        EXPECT_LT(solution.state.overturning_factor, 1);
    }
}

TEST(Fig28, FractionOfTheCrackItselfGivesNoCrackInTheFace) {
    for (const double unit_weight : {24e3, 25e3, 26e3, 27e3, 28e3, 29e3}) {
        const Fig28Solution solution = solve_fig_2_8(FilledFraction::of_the_crack_itself, unit_weight);
        EXPECT_TRUE(!solution.z || solution.state.crack_location != CrackLocation::face) << unit_weight;
    }
}

TEST(Fig28, CurvesFallAndPassThroughTheStatements) {
    const Fig28Solution solution = solve_fig_2_8(FilledFraction::of_z_below_crest, 27e3);
    const Polyline curve = fig_2_8_curve(solution.reading, 27e3, *solution.z, fig_2_8_cohesion);
    ASSERT_GT(curve.size(), 70U);
    for (std::size_t index = 1; index < curve.size(); ++index) {
        EXPECT_LE(curve[index].y(), curve[index - 1].y());
    }
    EXPECT_GT(curve[66].y(), 1);  // at 0.66, before two thirds
    EXPECT_LT(curve[67].y(), 1);
}

}  // namespace
}  // namespace delabole
