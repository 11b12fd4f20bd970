#include "limit_equilibrium/bound/assembly.hpp"

#include "parameters/fields.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

AssemblyCheck check_body(const Body& body) {
    if (!std::isfinite(body.weight) || !body.centroid.allFinite() || !body.load.force.allFinite() ||
        !std::isfinite(body.load.moment)) {
        return AssemblyCheck::input_out_of_range;
    }
    return body.weight > 0 ? AssemblyCheck::valid : AssemblyCheck::weight_not_positive;
}

AssemblyCheck check_contact(const Contact& contact, std::size_t bodies) {
    if (contact.body >= bodies || (contact.other && (*contact.other >= bodies || *contact.other == contact.body))) {
        return AssemblyCheck::contact_of_unknown_body;
    }
    if (!contact.start.allFinite() || !contact.end.allFinite() || !std::isfinite(contact.cohesion) ||
        !std::isfinite(contact.tensile_strength) || !std::isfinite(contact.friction_angle)) {
        return AssemblyCheck::input_out_of_range;
    }
    if (!(contact.length() > 0)) {
        return AssemblyCheck::contact_without_length;
    }
    if (!(contact.friction_angle >= 0 && contact.friction_angle < degrees(90))) {
        return AssemblyCheck::friction_not_below_90_deg;
    }
    return contact.cohesion >= 0 && contact.tensile_strength >= 0 ? AssemblyCheck::valid
                                                                  : AssemblyCheck::cohesion_negative;
}

}  // namespace

AssemblyCheck check_assembly(const Assembly& assembly) {
    if (assembly.check != AssemblyCheck::valid) {
        return assembly.check;
    }
    if (assembly.bodies.empty()) {
        return AssemblyCheck::no_bodies;
    }
    for (const Body& body : assembly.bodies) {
        if (const AssemblyCheck check = check_body(body); check != AssemblyCheck::valid) {
            return check;
        }
    }
    const auto [lightest, heaviest] =
        std::ranges::minmax_element(assembly.bodies, [](const Body& a, const Body& b) { return a.weight < b.weight; });
    if (heaviest->weight > greatest_weight_ratio * lightest->weight) {
        return AssemblyCheck::weights_too_different;
    }
    for (const Contact& contact : assembly.contacts) {
        if (const AssemblyCheck check = check_contact(contact, assembly.bodies.size()); check != AssemblyCheck::valid) {
            return check;
        }
    }
    return AssemblyCheck::valid;
}

}  // namespace delabole
