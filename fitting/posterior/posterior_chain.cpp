#include "fitting/posterior/posterior_chain.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace delabole {

PosteriorChain::PosteriorChain(const Evaluator& misfit, const PriorSpace& prior, std::uint64_t seed, int number)
    : misfit_(misfit), prior_(prior), random_(seed, RandomPurpose::chain, static_cast<std::uint32_t>(number)) {}

double PosteriorChain::normal_number() {
    return normal_quantile(random_.unit());
}

bool PosteriorChain::evaluate(State& state, double least) {
    state.parameters.resize(prior_.parameters().size());
    prior_.values(state.normal, state.parameters);
    double log_prior = 0;
    for (const double number : state.normal) {
        log_prior -= number * number / 2;
    }
    // The margin is for rounding: what it lets through is decided by the whole misfit.
    const double most = 2 * (log_prior - least) + 1e-9 * (1 - log_prior + std::abs(least));
    const bool hopeless = misfit_.bounded != nullptr && most < 0;
    const Evaluation evaluation = hopeless ? Evaluation{} : misfit_.value(state.parameters, most);
    misfit_.progress.count();
    evaluations_.record(evaluation);
    if (!evaluation.valid() || hopeless) {
        return false;
    }
    state.misfit = evaluation.value;
    state.log_density = -evaluation.value / 2;
    for (const double number : state.normal) {
        state.log_density -= number * number / 2;
    }
    return true;
}

PosteriorChain::Proposal PosteriorChain::difference_step(const State& from, const Points& archive) {
    const auto dimension = static_cast<double>(from.normal.size());
    // A full difference can jump from one mode to another; the other length is the best for a normal distribution.
    double length = random_.unit() < 0.1 ? 1 : 2.38 / std::sqrt(2 * dimension);
    if (random_.unit() < 1.0 / 3) {
        length *= std::pow(30, -random_.unit());
    }
    const std::size_t first = random_.below(archive.size());
    const std::size_t second = (first + 1 + random_.below(archive.size() - 1)) % archive.size();
    // A small random offset makes every point reachable although the archive is finite.
    constexpr double jitter = 1e-4;
    Proposal proposal{from.normal, 0};
    for (std::size_t index = 0; index < proposal.normal.size(); ++index) {
        proposal.normal[index] +=
            length * ((*archive[first])[index] - (*archive[second])[index]) + jitter * normal_number();
    }
    return proposal;
}

PosteriorChain::Proposal PosteriorChain::snooker_step(const State& from, const Points& archive) {
    const std::vector<double>& anchor = *archive[random_.below(archive.size())];
    const std::vector<double>& first = *archive[random_.below(archive.size())];
    const std::vector<double>& second = *archive[random_.below(archive.size())];
    const double length = 1.2 + random_.unit();
    double along = 0;
    double squared = 0;
    for (std::size_t index = 0; index < anchor.size(); ++index) {
        const double to_anchor = from.normal[index] - anchor[index];
        along += to_anchor * (first[index] - second[index]);
        squared += to_anchor * to_anchor;
    }
    Proposal proposal{from.normal, 0};
    if (!(squared > 0)) {
        return proposal;
    }
    const double stretch = length * along / squared;  // as a share of the distance to the anchor
    for (std::size_t index = 0; index < anchor.size(); ++index) {
        proposal.normal[index] += stretch * (from.normal[index] - anchor[index]);
    }
    proposal.log_weight = static_cast<double>(anchor.size() - 1) * std::log(std::abs(1 + stretch));
    return proposal;
}

PosteriorChain::Proposal PosteriorChain::mixture_step(const State& from, const StudentMixture& mixture) {
    std::vector<double> unit(mixture.unit_dimension());
    for (double& coordinate : unit) {
        coordinate = random_.unit();
    }
    Proposal proposal{from.normal, 0};
    mixture.draw(unit, proposal.normal);
    proposal.log_weight = mixture.log_density(from.normal) - mixture.log_density(proposal.normal);
    return proposal;
}

bool PosteriorChain::accept(State& state, Proposal proposal) {
    const double threshold = std::log(random_.unit());
    State candidate;
    candidate.normal = std::move(proposal.normal);
    if (!evaluate(candidate, state.log_density - proposal.log_weight + threshold) ||
        candidate.log_density - state.log_density + proposal.log_weight < threshold) {
        return false;
    }
    state = std::move(candidate);
    return true;
}

bool PosteriorChain::local_step(State& state, const Points& archive) {
    constexpr double snooker_share = 0.2;
    return accept(state,
                  random_.unit() < snooker_share ? snooker_step(state, archive) : difference_step(state, archive));
}

bool PosteriorChain::begin() {
    const std::size_t members = std::clamp<std::size_t>(10 * prior_.size(), 20, 80);
    constexpr std::size_t tries_per_member = 100;
    std::vector<State> population;
    for (std::size_t attempt = 0; attempt < tries_per_member * members && population.size() < members; ++attempt) {
        if (misfit_.stopped()) {
            return false;
        }
        State state;
        for (std::size_t index = 0; index < prior_.size(); ++index) {
            state.normal.push_back(normal_number());
        }
        if (evaluate(state)) {
            population.push_back(std::move(state));
        }
    }
    if (population.empty()) {
        return false;
    }
    // If few draws have an answer, several members begin at the same point and then move apart.
    const std::size_t found = population.size();
    while (population.size() < members) {
        population.push_back(population[population.size() - found]);
    }
    constexpr int generations = 30;
    constexpr int kept = 10;
    for (int generation = 0; generation < generations; ++generation) {
        for (std::size_t index = 0; index < members; ++index) {
            if (misfit_.stopped()) {
                return false;
            }
            Points others;
            for (std::size_t other = 0; other < members; ++other) {
                if (other != index) {
                    others.push_back(&population[other].normal);
                }
            }
            local_step(population[index], others);
        }
        if (generation >= generations - kept) {
            states_.insert(states_.end(), population.begin(), population.end());
        }
    }
    current_ = population[random_.below(members)];
    return true;
}

void PosteriorChain::walk(int steps, const PosteriorArchive& archive) {
    Points points;
    for (const std::vector<double>& point : archive.points) {
        points.push_back(&point);
    }
    states_.clear();
    states_.reserve(static_cast<std::size_t>(steps));
    moved_ = 0;
    constexpr double mixture_share = 0.4;
    for (int number = 0; number < steps && !misfit_.stopped(); ++number) {
        const bool moved = random_.unit() < mixture_share ? accept(current_, mixture_step(current_, archive.mixture))
                                                          : local_step(current_, points);
        moved_ += moved ? 1 : 0;
        states_.push_back(current_);
    }
}

}  // namespace delabole
