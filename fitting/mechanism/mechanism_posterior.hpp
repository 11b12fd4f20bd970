// Posterior and evidence of one mechanism of a back-analysis, and how the evidence hangs on what was put in.
//
// A datum or a piece of field evidence about which the mechanism says nothing counts as missed by two standard
// deviations, a factor exp(-2), else a mechanism would gain by predicting less.
#pragma once

#include "fitting/posterior/evidence.hpp"
#include "fitting/posterior/fit_problem.hpp"
#include "fitting/posterior/posterior.hpp"
#include "geometry/polyline.hpp"

#include <string>
#include <vector>

namespace delabole {

struct CostlyRuns;  // fitting/mechanism/costly_runs.hpp

// The part of the problem that is changed while all else stays as given.
enum class EvidenceVariant {
    as_given,
    priors_halved,  // standard deviations of all priors
    priors_doubled,
    priors_flat,        // between the bounds
    prior_means_lower,  // all by one standard deviation
    prior_means_higher,
    model_error_halved,  // standard deviations of observed factors of safety
    model_error_doubled,
};

struct VariantEvidence {
    EvidenceVariant variant = EvidenceVariant::as_given;
    Evidence evidence;
};

struct MechanismPosterior {
    Posterior posterior;
    std::vector<VariantEvidence> evidences;  // as given first; only variants that change anything
    int missing_data = 0;                    // about which the mechanism says nothing, a profile counting its vertices
    int missing_field_evidence = 0;          // likewise; the caller's to say, by what the best point shows
    double least_misfit = 0;                 // of the data, over all points evaluated; infinite where none was valid
    std::vector<Polyline> profiles;          // predicted at up to 200 draws; empty where none is predicted
    std::vector<std::string> warnings;       // sentences: priors against the observations, too many parameters, ...

    const Evidence& evidence() const { return evidences.front().evidence; }
    // Logarithms of the evidence, with the data that are missing counted as missed.
    double log_evidence(const Evidence& of, bool with_field_evidence) const {
        return of.log_evidence - 2 * (missing_data + (with_field_evidence ? missing_field_evidence : 0));
    }
    double log_evidence() const { return log_evidence(evidence(), true); }
    // Share of the prior that the data leave, as a logarithm: evidence over greatest likelihood.
    double log_occam_factor() const { return evidence().log_evidence + least_misfit / 2; }
};

// The variants that change anything in this problem, as_given first.
std::vector<EvidenceVariant> variants_of(const FitProblem& problem);
// The problem with that change made.
FitProblem varied(const FitProblem& problem, EvidenceVariant variant);

// The posterior of the mechanism of that index; the problem has to ask for a posterior and to have passed
// check_problem. A costly mechanism comes with the runs that were made of it: its surrogate, error included, takes the
// model's place. The result does not depend on the number of threads.
MechanismPosterior study_posterior(const FitProblem& problem, std::size_t mechanism, const CostlyRuns* costly,
                                   ProgressMeter& progress, StopFlag stop = nullptr);

// Evaluations to expect, for the progress report only.
long expected_posterior_evaluations(const FitProblem& problem, std::size_t mechanism);

}  // namespace delabole
