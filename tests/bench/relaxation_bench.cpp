// Measures the cost of dynamic relaxation: a step of a pack of bricks that moves and of one at rest, a search for
// contacts, the start, and whole bisections for a critical value.
#include "dynamic_relaxation/blocks/neighbours.hpp"
#include "dynamic_relaxation/scene/scenes.hpp"
#include "dynamic_relaxation/step/simulation.hpp"
#include "parameters/fields.hpp"
#include "tests/support/brick_pack.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace delabole {
namespace {

constexpr double gravity = 9.80665;

int rows_of(std::int64_t bricks) {
    return std::max(1, static_cast<int>(std::sqrt(static_cast<double>(bricks) / 2)));
}

RelaxationScene pack(std::int64_t bricks) {
    // The pack is four times as long as it is high.
    const int rows = rows_of(bricks);
    return brick_pack_scene({rows, static_cast<int>(bricks / rows), 1e5, degrees(40), degrees(20)});
}

RelaxationSettings endless() {
    RelaxationSettings settings;
    settings.stop_at_equilibrium = false;
    settings.duration = 1e9;
    settings.collapse_displacement = settings.collapse_rotation = settings.onset_slide = settings.onset_rotation = 1e9;
    return settings;
}

void report(benchmark::State& state, const Simulation& simulation, std::uint64_t contacts_before) {
    state.counters["blocks_x_steps"] = benchmark::Counter(static_cast<double>(simulation.bodies().size() - 2),
                                                          benchmark::Counter::kIsIterationInvariantRate);
    state.counters["contacts"] = benchmark::Counter(
        static_cast<double>(simulation.state().contacts_evaluated - contacts_before), benchmark::Counter::kIsRate);
}

// The pack is dropped onto its springs, and timed once the wave from the base has passed: every contact then works.
void step_moving(benchmark::State& state) {
    RelaxationSettings settings = endless();
    settings.start = RelaxationStart::dropped;
    settings.threads = static_cast<std::size_t>(state.range(1));
    Simulation simulation(pack(state.range(0)), settings);
    const int steps_for_a_row = 14;
    for (int left = std::max(300, steps_for_a_row * rows_of(state.range(0))); left > 0; --left) {
        simulation.step();
    }
    const std::uint64_t before = simulation.state().contacts_evaluated;
    for (auto _ : state) {
        simulation.step();
    }
    report(state, simulation, before);
}
BENCHMARK(step_moving)->Args({100, 1})->Args({1000, 1})->Args({10000, 1})->Args({10000, 2})->UseRealTime();
// The number of iterations is fixed: to find one, the benchmark would repeat all the steps before the loop.
BENCHMARK(step_moving)->Args({100000, 1})->Iterations(100)->UseRealTime();

// The pack has come to rest before it is timed.
void step_at_rest(benchmark::State& state) {
    Simulation simulation(pack(state.range(0)), endless());
    std::uint64_t evaluated = 0;
    while (evaluated != simulation.state().contacts_evaluated || simulation.state().steps < 1000) {
        evaluated = simulation.state().contacts_evaluated;
        simulation.step();
    }
    for (auto _ : state) {
        simulation.step();
    }
    report(state, simulation, evaluated);
}
BENCHMARK(step_at_rest)->Arg(1000)->UseRealTime();

void search(benchmark::State& state) {
    const RelaxationScene scene = pack(state.range(0));
    const Bodies bodies = make_bodies(scene);
    const std::vector<Motion> motion(bodies.size());
    const std::vector<char> removed(bodies.size(), 0);
    for (auto _ : state) {
        benchmark::DoNotOptimize(find_contacts(scene, bodies, motion, removed, {0.01, 0.2, true}, {}));
    }
    state.counters["blocks"] =
        benchmark::Counter(static_cast<double>(bodies.size()), benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(search)->Arg(1000)->Arg(100000)->Unit(benchmark::kMillisecond);

template <class SceneAt>
double bisect(double stands, double fails, double width, const SceneAt& scene_at) {
    RelaxationSettings settings;
    settings.stop_at_onset = true;
    settings.creep = true;
    while (std::abs(fails - stands) > width) {
        const double middle = (stands + fails) / 2;
        const RelaxationResult result = relax(scene_at(middle), settings);
        (result.outcome == RelaxationOutcome::equilibrium ? stands : fails) = middle;
    }
    return (stands + fails) / 2 / degrees(1);
}

// The arguments are the number of blocks, a/b, 10 log10(k b/W) and the theoretical tilt in thousandths of a degree.
void critical_tilt(benchmark::State& state) {
    const auto count = static_cast<std::size_t>(state.range(0));
    const StandingBlock block{1, static_cast<double>(state.range(1))};
    const double stiffness =
        stiffness_of_ratio(std::pow(10, static_cast<double>(state.range(2)) / 10), block, 2700, gravity);
    const double base_friction = count == 1 ? degrees(40) : degrees(20);
    const double theory = static_cast<double>(state.range(3)) / 1000;
    double found = 0;
    for (auto _ : state) {
        found = bisect(degrees(theory - 0.5), degrees(theory + 0.5), degrees(0.005), [&](double tilt) {
            return row_scene({std::vector<StandingBlock>(count, block),
                              2700,
                              {stiffness, stiffness, degrees(20)},
                              {stiffness, stiffness, base_friction},
                              tilt});
        });
    }
    state.counters["error_mdeg"] = 1000 * (found - theory);
}
BENCHMARK(critical_tilt)
    ->Args({1, 3, 60, 18435})
    ->Args({2, 3, 75, 18629})
    ->Args({2, 5, 75, 12008})
    ->Args({2, 7, 75, 8831})
    ->Args({2, 10, 75, 6313})
    ->Unit(benchmark::kMillisecond);

// The argument is 10 log10(k b/W) of the highest column.
void limiting_friction_appendix_a(benchmark::State& state) {
    StandingBlocks columns;
    for (const double height : {1.0, 2.0, 3.0, 4.0, 3.1, 2.2, 1.3, 0.4}) {
        columns.block.push_back({1, height, 0.5});
    }
    columns.density = 2700;
    columns.tilt = degrees(21.8);
    const double stiffness = stiffness_of_ratio(std::pow(10, static_cast<double>(state.range(0)) / 10),
                                                columns.block[3], columns.density, gravity);
    double found = 0;
    for (auto _ : state) {
        found = bisect(degrees(42), degrees(40), degrees(0.005), [&](double friction) {
            columns.interface = columns.base = {stiffness, stiffness, friction};
            return column_scene(columns);
        });
    }
    state.counters["error_mdeg"] = 1000 * (found - 41.1415);
}
BENCHMARK(limiting_friction_appendix_a)->Arg(50)->Arg(55)->Arg(60)->Arg(70)->Unit(benchmark::kMillisecond);

void limiting_friction_goodman_bray(benchmark::State& state) {
    StandingBlocks columns;
    for (int number = 1; number <= 16; ++number) {
        columns.block.push_back({10, number <= 10 ? 4.0 * number : 40 - 6.0 * (number - 10), 1});
    }
    columns.density = 25e3 / gravity;
    columns.tilt = degrees(30);
    const double stiffness = stiffness_of_ratio(std::pow(10, static_cast<double>(state.range(0)) / 10),
                                                columns.block[9], columns.density, gravity);
    double found = 0;
    for (auto _ : state) {
        found = bisect(degrees(39), degrees(37), degrees(0.005), [&](double friction) {
            columns.interface = columns.base = {stiffness, stiffness, friction};
            return column_scene(columns);
        });
    }
    state.counters["error_mdeg"] = 1000 * (found - 38.1512);
}
BENCHMARK(limiting_friction_goodman_bray)->Arg(40)->Arg(50)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace delabole
