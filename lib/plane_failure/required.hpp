// The value of one input at which the factor of safety takes a given value: friction, cohesion, water level, bolt force
// ...
#pragma once

#include "numerics/required_value.hpp"
#include "plane_failure/study.hpp"

#include <string>

namespace delabole {

// `target` is the factor of safety to reach, with a critical search, if the study has one, made anew for each value.
Required required_value(const PlaneFailureStudy<>& study, const std::string& parameter, double target,
                        const std::vector<std::string>& also = {});

// Inclination of the first bolt that makes the factor of safety largest, and that factor: a plunge in (-p, 90 deg]. For
// an active bolt of force T the condition is tan(plunge + p) = tan(phi) / FS (Coulomb); the inclination phi - p often
// printed as the optimum (Wyllie & Mah 2004, ch. 7) is that of least force for FS = 1, and coincides only there.
struct OptimumBolt {
    double plunge;
    double factor_of_safety;
};
// Requires at least one bolt and a valid problem, otherwise returns a factor of safety of 0, never NaN. Infinite if a
// bolt alone can hold the mass, then at the flattest plunge of the scan at which it does.
OptimumBolt optimum_bolt_plunge(const PlaneFailure<>& problem);

}  // namespace delabole
