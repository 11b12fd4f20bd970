#include "fitting/posterior/posterior.hpp"

#include "tests/fitting/posterior_targets.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>

namespace delabole {
namespace {

using test::free_parameter;
using test::sample;
using test::square;
using test::Target;
using test::with_prior;

double standard_error(const ParameterPosterior& parameter) {
    return parameter.standard_deviation / std::sqrt(parameter.diagnostics.bulk_size);
}

TEST(Posterior, OfANormalDatumAndACutNormalPriorIsThatOfTheTextbook) {
    const Posterior posterior = sample(test::cut_normal());
    ASSERT_EQ(posterior.status, PosteriorStatus::converged);
    const ParameterPosterior& x = posterior.parameters.front();
    // The mean of the cut normal is m + s (density(lower) - density(upper)) / share, in standard numbers.
    const double s = std::sqrt(0.2);
    const double mean =
        0.8 + 0.2 * (test::normal_density(-0.5, 0.8, s) - test::normal_density(1.5, 0.8, s)) / test::cut_normal_share;
    EXPECT_NEAR(x.mean, mean, 4 * standard_error(x));
    const auto quantile = [&](double share) {
        const double lower = normal_probability(-1.3 / s).below;
        return 0.8 + s * normal_quantile(lower + share * test::cut_normal_share);
    };
    // Four standard errors of a tail quantile: sqrt(0.025 0.975 / size) over the density there, about 0.15 and 0.45.
    EXPECT_NEAR(x.interval_95.lower, quantile(0.025), 4 * 0.156 / std::sqrt(x.diagnostics.tail_size) / 0.15);
    EXPECT_NEAR(x.interval_95.upper, quantile(0.975), 4 * 0.156 / std::sqrt(x.diagnostics.tail_size) / 0.3);
    EXPECT_NEAR(x.median, quantile(0.5), 5 * standard_error(x));
    EXPECT_EQ(posterior.draws.size(), 4000U);
    for (const Draw& draw : posterior.draws) {
        EXPECT_GE(draw.parameters[0], -0.5);
        EXPECT_LE(draw.parameters[0], 1.5);
        EXPECT_DOUBLE_EQ(draw.misfit, square((draw.parameters[0] - 1) / 0.5));
    }
}

TEST(Posterior, OfARidgeHasItsCorrelation) {
    const Posterior posterior = sample(test::ridge());
    ASSERT_EQ(posterior.status, PosteriorStatus::converged);
    // The sum has mean 2 / 2.0025 and variance 2 * 0.0025 / 2.0025, the difference keeps mean 0 and variance 2.
    const double sum = 2 * 0.0025 / 2.0025;
    const double deviation = std::sqrt((2 + sum) / 4);
    for (const ParameterPosterior& parameter : posterior.parameters) {
        EXPECT_NEAR(parameter.mean, 1 / 2.0025, 4 * standard_error(parameter));
        // Relative standard error of a deviation 1 / sqrt(2 size); size > 400.
        EXPECT_NEAR(parameter.standard_deviation, deviation, 4 * deviation / std::sqrt(800.0));
    }
    // The correlation errs by (1 - r^2) / sqrt(size) = 3e-4 at most.
    EXPECT_NEAR(posterior.correlation(0, 1), (sum - 2) / (sum + 2), 1e-3);
}

TEST(Posterior, FollowsABentRidgeAndWeighsModesByTheirContent) {
    const Posterior banana = sample(test::banana());
    ASSERT_EQ(banana.status, PosteriorStatus::converged);
    EXPECT_NEAR(banana.parameters[0].mean, 0, 4 * standard_error(banana.parameters[0]));
    // x2 is chi-square with one degree of freedom: mean 1.
    EXPECT_NEAR(banana.parameters[1].mean, 1, 4 * standard_error(banana.parameters[1]));
    EXPECT_NEAR(banana.parameters[0].standard_deviation, 1, 0.12);  // as above, size > 400

    const Posterior modes = sample(test::two_modes());
    ASSERT_EQ(modes.status, PosteriorStatus::converged);
    // The modes weigh three to one, so the mean is 2; their indicators have deviation 0.43 of the distance 8.
    EXPECT_NEAR(modes.parameters[0].mean, 2, 4 * standard_error(modes.parameters[0]));
}

TEST(Posterior, MeansErrAsMuchAsTheirEffectiveSizeSays) {
    double squares = 0;
    constexpr int repetitions = 40;
    for (std::uint64_t seed = 1; seed <= repetitions; ++seed) {
        PosteriorSettings settings;
        settings.seed = seed;
        settings.draws = 2000;
        const Posterior posterior = sample(test::ridge(), settings);
        const ParameterPosterior& x = posterior.parameters.front();
        squares += square((x.mean - 1 / 2.0025) / standard_error(x)) / repetitions;
    }
    // Chi-square with 40 degrees over 40: within 0.4 and 1.9 with probability 0.999.
    EXPECT_GT(squares, 0.4);
    EXPECT_LT(squares, 1.9);
}

TEST(Posterior, IsTheSameForAnyNumberOfThreadsAndAnotherForAnotherSeed) {
    const Posterior one = sample(test::banana(), {}, 1);
    const Posterior three = sample(test::banana(), {}, 3);
    ASSERT_EQ(one.draws.size(), three.draws.size());
    for (std::size_t index = 0; index < one.draws.size(); ++index) {
        EXPECT_EQ(one.draws[index].parameters, three.draws[index].parameters);
    }
    EXPECT_EQ(one.evaluations.total, three.evaluations.total);
    PosteriorSettings other;
    other.seed = 2;
    EXPECT_NE(one.draws.front().parameters, sample(test::banana(), other).draws.front().parameters);
}

TEST(Posterior, LeavesOutWhatHasNoAnswer) {
    Target target = test::cut_normal();
    test::Study study([](std::span<const double> x) {
        return x[0] > 1 ? Evaluation{0, "too_steep"} : Evaluation{square((x[0] - 1) / 0.5), {}};
    });
    const Posterior posterior = sample_posterior(study.evaluator(), PriorSpace(target.parameters), {});
    EXPECT_EQ(posterior.status, PosteriorStatus::converged);
    for (const Draw& draw : posterior.draws) {
        EXPECT_LE(draw.parameters[0], 1);
    }
    ASSERT_EQ(posterior.evaluations.failed_by_cause.size(), 1U);
    EXPECT_EQ(posterior.evaluations.failed_by_cause.front().first, "too_steep");
}

TEST(Posterior, SaysWhenNothingHasAnAnswerAndCountsTheCauses) {
    test::Study study([](std::span<const double>) { return Evaluation{0, "crack_below_plane"}; });
    const Posterior posterior = sample_posterior(study.evaluator(), PriorSpace({free_parameter("x1", 0, 1)}), {});
    EXPECT_EQ(posterior.status, PosteriorStatus::no_valid_point);
    EXPECT_TRUE(posterior.draws.empty());
    EXPECT_EQ(posterior.evaluations.failed(), posterior.evaluations.total);
}

TEST(Posterior, IsNotCalledConvergedWhereTheWalkIsTooShort) {
    PosteriorSettings settings;
    settings.draws = 64;  // 8 draws of each chain are too few for an effective size of 400
    settings.evaluations_per_chain = 16;
    EXPECT_EQ(sample(test::banana(), settings).status, PosteriorStatus::not_converged);
}

TEST(Posterior, StopsWhenAsked) {
    const std::atomic<bool> stop = true;
    const Posterior posterior = sample(test::ridge(), {}, 2, &stop);
    EXPECT_EQ(posterior.status, PosteriorStatus::interrupted);
    EXPECT_LT(posterior.evaluations.total, 100);
}

TEST(Posterior, KeepsFixedParametersAndNeedsNoFreeOne) {
    const Target half{{free_parameter("x1", 2, 2), with_prior("x2", -8, 8, 0, 1)},
                      [](std::span<const double> x) { return square(x[0] - x[1]); }};
    const Posterior posterior = sample(half);
    ASSERT_EQ(posterior.parameters.size(), 1U);
    EXPECT_EQ(posterior.parameters.front().name, "x2");
    EXPECT_EQ(posterior.draws.front().parameters.front(), 2);
    EXPECT_NEAR(posterior.parameters.front().mean, 1, 4 * standard_error(posterior.parameters.front()));

    const Target none{{free_parameter("x1", 2, 2)}, [](std::span<const double> x) { return square(x[0]); }};
    const Posterior point = sample(none);
    EXPECT_EQ(point.status, PosteriorStatus::converged);
    ASSERT_EQ(point.draws.size(), 1U);
    EXPECT_EQ(point.draws.front().misfit, 4);
}

TEST(PriorSpace, DrawsWithinTheBoundsAndFindsItsWayBack) {
    const PriorSpace prior({with_prior("x1", 0, 3, 5, 1), free_parameter("x2", -2, 4)});
    for (const double number : {-6.0, -1.0, 0.0, 2.5, 6.0}) {
        const std::vector<double> normal = {number, -number / 2};
        std::vector<double> parameters(2);
        prior.values(normal, parameters);
        EXPECT_GT(parameters[0], 0);
        EXPECT_LT(parameters[0], 3);
        const std::vector<double> back = prior.coordinates(parameters);
        // Near a bound the parameter itself is rounded: 1e-16 over a density of 1e-9.
        EXPECT_NEAR(back[0], number, 1e-5);
        EXPECT_NEAR(back[1], -number / 2, 1e-9);
    }
}

TEST(PriorSpace, RefusesAPriorWithNothingBetweenTheBounds) {
    EXPECT_TRUE(fault_of_prior(with_prior("x1", 0, 1, 0.5, 1)).empty());
    EXPECT_FALSE(fault_of_prior(with_prior("x1", 0, 1, 20, 1)).empty());
    EXPECT_FALSE(fault_of_prior(free_parameter("x1", 1, 0)).empty());
    EXPECT_THROW(PriorSpace({with_prior("x1", 0, 1, 20, 1)}), std::invalid_argument);
}

}  // namespace
}  // namespace delabole
