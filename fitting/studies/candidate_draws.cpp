#include "fitting/studies/candidate_draws.hpp"

#include "fitting/mechanism/input_binding.hpp"
#include "fitting/search/share.hpp"
#include "fitting/studies/comparison.hpp"

#include <algorithm>

namespace delabole {

namespace {

MechanismDraws draws_of(const FitProblem& problem, const Mechanism& mechanism, const MechanismFit& fit,
                        double probability, ProgressMeter& progress) {
    MechanismDraws result;
    result.name = mechanism.name;
    result.probability = probability;
    const std::vector<Draw> draws =
        thinned(fit.posterior->posterior.draws, mechanism.model.costly ? most_costly_draws : most_draws);
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
        const auto measured = QuantityOfMechanism::of(mechanism, candidate.quantities, candidate.conditions);
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
    const std::vector<MechanismWeight> weights = weigh(result);
    std::vector<MechanismDraws> draws;
    for (std::size_t index = 0; index < result.mechanisms.size(); ++index) {
        const MechanismFit& fit = result.mechanisms[index];
        if (fit.posterior && !fit.posterior->posterior.draws.empty()) {
            const auto mechanism = std::ranges::find(problem.mechanisms, fit.name, &Mechanism::name);
            draws.push_back(draws_of(problem, *mechanism, fit, weights[index].probability, progress));
        }
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
