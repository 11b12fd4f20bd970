#include "fitting/posterior/evidence.hpp"

#include "fitting/probability/dependence.hpp"
#include "fitting/probability/moments.hpp"
#include "fitting/probability/sampling.hpp"
#include "fitting/probability/student_mixture.hpp"

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
constexpr std::size_t most_components = 16;

double log_prior(std::span<const double> normal) {
    double sum = -0.5 * static_cast<double>(normal.size()) * std::log(2 * std::numbers::pi);
    for (const double number : normal) {
        sum -= number * number / 2;
    }
    return sum;
}

// Densities and draws in the standard normal numbers of the prior. Without a mixture it is the prior itself.
class Proposal {
  public:
    explicit Proposal(std::size_t dimension) : dimension_(dimension) {}
    Proposal(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights, std::uint64_t seed)
        : dimension_(static_cast<std::size_t>(points.rows())),
          mixture_(StudentMixture(points, weights, most_components, seed)) {}

    std::size_t unit_dimension() const { return dimension_ + 2; }

    // Draws a point and returns whether it comes from the prior.
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

    // log(density of the draws / prior density)
    double log_ratio(std::span<const double> normal) const {
        if (!mixture_) {
            return 0;
        }
        const double ratio = std::exp(mixture_->log_density(normal) - log_prior(normal));
        return std::log(prior_share + (1 - prior_share) * ratio);
    }

  private:
    std::size_t dimension_;
    std::optional<StudentMixture> mixture_;
};

Proposal proposal_from(const PriorSpace& prior, std::span<const Draw> draws, std::uint64_t seed) {
    constexpr std::size_t most_draws = 2000;
    if (draws.empty()) {
        return Proposal(prior.size());
    }
    const std::size_t count = std::min(draws.size(), most_draws);
    std::vector<std::vector<double>> points(count);
    for (std::size_t index = 0; index < count; ++index) {
        points[index] = prior.coordinates(draws[index * draws.size() / count].parameters);
    }
    return {as_columns(points), Eigen::VectorXd::Ones(static_cast<Eigen::Index>(count)), seed};
}

// Points drawn from a proposal, with the evaluations of the model.
struct Sample {
    Eigen::MatrixXd points;  // one per column, standard normal numbers
    std::vector<Evaluation> evaluations;
    std::vector<char> from_prior;

    std::span<const double> point(std::size_t index) const {
        return {points.col(static_cast<Eigen::Index>(index)).data(), static_cast<std::size_t>(points.rows())};
    }
};

// Draws replicates first, first + 1, ... of the sequence, one after the other; fewer points if the work was stopped.
Sample sample_from(const Proposal& proposal, const Evaluator& misfit, const PriorSpace& prior,
                   const SobolSequence& sequence, std::size_t points, std::size_t first, std::size_t replicates) {
    Sample sample;
    sample.points.resize(static_cast<Eigen::Index>(prior.size()), static_cast<Eigen::Index>(points * replicates));
    sample.from_prior.resize(points * replicates);
    sample.evaluations = misfit.evaluate(
        prior.parameters().size(), points * replicates, [&](std::size_t index, std::span<double> parameters) {
            std::array<double, most_parameters> storage{};
            const auto unit = std::span(storage).first(proposal.unit_dimension());
            sequence.point(index % points, first + index / points, unit);
            const std::span<double> normal(sample.points.col(static_cast<Eigen::Index>(index)).data(), prior.size());
            sample.from_prior[index] = proposal.draw(unit, normal) ? 1 : 0;
            prior.values(normal, parameters);
        });
    return sample;
}

// Pilot points of several proposals. The density behind each weight is the mean of all proposals, so that a single
// proposal that fitted badly does not dominate the weights.
class Pilots {
  public:
    void add(const Proposal& proposal, const Sample& sample) {
        proposals_.push_back(proposal);
        for (std::size_t index = 0; index < sample.evaluations.size(); ++index) {
            if (sample.evaluations[index].valid()) {
                const std::span<const double> point = sample.point(index);
                points_.emplace_back(point.begin(), point.end());
                log_likelihoods_.push_back(-sample.evaluations[index].value / 2);
            }
        }
    }

    // Nothing if no point has an answer.
    std::optional<Proposal> refitted(std::uint64_t seed) const {
        if (points_.empty()) {
            return std::nullopt;
        }
        std::vector<double> logs;
        for (std::size_t index = 0; index < points_.size(); ++index) {
            double density = 0;  // divided by the density of the prior
            for (const Proposal& proposal : proposals_) {
                density += std::exp(proposal.log_ratio(points_[index]));
            }
            logs.push_back(log_likelihoods_[index] - std::log(density));
        }
        const double greatest = *std::max_element(logs.begin(), logs.end());
        std::vector<std::vector<double>> points;
        std::vector<double> weights;
        for (std::size_t index = 0; index < logs.size(); ++index) {
            if (logs[index] > greatest - negligible) {
                points.push_back(points_[index]);
                weights.push_back(std::exp(logs[index] - greatest));
            }
        }
        return Proposal(as_columns(points),
                        Eigen::Map<const Eigen::VectorXd>(weights.data(), static_cast<Eigen::Index>(weights.size())),
                        seed);
    }

