#include "dynamic_relaxation/blocks/shared_faces.hpp"

#include "numerics/constants.hpp"

#include <algorithm>
#include <iterator>

namespace delabole {

namespace {

// Less is rounding, with nothing in between; m.
double least_gap(const Bodies& bodies, std::size_t block, std::size_t other) {
    constexpr double rounding = 1e-9;  // of the shortest edge
    return rounding * std::min(bodies.shortest_edge[block], bodies.shortest_edge[other]);
}

// How far a block reaches along a direction.
double extent_along(const Bodies& bodies, std::size_t block, const PlanePoint<>& direction) {
    double least = infinity;
    double greatest = -infinity;
    for (std::size_t corner = bodies.range[block].begin; corner < bodies.range[block].end; ++corner) {
        const double at = direction.dot(bodies.corner[corner]);
        least = std::min(least, at);
        greatest = std::max(greatest, at);
    }
    return greatest - least;
}

}  // namespace

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

BlocksBetween::BlocksBetween(const Bodies& bodies, const std::vector<BlockPair>& near, const std::vector<char>& gone)
    : bodies_(bodies), near_(bodies.size()) {
    const auto is_there = [&](std::size_t block) { return gone.empty() || gone[block] == 0; };
    for (const auto& [first, second] : near) {
        if (is_there(second)) {
            near_[first].push_back(second);
        }
        if (is_there(first)) {
            near_[second].push_back(first);
        }
    }
}

// Whether any third block near these two matches at some depth of the gap, as a share of it. At one depth two thirds
// may meet. Two fixed blocks are not listed as near, but one of these two is free; of two free blocks the one with
// fewer neighbours is asked.
template <class Matches>
bool BlocksBetween::any_near(std::size_t block, std::size_t other, const Matches& matches) const {
    const bool of_other =
        bodies_.fixed[block] != 0 || (bodies_.fixed[other] == 0 && near_[other].size() < near_[block].size());
    return std::ranges::any_of(near_[of_other ? other : block], [&](std::size_t third) {
        const auto matches_at = [&](double depth) { return matches(third, depth); };
        return third != block && third != other && std::ranges::any_of(std::array{0.5, 0.41, 0.59}, matches_at);
    });
}

bool BlocksBetween::part(const SharedFace& face) const {
    constexpr double thin = 2;            // joint openings
    constexpr double much_of_face = 0.1;  // neighbours at its ends reach in by rounding
    const std::array<double, 2> open = opening_in_drawing(bodies_, face);
    const double opening = std::max(open[0], open[1]);
    if (opening <= least_gap(bodies_, face.block, face.other)) {
        return false;
    }
    const PlanePoint<> normal = bodies_.normal(face.other_edge);
    const PlanePoint<> half = face.length / 2 * face.along;
    return any_near(face.block, face.other, [&](std::size_t third, double depth) {
        const PlanePoint<> middle = bodies_.centroid[face.other] - bodies_.centroid[third] + face.other_arm;
        const double share =
            share_inside(third, middle - half + depth * open[0] * normal, middle + half + depth * open[1] * normal);
        return share > much_of_face || (share * face.length > bodies_.shortest_edge[third] / 2 &&
                                        extent_along(bodies_, third, normal) <= thin * opening);
    });
}

bool BlocksBetween::part(std::size_t corner, std::size_t other_edge, double gap) const {
    const std::size_t block = bodies_.block_of[corner];
    const std::size_t other = bodies_.block_of[other_edge];
    if (gap <= least_gap(bodies_, block, other)) {
        return false;
    }
    // A corner may lie just above the end of what lies between.
    constexpr double enough = 0.25;
    const PlanePoint<> tip = bodies_.centroid[block] + bodies_.corner[corner];
    const PlanePoint<> beside = opening_of_closed_joint(bodies_, block, other) * bodies_.along[other_edge];
    return any_near(block, other, [&](std::size_t third, double depth) {
        const PlanePoint<> at = tip - depth * gap * bodies_.normal(other_edge) - bodies_.centroid[third];
        return share_inside(third, at - beside, at + beside) > enough;
    });
}

// The share of the way between two points about the third block's centroid that lies inside it.
double BlocksBetween::share_inside(std::size_t third, const PlanePoint<>& from, const PlanePoint<>& to) const {
    double begin = 0;
    double end = 1;
    for (std::size_t edge = bodies_.range[third].begin; edge < bodies_.range[third].end; ++edge) {
        const double outside_from = bodies_.normal(edge).dot(from - bodies_.corner[edge]);
        const double outside_to = bodies_.normal(edge).dot(to - bodies_.corner[edge]);
        if (outside_from > 0 && outside_to > 0) {
            return 0;
        }
        const double crossing = outside_from / (outside_from - outside_to);
        begin = outside_from > 0 ? std::max(begin, crossing) : begin;
        end = outside_to > 0 ? std::min(end, crossing) : end;
    }
    return std::max(end - begin, 0.0);
}

std::vector<SharedFace> find_shared_faces(const Bodies& bodies, double opening, const std::vector<char>& gone) {
    std::vector<SharedFace> faces;
    const std::vector<BlockPair> pairs = touching_blocks(bodies, opening);
    for (const auto& [first, second] : pairs) {
        std::ranges::copy(faces_between(bodies, first, second, opening), std::back_inserter(faces));
    }
    const auto is_open = [&](const SharedFace& face) {
        return std::ranges::max(opening_in_drawing(bodies, face)) > least_gap(bodies, face.block, face.other);
    };
    if (std::ranges::any_of(faces, is_open)) {
        const BlocksBetween between(bodies, pairs, gone);
        std::erase_if(faces, [&](const SharedFace& face) { return between.part(face); });
    }
    return faces;
}

}  // namespace delabole
