// Measures the cost of cutting a section into blocks, and of making a scene of it.
#include "dynamic_relaxation/scene/slope_scene.hpp"
#include "tests/support/jointed_slopes.hpp"

#include <benchmark/benchmark.h>

#include <cmath>

namespace delabole {
namespace {

// Two sets with scatter cut a square into about so many blocks.
SlopeGeometry crossed_square(std::int64_t blocks) {
    JointSetCut steep = testing::joint_set(degrees(70), 1);
    JointSetCut flat = testing::joint_set(degrees(-20), 1);
    steep.scatter = flat.scatter = 0.3;
    return testing::section(testing::square(std::sqrt(static_cast<double>(blocks))),
                            {testing::cut("steep", steep), testing::cut("flat", flat)});
}

void cut_section(benchmark::State& state) {
    const SlopeGeometry geometry = crossed_square(state.range(0));
    std::size_t blocks = 0;
    for (auto unused : state) {
        static_cast<void>(unused);
        blocks = testing::cut_in_one_rock(geometry).block.size();
    }
    state.counters["blocks"] = static_cast<double>(blocks);
}
BENCHMARK(cut_section)->RangeMultiplier(10)->Range(100, 100000)->Unit(benchmark::kMillisecond);

void make_scene(benchmark::State& state) {
    RelaxationSlope slope{};
    slope.geometry = crossed_square(state.range(0));
    slope.rock = {{"slate", 2700}};
    slope.joint = {{"joint", {}, {}}};
    slope.joint[0].strength.friction_angle = degrees(30);
    slope.frame = SlopeFrame{FrameSides::all_around, 1, {}, "joint"};
    const double level = std::sqrt(static_cast<double>(state.range(0))) / 2;
    slope.water = SlopeWater{9810, {{0, level}, {1, level}}};
    for (auto unused : state) {
        static_cast<void>(unused);
        benchmark::DoNotOptimize(slope_scene(slope).block.size());
    }
}
BENCHMARK(make_scene)->RangeMultiplier(10)->Range(100, 100000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace delabole
