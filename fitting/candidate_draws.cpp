#include "fitting/candidate_draws.hpp"

#include "fitting/comparison.hpp"
#include "fitting/input_binding.hpp"
#include "fitting/share.hpp"

#include <algorithm>
#include <limits>
#include <optional>

namespace delabole {

namespace {

// A quantity as a function of a mechanism's parameters.
class Measured {
  public:
    // Nothing where the mechanism has none of the candidate's quantities, or lacks an input that its conditions fix.
    static std::optional<Measured> of(const FitCandidate& candidate, const Mechanism& mechanism) {
        for (const Condition& condition : candidate.conditions) {
            if (!place_of(mechanism.model.inputs, condition.input)) {
                return std::nullopt;
            }
        }
        Measured measured(mechanism, candidate.conditions);
        for (const std::string& name : candidate.quantities) {
            measured.output_ = place_of(mechanism.model.outputs, name);
            measured.input_ = place_of(mechanism.model.inputs, name);
            if (measured.output_ || measured.input_) {
                return measured;
            }
        }
        return std::nullopt;
    }

    // NaN where the model has no answer.
    double at(std::span<const double> parameters) const {
        const std::vector<Assignment> assignments = binding_.at(parameters);
        if (!output_) {
            double value = mechanism_.model.inputs[*input_].value;
            for (const Assignment& assignment : assignments) {
                value = assignment.input == *input_ ? assignment.value : value;
            }
            return value;
        }
        const Prediction prediction = mechanism_.model.predict(assignments);
        return prediction.failure.empty() ? prediction.outputs[*output_] : std::numeric_limits<double>::quiet_NaN();
    }

  private:
    Measured(const Mechanism& mechanism, const std::vector<Condition>& conditions)
        : mechanism_(mechanism), binding_(mechanism, conditions) {}

    const Mechanism& mechanism_;
    InputBinding binding_;
    std::optional<std::size_t> output_;
    std::optional<std::size_t> input_;
};

// No more than are worth their time, as many of each chain.
std::vector<Draw> draws_of(const Posterior& posterior, bool costly) {
    const std::size_t most = costly ? most_costly_draws : most_draws;
    const std::size_t step = std::max<std::size_t>((posterior.draws.size() + most - 1) / most, 1);
    std::vector<Draw> draws;
    for (std::size_t index = step - 1; index < posterior.draws.size(); index += step) {
        draws.push_back(posterior.draws[index]);
    }
    return draws;
}

MechanismDraws draws_of(const FitProblem& problem, const Mechanism& mechanism, const MechanismFit& fit,
                        double probability, ProgressMeter& progress) {
    MechanismDraws result;
    result.name = mechanism.name;
    result.probability = probability;
    const std::vector<Draw> draws = draws_of(fit.posterior->posterior, mechanism.model.costly);
    for (const Draw& draw : draws) {
        result.chain.push_back(draw.chain);
    }
    for (std::size_t index = 0; index < mechanism.parameters.size(); ++index) {
        if (mechanism.parameters[index].lower < mechanism.parameters[index].upper) {
            result.parameters.push_back(mechanism.parameters[index].name);
            std::vector<double>& column = result.values.emplace_back();
            for (const Draw& draw : draws) {
                column.push_back(draw.parameters[index]);
            }
        }
    }
    const Workers workers{problem.settings.threads, problem.settings.ranks};
    for (const FitCandidate& candidate : problem.candidates) {
        const std::optional<Measured> measured = Measured::of(candidate, mechanism);
        result.predicted.emplace_back();
        if (measured) {
            result.predicted.back() = share_tasks<double>(draws.size(), workers, [&](std::size_t number) {
                progress.count();
                return measured->at(draws[number].parameters);
            });
        }
    }
    return result;
}

}  // namespace

std::vector<MechanismDraws> draws_for_candidates(const FitProblem& problem, const FitResult& result,
                                                 ProgressMeter& progress) {
    std::vector<LogEvidence> evidences;
    std::vector<const MechanismFit*> fits;
    for (const MechanismFit& fit : result.mechanisms) {
        if (fit.posterior && !fit.posterior->posterior.draws.empty()) {
            fits.push_back(&fit);
            evidences.push_back({fit.posterior->log_evidence(), fit.posterior->evidence().standard_error});
        }
    }
    const std::vector<MechanismWeight> weights = weigh(evidences);
    std::vector<MechanismDraws> draws;
    for (std::size_t index = 0; index < fits.size(); ++index) {
        const auto mechanism = std::find_if(problem.mechanisms.begin(), problem.mechanisms.end(),
                                            [&](const Mechanism& other) { return other.name == fits[index]->name; });
        draws.push_back(draws_of(problem, *mechanism, *fits[index], weights[index].probability, progress));
    }
    return draws;
}

std::vector<CandidateInformation> information_of(const FitProblem& problem, const FitResult& result,
                                                 const FitProgressCallback& progress, StopFlag stop) {
    if (problem.candidates.empty() || stop_requested(stop)) {
        return {};
    }
    ProgressMeter meter(progress, 1);
    meter.begin_stage("all mechanisms", "what to measure next", 1);
    const std::vector<MechanismDraws> draws = draws_for_candidates(problem, result, meter);
    if (draws.empty()) {
        return {};
    }
    InformationSettings settings;
    settings.seed = problem.settings.seed;
    settings.threads = problem.settings.threads;
    return value_of_information(problem.candidates, draws, settings);
}

}  // namespace delabole
