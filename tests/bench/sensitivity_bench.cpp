// Measures the cost of samples of a limit-equilibrium model on one and two threads, and of drawing them alone.
#include "fitting/sensitivity/sensitivity.hpp"
#include "plane_failure/plane_failure.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace delabole;

PlaneFailureStudy<> slope() {
    PlaneFailureStudy<> study{};
    PlaneFailure<>& problem = study.model;
    problem.slope.height = 60;
    problem.slope.face_dip = degrees(50);
    problem.failure_plane.dip = degrees(35);
    problem.tension_crack = TensionCrack<>{degrees(90), CrackOfDepth<>{14}};
    problem.rock.unit_weight = 25.5e3;
    problem.strength = Coulomb<>{98e3, degrees(35)};
    problem.water = CrackAndBaseWater<>{9810, FilledRatio<>{0.5}};
    return study;
}

SensitivityProblem problem_of(int threads) {
    SensitivityProblem problem;
    problem.model = model_interface(slope());
    problem.threads = threads;
    SensitivityStudy& study = problem.study;
    study.quantity = "factor_of_safety";
    study.parameters = {{"strength.friction_angle", {Normal{degrees(35), degrees(5)}, degrees(15), degrees(60)}, ""},
                        {"strength.cohesion", {Normal{98e3, 20e3}, 0, 250e3}, ""},
                        {"tension_crack.depth", {Normal{14, 3}, 0.1, 24.75}, ""},
                        {"water.filled_ratio", {Exponential{0.5}, 0, 1}, ""}};
    study.failure = FailureCriterion{1, FailureSide::below, {}, {}};
    return problem;
}

void million_samples(benchmark::State& state) {
    SensitivityProblem problem = problem_of(static_cast<int>(state.range(0)));
    problem.study.propagation = PropagationSettings{SamplingMethod::sobol_sequence, 1 << 20, 16};
    for (auto _ : state) {
        const SensitivityResult result = sensitivity(problem);
        state.counters["failure_percent"] = 100 * result.propagation->failure->probability->value;
        state.counters["samples"] = static_cast<double>(result.propagation->samples);
    }
}
BENCHMARK(million_samples)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime()->Unit(benchmark::kMillisecond);

void million_evaluations_for_indices(benchmark::State& state) {
    SensitivityProblem problem = problem_of(static_cast<int>(state.range(0)));
    problem.study.sobol_indices = SobolIndicesSettings{.samples = 1 << 17, .bootstrap = 1000};
    for (auto _ : state) {
        const SensitivityResult result = sensitivity(problem);
        state.counters["evaluations"] = static_cast<double>(result.sobol_indices->evaluations.total);
    }
}
BENCHMARK(million_evaluations_for_indices)
    ->ArgName("threads")
    ->Arg(1)
    ->Arg(2)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

void design_point_search(benchmark::State& state) {
    SensitivityProblem problem = problem_of(1);
    problem.study.reliability = ReliabilitySettings{};
    for (auto _ : state) {
        const SensitivityResult result = sensitivity(problem);
        state.counters["reliability_index"] = result.reliability->reliability_index;
        state.counters["evaluations"] = static_cast<double>(result.reliability->evaluations.total);
    }
}
BENCHMARK(design_point_search)->Unit(benchmark::kMillisecond);

void draw_only(benchmark::State& state) {
    const SensitivityProblem problem = problem_of(1);
    const InputSpace space = input_space(problem.study);
    const SamplePlan plan(SamplingMethod::sobol_sequence, space.size(), 1 << 16, 16, 1);
    std::array<double, 4> unit{};
    std::array<double, 4> parameters{};
    std::size_t index = 0;
    for (auto _ : state) {
        plan.point(index, unit);
        space.values_of_unit(unit, parameters);
        benchmark::DoNotOptimize(parameters);
        index = (index + 1) % plan.size();
    }
}
BENCHMARK(draw_only);

}  // namespace
