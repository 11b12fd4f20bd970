// A back-analysis: what was observed, which mechanisms may explain it, and which inputs of each are free.
//
// The objective of one mechanism is
//     misfit(p) = sum over observations ((predicted - observed) / standard deviation)^2
//               + sum over priors ((p - mean) / standard deviation)^2
// in natural units of chi-square. An inequality adds its square only if it is violated. A profile adds (number of its
// vertices) times the mean square of distance / standard deviation over profile_samples equally spaced points along the
// observed line, the distance being that to the nearest point of the predicted line.
#pragma once

#include "fitting/posterior/posterior_settings.hpp"
#include "fitting/search/algorithm.hpp"
#include "geometry/polyline.hpp"
#include "parameters/model_interface.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace delabole {

class Ranks;

// A normal distribution, cut off at the parameter's bounds.
struct Prior {
    double mean;
    double standard_deviation;  // > 0
    std::string source;
    static constexpr bool written_in_line = true;
    static constexpr auto fields() {
        return FieldTable{
            number<&Prior::mean>(Dimension::named, "mean of the prior"),
            number<&Prior::standard_deviation>(Dimension::named, more_than(0), "standard deviation of the prior"),
            with_default(section<&Prior::source>("where the prior comes from")),
        };
    }
};

struct FreeParameter {
    std::string name;
    double lower;  // lower == upper fixes the parameter
    double upper;
    std::optional<Prior> prior;
    std::vector<std::string> also = {};  // further inputs with the same value, such as two points of a water table
    Dimension dimension = Dimension::ratio;
    static constexpr auto fields() {
        using P = FreeParameter;
        return FieldTable{
            refers_to(NameOf::input, section<&P::name>("the input that is free, e.g. strength.friction_angle")),
            number<&P::lower>(Dimension::named, "lower bound"),
            number<&P::upper>(Dimension::named, "upper bound"),
            section<&P::prior>("what is known beforehand"),
            refers_to(NameOf::input, section<&P::also>("further inputs that take the same value")),
        };
    }
};

enum class Relation { equal, at_least, at_most };

struct QuantityObservation {
    std::string label;
    std::string quantity;  // a mechanism without this output leaves the observation unexplained
    Relation relation = Relation::equal;
    double value;
    double standard_deviation;  // > 0; of the measurement, or of the model for a factor of safety at failure
    // Values that inputs had when the observation was made, if they differ from the mechanism's (for example the water
    // level on the day when the slope still stood). They override free parameters of the same name.
    std::vector<Condition> conditions;
    std::string source;
    Dimension dimension = Dimension::ratio;
    static constexpr auto fields() {
        return FieldTable{
            section<&QuantityObservation::label>("what was observed, in a few words"),
            refers_to(NameOf::output, section<&QuantityObservation::quantity>("name of an output of the model")),
            with_default(section<&QuantityObservation::relation>("how the quantity compares with the value")),
            number<&QuantityObservation::value>(Dimension::named, "the observed value"),
            number<&QuantityObservation::standard_deviation>(Dimension::named, more_than(0),
                                                             "standard deviation of the observation, or of the model"),
            section("with", &QuantityObservation::conditions, "inputs that differed"),
            with_default(section<&QuantityObservation::source>("where the observation comes from")),
        };
    }
};

struct ProfileObservation {
    Polyline profile;           // in the coordinates of the model
    double standard_deviation;  // m, > 0
    std::string source;
    static constexpr auto fields() {
        return FieldTable{
            number("points", &ProfileObservation::profile, Dimension::length, any_number(),
                   "the ground after the failure, from the toe into the slope"),
            number<&ProfileObservation::standard_deviation>(Dimension::length, more_than(0),
                                                            "standard deviation of the distance from the profile"),
            with_default(section<&ProfileObservation::source>("where the profile comes from")),
        };
    }
};

// Evidence without a number, such as "crest_block_rotation", which a mechanism either explains or does not.
struct FieldEvidence {
    std::string name;
    std::string statement;
    std::string source;
    static constexpr auto fields() {
        return FieldTable{
            section<&FieldEvidence::name>("a short name, e.g. crest_block_rotation"),
            section<&FieldEvidence::statement>("what was seen"),
            with_default(section<&FieldEvidence::source>("who saw it")),
        };
    }
};

