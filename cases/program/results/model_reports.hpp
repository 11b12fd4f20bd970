// Functions that the program needs for each model besides its table of fields: the answer, its outputs and figures, and
// the sentences for impossible cases. Each model defines them in its own models/<model>/report.cpp.
#pragma once

#include "cases/program/results/analysis.hpp"
#include "cases/program/results/answers.hpp"
#include "cases/program/results/result_folder.hpp"
#include "fitting/mechanism/fit_result.hpp"
#include "kinematics/kinematics.hpp"
#include "limit_equilibrium/block_row/block_row.hpp"
#include "limit_equilibrium/stepped_path/stepped_path.hpp"
#include "water/column_tilt.hpp"
#include "wedge_failure/wedge_failure.hpp"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace delabole {

// Input -> standard deviation, SI, of those that a case gives.
using InputDeviations = std::map<std::string, double>;

struct WedgeFailureAnswer {
    WedgeFailureResult result{};
    std::vector<Required> required{};  // in the order of the study's requests
};

// Computes everything that the case asks for, once; the answer's check tells whether there is one. Only relaxation
// takes long and uses `work`: it reports progress, can be stopped and can be continued.
template <class Study>
auto analyse_case(const Study& study, const AnalysisWork& /*work*/ = {}) {
    return analyse(study);
}
PlaneFailureAnswer analyse_case(const PlaneFailureStudy<>& study, const AnalysisWork& work = {});
SteppedBaseAnswer analyse_case(const SteppedBaseStudy<>& study, const AnalysisWork& work = {});
WedgeFailureAnswer analyse_case(const WedgeFailureStudy& study, const AnalysisWork& work = {});
RelaxationStudyAnswer analyse_case(const RelaxationStudy& study, const AnalysisWork& work = {});

// Name of the check that failed; empty if there is an answer.
template <class Answer>
std::string failure_in(const Answer& answer) {
    if constexpr (requires { answer.result.check; }) {
        return failure_in(answer.result);
    } else if constexpr (requires { answer.check; }) {
        return answer.check == decltype(answer.check)::valid ? std::string() : std::string(word_of(answer.check));
    } else {
        return {};
    }
}
std::string failure_in(const RelaxationStudyAnswer& answer);

// Names, numbers and warnings of an answer whose check is valid.
template <class Study, class Answer>
Analysis named_outputs(const Study& /*study*/, const Answer& answer) {
    Analysis analysis;
    append_outputs(analysis, answer);
    return analysis;
}
Analysis named_outputs(const PlaneFailureStudy<>& study, const PlaneFailureAnswer& answer);
Analysis named_outputs(const SteppedBaseStudy<>& study, const SteppedBaseAnswer& answer);
Analysis named_outputs(const SingleBlock& problem, const SingleBlockResult& result);
Analysis named_outputs(const BlockRow& row, const BlockRowResult& result);
Analysis named_outputs(const KinematicsStudy& study, const KinematicsResult& result);
Analysis named_outputs(const SteppedPath& path, const SteppedPathResult& result);
Analysis named_outputs(const WedgeFailureStudy& study, const WedgeFailureAnswer& answer);
Analysis named_outputs(const RelaxationStudy& study, const RelaxationStudyAnswer& answer);

// The answer in at most three sentences, the first of them the verdict. The answer's check is valid.
HeadCard head_card(const PlaneFailureStudy<>& study, const PlaneFailureAnswer& answer);
HeadCard head_card(const SteppedBaseStudy<>& study, const SteppedBaseAnswer& answer);
HeadCard head_card(const SingleBlock& problem, const SingleBlockResult& result);
HeadCard head_card(const BlockRow& row, const BlockRowResult& result);
HeadCard head_card(const TiltedColumn<>& column, const ColumnTilt& tilt);
HeadCard head_card(const KinematicsStudy& study, const KinematicsResult& result);
HeadCard head_card(const FlexuralSlope& slope, const FlexuralStability& result);
HeadCard head_card(const SteppedPath& path, const SteppedPathResult& result);
HeadCard head_card(const WedgeFailureStudy& study, const WedgeFailureAnswer& answer);
HeadCard head_card(const RelaxationStudy& study, const RelaxationStudyAnswer& answer);

