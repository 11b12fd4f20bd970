// The thesis's chapter 5: what its items share, and single blocks. The other items stand in files of their own.
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "fitting/work/words.hpp"
#include "parameters/fields.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace delabole {

namespace {

struct EngineWords {
    std::string_view name;
    std::string_view start;  // of the clean engine
};

constexpr std::array<EngineWords, 3> engine_words{
    {{"re-created program", ""}, {"clean engine, dropped", "dropped"}, {"clean engine, preloaded", "preloaded"}}};

std::string printed_in_words(const Chapter5Run& run) {
    return run.printed_settled ? in_words(*run.printed_settled) : in_words(run.printed);
}

std::string settled_or_turned(const Chapter5Run& run, const HockingResult& result) {
    return result.outcome == HockingOutcome::stands ? settled_in_words(result) : outcome_with_rotation(run, result);
}

double x_of(const HockingPrint& print) {
    return print.blocks.front().centroid.x();
}

HistoryOf history_of_x(const std::string& legend, const HockingResult& result, bool clean = false) {
    const double start = x_of(result.prints.front());
    return {legend, &result, [start](const HockingPrint& print) { return (x_of(print) - start) * 1e6; }, clean};
}

// Marks the printed cycles after which CX no longer changes.
Figure with_printed_rest(const std::vector<Chapter5Run>& runs, Figure figure) {
    Points printed{.legend = "printed: CX at rest", .marker = Marker::filled_diamond, .size = 1.6};
    for (const Chapter5Run& run : runs) {
        printed.points.emplace_back(run.printed_settled->x, 0);
    }
    figure.series.emplace_back(printed);
    return figure;
}

// Every twenty cycles, for figures.
HockingResult fine_history(Chapter5Run run, int cycles, Engine engine) {
    run.settings.print_interval = 20;
    run.settings.cycles = cycles;
    return compute(run, engine);
}

// Shows how the last typed digit of the coordinates changes the runs.
Table last_digit_table() {
    constexpr int starts = 50;
    Table table{"Single block, fixed inclination: coordinates shifted at random by one digit (1e-6 m), " +
                    std::to_string(starts) + " starts each",
                {"inclination", "re-created: stand"_number, "fail"_number, "CX at rest"_number,
                 "clean, dropped: stand"_number, "fail"_number, "CX at rest"_number}};
    for (const Chapter5Run& run : chapter_5_runs("fixed_inclination")) {
        std::vector<std::string>& row = table.rows.emplace_back(std::vector{run.name});
        for (const Engine engine : {Engine::recreated, Engine::dropped}) {
            CountRange rests;
            long fail = 0;
            for (const HockingResult& result : compute_shifted(run, engine, typed_digit, starts)) {
                fail += result.outcome == HockingOutcome::fails ? 1 : 0;
                if (result.outcome == HockingOutcome::stands) {
                    rests.include(settled_cycles(result).x);
                }
            }
            row.insert(row.end(),
                       {std::to_string(rests.count), std::to_string(fail), rests.count > 0 ? rests.words(" to ") : ""});
        }
    }
    return table;
}

// How far the first swing goes down, m.
double depth(const HockingResult& history) {
    return x_of(history.prints.front()) - x_of(*std::ranges::min_element(history.prints, {}, x_of));
}

// The first landing: CX has a maximum there.
int landing(const HockingResult& history) {
    const auto& prints = history.prints;
    for (std::size_t print = 1; print + 1 < prints.size(); ++print) {
        if (x_of(prints[print]) > x_of(prints[print - 1]) && x_of(prints[print]) >= x_of(prints[print + 1])) {
            return prints[print].cycle;
        }
    }
    return prints.back().cycle;
}

// How much farther the first swing can go than that at 0.05 deg less: near the greatest inclination at which the block
// still stands.
double greatest_amplitude_ratio(const Chapter5Run& run) {
    const auto at = [&](double dip) {
        Chapter5Run other = run;
        other.columns.dip = dip;
        return fine_history(other, 20000, Engine::recreated);
    };
    double stands = degrees(18.15);
    double fails = degrees(18.3);
    while (fails - stands > degrees(1e-6)) {
        const double middle = (stands + fails) / 2;
        (at(middle).outcome == HockingOutcome::stands ? stands : fails) = middle;
    }
    return depth(at(stands)) / depth(at(stands - degrees(0.05)));
}

Reproduction fixed_inclination(const ResultFolder& folder, Report& report) {
    const std::vector<Chapter5Run> runs = chapter_5_runs("fixed_inclination");
    Reproduction result;
    add_outcomes("single block", runs, result);
    int largest = 0;
    for (const Chapter5Run& run : runs) {
        if (run.printed_settled) {
            const SettledCycles settled = settled_cycles(compute(run, Engine::recreated));
            const int x = settled.x - run.printed_settled->x;
            const int y = settled.y - run.printed_settled->y;
            largest = std::max({largest, std::abs(x), std::abs(y)});
            result.rows.push_back({"single block, " + run.name + ": cycles until CX / CY rest",
                                   in_words(*run.printed_settled), in_words(settled), in_words(SettledCycles{x, y}), "",
                                   settled_or_turned(run, compute(run, Engine::dropped))});
        }
    }
    result.json["largest_difference_of_settled_cycles"] = largest;
    report.blocks.emplace_back(Heading{"Single block at a fixed inclination (5.3.1 A)"});
    report.blocks.emplace_back(Paragraph{
        "The thesis gives neither density nor origin of coordinates nor what \"stabilized\" means. Chosen here: blocks "
        "of one inch of plaster, the origin at the toe, centroids typed to 1e-6 m, at rest when within 1e-8 m of the "
        "end. With exact coordinates the counts change by up to 200 cycles; with blocks of one metre not even 17 deg "
        "comes to rest. Print edits are 100 cycles apart. The last table of this section shows what the last typed "
        "digit does to the counts."});
    report.blocks.emplace_back(table_of("Cycles after which CX / CY no longer change", "inclination", runs,
                                        printed_in_words, settled_or_turned));
    const HockingResult a = fine_history(runs[4], 6000, Engine::recreated);
    const HockingResult b = fine_history(runs[5], 6000, Engine::recreated);
    const HockingResult clean = fine_history(runs[4], 6000, Engine::dropped);
    report.blocks.emplace_back(folder.draw(
        with_printed_rest(
            {runs[4], runs[5]},
            history_figure("Fig 5.7: transient oscillation", "CX, change since the start", "1e-6 m",
                           {history_of_x("18.1 deg", a), history_of_x("18.1 deg, clean engine", clean, true),
                            history_of_x("18.15 deg", b)})),
        "fig_5_7",
        "The first swing grows without limit as the critical inclination is approached. The clean engine's own limit, "
        "dropped, is nearer to 18.1 deg, so that it swings farther there; at 18.15 deg it falls."));
    const double ratio = depth(b) / depth(a);
    const double period = static_cast<double>(landing(b)) / landing(a);
    result.json["amplitude_ratio_18.15_to_18.1"] = ratio;
    result.json["period_ratio_18.15_to_18.1"] = period;
    result.rows.push_back({"Fig 5.7: first landing at 18.15 deg over that at 18.1 deg", "almost twice",
                           human_number(period, 3), "",
                           // Within an eighth of twice.
                           statement(std::abs(period - 2) <= 0.25) + ": cycles " + std::to_string(landing(b)) +
                               " and " + std::to_string(landing(a))});
    const double greatest_ratio = greatest_amplitude_ratio(runs[5]);
    result.json["greatest_amplitude_ratio"] = greatest_ratio;
    result.rows.push_back({"Fig 5.7: first swing at 18.15 deg over that at 18.1 deg", "almost twice",
                           human_number(ratio, 3), "",
                           statement(std::abs(ratio - 2) <= 0.25) + ": an inclination on the point of failure swings " +
                               human_number(greatest_ratio, 3) +
                               " times as far as one 0.05 deg below it, so that more cannot come of the last digits"});
    const HockingResult half = fine_history(runs[2], 3000, Engine::recreated);
    const HockingResult full = fine_history(runs[3], 3000, Engine::recreated);
    const HockingResult clean_half = fine_history(runs[2], 3000, Engine::dropped);
    const HockingResult clean_full = fine_history(runs[3], 3000, Engine::dropped);
    report.blocks.emplace_back(folder.draw(
        with_printed_rest(
            {runs[2], runs[3]},
            history_figure(
                "Fig 5.8: effect of damping, 18 deg", "CX, change since the start", "1e-6 m",
                {history_of_x("damping 0.5", half), history_of_x("damping 0.5, clean engine", clean_half, true),
                 history_of_x("damping 1", full), history_of_x("damping 1, clean engine", clean_full, true)})),
        "fig_5_8", "Twice the damping halves the time to rest."));
    return result;
}

Chapter5Run tilted_from_horizontal(TiltedPart part, int cycles_per_degree) {
    constexpr int beyond_the_end = 5;  // deg
    Chapter5Run run = chapter_5_runs("horizontal", part).front();
    HockingTilting& tilting = *run.settings.tilting;
    tilting.increment = degrees(1.0 / cycles_per_degree);
    run.settings.cycles = tilting.begin + cycles_per_degree * (25 + beyond_the_end);
    return run;
}

// Rows of the cycles until rest, base turned.
void add_tilted_counts(const std::vector<Chapter5Run>& runs, Reproduction& result) {
    for (const Chapter5Run& run : runs) {
        if (run.printed_settled) {
            result.rows.push_back({"single block, base turned, " + run.name + ": cycles until CX / CY rest",
                                   in_words(*run.printed_settled),
                                   settled_or_turned(run, compute(run, Engine::recreated)), "",
                                   "grows with the thickness of the base, which is not printed; see 'tilted_blocks'",
                                   settled_or_turned(run, compute(run, Engine::dropped))});
        }
    }
}

}  // namespace

