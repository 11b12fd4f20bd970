#include "dynamic_relaxation/blocks/joint_water.hpp"

#include "dynamic_relaxation/blocks/shared_faces.hpp"

#include <algorithm>
#include <utility>

namespace delabole {

namespace {

// The part of an edge that a face covers, limited to the edge where the two are not quite parallel.
EdgePart part_of(const Bodies& bodies, std::size_t edge, const PlanePoint<>& middle, double length) {
    const double centre = bodies.along[edge].dot(middle - bodies.corner[edge]);
    return {std::max(0.0, centre - length / 2), std::min(bodies.length[edge], centre + length / 2)};
}

}  // namespace

std::vector<FacePressure> pressures_of(const JointWater& water, const Bodies& bodies) {
    const std::vector<SharedFace> faces = faces_between(bodies, water.block, water.other);
    if (faces.empty()) {
        return {};
    }
    // Convex blocks touch along one line; positions on it are measured anticlockwise round the block.
    const PlanePoint<> along = bodies.along[faces.front().edge];
    double begin = along.dot(faces.front().arm);
    double end = begin;
    for (const SharedFace& face : faces) {
        begin = std::min(begin, along.dot(face.arm) - face.length / 2);
        end = std::max(end, along.dot(face.arm) + face.length / 2);
    }
    const auto at = [&](double place) {
        // With std::lerp rounding cannot make a zero pressure negative.
        return std::lerp(water.at_first, water.at_second, (place - begin) / (end - begin));
    };
    std::vector<FacePressure> pressures;
    for (const SharedFace& face : faces) {
        const double middle = along.dot(face.arm);
        const double first = at(middle - face.length / 2);
        const double second = at(middle + face.length / 2);
        pressures.push_back({water.block, face.edge - bodies.range[water.block].begin, first, second,
                             part_of(bodies, face.edge, face.arm, face.length), true});
        pressures.push_back({water.other, face.other_edge - bodies.range[water.other].begin, second, first,
                             part_of(bodies, face.other_edge, face.other_arm, face.length), true});
    }
    return pressures;
}

}  // namespace delabole
