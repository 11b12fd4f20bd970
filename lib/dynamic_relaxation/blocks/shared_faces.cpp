#include "dynamic_relaxation/blocks/shared_faces.hpp"

#include "dynamic_relaxation/blocks/neighbours.hpp"

#include <algorithm>

namespace delabole {

namespace {

constexpr double near = 1e-3;  // in shortest edges; contacts, too, treat a joint with a smaller initial opening as
                               // closed

}  // namespace

std::optional<SharedFace> shared_face(const Bodies& bodies, std::size_t edge, std::size_t other_edge) {
    const std::size_t block = bodies.block_of[edge];
    const std::size_t other = bodies.block_of[other_edge];
    const PlanePoint<>& along = bodies.along[other_edge];
    if (bodies.along[edge].dot(along) >= 0) {
        return {};
    }
    const double tolerance = near * std::min(bodies.shortest_edge[block], bodies.shortest_edge[other]);
    const PlanePoint<> between = bodies.centroid[block] - bodies.centroid[other];
    const auto from_start = [&](std::size_t corner) -> PlanePoint<> {
        return between + (bodies.corner[corner] - bodies.corner[other_edge]);
    };
    // Anticlockwise outlines run against each other along a shared face.
    const PlanePoint<> last = from_start(edge);
    const PlanePoint<> first = from_start(bodies.range[block].after(edge));
    const PlanePoint<> normal = bodies.normal(other_edge);
    const double begin = std::max(0.0, along.dot(first));
    const double end = std::min(bodies.length[other_edge], along.dot(last));
    if (std::abs(normal.dot(first)) > tolerance || std::abs(normal.dot(last)) > tolerance ||
        !(end - begin > tolerance)) {
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

std::vector<SharedFace> find_shared_faces(const Bodies& bodies) {
    std::vector<SharedFace> faces;
    if (bodies.size() == 0) {
        return faces;  // there is no shortest edge
    }
    const std::vector<Motion> unmoved(bodies.size());
    const std::vector<char> none_removed(bodies.size(), 0);
    const double margin = near * *std::min_element(bodies.shortest_edge.begin(), bodies.shortest_edge.end());
    const std::vector<double> reach(bodies.size(), margin / 2);
    for (const auto& [first, second] : neighbouring_blocks(bodies, unmoved, none_removed, reach)) {
        for (std::size_t edge = bodies.range[first].begin; edge < bodies.range[first].end; ++edge) {
            for (std::size_t other = bodies.range[second].begin; other < bodies.range[second].end; ++other) {
                if (const std::optional<SharedFace> face = shared_face(bodies, edge, other)) {
                    faces.push_back(*face);
                }
            }
        }
    }
    return faces;
}

}  // namespace delabole