Table table_of(const std::string& caption, const std::string& heading, const std::vector<Chapter5Run>& runs,
               const WordsOfRun& printed, const WordsOfResult& computed) {
    Table table{caption, {{heading}, "printed"_number}};
    for (const EngineWords& words : engine_words) {
        table.columns.emplace_back(std::string(words.name), true);
    }
    for (const Chapter5Run& run : runs) {
        std::vector<std::string>& row = table.rows.emplace_back(std::vector{run.name, printed(run)});
        for (const Engine engine : engines) {
            row.push_back(computed(run, compute(run, engine)));
        }
    }
    return table;
}

std::string in_words(HockingOutcome outcome) {
    return human_name(word_of(outcome));
}

std::string printed_outcome(const Chapter5Run& run) {
    return in_words(run.printed);
}

std::string outcome_in_words(const HockingResult& result) {
    return in_words(result.outcome) + (result.outcome == HockingOutcome::blows_out
                                           ? " at cycle " + std::to_string(result.blow_out_cycle.value_or(0))
                                           : "");
}

std::string outcome_with_rotation(const Chapter5Run& run, const HockingResult& result) {
    const auto turned = cycle_of_rotation(run, result, degrees(1));
    return outcome_in_words(result) + (turned ? ", 1 deg at " + std::to_string(*turned) : "");
}

