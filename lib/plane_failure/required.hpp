// The value of one input at which the factor of safety takes a given value: friction, cohesion, water level, bolt force
// ...
#pragma once

#include "plane_failure/parameters.hpp"

#include <array>
#include <string>
#include <string_view>

namespace delabole {

enum class RequiredStatus { found, several, never_reached, unknown_parameter };

constexpr std::array<std::string_view, 4> enum_names(RequiredStatus) {
    return {"found", "several", "never_reached", "unknown_parameter"};
}

struct Required {
    RequiredStatus status;
    double value;  // SI, meaningful where found or several (then the smallest)
    Dimension dimension;
    // Over the range searched, for the message where it is never reached; plus and minus infinity where the problem has
    // no answer at all.
    double lowest_factor_of_safety;
    double highest_factor_of_safety;
};

// `target` is the factor of safety to reach. Searches the range of the input's field; an unbounded range is searched
// geometrically over 24 decades of distance from its bound, or where it has none from zero and from the present value.
// Values without an answer (water above the crack, ...) are left out. Accuracy: full double precision of the root, if
// the function is monotonic between neighbouring points of the scan.
Required required_value(const PlaneFailure<>& problem, const std::string& parameter, double target);

// Inclination of the first bolt that makes the factor of safety largest, and that factor: a plunge in (-p, 90 deg]. For
// an active bolt of force T the condition is tan(plunge + p) = tan(phi) / FS (Coulomb); the inclination phi - p often
// printed as the optimum (Wyllie & Mah 2004, ch. 7) is that of least force for FS = 1, and coincides only there.
struct OptimumBolt {
    double plunge;
    double factor_of_safety;
};
// NaN-free: needs at least one bolt and a valid problem, otherwise returns a factor of safety of 0. Infinite where a
// bolt can hold the mass up altogether, at the flattest plunge of the scan that does.
OptimumBolt optimum_bolt_plunge(const PlaneFailure<>& problem);

}  // namespace delabole
