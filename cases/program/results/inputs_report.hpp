// Inputs and evidence with their sources, as tables of a report.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "plots/report/report.hpp"

namespace delabole {

void append_inputs(const CaseFile& file, Report& report);
Table evidence_table(const FitProblem& problem);

}  // namespace delabole
