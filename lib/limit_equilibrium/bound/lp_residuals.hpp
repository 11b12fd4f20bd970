// Formulation and solution of a linear programme of limit analysis, and the residuals of its forces and its mechanism
// in the equations of mechanics.
#pragma once

#include "geometry/polygon.hpp"
#include "limit_equilibrium/bound/lp_bound.hpp"
#include "numerics/constants.hpp"

#include <algorithm>
#include <cmath>

namespace delabole::detail {

// Units that make weights and arms about 1.
struct Scales {
    double force = 0;         // mean weight
    std::vector<double> arm;  // of each body: its farthest contact point
};

enum class Sense { largest, least };

// A factor to be found on loads, one load for each body.
struct Sought {
    std::vector<BodyLoad> load;
    Sense sense = Sense::largest;
    double lower = -infinity;
    double upper = infinity;
};

// Beyond this tangent the cone is a half plane to all digits of the simplex method.
constexpr double largest_raised_tangent = 1e4;

// Strength times a factor applies to tan(phi), not to phi. Raised strength stops at a tangent of 1e4, or at the given
// one if that is greater.
inline double friction_of(const Contact& contact, double strength) {
    const double given = std::tan(contact.friction_angle);
    const double most = strength > 1 ? std::max(given, largest_raised_tangent) : given;
    return std::atan(std::min(strength * given, most));
}

Scales scales_of(const Assembly& assembly);

// The answer for an invalid assembly.
LpBound refused_bound(AssemblyCheck check);

// The weights as forces in direction -x.
std::vector<BodyLoad> horizontal_weights(const Assembly& assembly);

// Solves a valid assembly with all strength multiplied by `strength`.
LpBound solve(const Assembly& assembly, const Scales& scales, const Sought& sought, double strength);

// Computes imbalance and cone violation from the forces themselves, independently of the programme's numbers.
void set_static_residuals(const Assembly& assembly, const Scales& scales, const Sought& sought, double strength,
                          LpBound& bound);

// Computes overlap and value of the mechanism.
void set_mechanism_residuals(const Assembly& assembly, const Sought& sought, double strength, LpBound& bound);

}  // namespace delabole::detail
