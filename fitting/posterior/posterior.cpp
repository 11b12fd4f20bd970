#include "fitting/posterior/posterior.hpp"

#include "fitting/posterior/posterior_chain.hpp"
#include "fitting/probability/estimate.hpp"
#include "fitting/work/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace delabole {

namespace {

using Chains = std::vector<PosteriorChain>;
using Values = std::vector<std::vector<double>>;  // values of one parameter, chain by chain

Values values_of(const Chains& chains, std::size_t parameter, std::size_t steps) {
    Values values;
    for (const PosteriorChain& chain : chains) {
        std::vector<double>& column = values.emplace_back();
        for (std::size_t step = 0; step < steps; ++step) {
            column.push_back(chain.states()[step].parameters[parameter]);
        }
    }
    return values;
}

Interval central(const std::vector<double>& sorted, double probability) {
    return {sorted_quantile(sorted, (1 - probability) / 2), sorted_quantile(sorted, (1 + probability) / 2)};
}

ParameterPosterior describe(const std::string& name, const Values& values) {
    const std::vector<double> sorted = sorted_together(values);
    const auto count = static_cast<double>(sorted.size());
    ParameterPosterior result;
    result.name = name;
    for (const double value : sorted) {
        result.mean += value / count;
    }
    double squares = 0;
    for (const double value : sorted) {
        squares += (value - result.mean) * (value - result.mean);
    }
    result.standard_deviation = std::sqrt(squares / (count - 1));
    result.median = sorted_quantile(sorted, 0.5);
    result.interval_68 = central(sorted, probability_68);
    result.interval_95 = central(sorted, probability_95);
    result.diagnostics = diagnose(values);
    return result;
}

bool met(const ChainDiagnostics& diagnostics) {
    return diagnostics.r_hat < greatest_r_hat && diagnostics.bulk_size > least_effective_size &&
           diagnostics.tail_size > least_effective_size;
}

std::vector<RunningQuantiles> running_quantiles(const Chains& chains, std::size_t parameter, std::size_t steps) {
    constexpr std::size_t lengths = 10;
    std::vector<RunningQuantiles> running;
    for (std::size_t part = 1; part <= lengths; ++part) {
        const std::size_t length = steps * part / lengths;
        if (length < 4) {
            continue;
        }
        const Values values = values_of(chains, parameter, length);
        const std::vector<double> sorted = sorted_together(values);
        const Interval interval = central(sorted, probability_95);
        running.push_back(
            {static_cast<int>(length), interval.lower, sorted_quantile(sorted, 0.5), interval.upper, r_hat(values)});
    }
    return running;
}

Eigen::MatrixXd correlation_of(const Chains& chains, const std::vector<std::size_t>& free,
                               const std::vector<ParameterPosterior>& parameters) {
    const auto size = static_cast<Eigen::Index>(free.size());
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(size, size);
    double count = 0;
    Eigen::VectorXd scaled(size);
    for (const PosteriorChain& chain : chains) {
        for (const PosteriorChain::State& state : chain.states()) {
            for (Eigen::Index row = 0; row < size; ++row) {
                const auto index = static_cast<std::size_t>(row);
                const double deviation = parameters[index].standard_deviation;
                scaled(row) = deviation > 0 ? (state.parameters[free[index]] - parameters[index].mean) / deviation : 0;
            }
            sum += scaled * scaled.transpose();
            ++count;
        }
    }
    sum /= count - 1;
    sum.diagonal().setOnes();
    return sum;
}

std::vector<Draw> thinned(const Chains& chains, std::size_t steps, std::size_t wanted) {
    const std::size_t kept = std::min(steps, std::max<std::size_t>(wanted / chains.size(), 1));
    std::vector<Draw> draws;
    for (std::size_t number = 0; number < chains.size(); ++number) {
        for (std::size_t place = 0; place < kept; ++place) {
            // The last state of each stretch is taken, so that the draws lie as far apart as possible.
            const PosteriorChain::State& state = chains[number].states()[(place + 1) * steps / kept - 1];
            draws.push_back({static_cast<int>(number), state.parameters, state.misfit});
        }
    }
    return draws;
}

// Describes the free parameters; returns whether all of them meet the diagnostics.
bool describe_all(const Chains& chains, const PriorSpace& prior, std::size_t steps, Posterior& posterior) {
    posterior.parameters.clear();
    bool all = true;
    for (const std::size_t index : prior.free()) {
        posterior.parameters.push_back(describe(prior.parameters()[index].name, values_of(chains, index, steps)));
        all = all && met(posterior.parameters.back().diagnostics);
    }
    return all;
}

std::size_t common_length(const Chains& chains) {
    std::size_t length = std::numeric_limits<std::size_t>::max();
    for (const PosteriorChain& chain : chains) {
        length = std::min(length, chain.states().size());
    }
    return length;
}

void for_each_chain(Chains& chains, int threads, const std::function<void(std::size_t)>& task) {
    run_tasks(chains.size(), threads, task);
}

// An archive of states, equally many of each chain.
PosteriorArchive archive_of(const Chains& chains, std::uint64_t seed) {
    constexpr std::size_t size = 1200;
    constexpr std::size_t most_components = 16;
    std::vector<std::vector<double>> points;
    for (const PosteriorChain& chain : chains) {
        const std::size_t count = std::min(size / chains.size() + 1, chain.states().size());
        for (std::size_t index = 0; index < count; ++index) {
            points.push_back(chain.states()[index * chain.states().size() / count].normal);
        }
    }
    const Eigen::MatrixXd columns = as_columns(points);
    return {std::move(points), StudentMixture(columns, Eigen::VectorXd::Ones(columns.cols()), most_components, seed)};
}

// Rounds of steps, each twice as long as the last, until the diagnostics are met. False if the work was stopped.
bool walk_until_converged(const Evaluator& misfit, const PriorSpace& prior, const PosteriorSettings& settings,
                          Chains& chains, Posterior& posterior) {
    int steps = std::max(settings.draws / settings.chains, 8);
    for (int spent = 0;; steps *= 2) {
        spent += steps;
        const PosteriorArchive archive = archive_of(chains, settings.seed);
        for_each_chain(chains, misfit.threads, [&](std::size_t number) { chains[number].walk(steps, archive); });
        if (misfit.stopped()) {
            return false;
        }
        const bool converged = describe_all(chains, prior, static_cast<std::size_t>(steps), posterior);
        if (converged || spent + 2 * steps > settings.evaluations_per_chain) {
            posterior.status = converged ? PosteriorStatus::converged : PosteriorStatus::not_converged;
            return true;
        }
    }
}

Posterior without_parameters(const Evaluator& misfit, const PriorSpace& prior) {
    Posterior posterior;
    std::vector<double> parameters(prior.parameters().size());
    prior.values({}, parameters);
    const Evaluation evaluation = misfit.quantity(parameters);
    misfit.progress.count();
    posterior.evaluations.record(evaluation);
    if (evaluation.valid()) {
        posterior.status = PosteriorStatus::converged;
        posterior.draws.push_back({0, std::move(parameters), evaluation.value});
    }
    return posterior;
}

}  // namespace

