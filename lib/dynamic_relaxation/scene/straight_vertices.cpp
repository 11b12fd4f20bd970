#include "dynamic_relaxation/scene/straight_vertices.hpp"

#include "jointed_slope/section_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace delabole {

namespace {

// Place of an edge of the given outline on an edge of the block.
struct EdgePlace {
    std::size_t edge;
    double begin;  // m, from that edge's first vertex
    double end;
};

bool is_corner(const RelaxationBlock& block, std::size_t vertex) {
    const std::size_t count = block.outline.size();
    const std::size_t before = (vertex + count - 1) % count;
    const bool same_joint = block.joint.empty() || block.joint[before] == block.joint[vertex];
    return !same_joint ||
           !goes_straight_on(block.outline[before], block.outline[vertex], block.outline[(vertex + 1) % count]);
}

// Returns a place for each edge of the given outline; empty if no vertex is left out.
std::vector<EdgePlace> leave_out_straight_vertices(RelaxationBlock& block) {
    const std::size_t count = block.outline.size();
    std::vector<std::size_t> corners;
    for (std::size_t vertex = 0; vertex < count; ++vertex) {
        if (is_corner(block, vertex)) {
            corners.push_back(vertex);
        }
    }
    if (corners.size() == count || corners.size() < 3) {
        return {};
    }
    std::vector<EdgePlace> places(count);
    RelaxationBlock left = block;
    left.outline.clear();
    left.joint.clear();
    for (std::size_t edge = 0; edge < corners.size(); ++edge) {
        const std::size_t first = corners[edge];
        const std::size_t next = corners[(edge + 1) % corners.size()];
        const double length = (block.outline[next] - block.outline[first]).norm();
        double begin = 0;
        for (std::size_t drawn = first; drawn != next; drawn = (drawn + 1) % count) {
            const double drawn_length = (block.outline[(drawn + 1) % count] - block.outline[drawn]).norm();
            const double end = std::min(begin + drawn_length, length);
            places[drawn] = {edge, begin, end};
            begin = end;
        }
        left.outline.push_back(block.outline[first]);
        if (!block.joint.empty()) {
            left.joint.push_back(block.joint[first]);
        }
    }
    block = std::move(left);
    return places;
}

}  // namespace

bool goes_straight_on(const PlanePoint<>& before, const PlanePoint<>& at, const PlanePoint<>& after) {
    return (at - before).dot(after - at) > 0 && std::abs(sine_of_turn(before, at, after)) <= 10 * straight_sine;
}

void leave_out_straight_vertices(RelaxationScene& scene) {
    std::vector<std::vector<EdgePlace>> places;
    for (RelaxationBlock& block : scene.block) {
        const bool has_joints = block.joint.empty() || block.joint.size() == block.outline.size();
        places.push_back(has_joints ? leave_out_straight_vertices(block) : std::vector<EdgePlace>{});
    }
    for (FacePressure& pressure : scene.pressure) {
        if (pressure.block >= places.size() || places[pressure.block].empty()) {
            continue;
        }
        const std::vector<EdgePlace>& of_block = places[pressure.block];
        if (pressure.edge >= of_block.size()) {
            pressure.edge = of_block.size();  // still an edge that does not exist
            continue;
        }
        const EdgePlace& place = of_block[pressure.edge];
        pressure.edge = place.edge;
        // Rounding must not extend a part past the end of the edge.
        pressure.part = pressure.part ? EdgePart{place.begin + pressure.part->begin,
                                                 std::min(place.begin + pressure.part->end, place.end)}
                                      : EdgePart{place.begin, place.end};
    }
}

}  // namespace delabole
