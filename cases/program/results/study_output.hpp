// The result folder of a command over many runs of a model (fit, trade, sensitivity).
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/result_folder.hpp"
#include "cases/program/terminal/options.hpp"

#include "plots/report/report.hpp"

#include <string>

namespace delabole {

struct StudyOutput {
    const CaseFile& file;
    Json json;  // with the provenance
    std::string screen;
    std::string reserved;  // the reason why the result is not a reliable answer; empty if it is
};

// Puts a notice at the top of the report if there is such a reason.
void add_reservation(const std::string& reserved, bool interrupted, Report& report);

// Ends the report with the provenance, writes the files and prints the summary; not_converged if there is such a
// reason.
ExitCode write_study(const StudyOutput& output, const ResultFolder& folder, const Options& options, Report& report);

}  // namespace delabole
