// A sensitivity study: which parameters are uncertain and how, which quantity is looked at, when it means failure, and
// what is to be computed.
#pragma once

#include "fitting/probability/dependence.hpp"
#include "fitting/sensitivity/propagation.hpp"
#include "fitting/sensitivity/reliability.hpp"
#include "fitting/sensitivity/screening.hpp"
#include "fitting/sensitivity/sobol_indices.hpp"
#include "fitting/sensitivity/sweep.hpp"
#include "parameters/model_interface.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

class Ranks;

struct UncertainParameter {
    std::string name;  // an input of the model
    Distribution distribution;
    std::string source;
    std::vector<std::string> also = {};  // further inputs that take the same value, as two points of a water table
};

struct ParameterCorrelation {
    std::string first;
    std::string second;
    CorrelationMeasure measure = CorrelationMeasure::linear;
    double coefficient;
};

// What is absent is not done.
struct SensitivityStudy {
    std::string quantity;  // an output of the model
    std::vector<UncertainParameter> parameters;
    std::vector<ParameterCorrelation> correlations;
    std::optional<FailureCriterion> failure;
    std::optional<TornadoSettings> tornado;
    std::optional<SweepSettings> sweep;
    std::optional<MorrisSettings> morris;
    std::optional<SobolIndicesSettings> sobol_indices;
    std::optional<PropagationSettings> propagation;
    std::optional<ReliabilitySettings> reliability;
    std::uint64_t seed = 1;
};

struct SensitivityProblem {
    ModelInterface model;
    SensitivityStudy study;
    int threads = 1;               // >= 1; no result depends on it
    const Ranks* ranks = nullptr;  // nor on these; null: this process alone
};

// Where a study is wrong: "parameter[2].standard_deviation", "correlation[1]", "sobol_indices", "" for all of it.
struct StudyFault {
    std::string key;
    std::string message;
};

// The joint distribution of the parameters. The distributions have to be in order, and the pairs to exist.
InputSpace input_space(const SensitivityStudy& study);

// The study's, with the words that decide by the bounds they tell of the quantity; what the study says of a word goes
// first.
std::optional<FailureCriterion> criterion_of(const SensitivityProblem& problem);

// Names that the model does not have, distributions that cannot be drawn, correlations that are impossible, settings
// out of their range, methods that do not go with the rest. Empty when sensitivity() can start.
std::vector<StudyFault> check_study(const SensitivityProblem& problem);

}  // namespace delabole
