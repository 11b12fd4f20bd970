// What the program needs of each model beyond its table of fields: its answers, its figures, and words for what is
// impossible. Each model has these functions in its own models/<model>/report.cpp.
#pragma once

#include "cases/program/results/analysis.hpp"
#include "cases/program/results/result_folder.hpp"
#include "fitting/mechanism/fit_result.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace delabole {

// Answers, warnings, or the name of the check that failed.
Analysis analyse_case(const PlaneFailureStudy<>& study);
Analysis analyse_case(const SteppedBaseStudy<>& study);
Analysis analyse_case(const SingleBlock<>& problem);
Analysis analyse_case(const BlockRow<>& row);
Analysis analyse_case(const TiltedColumn<>& column);
Analysis analyse_case(const KinematicsStudy& study);
Analysis analyse_case(const FlexuralSlope& slope);
// The one model whose analysis takes long: it reports how far it has come, and can be ended and gone on with.
Analysis analyse_case(const RelaxationStudy& study, const AnalysisWork& work);
// Its failure alone, without the run.
std::string failure_without_run(const RelaxationStudy& study);

// Figures and tables that only this model has, in the report of `delabole run`. Called after analyse_case gave answers.
void append_case_figures(const PlaneFailureStudy<>& study, const ResultFolder& folder, Report& report);
void append_case_figures(const SteppedBaseStudy<>& study, const ResultFolder& folder, Report& report);
void append_case_figures(const SingleBlock<>& problem, const ResultFolder& folder, Report& report);
void append_case_figures(const BlockRow<>& row, const ResultFolder& folder, Report& report);
void append_case_figures(const TiltedColumn<>& column, const ResultFolder& folder, Report& report);
void append_case_figures(const KinematicsStudy& study, const ResultFolder& folder, Report& report);
void append_case_figures(const FlexuralSlope& slope, const ResultFolder& folder, Report& report);
void append_case_figures(const RelaxationStudy& study, const Analysis& analysis, const ResultFolder& folder,
                         Report& report);

// The same in the report of `delabole fit`, for a mechanism at its best point.
void append_mechanism_figures(const PlaneFailureStudy<>& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const ResultFolder& folder, Report& report);
void append_mechanism_figures(const SteppedBaseStudy<>& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const ResultFolder& folder, Report& report);
void append_mechanism_figures(const SingleBlock<>& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const ResultFolder& folder, Report& report);
void append_mechanism_figures(const BlockRow<>& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const ResultFolder& folder, Report& report);
void append_mechanism_figures(const TiltedColumn<>& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const ResultFolder& folder, Report& report);
void append_mechanism_figures(const KinematicsStudy& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const ResultFolder& folder, Report& report);
void append_mechanism_figures(const RelaxationStudy& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const ResultFolder& folder, Report& report);
void append_mechanism_figures(const FlexuralSlope& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const ResultFolder& folder, Report& report);

// The keys that a failed check may blame, most likely first: the first that stands in the case is blamed.
std::vector<std::string> blamed_keys(const PlaneFailureStudy<>& study, std::string_view failure);
std::vector<std::string> blamed_keys(const SteppedBaseStudy<>& study, std::string_view failure);
std::vector<std::string> blamed_keys(const SingleBlock<>& problem, std::string_view failure);
std::vector<std::string> blamed_keys(const BlockRow<>& row, std::string_view failure);
std::vector<std::string> blamed_keys(const TiltedColumn<>& column, std::string_view failure);
std::vector<std::string> blamed_keys(const KinematicsStudy& study, std::string_view failure);
std::vector<std::string> blamed_keys(const RelaxationStudy& study, std::string_view failure);
std::vector<std::string> blamed_keys(const FlexuralSlope& slope, std::string_view failure);

// What is wrong, in a sentence that says what to change, with the limit that was broken where the model can tell.
// `key` is the blamed key, empty where none stands in the case.
std::string explain_failure(const PlaneFailureStudy<>& study, std::string_view failure, const std::string& key);
std::string explain_failure(const SteppedBaseStudy<>& study, std::string_view failure, const std::string& key);
std::string explain_failure(const SingleBlock<>& problem, std::string_view failure, const std::string& key);
std::string explain_failure(const BlockRow<>& row, std::string_view failure, const std::string& key);
std::string explain_failure(const TiltedColumn<>& column, std::string_view failure, const std::string& key);
std::string explain_failure(const KinematicsStudy& study, std::string_view failure, const std::string& key);
std::string explain_failure(const RelaxationStudy& study, std::string_view failure, const std::string& key);
std::string explain_failure(const FlexuralSlope& slope, std::string_view failure, const std::string& key);

}  // namespace delabole
