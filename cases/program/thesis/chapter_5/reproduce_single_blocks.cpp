// 5.3.1 of the thesis: one block, its swings and its tilting from the horizontal.
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "parameters/fields.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <list>

namespace delabole {

namespace {

double x_of(const HockingPrint& print) {
    return print.blocks.front().centroid.x();
}

// Prints every twenty cycles, for figures.
HockingResult fine_history(Chapter5Run run, int cycles, Engine engine) {
    run.settings.print_interval = 20;
    run.settings.cycles = cycles;
    return compute(run, engine);
}

// The re-created program's history at an inclination.
HockingResult history_at(double inclination, int cycles) {
    Chapter5Run run = chapter_5_runs("fixed_inclination").front();
    run.columns.dip = inclination;
    return fine_history(run, cycles, Engine::recreated);
}

// How far the first swing goes down, m.
double depth(const HockingResult& history) {
    return x_of(history.prints.front()) - x_of(*std::ranges::min_element(history.prints, {}, x_of));
}

// The first landing is at the first maximum of CX.
int landing(const HockingResult& history) {
    const auto& prints = history.prints;
    for (std::size_t print = 1; print + 1 < prints.size(); ++print) {
        if (x_of(prints[print]) > x_of(prints[print - 1]) && x_of(prints[print]) >= x_of(prints[print + 1])) {
            return prints[print].cycle;
        }
    }
    return prints.back().cycle;
}

Chapter5Run tilted_from_horizontal(TiltedPart part, int cycles_per_degree) {
    constexpr int beyond_the_end = 5;  // deg
    Chapter5Run run = chapter_5_runs("horizontal", part).front();
    HockingTilting& tilting = *run.settings.tilting;
    tilting.increment = degrees(1.0 / cycles_per_degree);
    run.settings.cycles = tilting.begin + cycles_per_degree * (25 + beyond_the_end);
    return run;
}

}  // namespace

Figure swings_figure(const std::string& title, const std::vector<Chapter5Run>& runs, int cycles) {
    std::list<HockingResult> computed;
    std::vector<HistoryOf> histories;
    Points printed{.legend = "printed: CX at rest", .marker = Marker::filled_diamond, .size = 1.6};
    for (const Chapter5Run& run : runs) {
        for (const Engine engine : {Engine::recreated, Engine::dropped}) {
            const bool clean = engine == Engine::dropped;
            const HockingResult& history = computed.emplace_back(fine_history(run, cycles, engine));
            if (!clean || history.outcome != HockingOutcome::fails) {
                histories.push_back(
                    {run.name + (clean ? ", clean engine" : ""), &history,
                     [start = x_of(history.prints.front())](const auto& print) { return (x_of(print) - start) * 1e6; },
                     clean});
            }
        }
        printed.points.emplace_back(run.printed_settled->x, 0);
    }
    Figure figure = history_figure(title, "CX, change since the start", "1e-6 m", histories);
    figure.series.emplace_back(printed);
    return figure;
}

// Fig 5.7: the first swings at 18.1 and 18.15 deg.
void first_swings(Chapter5Item& item) {
    Reproduction& result = item.result;
    const HockingResult a = history_at(degrees(18.1), 6000);
    const HockingResult b = history_at(degrees(18.15), 6000);
    const double period = static_cast<double>(landing(b)) / landing(a);
    const double ratio = depth(b) / depth(a);
    // The first swing is compared with that at 0.05 deg less; it is farthest at the greatest inclination at which the
    // block still stands.
    const double greatest = bisect(degrees(18.15), degrees(18.3), degrees(1e-6), [](double inclination) {
                                return history_at(inclination, 20000).outcome == HockingOutcome::stands;
                            }).first;
    const double greatest_ratio =
        depth(history_at(greatest, 20000)) / depth(history_at(greatest - degrees(0.05), 20000));
    result.json["amplitude_ratio_18.15_to_18.1"] = ratio;
    result.json["period_ratio_18.15_to_18.1"] = period;
    result.json["greatest_amplitude_ratio"] = greatest_ratio;
    const auto almost_twice = [](double value) { return statement(std::abs(value - 2) <= 0.25); };
    result.add("Fig 5.7: first landing at 18.15 deg over that at 18.1 deg", "almost twice", human_number(period, 3),
               almost_twice(period) + ": cycles " + std::to_string(landing(b)) + " and " + std::to_string(landing(a)));
    result.add("Fig 5.7: first swing at 18.15 deg over that at 18.1 deg", "almost twice", human_number(ratio, 3),
               almost_twice(ratio) + ": an inclination on the point of failure swings " +
                   human_number(greatest_ratio, 3) +
                   " times as far as one 0.05 deg below it, so that more cannot come of the last digits");
}

// How the last typed digit of the coordinates changes the runs.
void last_digits(Chapter5Item& item) {
    for (const Chapter5Run& run : item.runs) {
        std::vector<std::string>& row = item.table.rows.emplace_back(std::vector{run.name});
        for (const Engine engine : {Engine::recreated, Engine::dropped}) {
            CountRange rests;
            long fail = 0;
            for (const HockingResult& result : compute_shifted(run, engine, typed_digit, item.starts)) {
                fail += result.outcome == HockingOutcome::fails ? 1 : 0;
                if (result.outcome == HockingOutcome::stands) {
                    rests.include(settled_cycles(result).x);
                }
            }
            row.insert(row.end(),
                       {std::to_string(rests.count), std::to_string(fail), rests.count > 0 ? rests.words(" to ") : ""});
        }
    }
}

// Fig 5.5.
void tilting_from_the_horizontal(Chapter5Item& item) {
    for (const int cycles : {50, 100, 200, 500, 2000}) {
        std::vector<std::string>& row = item.table.rows.emplace_back(std::vector{std::to_string(cycles)});
        for (const TiltedPart part : {TiltedPart::gravity, TiltedPart::base}) {
            const Chapter5Run run = tilted_from_horizontal(part, cycles);
            for (const Engine engine : {Engine::recreated, Engine::dropped}) {
                const HockingResult computed = compute(run, engine);
                for (const double rotation : {1.0, 10.0}) {
                    const auto cycle = cycle_of_rotation(run, computed, degrees(rotation));
                    const double tilt = cycle ? print_at(computed, *cycle).tilt : std::nan("");
                    row.push_back(human_number(tilt / degrees(1), 4));
                }
            }
        }
        item.result.add({"tilted from the horizontal, 1 deg in " + row[0] + " cycles: turned by 1 deg", "very unstable",
                         row[5] + " deg (base turned)", row[1] + " deg (gravity turned)", "18.43 deg by equilibrium",
                         row[7] + " deg (base turned)"});
    }
    const std::string title = "Fig 5.5: base turned by 1 deg in 100 cycles";
    const Chapter5Run shown = tilted_from_horizontal(TiltedPart::base, 100);
    const HockingResult computed = compute(shown, Engine::recreated);
    const HockingResult clean = compute(shown, Engine::dropped);
    const auto rotation = [&](const HockingPrint& print) { return rotation_in(shown, print, 0) / degrees(1); };
    item.draw(history_figure(title, "rotation relative to the base", "deg",
                             {{"re-created program", &computed, rotation}, {"clean engine", &clean, rotation, true}}),
              "fig_5_5_history", "The block goes over long before its static limit.");
    item.draw(frames_figure(title, shown, computed, {0, 1000, 1500, 2000, 3300}), "fig_5_5",
              "Single block tilted from the horizontal.");
}

}  // namespace delabole
