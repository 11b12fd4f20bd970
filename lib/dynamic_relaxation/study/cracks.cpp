#include "dynamic_relaxation/study/cracks.hpp"

#include "dynamic_relaxation/blocks/shared_faces.hpp"

#include <cmath>
#include <set>
#include <utility>

namespace delabole {

namespace {

std::size_t edge_of(const Bodies& bodies, std::size_t block, std::size_t edge) {
    return bodies.range[block].begin + edge;
}

}  // namespace

PlanePoint<> carried(const Bodies& bodies, const std::vector<Motion>& motion, std::size_t block,
                     const PlanePoint<>& point) {
    const Motion& moved = motion[block];
    return bodies.centroid[block] + PlanePoint<>(moved.x, moved.y) + moved.turned(point - bodies.centroid[block]);
}

std::vector<BrokenBond> broken_bonds(const RelaxationScene& scene, const Bodies& bodies, const RelaxationState& state) {
    std::vector<BrokenBond> broken;
    for (std::size_t index = 0; index < scene.bond.size(); ++index) {
        const BondMemory& memory = state.bond[index];
        const FaceBond& bond = scene.bond[index];
        if (!is_broken(memory.state) || !bond.of_rock) {
            continue;
        }
        const std::optional<SharedFace> face =
            shared_face(bodies, edge_of(bodies, bond.block, bond.edge), edge_of(bodies, bond.other, bond.other_edge));
        if (face && state.removed[bond.other] == 0) {
            const PlanePoint<> middle = bodies.centroid[bond.other] + face->other_arm;
            const PlanePoint<> half = face->length / 2 * face->along;
            broken.push_back({bond.other, memory.time, middle - half, middle + half});
        }
    }
    return broken;
}

std::vector<OpenJoint> open_joints(const RelaxationScene& scene, const Bodies& bodies, const RelaxationState& state,
                                   double least) {
    std::set<std::pair<std::size_t, std::size_t>> bonded;
    for (const FaceBond& bond : scene.bond) {
        if (!bond.of_rock) {
            continue;
        }
        bonded.emplace(edge_of(bodies, bond.block, bond.edge), edge_of(bodies, bond.other, bond.other_edge));
        bonded.emplace(edge_of(bodies, bond.other, bond.other_edge), edge_of(bodies, bond.block, bond.edge));
    }
    std::vector<OpenJoint> open;
    for (const SharedFace& face : find_shared_faces(bodies)) {
        if (bodies.fixed[face.block] != 0 || bodies.fixed[face.other] != 0 || state.removed[face.block] != 0 ||
            state.removed[face.other] != 0 || bonded.contains({face.edge, face.other_edge})) {
            continue;
        }
        const FacePosition at = locate(face, state.motion[face.block], state.motion[face.other]);
        const double opening = at.widest(face.length);
        if (opening > least && std::abs(at.slide) < face.length) {
            const PlanePoint<> middle = bodies.centroid[face.other] + face.other_arm;
            const PlanePoint<> half = face.length / 2 * face.along;
            open.push_back({carried(bodies, state.motion, face.other, middle - half),
                            carried(bodies, state.motion, face.other, middle + half), opening});
        }
    }
    return open;
}

}  // namespace delabole
