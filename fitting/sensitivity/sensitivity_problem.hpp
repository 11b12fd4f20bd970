// A sensitivity study: which parameters are uncertain and by how much, which quantity is studied, when it means
// failure, and which analyses are made.
#pragma once

#include "fitting/probability/dependence.hpp"
#include "fitting/sensitivity/propagation.hpp"
#include "fitting/sensitivity/reliability.hpp"
#include "fitting/sensitivity/screening.hpp"
#include "fitting/sensitivity/sobol_indices.hpp"
#include "fitting/sensitivity/sweep.hpp"
#include "parameters/model_interface.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

class Ranks;

struct UncertainParameter {
    std::string name;
    Distribution distribution;
    std::string source;
    std::vector<std::string> also = {};  // further inputs with the same value, such as two points of a water table
    Dimension dimension = Dimension::ratio;
    static constexpr auto fields() {
        using P = UncertainParameter;
        return FieldTable{
            refers_to(NameOf::input, section<&P::name>("the input that is uncertain, e.g. strength.cohesion")),
            inlined(&P::distribution, "how it is distributed"),
            refers_to(NameOf::input, section<&P::also>("further inputs that take the same value")),
            with_default(section<&P::source>("where the distribution comes from")),
        };
    }
};

struct ParameterCorrelation {
    std::array<std::string, 2> pair;
    CorrelationMeasure measure = CorrelationMeasure::linear;
    double coefficient;
    static constexpr auto fields() {
        return FieldTable{
            section("between", &ParameterCorrelation::pair, "the names of two uncertain parameters, [\"a\", \"b\"]"),
            number<&ParameterCorrelation::coefficient>(between(-1, 1), "correlation coefficient"),
            with_default(section<&ParameterCorrelation::measure>("of the values, or of their ranks")),
        };
    }
};

// Analyses whose settings are absent are not made.
struct SensitivityStudy {
    std::string quantity;
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
    Dimension dimension = Dimension::ratio;  // of the quantity
    static constexpr auto fields() {
        using S = SensitivityStudy;
        return FieldTable{
            refers_to(NameOf::output, section<&S::quantity>("the output that is studied, e.g. factor_of_safety")),
            with_default(number<&S::seed>(at_least(0), "of the random numbers")),
            section("parameter", &S::parameters, "an input that is uncertain"),
            section("correlation", &S::correlations, "parameters that depend on each other"),
            section<&S::failure>("when the quantity means failure"),
            section<&S::tornado>("one parameter at a time, between two quantiles"),
            section<&S::sweep>("in steps between the same quantiles: what is not monotone"),
            section<&S::morris>("elementary effects: which parameters matter"),
            section<&S::sobol_indices>("shares of the variance"),
            section<&S::propagation>("distribution of the quantity and probability of failure"),
            section<&S::reliability>("the most likely point of failure"),
        };
    }
};

struct SensitivityProblem {
    ModelInterface model;
    SensitivityStudy study;
    int threads = 1;               // >= 1; no result depends on it
    const Ranks* ranks = nullptr;  // no result depends on them; null: this process alone
};

// A fault of a study and its place: "parameter[2].standard_deviation", "correlation[1]", "sobol_indices", or "" for the
// study as a whole.
struct StudyFault {
    std::string key;
    std::string message;
};

// The joint distribution of the parameters. The distributions must have no fault, and the pairs must name parameters.
InputSpace input_space(const SensitivityStudy& study);

// The study's criterion, to which those words of the model are added whose bounds on the quantity decide whether the
// slope fails. Words that the study itself lists keep their meaning.
std::optional<FailureCriterion> criterion_of(const SensitivityProblem& problem);

// Finds names that the model does not have, distributions that cannot be drawn, correlations that are impossible,
// settings out of their range, and methods that do not suit the rest of the study. Empty when sensitivity() can start.
std::vector<StudyFault> check_study(const SensitivityProblem& problem);

}  // namespace delabole
