#include "dynamic_relaxation/statics/pair_response.hpp"

#include "dynamic_relaxation/contact/contact_transition.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

PairResponse respond(const ContactLaw& law, const RelaxationContact& contact, const ContactPosition& at,
                     const Arms& arms, ContactMemory& memory, double hair, bool resists) {
    const double overlap = -at.gap;
    const bool bonded = law.tension > 0 && !memory.broken && memory.touching;
    const double weight = contact_weight(law, contact, at, memory.insists);
    memory.shear += at.slide - memory.place;
    memory.place = at.slide;
    memory.insists = memory.insists && (weight > 0 || !memory.touching);
    const bool idle = !memory.touching && (memory.beneath || memory.yields);
    const bool apart = overlap <= 0;
    const unsigned over = over_edge({.touching = memory.touching,
                                     .beneath = memory.beneath,
                                     .yields = memory.yields,
                                     .apart = apart,
                                     .handed_over = 0,
                                     .taken_over = 0});
    // A contact of zero weight stays in touch; it carries no force.
    memory.touching = holds_of_one(bearing_of(over, apart, bonded, 0));
    memory.sliding = false;
    const bool open = overlap < -hair && !bonded;
    PairResponse response;
    if (idle || open) {
        memory.shear = 0;
        if (idle || !resists) {
            return response;
        }
    }
    response.normal = arms.along(at.normal_x, at.normal_y, at);
    response.along = arms.along(at.along_x(), at.along_y(), at);
    if (resists) {
        response.normal_damping = weight * law.normal_stiffness;
        response.shear_damping = weight * law.shear_stiffness;
        if (open) {
            return response;
        }
    }
    const double pressing = law.normal_stiffness * std::max(overlap, 0.0);
    const double strength = shear_strength(law, pressing, memory.broken);
    response.normal_stiffness = weight * law.normal_stiffness;
    const double trial = -law.shear_stiffness * memory.shear;
    const double shear = std::clamp(trial, -strength, strength);
    memory.sliding = slips(trial, strength);
    memory.slip += (shear - trial) / law.shear_stiffness;
    memory.shear = -shear / law.shear_stiffness;
    if (memory.sliding) {
        const double friction = memory.broken ? law.residual_friction : law.friction;
        response.coupling = weight * law.normal_stiffness * std::copysign(friction, trial);
    } else {
        response.shear_stiffness = weight * law.shear_stiffness;
    }
    response.normal_force = weight * (bonded ? law.normal_stiffness * overlap : pressing);
    response.shear_force = weight * shear;
    return response;
}

std::array<PairResponse, 2> respond(const Bond& bond, const FacePosition& at, const Arms& arms) {
    PairResponse moved;
    moved.normal = arms.along(at.normal_x, at.normal_y, at);
    moved.along = arms.along(at.along_x(), at.along_y(), at);
    moved.normal_force = -bond.normal_stiffness * at.opening;
    moved.shear_force = -bond.shear_stiffness * at.slide;
    moved.normal_stiffness = moved.normal_damping = bond.normal_stiffness;
    moved.shear_stiffness = moved.shear_damping = bond.shear_stiffness;
    PairResponse turned;
    turned.normal = arms.turn();
    turned.normal_force = -bond.bending_stiffness * at.turn;
    turned.normal_stiffness = turned.normal_damping = bond.bending_stiffness;
    return {moved, turned};
}

PairResponse respond(const HeldByBolt& bolt, const BoltPosition& at, const Arms& arms) {
    PairResponse pulled;
    pulled.normal = arms.along(at.towards.x(), at.towards.y(), at);
    pulled.normal_force = force_of(bolt.segment, bolt.memory, at.extension);
    pulled.normal_damping = bolt.segment.stiffness;
    const bool elastic = pulled.normal_force > 0 && pulled.normal_force < bolt.segment.capacity;
    pulled.normal_stiffness = elastic ? bolt.segment.stiffness : 0;
    return pulled;
}

std::array<double, 36> tangent_of(std::span<const PairResponse> responses, double resisting) {
    std::array<double, 36> tangent{};
    for (const PairResponse& response : responses) {
        const std::array<double, 6> normal = response.normal.of_both();
        const std::array<double, 6> along = response.along.of_both();
        const double normal_stiffness = response.normal_stiffness + resisting * response.normal_damping;
        const double shear_stiffness = response.shear_stiffness + resisting * response.shear_damping;
        for (std::size_t column = 0; column < 6; ++column) {
            const double pressed = normal_stiffness * normal[column];
            const double sheared = response.coupling * normal[column] + shear_stiffness * along[column];
            for (std::size_t row = 0; row < 6; ++row) {
                tangent[6 * column + row] += pressed * normal[row] + sheared * along[row];
            }
        }
    }
    return tangent;
}

std::array<double, 6> damping_against(const std::array<double, 6>& moved, std::span<const PairResponse> responses) {
    std::array<double, 6> force{};
    for (const PairResponse& response : responses) {
        const auto resist = [&](const PairDirection& direction, double damping) {
            const double by = damping * (direction.x * (moved[0] - moved[3]) + direction.y * (moved[1] - moved[4]) +
                                         direction.lever * moved[2] + direction.other_lever * moved[5]);
            const std::array<double, 6> along = direction.of_both();
            for (std::size_t row = 0; row < 6; ++row) {
                force[row] += by * along[row];
            }
        };
        resist(response.normal, response.normal_damping);
        resist(response.along, response.shear_damping);
    }
    return force;
}

}  // namespace delabole
