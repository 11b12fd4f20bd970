// Repair and check of the outline of a section, and its division into convex parts.
#include "jointed_slope/cutting_work.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>

namespace delabole {

namespace {

double distance_to_segment(const PlanePoint<>& point, const PlanePoint<>& a, const PlanePoint<>& b) {
    const PlanePoint<> along = b - a;
    const double position = std::clamp((point - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
    return (point - a - position * along).norm();
}

bool segments_cross(const PlanePoint<>& a, const PlanePoint<>& b, const PlanePoint<>& c, const PlanePoint<>& d) {
    return (cross(b - a, c - a) > 0) != (cross(b - a, d - a) > 0) &&
           (cross(d - c, a - c) > 0) != (cross(d - c, b - c) > 0);
}

bool come_near(const PlanePoint<>& a, const PlanePoint<>& b, const PlanePoint<>& c, const PlanePoint<>& d,
               double snap) {
    const auto apart = [&](double one_low, double one_high, double two_low, double two_high) {
        return one_high + snap < two_low || two_high + snap < one_low;
    };
    if (apart(std::min(a.x(), b.x()), std::max(a.x(), b.x()), std::min(c.x(), d.x()), std::max(c.x(), d.x())) ||
        apart(std::min(a.y(), b.y()), std::max(a.y(), b.y()), std::min(c.y(), d.y()), std::max(c.y(), d.y()))) {
        return false;
    }
    return segments_cross(a, b, c, d) || distance_to_segment(a, c, d) < snap || distance_to_segment(b, c, d) < snap ||
           distance_to_segment(c, a, b) < snap || distance_to_segment(d, a, b) < snap;
}

struct Ray {
    MeshIndex edge = no_index;  // edge that is hit, or that begins at the corner hit
    bool at_corner = false;
    PlanePoint<> at = {0, 0};
    double clearance = 0;  // distance of other corners from the ray
};

// The point at which a ray from the start of an edge into its face meets the outline.
std::optional<Ray> cast(const SectionMesh& mesh, MeshIndex from, const PlanePoint<>& direction, double snap) {
    const PlanePoint<>& start = mesh.start(from);
    double nearest = std::numeric_limits<double>::infinity();
    Ray ray;
    mesh.for_each_edge(mesh.edge(from).face, [&](MeshIndex edge) {
        if (edge == from || edge == mesh.edge(from).previous) {
            return;
        }
        const PlanePoint<> a = mesh.start(edge) - start;
        const PlanePoint<> b = mesh.end(edge) - start;
        const double of_a = cross(direction, a);
        const double of_b = cross(direction, b);
        // The ray leaves the face where the anticlockwise outline crosses it from right to left.
        if (!(of_a <= 0 && of_b > 0)) {
            return;
        }
        const double place = (a.dot(direction) * of_b - b.dot(direction) * of_a) / (of_b - of_a);
        if (place > 0 && place < nearest) {
            nearest = place;
            ray.edge = edge;
            ray.at = start + place * direction;
        }
    });
    if (ray.edge == no_index) {
        return std::nullopt;
    }
    for (const MeshIndex corner : {ray.edge, mesh.edge(ray.edge).next}) {
        if ((mesh.start(corner) - ray.at).norm() < snap) {
            ray.edge = corner;
            ray.at = mesh.start(corner);
            ray.at_corner = true;
            break;
        }
    }
    if (ray.at_corner && (ray.edge == mesh.edge(from).next || ray.edge == mesh.edge(from).previous)) {
        return std::nullopt;
    }
    ray.clearance = std::numeric_limits<double>::infinity();
    mesh.for_each_edge(mesh.edge(from).face, [&](MeshIndex edge) {
        const bool end = edge == from || (ray.at_corner && edge == ray.edge);
        if (!end) {
            ray.clearance = std::min(ray.clearance, distance_to_segment(mesh.start(edge), start, ray.at));
        }
    });
    return ray;
}

MeshIndex inward_corner(const SectionMesh& mesh, MeshIndex face) {
    MeshIndex worst = no_index;
    double least = -straight_sine;
    mesh.for_each_edge(face, [&](MeshIndex edge) {
        const double sine = sine_of_turn(mesh.start(mesh.edge(edge).previous), mesh.start(edge), mesh.end(edge));
        if (sine < least) {
            least = sine;
            worst = edge;
        }
    });
    return worst;
}

}  // namespace

PlanePoint<> centroid_of(const SectionMesh& mesh, MeshIndex face) {
    return area_properties(mesh.outline_of(face)).centroid;
}

Polygon<> prepared_outline(const SlopeGeometry& geometry, JointedSection& section) {
    Polygon<> outline;
    for (const SectionPoint& point : geometry.outline) {
        const PlanePoint<> at(point.x, point.y);
        if (!outline.empty() && at == outline.back()) {
            ++section.corners_dropped;
            continue;
        }
        outline.push_back(at);
    }
    while (outline.size() > 1 && outline.back() == outline.front()) {
        outline.pop_back();
        ++section.corners_dropped;
    }
    if (area_properties(outline).area < 0) {
        section.outline_reversed = true;
        std::reverse(outline.begin() + 1, outline.end());
    }
    return outline;
}

std::optional<std::size_t> crossing_edge(const Polygon<>& outline, double snap) {
    const std::size_t count = outline.size();
    for (std::size_t one = 0; one < count; ++one) {
        const PlanePoint<>& a = outline[one];
        const PlanePoint<>& b = outline[(one + 1) % count];
        if ((b - a).norm() < snap) {
            return one;
        }
        // The next edge may only continue, not fold back on this one.
        const PlanePoint<>& next = outline[(one + 2) % count];
        if (distance_to_segment(next, a, b) < snap || distance_to_segment(a, b, next) < snap) {
            return one;
        }
        for (std::size_t other = one + 2; other < count; ++other) {
            if ((other + 1) % count != one && come_near(a, b, outline[other], outline[(other + 1) % count], snap)) {
                return one;
            }
        }
    }
    return std::nullopt;
}

void divide_into_convex(SectionMesh& mesh, double snap) {
    std::vector<MeshIndex> open{0};
    while (!open.empty()) {
        const MeshIndex face = open.back();
        const MeshIndex corner = inward_corner(mesh, face);
        if (corner == no_index) {
            open.pop_back();
            continue;
        }
        const PlanePoint<> in = (mesh.start(corner) - mesh.start(mesh.edge(corner).previous)).normalized();
        const PlanePoint<> out = (mesh.end(corner) - mesh.start(corner)).normalized();
        // Any direction between the continuations of both edges leaves two convex corners.
        const std::array<PlanePoint<>, 5> directions{PlanePoint<>(in - out), PlanePoint<>(2 * in - out),
                                                     PlanePoint<>(in - 2 * out), in, PlanePoint<>(-out)};
        std::optional<Ray> best;
        for (const PlanePoint<>& direction : directions) {
            const std::optional<Ray> ray = cast(mesh, corner, direction.normalized(), snap);
            if (ray && (!best || ray->clearance > best->clearance)) {
                best = ray;
            }
            if (best && best->clearance > 10 * snap) {
                break;
            }
        }
        if (!best) {
            return;
        }
        const MeshIndex end = best->at_corner ? best->edge : mesh.split_edge(best->edge, best->at);
        open.push_back(mesh.split_face(corner, end, intact_rock));
    }
}

}  // namespace delabole
