#include "dynamic_relaxation/blocks/shared_faces.hpp"

#include <algorithm>
#include <iterator>

namespace delabole {

std::optional<SharedFace> shared_face(const Bodies& bodies, std::size_t edge, std::size_t other_edge, double opening) {
    const std::size_t block = bodies.block_of[edge];
    const std::size_t other = bodies.block_of[other_edge];
    const PlanePoint<>& along = bodies.along[other_edge];
    if (bodies.along[edge].dot(along) >= 0) {
        return {};
    }
    const double tolerance = opening_of_closed_joint(bodies, block, other, opening);
    const PlanePoint<> between = bodies.centroid[block] - bodies.centroid[other];
    const auto from_start = [&](std::size_t corner) -> PlanePoint<> {
        return between + (bodies.corner[corner] - bodies.corner[other_edge]);
    };
    // Anticlockwise outlines run against each other along a shared face.
    const PlanePoint<> last = from_start(edge);
    const PlanePoint<> first = from_start(bodies.range[block].after(edge));
    const double begin = std::max(0.0, along.dot(first));
    const double end = std::min(bodies.length[other_edge], along.dot(last));
    // Where one edge is longer, its ends may lie farther from the line of the shorter one than the other way round.
    const auto on_line = [&](std::size_t line, const PlanePoint<>& one, const PlanePoint<>& two) {
        const PlanePoint<> normal = bodies.normal(line);
        return std::abs(normal.dot(one)) <= tolerance && std::abs(normal.dot(two)) <= tolerance;
    };
    if (!(end - begin > tolerance) ||
        !(on_line(other_edge, first, last) || on_line(edge, last, last - bodies.length[other_edge] * along))) {
        return {};
    }
    const PlanePoint<> other_arm = bodies.corner[other_edge] + (begin + end) / 2 * along;
    return SharedFace{static_cast<std::uint32_t>(block),
                      static_cast<std::uint32_t>(other),
                      static_cast<std::uint32_t>(edge),
                      static_cast<std::uint32_t>(other_edge),
                      other_arm - between,
                      other_arm,
                      along,
                      end - begin};
}

std::vector<SharedFace> faces_between(const Bodies& bodies, std::size_t block, std::size_t other, double opening) {
    std::vector<SharedFace> faces;
    for (std::size_t edge = bodies.range[block].begin; edge < bodies.range[block].end; ++edge) {
        for (std::size_t other_edge = bodies.range[other].begin; other_edge < bodies.range[other].end; ++other_edge) {
            if (const std::optional<SharedFace> face = shared_face(bodies, edge, other_edge, opening)) {
                faces.push_back(*face);
            }
        }
    }
    return faces;
}

std::array<double, 2> opening_in_drawing(const Bodies& bodies, const SharedFace& face) {
    const PlanePoint<> between = bodies.centroid[face.block] - bodies.centroid[face.other];
    const PlanePoint<> normal = bodies.normal(face.other_edge);
    const auto from_middle = [&](std::size_t corner) -> PlanePoint<> {
        return between + (bodies.corner[corner] - face.other_arm);
    };
    const PlanePoint<> last = from_middle(face.edge);
    const PlanePoint<> first = from_middle(bodies.range[face.block].after(face.edge));
    const double slope = normal.dot(last - first) / face.along.dot(last - first);
    const auto at = [&](double position) { return normal.dot(first) + slope * (position - face.along.dot(first)); };
    return {at(-face.length / 2), at(face.length / 2)};
}

std::vector<BlockPair> touching_blocks(const Bodies& bodies, double opening) {
    const std::vector<Motion> unmoved(bodies.size());
    const std::vector<char> none_removed(bodies.size(), 0);
    // The sum of both is at least the opening of a closed joint.
    std::vector<double> reach(bodies.size());
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        reach[block] = opening_of_closed_joint(bodies, block, block, opening) / 2;
    }
    return neighbouring_blocks(bodies, unmoved, none_removed, reach);
}

std::vector<SharedFace> find_shared_faces(const Bodies& bodies, double opening) {
    std::vector<SharedFace> faces;
    for (const auto& [first, second] : touching_blocks(bodies, opening)) {
        std::ranges::copy(faces_between(bodies, first, second, opening), std::back_inserter(faces));
    }
    return faces;
}

}  // namespace delabole
