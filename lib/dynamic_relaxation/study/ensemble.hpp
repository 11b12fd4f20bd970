// Prediction of a slope as the mean of several realizations of its joints. The exact positions of the joints of a set
// are seldom known, and which blocks fail depends on them: a single section is one realization among many.
//
// The first member is the slope as given. In the others each joint set is shifted by a share of its spacing, uniformly
// over the whole spacing, and spacings and friction angles of the joints have normal deviations, limited to two
// standard deviations; random spacings and ends of joints are drawn again. The shares come from an additive recurrence
// (Roberts 2018: multiples of the powers of the reciprocal generalized golden ratio, modulo 1). It spreads them more
// evenly than random numbers, and the same for all values of the parameters: the mean changes smoothly with them, and a
// fit can use it.
//
// The normal deviates of few slopes are not centred: of eight slopes whose spacings and friction angles deviate, the
// mean of one of these is up to 0.7 standard deviations low, of 32 slopes up to 0.2.
#pragma once

#include "dynamic_relaxation/study/critical_request.hpp"
#include "parameters/fields.hpp"
#include "parameters/model_interface.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace delabole {

struct RelaxationStudy;

struct EnsembleRequest {
    double runs;
    std::optional<double> spacing_deviation;
    std::optional<double> friction_deviation;
    static constexpr auto fields() {
        using E = EnsembleRequest;
        return FieldTable{
            number<&E::runs>(within(2, 1000), "slopes, the one as drawn among them"),
            number<&E::spacing_deviation>(within(0, 0.4),
                                          "standard deviation of the spacing of each set, as a share of it; absent: 0"),
            number<&E::friction_deviation>(Dimension::angle, within(0, degrees(20)),
                                           "standard deviation of the friction angle of each joint; absent: 0")};
    }
};

// A member of a jointed slope's ensemble; member 0 is the study itself. The returned study has no ensemble.
RelaxationStudy member_of(const RelaxationStudy& study, std::size_t member);

// A member whose search ended at a bound has an answer all the same: its critical value lies beyond that bound, and is
// taken at it. What has failed in its run as given is known as for any other member.
struct EnsembleMember {
    Prediction prediction;
    bool fails = false;              // at the strength as given
    bool at_lower = false;           // its critical value, on one of its paths, was taken at the least value tried
    bool at_upper = false;           // likewise at the greatest
    std::string_view ended_at = {};  // word for the end of a search at a bound; empty if it found a value
};

// A mean is at most what is found with values taken at the lower bound, and at least what is found with values taken at
// the upper one. With both it is neither.
struct MembersAtBounds {
    double lower = 0;  // number of members
    double upper = 0;
};

struct EnsemblePrediction {
    // Word of the members if all have the same, or `slopes_without_answer`, or "interrupted". A word of some members is
    // never that of their mean, for it may bound their critical value.
    std::string_view failure = {};
    std::string_view first_cause = {};              // word of the first member without an answer
    double without_answer = 0;                      // number of members without an answer
    double answered = 0;                            // number of the other members, of which all other results are
    double failing = 0;                             // number of these that fail at the strength as given
    std::optional<MembersAtBounds> at_bounds = {};  // with a search
    std::vector<double> mean = {};                  // of each output of a member
    std::vector<double> deviation = {};             // standard deviation of each output between the members
    Polyline profile = {};                          // mean elevation of the ground left standing
    double profile_deviation = 0;                   // m, root mean square distance of the members' profiles from it
};

inline constexpr std::string_view slopes_without_answer = "slopes_without_answer";

// Runs that lost their energy balance or their blocks give no answer. If their share is greater than this, the mean of
// the other runs would not represent the ensemble.
inline constexpr double most_without_answer = 0.25;

// `first`: answer of the study itself. `predict`: makes those of the other members. `go_on` receives the share done; if
// it returns false, the work ends with the failure "interrupted".
EnsemblePrediction predict_ensemble(const RelaxationStudy& study, EnsembleMember first,
                                    const std::function<EnsembleMember(const RelaxationStudy&)>& predict,
                                    const std::function<bool(double)>& go_on);

// Outputs of a model with an ensemble: for each output of a member its mean, under the same name, then its deviation
// (deviation_prefix), the deviation of the profile, and the number of members without an answer; with a search also the
// share of members that fail as given, and the numbers of those taken at its bounds.
std::vector<Quantity> outputs_of_ensemble(std::vector<Quantity> outputs, const std::optional<CriticalPlan>& plan);

// Which of these outputs, for a search on the paths of the plan whose first value is the output `critical` of a member,
// are only bounds if members were taken at bounds.
std::vector<BoundedOutput> bounded_outputs(const CriticalPlan& plan, std::size_t critical,
                                           const std::vector<Quantity>& outputs);

// Results in the order of outputs_of_ensemble; none if the ensemble failed.
Prediction prediction_of(EnsemblePrediction ensemble);

}  // namespace delabole
