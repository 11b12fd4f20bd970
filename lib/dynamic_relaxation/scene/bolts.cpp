#include "dynamic_relaxation/scene/bolts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace delabole {

namespace {

// The part of a line that lies inside a block, m from the line's beginning.
struct Stretch {
    std::size_t block;
    double begin;
    double end;
};

// Returns nothing where the line lies outside a convex outline or only touches it.
std::optional<Stretch> stretch_in(const Polygon<>& outline, const PlanePoint<>& from, const PlanePoint<>& along,
                                  double length) {
    Stretch inside{0, 0, length};
    for (std::size_t corner = 0; corner < outline.size(); ++corner) {
        const PlanePoint<> edge = outline[(corner + 1) % outline.size()] - outline[corner];
        const PlanePoint<> inward(-edge.y(), edge.x());
        const double distance = inward.dot(from - outline[corner]);
        const double approach = inward.dot(along);
        if (approach == 0) {
            if (distance < 0) {
                return std::nullopt;
            }
            continue;
        }
        double& bound = approach > 0 ? inside.begin : inside.end;
        bound = approach > 0 ? std::max(bound, -distance / approach) : std::min(bound, -distance / approach);
    }
    constexpr double touch = 1e-9;
    return inside.end - inside.begin > touch * length ? std::optional(inside) : std::nullopt;
}

bool is_there_at_first(const RelaxationScene& scene, std::size_t block) {
    return std::ranges::none_of(scene.removal,
                                [&](const Removal& removal) { return removal.block == block && removal.time < 0; });
}

// Returns the least x of the outline at this height. Above and below the outline the result is not finite.
double face_at(const std::vector<SectionPoint>& outline, double y) {
    double face = std::numeric_limits<double>::infinity();
    for (std::size_t corner = 0; corner < outline.size(); ++corner) {
        const SectionPoint& from = outline[corner];
        const SectionPoint& to = outline[(corner + 1) % outline.size()];
        if (std::min(from.y, to.y) <= y && y <= std::max(from.y, to.y)) {
            face = std::min(face, from.y == to.y ? std::min(from.x, to.x)
                                                 : from.x + (to.x - from.x) * (y - from.y) / (to.y - from.y));
        }
    }
    return face;
}

}  // namespace

std::vector<RelaxationBolt> all_bolts(const Relaxation& model) {
    std::vector<RelaxationBolt> bolts = model.bolt;
    const auto* slope = std::get_if<RelaxationSlope>(&model.scene);
    if (slope == nullptr || slope->geometry.outline.empty()) {
        return bolts;
    }
    const std::vector<SectionPoint>& outline = slope->geometry.outline;
    const double lowest = std::ranges::min(outline, {}, &SectionPoint::y).y;
    for (const BoltRows& support : model.support) {
        for (int row = 0; row < support.rows; ++row) {
            const double y = lowest + support.lowest_height + row * support.row_spacing;
            bolts.push_back({face_at(outline, y), y, support.bar});
        }
    }
    return bolts;
}

std::vector<BoltSegment> bolt_segments(const RelaxationScene& scene, const RelaxationBolt& bolt, std::size_t index) {
    const PlanePoint<> head(bolt.head_x, bolt.head_y);
    const PlanePoint<> along(std::cos(bolt.bar.plunge), -std::sin(bolt.bar.plunge));
    std::vector<Stretch> crossed;
    for (std::size_t block = 0; block < scene.block.size(); ++block) {
        const Polygon<>& outline = scene.block[block].outline;
        auto stretch = outline.size() >= 3 ? stretch_in(outline, head, along, bolt.bar.length) : std::nullopt;
        if (stretch && is_there_at_first(scene, block)) {
            stretch->block = block;
            crossed.push_back(*stretch);
        }
    }
    std::ranges::sort(crossed, {}, &Stretch::begin);
    // The given head may deviate from a face by rounding.
    const double tolerance = 1e-3 * bolt.bar.length;
    if (!std::isfinite(bolt.head_x) || crossed.size() < 2 || crossed.front().begin > tolerance ||
        crossed.back().end < bolt.bar.length - tolerance) {
        constexpr std::size_t nowhere = static_cast<std::size_t>(-1);
        return {{index, nowhere, nowhere, head, head, 0, 0, 0}};
    }
    const auto segment = [&](const Stretch& one, const Stretch& other, double begin, double end) {
        const double capacity = bolt.bar.free_length_at_joints ? force_of_bolt(bolt.bar.capacity, bolt.bar.grout,
                                                                               bolt.bar.length, (begin + end) / 2)
                                                               : bolt.bar.capacity;
        return BoltSegment{index,
                           one.block,
                           other.block,
                           head + begin * along,
                           head + end * along,
                           bolt.bar.axial_stiffness / (end - begin) / bolt.bar.spacing,
                           std::min(bolt.bar.pretension.value_or(0), capacity) / bolt.bar.spacing,
                           capacity / bolt.bar.spacing};
    };
    if (!bolt.bar.free_length_at_joints) {
        return {segment(crossed.front(), crossed.back(), 0, bolt.bar.length)};
    }
    std::vector<BoltSegment> segments;
    const double half = *bolt.bar.free_length_at_joints / 2;
    for (std::size_t next = 1; next < crossed.size(); ++next) {
        const double joint = (crossed[next - 1].end + crossed[next].begin) / 2;
        segments.push_back(segment(crossed[next - 1], crossed[next], joint - half, joint + half));
    }
    return segments;
}

}  // namespace delabole
