// The report, tables and JSON of a back-analysis.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/result_folder.hpp"
#include "fitting/mechanism/fit_result.hpp"

#include <string>
#include <vector>

namespace delabole {

// "converged", or what keeps the result from being the answer: the worst of what the mechanisms say.
std::string status_of_fit(const FitResult& result);

// result.json of `delabole fit`, but for its provenance and for what was asked beyond the fit.
Json json_of_fit(const CaseFile& file, const FitResult& result);

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
