#include "fitting/evidence.hpp"

#include "fitting/dependence.hpp"
#include "fitting/sampling.hpp"
#include "fitting/student_mixture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>

namespace delabole {

namespace {

constexpr double prior_share = 0.2;

// Densities and draws in the standard normal numbers of the prior.
class Proposal {
  public:
    Proposal(const PriorSpace& prior, std::span<const Draw> draws, std::uint64_t seed) : dimension_(prior.size()) {
        constexpr std::size_t most_draws = 1500;
        constexpr std::size_t most_components = 16;
        if (draws.empty()) {
            return;
        }
        const std::size_t count = std::min(draws.size(), most_draws);
        Eigen::MatrixXd points(static_cast<Eigen::Index>(dimension_), static_cast<Eigen::Index>(count));
        for (std::size_t index = 0; index < count; ++index) {
            const std::vector<double> point = prior.coordinates(draws[index * draws.size() / count].parameters);
            points.col(static_cast<Eigen::Index>(index)) =
                Eigen::Map<const Eigen::VectorXd>(point.data(), points.rows());
        }
        mixture_.emplace(points, most_components, seed);
    }

    std::size_t unit_dimension() const { return dimension_ + 2; }

    // Whether the point comes from the prior.
    bool draw(std::span<double> unit, std::span<double> normal) const {
        const bool from_prior = !mixture_ || unit[0] < prior_share;
        if (from_prior) {
            for (std::size_t index = 0; index < dimension_; ++index) {
                normal[index] = normal_quantile(unit[index + 1]);
            }
        } else {
            unit[0] = (unit[0] - prior_share) / (1 - prior_share);
            mixture_->draw(unit, normal);
        }
        return from_prior;
    }

    // log(prior density / density of the draws)
    double log_weight(std::span<const double> normal) const {
        if (!mixture_) {
            return 0;
        }
        double log_prior = -0.5 * static_cast<double>(dimension_) * std::log(2 * std::numbers::pi);
        for (const double number : normal) {
            log_prior -= number * number / 2;
        }
        // prior / (share prior + rest mixture) = 1 / (share + rest mixture / prior)
        const double ratio = std::exp(mixture_->log_density(normal) - log_prior);
        return -std::log(prior_share + (1 - prior_share) * ratio);
    }

  private:
    std::size_t dimension_;
    std::optional<StudentMixture> mixture_;
};

struct Weights {
    std::vector<double> logs;  // of likelihood times weight; -infinity where the model has no answer
    double least_misfit = std::numeric_limits<double>::infinity();
    double failed_share = 0;
    EvaluationCount evaluations;
};

Weights weights_of(const std::vector<Evaluation>& evaluations, const std::vector<double>& log_weights,
                   const std::vector<char>& from_prior) {
    Weights weights;
    double drawn = 0;
    double failed = 0;
    for (std::size_t index = 0; index < evaluations.size(); ++index) {
        const Evaluation& evaluation = evaluations[index];
        weights.evaluations.record(evaluation);
        const bool valid = evaluation.valid();
        weights.logs.push_back(valid ? log_weights[index] - evaluation.value / 2
                                     : -std::numeric_limits<double>::infinity());
        weights.least_misfit = valid ? std::min(weights.least_misfit, evaluation.value) : weights.least_misfit;
        drawn += from_prior[index];
        failed += from_prior[index] != 0 && !valid ? 1 : 0;
    }
    weights.failed_share = drawn > 0 ? failed / drawn : 0;
    return weights;
}

void average(const Weights& weights, const EvidenceSettings& settings, Evidence& evidence) {
    const double greatest = *std::max_element(weights.logs.begin(), weights.logs.end());
    evidence.least_misfit = weights.least_misfit;
    if (!std::isfinite(greatest)) {
        evidence.log_evidence = -std::numeric_limits<double>::infinity();
        return;
    }
    evidence.status = EvidenceStatus::estimated;
    const auto points = static_cast<std::size_t>(settings.points);
    double sum = 0;
    double squares = 0;
    std::vector<double> means;
    for (std::size_t first = 0; first < weights.logs.size(); first += points) {
        double mean = 0;
        for (std::size_t index = first; index < first + points; ++index) {
            const double weight = std::exp(weights.logs[index] - greatest);
            mean += weight / settings.points;
            sum += weight;
            squares += weight * weight;
        }
        means.push_back(mean);
    }
    const double mean = sum / static_cast<double>(weights.logs.size());
    double spread = 0;
    for (const double value : means) {
        spread += (value - mean) * (value - mean);
    }
    const auto count = static_cast<double>(means.size());
    evidence.log_evidence = greatest + std::log(mean);
    evidence.standard_error = std::sqrt(spread / (count * (count - 1))) / mean;
    evidence.effective_size = sum * sum / squares;
}

Evidence of_one_point(const Evaluator& misfit, const PriorSpace& prior) {
    std::vector<double> parameters(prior.parameters().size());
    prior.values({}, parameters);
    const Evaluation evaluation = misfit.quantity(parameters);
    misfit.progress.count();
    Evidence evidence;
    evidence.evaluations.record(evaluation);
    if (evaluation.valid()) {
        evidence.status = EvidenceStatus::estimated;
        evidence.least_misfit = evaluation.value;
        evidence.effective_size = 1;
    } else {
        evidence.failed_share = 1;
    }
    evidence.log_evidence = evaluation.valid() ? -evaluation.value / 2 : -std::numeric_limits<double>::infinity();
    return evidence;
}

}  // namespace

Evidence estimate_evidence(const Evaluator& misfit, const PriorSpace& prior, std::span<const Draw> draws,
                           const EvidenceSettings& settings) {
    if (settings.points < 16 || settings.replicates < 2) {
        throw std::invalid_argument("estimate_evidence: needs at least 16 points and 2 replicates");
    }
    if (prior.size() == 0) {
        return of_one_point(misfit, prior);
    }
    const Proposal proposal(prior, draws, settings.seed);
    const SamplePlan plan(SamplingMethod::sobol_sequence, proposal.unit_dimension(),
                          static_cast<std::size_t>(settings.points), static_cast<std::size_t>(settings.replicates),
                          settings.seed);
    std::vector<double> log_weights(plan.size());
    std::vector<char> from_prior(plan.size());
    const std::vector<Evaluation> evaluations =
        misfit.evaluate(prior.parameters().size(), plan.size(), [&](std::size_t index, std::span<double> parameters) {
            std::array<double, most_parameters> unit{};
            std::array<double, most_parameters> normal{};
            plan.point(index, std::span(unit).first(proposal.unit_dimension()));
            const auto numbers = std::span(normal).first(prior.size());
            from_prior[index] = proposal.draw(std::span(unit).first(proposal.unit_dimension()), numbers) ? 1 : 0;
            log_weights[index] = proposal.log_weight(numbers);
            prior.values(numbers, parameters);
        });
    Evidence evidence;
    if (evaluations.size() < plan.size()) {
        evidence.status = EvidenceStatus::interrupted;
        return evidence;
    }
    const Weights weights = weights_of(evaluations, log_weights, from_prior);
    evidence.evaluations = weights.evaluations;
    evidence.failed_share = weights.failed_share;
    average(weights, settings, evidence);
    return evidence;
}

}  // namespace delabole