std::string in_words(const std::vector<HockingResult>& results) {
    std::vector<std::string> parts;
    for (const auto& [outcome, word] :
         {std::pair{HockingOutcome::stands, "stand"}, std::pair{HockingOutcome::fails, "fail"},
          std::pair{HockingOutcome::blows_out, "blow out"}, std::pair{HockingOutcome::undecided, "undecided"}}) {
        if (const auto count = std::ranges::count(results, outcome, &HockingResult::outcome); count > 0) {
            parts.push_back(std::to_string(count) + " " + word);
        }
    }
    return "of " + std::to_string(results.size()) + ": " + list_in_words(parts);
}

std::string in_words(const SettledCycles& settled) {
    return std::to_string(settled.x) + " / " + std::to_string(settled.y);
}

std::string settled_in_words(const HockingResult& result) {
    return result.outcome == HockingOutcome::stands ? in_words(settled_cycles(result)) : outcome_in_words(result);
}

std::string in_words(TiltedPart part) {
    return std::string(word_of(part)) + " turned";
}

void CountRange::include(int value) {
    least = count == 0 ? value : std::min(least, value);
    greatest = count == 0 ? value : std::max(greatest, value);
    ++count;
}

std::string CountRange::words(const std::string& to) const {
    return std::to_string(least) + to + std::to_string(greatest);
}