// The prediction at the best point shows a piece of field evidence if an output is at least, or at most, a value.
struct EvidenceSign {
    std::string evidence;
    std::string quantity;
    Relation relation = Relation::at_least;  // or at_most
    double value;
    Dimension dimension = Dimension::ratio;
    static constexpr auto fields() {
        return FieldTable{
            section<&EvidenceSign::evidence>("name of a [[fit.evidence]]"),
            refers_to(NameOf::output, section<&EvidenceSign::quantity>("name of an output of the mechanism")),
            with_default(section<&EvidenceSign::relation>("how the quantity compares with the value")),
            number<&EvidenceSign::value>(Dimension::named, "limit of the quantity"),
        };
    }
};

// A measurement that could be made next; the expected information is computed before it is paid for.
struct FitCandidate {
    std::string label;
    // Mechanisms may give the measured quantity different names. The first name that a mechanism has is used; a
    // mechanism that has none of them learns nothing.
    std::vector<std::string> quantities;
    double standard_deviation;  // > 0
    std::vector<Condition> conditions;
    std::optional<double> cost;
    std::string source;
    Dimension dimension = Dimension::ratio;
    static constexpr auto fields() {
        using C = FitCandidate;
        return FieldTable{
            section<&C::label>("what could be measured, in a few words"),
            refers_to(NameOf::measurable,
                      section("quantity", &C::quantities,
                              "name of an output or an input of the model, or a list of such names")),
            number<&C::standard_deviation>(Dimension::named, more_than(0), "standard deviation of the measurement"),
            section("with", &C::conditions, "inputs under which an output would be measured"),
            number<&C::cost>(more_than(0), "in any unit that the candidates share"),
            with_default(section<&C::source>("where cost and accuracy come from")),
        };
    }
};

// The claim that the given mechanisms explain the failure, tested by the sum of their probabilities.
struct ClaimOfMechanisms {
    std::vector<std::string> mechanisms;
    static constexpr auto fields() {
        return FieldTable{refers_to(NameOf::mechanism, section("probability_of", &ClaimOfMechanisms::mechanisms,
                                                               "mechanisms whose probabilities count together"))};
    }
};

// A claim about an output of one mechanism.
struct ClaimOfQuantity {
    std::string mechanism;
    std::string quantity;
    std::vector<Condition> conditions;  // inputs that differ from what was fitted
    std::optional<std::vector<Condition>>
        against;  // the claim is then about the increase over the value under these conditions
    static constexpr auto fields() {
        return FieldTable{
            refers_to(NameOf::mechanism,
                      section<&ClaimOfQuantity::mechanism>("name of the mechanism that is asked, or probability_of")),
            refers_to(NameOf::output, section<&ClaimOfQuantity::quantity>("name of an output of the mechanism")),
            section("with", &ClaimOfQuantity::conditions, "inputs that differ from what was fitted"),
            section("compared_with", &ClaimOfQuantity::against, "inputs of the prediction that it is compared with"),
        };
    }
};

struct ConclusionTest {
    std::string claim;
    std::variant<ClaimOfMechanisms, ClaimOfQuantity> of;
    Relation relation = Relation::at_least;  // or at_most
    double limit;                            // of the probability, the quantity or the difference
    Dimension dimension = Dimension::ratio;  // of the limit
    static constexpr auto fields() {
        return FieldTable{
            section<&ConclusionTest::claim>("what is claimed, in words"),
            inlined(&ConclusionTest::of, "what the claim is about"),
            with_default(section<&ConclusionTest::relation>("how what is claimed compares with the value")),
            number("value", &ConclusionTest::limit, Dimension::named, any_number(), "limit of what is claimed"),
        };
    }
};

// A conclusion that others drew from the failure, to be tested against the back-analysis.
struct Conclusion {
    std::string label;
    std::string statement;
    std::vector<ConclusionTest> tests;  // empty: no mechanism can test it
    std::string source;
    std::string note;
    static constexpr auto fields() {
        return FieldTable{
            section<&Conclusion::label>("what it is called, e.g. (i)"),
            section<&Conclusion::statement>("what was concluded"),
            with_default(section<&Conclusion::source>("who concluded it")),
            with_default(section<&Conclusion::note>("what else there is to say")),
            section("test", &Conclusion::tests, "a claim that a prediction can confirm or contradict"),
        };
    }
};

// Everything about a mechanism except its model.
struct MechanismTask {
    std::string name;
    std::string title;
    std::vector<FreeParameter> parameters = {};
    // Replacements for observations with the same label, in terms of an output that this mechanism has: "it failed" can
    // mean a factor of safety of one, or a failed area of half the slope.
    std::vector<QuantityObservation> own_observations = {};
    std::vector<EvidenceSign> signs = {};  // of field evidence; all signs given for one piece of evidence have to hold
    static constexpr auto fields() {
        return FieldTable{
            section<&MechanismTask::name>("a short name, e.g. critical_geometry"),
            with_default(section<&MechanismTask::title>("what figures call it")),
            section("parameter", &MechanismTask::parameters, "an input that is free"),
            section("observation", &MechanismTask::own_observations, "an observation in terms of this mechanism"),
            section("shows", &MechanismTask::signs, "what shows a piece of field evidence"),
        };
    }
};

