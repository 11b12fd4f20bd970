#include "fitting/posterior/evidence.hpp"

#include "fitting/probability/sampling.hpp"
#include "fitting/probability/student_mixture.hpp"

#include "tests/fitting/posterior_targets.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace delabole {
namespace {

using test::evidence;
using test::sample;
using test::square;
using test::Target;

struct Known {
    std::string name;
    Target target;
    double log_evidence;
};

std::vector<Known> known() {
    // The sum on the ridge has prior variance 2 and error 0.05.
    const double ridge =
        std::log(0.05 * std::sqrt(2 * std::numbers::pi)) + std::log(test::normal_density(1, 0, std::sqrt(2.0025)));
    return {{"cut normal", test::cut_normal(), test::cut_normal_evidence},
            {"ridge", test::ridge(), ridge},
            {"banana", test::banana(), test::banana_evidence},
            {"two modes", test::two_modes(), test::two_modes_evidence}};
}

TEST(Evidence, OfKnownTargetsLiesWithinItsError) {
    for (const Known& item : known()) {
        const Evidence found = evidence(item.target, sample(item.target).draws);
        ASSERT_EQ(found.status, EvidenceStatus::estimated) << item.name;
        // 4.1 of Student's distribution with 15 degrees of freedom has probability 0.001; the bounds cut off up to 1e-4
        // of the closed forms.
        EXPECT_NEAR(found.log_evidence, item.log_evidence, 4.1 * found.standard_error + 2e-4) << item.name;
        EXPECT_LT(found.standard_error, 0.02) << item.name;
        EXPECT_GT(found.effective_size, 2000) << item.name;
        EXPECT_EQ(found.failed_share, 0) << item.name;
    }
}

TEST(Evidence, ErrsAsMuchAsItsErrorSays) {
    const Known ridge = known()[1];
    const std::vector<Draw> draws = sample(ridge.target).draws;
    double squares = 0;
    constexpr int repetitions = 40;
    for (std::uint64_t seed = 1; seed <= repetitions; ++seed) {
        const Evidence found = evidence(ridge.target, draws, {128, 16, seed});
        squares += square((found.log_evidence - ridge.log_evidence) / found.standard_error) / repetitions;
    }
    // The mean of 40 squares of Student's distribution with 15 degrees of freedom is 1.15 +- 0.29.
    EXPECT_GT(squares, 0.4);
    EXPECT_LT(squares, 2.3);
}

TEST(Evidence, FindsAModeThatTheDrawsMissed) {
    const Target target = test::two_modes();
    std::vector<Draw> draws;
    for (const Draw& draw : sample(target).draws) {
        if (draw.parameters[0] > 0) {
            draws.push_back(draw);
        }
    }
    const Evidence found = evidence(target, draws, {2048, 16, 1});
    EXPECT_NEAR(found.log_evidence, test::two_modes_evidence, 4.1 * found.standard_error + 1e-4);
    // Pilot points of the prior find the mode; else a fourth of the evidence would rest on the prior's share.
    EXPECT_LT(found.standard_error, 0.01);
}

TEST(Evidence, NeedsNoDraws) {
    const Evidence found = evidence(test::cut_normal(), {});
    EXPECT_NEAR(found.log_evidence, test::cut_normal_evidence, 4.1 * found.standard_error + 1e-6);
}

TEST(Evidence, CountsPointsWithoutAnswerAsUnlikely) {
    // Half of the prior has no answer, the likelihood is 1 in the other half.
    test::Study study([](std::span<const double> x) { return x[0] < 0.5 ? Evaluation{0, "no"} : Evaluation{0, {}}; });
    const PriorSpace prior({test::free_parameter("x1", 0, 1)});
    const Evidence found = estimate_evidence(study.evaluator(), prior, {}, {});
    // Each replicate of 512 points of the sequence holds 256 in each half.
    EXPECT_NEAR(found.log_evidence, std::log(0.5), 1e-12);
    EXPECT_NEAR(found.failed_share, 0.5, 1e-12);

    test::Study nothing([](std::span<const double>) { return Evaluation{0, "no"}; });
    const Evidence none = estimate_evidence(nothing.evaluator(), prior, {}, {});
    EXPECT_EQ(none.status, EvidenceStatus::no_valid_point);
    EXPECT_EQ(none.log_evidence, -std::numeric_limits<double>::infinity());
    EXPECT_EQ(none.failed_share, 1);
}

TEST(Evidence, IsTheSameForAnyNumberOfThreads) {
    const std::vector<Draw> draws = sample(test::banana()).draws;
    EXPECT_EQ(evidence(test::banana(), draws, {}, 1).log_evidence, evidence(test::banana(), draws, {}, 3).log_evidence);
}

TEST(Evidence, OfAModelWithoutFreeParametersIsItsLikelihood) {
    const Target target{{test::free_parameter("x1", 2, 2)}, [](std::span<const double> x) { return square(x[0]); }};
    EXPECT_EQ(evidence(target, {}).log_evidence, -2);
}

TEST(StudentMixture, IsADensityAndDrawsFromIt) {
    // The points lie on a bent line.
    Eigen::MatrixXd points(2, 1200);
    for (Eigen::Index index = 0; index < points.cols(); ++index) {
        const double x = -2 + 4 * static_cast<double>(index) / 1199;
        points.col(index) << x, x * x + 0.1 * std::sin(37 * static_cast<double>(index));
    }
    const StudentMixture mixture(points, Eigen::VectorXd::Ones(points.cols()), 8, 1);
    EXPECT_GT(mixture.size(), 3U);
    const auto in_box = [](double x, double y) { return x > 0.5 && x < 1.5 && y > 0.5 && y < 1.5; };
    double whole = 0;
    double box = 0;
    constexpr double step = 0.04;  // about half the width of the line: the sum is as good as the integral
    for (double x = -6 + step / 2; x < 6; x += step) {
        for (double y = -6 + step / 2; y < 10; y += step) {
            const double share = step * step * std::exp(mixture.log_density(std::vector<double>{x, y}));
            whole += share;
            box += in_box(x, y) ? share : 0;
        }
    }
    EXPECT_NEAR(whole, 1, 0.01);  // the tails reach further

    const SamplePlan plan(SamplingMethod::sobol_sequence, mixture.unit_dimension(), 1 << 15, 1, 3);
    double drawn = 0;
    std::vector<double> unit(mixture.unit_dimension());
    std::vector<double> point(2);
    for (std::size_t index = 0; index < plan.size(); ++index) {
        plan.point(index, unit);
        mixture.draw(unit, point);
        drawn += in_box(point[0], point[1]) ? 1.0 / static_cast<double>(plan.size()) : 0;
    }
    EXPECT_NEAR(drawn, box, 0.008);  // three standard errors of 32 768 independent draws, and the grid's edges
}

}  // namespace
}  // namespace delabole
