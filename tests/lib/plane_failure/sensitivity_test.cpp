// Exact derivatives of the factor of safety against differences in 50 digits.
#include "plane_failure/sensitivity.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/stability.hpp"
#include "tests/lib/plane_failure/reference_plane_failure.hpp"
#include "tests/support/random_problem.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace delabole {
namespace {

using reference::Real;

// Slopes of FS on both sides of one input, by second-order differences: the step of 1e-15 leaves 1e-30 of truncation
// and 1e-35 of rounding.
struct Slopes {
    bool has_left = false;
    bool has_right = false;
    double left = 0;
    double right = 0;
};

Slopes slopes_of(PlaneFailure<Real>& problem, Real& number) {
    const Real kept = number;
    const Real step = kept == 0 ? Real("1e-15") : Real(abs(kept) * Real("1e-15"));
    const auto factor = [&](const Real& value, bool& valid) {
        number = value;
        const Equilibrium<Real> forces = evaluate(problem);
        number = kept;
        valid = valid && forces.check == PlaneFailureCheck::valid;
        return forces.stability.factor_of_safety;
    };
    Slopes slopes;
    const auto one_sided = [&](const Real& signed_step, bool& has) {
        has = true;
        const Real at = factor(kept, has);
        const Real near = factor(Real(kept + signed_step), has);
        const Real far = factor(Real(kept + 2 * signed_step), has);
        return has ? static_cast<double>(Real((4 * near - 3 * at - far) / (2 * signed_step))) : 0.0;
    };
    slopes.right = one_sided(step, slopes.has_right);
    slopes.left = one_sided(Real(-step), slopes.has_left);
    return slopes;
}

struct Tally {
    int derivatives = 0;
    int kinks = 0;
    int conditioned = 0;
    double worst = 0;
};

void compare(const PlaneFailure<>& problem, Tally& tally) {
    const SensitivityResult result = sensitivities(problem);
    if (result.check != PlaneFailureCheck::valid || !std::isfinite(result.factor_of_safety)) {
        return;
    }
    EXPECT_EQ(result.factor_of_safety, factor_of_safety(problem).value);
    PlaneFailure<Real> varied = with_scalar<PlaneFailure<Real>>(problem);
    std::vector<Real*> numbers;
    std::vector<Interval> ranges;
    for_each_number(varied, [&](Real& number, const FieldInfo& info) {
        numbers.push_back(&number);
        ranges.push_back(info.range);
    });
    ASSERT_EQ(numbers.size(), result.derivatives.size());
    std::vector<Slopes> expected;
    double largest = result.factor_of_safety;  // of p dFS/dp: what rounding of the inputs alone moves
    for (std::size_t index = 0; index < numbers.size(); ++index) {
        expected.push_back(slopes_of(varied, *numbers[index]));
        const double value = std::abs(result.derivatives[index].value);
        largest = std::max({largest, value * std::abs(expected.back().left), value * std::abs(expected.back().right)});
    }
    for (std::size_t index = 0; index < numbers.size(); ++index) {
        const Sensitivity& found = result.derivatives[index];
        const Slopes& slopes = expected[index];
        // At the end of an input's range only the derivative inside counts.
        const bool right = slopes.has_right && found.value < ranges[index].upper;
        const bool left = slopes.has_left && found.value > ranges[index].lower;
        if (!right && !left) {
            continue;
        }
        ++tally.derivatives;
        const auto error_to = [&](double slope) { return std::abs(found.derivative - slope); };
        const double error = right && left ? std::min(error_to(slopes.left), error_to(slopes.right))
                                           : error_to(right ? slopes.right : slopes.left);
        const double size = std::max(std::abs(slopes.left), std::abs(slopes.right));
        // The rounding of one input moves FS by this much, as a slope: below it a derivative is zero.
        const double unit = largest / std::max(std::abs(found.value), 1e-300);
        const double jump = std::abs(slopes.left - slopes.right);
        tally.kinks += right && left && jump > 1e-6 * size && jump > 1e-15 * unit ? 1 : 0;
        if (error <= 1e-9 * size) {
            tally.worst = std::max(tally.worst, size > 0 ? error / size : 0.0);
            continue;
        }
        // Inputs of one dimension move the same lengths or stresses: between them slopes cancel, down to nothing (an
        // elevation and its datum), and leave the rounding of the largest.
        // Where FS does not feel the size of the mass at all, those of weight and base, FS over a length, cancel.
        double neighbour = found.dimension == Dimension::length ? result.factor_of_safety / problem.slope.height : 0.0;
        for (std::size_t other = 0; other < numbers.size(); ++other) {
            if (result.derivatives[other].dimension == found.dimension) {
                neighbour = std::max({neighbour, std::abs(expected[other].left), std::abs(expected[other].right)});
            }
        }
        if (size <= 1e-25 * unit && error <= 1e-12 * std::max(unit, neighbour)) {
            continue;
        }
        // Derivatives small beside others are known to their rounding only. Near singular geometry second derivatives
        // times that rounding enter, and with a plane nearly parallel to the face terms of 1 / gap cancel, of
        // 1 / (gap cos^2 f) where both are nearly vertical.
        ++tally.conditioned;
        const double gap = (problem.slope.face_dip - problem.failure_plane.dip) * std::cos(problem.slope.face_dip) *
                           std::cos(problem.failure_plane.dip);
        EXPECT_LE(error, 1e-14 * unit * std::max({1.0, largest / result.factor_of_safety, 0.1 / gap}))
            << found.parameter << " = " << found.value << ": " << found.derivative << " against " << slopes.left
            << " and " << slopes.right << ", strength " << problem.strength.index() << ", water "
            << problem.water.index();
    }
}

TEST(Sensitivity, EveryDerivativeOfRandomProblems) {
    RandomProblem random(31);
    Tally tally;
    for (int count = 0; count < 2000 && !::testing::Test::HasFailure(); ++count) {
        compare(random.next(), tally);
    }
    std::cout << tally.derivatives << " derivatives, " << tally.kinks << " at kinks, " << tally.conditioned
              << " small beside others, worst of the rest " << tally.worst << "\n";
    EXPECT_GT(tally.derivatives, 10000);
    EXPECT_LT(tally.conditioned, tally.derivatives / 50);
}

double derivative(const PlaneFailure<>& problem, std::string_view parameter) {
    const SensitivityResult result = sensitivities(problem);
    EXPECT_EQ(result.check, PlaneFailureCheck::valid);
    for (const Sensitivity& entry : result.derivatives) {
        if (entry.parameter == parameter) {
            return entry.derivative;
        }
    }
    ADD_FAILURE() << parameter;
    return 0;
}

// At the end of its range an input has a derivative on one side only.
TEST(Sensitivity, AtTheEndsOfRanges) {
    Tally tally;
    PlaneFailure<> problem = textbook_slope();
    problem.water = CrackAndBaseWater<>{9.81e3, WaterDepth<>{0}};
    compare(problem, tally);
    EXPECT_LT(derivative(problem, "water.water_depth"), -0.01);  // the base feels the first drop: gamma L / 2
    problem = textbook_slope();
    problem.strength = Coulomb<>{0, 0};
    compare(problem, tally);
    EXPECT_GT(derivative(problem, "strength.friction_angle"), 0.5);
    EXPECT_GT(derivative(problem, "strength.cohesion"), 0);
    problem = textbook_slope();
    problem.water = CrackAndBaseWater<>{9.81e3, FilledRatio<>{0.5}};
    problem.pond = Pond<>{0, 9.81e3};
    compare(problem, tally);
    EXPECT_LT(derivative(problem, "pond.depth"), 0);  // uplift first, the push on the face is of second order
    // A crack of the depth that the crest has above the plane: a smaller one opens farther back.
    problem = textbook_slope();
    const double crest_above = 12 - 12 / std::tan(degrees(60)) * std::tan(degrees(35));
    problem.tension_crack->position = CrackOfDepth<>{crest_above * (1 - 1e-15)};
    problem.water = CrackAndBaseWater<>{9.81e3, FilledRatio<>{0.5}};
    const double beside = derivative(problem, "tension_crack.depth");
    problem.tension_crack->position = CrackOfDepth<>{analyse([&] {
                                                         PlaneFailure<> at = problem;
                                                         at.tension_crack->position = CrackAtDistance<>{0};
                                                         return at;
                                                     }())
                                                         .crack_depth};
    EXPECT_NEAR(derivative(problem, "tension_crack.depth") / beside, 1, 1e-9);
}

// At these corners of the geometry the area is smooth although its trapezoids change: both sides must agree.
TEST(Sensitivity, BaseOfALeaningCrackUnderTheCrest) {
    PlaneFailure<> problem = textbook_slope();
    // Crest at (6, 6), plane of 26.57 deg: base of the crack at height 3 lies under the crest exactly in binary.
    problem.slope = {6, degrees(45), 0, {}, {}};
    problem.failure_plane.dip = std::atan(0.5);
    problem.tension_crack = TensionCrack<>{degrees(80), CrackBaseBelowCrest<>{3}};
    for (const double shift : {-1e-9, 0.0, 1e-9}) {
        Tally tally;
        problem.tension_crack->position = CrackBaseBelowCrest<>{3 + shift};
        compare(problem, tally);
        EXPECT_EQ(tally.kinks, 0);
    }
}

// Vertical cracks and level ground are branches of the code, but not of the function.
TEST(Sensitivity, VerticalCrackTurnsBothWays) {
    for (const CrackPosition<>& position :
         {CrackPosition<>(CrackAtDistance<>{4}), CrackPosition<>(CrackAtDistance<>{-1}),
          CrackPosition<>(CrackOfDepth<>{4}), CrackPosition<>(CrackBaseBelowCrest<>{4}),
          CrackPosition<>(CrackBaseElevation<>{8})}) {
        PlaneFailure<> problem = textbook_slope();
        problem.slope.toe_elevation = 0;
        problem.tension_crack->position = position;
        problem.water = PeakAtToeWater<>{9.81e3, FilledRatio<>{0.9}};
        Tally tally;
        compare(problem, tally);
        EXPECT_EQ(tally.kinks, 0);
    }
}

// Kinks: the derivative is that of one of the two sides, never something between.
TEST(Sensitivity, AtKinksOneOfTheSides) {
    PlaneFailure<> problem = textbook_slope();
    problem.surcharge = {{50e3, 1, 4}};
    problem.tension_crack->position = CrackAtDistance<>{4};  // the load ends at the crack
    Tally tally;
    compare(problem, tally);
    problem.tension_crack->position = CrackAtDistance<>{0};  // the crack opens at the crest
    problem.surcharge.clear();
    compare(problem, tally);
    EXPECT_GT(tally.kinks, 1);
}

TEST(Sensitivity, BoltHeadsDoNotEnter) {
    PlaneFailure<> problem = textbook_slope();
    problem.bolt = {{100e3, 0.1, 6, BoltAction::active}};
    EXPECT_EQ(derivative(problem, "bolt[1].head_height"), 0);
    EXPECT_GT(derivative(problem, "bolt[1].force"), 0);
}

}  // namespace
}  // namespace delabole