  private:
    static constexpr double negligible = 14;  // logarithm; a millionth of the greatest weight

    std::vector<Proposal> proposals_;
    std::vector<std::vector<double>> points_;
    std::vector<double> log_likelihoods_;
};

struct Weights {
    std::vector<double> logs;  // log of likelihood times weight; -infinity where the model has no answer
    double least_misfit = std::numeric_limits<double>::infinity();
    double failed_share = 0;
    EvaluationCount evaluations;
};

Weights weights_of(const Proposal& proposal, const Sample& sample) {
    constexpr double nothing = -std::numeric_limits<double>::infinity();
    Weights weights;
    double drawn = 0;
    double failed = 0;
    for (std::size_t index = 0; index < sample.evaluations.size(); ++index) {
        const Evaluation& evaluation = sample.evaluations[index];
        weights.evaluations.record(evaluation);
        const bool valid = evaluation.valid();
        weights.logs.push_back(valid ? -evaluation.value / 2 - proposal.log_ratio(sample.point(index)) : nothing);
        weights.least_misfit = valid ? std::min(weights.least_misfit, evaluation.value) : weights.least_misfit;
        drawn += sample.from_prior[index];
        failed += sample.from_prior[index] != 0 && !valid ? 1 : 0;
    }
    weights.failed_share = drawn > 0 ? failed / drawn : 0;
    return weights;
}

double effective_size(const std::vector<double>& log_weights) {
    const double greatest = *std::max_element(log_weights.begin(), log_weights.end());
    if (!std::isfinite(greatest)) {
        return 0;
    }
    double sum = 0;
    double squares = 0;
    for (const double log_weight : log_weights) {
        const double weight = std::exp(log_weight - greatest);
        sum += weight;
        squares += weight * weight;
    }
    return sum * sum / squares;
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
    std::vector<double> means;
    for (std::size_t first = 0; first < weights.logs.size(); first += points) {
        double mean = 0;
        for (std::size_t index = first; index < first + points; ++index) {
            const double weight = std::exp(weights.logs[index] - greatest);
            mean += weight / settings.points;
            sum += weight;
        }
        means.push_back(mean);
    }
    const double mean = sum / static_cast<double>(weights.logs.size());
    evidence.log_evidence = greatest + std::log(mean);
    evidence.standard_error = deviation_of(means) / std::sqrt(static_cast<double>(means.size())) / mean;
    evidence.effective_size = effective_size(weights.logs);
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

// The draws may be few or from another distribution. The mixture is therefore refitted to weighted pilot points until
// the weights of a new pilot are about equal; the best mixture is returned.
Proposal best_proposal(const Evaluator& misfit, const PriorSpace& prior, std::span<const Draw> draws,
                       const EvidenceSettings& settings, const SobolSequence& sequence, EvaluationCount& account) {
    constexpr double enough = 0.4;
    constexpr std::size_t most_pilots = 4;
    const auto points = static_cast<std::size_t>(settings.points);
    std::optional<Proposal> next = proposal_from(prior, draws, settings.seed);
    Proposal best = *next;
    double best_size = -1;
    Pilots pilots;
    for (std::size_t pilot = 0; pilot < most_pilots && next && best_size < enough * settings.points; ++pilot) {
        const std::size_t replicate = static_cast<std::size_t>(settings.replicates) + pilot;
        const Sample sample = sample_from(*next, misfit, prior, sequence, points, replicate, 1);
        if (sample.evaluations.size() < points) {
            break;
        }
        const Weights weights = weights_of(*next, sample);
        account.add(weights.evaluations);
        const double size = effective_size(weights.logs);
        if (size > best_size) {
            best_size = size;
            best = *next;
        }
        pilots.add(*next, sample);
        next = pilots.refitted(settings.seed);
    }
    return best;
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
    const auto points = static_cast<std::size_t>(settings.points);
    const auto replicates = static_cast<std::size_t>(settings.replicates);
    const SobolSequence sequence(prior.size() + 2, points, settings.seed);
    Evidence evidence;
    const Proposal proposal = best_proposal(misfit, prior, draws, settings, sequence, evidence.evaluations);
    const Sample sample = sample_from(proposal, misfit, prior, sequence, points, 0, replicates);
    if (sample.evaluations.size() < points * replicates) {
        evidence.status = EvidenceStatus::interrupted;
        return evidence;
    }
    const Weights weights = weights_of(proposal, sample);
    evidence.evaluations.add(weights.evaluations);
    evidence.failed_share = weights.failed_share;
    average(weights, settings, evidence);
    return evidence;
}

}  // namespace delabole
