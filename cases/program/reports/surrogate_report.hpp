// What a back-analysis says of a mechanism that was fitted through a surrogate of its runs.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "fitting/mechanism/fit_result.hpp"

#include <string>

namespace delabole {

// How many runs, how well the surrogate knows them, what that leaves open. The mechanism has to have a surrogate.
std::string surrogate_in_words(const MechanismFit& fit);

Json json_of_surrogate(const MechanismFit& fit);

// Parameters, misfit and failure of every run, as <mechanism>_runs.csv.
void write_runs(const MechanismFit& fit, const ResultFolder& folder);

}  // namespace delabole
