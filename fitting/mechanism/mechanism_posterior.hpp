// Posterior and evidence of one mechanism of a back-analysis, and how far the evidence depends on the assumptions.
//
// A datum or a piece of field evidence that the mechanism does not predict counts as missed by two standard deviations,
// a factor exp(-2); otherwise a mechanism would gain by predicting less.
#pragma once

#include "fitting/posterior/evidence.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/posterior/posterior.hpp"
#include "geometry/polyline.hpp"

#include <string>
#include <vector>

namespace delabole {

struct CostlyRuns;  // fitting/mechanism/costly_runs.hpp

// The assumption that is changed while everything else stays as given.
enum class EvidenceVariant {
    as_given,
    priors_halved,  // standard deviations of all priors halved
    priors_doubled,
    priors_flat,        // uniform between the bounds
    prior_means_lower,  // all lower by one standard deviation
    prior_means_higher,
    model_error_halved,  // standard deviations of observed factors of safety halved
    model_error_doubled,
};

struct VariantEvidence {
    EvidenceVariant variant = EvidenceVariant::as_given;
    Evidence evidence;
};

struct MechanismPosterior {
    Posterior posterior;
    std::vector<VariantEvidence> evidences;  // as given first, then the variants that change something
    int missing_data = 0;               // number of data not predicted; a profile counts with its number of vertices
    double log_own_precision = 0;       // of Misfit
    int missing_field_evidence = 0;     // number of pieces not predicted; set by the caller from the best point
    double least_misfit = 0;            // of the data, over all points evaluated; infinite if none was valid
    std::vector<Polyline> profiles;     // predicted at up to 200 draws; empty if none is predicted
    std::vector<std::string> warnings;  // sentences: priors against the observations, too many parameters, ...

    const Evidence& evidence() const { return evidences.front().evidence; }
    // Natural logarithm of the evidence, with missing data counted as missed.
    double log_evidence(const Evidence& of, bool with_field_evidence) const {
        return of.log_evidence + log_own_precision -
               2 * (missing_data + (with_field_evidence ? missing_field_evidence : 0));
    }
    double log_evidence() const { return log_evidence(evidence(), true); }
    // Logarithm of the share of the prior that the data leave: evidence over greatest likelihood.
    double log_occam_factor() const { return evidence().log_evidence + least_misfit / 2; }
};

// The variants that change something in this problem, as_given first.
std::vector<EvidenceVariant> variants_of(const FitProblem& problem);
// The problem after the change of that variant.
FitProblem varied(const FitProblem& problem, EvidenceVariant variant);

// The posterior of the mechanism of that index. The problem has to ask for a posterior and to have passed
// check_problem. For a costly mechanism its runs are given, and their surrogate, with its error, replaces the model.
// The result does not depend on the number of threads.
MechanismPosterior study_posterior(const FitProblem& problem, std::size_t mechanism, const CostlyRuns* costly,
                                   ProgressMeter& progress, StopFlag stop = nullptr);

// Number of evaluations to expect, used only for the progress report.
long expected_posterior_evaluations(const FitProblem& problem, std::size_t mechanism);

}  // namespace delabole
