// What the programme is asked, how it is solved, and what is left of its answer when forces and mechanism are put back
// into mechanics.
#pragma once

#include "limit_equilibrium/bound/lp_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole::detail {

constexpr double infinity = std::numeric_limits<double>::infinity();

inline double cross(const Point& a, const Point& b) {
    return a.x() * b.y() - a.y() * b.x();
}

// Units that make weights and arms about 1.
struct Scales {
    double force = 0;         // mean weight
    std::vector<double> arm;  // of each body: its farthest contact point
};

enum class Sense { largest, least };

// A factor on loads, one for each body.
struct Sought {
    std::vector<BodyLoad> load;
    Sense sense = Sense::largest;
    double lower = -infinity;
    double upper = infinity;
};

// Beyond this a cone is a half plane to as many digits as the simplex method keeps.
constexpr double largest_raised_tangent = 1e4;

// All strength times a factor: tan(phi), not phi. Raised strength stops at a tangent of 1e4, or at that given.
inline double friction_of(const Contact& contact, double strength) {
    const double given = std::tan(contact.friction_angle);
    const double most = strength > 1 ? std::max(given, largest_raised_tangent) : given;
    return std::atan(std::min(strength * given, most));
}

Scales scales_of(const Assembly& assembly);

// The answer for an assembly that cannot be asked about.
LpBound refused(AssemblyCheck check);

// The weights as forces along -x.
std::vector<BodyLoad> horizontal_weights(const Assembly& assembly);

// Solves a valid assembly, all of whose strength is multiplied by `strength`.
LpBound solve(const Assembly& assembly, const Scales& scales, const Sought& sought, double strength);

// Imbalance and cone violation, from the forces themselves and not from the programme's numbers.
void set_static_residuals(const Assembly& assembly, const Scales& scales, const Sought& sought, double strength,
                          LpBound& bound);

// Overlap and value of the mechanism.
void set_mechanism_residuals(const Assembly& assembly, const Sought& sought, double strength, LpBound& bound);

}  // namespace delabole::detail
