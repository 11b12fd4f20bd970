// Measures the cost of statics for slopes cut into more and more blocks: the equilibrium of the three sets of Old
// Delabole (cases/thesis/chapter_2/delabole_1500_blocks.toml), which stand at 50 deg of friction, and the factor of
// safety of columns that slide and lean.
//
// The option --figure=FOLDER draws the measured times over the number of blocks, beside a growth as N^1.4.
#include "dynamic_relaxation/study/relaxation_study.hpp"
#include "plots/drawing/figure.hpp"
#include "plots/drawing/text.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace delabole {
namespace {

// Cut by the sets, each given by its dip, spacing and offset.
struct Set {
    double dip;
    double spacing;
    double offset;
};

RelaxationStudy slope(const std::vector<Set>& sets, double snap_distance, double friction) {
    RelaxationSlope slope{};
    slope.geometry.sliver_share = 0.2;
    slope.geometry.snap_distance = snap_distance;
    slope.geometry.outline = {{0, 0}, {112, 0}, {112, 68.6}, {39.606, 68.6}};
    slope.rock = {{"slate", 2700}};
    for (const Set& set : sets) {
        const std::string name = "set " + std::to_string(slope.joint.size() + 1);
        JointSetCut cut{};
        cut.dip = set.dip;
        cut.spacing = set.spacing;
        cut.offset = set.offset;
        slope.geometry.cut.push_back({name, name, cut});
        SlopeJoint joint{};
        joint.name = name;
        joint.strength.friction_angle = friction;
        slope.joint.push_back(joint);
    }
    slope.frame = SlopeFrame{FrameSides::below_and_behind, 6, 60.0, "set 1"};
    RelaxationStudy study{};
    study.model.scene = slope;
    return study;
}

// Joints A and B and cleavage cut the slope; `fineness` is the ratio of the spacings to those of 1500 blocks.
RelaxationStudy delabole(double fineness) {
    return slope({{degrees(70), 10 * fineness, 0},
                  {degrees(-85), 2.549 * fineness, 0},
                  {degrees(-5), 1.942 * fineness, 0.971 * fineness}},
                 0.2 * fineness, degrees(50));
}

// Columns that lean into the slope, cut by joints on which they slide out of it.
RelaxationStudy sliding(double fineness) {
    const double spacing = 2 * fineness;
    return slope({{degrees(35), spacing, spacing / 2}, {degrees(-80), spacing, 0}}, 0.2 * fineness, degrees(40));
}

double fineness_of(const benchmark::State& state) {
    return std::sqrt(1500.0 / static_cast<double>(state.range(0)));
}

void verdict(benchmark::State& state) {
    const RelaxationStudy study = delabole(fineness_of(state));
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
BENCHMARK(verdict)->Arg(100)->Arg(300)->Arg(1000)->Arg(3000)->Arg(10000)->Iterations(1)->Unit(benchmark::kMillisecond);

void factor_of_safety(benchmark::State& state) {
    RelaxationStudy study = sliding(fineness_of(state));
    ReductionSearch search{};
    search.lower = 0.5;
    search.upper = 3;
    search.tolerance = 0.01;
    study.critical = search;
    CriticalAnswer answer;
    for (auto _ : state) {
        answer = find_critical(study);
    }
    state.counters["blocks"] = static_cast<double>(number_of_blocks(study));
    state.counters["factor"] = answer.status == CriticalStatus::found ? answer.value() : 0;
}
BENCHMARK(factor_of_safety)->Arg(100)->Arg(300)->Arg(1000)->Iterations(1)->Unit(benchmark::kMillisecond);

// Decimal logarithms of blocks and seconds, by the name of what was timed.
using Times = std::map<std::string, Polyline>;

class Reporter : public benchmark::ConsoleReporter {
  public:
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            const auto blocks = run.counters.find("blocks");
            if (blocks != run.counters.end() && !run.error_occurred) {
                times_[run.run_name.function_name].emplace_back(std::log10(blocks->second.value),
                                                                std::log10(run.cpu_accumulated_time));
            }
        }
        ConsoleReporter::ReportRuns(runs);
    }
    const Times& times() const { return times_; }

  private:
    Times times_;
};

// Returns the slope of the least-squares line.
double slope_of(const Polyline& points) {
    Point mean(0, 0);
    for (const Point& point : points) {
        mean += point / static_cast<double>(points.size());
    }
    double xy = 0;
    double xx = 0;
    for (const Point& point : points) {
        xy += (point.x() - mean.x()) * (point.y() - mean.y());
        xx += (point.x() - mean.x()) * (point.x() - mean.x());
    }
    return xy / xx;
}

Axis decades(const std::string& title, const std::string& unit, std::vector<std::string> powers, int first) {
    Axis axis{.title = title, .unit = unit};
    axis.range = {first, first + static_cast<int>(powers.size()) - 1};
    for (std::string& power : powers) {
        axis.ticks.emplace_back(first + static_cast<int>(axis.ticks.size()), std::move(power));
    }
    return axis;
}

Figure cost_figure(const Times& times) {
    constexpr double wanted = 1.4;
    Figure figure;
    figure.title = "Processor time of statics of jointed slopes";
    figure.x = decades("blocks", "", {"100", "1000", "10 000"}, 2);
    figure.y = decades("processor time", "s", {"0.01", "0.1", "1", "10", "100", "1000"}, -2);
    std::size_t number = 0;
    for (const auto& [name, points] : times) {
        const Colour colour = std::array{Colour::vermilion, Colour::blue}.at(number++);
        const std::string title = name == "verdict" ? "static verdict" : "factor of safety";
        const std::string growth = points.size() > 1 ? ", N^" + human_number(slope_of(points), 2) : "";
        figure.series.emplace_back(Line{.points = points, .legend = title + growth, .colour = colour});
        figure.series.emplace_back(Points{.points = points, .colour = colour});
        const double span = 4 - points.front().x();
        figure.series.emplace_back(Line{.points = {points.front(), points.front() + Point(span, wanted * span)},
                                        .legend = number == 1 ? "growth wanted, N^" + human_number(wanted, 2) : "",
                                        .dash = Dash::dashed});
    }
    return figure;
}

}  // namespace
}  // namespace delabole

int main(int count, char** arguments) {
    using namespace delabole;
    constexpr std::string_view option = "--figure=";
    std::string folder;
    const auto last = std::remove_if(arguments + 1, arguments + count, [&](std::string_view argument) {
        const bool is_figure = argument.starts_with(option);
        folder = is_figure ? argument.substr(option.size()) : folder;
        return is_figure;
    });
    count = static_cast<int>(last - arguments);
    benchmark::Initialize(&count, arguments);
    if (benchmark::ReportUnrecognizedArguments(count, arguments)) {
        return 2;
    }
    Reporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    if (folder.empty()) {
        return 0;
    }
    const FigureFiles files = write_figure(cost_figure(reporter.times()), folder, "static_solver_cost");
    std::cout << files.svg.string() << files.message << '\n';
    return files.status == FigureStatus::ok ? 0 : 5;
}
