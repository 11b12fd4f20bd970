#include "fitting/studies/recovery.hpp"

#include "fitting/mechanism/misfit.hpp"
#include "fitting/search/share.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace delabole {

namespace {

constexpr std::size_t bins = 10;
constexpr int most_tries = 2000;  // draws from the prior to find parameters that could have made the data

double normal(const CountedRandom& random, std::uint64_t index, std::size_t dimension) {
    return gsl_cdf_ugaussian_Pinv(random.unit(index, static_cast<std::uint32_t>(dimension)));
}

class Repetition {
  public:
    Repetition(const Mechanism& mechanism, const FitProblem& problem, const Misfit& misfit, const PriorSpace& prior,
               const RecoverySettings& settings, std::size_t number)
        : mechanism_(mechanism),
          problem_(problem),
          misfit_(misfit),
          prior_(prior),
          settings_(settings),
          number_(number),
          truths_(settings.posterior.seed, RandomPurpose::truth),
          errors_(settings.posterior.seed, RandomPurpose::error) {}

    Recovered run(ProgressMeter& progress, StopFlag stop) {
        Recovered result;
        result.has_truth = find_truth();
        if (!result.has_truth) {
            return result;
        }
        result.truth = truth_;
        const FitProblem made = problem_with_made_data();
        const Misfit misfit(mechanism_, made);
        const Objective data = [&](std::span<const double> parameters) {
            return misfit.value(parameters, Priors::ignored);
        };
        PosteriorSettings settings = settings_.posterior;
        settings.seed = truths_.bits(number_, repetition_seed);
        const Posterior posterior = sample_posterior({data, progress, stop, 1}, prior_, settings);
        result.status = posterior.status;
        if (!posterior.draws.empty()) {
            compare(posterior, result);
        }
        return result;
    }

  private:
    static constexpr std::uint32_t repetition_seed = 1U << 20U;  // index of a random number that no parameter uses
    static constexpr std::uint32_t acceptance = repetition_seed + 1;

    // Whether there are parameters with which the observations could have been made.
    bool find_truth() {
        if (!settings_.truth.empty()) {
            truth_ = settings_.truth;
            return predict();
        }
        truth_.resize(mechanism_.parameters.size());
        std::vector<double> coordinates(prior_.size());
        for (int attempt = 0; attempt < most_tries; ++attempt) {
            const std::uint64_t index = number_ * most_tries + static_cast<std::uint64_t>(attempt);
            for (std::size_t dimension = 0; dimension < coordinates.size(); ++dimension) {
                coordinates[dimension] = normal(truths_, index, dimension);
            }
            prior_.values(coordinates, truth_);
            if (predict() && truths_.unit(index, acceptance) < probability_of_inequalities()) {
                return true;
            }
        }
        return false;
    }

    // False if the model has no answer at the known parameters.
    bool predict() {
        predicted_ = misfit_.compare(truth_);
        return misfit_.parts(truth_).failure.empty();
    }

    double probability_of_inequalities() const {
        double squares = 0;
        for (const ObservationFit& row : predicted_) {
            squares += row.relation == Relation::equal ? 0 : row.residual * row.residual;
        }
        return std::exp(-0.5 * squares);
    }

    FitProblem problem_with_made_data() const {
        FitProblem made = problem_;
        for (std::size_t index = 0; index < made.observations.size(); ++index) {
            QuantityObservation& observation = made.observations[index];
            if (observation.relation == Relation::equal && predicted_[index].predicted) {
                observation.value = *predicted_[index].predicted +
                                    predicted_[index].standard_deviation * normal(errors_, number_, index);
            }
        }
        return made;
    }

    void compare(const Posterior& posterior, Recovered& result) const {
        for (std::size_t index = 0; index < prior_.free().size(); ++index) {
            const std::size_t parameter = prior_.free()[index];
            const ParameterPosterior& found = posterior.parameters[index];
            const double truth = truth_[parameter];
            result.mean.push_back(found.mean);
            result.standard_deviation.push_back(found.standard_deviation);
            result.inside_68.push_back(found.interval_68.contains(truth) ? 1 : 0);
            result.inside_95.push_back(found.interval_95.contains(truth) ? 1 : 0);
            int rank = 0;
            for (std::size_t place = 0; place < ranked_draws; ++place) {
                const std::size_t draw = (2 * place + 1) * posterior.draws.size() / (2 * std::size_t{ranked_draws});
                rank += posterior.draws[draw].parameters[parameter] < truth ? 1 : 0;
            }
            result.rank.push_back(rank);
        }
    }

