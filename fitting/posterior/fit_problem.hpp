// A back-analysis: what was observed, which mechanisms may explain it, and what is free in each.
//
// The objective of one mechanism is
//     misfit(p) = sum over observations ((predicted - observed) / standard deviation)^2
//               + sum over priors ((p - mean) / standard deviation)^2
// in natural units of chi-square. An inequality adds its square only where it is broken. A profile adds (number of its
// vertices) times the mean square of distance / standard deviation over profile_samples points spaced equally along the
// observed line, the distance being that to the nearest point of the predicted line.
#pragma once

#include "fitting/posterior/posterior_settings.hpp"
#include "fitting/search/algorithm.hpp"
#include "geometry/polyline.hpp"
#include "parameters/model_interface.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace delabole {

class Ranks;

// Normal, cut off at the parameter's bounds.
struct Prior {
    double mean;
    double standard_deviation;  // > 0
    std::string source;
};

struct FreeParameter {
    std::string name;  // an input of the mechanism's model
    double lower;      // lower == upper fixes the parameter
    double upper;
    std::optional<Prior> prior;
    std::vector<std::string> also = {};  // further inputs that take the same value, as two points of a water table
};

enum class Relation { equal, at_least, at_most };

constexpr std::array<std::string_view, 3> enum_names(Relation) {
    return {"equal", "at_least", "at_most"};
}

// Value that an input had when the observation was made, where it differs from the mechanism's (for example the water
// level on the day the slope still stood). Overrides a free parameter of the same name.
struct Condition {
    std::string input;
    double value;
};

struct QuantityObservation {
    std::string label;
    std::string quantity;  // an output of the model; a mechanism without that output leaves the observation unexplained
    Relation relation = Relation::equal;
    double value;
    double standard_deviation;  // > 0; of measurement, or of the model for a factor of safety at failure
    std::vector<Condition> conditions;
    std::string source;
};

struct ProfileObservation {
    Polyline profile;           // at least two distinct points, from the toe into the slope, same axes as the model
    double standard_deviation;  // m, > 0
    std::string source;
};

// Evidence without a number, such as "crest_block_rotation": a mechanism explains it or it does not.
struct FieldEvidence {
    std::string name;
    std::string statement;
    std::string source;
};

// What a prediction at the best point must be like to show a piece of field evidence.
struct EvidenceSign {
    std::string evidence;  // its name
    std::string quantity;  // an output of the mechanism
    Relation relation;     // at_least or at_most
    double value;
};

// A measurement that could be made next: how much it would tell is asked before it is paid for.
struct FitCandidate {
    std::string label;
    // Outputs or inputs of models: what is measured may have one name in one mechanism, another in the next. The first
    // that a mechanism has counts; one that has none learns nothing.
    std::vector<std::string> quantities;
    double standard_deviation;          // > 0; of the measurement
    std::vector<Condition> conditions;  // under which an output would be measured
    std::optional<double> cost;         // > 0, in any unit that the candidates share
    std::string source;
};

// That these mechanisms explain the failure: their probabilities together.
struct ClaimOfMechanisms {
    std::vector<std::string> mechanisms;
};

// Of an output of one mechanism.
struct ClaimOfQuantity {
    std::string mechanism;
    std::string quantity;
    std::vector<Condition> conditions;  // that make it differ from what was fitted
    std::optional<std::vector<Condition>>
        against;  // what is claimed is then by how much it exceeds its value under these
};

struct ConclusionTest {
    std::string claim;  // in words
    std::variant<ClaimOfMechanisms, ClaimOfQuantity> of;
    Relation relation;    // at_least or at_most
    double limit;         // of the probability, the quantity or the difference
    Dimension dimension;  // of that
};

// What others concluded of the failure, to be held against what the back-analysis finds.
struct Conclusion {
    std::string label;  // "(i)"
    std::string statement;
    std::vector<ConclusionTest> tests;  // empty: no mechanism has a say
    std::string source;
    std::string note;
};

struct Mechanism {
    std::string name;
    std::string title;
    ModelInterface model;
    std::vector<FreeParameter> parameters;
    // What is observed of all mechanisms, by the same label, in terms of an output that this one has: "it failed" is a
    // factor of safety of one and a failed area of half the slope.
    std::vector<QuantityObservation> own_observations = {};
    std::vector<EvidenceSign> signs = {};  // of field evidence; every sign of a name has to hold
    // Of a costly one: cheaper and less exact, with the same inputs and outputs. It says where runs would be wasted.
    std::optional<ModelInterface> coarse = {};
};

// Points along an observed profile at which its distance from the predicted one is taken.
inline constexpr std::size_t profile_samples = 50;

// Of mechanisms whose model is costly: they are fitted through a surrogate made of runs (surrogate.hpp).
struct SurrogateSettings {
    int runs = 120;                 // at most, >= 12
    std::optional<int> first_runs;  // before the surrogate has a say in where to run, >= 12; absent: 10 per parameter
    double tolerance = 0.1;         // of the relative error of the evidence: fewer runs if it is met, in (0, 1)
    // No more runs once its evidence, with twice its error, is less than this share of the best that a mechanism of
    // another kind has: cheap mechanisms prune costly ones. In [0, 1); 0: never.
    double give_up_below = 1e-3;
};

struct FitSettings {
    Algorithm algorithm = Algorithm::sbplx;
    int starts = 16;                   // local runs: from the prior means, then from a Sobol sequence; >= 1. A global
                                       // algorithm makes one run with the evaluations of all of them
    int evaluations_per_start = 400;   // own cap, whatever the algorithm's, >= 10; a quarter is kept for the polish
    double relative_tolerance = 1e-8;  // stop when parameters, scaled by their bounds, move less than this; > 0
    int profile_points = 41;           // points of each profile likelihood, >= 5
    int map_points = 61;               // points along each side of the misfit map, >= 5
    std::uint64_t seed = 1;            // of the algorithms that use chance (crs2, mlsl, isres)
    SurrogateSettings surrogate = {};
    int threads = 1;               // >= 1; the result does not depend on it
    const Ranks* ranks = nullptr;  // nor on these; null: this process alone
};

struct FitProblem {
    std::vector<Mechanism> mechanisms;
    std::vector<QuantityObservation> observations;
    std::optional<ProfileObservation> profile;
    std::vector<FieldEvidence> evidence;
    std::vector<FitCandidate> candidates;
    std::vector<Conclusion> conclusions;
    FitSettings settings;
    std::optional<PosteriorStudy> posterior;  // absent: neither posteriors nor evidences
};

}  // namespace delabole
