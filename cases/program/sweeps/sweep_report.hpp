// Reports [[sweep]] as figures, tables and files: for `run`, `grid` and the reproductions of the thesis.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "cases/program/sweeps/sweep_run.hpp"

namespace delabole {

// Draws into the folder, writes <name>.csv and appends to the report: a table if there are few values, one figure for
// each value of `each`, and one of the crossings over these values.
void document_sweep(const SweepRun& run, const Sheet& sheet);

// Documents all sweeps of a case and returns the comparisons with printed values.
std::vector<Comparison> document_sweeps(const CaseFile& file, const SweepWork& work, const Sheet& sheet);

// The points of a run, one object each: inputs and outputs with their units, as in its CSV file.
Json json_of(const SweepRun& run);

// The points as a table for a terminal; empty if there are too many to be read.
std::string screen_of(const SweepRun& run);

Table comparison_table(const std::vector<Comparison>& comparisons);
Json json_of(const std::vector<Comparison>& comparisons);

}  // namespace delabole
