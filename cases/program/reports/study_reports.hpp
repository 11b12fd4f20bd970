// Reports, tables and JSON of the studies that run a model many times. Each writes its figures and CSV files into the
// folder and appends blocks to the report.
#pragma once

#include "cases/program/case/case_file.hpp"
#include "cases/program/results/result_folder.hpp"
#include "fitting/mechanism/fit_result.hpp"
#include "fitting/sensitivity/sensitivity.hpp"
#include "fitting/studies/conclusions.hpp"
#include "fitting/studies/information.hpp"
#include "fitting/studies/recovery.hpp"
#include "fitting/studies/trade.hpp"
#include "plots/report/report.hpp"

#include <string>
#include <vector>

namespace delabole {

struct StudyDocuments {
    Json json;                           // everything except the provenance
    std::string screen;                  // verdicts and findings first
    std::vector<ReportBlock> details{};  // one mechanism after another, for the end of the report
};

// "converged", or the worst status among the mechanisms.
std::string status_of_fit(const FitResult& result);

// result.json of `delabole fit` without its provenance and without the studies beyond the fit.
Json json_of_fit(const CaseFile& file, const FitResult& result);

// Writes figures and CSV tables into the folder and appends blocks to the report; the answer is placed before the
// blocks that it already holds.
StudyDocuments document_fit(const CaseFile& file, const FitProblem& problem, const FitResult& result,
                            const Sheet& sheet);

// Appends blocks to the report and writes conclusions.csv into the folder. `findings` belong to `conclusions`, in
// order.
StudyDocuments document_conclusions(const std::vector<Conclusion>& conclusions,
                                    const std::vector<ConclusionFinding>& findings, const Sheet& sheet);

// Appends blocks to the report and writes table and figure into the folder. `information` belongs to `candidates`, in
// order.
StudyDocuments document_information(const std::vector<FitCandidate>& candidates,
                                    const std::vector<CandidateInformation>& information, const Sheet& sheet);

// Appends blocks to the report and writes tables and figures into the folder. `at_best`: the known parameters were
// those of the best fit.
StudyDocuments document_recovery(const std::vector<MechanismRecovery>& recoveries, bool at_best, const Sheet& sheet);

// Writes figures and CSV files into the folder and appends blocks to the report. The problem was made from the
// [sensitivity] section of the case.
StudyDocuments document_sensitivity(const CaseFile& file, const SensitivityProblem& problem,
                                    const SensitivityResult& result, const Sheet& sheet);

// The quantity whose error is shown, and the source of its accurate value.
struct TradeTruth {
    std::string quantity;     // "critical_tilt"
    Dimension dimension;      // of it
    std::string where_from;   // its source, for a sentence
    double half_bracket = 0;  // SI; no setting can show a smaller error
};

// Writes the figure and trade.csv into the folder and appends blocks to the report.
StudyDocuments document_trade(const std::vector<TradeParameter>& parameters, const TradeResult& result,
                              const TradeTruth& truth, const Sheet& sheet);

}  // namespace delabole
