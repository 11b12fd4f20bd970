// Measures the cost of dividing a slope into columns, and of searching for its least stable base.
#include "limit_equilibrium/stepped_base/critical_base.hpp"
#include "tests/lib/limit_equilibrium/columns/reference_recursion.hpp"

#include <benchmark/benchmark.h>

namespace delabole {
namespace {

// Goodman & Bray's (1976) slope with columns of any number.
ColumnScene<> goodman_bray(double columns_to_crest) {
    ColumnScene<> scene{};
    const double base_dip = degrees(30);
    scene.slope = SlopeSection<>{92.5, base_dip + std::atan(0.5), base_dip - std::atan(0.5), {}, {}};
    scene.columns = ContinuousColumns<>{degrees(60), 100 / columns_to_crest, base_dip + std::atan(0.1), {}};
    scene.rock = {25e3};
    scene.water = FilledJointsWater<>{9810, 0.1};
    return scene;
}

void make_wet_columns(benchmark::State& state) {
    ColumnScene<> scene = goodman_bray(static_cast<double>(state.range(0)));
    for (auto _ : state) {
        benchmark::DoNotOptimize(scene);
        benchmark::DoNotOptimize(make_columns(scene));
    }
    state.SetComplexityN(state.range(0));
}
BENCHMARK(make_wet_columns)->Arg(10)->Arg(100)->Arg(1000)->Arg(10000)->Complexity(benchmark::oN);

void search_critical_base(benchmark::State& state) {
    const ColumnScene<> scene = goodman_bray(10);
    const CriticalBaseSearch<> request{
        static_cast<CriticalBaseFeature>(state.range(0)), SearchCondition::given_water, {}, {}, {}, {}};
    int evaluations = 0;
    for (auto _ : state) {
        const CriticalBase critical = find_critical_base(scene, request, [](const ColumnScene<>& at) {
            const ColumnSlope<> slope = make_columns(at);
            return slope.check == ColumnCheck::valid ? test::factor_of_safety(slope, 0.8, 0.8)
                                                     : std::numeric_limits<double>::infinity();
        });
        evaluations = critical.evaluations;
    }
    state.counters["evaluations"] = evaluations;
}
BENCHMARK(search_critical_base)->DenseRange(0, 2)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace delabole
