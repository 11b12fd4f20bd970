// Measures the cost of a row of blocks: all modes of short rows are tried, long ones have a bounded search.
#include "limit_equilibrium/block_row/block_row.hpp"
#include "limit_equilibrium/block_row/single_block.hpp"

#include <benchmark/benchmark.h>

namespace delabole {
namespace {

BlockRow row_of(std::int64_t count) {
    BlockRow row{};
    row.base = {degrees(15), degrees(30)};
    row.interface = {degrees(20)};
    for (std::int64_t index = 0; index < count; ++index) {
        row.block.push_back({3 + 0.1 * static_cast<double>(index % 7), 1, UnitWeightOfBlock{25e3}, {}, {}});
    }
    return row;
}

void analyse_row(benchmark::State& state) {
    BlockRow row = row_of(state.range(0));
    for (auto _ : state) {
        benchmark::DoNotOptimize(row);
        benchmark::DoNotOptimize(analyse(row));
    }
    state.SetComplexityN(state.range(0));
}
BENCHMARK(analyse_row)->Arg(2)->Arg(3)->Arg(4)->Arg(8)->Arg(16)->Arg(17)->Arg(100)->Arg(1000)->Arg(10000);

void analyse_single_block(benchmark::State& state) {
    SingleBlock problem{{3, 1, 25e3}, {degrees(25), degrees(19), 0}, {}, {}};
    for (auto _ : state) {
        benchmark::DoNotOptimize(problem);
        benchmark::DoNotOptimize(analyse(problem));
    }
}
BENCHMARK(analyse_single_block);

}  // namespace
}  // namespace delabole
