// The part of a back-analysis's report that tells of posteriors and evidences.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "fitting/mechanism/fit_result.hpp"

#include <string>

namespace delabole {

// Of the first mechanism, as "91 %"; empty where none was compared with it.
std::string probability_of_best(const FitResult& result);

// Says whether the order of the mechanisms is the same with other priors and another model error; empty where there is
// no order or nothing was changed.
std::string dependence_of_ranking(const FitResult& result);

// Evidences of all mechanisms against each other: table and figures for the report, evidence.csv. Nothing where no
// posterior was asked for.
void append_evidence(const FitResult& result, const ResultFolder& folder, Report& report);
Json json_of_evidence(const FitResult& result);
std::string screen_of_evidence(const FitResult& result);

// One mechanism's intervals with their diagnostics, its draws as <name>_draws.csv. Nothing where the fit has no
// posterior.
void append_posterior(const MechanismFit& fit, const ResultFolder& folder, Report& report);
Json json_of_posterior(const MechanismFit& fit);
std::string screen_of_posterior(const MechanismFit& fit);

}  // namespace delabole
