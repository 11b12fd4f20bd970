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
    Json json;                           // everything but provenance
    std::string screen;                  // verdicts and findings first
    std::vector<ReportBlock> details{};  // one mechanism after the other, for the end of the report
};

// "converged", or what keeps the result from being the answer: the worst of what the mechanisms say.
std::string status_of_fit(const FitResult& result);

// result.json of `delabole fit`, but for its provenance and for what was asked beyond the fit.
Json json_of_fit(const CaseFile& file, const FitResult& result);

// Figures and CSV tables are written into the folder, blocks are appended to the report, the answer in front of what it
// holds already.
StudyDocuments document_fit(const CaseFile& file, const FitProblem& problem, const FitResult& result,
                            const ResultFolder& folder, Report& report);

// Appends blocks to the report and writes conclusions.csv into the folder. `findings` are those of `conclusions`.
StudyDocuments document_conclusions(const std::vector<Conclusion>& conclusions,
                                    const std::vector<ConclusionFinding>& findings, const ResultFolder& folder,
                                    Report& report);

// Appends blocks to the report and writes table and figure into the folder. `information` is that of `candidates`.
StudyDocuments document_information(const std::vector<FitCandidate>& candidates,
                                    const std::vector<CandidateInformation>& information, const ResultFolder& folder,
                                    Report& report);

// Appends blocks to the report and writes tables and figures into the folder. `at_best`: the truth was the best
// fit.
StudyDocuments document_recovery(const std::vector<MechanismRecovery>& recoveries, bool at_best,
                                 const ResultFolder& folder, Report& report);

// Figures and CSV files are written into the folder, blocks are appended to the report. The case has a [sensitivity]
// section, from which the problem was made.
StudyDocuments document_sensitivity(const CaseFile& file, const SensitivityProblem& problem,
                                    const SensitivityResult& result, const ResultFolder& folder, Report& report);

// The quantity whose error is told, and its accurate value.
struct TradeTruth {
    std::string quantity;     // "critical_tilt"
    Dimension dimension;      // of it
    std::string where_from;   // for a sentence
    double half_bracket = 0;  // SI; no setting can show a smaller error
};

// The figure and trade.csv are written into the folder, blocks are appended to the report.
StudyDocuments document_trade(const std::vector<TradeKnob>& knobs, const TradeResult& result, const TradeTruth& truth,
                              const ResultFolder& folder, Report& report);

}  // namespace delabole
