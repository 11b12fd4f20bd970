#include "cases/program/thesis/chapter_5/sliding.hpp"

#include "cases/program/thesis/thesis_tables.hpp"
#include "parameters/fields.hpp"

#include <algorithm>

namespace delabole {

namespace {

constexpr int table_interval = 100;  // cycles

// A row of cases/thesis/chapter_5/histories.csv.
struct PrintedSliding {
    std::string table;
    double cycle;
    double last_cycle;
    std::string block_1;
    std::string block_2;
    std::string block_3;
    std::string block_4;
    static constexpr std::string_view file = "thesis/chapter_5/histories.csv";
    static constexpr auto fields() {
        return joined(table_columns<&PrintedSliding::table, &PrintedSliding::block_1, &PrintedSliding::block_2,
                                    &PrintedSliding::block_3, &PrintedSliding::block_4>(),
                      table_columns<&PrintedSliding::cycle, &PrintedSliding::last_cycle>(at_least(1)));
    }
};

constexpr std::string_view letters = "-FB?";  // by BaseSliding

BaseSliding sliding_of(const std::string& letter) {
    return static_cast<BaseSliding>(letters.find(letter.front()));
}

SlidingHistory without_sliding(const Chapter5Run& run) {
    SlidingHistory history;
    for (int cycle = run.first_print; cycle <= run.settings.cycles; cycle += table_interval) {
        history[cycle].assign(run.columns.heights.size(), BaseSliding::none);
    }
    return history;
}

// Shares of no, forward and backward sliding of each block.
std::vector<std::array<double, 3>> shares_of(const std::vector<SlidingHistory>& histories) {
    std::vector<std::array<double, 3>> shares;
    std::vector<double> said;
    for (const SlidingHistory& history : histories) {
        for (const auto& [cycle, blocks] : history) {
            shares.resize(blocks.size());
            said.resize(blocks.size());
            for (std::size_t block = 0; block < blocks.size(); ++block) {
                if (blocks[block] != BaseSliding::both) {
                    shares[block][static_cast<std::size_t>(blocks[block])] += 1;
                    said[block] += 1;
                }
            }
        }
    }
    for (std::size_t block = 0; block < shares.size(); ++block) {
        for (double& share : shares[block]) {
            share /= said[block];
        }
    }
    return shares;
}

}  // namespace

std::string in_words(const SlidingTotals& totals) {
    const std::string text = "F " + std::to_string(totals.forward) + ", B " + std::to_string(totals.backward) + ", - " +
                             std::to_string(totals.none);
    return totals.unclear > 0 ? text + ", ? " + std::to_string(totals.unclear) : text;
}

std::string in_words(const TotalsRange& range) {
    return range[0].words("-") + ", " + range[1].words("-") + ", " + range[2].words("-");
}

std::vector<SlidingTotals> totals_of(const Chapter5Run& run, const HockingResult& result) {
    return count_sliding(result, run.columns.heights.size(), run.first_print);
}

std::vector<TotalsRange> spread_of_totals(const Chapter5Run& run, const std::vector<HockingResult>& starts) {
    std::vector<TotalsRange> ranges(run.columns.heights.size());
    for (const HockingResult& result : starts) {
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

bool forward_prevails(const SlidingTotals& totals) {
    return totals.forward > totals.backward;
}

SlidingHistory printed_history(const Chapter5Run& run) {
    static const std::vector<PrintedSliding> rows = rows_of<PrintedSliding>();
    SlidingHistory history = without_sliding(run);
    for (const PrintedSliding& row : rows) {
        if (row.table == run.name) {
            for (int cycle = static_cast<int>(row.cycle); cycle <= row.last_cycle; cycle += table_interval) {
                history[cycle] = {sliding_of(row.block_1), sliding_of(row.block_2), sliding_of(row.block_3),
                                  sliding_of(row.block_4)};
            }
        }
    }
    return history;
}

SlidingHistory history_of(const Chapter5Run& run, const HockingResult& result) {
    SlidingHistory history = without_sliding(run);
    for (const HockingPrint& print : result.prints) {
        const auto edit = history.find(print.cycle);
        if (edit != history.end()) {
            for (std::size_t column = 0; column < edit->second.size(); ++column) {
                edit->second[column] = print.blocks[column].sliding;
            }
        }
    }
    return history;
}

std::string letter_of(BaseSliding sliding) {
    return {letters[static_cast<std::size_t>(sliding)]};
}

double agreement(const SlidingHistory& one, const SlidingHistory& other) {
    int said = 0;
    int same = 0;
    for (const auto& [cycle, blocks] : one) {
        const auto found = other.find(cycle);
        for (std::size_t block = 0; found != other.end() && block < blocks.size(); ++block) {
            const BaseSliding of_other = found->second[block];
            if (blocks[block] != BaseSliding::both && of_other != BaseSliding::both) {
                ++said;
                same += blocks[block] == of_other ? 1 : 0;
            }
        }
    }
    return said > 0 ? static_cast<double>(same) / said : 0;
}

HistoryAgreement agreement_of(const SlidingHistory& history, const std::vector<SlidingHistory>& starts) {
    HistoryAgreement result;
    std::vector<double> with_others;
    const auto count = static_cast<double>(starts.size());
    for (const SlidingHistory& start : starts) {
        const double with_this = agreement(history, start);
        result.mean += with_this / count;
        result.nearest = std::max(result.nearest, with_this);
        double sum = -1;  // its agreement with itself
        for (const SlidingHistory& other : starts) {
            sum += agreement(start, other);
        }
        with_others.push_back(sum / (count - 1));
    }
    const auto [least, greatest] = std::ranges::minmax(with_others);
    result.least = least;
    result.greatest = greatest;
    const std::vector<std::array<double, 3>> own = shares_of({history});
    const std::vector<std::array<double, 3>> of_starts = shares_of(starts);
    for (std::size_t block = 0; block < own.size(); ++block) {
        for (std::size_t kind = 0; kind < own[block].size(); ++kind) {
            result.by_chance += own[block][kind] * of_starts[block][kind] / static_cast<double>(own.size());
        }
    }
    return result;
}

}  // namespace delabole