struct Mechanism : MechanismTask {
    ModelInterface model = {};
    // A cheaper and less accurate version of a costly model, with the same inputs and outputs. It shows where runs
    // would be wasted.
    std::optional<ModelInterface> coarse = {};
};

// Points along an observed profile at which its distance from the predicted one is taken.
inline constexpr std::size_t profile_samples = 50;

// Mechanisms with a costly model are fitted through a surrogate made from runs of it (surrogate.hpp).
struct SurrogateSettings {
    int runs = 120;
    std::optional<int> first_runs;
    double tolerance = 0.1;
    double give_up_below = 1e-3;
    int runs_of_claim = 4;
    static constexpr auto fields() {
        constexpr Interval runs_range = within(12, 2000);  // with more runs the surrogate takes longer than the model
        return FieldTable{
            with_default(number<&SurrogateSettings::runs>(runs_range, "runs at most")),
            number<&SurrogateSettings::first_runs>(
                runs_range, "runs before the surrogate says where to run; 10 for each parameter where it is absent"),
            with_default(number<&SurrogateSettings::tolerance>(
                between(0, 1), "relative error of the evidence that is small enough to stop")),
            // Cheap mechanisms are fitted first, so that costly ones with a far lower evidence can be given up.
            with_default(number<&SurrogateSettings::give_up_below>(
                right_open(0, 1),
                "no more runs once the evidence, with twice its error, is less than this "
                "share of the best of mechanisms of another kind; 0 for never")),
            with_default(number<&SurrogateSettings::runs_of_claim>(
                within(1, 1000), "draws of the posterior at which a claim about such a mechanism is evaluated")),
        };
    }
};

struct FitSettings {
    Algorithm algorithm = Algorithm::sbplx;
    int starts = 16;
    int evaluations_per_start = 400;
    double relative_tolerance = 1e-8;
    int profile_points = 41;
    int map_points = 61;
    std::uint64_t seed = 1;
    SurrogateSettings surrogate = {};
    int threads = 1;               // >= 1; the result does not depend on it
    const Ranks* ranks = nullptr;  // no result depends on them; null: this process alone
    static constexpr auto fields() {
        using S = FitSettings;
        constexpr Interval points_range = within(5, 2001);
        return FieldTable{
            with_default(section<&S::algorithm>("what minimises the misfit")),
            with_default(number<&S::starts>(within(1, 100'000),
                                            "local runs, from the prior means, then from a Sobol sequence; a global "
                                            "algorithm makes one run with the evaluations of all")),
            // A quarter of the evaluations is kept for polishing.
            with_default(number<&S::evaluations_per_start>(within(10, 100'000'000), "evaluations of each at most")),
            with_default(number<&S::relative_tolerance>(
                between(0, 1), "stop when the parameters, scaled by their bounds, move less than this")),
            with_default(number<&S::profile_points>(points_range, "points of each profile likelihood")),
            with_default(number<&S::map_points>(points_range, "points along each side of the misfit map")),
            with_default(number<&S::seed>(at_least(0), "for what uses chance")),
            with_default(section<&S::surrogate>("for models that take long")),
        };
    }
};

// Everything about a back-analysis except its mechanisms.
struct FitTask {
    FitSettings settings = {};
    std::optional<PosteriorStudy> posterior = {};  // absent: no posteriors and no evidences are computed
    std::vector<QuantityObservation> observations = {};
    std::optional<ProfileObservation> profile = {};
    std::vector<FieldEvidence> evidence = {};
    std::vector<FitCandidate> candidates = {};
    std::vector<Conclusion> conclusions = {};
    static constexpr auto fields() {
        return FieldTable{
            inlined(&FitTask::settings, "how to search"),
            section<&FitTask::posterior>("samples the posterior and the evidence"),
            section("observation", &FitTask::observations, "a quantity that was observed"),
            section<&FitTask::profile>("the ground after the failure"),
            section<&FitTask::evidence>("evidence without a number"),
            section("candidate", &FitTask::candidates, "a measurement that could be made next"),
            section("conclusion", &FitTask::conclusions, "what others concluded"),
        };
    }
};

struct FitProblem : FitTask {
    std::vector<Mechanism> mechanisms;
};

}  // namespace delabole