    const Mechanism& mechanism_;
    const FitProblem& problem_;
    const Misfit& misfit_;
    const PriorSpace& prior_;
    const RecoverySettings& settings_;
    std::size_t number_;
    CountedRandom truths_;
    CountedRandom errors_;
    std::vector<double> truth_;
    std::vector<ObservationFit> predicted_;
};

Estimate share(int hits, int of) {
    return {static_cast<double>(hits) / of, wilson_interval(hits, of)};
}

ParameterRecovery summarise(const std::vector<const Recovered*>& counted, std::size_t index, std::size_t parameter) {
    ParameterRecovery summary{};
    const auto count = static_cast<int>(counted.size());
    int inside_68 = 0;
    int inside_95 = 0;
    std::vector<double> errors;
    summary.histogram.assign(bins, 0);
    for (const Recovered* one : counted) {
        inside_68 += one->inside_68[index];
        inside_95 += one->inside_95[index];
        const double deviation = one->standard_deviation[index];
        summary.spread += deviation / count;
        errors.push_back(deviation > 0 ? (one->mean[index] - one->truth[parameter]) / deviation : 0);
        ++summary.histogram[static_cast<std::size_t>(one->rank[index]) * bins / (ranked_draws + 1)];
    }
    summary.coverage_68 = share(inside_68, count);
    summary.coverage_95 = share(inside_95, count);
    summary.bias = count > 1 ? mean_of_replicates(errors) : Estimate{errors.front(), {errors.front(), errors.front()}};
    double chi_square = 0;
    const double expected = static_cast<double>(count) / bins;
    for (const int number : summary.histogram) {
        chi_square += (number - expected) * (number - expected) / expected;
    }
    summary.uniformity = gsl_cdf_chisq_Q(chi_square, bins - 1);
    return summary;
}

}  // namespace

MechanismRecovery recover(const Mechanism& mechanism, const FitProblem& problem, const RecoverySettings& settings,
                          ProgressMeter& progress, StopFlag stop) {
    const bool fixed = !settings.truth.empty();
    if (settings.repetitions < 1 || (fixed && settings.truth.size() != mechanism.parameters.size())) {
        throw std::invalid_argument("recover: needs a repetition, and a truth for each parameter or for none");
    }
    FitProblem without_profile = problem;
    without_profile.profile.reset();
    const Misfit misfit(mechanism, without_profile);
    const PriorSpace prior(mechanism.parameters);
    MechanismRecovery result;
    result.name = mechanism.name;
    result.profile_left_out = problem.profile.has_value();
    const Workers workers{settings.threads, settings.ranks};
    result.repetitions =
        share_tasks<Recovered>(static_cast<std::size_t>(settings.repetitions), workers, [&](std::size_t number) {
            if (stop_requested(stop)) {
                Recovered not_begun;
                not_begun.status = PosteriorStatus::interrupted;
                return not_begun;
            }
            return Repetition(mechanism, without_profile, misfit, prior, settings, number).run(progress, stop);
        });
    std::erase_if(result.repetitions, [&](const Recovered& one) {
        const bool interrupted = one.status == PosteriorStatus::interrupted;
        result.interrupted = result.interrupted || interrupted;
        return interrupted;
    });
    std::vector<const Recovered*> counted;
    for (const Recovered& one : result.repetitions) {
        result.without_truth += one.has_truth ? 0 : 1;
        result.not_converged += one.has_truth && one.status != PosteriorStatus::converged ? 1 : 0;
        if (one.has_truth && one.status == PosteriorStatus::converged) {
            counted.push_back(&one);
        }
    }
    result.counted = static_cast<int>(counted.size());
    if (counted.empty()) {
        return result;
    }
    const std::vector<Dimension> dimensions = misfit.dimensions();
    for (std::size_t index = 0; index < prior.free().size(); ++index) {
        const std::size_t parameter = prior.free()[index];
        ParameterRecovery& summary = result.parameters.emplace_back(summarise(counted, index, parameter));
        summary.index = parameter;
        summary.name = mechanism.parameters[parameter].name;
        summary.dimension = dimensions[parameter];
    }
    return result;
}

}  // namespace delabole
