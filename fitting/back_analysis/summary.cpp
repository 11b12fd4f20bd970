#include "fitting/back_analysis/steps.hpp"

#include "fitting/work/words.hpp"

#include <cmath>
#include <limits>

namespace delabole {

namespace {

constexpr double large_residual = 2;
constexpr double score_of_silence = large_residual * large_residual;

// The sign of the evidence that the prediction contradicts, with its value; empty if the prediction shows the sign.
std::string contradiction(const EvidenceSign& sign, const Misfit& misfit, const Prediction& prediction) {
    const auto output = misfit.output(sign.quantity);
    if (!output || *output >= prediction.outputs.size()) {
        return sign.quantity + " has no value";
    }
    const double value = prediction.outputs[*output];
    if (sign.relation == Relation::at_least ? value >= sign.value : value <= sign.value) {
        return {};
    }
    return sign.quantity + " is " + value_in_words(value, misfit.mechanism().model.outputs[*output].dimension);
}

// A mechanism explains a piece of evidence if its prediction shows every sign given for it, and in no other case.
void sort_evidence(const Misfit& misfit, MechanismFit& fit) {
    for (const FieldEvidence& evidence : misfit.problem().evidence) {
        std::string why_not = "the mechanism predicts nothing of the kind";
        for (const EvidenceSign& sign : misfit.mechanism().signs) {
            if (sign.evidence == evidence.name) {
                why_not = contradiction(sign, misfit, fit.prediction);
                if (!why_not.empty()) {
                    break;
                }
            }
        }
        if (why_not.empty()) {
            fit.explained.push_back(evidence.name);
        } else {
            fit.unexplained.push_back(evidence.name + " (" + evidence.statement + "): " + why_not);
        }
    }
}

std::string miss_in_words(const ObservationFit& row) {
    const char* relation = row.relation == Relation::equal      ? ""
                           : row.relation == Relation::at_least ? "at least "
                                                                : "at most ";
    return row.label + ": predicted " + value_in_words(*row.predicted, row.dimension) + ", observed " + relation +
           value_in_words(row.observed, row.dimension) + ", " + number_in_words(std::abs(row.residual)) +
           " standard deviations away";
}

void add_misses(MechanismFit& fit) {
    for (const ObservationFit& row : fit.observations) {
        if (row.predicted && std::abs(row.residual) > large_residual) {
            fit.unexplained.push_back(miss_in_words(row));
        }
    }
    if (fit.profile_fit && fit.profile_fit->residual() > large_residual) {
        fit.unexplained.push_back("post-failure profile: " + value_in_words(fit.profile_fit->rms, Dimension::length) +
                                  " root mean square distance, " + number_in_words(fit.profile_fit->residual()) +
                                  " standard deviations of " +
                                  value_in_words(fit.profile_fit->standard_deviation, Dimension::length));
    }
}

// A fitted value far outside its prior is reported as unexplained: the mechanism needs a value that was not expected.
void add_prior_conflicts(MechanismFit& fit) {
    for (std::size_t index = 0; index < fit.best.size(); ++index) {
        const FreeParameter& parameter = fit.parameters[index];
        if (!parameter.prior) {
            continue;
        }
        const double residual = (fit.best[index] - parameter.prior->mean) / parameter.prior->standard_deviation;
        if (std::abs(residual) > large_residual) {
            fit.unexplained.push_back(parameter.name + ": needs " +
                                      value_in_words(fit.best[index], fit.dimensions[index]) + ", " +
                                      number_in_words(std::abs(residual)) + " standard deviations from its prior of " +
                                      value_in_words(parameter.prior->mean, fit.dimensions[index]));
        }
    }
}

}  // namespace

void summarise(const Misfit& misfit, const Surrogate* surrogate, bool found, MechanismFit& fit) {
    if (found) {
        fit.prediction = misfit.predict(fit.best);
    }
    sort_evidence(misfit, fit);
    const double silent = static_cast<double>(fit.unexplained.size()) + misfit.missing_count();
    for (std::string& sentence : misfit.not_compared()) {
        fit.unexplained.push_back(std::move(sentence));
    }
    fit.data_count = misfit.data_count();
    if (!found) {
        fit.misfit = fit.data_misfit = fit.ranking_score = std::numeric_limits<double>::infinity();
        return;
    }
    const MisfitParts parts = misfit.parts(fit.best);
    fit.data_misfit = parts.data;
    if (surrogate != nullptr) {
        constexpr double none = std::numeric_limits<double>::infinity();
        fit.surrogate->misfit_of_run = parts.failure.empty() ? parts.data : none;
        fit.data_misfit = surrogate->value(fit.best, Priors::ignored).value;
    }
    fit.prior_misfit = parts.prior;
    fit.misfit = fit.data_misfit + fit.prior_misfit;
    fit.ranking_score = fit.misfit + score_of_silence * silent - 2 * misfit.log_own_precision();
    fit.observations = misfit.compare(fit.best);
    fit.profile_fit = misfit.compare_profile(fit.best);
    fit.scatter_cost = misfit.scatter_cost(fit.best);
    add_misses(fit);
    add_prior_conflicts(fit);
}

}  // namespace delabole
