#include "dynamic_relaxation/statics/pair_response.hpp"

namespace delabole {

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

}  // namespace delabole