// Figures and tables of this model alone for the report of `delabole run`; the figure that shows the answer comes
// first. Some models have none. The answer's check is valid.
template <class Study, class Answer>
void append_case_figures(const Study& /*study*/, const Answer& /*answer*/, const Sheet& /*sheet*/) {}
void append_case_figures(const PlaneFailureStudy<>& study, const PlaneFailureAnswer& answer, const Sheet& sheet,
                         const InputDeviations& known);
void append_case_figures(const SteppedBaseStudy<>& study, const SteppedBaseAnswer& answer, const Sheet& sheet,
                         const InputDeviations& known);
void append_case_figures(const SingleBlock& problem, const SingleBlockResult& result, const Sheet& sheet);
void append_case_figures(const BlockRow& row, const BlockRowResult& result, const Sheet& sheet);
void append_case_figures(const KinematicsStudy& study, const KinematicsResult& result, const Sheet& sheet);
void append_case_figures(const FlexuralSlope& slope, const FlexuralStability& result, const Sheet& sheet);
void append_case_figures(const SteppedPath& path, const SteppedPathResult& result, const Sheet& sheet);
void append_case_figures(const WedgeFailureStudy& study, const WedgeFailureAnswer& answer, const Sheet& sheet,
                         const InputDeviations& known);
void append_case_figures(const RelaxationStudy& study, const RelaxationStudyAnswer& answer, const Sheet& sheet);

template <class Study>
using AnswerTo = decltype(analyse_case(std::declval<const Study&>()));

template <class... Studies>
std::variant<AnswerTo<Studies>...> answers_to(const std::variant<Studies...>& model);

// The answer for any model that a case can have, and the functions above for it.
using CaseAnswer = decltype(answers_to(std::declval<const CaseModel&>()));
CaseAnswer analyse_case(const CaseModel& model, const AnalysisWork& work = {});
Analysis named_outputs(const CaseModel& model, const CaseAnswer& answer);
HeadCard head_card(const CaseModel& model, const CaseAnswer& answer);
void append_case_figures(const CaseModel& model, const CaseAnswer& answer, const Sheet& sheet,
                         const InputDeviations& known = {});

struct CaseFigure {
    Figure figure;
    std::string caption;
};

// The first of those figures, not drawn yet; the others are not computed.
std::optional<CaseFigure> first_case_figure(const CaseModel& model, const CaseAnswer& answer);

// Figures of a mechanism at its best point, for the report of `delabole fit`.
template <class Study>
void append_mechanism_figures(const Study& /*at_best*/, const MechanismFit& /*fit*/, const FitProblem& /*problem*/,
                              const Sheet& /*sheet*/) {}
void append_mechanism_figures(const PlaneFailureStudy<>& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const Sheet& sheet);
void append_mechanism_figures(const SteppedBaseStudy<>& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const Sheet& sheet);
void append_mechanism_figures(const SingleBlock& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const Sheet& sheet);
void append_mechanism_figures(const BlockRow& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const Sheet& sheet);
void append_mechanism_figures(const RelaxationStudy& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const Sheet& sheet);
void append_mechanism_figures(const FlexuralSlope& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const Sheet& sheet);
void append_mechanism_figures(const SteppedPath& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const Sheet& sheet);
void append_mechanism_figures(const WedgeFailureStudy& at_best, const MechanismFit& fit, const FitProblem& problem,
                              const Sheet& sheet);

// The reason why a case has no answer.
struct Impossibility {
    std::vector<std::string> keys = {};  // possible causes, most likely first; the first in the case is reported
    std::string words = {};              // a sentence about what is wrong and what to change
    // The same with the limit that the value of the reported key violates; empty if no number adds to it.
    std::function<std::string(const std::string& key)> limit = {};
};

// Looks up the sentence for a failed check of a model in impossible_cases.csv; by default it is "a number is outside
// its allowed range".
Impossibility stated_impossibility(std::string_view model, std::string_view failure);

template <class Study>
Impossibility impossibility(const Study& /*study*/, std::string_view failure) {
    return stated_impossibility(Study::kind, failure);
}
Impossibility impossibility(const PlaneFailureStudy<>& study, std::string_view failure);
Impossibility impossibility(const SteppedBaseStudy<>& study, std::string_view failure);
Impossibility impossibility(const SingleBlock& problem, std::string_view failure);
Impossibility impossibility(const BlockRow& row, std::string_view failure);
Impossibility impossibility(const KinematicsStudy& study, std::string_view failure);
Impossibility impossibility(const RelaxationStudy& study, std::string_view failure);

}  // namespace delabole
