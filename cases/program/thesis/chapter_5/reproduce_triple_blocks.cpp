// 5.3.3.1 of the thesis: three blocks.
#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"
#include "cases/program/thesis/chapter_5/sliding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

// Starts from which a block slides that way, and the first cycles of it.
std::string first_in_words(const std::vector<HockingResult>& starts, std::size_t column, BaseSliding sense) {
    CountRange cycles;
    for (const HockingResult& start : starts) {
        if (const std::optional<int> cycle = first_sliding(start, column, sense)) {
            cycles.include(*cycle);
        }
    }
    return cycles.count == 0
               ? "never"
               : cycles.words(" to ") + " in " + std::to_string(cycles.count) + " of " + std::to_string(starts.size());
}

std::string cycle_in_words(const HockingResult& result, std::size_t column, BaseSliding sense) {
    const std::optional<int> cycle = first_sliding(result, column, sense);
    return cycle ? std::to_string(*cycle) : "never";
}

// Adds what is printed of single blocks beside what the typed coordinates give; `starts` are shifted by a digit.
void add_statements(const Chapter5Run& run, const HockingResult& result, const std::vector<HockingResult>& starts,
                    Reproduction& reproduction) {
    constexpr BaseSliding forward = BaseSliding::forward;
    constexpr BaseSliding backward = BaseSliding::backward;
    const std::vector<SlidingTotals> totals = totals_of(run, result);
    const std::string name = "three blocks " + run.name + ": ";
    const auto how_often = [&](const auto& holds) {
        return "; so in " + std::to_string(std::ranges::count_if(starts, holds)) + " of " +
               std::to_string(starts.size()) + " starts with the last typed digits shifted";
    };
    const auto first = [](const HockingResult& of, std::size_t column, BaseSliding sense) {
        return first_sliding(of, column, sense).value_or(std::numeric_limits<int>::max());
    };
    const auto add = [&](const std::string& what, const std::string& printed, const std::string& computed,
                         const auto& holds) {
        reproduction.rows.push_back({name + what, printed, computed, "", statement(holds(result)) + how_often(holds)});
    };
    if (run.name == "(i)") {
        add("blocks 1 and 2 slide backward", "never", in_words(totals[0]) + "; " + in_words(totals[1]),
            [&](const HockingResult& of) {
                return !first_sliding(of, 0, backward) && !first_sliding(of, 1, backward);
            });
        add("block 3 slides forward first, backward from cycle", "in the end",
            cycle_in_words(result, 2, forward) + ", " + cycle_in_words(result, 2, backward),
            [&](const HockingResult& of) {
                return first_sliding(of, 2, backward) && first(of, 2, forward) < first(of, 2, backward);
            });
    }
    if (run.name == "(ii)") {
        const auto about = [&](const HockingResult& of, std::size_t column, BaseSliding sense, int printed) {
            // A print edit to either side.
            return std::abs(first(of, column, sense) - printed) <= 100;
        };
        add("block 1 slides forward from cycle", "400", cycle_in_words(result, 0, forward),
            [&](const HockingResult& of) { return about(of, 0, forward, 400); });
        add("block 3 slides backward from cycle", "600", cycle_in_words(result, 2, backward),
            [&](const HockingResult& of) { return about(of, 2, backward, 600); });
        add("block 2 slides backward at cycle", "1500", cycle_in_words(result, 1, backward),
            [&](const HockingResult& of) { return about(of, 1, backward, 1500); });
        reproduction.rows.back().remark += "; backward from cycle " + first_in_words(starts, 1, backward);
    }
    if (run.name == "(iii)") {
        add("blocks 1 forward, 2 forward and 3 backward begin at cycle", "the first of them first",
            cycle_in_words(result, 0, forward) + ", " + cycle_in_words(result, 1, forward) + ", " +
                cycle_in_words(result, 2, backward),
            [&](const HockingResult& of) {
                return first_sliding(of, 1, forward) && first_sliding(of, 2, backward) &&
                       first(of, 0, forward) < first(of, 1, forward) && first(of, 0, forward) < first(of, 2, backward);
            });
    }
    if (run.name == "(iv)") {
        add("block 2 slides mostly", "backward", in_words(totals[1]), [&](const HockingResult& of) {
            const SlidingTotals second = totals_of(run, of)[1];
            return second.backward > second.forward;
        });
    }
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
        const std::vector<TotalsRange> ranges =
            spread_of_totals(run, compute_shifted(run, Engine::dropped, typed_digit, shifted_starts));
        for (std::size_t column = 0; column < ranges.size(); ++column) {
            std::vector<std::string> row = {run.name, std::to_string(column + 1), run.printed_behaviour[column]};
            for (const HockingResult& computed : results) {
                row.push_back(in_words(totals_of(run, computed)[column]));
                row.push_back(cycle_in_words(computed, column, BaseSliding::forward) + ", " +
                              cycle_in_words(computed, column, BaseSliding::backward));
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
        add_statements(run, results[0], compute_shifted(run, Engine::recreated, typed_digit, shifted_starts), result);
    }
    report.blocks.emplace_back(table);
    report.blocks.emplace_back(
        Paragraph{"The clean engine agrees on what blocks mostly do, and its blocks do not change their mind: block 1 "
                  "slides forward, block 3 backward. It does so with the time step divided or not, so that the "
                  "alternating senses of the thesis's histories are no matter of the step. What is left is the law of "
                  "contact: the re-created program stores the dashpot's force in its shear springs, and what is stored "
                  "pushes back. In (iv) its block 2 neither slides backward mostly, as printed, nor forward. The "
                  "cycles printed of (ii) hang on digits that are not printed, as those of four blocks do."});
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

}  // namespace delabole
