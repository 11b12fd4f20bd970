// Functions with known sensitivities, and a study that evaluates them.
#pragma once

#include "fitting/probability/dependence.hpp"
#include "fitting/search/evaluate_points.hpp"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace delabole::test {

inline Objective objective(std::function<double(std::span<const double>)> function) {
    return [function = std::move(function)](std::span<const double> x) { return Evaluation{function(x), {}}; };
}

// Owns what an Evaluator refers to.
class Study {
  public:
    explicit Study(Objective quantity, int threads = 1) : quantity_(std::move(quantity)), threads_(threads) {}

    Evaluator evaluator(StopFlag stop = nullptr) { return {quantity_, progress_, stop, threads_}; }

  private:
    Objective quantity_;
    ProgressMeter progress_{{}, 1};
    int threads_;
};

inline InputSpace independent(std::size_t count, const Law& law) {
    return {std::vector<Marginal>(count, Marginal({law})), {}};
}

inline InputSpace unit_box(std::size_t count) {
    return independent(count, Uniform{0, 1});
}

// T. Ishigami & T. Homma, Proc. ISUMA '90, 398-403; inputs uniform in (-pi, pi), a = 7, b = 0.1.
inline double ishigami(std::span<const double> x) {
    return std::sin(x[0]) + 7 * std::pow(std::sin(x[1]), 2) + 0.1 * std::pow(x[2], 4) * std::sin(x[0]);
}

inline InputSpace ishigami_space() {
    return independent(3, Uniform{-std::numbers::pi, std::numbers::pi});
}

// I. M. Sobol's g-function with the coefficients of A. Saltelli & I. M. Sobol, Reliability Engineering & System Safety
// 50 (1995) 225-239; inputs uniform in (0, 1).
inline constexpr std::array g_coefficients{0.0, 1.0, 4.5, 9.0, 99.0, 99.0, 99.0, 99.0};

inline double g_function(std::span<const double> x) {
    double product = 1;
    for (std::size_t index = 0; index < g_coefficients.size(); ++index) {
        product *= (std::abs(4 * x[index] - 2) + g_coefficients[index]) / (1 + g_coefficients[index]);
    }
    return product;
}

// M. D. Morris, Technometrics 33 (1991) 161-174, section 5, with the small coefficients that he draws at random set to
// +1 and -1 in turn; 20 inputs uniform in (0, 1).
inline double morris_function(std::span<const double> x) {
    std::array<double, 20> w{};
    for (std::size_t i = 0; i < w.size(); ++i) {
        const bool bent = i == 2 || i == 4 || i == 6;
        w[i] = 2 * ((bent ? 1.1 * x[i] / (x[i] + 0.1) : x[i]) - 0.5);
    }
    double y = 0;
    for (std::size_t i = 0; i < 20; ++i) {
        y += (i < 10 ? 20 : (i % 2 == 0 ? 1 : -1)) * w[i];
        for (std::size_t j = i + 1; j < 20; ++j) {
            y += (j < 6 ? -15 : ((i + j) % 2 == 0 ? 1 : -1)) * w[i] * w[j];
        }
    }
    for (std::size_t i = 0; i < 5; ++i) {
        for (std::size_t j = i + 1; j < 5; ++j) {
            for (std::size_t k = j + 1; k < 5; ++k) {
                y += -10 * w[i] * w[j] * w[k];
            }
        }
    }
    return y + 5 * w[0] * w[1] * w[2] * w[3];
}

}  // namespace delabole::test
