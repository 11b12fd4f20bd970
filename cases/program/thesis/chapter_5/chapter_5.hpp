// The items of the thesis's chapter 5, dynamic relaxation.
#pragma once

#include "cases/program/thesis/hocking/chapter_5.hpp"
#include "cases/program/thesis/reproduction.hpp"
#include "dynamic_relaxation/scene/settings.hpp"

#include <functional>
#include <string>
#include <vector>

namespace delabole {

// How a run of chapter 5 is computed; every table has a column for each scheme.
struct Scheme {
    std::string name;
    std::string brief;  // of the clean engine: how it starts
    std::function<HockingResult(const Chapter5Run&)> compute;
};

const std::vector<Scheme>& schemes();

// Of one table: what of a run is printed, and what a scheme says to it.
struct RunTable {
    std::string caption;
    std::string heading;  // of the first column
    std::vector<Chapter5Run> runs;
    std::function<std::string(const Chapter5Run&)> printed;
    std::function<std::string(const Chapter5Run&, const HockingResult&)> computed;
};

Table table_of(const RunTable& data);

// "stands", "fails at cycle 3000", "blows out at cycle 680", "undecided".
std::string outcome_in_words(const HockingResult& result);
std::string in_words(PrintedOutcome printed);
bool agrees(PrintedOutcome printed, const HockingResult& result);

// Outcomes of a run with the free blocks' coordinates shifted at random by a unit.
struct OutcomeCount {
    int runs = 0;
    int stand = 0;
    int fail = 0;
    int blow_out = 0;
    int undecided = 0;

    void include(HockingOutcome outcome);
};

OutcomeCount count_outcomes(const Chapter5Run& run, double unit, int runs);
OutcomeCount count_clean_outcomes(const Chapter5Run& run, RelaxationStart start, double unit, int runs);
std::string in_words(const OutcomeCount& count);
int agreeing(PrintedOutcome printed, const OutcomeCount& count);

// Every run's outcome beside the printed one, also for result.json; where they differ, of shifted starts too, and the
// reason, if one is known.
void add_outcomes(const std::string& what, const std::vector<Chapter5Run>& runs, Reproduction& result,
                  const std::function<std::string(const Chapter5Run&)>& reason = {});

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
