// 5.3.3.2 of the thesis: four blocks, Tables 5.1 to 5.5.
#include "cases/program/thesis/chapter_5/sliding.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace delabole {

namespace {

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

std::string share_in_words(double share) {
    return human_number(100 * share, 2) + " %";
}

constexpr double last_bit = 1e-15;  // m

// Tabulates what each block does at each printed edit, and in how many of the starts it does so.
Table history_table(const Chapter5Run& run, const SlidingHistory& printed, const std::vector<SlidingHistory>& starts) {
    Table table{run.name + ": printed, and of " + std::to_string(starts.size()) + " starts those that slide F / B",
                {"cycle"_number}};
    for (std::size_t block = 0; block < run.columns.heights.size(); ++block) {
        table.columns.emplace_back("block " + std::to_string(block + 1));
        table.columns.emplace_back("F / B", true);
    }
    for (const auto& [cycle, blocks] : printed) {
        std::vector<std::string>& row = table.rows.emplace_back(std::vector{std::to_string(cycle)});
        for (std::size_t block = 0; block < blocks.size(); ++block) {
            const auto sliding = [&, at = cycle](BaseSliding sense) {
                return std::to_string(std::ranges::count_if(
                    starts, [&](const SlidingHistory& one) { return one.at(at)[block] == sense; }));
            };
            row.push_back(letter_of(blocks[block]));
            row.push_back(sliding(BaseSliding::forward) + " / " + sliding(BaseSliding::backward));
        }
    }
    return table;
}

// Each block has a lane: forward above its line, backward below it.
Figure history_lanes(const Chapter5Run& run, const SlidingHistory& printed, const std::vector<SlidingHistory>& starts) {
    constexpr double half_lane = 0.28;
    Figure figure{.title = run.name + ": sliding of four blocks",
                  .x = {.title = "cycle"},
                  .y = {.title = "block", .range = std::pair(0.4, 4.6), .grid = false}};
    Points marks{.legend = "printed; up: forward", .marker = Marker::filled_circle, .size = 0.9};
    const auto count = static_cast<double>(starts.size());
    for (std::size_t block = 0; block < run.columns.heights.size(); ++block) {
        const double lane = static_cast<double>(block) + 1;
        Line net{.legend = block == 0 ? "share of starts that slide forward, less backward" : "",
                 .colour = Colour::blue};
        Line none{.colour = Colour::light_grey, .width = 1.2};
        for (const auto& [cycle, blocks] : printed) {
            double sum = 0;
            for (const SlidingHistory& start : starts) {
                const BaseSliding does = start.at(cycle)[block];
                sum += does == BaseSliding::forward ? 1 : does == BaseSliding::backward ? -1 : 0;
            }
            net.points.emplace_back(cycle, lane + half_lane * sum / count);
            none.points.emplace_back(cycle, lane);
            const BaseSliding does = blocks[block];
            if (does != BaseSliding::both) {
                const double side = does == BaseSliding::forward ? 1 : does == BaseSliding::backward ? -1 : 0;
                marks.points.emplace_back(cycle, lane + half_lane * side);
            }
        }
        figure.series.emplace_back(none);
        figure.series.emplace_back(net);
        figure.y.ticks.emplace_back(lane, std::to_string(block + 1));
    }
    figure.series.emplace_back(marks);
    return figure;
}

// Adds the printed rows beside those of many starts, and where the listing's words part from `reference`.
void add_history(const Chapter5Run& run, const HockingResult& reference, const std::vector<HockingResult>& results,
                 Chapter5Item& item) {
    const SlidingHistory printed = printed_history(run);
    std::vector<SlidingHistory> starts;
    for (const HockingResult& one : results) {
        if (one.outcome != HockingOutcome::blows_out) {
            starts.push_back(history_of(run, one));
        }
    }
    const HistoryAgreement agrees = agreement_of(printed, starts);
    Reproduction& result = item.result;
    Json& json = result.json["histories"][run.name];
    json = {{"mean", agrees.mean},
            {"nearest", agrees.nearest},
            {"least_of_starts", agrees.least},
            {"greatest_of_starts", agrees.greatest},
            {"by_chance", agrees.by_chance}};
    const SlidingHistory unshortened = history_of(run, reference);
    std::string parted;
    std::string as_starts;
    for (const OtherListing& listing : compute_otherwise(run)) {
        const SlidingHistory history = history_of(run, listing.result);
        const auto differs =
            std::ranges::find_if(history, [&](const auto& edit) { return edit.second != unshortened.at(edit.first); });
        const double as_printed = agreement(printed, history);
        parted += (parted.empty() ? "" : "; ") + listing.name + ": " +
                  (listing.result.outcome == HockingOutcome::blows_out ? "blows out"
                   : differs == history.end()                          ? "never"
                                                                       : "cycle " + std::to_string(differs->first)) +
                  ", " + share_in_words(as_printed) + " of rows";
        as_starts += "; " + listing.name + ": " + share_in_words(agreement_of(history, starts).mean);
        json[listing.name] = as_printed;
    }
    // One of the starts and the printed table has to agree least: by chance alone each is as likely to.
    const bool alike = agrees.mean >= agrees.least;
    const double chance = 1 / static_cast<double>(starts.size() + 1);
    const std::string by_accident = ": less than any start; chance makes it so in " + share_in_words(chance) +
                                    " of tables, and in " +
                                    share_in_words(1 - std::pow(1 - chance, static_cast<double>(item.runs.size()))) +
                                    " for one of " + number_in_words(static_cast<double>(item.runs.size()));
    result.add(run.name + ": rows as those of " + std::to_string(starts.size()) + " starts, on average",
               "as starts among themselves: " + share_in_words(agrees.least) + " to " + share_in_words(agrees.greatest),
               share_in_words(agrees.mean),
               statement(alike) + (alike ? "" : by_accident) + as_starts +
                   "; the nearest start agrees with the printed table in " + share_in_words(agrees.nearest) +
                   " of blocks and rows, by chance it would be " + share_in_words(agrees.by_chance));
    result.add(run.name + ": first row that shorter words or blocks listed from the last change, and rows as printed",
               "", parted, "");
    item.below.add(history_table(run, printed, starts));
    item.draw(
        history_lanes(run, printed, starts), "table_" + run.name.substr(6, 1) + "_" + run.name.substr(8),
        "Forward above a block's line, backward below it: printed, and by the re-created program from many starts.");
}

}  // namespace

