// The items of the thesis's chapter 5, dynamic relaxation, and what they share.
#pragma once

#include "cases/program/thesis/chapter_5/clean_chapter_5.hpp"
#include "cases/program/thesis/reproduction.hpp"

#include <functional>
#include <string>
#include <vector>

namespace delabole {

using WordsOfRun = std::function<std::string(const Chapter5Run&)>;
using WordsOfResult = std::function<std::string(const Chapter5Run&, const HockingResult&)>;

// A row for each run: what is printed of it, and what each engine says to it. `heading` is that of the runs' names.
Table table_of(const std::string& caption, const std::string& heading, const std::vector<Chapter5Run>& runs,
               const WordsOfRun& printed, const WordsOfResult& computed);

// "blows out".
std::string in_words(HockingOutcome outcome);
std::string printed_outcome(const Chapter5Run& run);
// "stands", "blows out at cycle 680".
std::string outcome_in_words(const HockingResult& result);
// Adds the cycle at which the first block has turned by a degree.
std::string outcome_with_rotation(const Chapter5Run& run, const HockingResult& result);
// "of 20: 3 stand and 17 fail".
std::string in_words(const std::vector<HockingResult>& results);

// "800 / 900".
std::string in_words(const SettledCycles& settled);
// Cycles after which the first block rests, or how the run ends otherwise.
std::string settled_in_words(const HockingResult& result);

// Degrees.
double rotation_at_end(const HockingResult& result, std::size_t column);

std::string in_words(TiltedPart part);  // "base turned"

// Least and greatest number over many starts.
struct CountRange {
    int least = 0;
    int greatest = 0;
    int count = 0;  // of the numbers

    void include(int value);
    bool holds(int value) const { return count > 0 && value >= least && value <= greatest; }
    std::string words(const std::string& to) const;  // "3 to 8"
};

// Every run's outcome beside the printed one, also for result.json; where they differ, of shifted starts too, and the
// reason, if one is known.
void add_outcomes(const std::string& what, const std::vector<Chapter5Run>& runs, Reproduction& result,
                  const WordsOfRun& reason = {});

// How many outcomes are as printed where gravity turned instead of the base: no statement of the thesis's.
void add_other_part(const std::string& what, const std::vector<Chapter5Run>& runs, Reproduction& result);

Reproduction reproduce_fig_5_4(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_5_5(const ResultFolder& folder, Report& report);
Reproduction reproduce_single_blocks(const ResultFolder& folder, Report& report);

Reproduction reproduce_double_blocks(const ResultFolder& folder, Report& report);
Reproduction reproduce_tilted_blocks(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_5_12(const ResultFolder& folder, Report& report);
Reproduction reproduce_observations(const ResultFolder& folder, Report& report);

Reproduction reproduce_thresholds(const ResultFolder& folder, Report& report);

Reproduction reproduce_fig_5_13(const ResultFolder& folder, Report& report);

Reproduction reproduce_triple_blocks(const ResultFolder& folder, Report& report);
Reproduction reproduce_quadruple_blocks(const ResultFolder& folder, Report& report);

Reproduction reproduce_fig_5_16(const ResultFolder& folder, Report& report);
Reproduction reproduce_fig_5_17(const ResultFolder& folder, Report& report);
Reproduction reproduce_onset(const ResultFolder& folder, Report& report);

}  // namespace delabole
