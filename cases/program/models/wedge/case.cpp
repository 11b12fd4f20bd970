// Wedge failure as the reader knows it.
#include "cases/program/case/model_cases.hpp"
#include "wedge_failure/wedge_failure.hpp"

namespace delabole {
namespace {

// Hoek & Bray's example of the complete solution, fissures filled.
WedgeFailureStudy<> example_wedge() {
    constexpr double foot = 0.3048;
    constexpr double pound_per_square_foot = 47.880258980335839;
    constexpr double pound_per_cubic_foot = pound_per_square_foot / foot;
    WedgeFailureStudy<> study{};
    study.model.slope = {.height = 100 * foot,
                         .face_dip = degrees(65),
                         .face_dip_direction = degrees(185),
                         .upper_surface_dip = degrees(12),
                         .upper_surface_dip_direction = degrees(195)};
    study.model.plane_1 = {degrees(45), degrees(105), Coulomb<>{500 * pound_per_square_foot, degrees(20)}};
    study.model.plane_2 = {degrees(70), degrees(235), Coulomb<>{1000 * pound_per_square_foot, degrees(30)}};
    study.model.tension_crack = WedgeCrack<>{degrees(70), degrees(165), 40 * foot};
    study.model.rock = {.unit_weight = 160 * pound_per_cubic_foot};
    study.model.water = FilledFissures<>{.unit_weight = 62.5 * pound_per_cubic_foot, .filled_ratio = 1};
    return study;
}

constexpr std::string_view wedge_parts = R"(
[sources]                           # where a value comes from, by its key
"plane_1.dip" = "compass"

[[expect]]                          # a value known otherwise: delabole verify compares
quantity = "factor_of_safety"
value = 1.1378
tolerance = 0.0001                  # absolute, or relative_tolerance
with = { "plane_1.strength.friction_angle" = "20 deg" }  # inputs that differ
source = "a calculation by hand"

[fit]                               # delabole fit: see delabole init plane_failure --full
[[fit.parameter]]
name = "plane_1.strength.friction_angle"
also = ["plane_2.strength.friction_angle"]  # further inputs that take its value
lower = "15 deg"
upper = "45 deg"
prior = { mean = "25 deg", standard_deviation = "4 deg" }

[[fit.observation]]
label = "it failed"
quantity = "factor_of_safety"
value = 1
standard_deviation = 0.05

[sensitivity]                       # delabole sensitivity
quantity = "factor_of_safety"

[sensitivity.failure]
limit = 1
side = "below"

[[sensitivity.parameter]]
name = "plane_1.dip"
distribution = "normal"
mean = "45 deg"
standard_deviation = "3 deg"
lower = "33 deg"
upper = "57 deg"

[[sensitivity.parameter]]
name = "plane_1.strength.friction_angle"
distribution = "normal"
mean = "20 deg"
standard_deviation = "2 deg"
lower = "12 deg"
upper = "28 deg"

[sensitivity.propagation]           # samples without a wedge are counted by cause
samples = 16384
)";

}  // namespace

void check_case(Checker& checker, const WedgeFailureStudy<>& study) {
    check_strength(checker, "plane_1.strength", study.model.plane_1.strength);
    check_strength(checker, "plane_2.strength", study.model.plane_2.strength);
    const auto* pressures = std::get_if<MeanPressures<>>(&study.model.water);
    if (pressures != nullptr && pressures->tension_crack && !study.model.tension_crack) {
        checker.complain("water.tension_crack", "is a pressure in a crack, but the case has no [tension_crack]");
    }
    check_required(checker, study.required, study);
}

ModelExample<WedgeFailureStudy<>> example_case(const WedgeFailureStudy<>*) {
    return {example_wedge(), "A wedge with a tension crack and filled fissures", wedge_parts};
}

std::vector<Quantity> possible_outputs(const WedgeFailureStudy<>&) {
    return outputs_of(WedgeFailureResult{});
}

}  // namespace delabole
