// What becomes of a contact: it stays open, begins to bear, goes on bearing or opens; and where it bears, it sticks or
// slips. Decided here alone, for a run's contacts one by one (contact_law.hpp), for several at once (contact_sweep.cpp)
// and for a static solve (static_equations.cpp).
#pragma once

#include "dynamic_relaxation/contact/contacts.hpp"
#include "numerics/lanes.hpp"

namespace delabole {

// What contacts remember and where their corners are: one bit for each contact, the lowest for one by itself.
struct ContactSituation {
    unsigned touching;     // until now
    unsigned beneath;      // below the line of the edge without having come over it
    unsigned yields;       // does not bear in a trial
    unsigned apart;        // the corner is not below the line of the edge
    unsigned handed_over;  // of one beneath: the twin touches and is about as deep
    unsigned taken_over;   // of one that yields: the edge that bears in its place is too deep for that
};

// Which contacts touch or begin to. Others are open and stay so.
DELABOLE_INLINED unsigned over_edge(const ContactSituation& now) {
    const unsigned may_begin = (now.yields & now.taken_over) | (~now.yields & (~now.beneath | now.handed_over));
    return now.touching | (~now.apart & may_begin);
}

// Which of these then bear. Others open. `pulls`: they have tensile strength left. `weightless`: they are past the end
// of the edge, or deeper than on the edge's rival.
DELABOLE_INLINED unsigned bearing_of(unsigned over_edge, unsigned apart, unsigned pulls, unsigned weightless) {
    return over_edge & (~apart | pulls) & ~weightless;
}

// Whether it holds of one contact by itself.
DELABOLE_INLINED bool holds_of_one(unsigned bits) {
    return (bits & 1U) != 0;
}

// N/m, what friction and cohesion can hold along an edge that is pressed with `pressing`, N/m.
template <class Number>
DELABOLE_INLINED Number shear_strength(const JointLawOf<Number>& law, const Number& residual_cohesion,
                                       const Number& pressing, const MaskOf<Number>& broken) {
    return select(broken, pressing * law.residual_friction + residual_cohesion, pressing * law.friction + law.cohesion);
}

inline double shear_strength(const ContactLaw& law, double pressing, bool broken) {
    return shear_strength<double>(law, law.residual_cohesion, pressing, broken);
}

// Whether a contact slips that would have to hold so much, N/m, to stick.
template <class Number>
DELABOLE_INLINED MaskOf<Number> slips(const Number& held, const Number& strength) {
    return absolute(held) > strength;
}

}  // namespace delabole
