// Limit analysis of an assembly of rigid bodies by linear programming: contact forces inside Coulomb's cone at both
// ends of every contact, equilibrium of every body, and the largest (or least) load for which such forces exist.
//
// At an end with normal force N and shear T the cone |T| <= N tan(phi), N >= 0 is spanned by its two edges
// (sin phi, cos phi) and (-sin phi, cos phi), so that N and T are two non-negative unknowns; any resultant that lies
// within the face is a pair of end forces. Cohesion adds a shear of at most c times the length of the face, wherever
// the face opens. Tensile strength adds a pull of at most half of the face's at each end. All are linear, whence a
// linear programme; its dual is a mechanism, one displacement and rotation of each body, in which faces that slide open
// by tan(phi) times the slip.
//
// THE ANSWER BOUNDS FROM THE UNSAFE SIDE. That forces exist which would keep the bodies in equilibrium does not mean
// that they arise. The theorem by which a static solution is a safe bound needs dilatant friction (associated flow);
// real joints slip without opening, and then an assembly may fail at a load for which the programme still finds forces.
// No load above this bound can be carried, friction less than its answer cannot suffice; loads below it may fail. On
// stepped bases the recursion, which puts the forces on the tops of the joints as a toppling mechanism does, needs far
// more friction than the programme, which may put them low. Drucker (1954, "Coulomb friction, plasticity, and limit
// loads", J. Appl. Mech. 21) for the theorem and its failure; Livesley (1978, Int. J. Num. Meth. Engng 12) for the
// programme.
//
// Accuracy: values to about 1e-10 relative, where the assembly is not itself ill-conditioned; the result carries its
// residuals and the value of the mechanism, which bounds from the other side, to judge by. Scaled by weight and length:
// units do not matter. Time grows between linear and quadratic with the bodies. Safe to call from any thread.
#pragma once

#include "limit_equilibrium/bound/assembly.hpp"

#include <atomic>

namespace delabole {

enum class LpStatus {
    optimal,
    unbounded,         // stands whatever the load
    infeasible,        // cannot stand whatever the load
    not_converged,     // the solver gave up, or its answer failed the check in `residuals`
    invalid_assembly,  // `check` says why
    interrupted,       // asked to stop
};

struct EndForce {
    double normal;  // on `body`, compression positive, N/m
    double shear;   // on `body`, along the way from start to end, N/m
};

struct BoundContactForce {
    EndForce at_start;
    EndForce at_end;
    double position;  // of the resultant, from the start, m; the middle where there is no normal force

    double normal() const { return at_start.normal + at_end.normal; }
    double shear() const { return at_start.shear + at_end.shear; }
};

// Motion of a body about its centroid, scaled so that the fastest contact point, body by body counted as displacement
// plus rotation times its distance from the centroid, moves by about 1.
struct VirtualMotion {
    Point displacement;
    double rotation;  // anticlockwise
};

struct LpResiduals {
    double imbalance;          // largest force, or moment by arm, left on a body, over the mean weight
    double cone_violation;     // largest shear beyond strength, or tension, over the mean weight
    double mechanism_overlap;  // largest closing of a face against Coulomb's cone in the mechanism
    double mechanism_value;    // the value by the mechanism: dissipation less work of the fixed loads, over work of the
                               // sought one
};

struct LpBound {
    LpStatus status = LpStatus::not_converged;
    AssemblyCheck check = AssemblyCheck::valid;
    double value = 0;                         // meaning with each function; 0 unless optimal
    std::vector<BoundContactForce> forces{};  // of every contact; empty unless optimal
    std::vector<VirtualMotion> mechanism{};   // of every body; empty unless optimal, and where none limits the value
    LpResiduals residuals{};
    int iterations = 0;  // of the simplex method, all programmes together
};

// Largest k for which the assembly stands with k times each weight as a force along -x added: the horizontal earthquake
// coefficient. Where nothing but weight and friction acts it is the tangent of the largest tilt towards -x, since all
// forces then scale by 1/cos(tilt). Negative where the assembly needs a push into the slope.
LpBound largest_tilt(const Assembly& assembly);

// Largest factor on `loads`, one for each body, on top of its own weight and load.
LpBound largest_load_factor(const Assembly& assembly, const std::vector<BodyLoad>& loads);

// Smallest factor on the tangents of all friction angles and on all cohesions for which the assembly stands; its
// inverse is a factor of safety, right or too high. 0: stands without friction. Infeasible: a factor of 1024 is not
// enough. No tangent is raised beyond 1e4. Relative accuracy 1e-10. The mechanism is the one that a horizontal force
// would set off at that strength, and `mechanism_value` the coefficient of that force, about 0. The flag is looked at
// before each of its 10 to 60 programmes.
LpBound least_strength_factor(const Assembly& assembly, const std::atomic<bool>* stop = nullptr);

struct LeastImbalance {
    LpStatus status = LpStatus::not_converged;
    AssemblyCheck check = AssemblyCheck::valid;
    // Sum of the forces along x and y, and moments by arm, that have to be added to the bodies; in mean weights.
    double sum = 0;
    std::vector<VirtualMotion> mechanism{};  // of every body: what would move; empty unless optimal

    // The sum is known to 1e-8.
    bool stands() const { return sum <= 1e-7; }
};

// Whether the assembly stands under its own weights and loads, for a small part of the time that a bound takes, since
// the method of interior points does not mind that there are forces whatever the load: 0.03 s for 200 bodies, 0.3 s for
// 1500. Bodies lighter than 1e-7 of the mean weight are not noticed.
LeastImbalance least_imbalance(const Assembly& assembly);

}  // namespace delabole
