#include "fitting/studies/information.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace delabole {
namespace {

FitCandidate candidate(const std::string& label, double standard_deviation) {
    return {label, {label}, standard_deviation, {}, std::nullopt, ""};
}

constexpr int chains = 8;
constexpr int draws_per_chain = 500;

std::vector<int> chain_numbers() {
    std::vector<int> numbers;
    for (int chain = 0; chain < chains; ++chain) {
        numbers.insert(numbers.end(), draws_per_chain, chain);
    }
    return numbers;
}

// Draws of a normal posterior with two parameters; candidates measure linear combinations of them.
class LinearGaussian {
  public:
    LinearGaussian(double first, double second, double correlation) {
        covariance << first * first, correlation * first * second, correlation * first * second, second * second;
    }

    MechanismDraws draws(const std::vector<Eigen::Vector2d>& combinations, unsigned seed) const {
        MechanismDraws result{"linear", 1, {"a", "b"}, chain_numbers(), {}, {}};
        result.values.resize(2);
        result.predicted.resize(combinations.size());
        std::mt19937_64 engine(seed);
        std::normal_distribution<double> normal;
        const Eigen::Matrix2d root = covariance.llt().matrixL();
        for (std::size_t draw = 0; draw < result.chain.size(); ++draw) {
            const Eigen::Vector2d standard(normal(engine), normal(engine));
            const Eigen::Vector2d point = root * standard;
            result.values[0].push_back(point[0]);
            result.values[1].push_back(point[1]);
            for (std::size_t index = 0; index < combinations.size(); ++index) {
                result.predicted[index].push_back(combinations[index].dot(point));
            }
        }
        return result;
    }

    // Measuring combination a changes parameter `index`: the covariance falls by C a a' C / (a' C a + s^2).
    double reduction(const Eigen::Vector2d& combination, double deviation, int index) const {
        const Eigen::Vector2d column = covariance * combination;
        const double fall = column[index] * column[index] / (combination.dot(column) + deviation * deviation);
        return 1 - std::sqrt(1 - fall / covariance(index, index));
    }

