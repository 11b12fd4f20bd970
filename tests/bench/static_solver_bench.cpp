// What a static equilibrium solve costs, of slopes cut into more and more blocks by the three sets of Old Delabole
// (cases/thesis/chapter_2/delabole_1500_blocks.toml), which stand at 50 deg of friction.
#include "dynamic_relaxation/study/relaxation_study.hpp"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

namespace delabole {
namespace {

// `fineness`: spacings over those of 1500 blocks.
RelaxationStudy slope(double fineness, double friction) {
    RelaxationSlope slope{};
    slope.geometry.sliver_share = 0.2;
    slope.geometry.snap_distance = 0.2 * fineness;
    slope.geometry.outline = {{0, 0}, {112, 0}, {112, 68.6}, {39.606, 68.6}};
    slope.rock = {{"slate", 2700}};
    const auto add = [&](const std::string& name, double dip, double spacing, double offset) {
        JointSetCut set{};
        set.dip = dip;
        set.spacing = fineness * spacing;
        set.offset = fineness * offset;
        slope.geometry.cut.push_back({name, name, set});
        SlopeJoint joint{};
        joint.name = name;
        joint.strength.friction_angle = friction;
        slope.joint.push_back(joint);
    };
    add("joint A", degrees(70), 10, 0);
    add("joint B", degrees(-85), 2.549, 0);
    add("cleavage", degrees(-5), 1.942, 0.971);
    slope.frame = SlopeFrame{FrameSides::below_and_behind, 6, 60.0, "joint A"};
    RelaxationStudy study{};
    study.model.scene = slope;
    return study;
}

void solve(benchmark::State& state) {
    const double fineness = std::sqrt(1500.0 / static_cast<double>(state.range(0)));
    const RelaxationStudy study = slope(fineness, degrees(50));
    const RelaxationScene scene = relaxation_scene(study);
    const RelaxationSettings settings = relaxation_settings(study);
    double unbalanced = 0;
    for (auto _ : state) {
        const Simulation simulation(scene, settings);
        unbalanced = simulation.state().start_balance->unbalanced_ratio;
    }
    state.counters["blocks"] = static_cast<double>(scene.block.size());
    state.counters["unbalanced"] = unbalanced;
}
BENCHMARK(solve)->Arg(100)->Arg(300)->Arg(1000)->Arg(3000)->Arg(10000)->Iterations(1)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace delabole
