// The thesis's chapter 5: what its items share, and single blocks. Rows of two in reproduce_double_blocks.cpp, the
// blow-out in reproduce_blow_out.cpp, other rows and slopes in reproduce_block_rows.cpp.
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "cases/program/terminal/interrupt.hpp"
#include "cases/program/thesis/chapter_5/clean_chapter_5.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

std::string pair_in_words(const SettledCycles& settled) {
    return std::to_string(settled.x) + " / " + std::to_string(settled.y);
}

std::string printed_in_words(const Chapter5Run& run) {
    return run.printed_settled ? pair_in_words(*run.printed_settled) : in_words(run.printed);
}

std::string settled_in_words(const Chapter5Run& run, const HockingResult& result) {
    if (result.outcome != HockingOutcome::settled) {
        const auto turned = cycle_of_rotation(run, result, 0, degrees(1));
        return outcome_in_words(result) + (turned ? ", 1 deg at " + std::to_string(*turned) : "");
    }
    return pair_in_words(settled_cycles(result, 0));
}

HistoryOf history_of_x(const std::string& legend, const HockingResult& result, bool clean = false) {
    const double start = result.prints.front().blocks.front().centroid.x();
    return {legend, &result,
            [start](const HockingPrint& print) { return (print.blocks.front().centroid.x() - start) * 1e6; }, clean};
}

// Marks the printed cycles after which CX no longer changes.
Figure with_printed_rest(const std::vector<Chapter5Run>& runs, Figure figure) {
    Points printed;
    printed.legend = "printed: CX at rest";
    printed.marker = Marker::filled_diamond;
    printed.size = 1.6;
    for (const Chapter5Run& run : runs) {
        printed.points.emplace_back(run.printed_settled->x, 0);
    }
    figure.series.emplace_back(printed);
    return figure;
}

// Every twenty cycles, for figures.
Chapter5Run finely_printed(Chapter5Run run, int cycles) {
    run.settings.print_interval = 20;
    run.settings.cycles = cycles;
    return run;
}

HockingResult fine_history(const Chapter5Run& run, int cycles) {
    return delabole::run(finely_printed(run, cycles));
}

HockingResult fine_clean_history(const Chapter5Run& run, int cycles) {
    return clean_history(finely_printed(run, cycles));
}

// Outcomes and counts of one block over shifted starts.
struct ShiftedStarts {
    int stand = 0;
    int fail = 0;
    int least = std::numeric_limits<int>::max();
    int greatest = 0;

    void include(const HockingResult& result) {
        fail += result.outcome == HockingOutcome::failed ? 1 : 0;
        if (result.outcome == HockingOutcome::settled) {
            ++stand;
            least = std::min(least, settled_cycles(result, 0).x);
            greatest = std::max(greatest, settled_cycles(result, 0).x);
        }
    }
    std::vector<std::string> words() const {
        return {std::to_string(stand), std::to_string(fail),
                stand > 0 ? std::to_string(least) + " to " + std::to_string(greatest) : ""};
    }
};

// What the last typed digit of the coordinates does.
Table last_digit_table() {
    constexpr unsigned starts = 50;
    Table table{"Single block, fixed inclination: coordinates shifted at random by one digit (1e-6 m), " +
                    std::to_string(starts) + " starts each",
                {"inclination", "re-created: stand"_number, "fail"_number, "CX at rest"_number,
                 "clean, dropped: stand"_number, "fail"_number, "CX at rest"_number}};
    for (const Chapter5Run& run : fixed_inclination_runs()) {
        const std::vector<HockingBlock> blocks = make_blocks(run.columns);
        ShiftedStarts recreated;
        ShiftedStarts clean;
        for (unsigned seed = 1; seed <= starts; ++seed) {
            const std::vector<HockingBlock> shifted = perturbed(blocks, typed_digit, seed);
            recreated.include(run_hocking(shifted, run.settings));
            clean.include(run_clean(run, shifted, RelaxationStart::dropped).history);
        }
        std::vector<std::string> row = {run.name};
        for (const ShiftedStarts& one : {recreated, clean}) {
            for (const std::string& word : one.words()) {
                row.push_back(word);
            }
        }
        table.rows.push_back(row);
    }
    return table;
}

