// Distributions of uncertain parameters: normal, lognormal, exponential, uniform, triangular, beta, and any of them
// truncated.
//
// Every value is in the unit of the parameter, SI; mean and standard deviation are those before truncation. A
// parameter is drawn by its quantile function, from a standard normal number, which keeps both tails exact: the lower
// probability and the upper one (1 - probability) are carried side by side.
#pragma once

#include "parameters/fields.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace delabole {

struct Normal {
    double mean;
    double standard_deviation;
    static constexpr std::string_view kind = "normal";
    static constexpr std::string_view kind_key = "distribution";
    static constexpr auto fields() {
        return FieldTable{number<&Normal::mean>(Dimension::named, "mean"),
                          number<&Normal::standard_deviation>(Dimension::named, more_than(0), "standard deviation")};
    }
};

// Mean and standard deviation are those of the parameter, not of its logarithm.
struct Lognormal {
    double mean;  // > 0
    double standard_deviation;
    static constexpr std::string_view kind = "lognormal";
    static constexpr auto fields() {
        return FieldTable{
            number<&Lognormal::mean>(Dimension::named, more_than(0), "mean"),
            number<&Lognormal::standard_deviation>(Dimension::named, more_than(0),
                                                   "standard deviation of the parameter itself, not of its logarithm")};
    }
};

// Its values range from 0 upwards.
struct Exponential {
    double mean;  // > 0
    static constexpr std::string_view kind = "exponential";
    static constexpr auto fields() {
        return FieldTable{number<&Exponential::mean>(Dimension::named, more_than(0), "mean before any truncation")};
    }
};

struct Uniform {
    double lower;
    double upper;
    static constexpr std::string_view kind = "uniform";
    static constexpr auto fields() {
        return FieldTable{number<&Uniform::lower>(Dimension::named, "least value"),
                          number<&Uniform::upper>(Dimension::named, "greatest value")};
    }
};

struct Triangular {
    double lower;
    double mode;
    double upper;
    static constexpr std::string_view kind = "triangular";
    static constexpr auto fields() {
        return FieldTable{number<&Triangular::lower>(Dimension::named, "least value"),
                          number<&Triangular::mode>(Dimension::named, "most likely value"),
                          number<&Triangular::upper>(Dimension::named, "greatest value")};
    }
};

// Beta distribution between two limits. Its shape parameters are a = m k and b = (1 - m) k, with m = (mean - lower) /
// (upper - lower) and k = m (1 - m) ((upper - lower) / standard deviation)^2 - 1, which has to be positive.
struct Beta {
    double mean;
    double standard_deviation;
    double lower;
    double upper;
    static constexpr std::string_view kind = "beta";
    static constexpr auto fields() {
        return FieldTable{number<&Beta::mean>(Dimension::named, "mean"),
                          number<&Beta::standard_deviation>(Dimension::named, more_than(0), "standard deviation"),
                          number<&Beta::lower>(Dimension::named, "least value"),
                          number<&Beta::upper>(Dimension::named, "greatest value")};
    }
};

using Law = std::variant<Normal, Lognormal, Exponential, Uniform, Triangular, Beta>;

// Uniform, triangular and beta have limits of their own and take no truncation.
constexpr bool has_limits(const Law& law) {
    return std::holds_alternative<Uniform>(law) || std::holds_alternative<Triangular>(law) ||
           std::holds_alternative<Beta>(law);
}

struct Distribution {
    Law law;
    std::optional<double> lower = {};  // truncation
    std::optional<double> upper = {};
    static constexpr auto fields() {
        return FieldTable{
            inlined(&Distribution::law, "kind of distribution"),
            number<&Distribution::lower>(Dimension::named, "smaller values are cut off"),
            number<&Distribution::upper>(Dimension::named, "greater values are cut off"),
        };
    }
};

// Probabilities of the two quantiles between which a study varies a parameter.
inline constexpr Interval lower_quantile = between(0, 0.5);
inline constexpr Interval upper_quantile = between(0.5, 1);

// A fault in one of the values that describe a distribution.
struct DistributionFault {
    std::string_view key;  // "standard_deviation", "lower", ...
    std::string message;   // the inequality it breaks
};

// Finds values that are not finite or out of order, a standard deviation that is not positive or too large for the
// limits of a beta distribution, and a truncation that leaves a probability below 1e-12. Empty for a distribution that
// can be drawn.
std::vector<DistributionFault> check(const Distribution& distribution);

// A probability and its complement to 1, each to full relative accuracy.
struct Probability {
    double below;
    double above;
};
Probability normal_probability(double standard_normal);
// Quantile of the standard normal distribution; infinite at 0 and 1. Accuracy: GSL's, relative 1e-15. Source: GSL
// manual, gsl_cdf_ugaussian_Pinv.
double normal_quantile(double probability);

// A distribution that can be drawn. Throws std::invalid_argument for one in which check() finds a fault.
class Marginal {
  public:
    explicit Marginal(const Distribution& distribution);

    // The value whose probability equals that of this standard normal number. Accuracy: 1e-13 of the distance between
    // the value and the nearer limit, 1e-12 for a beta distribution.
    double value(double standard_normal) const;
    double quantile(double probability) const { return value(normal_quantile(probability)); }
    // Probabilities of smaller and of greater values, with the truncation.
    Probability probability(double value) const;

    // Moments of the truncated distribution. Accuracy: 1e-10 of the standard deviation, by the trapezium rule over the
    // standard normal number; 1e-5 for triangular distributions and for lognormal ones of deviation 10 times the mean.
    double mean() const { return mean_; }
    double standard_deviation() const { return standard_deviation_; }

  private:
    Law law_;
    std::optional<double> lower_;
    std::optional<double> upper_;
    Probability at_lower_{0, 1};
    Probability at_upper_{1, 0};
    std::pair<double, double> beta_shape_{1, 1};
    double mean_ = 0;
    double standard_deviation_ = 0;
};

}  // namespace delabole
