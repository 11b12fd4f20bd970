// Parts of the report of a back-analysis: its answer, and for each mechanism parameters, posterior and surrogate.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "fitting/mechanism/fit_result.hpp"
#include "plots/report/report.hpp"

#include <string>
#include <vector>

namespace delabole {

// The mechanism that explains the observations best, what the data determine of it, and its first parameters.
HeadCard head_card(const FitResult& result);

std::string title_of(const MechanismFit& fit);

// "friction angle" for "strength.friction_angle" if no other parameter has the same ending.
std::string short_name(const MechanismFit& fit, const std::string& name);

// A sum of squared residuals; a rounding error is shown as 0.
std::string misfit_in_words(double misfit);

// Null if the fit has no profile of that parameter.
const ProfileLikelihood* profile_of(const MechanismFit& fit, const std::string& parameter, bool with_priors);

// The 95 % interval. Ends that are bounds of the search are marked, because the data do not determine them.
std::string interval_in_words(const ProfileLikelihood* profile, const FreeParameter& parameter, Dimension dimension);

// A table of the report for the terminal, indented and with shorter titles; empty if the table has no rows.
std::string screen_of(const Table& table, std::vector<std::string> titles);

// Details of what the data determine, folded, for the end of a mechanism's part of the report.
Folded knowledge_of(const MechanismFit& fit, const ResultFolder& folder);

// The first mechanism's probability, such as "91 %"; empty if there was no other to compare it with.
std::string probability_of_best(const FitResult& result);

// Whether the order of the mechanisms is the same with other priors and another model error; empty if there is no order
// or nothing was changed.
std::string dependence_of_ranking(const FitResult& result);

// The mechanisms that other priors or another model error put first, and which do so: "critical_sliding with flat
// priors"; empty if the one that is first as given stays first, or nothing was changed.
std::string first_under_other_priors(const FitResult& result);

// Comparison of the evidences of all mechanisms: table and figures for the report, evidence.csv. Nothing if no
// posterior was asked for.
void append_evidence(const FitResult& result, const Sheet& sheet);
Json json_of_evidence(const FitResult& result);
std::string screen_of_evidence(const FitResult& result);

// One mechanism's intervals with their diagnostics, and its draws as <name>_draws.csv. Nothing if the fit has no
// posterior.
void append_posterior(const MechanismFit& fit, const Sheet& sheet);
Json json_of_posterior(const MechanismFit& fit);
std::string screen_of_posterior(const MechanismFit& fit);

// Number of runs, accuracy of the surrogate, and the resulting uncertainty. The mechanism has to have a surrogate.
std::string surrogate_in_words(const MechanismFit& fit);

Json json_of_surrogate(const MechanismFit& fit);

// Writes parameters, misfit and failure of every run to <mechanism>_runs.csv.
void write_runs(const MechanismFit& fit, const ResultFolder& folder);

}  // namespace delabole
