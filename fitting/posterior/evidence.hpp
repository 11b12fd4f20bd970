// Evidence for a mechanism: its likelihood averaged over the prior of its parameters (marginal likelihood),
//     Z = E[exp(-misfit / 2)],  the parameters drawn from the prior.
// Constants of the likelihood that all mechanisms share are left out, so only ratios of Z mean anything.
//
// Importance sampling gives it independently of the chains. Points are drawn from
//     q = 0.2 prior + 0.8 mixture of Student distributions fitted to the posterior's draws,
// and Z is the mean of exp(-misfit / 2) prior / q. If the draws are few or from another distribution, so that the
// weights are uneven, the mixture is first refitted to weighted pilot points; the weight of each is taken with the mean
// of all densities from which pilot points were drawn. The share of the prior in q keeps every weight below 5 times the
// greatest likelihood, so the estimate is unbiased and its variance finite even if the draws have missed a mode. The
// points are replicates of a randomly shifted Sobol sequence; the spread of the replicates gives the error. Below an
// effective size of a tenth of the points the error itself is uncertain, and the estimate is more often too low than
// too high.
// Sources: T. Hesterberg, Technometrics 37 (1995) 185-194; A. B. Owen & Y. Zhou, J. American Statistical Association
// 95 (2000) 135-143; J.-M. Cornuet, J.-M. Marin, A. Mira & C. P. Robert, Scandinavian J. Statistics 39 (2012) 798-812.
#pragma once

#include "fitting/posterior/posterior.hpp"

#include <span>

namespace delabole {

enum class EvidenceStatus {
    estimated,
    no_valid_point,  // no point has an answer, or all likelihoods are too small for a double: the evidence is 0
    interrupted,
};

struct Evidence {
    EvidenceStatus status = EvidenceStatus::no_valid_point;
    double log_evidence = 0;    // natural logarithm; -infinity where the status is no_valid_point
    double standard_error = 0;  // of log_evidence
    double least_misfit = 0;    // over all points
    double effective_size = 0;  // (sum of weights)^2 / sum of squared weights
    double failed_share = 0;    // probability of the prior where the model has no answer
    EvaluationCount evaluations;
};

// `draws` is any number of draws, even none, of the posterior or of a similar distribution; they affect the error and
// not the expected value. The parameters in the misfit's points are those of the prior, in SI. The result does not
// depend on the number of threads. Throws std::invalid_argument for settings outside their range and for more than
// most_parameters - 2 free parameters.
Evidence estimate_evidence(const Evaluator& misfit, const PriorSpace& prior, std::span<const Draw> draws,
                           const EvidenceSettings& settings);

}  // namespace delabole
