#include "fitting/posterior/prior_space.hpp"

#include "fitting/probability/dependence.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace delabole {

namespace {

Distribution distribution_of(const FreeParameter& parameter) {
    if (parameter.prior) {
        return {Normal{parameter.prior->mean, parameter.prior->standard_deviation}, parameter.lower, parameter.upper};
    }
    return {Uniform{parameter.lower, parameter.upper}};
}

}  // namespace

std::string fault_of_prior(const FreeParameter& parameter) {
    if (!std::isfinite(parameter.lower) || !std::isfinite(parameter.upper) || parameter.lower > parameter.upper) {
        return "the bounds must be finite and in order";
    }
    if (parameter.lower == parameter.upper) {
        return {};
    }
    const std::vector<DistributionFault> faults = check(distribution_of(parameter));
    return faults.empty() ? std::string() : "prior: " + faults.front().message;
}

PriorSpace::PriorSpace(std::vector<FreeParameter> parameters) : parameters_(std::move(parameters)) {
    if (parameters_.size() > most_parameters) {
        throw std::invalid_argument("PriorSpace: too many parameters");
    }
    for (std::size_t index = 0; index < parameters_.size(); ++index) {
        const FreeParameter& parameter = parameters_[index];
        if (const std::string fault = fault_of_prior(parameter); !fault.empty()) {
            throw std::invalid_argument(parameter.name + ": " + fault);
        }
        if (parameter.lower < parameter.upper) {
            free_.push_back(index);
            marginals_.emplace_back(distribution_of(parameter));
        }
    }
}

void PriorSpace::values(std::span<const double> standard_normal, std::span<double> parameters) const {
    for (std::size_t index = 0; index < parameters_.size(); ++index) {
        parameters[index] = parameters_[index].lower;
    }
    for (std::size_t coordinate = 0; coordinate < free_.size(); ++coordinate) {
        const FreeParameter& parameter = parameters_[free_[coordinate]];
        parameters[free_[coordinate]] =
            std::clamp(marginals_[coordinate].value(standard_normal[coordinate]), parameter.lower, parameter.upper);
    }
}

std::vector<double> PriorSpace::coordinates(std::span<const double> parameters) const {
    // Farther out the lower and upper part of a probability together cannot tell it from 0 or 1.
    constexpr double furthest = 8.3;
    std::vector<double> result;
    for (std::size_t coordinate = 0; coordinate < free_.size(); ++coordinate) {
        const Probability probability = marginals_[coordinate].probability(parameters[free_[coordinate]]);
        const double z = probability.below < probability.above ? normal_quantile(probability.below)
                                                               : -normal_quantile(probability.above);
        result.push_back(std::clamp(z, -furthest, furthest));
    }
    return result;
}

}  // namespace delabole
