// Measures the cost of plane failure. Run with --benchmark_repetitions=10 --benchmark_report_aggregates_only=false and
// read the least time: everything else is the machine.
#include "plane_failure/critical.hpp"
#include "plane_failure/plane_failure.hpp"
#include "plane_failure/required.hpp"
#include "plane_failure/sensitivity.hpp"

#include <benchmark/benchmark.h>

namespace delabole {
namespace {

// Wyllie & Mah (2004), example 7.1: the Hoek-Bray case.
PlaneFailure<> hoek_bray() {
    PlaneFailure<> problem{};
    problem.slope = {12.0, degrees(60), 0.0, {}, {}};
    problem.failure_plane = {degrees(35), {}};
    problem.tension_crack = TensionCrack<>{degrees(90), CrackAtDistance<>{4.0}};
    problem.rock = {26e3};
    problem.strength = Coulomb<>{25e3, degrees(37)};
    problem.water = CrackAndBaseWater<>{9.81e3, FilledRatio<>{0.5}};
    return problem;
}

void factor_of_safety_alone(benchmark::State& state) {
    PlaneFailure<> problem = hoek_bray();
    for (auto _ : state) {
        benchmark::DoNotOptimize(problem);
        benchmark::DoNotOptimize(factor_of_safety(problem));
    }
}
BENCHMARK(factor_of_safety_alone);

void analyse_with_all_checks(benchmark::State& state) {
    PlaneFailure<> problem = hoek_bray();
    for (auto _ : state) {
        benchmark::DoNotOptimize(problem);
        benchmark::DoNotOptimize(analyse(problem));
    }
}
BENCHMARK(analyse_with_all_checks);

// One sample of a Monte Carlo run takes a fresh copy, draws three inputs and makes all checks.
void monte_carlo_sample(benchmark::State& state) {
    const PlaneFailure<> base = hoek_bray();
    double drawn = 0;
    for (auto _ : state) {
        drawn = drawn < 1 ? drawn + 1e-3 : 0;
        PlaneFailure<> problem = base;
        auto& strength = std::get<Coulomb<>>(problem.strength);
        strength.cohesion = 20e3 + 10e3 * drawn;
        strength.friction_angle = degrees(32 + 10 * drawn);
        std::get<FilledRatio<>>(std::get<CrackAndBaseWater<>>(problem.water).level).filled_ratio = drawn;
        double value = 0;
        if (check_ranges(problem) == PlaneFailureCheck::valid) {
            value = factor_of_safety(problem).value;
        }
        benchmark::DoNotOptimize(value);
    }
    state.SetItemsProcessed(state.iterations());
}
BENCHMARK(monte_carlo_sample);

void all_sensitivities(benchmark::State& state) {
    const PlaneFailure<> problem = hoek_bray();
    for (auto _ : state) {
        benchmark::DoNotOptimize(sensitivities(problem));
    }
}
BENCHMARK(all_sensitivities);

void critical_crack(benchmark::State& state) {
    const PlaneFailure<> problem = hoek_bray();
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            find_critical_geometry(problem, {CriticalFeature::tension_crack, SearchCondition::dry_slope, {}, {}}));
    }
}
BENCHMARK(critical_crack);

void critical_crack_and_plane(benchmark::State& state) {
    const PlaneFailure<> problem = hoek_bray();
    for (auto _ : state) {
        benchmark::DoNotOptimize(
            find_critical_geometry(problem, {CriticalFeature::both, SearchCondition::dry_slope, {}, {}}));
    }
}
BENCHMARK(critical_crack_and_plane);

void required_cohesion(benchmark::State& state) {
    const PlaneFailure<> problem = hoek_bray();
    for (auto _ : state) {
        benchmark::DoNotOptimize(required_value({problem, {}, {}}, "strength.cohesion", 1));
    }
}
BENCHMARK(required_cohesion);

void predict_through_the_interface(benchmark::State& state) {
    const ModelInterface model = model_interface({hoek_bray(), {}, {}});
    const std::vector<Assignment> assignments = {{3, degrees(35)}, {7, 25e3}};
    for (auto _ : state) {
        benchmark::DoNotOptimize(model.predict(assignments));
    }
}
BENCHMARK(predict_through_the_interface);

void predict_with_critical_geometry(benchmark::State& state) {
    const ModelInterface model =
        model_interface({hoek_bray(), CriticalSearch<>{CriticalFeature::both, SearchCondition::dry_slope, {}, {}}, {}});
    const std::vector<Assignment> assignments = {{7, 25e3}};
    for (auto _ : state) {
        benchmark::DoNotOptimize(model.predict(assignments));
    }
}
BENCHMARK(predict_with_critical_geometry);

}  // namespace
}  // namespace delabole
