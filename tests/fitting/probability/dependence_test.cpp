#include "fitting/probability/dependence.hpp"

#include "fitting/probability/sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace delabole {
namespace {

const Marginal cohesion({Normal{100e3, 20e3}});
const Marginal friction({Normal{0.6, 0.09}});

TEST(Dependence, NormalsKeepTheirCorrelation) {
    for (const double coefficient : {-0.9, -0.5, 0.0, 0.3, 0.99}) {
        const auto found = normal_correlation(cohesion, friction, CorrelationMeasure::linear, coefficient);
        EXPECT_EQ(found.check, DependenceCheck::valid);
        EXPECT_NEAR(found.coefficient, coefficient, 1e-12);
    }
}

TEST(Dependence, LognormalsAsInClosedForm) {
    // r = (exp(z s1 s2) - 1) / sqrt((exp(s1^2) - 1) (exp(s2^2) - 1))
    const double v1 = 0.3;
    const double v2 = 0.8;
    const double s1 = std::sqrt(std::log1p(v1 * v1));
    const double s2 = std::sqrt(std::log1p(v2 * v2));
    const Marginal one({Lognormal{10, 10 * v1}});
    const Marginal other({Lognormal{3, 3 * v2}});
    for (const double coefficient : {-0.6, -0.3, 0.2, 0.9}) {
        const auto found = normal_correlation(one, other, CorrelationMeasure::linear, coefficient);
        EXPECT_NEAR(found.coefficient, std::log1p(coefficient * v1 * v2) / (s1 * s2), 1e-9);
    }
    // The least correlation is that at z = -1, -0.76 here.
    const auto beyond = normal_correlation(one, other, CorrelationMeasure::linear, -0.8);
    EXPECT_EQ(beyond.check, DependenceCheck::coefficient_out_of_reach);
    EXPECT_NEAR(beyond.reach.lower, std::expm1(-s1 * s2) / (v1 * v2), 1e-9);
    EXPECT_NEAR(beyond.reach.upper, std::expm1(s1 * s2) / (v1 * v2), 1e-9);
}

TEST(Dependence, UniformsAsInClosedForm) {
    // r = 6 asin(z / 2) / pi, for uniform parameters linear and rank correlation alike.
    const Marginal uniform({Uniform{0, 1}});
    for (const double coefficient : {-0.95, -0.5, 0.1, 0.7, 0.95}) {
        const double expected = 2 * std::sin(std::numbers::pi * coefficient / 6);
        EXPECT_NEAR(normal_correlation(uniform, uniform, CorrelationMeasure::linear, coefficient).coefficient, expected,
                    1e-9);
        EXPECT_NEAR(normal_correlation(uniform, uniform, CorrelationMeasure::rank, coefficient).coefficient, expected,
                    1e-15);
    }
}

TEST(Dependence, SamplesHaveTheCorrelationAskedFor) {
    const Marginal water({Exponential{0.5}, 0, 1});
    const Marginal depth({Beta{14, 4, 0, 24.75}});
    constexpr double asked = -0.5;
    const InputSpace space({water, depth}, {{0, 1, CorrelationMeasure::linear, asked}});
    ASSERT_EQ(space.check(), DependenceCheck::valid);
    EXPECT_FALSE(space.independent());
    const SamplePlan plan(SamplingMethod::sobol_sequence, 2, 1 << 14, 1, 3);
    double product = 0;
    std::array<double, 2> unit{};
    std::array<double, 2> values{};
    for (std::size_t index = 0; index < plan.size(); ++index) {
        plan.point(index, unit);
        space.values_of_unit(unit, values);
        product += (values[0] - water.mean()) / water.standard_deviation() *
                   ((values[1] - depth.mean()) / depth.standard_deviation());
    }
    // 16 384 points of a sequence: a few 1e-4.
    EXPECT_NEAR(product / static_cast<double>(plan.size()), asked, 2e-3);
}

TEST(Dependence, ContradictingCorrelationsAreRefused) {
    const std::vector<Marginal> three(3, cohesion);
    const auto with = [&](double third) {
        return InputSpace(three, {{0, 1, CorrelationMeasure::linear, 0.9},
                                  {1, 2, CorrelationMeasure::linear, 0.9},
                                  {0, 2, CorrelationMeasure::linear, third}})
            .check();
    };
    // With 0.9 and 0.9 the third lies above 2 0.9^2 - 1 = 0.62.
    EXPECT_EQ(with(0.61), DependenceCheck::not_positive_definite);
    EXPECT_EQ(with(0.63), DependenceCheck::valid);
    EXPECT_EQ(with(-0.9), DependenceCheck::not_positive_definite);
}

TEST(Dependence, ParameterAtItsMedianWhereNothingIsKnown) {
    const InputSpace space({cohesion, friction}, {{0, 1, CorrelationMeasure::rank, 0.8}});
    std::array<double, 2> values{};
    space.values(std::array{0.0, 0.0}, values);
    EXPECT_EQ(values[0], 100e3);
    EXPECT_EQ(values[1], 0.6);
}

}  // namespace
}  // namespace delabole
