// Which next measurement would tell most: preposterior analysis (H. Raiffa & R. Schlaifer, Applied statistical decision
// theory (1961), chapter 4) over draws of each mechanism's posterior.
//
// A candidate measures a quantity y(parameters) with a normal error of standard deviation s. From a draw k an outcome
// z = y_k + s e is simulated, e being standard normal. Given z the other draws have the weights
// exp(-(z - y_i)^2 / (2 s^2)), and with them the posterior as it would be. Averaged over outcomes this gives
//     expected reduction = 1 - mean over outcomes of (spread with weights) / (spread now)
// of the standard deviation and of the width of the 95 % interval of each parameter. The draw that made the outcome is
// left out: with it, a sharp measurement would always find its own truth again.
//
// An outcome z turns the probabilities p_m of the mechanisms into p_m f_m(z) / sum, f_m being the mean of
// the normal density of z over the draws of m. The expected information is the mean fall of the entropy
// -sum p ln p, among the mechanisms that predict the quantity; the others say nothing about the outcome.
//
// Accuracy: errors are standard errors, for reductions by the jackknife over chains, each taken out with its outcomes.
// Where a measurement is so sharp that few draws keep a weight (effective_draws), its reduction is uncertain beyond
// that: no more than the spacing of draws can be resolved.
#pragma once

#include "fitting/posterior/fit_problem.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace delabole {

// The draws of a mechanism's posterior, with what measurements of it would read.
struct MechanismDraws {
    std::string name;
    double probability;                       // of the mechanism, given the data so far
    std::vector<std::string> parameters;      // free ones
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
    not_predicted,    // the mechanism says nothing about the quantity
    few_answers,      // under half of the draws have an answer
    few_draws_alike,  // under 50 draws keep a weight, on average: sharper than the draws can tell
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
    // Gain of each parameter, weighted by the probabilities of the mechanisms in which it is free; one that says
    // nothing about the quantity gains nothing.
    std::vector<ParameterInformation> over_mechanisms;
    // About which mechanism it was, nats; absent where fewer than two predict the quantity.
    std::optional<ExpectedReduction> about_mechanism;
};

struct InformationSettings {
    int outcomes = 128;  // simulated for each candidate and mechanism; >= 2
    std::uint64_t seed = 1;
    int threads = 1;  // the result does not depend on it
};

// Results in the order of the candidates. Chains are numbered from 0, at least two of them with as many draws each.
// Throws std::invalid_argument for draws that do not fit together.
std::vector<CandidateInformation> value_of_information(const std::vector<FitCandidate>& candidates,
                                                       const std::vector<MechanismDraws>& mechanisms,
                                                       const InformationSettings& settings);

}  // namespace delabole
