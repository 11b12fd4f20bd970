#include "fitting/back_analysis/check_problem.hpp"

#include "fitting/mechanism/mechanism_posterior.hpp"
#include "fitting/probability/dependence.hpp"
#include "fitting/work/words.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace delabole {

namespace {

using Faults = std::vector<std::string>;

void check_positive(const std::string& where, double standard_deviation, Faults& faults) {
    if (!(std::isfinite(standard_deviation) && standard_deviation > 0)) {
        faults.push_back(where + ": standard_deviation = " + number_in_words(standard_deviation) +
                         " must be finite and > 0");
    }
}

void check_finite(const std::string& where, const char* key, double value, Faults& faults) {
    if (!std::isfinite(value)) {
        faults.push_back(where + ": " + key + " = " + number_in_words(value) + " must be finite");
    }
}

void check_parameter(const std::string& where, const FreeParameter& parameter, const Quantity& input, Faults& faults) {
    check_finite(where, "lower", parameter.lower, faults);
    check_finite(where, "upper", parameter.upper, faults);
    const std::string lower = value_in_words(parameter.lower, input.dimension);
    const std::string upper = value_in_words(parameter.upper, input.dimension);
    if (parameter.lower > parameter.upper) {
        faults.push_back(where + ": lower = " + lower + " exceeds upper = " + upper);
    }
    // A bound may lie on an open end of the range: the model reports the failure of that one value.
    if (parameter.lower < input.range.lower || parameter.upper > input.range.upper) {
        faults.push_back(where + ": the bounds " + lower + " to " + upper + " leave the input's range " +
                         value_in_words(input.range.lower, input.dimension) + " to " +
                         value_in_words(input.range.upper, input.dimension));
    }
    if (parameter.prior) {
        check_finite(where + ", prior", "mean", parameter.prior->mean, faults);
        check_positive(where + ", prior", parameter.prior->standard_deviation, faults);
    }
}

void check_observation(const QuantityObservation& observation, Faults& faults) {
    const std::string where = "observation " + observation.label;
    check_finite(where, "value", observation.value, faults);
    check_positive(where, observation.standard_deviation, faults);
    std::set<std::string> seen;
    for (const Condition& condition : observation.conditions) {
        check_finite(where + ", condition " + condition.input, "value", condition.value, faults);
        if (!seen.insert(condition.input).second) {
            faults.push_back(where + ", condition " + condition.input + ": given twice");
        }
    }
}

// A datum given twice would count twice.
void check_observations(const std::vector<QuantityObservation>& observations, Faults& faults) {
    const auto what = [](const QuantityObservation& one) {
        std::set<std::pair<std::string, double>> conditions;
        for (const Condition& condition : one.conditions) {
            conditions.emplace(condition.input, condition.value);
        }
        return std::tuple(one.label, one.quantity, one.relation, conditions);
    };
    std::set<decltype(what(observations.front()))> seen;
    for (const QuantityObservation& observation : observations) {
        check_observation(observation, faults);
        if (!seen.insert(what(observation)).second) {
            faults.push_back("observation " + observation.label + ": given twice");
        }
    }
}

void check_coarse(const Mechanism& mechanism, Faults& faults) {
    if (!mechanism.coarse) {
        return;
    }
    if (!mechanism.model.costly) {
        faults.push_back(mechanism.name + ": a coarse model is for costly ones only");
    }
    const auto names_differ = [](const std::vector<Quantity>& left, const std::vector<Quantity>& right) {
        return !std::ranges::equal(left, right, {}, &Quantity::name, &Quantity::name);
    };
    if (names_differ(mechanism.coarse->inputs, mechanism.model.inputs) ||
        names_differ(mechanism.coarse->outputs, mechanism.model.outputs)) {
        faults.push_back(mechanism.name + ": the coarse model has other inputs or outputs");
    }
}

void check_mechanism(const Mechanism& mechanism, Faults& faults) {
    if (!mechanism.model.predict) {
        faults.push_back(mechanism.name + ": the model cannot predict");
    }
    if (mechanism.parameters.size() > 40) {
        faults.push_back(mechanism.name + ": " + std::to_string(mechanism.parameters.size()) +
                         " free parameters, at most 40");
    }
    std::set<std::string> seen;
    for (const FreeParameter& parameter : mechanism.parameters) {
        const std::string where = mechanism.name + ", parameter " + parameter.name;
        const Quantity* input = find_quantity(mechanism.model.inputs, parameter.name);
        if (!seen.insert(parameter.name).second) {
            faults.push_back(where + ": given twice");
        } else if (input == nullptr) {
            faults.push_back(where + ": the model has no such input");
        } else {
            check_parameter(where, parameter, *input, faults);
            for (const std::string& name : parameter.also) {
                const Quantity* other = find_quantity(mechanism.model.inputs, name);
                std::string fault = where;
                fault += ", also ";
                fault += name;
                if (other == nullptr) {
                    fault += ": the model has no such input";
                } else if (!seen.insert(name).second) {
                    fault += ": given twice";
                } else if (other->dimension != input->dimension) {
                    fault += ": has another dimension";
                } else {
                    continue;
                }
                faults.push_back(std::move(fault));
            }
        }
    }
    check_coarse(mechanism, faults);
    check_observations(mechanism.own_observations, faults);
}

// A mechanism's own observation takes the place of the one with its label.
void check_own_labels(const Mechanism& mechanism, const std::vector<QuantityObservation>& observations,
                      Faults& faults) {
    for (const QuantityObservation& own : mechanism.own_observations) {
        const auto with_its_label = [&](const std::vector<QuantityObservation>& all) {
            return std::ranges::count(all, own.label, &QuantityObservation::label);
        };
        if (with_its_label(mechanism.own_observations) > 1 || with_its_label(observations) > 1) {
            faults.push_back(mechanism.name + ", observation " + own.label +
                             ": its label belongs to more than one observation");
        }
    }
}

void check_profile(const ProfileObservation& profile, Faults& faults) {
    check_positive("profile", profile.standard_deviation, faults);
    for (const Point& point : profile.profile) {
        if (!point.allFinite()) {
            faults.push_back("profile: coordinates must be finite");
            return;
        }
    }
    if (!(length(profile.profile) > 0)) {
        faults.push_back("profile: needs at least two distinct points");
    }
}

template <Described Settings>
void check_ranges(const std::string& where, const Settings& settings, Faults& faults) {
    for_each_named_number(settings, [&](const std::string& path, const FieldInfo& info, auto value) {
        const auto number = static_cast<double>(value);
        if (!info.range.contains(number)) {
            faults.push_back(where + ": " + path + " = " + number_in_words(number) + " must be " +
                             range_in_words(info.range));
        }
    });
}

// Checks the priors as given and as each variant of the evidence changes them.
void check_priors(const FitProblem& problem, Faults& faults) {
    for (const EvidenceVariant variant : variants_of(problem)) {
        for (const Mechanism& mechanism : varied(problem, variant).mechanisms) {
            for (const FreeParameter& parameter : mechanism.parameters) {
                const std::string fault = fault_of_prior(parameter);
                if (!fault.empty()) {
                    faults.push_back(
                        mechanism.name + ", parameter " + parameter.name + ": " + fault +
                        (variant == EvidenceVariant::as_given ? "" : ", with " + std::string(word_of(variant))));
                }
            }
        }
        if (!faults.empty()) {
            return;
        }
    }
}

void check_posterior(const FitProblem& problem, Faults& faults) {
    const PosteriorStudy& study = *problem.posterior;
    check_ranges("posterior", study, faults);
    if (study.draws < draws_per_chain * study.chains) {
        faults.push_back("posterior: draws = " + std::to_string(study.draws) + " must be at least " +
                         std::to_string(draws_per_chain * study.chains));
    }
    for (const Mechanism& mechanism : problem.mechanisms) {
        // The evidence needs two coordinates of the Sobol sequence for the choice among distributions and for their
        // tails.
        if (mechanism.parameters.size() + 2 > most_parameters) {
            faults.push_back(mechanism.name + ": " + std::to_string(mechanism.parameters.size()) +
                             " free parameters, at most 38 with a posterior");
        }
    }
    check_priors(problem, faults);
}

}  // namespace

std::vector<std::string> check_problem(const FitProblem& problem) {
    Faults faults;
    for (const Mechanism& mechanism : problem.mechanisms) {
        check_mechanism(mechanism, faults);
    }
    check_observations(problem.observations, faults);
    for (const Mechanism& mechanism : problem.mechanisms) {
        check_own_labels(mechanism, problem.observations, faults);
    }
    if (problem.profile) {
        check_profile(*problem.profile, faults);
    }
    check_ranges("settings", problem.settings, faults);
    if (problem.settings.threads < 1) {
        faults.push_back("settings: threads = " + std::to_string(problem.settings.threads) + " must be at least 1");
    }
    if (const SurrogateSettings& surrogate = problem.settings.surrogate;
        surrogate.first_runs && *surrogate.first_runs > surrogate.runs) {
        faults.push_back("settings: surrogate.first_runs = " + std::to_string(*surrogate.first_runs) +
                         " must be at most surrogate.runs = " + std::to_string(surrogate.runs));
    }
    if (problem.posterior && faults.empty()) {
        check_posterior(problem, faults);
    }
    return faults;
}

}  // namespace delabole
