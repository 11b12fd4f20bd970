#include "fitting/search/gaussian_process.hpp"

#include "fitting/probability/counted_random.hpp"
#include "fitting/probability/distribution.hpp"
#include "fitting/probability/estimate.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace delabole {
namespace {

double wave(double x, double y) {
    return std::sin(4 * x) + 0.5 * y * y;
}

struct Scattered {
    Eigen::MatrixXd points;
    Eigen::VectorXd values;
};

Scattered scattered(std::size_t count, double noise) {
    const std::vector<std::vector<double>> sobol = sobol_points(2, count);
    const CountedRandom random(7, RandomPurpose::jitter);
    Scattered data{Eigen::MatrixXd(count, 2), Eigen::VectorXd(count)};
    for (std::size_t index = 0; index < count; ++index) {
        const auto row = static_cast<Eigen::Index>(index);
        data.points(row, 0) = sobol[index][0];
        data.points(row, 1) = sobol[index][1];
        data.values[row] = wave(sobol[index][0], sobol[index][1]) + noise * normal_quantile(random.unit(index));
    }
    return data;
}

TEST(GaussianProcess, SmoothFunctionIsKnownBetweenItsPoints) {
    const Scattered data = scattered(40, 0);
    const GaussianProcess process(data.points, data.values);
    for (const std::array<double, 2> at : {std::array{0.31, 0.47}, {0.62, 0.2}, {0.77, 0.83}}) {
        const ProcessPrediction predicted = process.predict(at);
        // Forty points over a wave of one length: a hundredth of its height; five deviations are as good as certain.
        EXPECT_NEAR(predicted.mean, wave(at[0], at[1]), 0.01);
        EXPECT_NEAR(predicted.mean, wave(at[0], at[1]), 5 * std::sqrt(predicted.variance) + 1e-9);
    }
    // Far outside nothing is known but the level.
    EXPECT_GT(process.predict(std::array{9.0, 9.0}).variance, 0.5 * process.amplitude() * process.amplitude());
}

TEST(GaussianProcess, ScatterIsToldFromTheFunction) {
    const Scattered data = scattered(150, 0.2);
    const GaussianProcess process(data.points, data.values);
    // The standard deviation of 150 numbers is known to 1 / sqrt(2 * 150) = 6 %; three of these, and some for the fit.
    EXPECT_NEAR(std::sqrt(process.scatter_variance()), 0.2, 0.05);
    const ProcessPrediction predicted = process.predict(std::array{0.5, 0.5});
    EXPECT_NEAR(predicted.mean, wave(0.5, 0.5), 0.15);
    EXPECT_LT(predicted.variance, 0.01);
}

TEST(GaussianProcess, LeaveOneOutIsThePredictionWithoutThePoint) {
    const Scattered data = scattered(12, 0.05);
    const GaussianProcess whole(data.points, data.values);
    const std::vector<ProcessPrediction> predicted = whole.leave_one_out();
    for (Eigen::Index left_out = 0; left_out < 12; ++left_out) {
        Eigen::MatrixXd points(11, 2);
        Eigen::VectorXd values(11);
        for (Eigen::Index row = 0; row < 11; ++row) {
            points.row(row) = data.points.row(row < left_out ? row : row + 1);
            values[row] = data.values[row < left_out ? row : row + 1];
        }
        const GaussianProcess part(points, values, whole.shape());
        const std::array<double, 2> at{data.points(left_out, 0), data.points(left_out, 1)};
        // Two ways through the same equations: rounding times the condition of twelve points.
        EXPECT_NEAR(predicted[static_cast<std::size_t>(left_out)].mean, part.predict(at).mean, 1e-8);
        // The amplitude is that of all points in the one and of eleven in the other.
        const double scale = std::pow(whole.amplitude() / part.amplitude(), 2);
        EXPECT_NEAR(predicted[static_cast<std::size_t>(left_out)].variance,
                    scale * (part.predict(at).variance + part.scatter_variance()), 1e-8);
    }
}

TEST(GaussianProcess, ConstantIsKnownEverywhere) {
    const Scattered data = scattered(6, 0);
    const GaussianProcess process(data.points, Eigen::VectorXd::Constant(6, 3.5));
    EXPECT_EQ(process.scatter_variance(), 0);
    EXPECT_NEAR(process.predict(std::array{0.1, 0.9}).mean, 3.5, 1e-9);  // rounding of a solved system
    EXPECT_EQ(process.predict(std::array{0.1, 0.9}).variance, 0);
}

}  // namespace
}  // namespace delabole
