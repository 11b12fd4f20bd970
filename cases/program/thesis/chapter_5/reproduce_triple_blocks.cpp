// 5.3.3.1 of the thesis: three blocks.
#include "cases/program/thesis/chapter_5/sliding.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>

namespace delabole {

namespace {

constexpr BaseSliding forward = BaseSliding::forward;
constexpr BaseSliding backward = BaseSliding::backward;
constexpr int never = std::numeric_limits<int>::max();

// Returns the cycle at which a block first slides in that sense.
int first(const HockingResult& result, int block, BaseSliding sense) {
    return first_sliding(result, static_cast<std::size_t>(block) - 1, sense).value_or(never);
}

std::string cycle_in_words(const HockingResult& result, int block, BaseSliding sense) {
    return in_words(first_sliding(result, static_cast<std::size_t>(block) - 1, sense));
}

// The cycles agree within a print edit to either side.
bool about(int cycle, int printed) {
    return cycle >= printed - 100 && cycle <= printed + 100;
}

// A printed statement on single blocks of a run.
struct SlidingStatement {
    std::string run;
    std::string what;
    std::string printed;
    std::function<std::string(const Chapter5Run&, const HockingResult&)> computed;
    std::function<bool(const Chapter5Run&, const HockingResult&)> holds;
};

const std::vector<SlidingStatement>& statements() {
    using Run = const Chapter5Run&;
    using Result = const HockingResult&;
    static const std::vector<SlidingStatement> all{
        {"(i)", "blocks 1 and 2 slide backward", "never",
         [](Run run, Result of) { return in_words(totals_of(run, of)[0]) + "; " + in_words(totals_of(run, of)[1]); },
         [](Run, Result of) { return first(of, 1, backward) == never && first(of, 2, backward) == never; }},
        {"(i)", "block 3 slides forward first, backward from cycle", "in the end",
         [](Run, Result of) { return cycle_in_words(of, 3, forward) + ", " + cycle_in_words(of, 3, backward); },
         [](Run, Result of) {
             return first(of, 3, backward) < never && first(of, 3, forward) < first(of, 3, backward);
         }},
        {"(ii)", "block 1 slides forward from cycle", "400",
         [](Run, Result of) { return cycle_in_words(of, 1, forward); },
         [](Run, Result of) { return about(first(of, 1, forward), 400); }},
        {"(ii)", "block 3 slides backward from cycle", "600",
         [](Run, Result of) { return cycle_in_words(of, 3, backward); },
         [](Run, Result of) { return about(first(of, 3, backward), 600); }},
        {"(ii)", "block 2 slides backward at cycle", "1500",
         [](Run, Result of) { return cycle_in_words(of, 2, backward); },
         [](Run, Result of) { return about(first(of, 2, backward), 1500); }},
        {"(iii)", "blocks 1 forward, 2 forward and 3 backward begin at cycle", "the first of them first",
         [](Run, Result of) {
             return cycle_in_words(of, 1, forward) + ", " + cycle_in_words(of, 2, forward) + ", " +
                    cycle_in_words(of, 3, backward);
         },
         [](Run, Result of) {
             const int second = first(of, 2, forward);
             const int third = first(of, 3, backward);
             return second < never && third < never && first(of, 1, forward) < std::min(second, third);
         }},
        {"(iv)", "block 2 slides mostly", "backward",
         [](Run run, Result of) { return in_words(totals_of(run, of)[1]); },
         [](Run run, Result of) { return totals_of(run, of)[1].backward > totals_of(run, of)[1].forward; }},
    };
    return all;
}

// Adds what is printed of single blocks beside what the typed coordinates give, and of how many shifted starts it
// holds.
void add_statements(const Chapter5Run& run, const HockingResult& result, int count, Reproduction& reproduction) {
    const std::vector<HockingResult> starts = compute_shifted(run, Engine::recreated, typed_digit, count);
    const std::vector<OtherListing> listings = compute_otherwise(run);
    for (const SlidingStatement& one : statements()) {
        if (one.run == run.name) {
            const auto held = std::ranges::count_if(starts, [&](const auto& start) { return one.holds(run, start); });
            std::string otherwise;
            for (const OtherListing& listing : listings) {
                otherwise += "; " + listing.name + ": " + one.computed(run, listing.result);
            }
            reproduction.add("three blocks " + run.name + ": " + one.what, one.printed, one.computed(run, result),
                             statement(one.holds(run, result)) + "; so in " + std::to_string(held) + " of " +
                                 std::to_string(starts.size()) + " starts with the last typed digits shifted" +
                                 otherwise);
        }
    }
    if (run.name == "(ii)") {
        CountRange cycles;
        for (const HockingResult& start : starts) {
            if (const int cycle = first(start, 2, backward); cycle < never) {
                cycles.include(cycle);
            }
        }
        reproduction.rows.back().remark += "; backward from cycle " + cycles.words(" to ") + " in " +
                                           std::to_string(cycles.count) + " of " + std::to_string(starts.size());
    }
}

}  // namespace

void senses_of_three_blocks(Chapter5Item& item) {
    Reproduction& result = item.result;
    for (const Chapter5Run& run : item.runs) {
        const std::array results = {compute(run, Engine::recreated), compute(run, Engine::dropped)};
        const std::vector<TotalsRange> ranges =
            spread_of_totals(run, compute_shifted(run, Engine::dropped, typed_digit, item.starts));
        for (std::size_t column = 0; column < ranges.size(); ++column) {
            const int block = static_cast<int>(column) + 1;
            std::vector<std::string>& row = item.table.rows.emplace_back(
                std::vector{run.name, std::to_string(block), run.printed_behaviour[column]});
            for (const HockingResult& computed : results) {
                row.push_back(in_words(totals_of(run, computed)[column]));
                row.push_back(cycle_in_words(computed, block, forward) + ", " +
                              cycle_in_words(computed, block, backward));
            }
            row.push_back(in_words(ranges[column]));
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
        result.add("three blocks " + run.name + ": block 1 / block 3 slides mostly", "forward / backward", in_each[0],
                   statement(senses), in_each[1]);
        add_statements(run, results[0], item.starts, result);
    }
}

}  // namespace delabole