void add_outcomes(const std::string& what, const std::vector<Chapter5Run>& runs, Reproduction& result,
                  const WordsOfRun& reason) {
    constexpr int shifted_starts = 20;
    for (const Chapter5Run& run : runs) {
        PrintedRow row{what + ", " + run.name, in_words(run.printed), "", "", ""};
        for (const Engine engine : engines) {
            const HockingResult computed = compute(run, engine);
            const std::string words = outcome_in_words(computed);
            const bool agrees = computed.outcome == run.printed;
            const auto& [name, start] = engine_words[static_cast<std::size_t>(engine)];
            if (engine != Engine::recreated) {
                row.clean += (row.clean.empty() ? "" : "; ") + std::string(start) + " " + words;
            } else {
                row.computed = words;
                row.remark = statement(agrees);
                if (!agrees) {
                    const std::vector<HockingResult> shifted =
                        compute_shifted(run, engine, typed_digit, shifted_starts);
                    row.remark += "; with the last typed digits shifted, " + in_words(shifted);
                    row.remark += reason ? "; " + reason(run) : "";
                    result.json["shifted"][what][run.name] = {
                        {"runs", shifted_starts},
                        {"agree", std::ranges::count(shifted, run.printed, &HockingResult::outcome)}};
                }
                result.json["outcomes"][what][run.name] = {
                    {"printed", in_words(run.printed)}, {"computed", words}, {"agrees", agrees}};
            }
            result.json["outcomes_by_scheme"][std::string(name)][what][run.name] = {{"computed", words},
                                                                                    {"agrees", agrees}};
        }
        result.rows.push_back(row);
    }
}

double rotation_at_end(const HockingResult& result, std::size_t column) {
    return result.prints.back().blocks[column].angle / degrees(1);
}

void add_other_part(const std::string& what, const std::vector<Chapter5Run>& runs, Reproduction& result) {
    const auto agree = std::ranges::count_if(
        runs, [](const Chapter5Run& run) { return compute(run, Engine::recreated).outcome == run.printed; });
    result.json["gravity_turned"][what] = {{"agree", agree}, {"of", runs.size()}};
    result.rows.push_back(
        {what + ", gravity turned instead: outcomes as printed", std::to_string(runs.size()), std::to_string(agree), "",
         statement(agree == std::ssize(runs)) +
             ": so the base was turned: turned gravity pushes nothing, and no input that 'tilted_blocks' changes "
             "gives all outcomes with it"});
}

Reproduction reproduce_fig_5_5(const ResultFolder& folder, Report& report) {
    Reproduction result;
    Table table{"Tilt at which the block has turned relative to its base, deg",
                {"cycles for a degree"_number, "gravity turned: by 1 deg"_number, "by 10 deg"_number,
                 "clean: by 1 deg"_number, "by 10 deg"_number, "base turned: by 1 deg"_number, "by 10 deg"_number,
                 "clean: by 1 deg"_number, "by 10 deg"_number}};
    for (const int cycles : {50, 100, 200, 500, 2000}) {
        std::vector<double> tilts;
        std::vector<std::string>& row = table.rows.emplace_back(std::vector{std::to_string(cycles)});
        for (const TiltedPart part : {TiltedPart::gravity, TiltedPart::base}) {
            const Chapter5Run run = tilted_from_horizontal(part, cycles);
            for (const Engine engine : {Engine::recreated, Engine::dropped}) {
                const HockingResult computed = compute(run, engine);
                for (const double rotation : {1.0, 10.0}) {
                    const auto cycle = cycle_of_rotation(run, computed, degrees(rotation));
                    tilts.push_back(cycle ? print_at(computed, *cycle).tilt / degrees(1) : std::nan(""));
                    row.push_back(human_number(tilts.back(), 4));
                }
            }
        }
        result.rows.push_back({"tilted from the horizontal, 1 deg in " + row[0] + " cycles: turned by 1 deg",
                               "very unstable", row[5] + " deg (base turned)", row[1] + " deg (gravity turned)",
                               "18.43 deg by equilibrium", row[7] + " deg (base turned)"});
    }
    report.blocks.emplace_back(Heading{"Fig 5.5: tilting from the horizontal"});
    report.blocks.emplace_back(Paragraph{
        "The rate and what was turned are not printed; the tilt ends at 25 deg. Where gravity turns, and where the "
        "base turns slowly, the block is late: it needs time to go over. Where the base turns by a degree in 100 "
        "cycles the block first lags behind, then swings past it and is more than a degree ahead from 8 deg of tilt "
        "on: the printed \"very unstable situation\"."});
    report.blocks.emplace_back(table);
    const Chapter5Run shown = tilted_from_horizontal(TiltedPart::base, 100);
    const HockingResult computed = compute(shown, Engine::recreated);
    const HockingResult clean = compute(shown, Engine::dropped);
    const auto rotation = [&](const HockingPrint& print) { return rotation_in(shown, print, 0) / degrees(1); };
    report.blocks.emplace_back(folder.draw(
        history_figure("Fig 5.5: base turned by 1 deg in 100 cycles", "rotation relative to the base", "deg",
                       {{"re-created program", &computed, rotation}, {"clean engine", &clean, rotation, true}}),
        "fig_5_5_history", "The block goes over long before its static limit."));
    report.blocks.emplace_back(folder.draw(
        frames_figure("Fig 5.5: base turned by 1 deg in 100 cycles", shown, computed, {0, 1000, 1500, 2000, 3300}),
        "fig_5_5", "Single block tilted from the horizontal."));
    return result;
}

