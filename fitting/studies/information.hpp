// Which next measurement is expected to tell most: preposterior analysis (H. Raiffa & R. Schlaifer, Applied statistical
// decision theory (1961), chapter 4) over draws of each mechanism's posterior.
//
// A candidate measures a quantity y(parameters) with a normal error of standard deviation s. From each draw k an
// outcome z = y_k + s e is simulated, e being standard normal. Given z the other draws have the weights exp(-(z -
// y_i)^2 / (2 s^2)) and so represent the posterior after the measurement. Averaged over outcomes this gives
//     expected reduction = 1 - mean over outcomes of (spread with weights) / (spread now)
// of the standard deviation and of the width of the 95 % interval of each parameter. The draw from which the outcome
// was simulated is left out: with it, a precise measurement would always find that draw again.
//
// An outcome z changes the probabilities p_m of the mechanisms to p_m f_m(z) / sum, f_m being the mean normal density
// of z over the draws of m. The expected information is the mean decrease of the entropy -sum p ln p, among the
// mechanisms that predict the quantity; the others do not predict the outcome.
//
// Accuracy: errors are standard errors; those of reductions come from the jackknife over chains, each left out together
// with its outcomes. If a measurement is so precise that few draws keep a weight (effective_draws), its reduction is
// less certain than that, because nothing smaller than the spacing of draws can be resolved.
#pragma once

#include "fitting/posterior/fit_problem.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

// The draws of a mechanism's posterior, with the values that each candidate would measure.
struct MechanismDraws {
    std::string name;
    double probability;                       // of the mechanism, given the data so far
    std::vector<std::string> parameters;      // the free ones
    std::vector<int> chain;                   // of each draw
    std::vector<std::vector<double>> values;  // of each parameter, of each draw, SI
    // For each candidate, its quantity at each draw, NaN where the model has no answer; empty where the mechanism does
    // not predict the quantity.
    std::vector<std::vector<double>> predicted;
};

// A share, with its standard error.
struct ExpectedReduction {
    double value = 0;
    double error = 0;
};

struct ParameterInformation {
    std::string parameter;
    ExpectedReduction standard_deviation;
    ExpectedReduction interval_95;
};

enum class InformationStatus {
    found,
    not_predicted,    // the mechanism does not predict the quantity
    few_answers,      // fewer than half of the draws have an answer
    few_draws_alike,  // under 50 draws keep a weight on average: the measurement is too precise for the draws
};

struct MechanismInformation {
    std::string mechanism;
    InformationStatus status = InformationStatus::not_predicted;
    double effective_draws = 0;                    // mean over outcomes
    double without_answer = 0;                     // share of the draws
    std::vector<ParameterInformation> parameters;  // empty unless found or few_draws_alike
};

struct CandidateInformation {
    std::string label;
    std::vector<MechanismInformation> mechanisms;
    // Reductions of each parameter, weighted by the probabilities of the mechanisms in which it is free. A mechanism
    // that does not predict the quantity contributes no reduction.
    std::vector<ParameterInformation> over_mechanisms;
    // Expected information about which mechanism was at work, nats; absent if fewer than two mechanisms predict the
    // quantity.
    std::optional<ExpectedReduction> about_mechanism;
};

struct InformationSettings {
    int outcomes = 128;  // simulated for each candidate and mechanism; >= 2
    std::uint64_t seed = 1;
    int threads = 1;  // the result does not depend on it
};

// The results are in the order of the candidates. Chains are numbered from 0; there are at least two, with equally many
// draws each. Throws std::invalid_argument for draws of inconsistent sizes.
std::vector<CandidateInformation> value_of_information(const std::vector<FitCandidate>& candidates,
                                                       const std::vector<MechanismDraws>& mechanisms,
                                                       const InformationSettings& settings);

}  // namespace delabole
