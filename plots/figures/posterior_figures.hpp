// The figures of posteriors and evidences. Mechanisms without a posterior are left out.
#pragma once

#include "fitting/mechanism/fit_result.hpp"
#include "plots/drawing/figure.hpp"

#include <optional>
#include <string>

namespace delabole {

// "flat priors", "half the model error".
std::string variant_in_words(EvidenceVariant variant);

// What the logarithm of each mechanism's evidence is made of, as bars to the left of 0, the shortest on top: misfit of
// the best point, share of the prior that the data leave, data and field evidence about which it says nothing; the 95 %
// interval of the sum where it can be seen.
std::optional<Figure> evidence_figure(const FitResult& result);

// Logarithm of each mechanism's evidence, field evidence included, with priors and model error changed.
std::optional<Figure> evidence_dependence_figure(const FitResult& result);

// The greatest R-hat of each mechanism's parameters over the length of its chains, with the limit.
std::optional<Figure> chain_agreement_figure(const FitResult& result);

// Median and 95 % interval of each parameter from the first steps of all chains, less the final median and in final
// standard deviations.
std::optional<Figure> running_quantiles_figure(const MechanismFit& fit);

// Each parameter's distribution over its prior on the diagonal, below it the 68 and 95 % regions of each pair over the
// loci of factor of safety 1, with the best point. One panel for each; at most the first six free parameters.
std::optional<Figure> posterior_corner_figure(const MechanismFit& fit);

}  // namespace delabole