    Eigen::Matrix2d covariance;
};

TEST(Information, IsThatOfALinearGaussian) {
    const LinearGaussian posterior(2, 0.5, -0.8);
    const std::vector<Eigen::Vector2d> combinations{{1, 0}, {1, 4}, {0, 1}};
    const std::vector<double> deviations{1, 0.5, 5};
    std::vector<FitCandidate> candidates;
    for (std::size_t index = 0; index < combinations.size(); ++index) {
        candidates.push_back(candidate("measurement " + std::to_string(index), deviations[index]));
    }
    const auto result = value_of_information(candidates, {posterior.draws(combinations, 1)}, {.outcomes = 512});
    for (std::size_t index = 0; index < combinations.size(); ++index) {
        const MechanismInformation& found = result[index].mechanisms.at(0);
        EXPECT_EQ(found.status, InformationStatus::found);
        for (int parameter = 0; parameter < 2; ++parameter) {
            const double exact = posterior.reduction(combinations[index], deviations[index], parameter);
            const ParameterInformation& one = found.parameters.at(static_cast<std::size_t>(parameter));
            // Four standard errors: one of the twelve comparisons errs by more in 1300 runs. The third hardly tells
            // anything, where the draws' own noise leaves a few thousandths.
            EXPECT_NEAR(one.standard_deviation.value, exact, 4 * one.standard_deviation.error + 0.003);
            EXPECT_NEAR(one.interval_95.value, exact, 4 * one.interval_95.error + 0.003);
            EXPECT_LT(one.standard_deviation.error, 0.03);
            EXPECT_EQ(result[index].over_mechanisms.at(static_cast<std::size_t>(parameter)).standard_deviation.value,
                      one.standard_deviation.value);
        }
        EXPECT_FALSE(result[index].about_mechanism.has_value());
    }
}

TEST(Information, ErrorsAreHonest) {
    const LinearGaussian posterior(1, 1, 0.5);
    const Eigen::Vector2d combination(1, 1);
    const double exact = posterior.reduction(combination, 0.7, 0);
    double squares = 0;
    constexpr unsigned runs = 40;
    for (unsigned seed = 1; seed <= runs; ++seed) {
        const auto result = value_of_information({candidate("sum", 0.7)}, {posterior.draws({combination}, seed)},
                                                 {.outcomes = 128, .seed = seed});
        const ExpectedReduction& one = result[0].mechanisms.at(0).parameters.at(0).standard_deviation;
        squares += std::pow((one.value - exact) / one.error, 2);
    }
    // A chi-square variable of 40 over 40 lies between 0.5 and 1.7 with 99.5 %; the jackknife's errors scatter too.
    EXPECT_GT(squares / runs, 0.4);
    EXPECT_LT(squares / runs, 2.2);
}

TEST(Information, SaysWhereDrawsAreTooFewOrAnswersMissing) {
    const LinearGaussian posterior(1, 1, 0);
    MechanismDraws draws = posterior.draws({{1, 0}, {1, 0}, {1, 0}}, 3);
    draws.predicted[1].clear();
    for (std::size_t draw = 0; draw < draws.chain.size() * 3 / 4; ++draw) {
        draws.predicted[2][(draw * 7919) % draws.chain.size()] = std::numeric_limits<double>::quiet_NaN();
    }
    const auto result =
        value_of_information({candidate("sharp", 0.001), candidate("silent", 1), candidate("failing", 1)}, {draws}, {});
    EXPECT_EQ(result[0].mechanisms.at(0).status, InformationStatus::few_draws_alike);
    EXPECT_EQ(result[1].mechanisms.at(0).status, InformationStatus::not_predicted);
    EXPECT_TRUE(result[1].mechanisms.at(0).parameters.empty());
    EXPECT_EQ(result[1].over_mechanisms.at(0).standard_deviation.value, 0);
    EXPECT_EQ(result[2].mechanisms.at(0).status, InformationStatus::few_answers);
    EXPECT_NEAR(result[2].mechanisms.at(0).without_answer, 0.75, 1e-12);
}

// Mutual information of a choice between two mechanisms and their normal outcomes, by quadrature.
double mutual_information(double probability, double distance, double deviation) {
    const auto density = [&](double z, double mean) {
        return std::exp(-0.5 * std::pow((z - mean) / deviation, 2)) / (deviation * std::sqrt(2 * M_PI));
    };
    const double step = deviation / 200;
    double sum = 0;
    for (double z = -12 * deviation; z < distance + 12 * deviation; z += step) {
        const double first = probability * density(z, 0);
        const double second = (1 - probability) * density(z, distance);
        const double all = first + second;
        sum += step * (first > 0 ? first * std::log(first / all / probability) : 0);
        sum += step * (second > 0 ? second * std::log(second / all / (1 - probability)) : 0);
    }
    return sum;
}

TEST(Information, AboutWhichMechanismItWas) {
    const LinearGaussian posterior(1, 1, 0);
    std::vector<MechanismDraws> mechanisms{posterior.draws({{1, 0}}, 5), posterior.draws({{1, 0}}, 6),
                                           posterior.draws({{1, 0}}, 7)};
    mechanisms[0].probability = 0.56;
    mechanisms[1].probability = 0.24;
    mechanisms[2].probability = 0.2;
    mechanisms[2].predicted[0].clear();  // says nothing: the other two are weighed alone, 0.7 to 0.3
    for (double& value : mechanisms[1].predicted[0]) {
        value += 3;
    }
    const double deviation = 0.8;
    const auto result = value_of_information({candidate("crack", deviation)}, mechanisms, {.outcomes = 1000});
    ASSERT_TRUE(result[0].about_mechanism.has_value());
    const double exact = mutual_information(0.7, 3, std::hypot(1.0, deviation));
    EXPECT_NEAR(result[0].about_mechanism->value, exact, 4 * result[0].about_mechanism->error);
    EXPECT_LT(result[0].about_mechanism->error, 0.02);
    // The mean is weighted over the mechanisms, of which the third gains nothing.
    const double gain = posterior.reduction({1, 0}, deviation, 0);
    const ExpectedReduction& over = result[0].over_mechanisms.at(0).standard_deviation;
    EXPECT_NEAR(over.value, 0.8 * gain, 4 * over.error);
}

TEST(Information, IsTheSameOnAnyNumberOfThreads) {
    const LinearGaussian posterior(1, 1, 0.3);
    const auto one = value_of_information({candidate("a", 0.5)}, {posterior.draws({{1, 0}}, 1)}, {.threads = 1});
    const auto three = value_of_information({candidate("a", 0.5)}, {posterior.draws({{1, 0}}, 1)}, {.threads = 3});
    EXPECT_EQ(one[0].mechanisms[0].parameters[0].standard_deviation.value,
              three[0].mechanisms[0].parameters[0].standard_deviation.value);
}

}  // namespace
}  // namespace delabole
