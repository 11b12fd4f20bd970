// A slope predicted as the mean of several that differ as nature's do. Where exactly the joints of a set run is seldom
// known, and which blocks fail depends on it: one drawing is one chance among many.
//
// The first member is the slope as drawn. In the others each joint set is shifted by a share of its spacing, evenly
// over the whole of it, and spacings and friction angles of the joints deviate normally, by two standard deviations at
// most; joints that scatter or end at random do so anew. The shares are those of an additive recurrence (Roberts 2018:
// multiples of the powers of the reciprocal generalized golden ratio, modulo 1), which spreads them more evenly than
// chance and the same for all values of the parameters: the mean changes smoothly with them, and a fit can use it.
#pragma once

#include "parameters/fields.hpp"
#include "parameters/model_interface.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

namespace delabole {

struct RelaxationStudy;

struct EnsembleRequest {
    double runs;
    std::optional<double> spacing_deviation;
    std::optional<double> friction_deviation;
    static constexpr auto fields() {
        using E = EnsembleRequest;
        return std::tuple{
            number("runs", &E::runs, Dimension::ratio, within(2, 1000), "slopes, the one as drawn among them"),
            number("spacing_deviation", &E::spacing_deviation, Dimension::ratio, within(0, 0.4),
                   "standard deviation of the spacing of each set, as a share of it; absent: 0"),
            number("friction_deviation", &E::friction_deviation, Dimension::angle, within(0, degrees(20)),
                   "standard deviation of the friction angle of each joint; absent: 0")};
    }
};

// A member of a jointed slope's ensemble; the first, 0, is the study itself. It has no ensemble of its own.
RelaxationStudy member_of(const RelaxationStudy& study, std::size_t member);

struct EnsemblePrediction {
    std::string_view failure = {};       // of the first member without an answer, where too many have none
    double without_answer = 0;           // members; the rest is of the others
    std::vector<double> mean = {};       // of each output of a member
    std::vector<double> deviation = {};  // likewise, standard deviation between the members
    Polyline profile = {};               // mean level left standing
    double profile_deviation = 0;        // m, root mean square distance of the members' profiles from it
};

// Runs that lost their energy balance or their blocks tell nothing. Where they are more than this share, the mean of
// the others would not be that of all.
inline constexpr double most_without_answer = 0.25;

// `first`: of the study itself. `predict`: of the other members. `go_on` is told the share done; returning false ends
// the work with the failure "interrupted".
EnsemblePrediction predict_ensemble(const RelaxationStudy& study, Prediction first,
                                    const std::function<Prediction(const RelaxationStudy&)>& predict,
                                    const std::function<bool(double)>& go_on);

// What a model with an ensemble answers: for each output of a member its mean, under the same name, then its deviation
// (deviation_prefix), that of the profile, and how many members had no answer.
std::vector<Quantity> outputs_of_ensemble(const std::vector<Quantity>& outputs);

// Results in the order of the members. Nothing where there is a failure.
Prediction prediction_of(EnsemblePrediction ensemble);

}  // namespace delabole
