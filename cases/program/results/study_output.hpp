// The result folder of a command over many runs of a model (fit, trade, sensitivity), and what reports say of the
// inputs.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/terminal/options.hpp"
#include "cases/program/terminal/progress.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/work/progress.hpp"
#include "plots/report/report.hpp"

#include <string>
#include <vector>

namespace delabole {

struct StudyOutput {
    const CaseFile& file;
    Json json;  // with the provenance
    std::string screen;
    std::string reserved;  // the reason why the result is not a reliable answer; empty if it is
};

// Tables of the inputs and of the evidence, with their sources.
void append_inputs(const CaseFile& file, Report& report);
Table evidence_table(const FitProblem& problem);

// Shows the progress of a fit as "mechanism: stage".
FitProgressCallback told_to(Progress& progress);

// Says in all outputs that mechanisms were left out, if any were: their predictions are runs, `and_so`.
void say_left_out(const std::vector<std::string>& names, const std::string& and_so, Json& json, std::string& screen,
                  Report& report);

// "report in results/slope/report.html", or "results in results/slope" without a report.
std::string written_where(const ResultFolder& folder, const Options& options);

// Puts a notice at the top of the report if there is such a reason.
void add_reservation(const std::string& reserved, bool interrupted, Report& report);

// Ends the report with the provenance, writes the files and prints the summary; not_converged if there is such a
// reason.
ExitCode write_study(const StudyOutput& output, const ResultFolder& folder, const Options& options, Report& report);

}  // namespace delabole
