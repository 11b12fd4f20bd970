// Parts of the report of a back-analysis: its answer, and for each mechanism parameters, posterior and surrogate.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "fitting/mechanism/fit_result.hpp"
#include "plots/report/report.hpp"

#include <string>
#include <vector>

namespace delabole {

// Says which mechanism explains the observations best, what the data determine of it, and its first parameters.
HeadCard head_card(const FitResult& result);

std::string title_of(const MechanismFit& fit);

// "friction angle" of "strength.friction_angle" where no other parameter ends so.
std::string short_name(const MechanismFit& fit, const std::string& name);

// A sum of squared pulls; 0 where it is rounding.
std::string misfit_in_words(double misfit);

// Null where the fit has no profile of that parameter.
const ProfileLikelihood* profile_of(const MechanismFit& fit, const std::string& parameter, bool with_priors);

// The 95 % interval, its ends marked where they are bounds of the search: those are no evidence.
std::string interval_in_words(const ProfileLikelihood* profile, const FreeParameter& parameter, Dimension dimension);

// A table of the report on the terminal, indented, under shorter titles; nothing where it has no rows.
std::string screen_of(const Table& table, std::vector<std::string> titles);

// Folded, for the end of what the report says of the mechanism.
Folded knowledge_of(const MechanismFit& fit, const ResultFolder& folder);

// The first mechanism's probability, as "91 %"; empty where none was compared with it.
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

// How many runs, how well the surrogate knows them, what that leaves open. The mechanism has to have a surrogate.
std::string surrogate_in_words(const MechanismFit& fit);

Json json_of_surrogate(const MechanismFit& fit);

// Parameters, misfit and failure of every run, as <mechanism>_runs.csv.
void write_runs(const MechanismFit& fit, const ResultFolder& folder);

}  // namespace delabole
