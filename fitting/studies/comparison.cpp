#include "fitting/studies/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

std::vector<MechanismWeight> weigh(std::span<const LogEvidence> mechanisms) {
    constexpr double nothing = -std::numeric_limits<double>::infinity();
    double best = nothing;
    for (const LogEvidence& mechanism : mechanisms) {
        best = std::max(best, mechanism.value);
    }
    std::vector<MechanismWeight> weights;
    if (best == nothing) {
        weights.assign(mechanisms.size(), {nothing, 0, 0});
        return weights;
    }
    double sum = 0;
    for (const LogEvidence& mechanism : mechanisms) {
        sum += std::exp(mechanism.value - best);
    }
    for (const LogEvidence& mechanism : mechanisms) {
        weights.push_back({mechanism.value - best, std::exp(mechanism.value - best) / sum, 0});
    }
    // d p_i = p_i (d ln Z_i - sum over j of p_j d ln Z_j)
    for (std::size_t index = 0; index < weights.size(); ++index) {
        double variance = 0;
        for (std::size_t other = 0; other < weights.size(); ++other) {
            const double slope = (index == other ? 1 : 0) - weights[other].probability;
            const double error = mechanisms[other].value == nothing ? 0 : mechanisms[other].standard_error;
            variance += slope * slope * error * error;
        }
        weights[index].standard_error = weights[index].probability * std::sqrt(variance);
    }
    return weights;
}

std::vector<MechanismWeight> weigh(const FitResult& result) {
    std::vector<LogEvidence> evidences;
    for (const MechanismFit& fit : result.mechanisms) {
        evidences.push_back(fit.posterior
                                ? LogEvidence{fit.posterior->log_evidence(), fit.posterior->evidence().standard_error}
                                : LogEvidence{-std::numeric_limits<double>::infinity(), 0});
    }
    return weigh(evidences);
}

}  // namespace delabole
