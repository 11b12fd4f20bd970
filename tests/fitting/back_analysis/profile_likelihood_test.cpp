#include "fitting/back_analysis/back_analysis.hpp"
#include "tests/fitting/test_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace delabole {
namespace {

using test::answer;
using test::formula_model;
using test::observe;

constexpr double z_95 = 1.959963985;  // normal quantile

const ProfileLikelihood& profile(const MechanismFit& fit, const std::string& parameter, bool with_priors) {
    return *std::find_if(fit.profiles.begin(), fit.profiles.end(), [&](const ProfileLikelihood& entry) {
        return entry.parameter == parameter && entry.with_priors == with_priors;
    });
}

// a = x1 + x2, b = x1 - x2, c = x1 + 2 x2 with known deviations: normal posterior, covariance by hand.
MechanismFit linear_gaussian() {
    const ModelInterface model = formula_model(2, {"a", "b", "c"}, [](std::span<const double> x) {
        return answer({x[0] + x[1], x[0] - x[1], x[0] + 2 * x[1]});
    });
    const FitProblem problem =
        test::problem_of(model, {test::free_parameter("x1", -10, 10), test::with_prior("x2", -10, 10, 2, 0.5)},
                         {observe("a", 3, 0.5), observe("b", 1, 1), observe("c", 4, 0.25)});
    return fit(problem).mechanisms[0];
}

TEST(ProfileLikelihood, HasTheExactIntervalsOfALinearGaussianProblem) {
    const MechanismFit result = linear_gaussian();
    // Information of the data: rows (1, 1)/0.5, (1, -1)/1, (1, 2)/0.25
    const double a = 4 + 1 + 16;
    const double b = 4 - 1 + 32;
    const double c = 4 + 1 + 64;
    const double right_1 = 12 + 1 + 64;
    const double right_2 = 12 - 1 + 128;
    for (const bool with_priors : {false, true}) {
        const double c_used = c + (with_priors ? 4 : 0);
        const double right_2_used = right_2 + (with_priors ? 8 : 0);
        const double determinant = a * c_used - b * b;
        const double best = (c_used * right_1 - b * right_2_used) / determinant;
        const double deviation = std::sqrt(c_used / determinant);
        const ProfileLikelihood& curve = profile(result, "x1", with_priors);
        // 1e-3 deviations: the roots' tolerance is 1e-4 of sqrt(misfit), each minimum's 1e-6 of misfit
        EXPECT_NEAR(curve.interval_68.lower, best - deviation, 1e-3 * deviation);
        EXPECT_NEAR(curve.interval_68.upper, best + deviation, 1e-3 * deviation);
        EXPECT_NEAR(curve.interval_95.lower, best - z_95 * deviation, 1e-3 * deviation);
        EXPECT_NEAR(curve.interval_95.upper, best + z_95 * deviation, 1e-3 * deviation);
        EXPECT_EQ(curve.determination, Determination::determined);
        for (std::size_t index = 0; index < curve.values.size(); ++index) {
            const double residual = (curve.values[index] - best) / deviation;
            EXPECT_NEAR(curve.misfits[index] - curve.least_misfit, residual * residual,
                        1e-5 + 1e-6 * residual * residual);
        }
    }
    const double determinant = a * (c + 4) - b * b;
    ASSERT_TRUE(result.identifiability.covariance);
    EXPECT_NEAR((*result.identifiability.covariance)(0, 0), (c + 4) / determinant, 1e-9);
    EXPECT_NEAR((*result.identifiability.covariance)(0, 1), -b / determinant, 1e-9);
    EXPECT_EQ(result.identifiability.rank, 2);
    EXPECT_EQ(result.status, FitStatus::converged);
}

TEST(ProfileLikelihood, IsSortedAndHoldsTheBestValue) {
    const MechanismFit result = linear_gaussian();
    const ProfileLikelihood& curve = profile(result, "x1", true);
    EXPECT_TRUE(std::is_sorted(curve.values.begin(), curve.values.end()));
    EXPECT_EQ(std::count(curve.values.begin(), curve.values.end(), result.best[0]), 1);
    EXPECT_GE(curve.values.size(), 41u);
    EXPECT_EQ(curve.values.front(), -10);
    EXPECT_EQ(curve.values.back(), 10);
    EXPECT_NEAR(*std::min_element(curve.misfits.begin(), curve.misfits.end()), result.misfit, 1e-9);
}

TEST(ProfileLikelihood, IsUndeterminedAlongTheFailureLine) {
    // FS = 1 holds along x2 = 2 x1 - 1: every x1 from 0.5 to 1 and every x2 has an exact answer.
    const FitProblem problem =
        test::problem_of(test::linear_safety(), {test::free_parameter("x1", 0, 1), test::free_parameter("x2", 0, 1)},
                         {observe("factor_of_safety", 1, 0.05)});
    const MechanismFit result = fit(problem).mechanisms[0];
    EXPECT_EQ(result.profiles.size(), 4u);
    const ProfileLikelihood& first = profile(result, "x1", false);
    // The misfit rises there only because x2 may not be less than 0, which is no evidence.
    EXPECT_EQ(first.determination, Determination::undetermined);
    EXPECT_EQ(first.lower_bounded_by, std::vector<std::string>{"x2"});
    EXPECT_TRUE(first.upper_bounded_by.empty());
    EXPECT_NEAR(first.interval_95.lower, 0.5 - z_95 * 0.05 / 0.8, 1e-4);  // x2 = 0 and FS = 1 - 1.96 sd
    EXPECT_EQ(first.interval_95.upper, 1);
    const ProfileLikelihood& second = profile(result, "x2", false);
    EXPECT_EQ(second.determination, Determination::undetermined);
    EXPECT_EQ(second.interval_95.lower, 0);
    EXPECT_EQ(second.interval_95.upper, 1);
    EXPECT_LT(*std::max_element(second.misfits.begin(), second.misfits.end()), 1e-5);
}

TEST(ProfileLikelihood, DoesNotTakeTheEndOfTheModelForEvidence) {
    const ModelInterface model = formula_model(1, {"a"}, [](std::span<const double> x) {
        return x[0] < 0.3 ? Prediction{"impossible", {}, {}} : answer({x[0]});
    });
    const FitProblem problem = test::problem_of(model, {test::free_parameter("x1", 0, 1)}, {observe("a", 0.4, 0.1)});
    const ProfileLikelihood curve = fit(problem).mechanisms[0].profiles[0];
    EXPECT_EQ(curve.determination, Determination::bounded_above);
    EXPECT_NEAR(curve.interval_95.lower, 0.3, 1e-4);
    EXPECT_NEAR(curve.interval_95.upper, 0.4 + z_95 * 0.1, 1e-4);
    EXPECT_TRUE(std::isinf(curve.misfits.front()));
}

TEST(ProfileLikelihood, SpansTwoMinima) {
    const ModelInterface model =
        formula_model(1, {"a"}, [](std::span<const double> x) { return answer({x[0] * x[0]}); });
    const FitProblem problem = test::problem_of(model, {test::free_parameter("x1", -3, 3)}, {observe("a", 1, 0.1)});
    const ProfileLikelihood curve = fit(problem).mechanisms[0].profiles[0];
    EXPECT_NEAR(curve.interval_68.lower, -std::sqrt(1.1), 1e-4);
    EXPECT_NEAR(curve.interval_68.upper, std::sqrt(1.1), 1e-4);
}

}  // namespace
}  // namespace delabole
