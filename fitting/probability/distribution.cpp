#include "fitting/probability/distribution.hpp"

#include "fitting/probability/normal_integral.hpp"
#include "fitting/work/words.hpp"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_randist.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace delabole {

namespace {

// A truncation that keeps less would draw only the rounding errors of the tail.
constexpr double least_kept_probability = 1e-12;

// For a greater ratio of standard deviation to mean the moments lie so far out in the tail that no sample would find
// them.
constexpr double widest_lognormal = 10;

// For shape parameters a few times greater GSL's continued fraction for the beta distribution does not converge.
constexpr double greatest_shapes = 1e5;

using Faults = std::vector<DistributionFault>;

// Mean and standard deviation of the logarithm.
std::pair<double, double> of_logarithm(const Lognormal& law) {
    const double ratio = law.standard_deviation / law.mean;
    const double variance = std::log1p(ratio * ratio);
    return {std::log(law.mean) - variance / 2, std::sqrt(variance)};
}

std::pair<double, double> shape_of(const Beta& law) {
    const double range = law.upper - law.lower;
    const double mean = (law.mean - law.lower) / range;
    const double spread = law.standard_deviation / range;
    const double sum = mean * (1 - mean) / (spread * spread) - 1;
    return {mean * sum, (1 - mean) * sum};
}

Probability of_law(const Normal& law, std::pair<double, double>, double value) {
    return normal_probability((value - law.mean) / law.standard_deviation);
}

Probability of_law(const Lognormal& law, std::pair<double, double>, double value) {
    if (!(value > 0)) {
        return {0, 1};
    }
    const auto [mean, deviation] = of_logarithm(law);
    return normal_probability((std::log(value) - mean) / deviation);
}

Probability of_law(const Exponential& law, std::pair<double, double>, double value) {
    const double ratio = std::max(value, 0.0) / law.mean;
    return {-std::expm1(-ratio), std::exp(-ratio)};
}

Probability of_law(const Uniform& law, std::pair<double, double>, double value) {
    const double inside = std::clamp(value, law.lower, law.upper);
    return {(inside - law.lower) / (law.upper - law.lower), (law.upper - inside) / (law.upper - law.lower)};
}

Probability of_law(const Triangular& law, std::pair<double, double>, double value) {
    const double range = law.upper - law.lower;
    const double inside = std::clamp(value, law.lower, law.upper);
    if (inside < law.mode) {
        const double below = (inside - law.lower) * (inside - law.lower) / (range * (law.mode - law.lower));
        return {below, 1 - below};
    }
    if (law.mode == law.upper) {
        return {1, 0};
    }
    const double above = (law.upper - inside) * (law.upper - inside) / (range * (law.upper - law.mode));
    return {1 - above, above};
}

Probability of_law(const Beta& law, std::pair<double, double> shape, double value) {
    const double share = std::clamp((value - law.lower) / (law.upper - law.lower), 0.0, 1.0);
    return {gsl_cdf_beta_P(share, shape.first, shape.second), gsl_cdf_beta_Q(share, shape.first, shape.second)};
}

double normal_quantile(Probability probability) {
    return probability.below < probability.above ? gsl_cdf_ugaussian_Pinv(probability.below)
                                                 : gsl_cdf_ugaussian_Qinv(probability.above);
}

double inverse(const Normal& law, std::pair<double, double>, Probability probability) {
    return law.mean + law.standard_deviation * normal_quantile(probability);
}

double inverse(const Lognormal& law, std::pair<double, double>, Probability probability) {
    const auto [mean, deviation] = of_logarithm(law);
    return std::exp(mean + deviation * normal_quantile(probability));
}

double inverse(const Exponential& law, std::pair<double, double>, Probability probability) {
    return law.mean * (probability.below < 0.5 ? -std::log1p(-probability.below) : -std::log(probability.above));
}

double inverse(const Uniform& law, std::pair<double, double>, Probability probability) {
    const double range = law.upper - law.lower;
    return probability.below < probability.above ? law.lower + range * probability.below
                                                 : law.upper - range * probability.above;
}

double inverse(const Triangular& law, std::pair<double, double>, Probability probability) {
    const double range = law.upper - law.lower;
    if (probability.below * range < law.mode - law.lower) {
        return law.lower + std::sqrt(probability.below * range * (law.mode - law.lower));
    }
    return law.upper - std::sqrt(probability.above * range * (law.upper - law.mode));
}

// Newton's method, kept inside a bracket. GSL's own inverse cannot be used: where it does not converge it calls the
// error handler, which ends the program.
double beta_quantile(double probability, double a, double b) {
    double lower = 0;
    double upper = 1;
    double share = a / (a + b);
    constexpr int most_steps = 200;
    for (int step = 0; step < most_steps && upper - lower > 1e-16 * upper; ++step) {
        const double excess = gsl_cdf_beta_P(share, a, b) - probability;
        (excess < 0 ? lower : upper) = share;
        const double density = gsl_ran_beta_pdf(share, a, b);
        const double newton = share - excess / density;
        // Near the lower end of the range the root may have any order of magnitude, so the range of its logarithm is
        // halved.
        const double middle = lower > 0 && upper > 4 * lower ? std::sqrt(lower * upper)
                              : lower > 0                    ? (lower + upper) / 2
                                                             : upper / 16;
        const double next = newton > lower && newton < upper ? newton : middle;
        if (std::abs(next - share) <= 1e-15 * share) {
            return next;
        }
        share = next;
    }
    return share;
}

double inverse(const Beta& law, std::pair<double, double> shape, Probability probability) {
    const auto [a, b] = shape;
    const double range = law.upper - law.lower;
    if (probability.below <= 0 || probability.above <= 0) {
        return probability.below <= 0 ? law.lower : law.upper;
    }
    // Solved from the nearer end, so that a small probability is used itself and not its complement to 1.
    return probability.below < probability.above ? law.lower + range * beta_quantile(probability.below, a, b)
                                                 : law.upper - range * beta_quantile(probability.above, b, a);
}

// Probability between two values, taken from the tail in which they lie so that no digits are lost.
double between(Probability lower, Probability upper) {
    return lower.below < 0.5 ? upper.below - lower.below : lower.above - upper.above;
}

std::string must_be(std::string_view relation, std::string_view other) {
    return "must be " + std::string(relation) + " " + std::string(other);
}

void check_order(std::string_view lower_key, double lower, std::string_view upper_key, double upper, Faults& faults) {
    if (!(lower < upper)) {
        faults.push_back({lower_key, must_be("less than", upper_key)});
    }
}

void check_law(const Normal&, Faults&) {}

void check_law(const Lognormal& law, Faults& faults) {
    if (law.standard_deviation > widest_lognormal * law.mean) {
        faults.push_back({"standard_deviation", "must be at most 10 times the mean"});
    }
}

void check_law(const Exponential&, Faults&) {}

void check_law(const Uniform& law, Faults& faults) {
    check_order("lower", law.lower, "upper", law.upper, faults);
}

void check_law(const Triangular& law, Faults& faults) {
    check_order("lower", law.lower, "upper", law.upper, faults);
    if (law.mode < law.lower) {
        faults.push_back({"mode", must_be("at least", "lower")});
    }
    if (law.mode > law.upper) {
        faults.push_back({"mode", must_be("at most", "upper")});
    }
}

void check_law(const Beta& law, Faults& faults) {
    check_order("lower", law.lower, "upper", law.upper, faults);
    check_order("lower", law.lower, "mean", law.mean, faults);
    check_order("mean", law.mean, "upper", law.upper, faults);
    const auto [a, b] = shape_of(law);
    if (faults.empty() && !(a > 0 && b > 0)) {
        faults.push_back({"standard_deviation",
                          "is too large for these limits: must be less than sqrt((mean - lower) (upper - mean))"});
    } else if (faults.empty() && a + b > greatest_shapes) {
        faults.push_back({"standard_deviation", "is too small for these limits: a normal distribution does as well"});
    }
}

}  // namespace

