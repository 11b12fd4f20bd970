// Limit analysis of an assembly of rigid bodies by linear programming: contact forces inside Coulomb's cone at both
// ends of every contact, equilibrium of every body, and the largest (or least) load for which such forces exist.
//
// At an end with normal force N and shear T the cone |T| <= N tan(phi), N >= 0 is spanned by its two edges
// (sin phi, cos phi) and (-sin phi, cos phi), so that N and T are two non-negative unknowns; any resultant that lies
// within the face is a pair of end forces. Cohesion adds a shear of at most c times the length of the face, wherever
// the face opens. Tensile strength adds a tension of at most half of the face's at each end. All of this is linear,
// hence a linear programme; its dual is a mechanism, one displacement and rotation of each body, in which sliding faces
// open by tan(phi) times the slip.
//
// THE ANSWER IS A BOUND ON THE UNSAFE SIDE. The existence of forces that would keep the bodies in equilibrium does not
// mean that they arise. The theorem by which a static solution is a safe bound needs dilatant friction (associated
// flow); real joints slip without opening, and then an assembly may fail at a load for which the programme still finds
// forces. No load above this bound can be carried, and friction less than the required one cannot suffice; loads below
// the bound may fail. On stepped bases the recursion, which puts the forces on the tops of the joints as a toppling
// mechanism does, needs far more friction than the programme, which may put them low. Drucker (1954, "Coulomb friction,
// plasticity, and limit loads", J. Appl. Mech. 21) for the theorem and its failure; Livesley (1978, Int. J. Num. Meth.
// Engng 12) for the programme.
//
// Accuracy: values to about 1e-10 relative, unless the assembly itself is ill-conditioned; as a check the result has
// its residuals and the value of the mechanism, which bounds from the other side. Forces and lengths are scaled by
// weight and size, so that units do not matter. Time grows between linear and quadratic with the bodies. Safe to call
// from any thread.
#pragma once

#include "limit_equilibrium/bound/assembly.hpp"

#include <atomic>

namespace delabole {

enum class LpStatus {
    optimal,
    unbounded,         // stands under any load
    infeasible,        // stands under no load
    not_converged,     // the solver gave up, or its answer failed the check in `residuals`
    invalid_assembly,  // see `check`
    interrupted,       // stopped on request
};

struct EndForce {
    double normal;  // on `body`, compression positive, N/m
    double shear;   // on `body`, along the direction from start to end, N/m
};

struct BoundContactForce {
    EndForce at_start;
    EndForce at_end;
    double position;  // of the resultant, from the start, m; the middle if there is no normal force

    double normal() const { return at_start.normal + at_end.normal; }
    double shear() const { return at_start.shear + at_end.shear; }
};

// Motion of a body about its centroid, scaled so that the fastest contact point moves by about 1; the motion of a point
// is counted as displacement plus rotation times its distance from the body's centroid.
struct VirtualMotion {
    Point displacement;
    double rotation;  // anticlockwise
};

struct LpResiduals {
    double imbalance;          // largest force, or moment by arm, left on a body, over the mean weight
    double cone_violation;     // largest shear beyond strength, or tension, over the mean weight
    double mechanism_overlap;  // largest closing of a face in the mechanism, in violation of Coulomb's cone
    double mechanism_value;    // value by the mechanism: dissipation less work of the fixed loads, over work of the
                               // sought one
};

struct LpBound {
    LpStatus status = LpStatus::not_converged;
    AssemblyCheck check = AssemblyCheck::valid;
    double value = 0;                         // each function states its meaning; 0 unless optimal
    std::vector<BoundContactForce> forces{};  // of every contact; empty unless optimal
    std::vector<VirtualMotion> mechanism{};   // of every body; empty unless optimal, and if none limits the value
    LpResiduals residuals{};
    int iterations = 0;  // of the simplex method, in all programmes together
};

// Largest k for which the assembly stands with an added force along -x of k times each weight: the horizontal
// earthquake coefficient. If only weight and friction act, it is the tangent of the largest tilt towards -x, since all
// forces then scale by 1/cos(tilt). Negative if the assembly needs a push into the slope.
LpBound largest_tilt(const Assembly& assembly);

// Largest factor on `loads`, one for each body, on top of its own weight and load.
LpBound largest_load_factor(const Assembly& assembly, const std::vector<BodyLoad>& loads);

// Smallest factor on the tangents of all friction angles and on all cohesions for which the assembly stands; its
// inverse is a factor of safety, correct or too high. 0: the assembly stands without friction. Infeasible: a factor of
// 1024 is not enough. No tangent is raised beyond 1e4. Relative accuracy 1e-10; with a factor below 1e-6 the assembly
// stands, but a still smaller one may do. The mechanism is the one that a horizontal force would cause at that
// strength, and `mechanism_value` the coefficient of that force, about 0. `stop` is checked before each of the 10 to 60
// programmes.
LpBound least_strength_factor(const Assembly& assembly, const std::atomic<bool>* stop = nullptr);

struct LeastImbalance {
    LpStatus status = LpStatus::not_converged;
    AssemblyCheck check = AssemblyCheck::valid;
    // Sum of the forces along x and y, and moments by arm, that have to be added to the bodies; in mean weights.
    double sum = 0;
    std::vector<VirtualMotion> mechanism{};  // of every body: the motion if they do not stand; empty unless optimal

    // The tolerance allows for the accuracy of the sum, 1e-8.
    bool stands() const { return sum <= 1e-7; }
};

// Whether the assembly stands under its own weights and loads. This takes a small part of the time of a bound, because
// the interior-point method also solves problems in which forces exist for any load: 0.03 s for 200 bodies, 0.3 s for
// 1500. Bodies lighter than 1e-7 of the mean weight have no noticeable effect.
LeastImbalance least_imbalance(const Assembly& assembly);

}  // namespace delabole
