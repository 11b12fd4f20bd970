// Targets of sampling with known posteriors and evidences.
#pragma once

#include "fitting/posterior/evidence.hpp"

#include "tests/fitting/test_functions.hpp"
#include "tests/fitting/test_models.hpp"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace delabole::test {

struct Target {
    std::vector<FreeParameter> parameters;
    std::function<double(std::span<const double>)> misfit;
};

inline double square(double value) {
    return value * value;
}

inline double normal_density(double value, double mean, double deviation) {
    return std::exp(-square((value - mean) / deviation) / 2) / (deviation * std::sqrt(2 * std::numbers::pi));
}

inline double normal_share(double lower, double upper, double mean, double deviation) {
    return normal_probability((upper - mean) / deviation).below - normal_probability((lower - mean) / deviation).below;
}

inline Posterior sample(const Target& target, const PosteriorSettings& settings = {}, int threads = 1,
                        StopFlag stop = nullptr) {
    Study study(objective(target.misfit), threads);
    return sample_posterior(study.evaluator(stop), PriorSpace(target.parameters), settings);
}

inline Evidence evidence(const Target& target, const std::vector<Draw>& draws, const EvidenceSettings& settings = {},
                         int threads = 1) {
    Study study(objective(target.misfit), threads);
    return estimate_evidence(study.evaluator(), PriorSpace(target.parameters), draws, settings);
}

// A datum 1 +- 0.5 of a parameter with a standard normal prior cut off at -0.5 and 1.5: normal with mean 0.8 and
// variance 0.2, cut off there.
inline Target cut_normal() {
    return {{with_prior("x1", -0.5, 1.5, 0, 1)}, [](std::span<const double> x) { return square((x[0] - 1) / 0.5); }};
}
inline const double cut_normal_share = normal_share(-0.5, 1.5, 0.8, std::sqrt(0.2));
inline const double cut_normal_evidence =
    std::log(0.5 * std::sqrt(2 * std::numbers::pi) * normal_density(1, 0, std::sqrt(1.25)) * cut_normal_share /
             normal_share(-0.5, 1.5, 0, 1));

// A sum known to 0.05 of two parameters with standard normal priors: correlation -1 / 1.005 ...
inline Target ridge() {
    return {{with_prior("x1", -8, 8, 0, 1), with_prior("x2", -8, 8, 0, 1)},
            [](std::span<const double> x) { return square((x[0] + x[1] - 1) / 0.05); }};
}

// x2 = x1^2 to 0.1, x1 normal, both within flat bounds that cut off nothing above 1e-4 of it.
inline Target banana() {
    return {{free_parameter("x1", -4, 4), free_parameter("x2", -2, 17)},
            [](std::span<const double> x) { return square(x[0]) + square((x[1] - x[0] * x[0]) / 0.1); }};
}
inline const double banana_evidence = std::log(2 * std::numbers::pi * 0.1 / (8 * 19));

// Two normal peaks, the first three times the second.
inline Target two_modes() {
    return {{free_parameter("x1", -10, 10), free_parameter("x2", -10, 10)}, [](std::span<const double> x) {
                const auto peak = [&](double at) { return -(square(x[0] - at) + square(x[1] - at)) / (2 * 0.09); };
                const double first = std::log(3.0) + peak(4);
                const double second = peak(-4);
                return -2 * (std::max(first, second) + std::log1p(std::exp(-std::abs(first - second))));
            }};
}
inline const double two_modes_evidence = std::log(4 * 2 * std::numbers::pi * 0.09 / 400);

}  // namespace delabole::test