// Counts the numbers and senses that are as printed.
struct AsPrinted {
    int totals = 0;                // printed
    int within = 0;                // of them, within the range of the starts
    int clean_within = 0;          // and of those of the clean engine
    int senses = 0;                // printed
    int computed = 0;              // of them, as computed
    int clean = 0;                 // and by the clean engine
    std::vector<int> starts = {};  // by each start
};

void histories_of_four_blocks(Chapter5Item& item) {
    Reproduction& result = item.result;
    AsPrinted count;
    count.starts.resize(static_cast<std::size_t>(item.starts));
    for (const Chapter5Run& run : item.runs) {
        const std::vector<HockingResult> starts = compute_shifted(run, Engine::recreated, typed_digit, item.starts);
        const std::vector<TotalsRange> bit =
            spread_of_totals(run, compute_shifted(run, Engine::recreated, last_bit, item.starts));
        const std::vector<TotalsRange> digit = spread_of_totals(run, starts);
        const std::vector<TotalsRange> of_clean =
            spread_of_totals(run, compute_shifted(run, Engine::dropped, typed_digit, item.starts));
        const HockingResult reference = compute(run, Engine::recreated);
        const HockingResult clean_reference = compute(run, Engine::dropped);
        const std::vector<SlidingTotals> computed = totals_of(run, reference);
        const std::vector<SlidingTotals> clean_totals = totals_of(run, clean_reference);
        for (std::size_t column = 0; column < computed.size(); ++column) {
            const SlidingTotals& printed = run.printed_totals[column];
            item.table.rows.push_back({run.name, std::to_string(column + 1), in_words(printed),
                                       in_words(computed[column]), in_words(bit[column]), in_words(digit[column]),
                                       in_words(clean_totals[column]), in_words(of_clean[column])});
            for (std::size_t kind = 0; kind < counted.size(); ++kind) {
                const int value = printed.*counted[kind];
                ++count.totals;
                count.within += bit[column][kind].holds(value) || digit[column][kind].holds(value) ? 1 : 0;
                count.clean_within += of_clean[column][kind].holds(value) ? 1 : 0;
            }
            if (printed.forward != printed.backward) {
                const auto same_sense = [&](const SlidingTotals& totals) {
                    return forward_prevails(totals) == forward_prevails(printed) ? 1 : 0;
                };
                ++count.senses;
                count.computed += same_sense(computed[column]);
                count.clean += same_sense(clean_totals[column]);
                for (std::size_t start = 0; start < starts.size(); ++start) {
                    count.starts[start] += same_sense(totals_of(run, starts[start])[column]);
                }
            }
            const auto as_json = [](const SlidingTotals& totals) {
                return Json{totals.forward, totals.backward, totals.none};
            };
            result.json[run.name].push_back({{"printed", as_json(printed)},
                                             {"computed", as_json(computed[column])},
                                             {"clean", as_json(clean_totals[column])}});
        }
        add_history(run, reference, starts, item);
        const int parted = first_difference(run, Engine::recreated, make_blocks(run.columns), last_bit);
        const int clean_parted = first_difference(run, Engine::dropped, exact_blocks(run), last_bit);
        result.json["first_different_print"][run.name] = parted;
        result.json["first_different_print_of_clean"][run.name] = clean_parted;
        result.add(run.name + ": first print that a shift of 1e-15 m changes", "", "cycle " + std::to_string(parted),
                   "", clean_parted > 0 ? "cycle " + std::to_string(clean_parted) : std::string("none"));
    }
    result.json["printed_totals_within_range"] = count.within;
    result.json["printed_totals"] = count.totals;
    result.json["senses_as_printed"] = count.computed;
    result.json["clean_senses_as_printed"] = count.clean;
    result.json["senses_of_starts"] = count.starts;
    result.add("printed totals within the range of the starts", std::to_string(count.totals),
               std::to_string(count.within), "", std::to_string(count.clean_within));
    const auto [fewest, most] = std::ranges::minmax(count.starts);
    result.add("blocks whose prevailing sense is the printed one", std::to_string(count.senses),
               std::to_string(count.computed),
               statement(count.computed == count.senses) + ": with the last typed digits shifted " +
                   std::to_string(fewest) + " to " + std::to_string(most) + ", all of them in " +
                   std::to_string(std::ranges::count(count.starts, count.senses)) + " of " +
                   std::to_string(item.starts) + " starts",
               std::to_string(count.clean));
}

}  // namespace delabole
