// Transitions of a contact: it stays open, begins to bear, goes on bearing or opens; where it bears, it sticks or
// slips. They are decided only here, for a run's contacts one by one (contact_law.hpp), for several at once
// (contact_sweep.cpp) and for a static solve (static_equations.cpp).
#pragma once

#include "dynamic_relaxation/contact/contacts.hpp"
#include "numerics/lanes.hpp"

namespace delabole {

// Memory and corner positions of contacts, one bit for each contact; a single contact uses the lowest bit.
struct ContactSituation {
    unsigned touching;     // touched until now
    unsigned beneath;      // below the line of the edge without having come over it
    unsigned yields;       // does not bear in a trial
    unsigned apart;        // the corner is not below the line of the edge
    unsigned handed_over;  // for a contact `beneath`: the twin touches and is about as deep
    unsigned taken_over;   // for a contact that yields: the edge that bears instead is too deep for a trial
};

// Returns the contacts that touch or begin to touch. All others stay open.
DELABOLE_INLINED unsigned over_edge(const ContactSituation& now) {
    const unsigned may_begin = (now.yields & now.taken_over) | (~now.yields & (~now.beneath | now.handed_over));
    return now.touching | (~now.apart & may_begin);
}

// Returns which of these contacts bear; the others open. `weightless`: contacts past the end of the edge, or deeper
// than on the edge's rival.
DELABOLE_INLINED unsigned bearing_of(unsigned over_edge, unsigned apart, unsigned weightless) {
    return over_edge & ~apart & ~weightless;
}

// Whether the bit of a single contact is set.
DELABOLE_INLINED bool holds_of_one(unsigned bits) {
    return (bits & 1U) != 0;
}

// Shear strength by friction and cohesion along an edge under the compression `pressing`, both N/m.
template <class Number>
DELABOLE_INLINED Number shear_strength(const JointLawOf<Number>& law, const Number& pressing,
                                       const MaskOf<Number>& broken) {
    return select(broken, pressing * law.residual_friction + law.residual_cohesion,
                  pressing * law.friction + law.cohesion);
}

// Whether a contact with this law loses strength where it slips or opens.
inline bool has_peak(const JointLawOf<double>& law) {
    return law.cohesion != law.residual_cohesion || law.friction != law.residual_friction;
}

// Whether a contact slips that would need the shear force `held`, N/m, to stick.
template <class Number>
DELABOLE_INLINED MaskOf<Number> slips(const Number& held, const Number& strength) {
    return absolute(held) > strength;
}

}  // namespace delabole
