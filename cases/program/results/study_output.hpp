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
    Json json;  // with its provenance
    std::string screen;
    std::string reserved;  // what keeps the result from being the answer; empty where nothing does
};

// Puts a notice on top of the report where something keeps the result from being the answer.
void add_reservation(const std::string& reserved, bool interrupted, Report& report);

// Ends the report with the provenance, writes the files, prints; not_converged where something is reserved.
ExitCode write_study(const StudyOutput& output, const ResultFolder& folder, const Options& options, Report& report);

}  // namespace delabole
