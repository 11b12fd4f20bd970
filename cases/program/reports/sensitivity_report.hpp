// The report, tables and JSON of a sensitivity study.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/result_folder.hpp"
#include "fitting/sensitivity/sensitivity.hpp"

#include <string>

namespace delabole {

struct SensitivityDocuments {
    Json json;           // everything but status and provenance
    std::string screen;  // findings and the table of parameters
};

// Figures and CSV files are written into the folder, blocks are appended to the report. The case has a [sensitivity]
// section, from which the problem was made.
SensitivityDocuments document_sensitivity(const CaseFile& file, const SensitivityProblem& problem,
                                          const SensitivityResult& result, const ResultFolder& folder, Report& report);

}  // namespace delabole
