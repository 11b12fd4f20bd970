#include "fitting/sensitivity/sensitivity_problem.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>
#include <utility>

namespace delabole {

namespace {

using Faults = std::vector<StudyFault>;

std::string numbered(const std::string& key, std::size_t index) {
    return key + "[" + std::to_string(index + 1) + "]";
}

void check_parameters(const SensitivityProblem& problem, Faults& faults) {
    const SensitivityStudy& study = problem.study;
    if (study.parameters.empty()) {
        faults.push_back({"", "nothing is uncertain: [[sensitivity.parameter]] is required"});
    }
    if (study.parameters.size() > most_parameters) {
        faults.push_back({numbered("parameter", most_parameters), std::to_string(study.parameters.size()) +
                                                                      " uncertain parameters, at most " +
                                                                      std::to_string(most_parameters)});
    }
    std::set<std::string> seen;
    for (std::size_t index = 0; index < study.parameters.size(); ++index) {
        const UncertainParameter& parameter = study.parameters[index];
        const std::string key = numbered("parameter", index);
        if (find_quantity(problem.model.inputs, parameter.name) == nullptr) {
            faults.push_back({key + ".name", "the model has no such input"});
        }
        if (!seen.insert(parameter.name).second) {
            faults.push_back({key + ".name", "is uncertain already: each input once"});
        }
        for (const std::string& other : parameter.also) {
            if (find_quantity(problem.model.inputs, other) == nullptr) {
                faults.push_back({key + ".also", "the model has no input " + other});
            }
            if (!seen.insert(other).second) {
                faults.push_back({key + ".also", other + " is uncertain already: each input once"});
            }
        }
        for (const DistributionFault& fault : check(parameter.distribution)) {
            faults.push_back({key + "." + std::string(fault.key), fault.message});
        }
    }
}

std::size_t index_of(const SensitivityStudy& study, const std::string& name) {
    return static_cast<std::size_t>(
        std::find_if(study.parameters.begin(), study.parameters.end(),
                     [&](const UncertainParameter& parameter) { return parameter.name == name; }) -
        study.parameters.begin());
}

// Every number of a described struct has to be finite and within its range.
template <Described Settings>
void check_ranges(const std::string& section, const Settings& settings, Faults& faults) {
    for_each_named_number(settings, [&](const std::string& path, const FieldInfo& info, auto value) {
        const auto number = static_cast<double>(value);
        if (!std::isfinite(number) || !info.range.contains(number)) {
            const std::string range = range_in_words(info.range);
            faults.push_back({section + "." + path, "must be " + (range.empty() ? "finite" : range)});
        }
    });
}

void check_pairs(const SensitivityStudy& study, Faults& faults) {
    std::set<std::pair<std::size_t, std::size_t>> seen;
    for (std::size_t index = 0; index < study.correlations.size(); ++index) {
        const ParameterCorrelation& correlation = study.correlations[index];
        const std::string key = numbered("correlation", index);
        check_ranges(key, correlation, faults);
        const std::size_t first = index_of(study, correlation.pair[0]);
        const std::size_t second = index_of(study, correlation.pair[1]);
        for (const std::string& name : correlation.pair) {
            if (index_of(study, name) == study.parameters.size()) {
                faults.push_back({key + ".between", name + " is not among the uncertain parameters"});
            }
        }
        if (first == second) {
            faults.push_back({key + ".between", "needs two different parameters"});
        } else if (!seen.insert(std::minmax(first, second)).second) {
            faults.push_back({key + ".between", "this pair has a correlation already"});
        }
    }
}

// Call this only if the parameters and pairs have no fault themselves.
void check_dependence(const SensitivityStudy& study, Faults& faults) {
    const InputSpace space = input_space(study);
    switch (space.check()) {
    case DependenceCheck::valid:
        return;
    case DependenceCheck::coefficient_out_of_reach:
        faults.push_back({numbered("correlation", space.faulty_correlation()) + ".coefficient",
                          "two parameters of these distributions can only have linear correlations between " +
                              number_in_words(space.reach().lower) + " and " + number_in_words(space.reach().upper)});
        return;
    case DependenceCheck::not_positive_definite:
        faults.push_back({numbered("correlation", study.correlations.size() - 1) + ".coefficient",
                          "the correlations contradict each other: their matrix is not positive definite"});
        return;
    }
}

void check_sweep(const SensitivityProblem& problem, Faults& faults) {
    const SweepSettings& settings = *problem.study.sweep;
    if (settings.points % 2 == 0) {
        faults.push_back({"sweep.points", "must be odd: the median, and as many on either side"});
    }
    constexpr int least_in_class = 8;
    if (settings.samples != 0 && !(settings.samples >= least_in_class * settings.points)) {
        faults.push_back({"sweep.samples",
                          "must be at least 8 for each point: " + std::to_string(least_in_class * settings.points)});
    }
    for (std::size_t index = 0; index < settings.further.size(); ++index) {
        const SweptQuantity& further = settings.further[index];
        const std::string key = numbered("sweep.quantity", index);
        if (find_quantity(problem.model.outputs, further.name) == nullptr) {
            faults.push_back({key + ".name", "the model does not answer this"});
        }
        const auto earlier = settings.further.begin() + static_cast<std::ptrdiff_t>(index);
        if (further.name == problem.study.quantity ||
            std::ranges::find(settings.further.begin(), earlier, further.name, &SweptQuantity::name) != earlier) {
            faults.push_back({key + ".name", "is swept already: each quantity once"});
        }
    }
}

void check_morris(const MorrisSettings& settings, Faults& faults) {
    if (settings.levels % 2 != 0) {
        faults.push_back({"morris.levels", "must be even: a step is half the levels"});
    }
}

void check_sobol_indices(const SobolIndicesSettings& settings, const SensitivityStudy& study, Faults& faults) {
    if (settings.samples > 0 && !std::has_single_bit(static_cast<unsigned>(settings.samples))) {
        faults.push_back({"sobol_indices.samples", "must be a power of 2"});
    }
    constexpr double most_evaluations = 2e7;  // all are kept in memory
    if (settings.samples * (static_cast<double>(study.parameters.size()) + 2) > most_evaluations) {
        faults.push_back({"sobol_indices.samples", "must be at most 2e7 / (number of parameters + 2)"});
    }
    if (!study.correlations.empty()) {
        faults.push_back({"sobol_indices",
                          "needs independent parameters, because shares of the variance do not add up "
                          "otherwise: remove this section or the correlations"});
    }
    if (study.parameters.size() > most_index_parameters) {
        faults.push_back({"sobol_indices", std::to_string(study.parameters.size()) +
                                               " uncertain parameters, at most 20: the sequence has 40 dimensions and "
                                               "needs two for each"});
    }
}

void check_propagation(const PropagationSettings& settings, std::size_t parameters, Faults& faults) {
    // Latin hypercubes keep their permutations in memory.
    constexpr double most_strata = 2e8;
    if (settings.method == SamplingMethod::latin_hypercube &&
        static_cast<double>(settings.samples) * static_cast<double>(parameters) > most_strata) {
        faults.push_back({"propagation.samples", "Latin hypercubes take at most 2e8 / (number of parameters) samples"});
    }
}

void check_reliability(const SensitivityStudy& study, Faults& faults) {
    if (!study.failure) {
        faults.push_back({"reliability", "needs [sensitivity.failure]: the limit whose distance is asked for"});
    }
}

}  // namespace

InputSpace input_space(const SensitivityStudy& study) {
    std::vector<Marginal> marginals;
    for (const UncertainParameter& parameter : study.parameters) {
        marginals.emplace_back(parameter.distribution);
    }
    std::vector<Correlation> correlations;
    for (const ParameterCorrelation& correlation : study.correlations) {
        correlations.push_back({index_of(study, correlation.pair[0]), index_of(study, correlation.pair[1]),
                                correlation.measure, correlation.coefficient});
    }
    return {std::move(marginals), correlations};
}

std::optional<FailureCriterion> criterion_of(const SensitivityProblem& problem) {
    std::optional<FailureCriterion> criterion = problem.study.failure;
    const auto output = place_of(problem.model.outputs, problem.study.quantity);
    if (!criterion || !output) {
        return criterion;
    }
    for (const OutputBound& bound : problem.model.bounds) {
        const std::optional<bool> failed = bound.output == *output ? criterion->failed(bound.within) : std::nullopt;
        if (failed && !criterion->decided(Evaluation{0, bound.failure})) {
            (*failed ? criterion->failing_words : criterion->standing_words).emplace_back(bound.failure);
        }
    }
    return criterion;
}

std::vector<StudyFault> check_study(const SensitivityProblem& problem) {
    const SensitivityStudy& study = problem.study;
    Faults faults;
    check_parameters(problem, faults);
    check_pairs(study, faults);
    if (faults.empty()) {
        check_dependence(study, faults);
    }
    if (find_quantity(problem.model.outputs, study.quantity) == nullptr) {
        faults.push_back({"quantity", "the model does not answer this"});
    }
    const auto check_section = [&](const char* section, const auto& settings) {
        if (settings) {
            check_ranges(section, *settings, faults);
        }
    };
    check_section("failure", study.failure);
    check_section("tornado", study.tornado);
    check_section("sweep", study.sweep);
    check_section("morris", study.morris);
    check_section("sobol_indices", study.sobol_indices);
    check_section("propagation", study.propagation);
    check_section("reliability", study.reliability);
    if (study.sweep) {
        check_sweep(problem, faults);
    }
    if (study.morris) {
        check_morris(*study.morris, faults);
    }
    if (study.sobol_indices) {
        check_sobol_indices(*study.sobol_indices, study, faults);
    }
    if (study.propagation) {
        check_propagation(*study.propagation, study.parameters.size(), faults);
    }
    if (study.reliability) {
        check_reliability(study, faults);
    }
    if (!study.tornado && !study.sweep && !study.morris && !study.sobol_indices && !study.propagation &&
        !study.reliability) {
        faults.push_back(
            {"",
             "asks for nothing: give at least one of [sensitivity.tornado], .sweep, .morris, .sobol_indices, "
             ".propagation, .reliability (empty for the standard settings)"});
    }
    if (problem.threads < 1) {
        faults.push_back({"", "threads must be >= 1"});
    }
    return faults;
}

}  // namespace delabole
