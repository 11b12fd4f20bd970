#include "dynamic_relaxation/blocks/overlap.hpp"

#include "dynamic_relaxation/blocks/neighbours.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace delabole {

namespace {

// Outline of a moved block about the centroid of `origin` in the initial geometry, so that coordinates keep their
// digits far from zero.
Polygon<> moved_outline(const Bodies& bodies, const std::vector<Motion>& motion, std::size_t block,
                        std::size_t origin) {
    const Motion& moved = motion[block];
    const PlanePoint<> centroid = (bodies.centroid[block] - bodies.centroid[origin]) + PlanePoint<>(moved.x, moved.y);
    Polygon<> outline;
    for (std::size_t corner = bodies.range[block].begin; corner < bodies.range[block].end; ++corner) {
        outline.emplace_back(centroid + moved.turned(bodies.corner[corner]));
    }
    return outline;
}

// Penetration depth: the shortest displacement normal to an edge of `of` that separates the polygons; not positive
// where they do not overlap.
double penetration_depth(const Polygon<>& of, const Polygon<>& other) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t vertex = 0; vertex < of.size(); ++vertex) {
        const PlanePoint<>& from = of[vertex];
        const PlanePoint<> along = (of[vertex + 1 < of.size() ? vertex + 1 : 0] - from).normalized();
        double deepest = -std::numeric_limits<double>::infinity();
        for (const PlanePoint<>& corner : other) {
            deepest = std::max(deepest, along.x() * (corner.y() - from.y()) - along.y() * (corner.x() - from.x()));
        }
        least = std::min(least, deepest);
    }
    return least;
}

double common_area(Polygon<> one, const Polygon<>& other) {
    for (std::size_t vertex = 0; vertex < other.size() && !one.empty(); ++vertex) {
        one = clip(one, HalfPlane<>{other[vertex], other[vertex + 1 < other.size() ? vertex + 1 : 0]});
    }
    return area_properties(one).area;
}

}  // namespace

std::optional<BlockOverlap> greatest_overlap(const Bodies& bodies, const std::vector<Motion>& motion,
                                             const std::vector<char>& removed) {
    std::optional<BlockOverlap> greatest;
    for (const auto& [block, other] :
         neighbouring_blocks(bodies, motion, removed, std::vector<double>(bodies.size(), 0))) {
        const Polygon<> one = moved_outline(bodies, motion, block, block);
        const Polygon<> two = moved_outline(bodies, motion, other, block);
        const double depth = std::min(penetration_depth(one, two), penetration_depth(two, one));
        const double share = depth / std::min(bodies.shortest_edge[block], bodies.shortest_edge[other]);
        if (share > (greatest ? greatest->share : 0)) {
            greatest = BlockOverlap{block, other, depth, share, common_area(one, two)};
        }
    }
    return greatest;
}

}  // namespace delabole
