#include "limit_equilibrium/bound/lp_residuals.hpp"

#include <algorithm>

namespace delabole::detail {

Scales scales_of(const Assembly& assembly) {
    Scales scales;
    for (const Body& body : assembly.bodies) {
        scales.force += body.weight / static_cast<double>(assembly.bodies.size());
    }
    scales.arm.resize(assembly.bodies.size());
    const auto reach = [&](std::size_t body, const Point& point) {
        scales.arm[body] = std::max(scales.arm[body], (point - assembly.bodies[body].centroid).norm());
    };
    for (const Contact& contact : assembly.contacts) {
        for (const Point& point : {contact.start, contact.end}) {
            reach(contact.body, point);
            if (contact.other) {
                reach(*contact.other, point);
            }
        }
    }
    for (double& arm : scales.arm) {
        arm = arm > 0 ? arm : 1;  // a body without contacts
    }
    return scales;
}

LpBound refused_bound(AssemblyCheck check) {
    LpBound bound;
    bound.status = LpStatus::invalid_assembly;
    bound.check = check;
    return bound;
}

std::vector<BodyLoad> horizontal_weights(const Assembly& assembly) {
    std::vector<BodyLoad> loads;
    for (const Body& body : assembly.bodies) {
        loads.push_back({{-body.weight, 0}, 0});
    }
    return loads;
}

void set_static_residuals(const Assembly& assembly, const Scales& scales, const Sought& sought, double strength,
                          LpBound& bound) {
    std::vector<BodyLoad> sums(assembly.bodies.size());
    for (std::size_t index = 0; index < sums.size(); ++index) {
        const Body& body = assembly.bodies[index];
        sums[index].force = body.load.force + Point(0, -body.weight) + bound.value * sought.load[index].force;
        sums[index].moment = body.load.moment + bound.value * sought.load[index].moment;
    }
    for (std::size_t index = 0; index < assembly.contacts.size(); ++index) {
        const Contact& contact = assembly.contacts[index];
        const BoundContactForce& force = bound.forces[index];
        const double friction = std::tan(friction_of(contact, strength));
        const double cohesion = strength * contact.cohesion * contact.length() / 2;
        const double pull = strength * contact.tensile_strength * contact.length() / 2;
        const auto add = [&](std::size_t body, const Point& point, const Point& vector) {
            sums[body].force += vector;
            sums[body].moment += cross(point - assembly.bodies[body].centroid, vector);
        };
        for (const auto& [end, point] :
             {std::pair(force.at_start, contact.start), std::pair(force.at_end, contact.end)}) {
            const Point vector = end.normal * contact.normal() + end.shear * contact.along();
            add(contact.body, point, vector);
            if (contact.other) {
                add(*contact.other, point, -vector);
            }
            // Measured across the cone, so that friction near 90 deg does not magnify rounding.
            const double pressing = end.normal + pull;
            const double beyond = (std::abs(end.shear) - friction * pressing - cohesion) / std::hypot(1, friction);
            bound.residuals.cone_violation =
                std::max({bound.residuals.cone_violation, -pressing / scales.force, beyond / scales.force});
        }
    }
    for (std::size_t index = 0; index < sums.size(); ++index) {
        bound.residuals.imbalance =
            std::max({bound.residuals.imbalance, sums[index].force.cwiseAbs().maxCoeff() / scales.force,
                      std::abs(sums[index].moment) / (scales.force * scales.arm[index])});
    }
}

void set_mechanism_residuals(const Assembly& assembly, const Sought& sought, double strength, LpBound& bound) {
    if (bound.mechanism.empty()) {
        bound.residuals.mechanism_value = bound.value;
        return;
    }
    const auto work = [&](std::size_t body, const Point& force, double moment) {
        const VirtualMotion& motion = bound.mechanism[body];
        return force.dot(motion.displacement) + moment * motion.rotation;
    };
    const auto motion_at = [&](std::size_t body, const Point& point) {
        const VirtualMotion& motion = bound.mechanism[body];
        const Point arm = point - assembly.bodies[body].centroid;
        return Point(motion.displacement + motion.rotation * Point(-arm.y(), arm.x()));
    };
    double fixed = 0;
    double moving = 0;
    for (std::size_t index = 0; index < assembly.bodies.size(); ++index) {
        const Body& body = assembly.bodies[index];
        fixed += work(index, Point(body.load.force + Point(0, -body.weight)), body.load.moment);
        moving += work(index, sought.load[index].force, sought.load[index].moment);
    }
    double dissipation = 0;
    for (const Contact& contact : assembly.contacts) {
        const double friction = friction_of(contact, strength);
        for (const Point& point : {contact.start, contact.end}) {
            Point relative = motion_at(contact.body, point);
            if (contact.other) {
                relative -= motion_at(*contact.other, point);
            }
            const double opening = relative.dot(contact.normal());
            const double slip = std::abs(relative.dot(contact.along()));
            const double overlap = slip * std::sin(friction) - opening * std::cos(friction);
            if (contact.bears_compression) {
                bound.residuals.mechanism_overlap = std::max(bound.residuals.mechanism_overlap, overlap);
            }
            dissipation += strength * contact.length() / 2 *
                           (slip * contact.cohesion + std::max(opening, 0.0) * contact.tensile_strength);
        }
    }
    bound.residuals.mechanism_value = (dissipation - fixed) / moving;
}

}  // namespace delabole::detail
