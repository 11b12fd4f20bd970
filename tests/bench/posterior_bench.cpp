// Cost of a posterior and of an evidence: without a model, and with one of a given cost.
#include "fitting/posterior/evidence.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace delabole;

void spend(std::chrono::nanoseconds cost) {
    const auto end = std::chrono::steady_clock::now() + cost;
    while (cost.count() > 0 && std::chrono::steady_clock::now() < end) {
    }
}

// A ridge along x1 x2 = 1 / 4 that is 0.01 wide; further parameters keep their priors.
Objective ridge(std::chrono::nanoseconds cost) {
    return [cost](std::span<const double> x) {
        spend(cost);
        const double residual = (x[0] * x[1] - 0.25) / 0.01;
        return Evaluation{residual * residual, {}};
    };
}

PriorSpace priors(std::int64_t count) {
    std::vector<FreeParameter> parameters;
    for (std::int64_t index = 0; index < count; ++index) {
        parameters.push_back({"x" + std::to_string(index + 1), 0, 1, Prior{0.5, 0.3, "bench"}});
    }
    return PriorSpace(std::move(parameters));
}

void posterior(benchmark::State& state) {
    const Objective misfit = ridge(std::chrono::nanoseconds(state.range(1)));
    const PriorSpace prior = priors(state.range(0));
    Posterior found;
    for (auto _ : state) {
        ProgressMeter progress({}, 1);
        found = sample_posterior({misfit, progress, nullptr, static_cast<int>(state.range(2))}, prior, {});
    }
    double size = 1e9;
    for (const ParameterPosterior& parameter : found.parameters) {
        size = std::min(size, parameter.diagnostics.bulk_size);
    }
    state.counters["evaluations"] = static_cast<double>(found.evaluations.total);
    state.counters["effective_size"] = size;
    state.SetLabel(std::string(word_of(found.status)));
}
BENCHMARK(posterior)
    ->ArgNames({"parameters", "model_ns", "threads"})
    ->Args({2, 0, 1})
    ->Args({4, 0, 1})
    ->Args({4, 10000, 1})
    ->Args({4, 10000, 2})
    ->Unit(benchmark::kMillisecond);

void evidence(benchmark::State& state) {
    const Objective misfit = ridge(std::chrono::nanoseconds(0));
    const PriorSpace prior = priors(state.range(0));
    ProgressMeter progress({}, 1);
    const Evaluator evaluator{misfit, progress, nullptr, 1};
    const Posterior found = sample_posterior(evaluator, prior, {});
    Evidence estimate;
    for (auto _ : state) {
        estimate = estimate_evidence(evaluator, prior, found.draws, {});
    }
    state.counters["standard_error"] = estimate.standard_error;
}
BENCHMARK(evidence)->ArgName("parameters")->Arg(2)->Arg(4)->Unit(benchmark::kMillisecond);

}  // namespace
