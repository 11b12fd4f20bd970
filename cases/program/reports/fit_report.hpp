// The report, tables and JSON of a back-analysis.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/result_folder.hpp"
#include "fitting/mechanism/fit_result.hpp"

#include <string>
#include <vector>

namespace delabole {

struct FitDocuments {
    Json json;                           // everything but provenance
    std::string screen;                  // verdicts first, then values
    std::vector<ReportBlock> details{};  // one mechanism after the other, for the end of the report
};

// Figures and CSV tables are written into the folder, blocks are appended to the report, the answer in front of what it
// holds already.
FitDocuments document_fit(const CaseFile& file, const FitProblem& problem, const FitResult& result,
                          const ResultFolder& folder, Report& report);

}  // namespace delabole