Posterior sample_posterior(const Evaluator& misfit, const PriorSpace& prior, const PosteriorSettings& settings) {
    if (settings.chains < 2 || settings.draws < 8 * settings.chains || settings.evaluations_per_chain < 1) {
        throw std::invalid_argument("sample_posterior: needs at least 2 chains, 8 draws of each and 1 evaluation");
    }
    if (prior.size() == 0) {
        return without_parameters(misfit, prior);
    }
    Posterior posterior;
    Chains chains;
    for (int number = 0; number < settings.chains; ++number) {
        chains.emplace_back(misfit, prior, settings.seed, number);
    }
    std::vector<char> begun(chains.size());
    for_each_chain(chains, misfit.threads, [&](std::size_t number) { begun[number] = chains[number].begin() ? 1 : 0; });
    const bool all_begun = std::find(begun.begin(), begun.end(), 0) == begun.end();
    // If one chain found no valid start none is sampled, because its thousands of draws of the prior all failed.
    const bool finished = all_begun && walk_until_converged(misfit, prior, settings, chains, posterior);
    for (const PosteriorChain& chain : chains) {
        posterior.evaluations.add(chain.evaluations());
    }
    if (misfit.stopped()) {
        posterior.status = PosteriorStatus::interrupted;
    }
    if (!finished || misfit.stopped()) {
        posterior.parameters.clear();
        return posterior;
    }
    const std::size_t steps = common_length(chains);
    posterior.steps = static_cast<int>(steps);
    posterior.correlation = correlation_of(chains, prior.free(), posterior.parameters);
    posterior.draws = thinned(chains, steps, static_cast<std::size_t>(settings.draws));
    double moved = 0;
    for (const PosteriorChain& chain : chains) {
        moved += chain.moved();
    }
    posterior.acceptance = moved / static_cast<double>(steps * chains.size());
    for (const std::size_t index : prior.free()) {
        posterior.running.push_back(running_quantiles(chains, index, steps));
    }
    return posterior;
}

}  // namespace delabole