Reproduction reproduce_single_blocks(const ResultFolder& folder, Report& report) {
    Reproduction result = fixed_inclination(folder, report);
    report.blocks.emplace_back(Heading{"Single block tilted from a stable inclination (5.3.1 B)"});
    report.blocks.emplace_back(Paragraph{
        "Gravity turned, which is the same as turning the whole model, lets the block stand up to its static limit. "
        "The base turned, 1.1 inches thick and about its centroid, gives every printed outcome, with smaller counts: "
        "what was turned is not printed, so the base is taken."});
    for (const TiltedPart part : {TiltedPart::base, TiltedPart::gravity}) {
        const std::vector<Chapter5Run> runs = chapter_5_runs("single_tilting", part);
        if (part == TiltedPart::base) {
            add_outcomes("single block, " + in_words(part), runs, result);
            add_tilted_counts(runs, result);
        } else {
            add_other_part("single block", runs, result);
        }
        report.blocks.emplace_back(table_of(
            "Cycles after which CX / CY no longer change, " + in_words(part), "tilted from, to", runs,
            [](const Chapter5Run& run) {
                return run.printed_cycle ? "fails, momentum after " + std::to_string(*run.printed_cycle)
                                         : printed_in_words(run);
            },
            settled_or_turned));
    }
    report.blocks.emplace_back(last_digit_table());
    return result;
}

ReproductionChapter chapter_5() {
    return {
        "chapter5",
        "dynamic relaxation, chapter 5",
        "Thesis, chapter 5: printed and computed",
        {
            {"fig5.4", "Fig 5.4", "the laws of contact: normal, elastic-plastic and brittle shear", reproduce_fig_5_4},
            {"fig5.5", "Fig 5.5", "single block tilted from the horizontal", reproduce_fig_5_5},
            {"single_blocks", "5.3.1, Figs 5.7, 5.8", "single block, fixed and tilted: tables and Figs 5.7 and 5.8",
             reproduce_single_blocks},
            {"double_blocks", "5.3.2, Figs 5.10, 5.11", "two blocks, fixed and tilted, Figs 5.10 and 5.11",
             reproduce_double_blocks},
            {"tilted_blocks", "5.3.1, 5.3.2",
             "one and two blocks tilted: which input that is not printed gives the printed outcomes",
             reproduce_tilted_blocks},
            {"fig5.12", "Fig 5.12", "two blocks of a/b = 3, 5, 10: when backward sliding begins", reproduce_fig_5_12},
            {"fig5.13", "Fig 5.13", "two blocks of a/b = 7: why the program blew out at cycle 677", reproduce_fig_5_13},
            {"observations", "5.3.2", "two blocks: stiffness, time step and damping", reproduce_observations},
            {"thresholds", "5.3.1, 5.3.2", "stiffness, step, damping and start: at which tilt one and two blocks fail",
             reproduce_thresholds},
            {"triple_blocks", "5.3.3.1, Fig 5.14", "three blocks (i)-(iv) with Fig 5.14", reproduce_triple_blocks},
            {"quadruple_blocks", "Tables 5.1 to 5.5",
             "four blocks, Tables 5.1 to 5.5, Fig 5.15, and how far they are reproducible", reproduce_quadruple_blocks},
            {"fig5.16", "Fig 5.16", "nine columns on a plane base", reproduce_fig_5_16},
            {"fig5.17", "Fig 5.17", "eight columns on a stepped base, five friction angles", reproduce_fig_5_17},
            {"onset", "5.3.4.2", "the stepped base well resolved: onset against stiffness", reproduce_onset},
        }};
}

}  // namespace delabole
