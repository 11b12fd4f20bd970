#include "fitting/studies/recovery.hpp"
#include "tests/fitting/test_models.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace delabole {
namespace {

using test::answer;
using test::formula_model;

// Shares and bias have to be within 3.3 of their standard errors, and ranks as even as chance leaves them: a sound
// sampler misses each of the four once in a thousand times.
void expect_calibrated(const ParameterRecovery& parameter, int counted) {
    const auto error = [&](double share) { return 3.3 * std::sqrt(share * (1 - share) / counted); };
    EXPECT_NEAR(parameter.coverage_68.value, 0.683, error(0.683)) << parameter.name;
    EXPECT_NEAR(parameter.coverage_95.value, 0.95, error(0.95)) << parameter.name;
    // A residual has a standard deviation of about 1.
    EXPECT_NEAR(parameter.bias.value, 0, 3.3 / std::sqrt(counted)) << parameter.name;
    EXPECT_GT(parameter.uniformity, 0.001) << parameter.name;
}

// Two parameters, two data of which one is their sum: a normal posterior.
FitProblem linear() {
    return test::problem_of(formula_model(2, {"sum", "second"},
                                          [](std::span<const double> x) {
                                              return answer({x[0] + x[1], x[1]});
                                          }),
                            {test::with_prior("x1", -10, 10, 1, 1), test::with_prior("x2", -10, 10, 0, 2)},
                            {test::observe("sum", 1, 0.5), test::observe("second", 0, 1)});
}

RecoverySettings quick(int repetitions) {
    RecoverySettings settings;
    settings.repetitions = repetitions;
    settings.posterior.chains = 4;
    settings.posterior.draws = 1000;
    settings.threads = 2;
    return settings;
}

MechanismRecovery recovery_of(const FitProblem& problem, const RecoverySettings& settings) {
    ProgressMeter progress({}, 1);
    return recover(problem.mechanisms.front(), problem, settings, progress);
}

TEST(Recovery, FindsALinearGaussianCalibrated) {
    const MechanismRecovery result = recovery_of(linear(), quick(80));
    EXPECT_EQ(result.without_truth, 0);
    EXPECT_GT(result.counted, 75) << result.not_converged << " did not converge";
    ASSERT_EQ(result.parameters.size(), 2U);
    for (const ParameterRecovery& parameter : result.parameters) {
        expect_calibrated(parameter, result.counted);
    }
    // The precisions of x2 are 1 / 4 of the prior, 1 of the datum and 1 / (1 + 0.25) of the sum. The spread is the same
    // for all data; draws give it to a few per cent.
    EXPECT_NEAR(result.parameters[1].spread, 1 / std::sqrt(0.25 + 1 + 0.8), 0.02);
}

// Three standard deviations off the prior's mean, which pulls by more than the posterior is wide.
TEST(Recovery, SeesThatThePriorPulls) {
    RecoverySettings settings = quick(30);
    settings.truth = {4, 0};
    const MechanismRecovery result = recovery_of(linear(), settings);
    // In closed form the mean of x1 misses 4 by 3 x (share of the prior in its precision) = 3 / (1 + 1 / 1.05) = 1.5,
    // 2.1 standard deviations of the posterior.
    EXPECT_LT(result.parameters[0].bias.interval_95.upper, -1.5);
    EXPECT_LT(result.parameters[0].coverage_95.interval_95.upper, 0.9);
}

// The data include an inequality that the prior breaks half the time.
TEST(Recovery, KeepsRanksUniformWithInequalities) {
    FitProblem problem = linear();
    problem.observations[1] = test::observe("second", 0, 0.3, Relation::at_least);
    const MechanismRecovery result = recovery_of(problem, quick(60));
    EXPECT_GT(result.counted, 55);
    for (const ParameterRecovery& parameter : result.parameters) {
        expect_calibrated(parameter, result.counted);
    }
}

TEST(Recovery, DrawsNoTruthWithoutAnAnswer) {
    FitProblem problem = linear();
    problem.mechanisms[0].model = formula_model(2, {"sum", "second"}, [](std::span<const double> x) {
        return x[0] < 1 ? Prediction{"too_small", {}, {}} : answer({x[0] + x[1], x[1]});
    });
    for (const Recovered& one : recovery_of(problem, quick(8)).repetitions) {
        ASSERT_TRUE(one.has_truth);
        EXPECT_GE(one.truth[0], 1);
    }
    problem.mechanisms[0].model = formula_model(2, {"sum", "second"}, [](std::span<const double>) {
        return Prediction{"always", {}, {}};
    });
    const MechanismRecovery none = recovery_of(problem, quick(3));
    EXPECT_EQ(none.without_truth, 3);
    EXPECT_EQ(none.counted, 0);
    EXPECT_TRUE(none.parameters.empty());
}

TEST(Recovery, IsTheSameOnAnyNumberOfThreads) {
    RecoverySettings settings = quick(4);
    const MechanismRecovery two = recovery_of(linear(), settings);
    settings.threads = 1;
    const MechanismRecovery one = recovery_of(linear(), settings);
    for (std::size_t index = 0; index < one.repetitions.size(); ++index) {
        EXPECT_EQ(one.repetitions[index].mean, two.repetitions[index].mean);
        EXPECT_EQ(one.repetitions[index].rank, two.repetitions[index].rank);
    }
}

}  // namespace
}  // namespace delabole