Reproduction fixed_inclination(const ResultFolder& folder, Report& report) {
    const std::vector<Chapter5Run> runs = fixed_inclination_runs();
    Reproduction result;
    add_outcomes("single block", runs, result);
    int largest = 0;
    for (const Chapter5Run& run : runs) {
        if (run.printed_settled) {
            const SettledCycles settled = settled_cycles(delabole::run(run), 0);
            largest = std::max(
                {largest, std::abs(settled.x - run.printed_settled->x), std::abs(settled.y - run.printed_settled->y)});
            result.json["settled_cycles"][run.name] = {settled.x, settled.y};
            result.rows.push_back({"single block, " + run.name + ": cycles until CX / CY rest",
                                   pair_in_words(*run.printed_settled), pair_in_words(settled),
                                   std::to_string(settled.x - run.printed_settled->x) + " / " +
                                       std::to_string(settled.y - run.printed_settled->y),
                                   "", settled_in_words(run, clean_history(run))});
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
    report.blocks.emplace_back(table_of(
        {"Cycles after which CX / CY no longer change", "inclination", runs, printed_in_words, settled_in_words}));
    const HockingResult a = fine_history(runs[4], 6000);
    const HockingResult b = fine_history(runs[5], 6000);
    const HockingResult clean = fine_clean_history(runs[4], 6000);
    report.blocks.emplace_back(folder.draw(
        with_printed_rest(
            {runs[4], runs[5]},
            history_figure("Fig 5.7: transient oscillation", "CX, change since the start", "1e-6 m",
                           {history_of_x("18.1 deg", a), history_of_x("18.1 deg, clean engine", clean, true),
                            history_of_x("18.15 deg", b)})),
        "fig_5_7",
        "The first swing grows without limit as the critical inclination is approached. The clean engine's "
        "own limit, dropped, is nearer to 18.1 deg, so that it swings farther there; at 18.15 deg it "
        "falls."));
    const auto depth = [](const HockingResult& history) {
        double lowest = 0;
        for (const HockingPrint& print : history.prints) {
            lowest = std::min(lowest, print.blocks[0].centroid.x() - history.prints[0].blocks[0].centroid.x());
        }
        return -lowest;
    };
    const double ratio = depth(b) / depth(a);
    // The first landing: CX has a maximum there.
    const auto landing = [](const HockingResult& history) {
        const auto x = [&](std::size_t print) { return history.prints[print].blocks[0].centroid.x(); };
        for (std::size_t print = 1; print + 1 < history.prints.size(); ++print) {
            if (x(print) > x(print - 1) && x(print) >= x(print + 1)) {
                return history.prints[print].cycle;
            }
        }
        return history.prints.back().cycle;
    };
    const double period = static_cast<double>(landing(b)) / landing(a);
    result.json["amplitude_ratio_18.15_to_18.1"] = ratio;
    result.json["period_ratio_18.15_to_18.1"] = period;
    result.rows.push_back({"Fig 5.7: first landing at 18.15 deg over that at 18.1 deg", "almost twice",
                           human_number(period, 3), "",
                           "cycles " + std::to_string(landing(b)) + " and " + std::to_string(landing(a))});
    result.rows.push_back(
        {"Fig 5.7: first swing at 18.15 deg over that at 18.1 deg", "almost twice", human_number(ratio, 3), "", ""});
    const HockingResult half = fine_history(runs[2], 3000);
    const HockingResult full = fine_history(runs[3], 3000);
    const HockingResult clean_half = fine_clean_history(runs[2], 3000);
    const HockingResult clean_full = fine_clean_history(runs[3], 3000);
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

}  // namespace

const std::vector<Scheme>& schemes() {
    static const std::vector<Scheme> all = {
        {"re-created program", "", [](const Chapter5Run& one) { return delabole::run(one); }},
        {"clean engine, dropped", "dropped", clean_history},
        {"clean engine, preloaded", "preloaded",
         [](const Chapter5Run& one) { return run_clean(one, exact_blocks(one), RelaxationStart::preloaded).history; }},
    };
    return all;
}

Table table_of(const RunTable& data) {
    Table table{data.caption, {{data.heading}, {"printed", true}}};
    for (const Scheme& scheme : schemes()) {
        table.columns.emplace_back(scheme.name, true);
    }
    for (const Chapter5Run& run : data.runs) {
        std::vector<std::string> row = {run.name, data.printed(run)};
        for (const Scheme& scheme : schemes()) {
            row.push_back(data.computed(run, scheme.compute(run)));
        }
        table.rows.push_back(row);
    }
    return table;
}

std::string outcome_in_words(const HockingResult& result) {
    switch (result.outcome) {
    case HockingOutcome::settled:
        return "stands";
    case HockingOutcome::failed:
        return "fails";
    case HockingOutcome::blown_out:
        return "blows out at cycle " + std::to_string(result.blow_out_cycle.value_or(0));
    case HockingOutcome::impossible_input:
        return "impossible input";
    case HockingOutcome::undecided:
        break;
    }
    return "undecided";
}

std::string in_words(PrintedOutcome printed) {
    switch (printed) {
    case PrintedOutcome::stands:
        return "stands";
    case PrintedOutcome::fails:
        return "fails";
    case PrintedOutcome::blows_up:
        return "blows out";
    case PrintedOutcome::not_printed:
        break;
    }
    return "";
}

bool agrees(PrintedOutcome printed, const HockingResult& result) {
    switch (printed) {
    case PrintedOutcome::stands:
        return result.outcome == HockingOutcome::settled;
    case PrintedOutcome::fails:
        return result.outcome == HockingOutcome::failed;
    case PrintedOutcome::blows_up:
        return result.outcome == HockingOutcome::blown_out;
    case PrintedOutcome::not_printed:
        break;
    }
    return false;
}

int agreeing(PrintedOutcome printed, const OutcomeCount& count) {
    switch (printed) {
    case PrintedOutcome::stands:
        return count.stand;
    case PrintedOutcome::fails:
        return count.fail;
    case PrintedOutcome::blows_up:
        return count.blow_out;
    case PrintedOutcome::not_printed:
        break;
    }
    return 0;
}

void OutcomeCount::include(HockingOutcome outcome) {
    ++runs;
    stand += outcome == HockingOutcome::settled ? 1 : 0;
    fail += outcome == HockingOutcome::failed ? 1 : 0;
    blow_out += outcome == HockingOutcome::blown_out ? 1 : 0;
    undecided += outcome == HockingOutcome::undecided ? 1 : 0;
}

OutcomeCount count_outcomes(const Chapter5Run& run, double unit, int runs) {
    const std::vector<HockingBlock> blocks = make_blocks(run.columns);
    OutcomeCount count;
    for (int seed = 1; seed <= runs; ++seed) {
        stop_if_interrupted();
        count.include(run_hocking(perturbed(blocks, unit, static_cast<unsigned>(seed)), run.settings).outcome);
    }
    return count;
}

OutcomeCount count_clean_outcomes(const Chapter5Run& run, RelaxationStart start, double unit, int runs) {
    const std::vector<HockingBlock> blocks = make_blocks(run.columns);
    OutcomeCount count;
    for (int seed = 1; seed <= runs; ++seed) {
        stop_if_interrupted();
        count.include(run_clean(run, perturbed(blocks, unit, static_cast<unsigned>(seed)), start).history.outcome);
    }
    return count;
}

std::string in_words(const OutcomeCount& count) {
    std::vector<std::string> parts;
    const auto add = [&](int number, const std::string& what) {
        if (number > 0) {
            parts.push_back(std::to_string(number) + " " + what);
        }
    };
    add(count.stand, "stand");
    add(count.fail, "fail");
    add(count.blow_out, "blow out");
    add(count.undecided, "undecided");
    return "of " + std::to_string(count.runs) + ": " + list_in_words(parts);
}

void add_outcomes(const std::string& what, const std::vector<Chapter5Run>& runs, Reproduction& result,
                  const std::function<std::string(const Chapter5Run&)>& reason) {
    constexpr int shifted_starts = 20;
    for (const Chapter5Run& run : runs) {
        const HockingResult computed = delabole::run(run);
        PrintedRow row = {what + ", " + run.name, in_words(run.printed), outcome_in_words(computed), "",
                          statement(agrees(run.printed, computed))};
        if (!agrees(run.printed, computed)) {
            const OutcomeCount shifted = count_outcomes(run, typed_digit, shifted_starts);
            row.remark += "; with the last typed digits shifted, " + in_words(shifted);
            const std::string why = reason ? reason(run) : "";
            row.remark += why.empty() ? "" : "; " + why;
            result.json["shifted"][what][run.name] = {{"runs", shifted.runs},
                                                      {"agree", agreeing(run.printed, shifted)}};
        }
        result.json["outcomes"][what][run.name] = {{"printed", in_words(run.printed)},
                                                   {"computed", outcome_in_words(computed)},
                                                   {"agrees", agrees(run.printed, computed)}};
        for (const Scheme& scheme : schemes()) {
            const HockingResult other = scheme.compute(run);
            result.json["outcomes_by_scheme"][scheme.name][what][run.name] = {{"computed", outcome_in_words(other)},
                                                                              {"agrees", agrees(run.printed, other)}};
            if (&scheme != &schemes().front()) {
                row.clean += (row.clean.empty() ? "" : "; ") + scheme.brief + " " + outcome_in_words(other);
            }
        }
        result.rows.push_back(row);
    }
}

Reproduction reproduce_fig_5_5(const ResultFolder& folder, Report& report) {
    Reproduction result;
    Table table{"Tilt at which the block has turned relative to its base, deg",
                {"cycles for a degree"_number, "gravity turned: by 1 deg"_number, "by 10 deg"_number,
                 "clean: by 1 deg"_number, "by 10 deg"_number, "base turned: by 1 deg"_number, "by 10 deg"_number,
                 "clean: by 1 deg"_number, "by 10 deg"_number}};
    for (const int cycles : {50, 100, 200, 500, 2000}) {
        std::vector<double> tilts;
        for (const TiltedPart part : {TiltedPart::gravity, TiltedPart::base}) {
            const Chapter5Run run = horizontal_start_run(part, cycles);
            for (const HockingResult& computed : {delabole::run(run), clean_history(run)}) {
                for (const double rotation : {1.0, 10.0}) {
                    const auto cycle = cycle_of_rotation(run, computed, 0, degrees(rotation));
                    tilts.push_back(cycle ? print_at(computed, *cycle).tilt / degrees(1) : std::nan(""));
                }
            }
        }
        std::vector<std::string> row = {std::to_string(cycles)};
        for (const double tilt : tilts) {
            row.push_back(human_number(tilt, 4));
        }
        table.rows.push_back(row);
        result.json["tilt_deg_at_1_deg"][std::to_string(cycles)] = {
            {"gravity", tilts[0]}, {"base", tilts[4]}, {"clean_gravity", tilts[2]}, {"clean_base", tilts[6]}};
        result.rows.push_back(
            {"tilted from the horizontal, 1 deg in " + std::to_string(cycles) + " cycles: turned by 1 deg",
             "very unstable", human_number(tilts[4], 4) + " deg (base turned)",
             human_number(tilts[0], 4) + " deg (gravity turned)", "18.43 deg by equilibrium",
             human_number(tilts[6], 4) + " deg (base turned)"});
    }
    report.blocks.emplace_back(Heading{"Fig 5.5: tilting from the horizontal"});
    report.blocks.emplace_back(Paragraph{
        "The rate and what was turned are not printed; the tilt ends at 25 deg. Where gravity turns, and where the "
        "base turns slowly, the block is late: it needs time to go over. Where the base turns by a degree in 100 "
        "cycles the block first lags behind, then swings past it and is more than a degree ahead from 8 deg of tilt "
        "on: the printed \"very unstable situation\"."});
    report.blocks.emplace_back(table);
    const Chapter5Run shown = horizontal_start_run(TiltedPart::base, 100);
    const HockingResult computed = delabole::run(shown);
    const HockingResult clean = clean_history(shown);
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

namespace {

// Rows of the cycles until rest.
void add_tilted_counts(const std::string& turned, const std::vector<Chapter5Run>& runs, Reproduction& result) {
    for (const Chapter5Run& run : runs) {
        if (!run.printed_settled) {
            continue;
        }
        const HockingTilting& tilting = *run.settings.tilting;
        const int end =
            tilting.begin + static_cast<int>(std::lround(tilting.total / tilting.increment)) * tilting.every;
        result.rows.push_back(
            {"single block, " + turned + ", " + run.name + ": cycles until CX / CY rest",
             pair_in_words(*run.printed_settled), settled_in_words(run, delabole::run(run)), "",
             tilting.part == TiltedPart::gravity
                 ? "the tilt ends at " + std::to_string(end) + ": turned gravity leaves nothing to come to rest from"
                 : "grows with the thickness of the base, which is not printed; see 'tilted_blocks'",
             settled_in_words(run, clean_history(run))});
    }
}

}  // namespace

Reproduction reproduce_single_blocks(const ResultFolder& folder, Report& report) {
    Reproduction result = fixed_inclination(folder, report);
    report.blocks.emplace_back(Heading{"Single block tilted from a stable inclination (5.3.1 B)"});
    report.blocks.emplace_back(Paragraph{
        "Gravity turned, which is the same as turning the whole model, lets the block stand up to its static limit. "
        "The base turned, an inch thick and about its centroid, gives every printed outcome, with smaller counts."});
    for (const TiltedPart part : {TiltedPart::gravity, TiltedPart::base}) {
        const std::string turned = part == TiltedPart::gravity ? "gravity turned" : "base turned";
        const std::vector<Chapter5Run> runs = single_tilting_runs(part);
        add_outcomes("single block, " + turned, runs, result, [](const Chapter5Run&) {
            return "turned gravity pushes nothing, and no input tried in 'tilted_blocks' gives all five outcomes";
        });
        add_tilted_counts(turned, runs, result);
        report.blocks.emplace_back(
            table_of({"Cycles after which CX / CY no longer change, " + turned, "tilted from, to", runs,
                      [](const Chapter5Run& run) {
                          return run.printed_cycle ? "fails, momentum after " + std::to_string(*run.printed_cycle)
                                                   : printed_in_words(run);
                      },
                      settled_in_words}));
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
            {"fig5.5", "single block tilted from the horizontal", reproduce_fig_5_5},
            {"single_blocks", "single block, fixed and tilted: tables and Figs 5.7 and 5.8", reproduce_single_blocks},
            {"double_blocks", "two blocks, fixed and tilted, Figs 5.10 and 5.11", reproduce_double_blocks},
            {"tilted_blocks", "one and two blocks tilted: which input that is not printed gives the printed outcomes",
             reproduce_tilted_blocks},
            {"fig5.12", "two blocks of a/b = 3, 5, 10: when backward sliding begins", reproduce_fig_5_12},
            {"fig5.13", "two blocks of a/b = 7: why the program blew out at cycle 677", reproduce_fig_5_13},
            {"observations", "two blocks: stiffness, time step and damping", reproduce_observations},
            {"thresholds", "stiffness, step, damping and start: at which tilt one and two blocks fail",
             reproduce_thresholds},
            {"triple_blocks", "three blocks (i)-(iv) with Fig 5.14", reproduce_triple_blocks},
            {"quadruple_blocks", "four blocks, Tables 5.1 to 5.5, Fig 5.15, and how far they are reproducible",
             reproduce_quadruple_blocks},
            {"fig5.16", "nine columns on a plane base", reproduce_fig_5_16},
            {"fig5.17", "eight columns on a stepped base, five friction angles", reproduce_fig_5_17},
            {"onset", "the stepped base well resolved: onset against stiffness", reproduce_onset},
        }};
}

}  // namespace delabole
