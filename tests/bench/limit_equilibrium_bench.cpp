// Measures the cost of columns on a stepped base once they are made. Run with --benchmark_repetitions=10 and read the
// least time: everything else is the machine.
#include "limit_equilibrium/stepped_base/stepped_base_study.hpp"

#include <benchmark/benchmark.h>

namespace delabole {
namespace {

// Goodman & Bray's (1976) slope; 16 columns of 10 m, or the same shape in finer columns.
SteppedBase<> goodman_bray(int columns_to_crest) {
    const double scale = 10.0 / columns_to_crest;
    BlockColumns<> columns{degrees(60), {}};
    for (int n = 1; n <= columns_to_crest; ++n) {
        columns.block.push_back({4 * scale * n, 10 * scale, scale, std::nullopt});
    }
    for (int n = 1; 40 - 6 * scale * n > scale; ++n) {
        columns.block.push_back({40 - 6 * scale * n, 10 * scale, scale, std::nullopt});
    }
    SteppedBase<> problem{};
    problem.scene.columns = columns;
    problem.scene.rock.unit_weight = 25e3;
    problem.scene.water = Dry{};
    problem.joints.friction_angle = std::atan(0.65);
    problem.bases = {std::atan(0.65), 0};
    return problem;
}

void recursion(benchmark::State& state) {
    const SteppedBase<> problem = goodman_bray(static_cast<int>(state.range(0)));
    const ColumnSlope<> slope = make_columns(problem.scene);
    ColumnStrength<> strength = strength_of(problem);
    for (auto _ : state) {
        benchmark::DoNotOptimize(strength);
        benchmark::DoNotOptimize(toe_balance(slope, strength, JointForce<>{0, 0, 0}));
    }
    state.counters["columns"] = static_cast<double>(slope.columns.size());
    state.SetComplexityN(static_cast<std::int64_t>(slope.columns.size()));
}
BENCHMARK(recursion)->Arg(10)->Arg(100)->Arg(1000)->Arg(6250)->Complexity(benchmark::oN);

void limiting_friction(benchmark::State& state) {
    ColumnSlope<> slope = make_columns(goodman_bray(static_cast<int>(state.range(0))).scene);
    int evaluations = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(slope);
        const Limit limit = limiting_friction_angle(slope, 0);
        evaluations = limit.evaluations;
        benchmark::DoNotOptimize(limit.value);
    }
    state.counters["evaluations"] = evaluations;
}
BENCHMARK(limiting_friction)->Arg(10)->Arg(1000);

void factor_of_safety_of_made_columns(benchmark::State& state) {
    const SteppedBase<> problem = goodman_bray(10);
    ColumnSlope<> slope = make_columns(problem.scene);
    int evaluations = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(slope);
        const Limit limit = factor_of_safety(slope, strength_of(problem));
        evaluations = limit.evaluations;
        benchmark::DoNotOptimize(limit.value);
    }
    state.counters["evaluations"] = evaluations;
}
BENCHMARK(factor_of_safety_of_made_columns);

void cable(benchmark::State& state) {
    const SteppedBase<> problem = goodman_bray(10);
    const RequiredCable<> request{static_cast<double>(state.range(0)), degrees(10), 2, 1};
    for (auto _ : state) {
        benchmark::DoNotOptimize(required_cable(problem, request));
    }
}
BENCHMARK(cable)->Arg(1)->Arg(3);

void analyse_with_all_checks(benchmark::State& state) {
    SteppedBase<> problem = goodman_bray(10);
    for (auto _ : state) {
        benchmark::DoNotOptimize(problem);
        benchmark::DoNotOptimize(analyse(problem));
    }
}
BENCHMARK(analyse_with_all_checks);

void predict_through_the_interface(benchmark::State& state) {
    SteppedBaseStudy<> study{};
    study.model = goodman_bray(10);
    const ModelInterface model = model_interface(study);
    for (auto _ : state) {
        benchmark::DoNotOptimize(model.predict({}));
    }
}
BENCHMARK(predict_through_the_interface);

}  // namespace
}  // namespace delabole
