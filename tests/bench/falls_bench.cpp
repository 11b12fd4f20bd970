// Thousands of blocks that fall, slide and pile up at up to 50 m/s: how many go through each other, how many runs are
// stopped because their joints are too soft for the speed, and how well energy is kept. The tests run some of them
// (falls_test.cpp).
#include "tests/support/falls.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace delabole {
namespace {

// Arguments: kind, first seed, number of falls.
void fall(benchmark::State& state) {
    const auto kind = static_cast<falls::Kind>(state.range(0));
    double runs = 0;
    double through = 0;
    double stopped = 0;
    double worst = 0;
    double above_two_percent = 0;
    for (auto _ : state) {
        for (std::int64_t index = 0; index < state.range(2); ++index) {
            const falls::Fall one = falls::fall_of(kind, static_cast<unsigned>(state.range(1) + index));
            const auto landing = falls::land(one, falls::settings_of(one));
            if (!landing) {
                continue;
            }
            ++runs;
            if (!landing->ended()) {
                ++stopped;
                continue;
            }
            const double lacking = std::abs(landing->result.energy_balance.residual_share());
            through += landing->deepest > 0.06 ? 1 : 0;
            above_two_percent += lacking > 0.02 ? 1 : 0;
            worst = std::max(worst, lacking);
        }
    }
    state.counters["runs"] = runs;
    state.counters["through"] = through;
    state.counters["stopped"] = stopped;
    state.counters["energy_above_2_percent"] = above_two_percent;
    state.counters["worst_energy"] = worst;
}
BENCHMARK(fall)
    ->ArgsProduct({{0, 1, 2}, {0}, {1500}})
    ->ArgsProduct({{3}, {0}, {500}})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace delabole
