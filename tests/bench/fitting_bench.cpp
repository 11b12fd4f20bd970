// Cost of a whole back-analysis with the default settings: three parameters, a model of a given cost.
#include "fitting/back_analysis/back_analysis.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <vector>

namespace {

using namespace delabole;

void spend(std::chrono::nanoseconds cost) {
    const auto end = std::chrono::steady_clock::now() + cost;
    while (cost.count() > 0 && std::chrono::steady_clock::now() < end) {
    }
}

// The model resembles plane failure: friction is in rad, cohesion and water are ratios.
ModelInterface sliding_model(std::chrono::nanoseconds cost) {
    ModelInterface model;
    for (const char* name : {"friction_angle", "cohesion", "water"}) {
        Quantity input;
        input.name = name;
        model.inputs.push_back(input);
    }
    for (const char* name : {"factor_of_safety", "crack_depth"}) {
        Quantity output;
        output.name = name;
        model.outputs.push_back(output);
    }
    model.predict = [cost](std::span<const Assignment> assignments) {
        spend(cost);
        double values[3] = {0.5, 0.5, 0.5};
        for (const Assignment& assignment : assignments) {
            values[assignment.input] = assignment.value;
        }
        const double safety = values[1] + 1.2 * std::tan(values[0]) * (1 - 0.6 * values[2] * values[2]);
        Prediction prediction;
        prediction.outputs = {safety, 40 * (1 - values[1]) * (1 + 0.2 * values[2])};
        prediction.profile = {Point(0, 0), Point(30, 30 * std::tan(0.6 + 0.3 * values[0])), Point(60, 60)};
        return prediction;
    };
    return model;
}

FitProblem sliding_problem(std::chrono::nanoseconds cost, bool profile) {
    FitProblem problem;
    problem.mechanisms.push_back({{"sliding",
                                   "Sliding",
                                   {{"friction_angle", 0.2, 0.9, Prior{0.52, 0.1, "bench"}},
                                    {"cohesion", 0, 1, Prior{0.4, 0.3, "bench"}},
                                    {"water", 0, 1, std::nullopt}}},
                                  sliding_model(cost)});
    problem.observations.push_back({"failed", "factor_of_safety", Relation::equal, 1, 0.05, {}, "bench"});
    problem.observations.push_back({"stood", "factor_of_safety", Relation::at_least, 1, 0.05, {{"water", 0}}, "bench"});
    problem.observations.push_back({"crack", "crack_depth", Relation::equal, 25, 5, {}, "bench"});
    if (profile) {
        problem.profile = ProfileObservation{{Point(0, 0), Point(30, 28), Point(60, 60)}, 2, "bench"};
    }
    return problem;
}

void fit_sliding(benchmark::State& state) {
    const FitProblem problem = sliding_problem(std::chrono::nanoseconds(state.range(0)), state.range(1) != 0);
    long evaluations = 0;
    for (auto _ : state) {
        evaluations = fit(problem).mechanisms[0].evaluations.total;
    }
    state.counters["evaluations"] = static_cast<double>(evaluations);
}
BENCHMARK(fit_sliding)
    ->ArgNames({"model_ns", "profile"})
    ->Args({0, 0})
    ->Args({300, 1})
    ->Args({20000, 1})
    ->Unit(benchmark::kMillisecond);

}  // namespace
