// 5.3.3 and 5.3.4 of the thesis: three and four blocks, and columns of unequal height.
#include "cases/program/thesis/chapter_5/chapter_5.hpp"
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace delabole {

namespace {

std::string in_words(const SlidingTotals& totals) {
    const std::string text = "F " + std::to_string(totals.forward) + ", B " + std::to_string(totals.backward) + ", - " +
                             std::to_string(totals.none);
    return totals.unclear > 0 ? text + ", ? " + std::to_string(totals.unclear) : text;
}

constexpr int shifted_starts = 40;
constexpr std::array counted{&SlidingTotals::forward, &SlidingTotals::backward, &SlidingTotals::none};

// The range of each count over the starts.
using TotalsRange = std::array<CountRange, counted.size()>;

std::string in_words(const TotalsRange& range) {
    return range[0].words("-") + ", " + range[1].words("-") + ", " + range[2].words("-");
}

std::vector<SlidingTotals> totals_of(const Chapter5Run& run, const HockingResult& result) {
    return count_sliding(result, run.columns.heights.size(), run.first_print);
}

// The ranges are by column; runs that blow out are left out.
std::vector<TotalsRange> spread_of_totals(const Chapter5Run& run, Engine engine, double unit) {
    std::vector<TotalsRange> ranges(run.columns.heights.size());
    for (const HockingResult& result : compute_shifted(run, engine, unit, shifted_starts)) {
        if (result.outcome != HockingOutcome::blows_out) {
            const std::vector<SlidingTotals> totals = totals_of(run, result);
            for (std::size_t column = 0; column < totals.size(); ++column) {
                for (std::size_t kind = 0; kind < counted.size(); ++kind) {
                    ranges[column][kind].include(totals[column].*counted[kind]);
                }
            }
        }
    }
    return ranges;
}

// First print at which a history from a start shifted by a unit names another sense of sliding for any column; 0 where
// it never does.
int first_difference(const Chapter5Run& run, Engine engine, const std::vector<HockingBlock>& start, double unit) {
    const HockingResult one = compute(run, engine, start);
    const HockingResult other = compute(run, engine, perturbed(start, unit, 1));
    for (std::size_t index = 0; index < std::min(one.prints.size(), other.prints.size()); ++index) {
        for (std::size_t column = 0; column < run.columns.heights.size(); ++column) {
            if (one.prints[index].blocks[column].sliding != other.prints[index].blocks[column].sliding) {
                return one.prints[index].cycle;
            }
        }
    }
    return 0;
}

// Whether forward or backward sliding prevails: what the thesis's senses come down to.
bool forward_prevails(const SlidingTotals& totals) {
    return totals.forward > totals.backward;
}

std::vector<std::string_view> behaviour_at_end(const Chapter5Run& run, const HockingResult& result) {
    std::vector<std::string_view> does;
    for (std::size_t column = 0; column < run.columns.heights.size(); ++column) {
        does.push_back(word_of(behaviour(run, result, result.prints.back(), column)));
    }
    return does;
}

std::string behaviour_in_words(const Chapter5Run& run, const HockingResult& result) {
    return columns_in_words(behaviour_at_end(run, result), "-");
}

bool behaves_as_printed(const Chapter5Run& run, const HockingResult& result) {
    return std::ranges::equal(run.printed_behaviour, behaviour_at_end(run, result));
}

// Less is the give of the springs.
constexpr double open_joint = 1e-3;  // of a column's width

std::string opening_in_words(const Chapter5Run& run, const HockingPrint& print) {
    const JointOpening widest = widest_opening(run, print);
    if (widest.width < open_joint * run.columns.width) {
        return "none";
    }
    return "columns " + std::to_string(widest.column + 1) + " and " + std::to_string(widest.column + 2) + ", " +
           human_number(widest.width / inch, 2) + " in";
}

// First print with an open joint; the last one where none opens.
const HockingPrint& first_opening(const Chapter5Run& run, const HockingResult& result) {
    const auto found = std::ranges::find_if(result.prints, [&](const HockingPrint& print) {
        return widest_opening(run, print).width >= open_joint * run.columns.width;
    });
    return found == result.prints.end() ? result.prints.back() : *found;
}

// The tension crack: the first joint to open, and the widest at the end.
void add_crack(const Chapter5Run& run, const HockingResult& recreated, const HockingResult& clean,
               Reproduction& result) {
    constexpr std::size_t fifth = 4;
    const bool fails = run.printed == HockingOutcome::fails;
    const auto shown = [&](const HockingResult& history) {
        return "first " + opening_in_words(run, first_opening(run, history)) + ", at the end " +
               opening_in_words(run, history.prints.back());
    };
    const auto place = [&](const HockingPrint& print) { return widest_opening(run, print).column; };
    const auto as_printed = [&](const HockingResult& history) {
        const bool at_end = place(history.prints.back()) == fifth;
        return (!fails || at_end) && place(first_opening(run, history)) == fifth;
    };
    result.rows.push_back({"stepped base, " + run.name + ": widest joint, between",
                           fails ? "columns 5 and 6" : "columns 5 and 6, slight", shown(recreated), "",
                           statement(as_printed(recreated)), shown(clean)});
    result.json["crack"][run.name] = {{"as_printed", as_printed(recreated)},
                                      {"clean_as_printed", as_printed(clean)},
                                      {"width_in", widest_opening(run, recreated.prints.back()).width / inch},
                                      {"clean_width_in", widest_opening(run, clean.prints.back()).width / inch}};
}

double rotation_at_end(const HockingResult& result, std::size_t column) {
    return result.prints.back().blocks[column].angle / degrees(1);
}

}  // namespace

Reproduction reproduce_triple_blocks(const ResultFolder& folder, Report& report) {
    Reproduction result;
    report.blocks.emplace_back(Heading{"Three blocks (5.3.3.1)"});
    const std::string range = "clean, range of " + std::to_string(shifted_starts) + " starts (F, B, -)";
    Table table{
        "Sliding on the base in print edits of 100 cycles: F forward, B backward, - none",
        {"run", "block"_number, "printed", "re-created program", "first F, B", "clean engine", "first F, B", range}};
    const std::vector<Chapter5Run> runs = chapter_5_runs("triple");
    for (const Chapter5Run& run : runs) {
        const std::array results = {compute(run, Engine::recreated), compute(run, Engine::dropped)};
        const std::vector<TotalsRange> ranges = spread_of_totals(run, Engine::dropped, typed_digit);
        for (std::size_t column = 0; column < ranges.size(); ++column) {
            std::vector<std::string> row = {run.name, std::to_string(column + 1), run.printed_behaviour[column]};
            for (const HockingResult& computed : results) {
                const auto first = [&](BaseSliding sense) {
                    const auto cycle = first_sliding(computed, column, sense);
                    return cycle ? std::to_string(*cycle) : std::string("never");
                };
                row.push_back(in_words(totals_of(run, computed)[column]));
                row.push_back(first(BaseSliding::forward) + ", " + first(BaseSliding::backward));
            }
            row.push_back(in_words(ranges[column]));
            table.rows.push_back(row);
        }
        std::vector<std::string> in_each;
        bool senses = true;
        for (std::size_t which = 0; which < results.size(); ++which) {
            const std::vector<SlidingTotals> totals = totals_of(run, results[which]);
            const bool first = forward_prevails(totals.front());
            const bool last = forward_prevails(totals.back());
            senses = senses && first && !last;
            in_each.push_back(std::string(first ? "forward" : "backward") + " / " + (last ? "forward" : "backward"));
            for (const SlidingTotals& one : totals) {
                result.json[which == 0 ? "re-created" : "clean"][run.name].push_back(
                    {{"forward", one.forward}, {"backward", one.backward}, {"none", one.none}});
            }
        }
        result.rows.push_back({"three blocks " + run.name + ": block 1 / block 3 slides mostly", "forward / backward",
                               in_each[0], "", statement(senses), in_each[1]});
    }
    report.blocks.emplace_back(table);
    report.blocks.emplace_back(
        Paragraph{"The clean engine agrees on what blocks mostly do, and its blocks do not change their mind: block 1 "
                  "slides forward, block 3 backward. It does so with the time step divided or not, so that the "
                  "alternating senses of the thesis's histories are no matter of the step. What is left is the law of "
                  "contact: the re-created program stores the dashpot's force in its shear springs, and what is stored "
                  "pushes back. In (iv) block 2 neither slides backward mostly, as printed, nor forward."});
    const std::vector<int> cycles = {500, 1000, 1500, 2000};
    report.blocks.emplace_back(
        folder.draw(frames_figure("Fig 5.14: three blocks (ii)", runs[1], compute(runs[1], Engine::recreated), cycles),
                    "fig_5_14", "Toppling of three blocks, a/b = 3, 35 deg. Re-created program."));
    report.blocks.emplace_back(
        folder.draw(frames_figure("Fig 5.14, clean engine", runs[1], compute(runs[1], Engine::dropped), cycles),
                    "fig_5_14_clean", "The same by the clean engine."));
    report.blocks.emplace_back(printed_table("Senses", result.rows));
    return result;
}

Reproduction reproduce_quadruple_blocks(const ResultFolder& folder, Report& report) {
    constexpr double last_bit = 1e-15;  // m
    Reproduction result;
    report.blocks.emplace_back(Heading{"Four blocks, Tables 5.1 to 5.5 (5.3.3.2)"});
    report.blocks.emplace_back(Paragraph{
        "Totals of the print edits of 100 cycles in which a block slides forward (F), backward (B) or not (-). The "
        "histories are chaotic: a shift of the free blocks by 1e-15 m, the last bit, changes them as much as one by "
        "the last typed digit does. So cycles cannot be compared, only senses and totals, within the ranges below. The "
        "clean engine's histories do not part by the last bit; its blocks slide one way each, and its ranges are "
        "narrow, so that most printed totals, mixed as they are, lie outside."});
    Table table{"Totals, and their range over " + std::to_string(shifted_starts) + " starts (F, B, -)",
                {"table", "block"_number, "printed", "re-created program", "range, 1e-15 m", "range, 1e-6 m",
                 "clean engine", "range, 1e-6 m"}};
    int within = 0;
    int count = 0;
    int senses = 0;
    int sensed = 0;
    int clean_within = 0;
    int clean_senses = 0;
    const std::vector<Chapter5Run> runs = chapter_5_runs("quadruple");
    for (const Chapter5Run& run : runs) {
        const std::vector<TotalsRange> bit = spread_of_totals(run, Engine::recreated, last_bit);
        const std::vector<TotalsRange> digit = spread_of_totals(run, Engine::recreated, typed_digit);
        const std::vector<TotalsRange> of_clean = spread_of_totals(run, Engine::dropped, typed_digit);
        const HockingResult reference = compute(run, Engine::recreated);
        const HockingResult clean_reference = compute(run, Engine::dropped);
        const std::vector<SlidingTotals> computed = totals_of(run, reference);
        const std::vector<SlidingTotals> clean_totals = totals_of(run, clean_reference);
        for (std::size_t column = 0; column < computed.size(); ++column) {
            const SlidingTotals& printed = run.printed_totals[column];
            table.rows.push_back({run.name, std::to_string(column + 1), in_words(printed), in_words(computed[column]),
                                  in_words(bit[column]), in_words(digit[column]), in_words(clean_totals[column]),
                                  in_words(of_clean[column])});
            for (std::size_t kind = 0; kind < counted.size(); ++kind) {
                const int value = printed.*counted[kind];
                ++count;
                within += bit[column][kind].holds(value) || digit[column][kind].holds(value) ? 1 : 0;
                clean_within += of_clean[column][kind].holds(value) ? 1 : 0;
            }
            if (printed.forward != printed.backward) {
                ++sensed;
                senses += forward_prevails(computed[column]) == forward_prevails(printed) ? 1 : 0;
                clean_senses += forward_prevails(clean_totals[column]) == forward_prevails(printed) ? 1 : 0;
            }
            const auto as_json = [](const SlidingTotals& totals) {
                return Json{totals.forward, totals.backward, totals.none};
            };
            result.json[run.name].push_back({{"printed", as_json(printed)},
                                             {"computed", as_json(computed[column])},
                                             {"clean", as_json(clean_totals[column])}});
        }
        const int parted = first_difference(run, Engine::recreated, make_blocks(run.columns), last_bit);
        result.json["first_different_print"][run.name] = parted;
        const int clean_parted = first_difference(run, Engine::dropped, exact_blocks(run), last_bit);
        result.json["first_different_print_of_clean"][run.name] = clean_parted;
        result.rows.push_back({run.name + ": first print that a shift of 1e-15 m changes", "",
                               "cycle " + std::to_string(parted), "", "",
                               clean_parted > 0 ? "cycle " + std::to_string(clean_parted) : std::string("none")});
        const auto rotations = [&](const HockingResult& history) {
            return human_number(rotation_at_end(history, 0), 3) + " / " +
                   human_number(rotation_at_end(history, computed.size() - 1), 3) + " deg";
        };
        result.rows.push_back({run.name + ": rotation of blocks 1 / 4 at the end", "", rotations(reference), "", "",
                               rotations(clean_reference)});
    }
    result.json["printed_totals_within_range"] = within;
    result.json["printed_totals"] = count;
    result.json["senses_as_printed"] = senses;
    result.json["senses"] = sensed;
    result.json["clean_printed_totals_within_range"] = clean_within;
    result.json["clean_senses_as_printed"] = clean_senses;
    result.rows.push_back({"printed totals within the range of the starts", std::to_string(count),
                           std::to_string(within), "", "", std::to_string(clean_within)});
    result.rows.push_back({"blocks whose prevailing sense is the printed one", std::to_string(sensed),
                           std::to_string(senses), "", "", std::to_string(clean_senses)});
    report.blocks.emplace_back(table);
    report.blocks.emplace_back(printed_table("How far the histories are reproducible", result.rows));
    const std::vector<int> cycles = {1000, 2000, 3000};
    report.blocks.emplace_back(
        folder.draw(frames_figure("Fig 5.15: four blocks (ii)", runs[1], compute(runs[1], Engine::recreated), cycles),
                    "fig_5_15", "Failure of four blocks, a/b = 5, 18.5 deg. Re-created program."));
    report.blocks.emplace_back(
        folder.draw(frames_figure("Fig 5.15, clean engine", runs[1], compute(runs[1], Engine::dropped), cycles),
                    "fig_5_15_clean", "The same by the clean engine."));
    return result;
}

Reproduction reproduce_fig_5_16(const ResultFolder& folder, Report& report) {
    Reproduction result;
    const Chapter5Run run = chapter_5_runs("plane_base").front();
    const HockingResult computed = compute(run, Engine::recreated);
    const HockingResult clean_computed = compute(run, Engine::dropped);
    report.blocks.emplace_back(Heading{"Fig 5.16: nine columns on a plane base"});
    report.blocks.emplace_back(
        Paragraph{"Heights are read off the drawing, friction (30 deg) is chosen. The tilting frame's crack at 16 deg "
                  "lay between columns 6 and 7; at 25 deg column 7 topples too."});
    result.rows.push_back({"25 deg, cycle 2000", "1 slides, 2-7 topple, 8-9 stay", behaviour_in_words(run, computed),
                           "", statement(behaves_as_printed(run, computed)), behaviour_in_words(run, clean_computed)});
    Chapter5Run gentle = run;
    gentle.columns.dip = degrees(16);
    gentle.settings.bases = gentle.settings.joints = {degrees(26), degrees(26)};
    std::vector<std::string> cracks;
    bool all_crack = true;
    for (const Engine engine : {Engine::recreated, Engine::dropped}) {
        const HockingResult frame = compute(gentle, engine);
        const double sixth = rotation_at_end(frame, 5);
        const double seventh = rotation_at_end(frame, 6);
        const bool crack = sixth > 0.1 && std::abs(seventh) < 0.1;
        all_crack = all_crack && crack;
        cracks.push_back("6 turned " + human_number(sixth, 2) + " deg, 7 " + human_number(seventh, 2));
        result.json[engine == Engine::recreated ? "crack_at_16_deg" : "clean_crack_at_16_deg"] = crack;
    }
    result.rows.push_back({"16 deg, friction 26 deg: tension crack (tilting frame)", "between 6 and 7", cracks[0], "",
                           statement(all_crack), cracks[1]});
    result.json["as_printed"] = behaves_as_printed(run, computed);
    result.json["clean_as_printed"] = behaves_as_printed(run, clean_computed);
    result.json["behaviour"] = behaviour_in_words(run, computed);
    report.blocks.emplace_back(printed_table("Behaviour", result.rows));
    for (const int cycle : {0, 1000, 2000}) {
        report.blocks.emplace_back(folder.draw(frames_figure("Fig 5.16: nine columns, 25 deg", run, computed, {cycle}),
                                               "fig_5_16_" + std::to_string(cycle), "Re-created program."));
    }
    report.blocks.emplace_back(
        folder.draw(frames_figure("Fig 5.16, clean engine: nine columns, 25 deg", run, clean_computed, {2000}),
                    "fig_5_16_clean", "The same by the clean engine."));
    return result;
}

Reproduction reproduce_fig_5_17(const ResultFolder& folder, Report& report) {
    Reproduction result;
    const std::vector<Chapter5Run> runs = chapter_5_runs("stepped_base");
    report.blocks.emplace_back(Heading{"Fig 5.17: eight columns on a stepped base"});
    report.blocks.emplace_back(
        Paragraph{"Columns that fail turn by some degrees and wedge again; so failure is here a rotation above 1 "
                  "degree. Equilibrium asks for 41.14 deg of friction. That 42 deg fails nevertheless, as printed, "
                  "comes of the start: dropped on springs as soft, it fails in the clean engine too; preloaded, it "
                  "stands. Columns that have failed wedge again there as well."});
    add_outcomes("stepped base, friction", runs, result);
    report.blocks.emplace_back(table_of(
        "Friction angle", "friction", runs, printed_outcome, [](const Chapter5Run& run, const HockingResult& computed) {
            return outcome_in_words(computed) + ": " + behaviour_in_words(run, computed);
        }));
    for (const Chapter5Run& run : runs) {
        const HockingResult computed = compute(run, Engine::recreated);
        const HockingResult other = compute(run, Engine::dropped);
        for (std::size_t column = 0; column < run.columns.heights.size(); ++column) {
            result.json["rotation_deg"][run.name].push_back(rotation_at_end(computed, column));
        }
        add_crack(run, computed, other, result);
        if (run.printed == HockingOutcome::fails) {
            result.rows.push_back({"stepped base, " + run.name + ": behaviour", "1 slides, 2-5 topple, 6-8 stay",
                                   behaviour_in_words(run, computed), "", statement(behaves_as_printed(run, computed)),
                                   behaviour_in_words(run, other)});
            result.json["behaves_as_printed"][run.name] = behaves_as_printed(run, computed);
            result.json["clean_behaves_as_printed"][run.name] = behaves_as_printed(run, other);
        }
    }
    const Chapter5Run& drawn = runs[1];
    const HockingResult computed = compute(drawn, Engine::recreated);
    const auto widest_joint = [&](const HockingResult& history, int cycle) {
        return "The widest open joint: " + opening_in_words(drawn, print_at(history, cycle)) + ".";
    };
    for (const int cycle : {0, 1000, 13000}) {
        report.blocks.emplace_back(
            folder.draw(frames_figure("Fig 5.17: stepped base, friction " + drawn.name, drawn, computed, {cycle}),
                        "fig_5_17_" + std::to_string(cycle), widest_joint(computed, cycle)));
    }
    const HockingResult drawn_clean = compute(drawn, Engine::dropped);
    report.blocks.emplace_back(
        folder.draw(frames_figure("Fig 5.17, clean engine: friction " + drawn.name, drawn, drawn_clean, {13000}),
                    "fig_5_17_clean", "The same by the clean engine, dropped. " + widest_joint(drawn_clean, 13000)));
    report.blocks.emplace_back(printed_table("Stepped base", result.rows));
    return result;
}

}  // namespace delabole
