// Measures the cost of the bound by linear programming: 100 blocks have to take less than 50 ms. Run with
// --benchmark_repetitions=10 and read the least time.
#include "limit_equilibrium/bound/block_assembly.hpp"
#include "limit_equilibrium/bound/lp_bound.hpp"
#include "limit_equilibrium/columns/make_columns.hpp"

#include <benchmark/benchmark.h>

namespace delabole {
namespace {

void tilt_of_a_row(benchmark::State& state) {
    const std::vector<RectangularBlock> blocks(static_cast<std::size_t>(state.range(0)), {1, 3, 1e4});
    const double friction = degrees(static_cast<double>(state.range(1)));
    const Assembly row = assemble_row(blocks, {friction, friction});
    for (auto _ : state) {
        benchmark::DoNotOptimize(largest_tilt(row));
    }
    state.SetComplexityN(state.range(0));
}
BENCHMARK(tilt_of_a_row)->ArgsProduct({{2, 10, 100, 1000}, {20, 35, 60}})->Unit(benchmark::kMillisecond);

ColumnSlope<> goodman_bray() {
    ColumnScene<> scene{};
    BlockColumns<> layout{degrees(60), {}};
    for (int number = 1; number <= 16; ++number) {
        layout.block.push_back({number <= 10 ? 4.0 * number : 40.0 - 6.0 * (number - 10), 10, 1, {}});
    }
    scene.columns = layout;
    scene.rock = {25e3};
    scene.water = Dry{};
    return make_columns(scene);
}

void strength_of_goodman_bray(benchmark::State& state) {
    const Assembly assembly = assemble_columns(goodman_bray(), {degrees(40), degrees(40)}, whole_joint);
    for (auto _ : state) {
        benchmark::DoNotOptimize(least_strength_factor(assembly));
    }
}
BENCHMARK(strength_of_goodman_bray)->Unit(benchmark::kMillisecond);

void tilt_of_goodman_bray_cut_by_cross_joints(benchmark::State& state) {
    const Assembly assembly = assemble_blocks(goodman_bray(), {5, 2.5, degrees(40)}, {degrees(40), degrees(40)});
    for (auto _ : state) {
        benchmark::DoNotOptimize(largest_tilt(assembly));
    }
    state.counters["blocks"] = static_cast<double>(assembly.bodies.size());
}
BENCHMARK(tilt_of_goodman_bray_cut_by_cross_joints)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace delabole
