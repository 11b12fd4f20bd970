// Parts that the reports of sensitivity studies share; some serve fits and recoveries as well.
#pragma once

#include "cases/program/results/result_folder.hpp"
#include "fitting/sensitivity/sensitivity.hpp"
#include "plots/figures/sensitivity_figures.hpp"

#include <optional>
#include <string>
#include <vector>

namespace delabole {

// The parts of a study that all parts of its report need.
struct StudySubject {
    const SensitivityStudy& study;
    StudiedQuantity quantity;
    ParameterNames names = {};
    std::vector<Dimension> dimensions = {};  // of the parameters
    InputSpace space;
    std::optional<FailureCriterion> criterion;  // with the words that decide through the model's bounds
    std::vector<OutputBound> bounds = {};       // of the quantity
    std::vector<Dimension> swept = {};  // of the quantities of the sweep: the studied one, then the further ones

    explicit StudySubject(const SensitivityProblem& problem);

    std::string in_words(double value) const;
    double shown(double value) const { return in_display_unit(value, quantity.dimension); }
    std::string column(const std::string& name) const { return column_name(name, quantity.dimension); }
    double unit() const { return display_unit(quantity.dimension).si_per_unit; }
};

// "6.4 %", "6.2 to 6.7 %"
std::string percent(double share);
std::string percent_range(const Interval& interval);
// "1.34 (1.33 to 1.35)"; `unit` is the SI value of the unit shown.
std::string with_interval(const Estimate& estimate, double unit);
Json json_of(const Estimate& estimate, Dimension dimension);
Json json_of(const EvaluationCount& count);
std::string evaluations_in_words(const EvaluationCount& count);

// "Probability of failure 5.5 % (95 % interval 5.2 to 5.8 %) from 64 samples"
std::string probability_in_words(const FailureProbability& failure);
std::string reliability_in_words(const ReliabilityResult& result);

// Each appends blocks to the report, fills its part of the JSON and writes its tables and figures.
void document_tornado(const StudySubject& subject, const TornadoResult& result, const Sheet& sheet, Json& json);
// Sentences on the parameters with the greatest effect on each quantity, and on those for which it is not monotone.
std::vector<std::string> sweep_findings(const StudySubject& subject, const std::vector<SweepResult>& results);
void document_sweeps(const StudySubject& subject, const std::vector<SweepResult>& results, const Sheet& sheet,
                     Json& json);
void document_morris(const StudySubject& subject, const MorrisResult& result, const Sheet& sheet, Json& json);
void document_indices(const StudySubject& subject, const SobolIndicesResult& result, const Sheet& sheet, Json& json);
void document_samples(const StudySubject& subject, const PropagationResult& result,
                      const std::optional<ReliabilityResult>& first_order, const Sheet& sheet, Json& json);
void document_reliability(const StudySubject& subject, const ReliabilityResult& result, const Sheet& sheet, Json& json);

}  // namespace delabole