Probability normal_probability(double standard_normal) {
    return {std::erfc(-standard_normal * M_SQRT1_2) / 2, std::erfc(standard_normal * M_SQRT1_2) / 2};
}

double normal_quantile(double probability) {
    return gsl_cdf_ugaussian_Pinv(probability);
}

std::vector<DistributionFault> check(const Distribution& distribution) {
    Faults faults;
    std::visit(
        [&](const auto& law) {
            visit_fields(law, [&](const FieldInfo& info, double value) {
                if (!std::isfinite(value)) {
                    faults.push_back({info.key, "must be finite"});
                } else if (!info.range.contains(value)) {
                    faults.push_back({info.key, "must be more than " + number_in_words(info.range.lower)});
                }
            });
            if (faults.empty()) {
                check_law(law, faults);
            }
        },
        distribution.law);
    for (const auto& [key, limit] : {std::pair{"lower", distribution.lower}, std::pair{"upper", distribution.upper}}) {
        if (limit && has_limits(distribution.law)) {
            faults.push_back({key, "a distribution that has limits takes no truncation"});
        } else if (limit && !std::isfinite(*limit)) {
            faults.push_back({key, "must be finite"});
        }
    }
    if (faults.empty() && distribution.lower && distribution.upper) {
        check_order("lower", *distribution.lower, "upper", *distribution.upper, faults);
    }
    if (faults.empty() && (distribution.lower || distribution.upper)) {
        const auto at = [&](const std::optional<double>& limit, Probability otherwise) {
            return limit ? std::visit([&](const auto& law) { return of_law(law, {}, *limit); }, distribution.law)
                         : otherwise;
        };
        const Probability lower = at(distribution.lower, {0, 1});
        const Probability upper = at(distribution.upper, {1, 0});
        const double kept = between(lower, upper);
        if (!(kept >= least_kept_probability)) {
            faults.push_back({distribution.lower ? "lower" : "upper",
                              "the truncation leaves next to nothing: a probability of " + number_in_words(kept)});
        }
    }
    return faults;
}

Marginal::Marginal(const Distribution& distribution)
    : law_(distribution.law), lower_(distribution.lower), upper_(distribution.upper) {
    const std::vector<DistributionFault> faults = check(distribution);
    if (!faults.empty()) {
        throw std::invalid_argument("distribution: " + std::string(faults.front().key) + " " + faults.front().message);
    }
    const auto at = [&](double limit) {
        return std::visit([&](const auto& law) { return of_law(law, beta_shape_, limit); }, law_);
    };
    at_lower_ = lower_ ? at(*lower_) : at_lower_;
    at_upper_ = upper_ ? at(*upper_) : at_upper_;
    if (const auto* law = std::get_if<Beta>(&law_)) {
        beta_shape_ = shape_of(*law);
    }
    // The integral is taken of the offset from the median, so that a small spread about a large value keeps its digits.
    const double median = value(0);
    const double offset = normal_integral([&](double number) { return value(number) - median; });
    mean_ = median + offset;
    standard_deviation_ = std::sqrt(normal_integral([&](double number) {
        const double difference = value(number) - mean_;
        return difference * difference;
    }));
}

double Marginal::value(double standard_normal) const {
    if (const auto* law = std::get_if<Normal>(&law_); law != nullptr && !lower_ && !upper_) {
        return law->mean + law->standard_deviation * standard_normal;
    }
    Probability probability = normal_probability(standard_normal);
    if (lower_ || upper_) {
        const auto [below, above] = probability;
        probability = {at_lower_.below * above + at_upper_.below * below,
                       at_lower_.above * above + at_upper_.above * below};
    }
    const double value = std::visit([&](const auto& law) { return inverse(law, beta_shape_, probability); }, law_);
    const double not_below = lower_ ? std::max(value, *lower_) : value;
    return upper_ ? std::min(not_below, *upper_) : not_below;
}

Probability Marginal::probability(double value) const {
    const Probability plain = std::visit([&](const auto& law) { return of_law(law, beta_shape_, value); }, law_);
    const double kept = between(at_lower_, at_upper_);
    return {std::clamp(between(at_lower_, plain) / kept, 0.0, 1.0),
            std::clamp(between(plain, at_upper_) / kept, 0.0, 1.0)};
}

}  // namespace delabole
