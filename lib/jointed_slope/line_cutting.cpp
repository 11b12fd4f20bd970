// Single joints, faults with gouge, boundaries of rocks: lines of straight pieces.
//
// At a bend inside a block the block is first divided along the bisector of the bend, so that both pieces of the line
// run from side to side of convex blocks; unnecessary parts of that division are removed at the end.
#include "jointed_slope/cutting_work.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

namespace delabole {

namespace {

// Both faces of a fault, or the line itself, and the bisectors of its bends.
struct Faces {
    std::vector<Polyline> line;
    Polyline halving;  // bisector at each point; unused at the ends
    bool folds_back = false;
};

Faces faces_of(const Polyline& middle, double half_thickness) {
    Faces faces;
    const std::size_t count = middle.size();
    Polyline normals;
    for (std::size_t index = 1; index < count; ++index) {
        normals.push_back(left_of(middle[index] - middle[index - 1]).normalized());
    }
    Polyline shifts;
    for (std::size_t index = 0; index < count; ++index) {
        const PlanePoint<>& before = normals[index == 0 ? 0 : index - 1];
        const PlanePoint<>& after = normals[std::min(index, count - 2)];
        const PlanePoint<> sum = before + after;
        // Beyond 150 deg a mitre is at least four times as long as the fault is thick.
        constexpr double sharpest = 0.26;
        const double cosine = sum.norm() / 2;
        faces.folds_back = faces.folds_back || !(cosine > sharpest);
        faces.halving.push_back(sum.normalized());
        shifts.push_back(faces.halving.back() * (half_thickness / cosine));
    }
    const std::vector<double> sides = half_thickness > 0 ? std::vector<double>{1, -1} : std::vector<double>{0};
    for (const double side : sides) {
        Polyline line;
        for (std::size_t index = 0; index < count; ++index) {
            line.push_back(middle[index] + side * shifts[index]);
        }
        faces.line.push_back(std::move(line));
    }
    return faces;
}

// Puts a vertex on an edge at a point that lies on it; returns false if it does not.
bool put_vertex(SectionMesh& mesh, MeshIndex edge, const PlanePoint<>& point, double snap) {
    const PlanePoint<> direction = (mesh.end(edge) - mesh.start(edge)).normalized();
    const PlanePoint<> from_start = point - mesh.start(edge);
    const double passed = direction.dot(from_start);
    const double left = direction.dot(mesh.end(edge) - point);
    if (!(std::abs(left_of(direction).dot(from_start)) < snap && passed > snap && left > snap)) {
        return false;
    }
    // The point must lie on the original edge, from which a snapped cut may deviate slightly.
    const MeshSegment& segment = mesh.segment_of(edge);
    mesh.split_edge(edge, point_between(segment, std::abs(direction.dot(point - segment.first)),
                                        std::abs(direction.dot(segment.second - point))));
    return true;
}

void put_vertex(SectionMesh& mesh, const PlanePoint<>& point, double snap) {
    const auto edges = static_cast<MeshIndex>(mesh.edge_count());
    for (MeshIndex edge = 0; edge < edges; ++edge) {
        if (mesh.edge(edge).face != no_index && put_vertex(mesh, edge, point, snap)) {
            return;
        }
    }
}

// Returns the new face; no_index if there is none.
MeshIndex divide_through(SectionMesh& mesh, MeshIndex face, const PlanePoint<>& point, const PlanePoint<>& direction,
                         double snap) {
    const PlanePoint<> normal = left_of(direction);
    const StraightLine line{normal, direction, normal.dot(point)};
    return cut_face(mesh, face, line, snap, intact_rock, [](double, double) { return true; }).beyond;
}

void divide_at_bend(SectionMesh& mesh, const PlanePoint<>& bend, const PlanePoint<>& halving, double snap) {
    std::vector<MeshIndex> all(mesh.face_count());
    std::iota(all.begin(), all.end(), MeshIndex{0});
    if (const MeshIndex face = face_around(mesh, all, bend, snap); face != no_index) {
        divide_through(mesh, face, bend, halving, snap);
    }
    // The bend lies on an edge: that of the division just made, of one made for the fault's other face, or of a joint.
    put_vertex(mesh, bend, snap);
}

// Points at which a line does not bend would divide blocks.
void remove_straight(Polyline& middle, double snap) {
    constexpr double straight = 1e-3;  // of the snap distance
    for (std::size_t index = 1; index + 1 < middle.size();) {
        const StraightLine chord = line_through(middle[index - 1], middle[index + 1]);
        const double place = chord.place(middle[index]);
        if (std::abs(chord.distance(middle[index])) < straight * snap && place > chord.place(middle[index - 1]) &&
            place < chord.place(middle[index + 1])) {
            middle.erase(middle.begin() + static_cast<std::ptrdiff_t>(index));
        } else {
            ++index;
        }
    }
}

// Places between which a line's piece cuts: it ends at the corner to which a bend has snapped.
LinePart reach_of(const StraightLine& straight, const PlanePoint<>& from, const PlanePoint<>& to, double snap) {
    return {straight.place(from) - 2 * snap, straight.place(to) + 2 * snap};
}

// Whether a piece that does not cross a face from side to side ends inside it.
bool ends_in(const SectionMesh& mesh, MeshIndex face, const StraightLine& straight, const LinePart& reach,
             double snap) {
    const std::optional<Chord> chord = find_chord(mesh, face, straight, snap);
    if (!chord) {
        return false;
    }
    const auto [one, other] = std::minmax({straight.place(chord->rising.at), straight.place(chord->falling.at)});
    return other > reach.begin + least_part * snap && one < reach.end - least_part * snap;
}

CutCount cut_pieces(CuttingWork& work, const Polyline& line, MeshIndex joint) {
    CutCount count;
    SectionMesh& mesh = work.mesh;
    for (std::size_t piece = 1; piece < line.size(); ++piece) {
        const StraightLine straight = line_through(line[piece - 1], line[piece]);
        const LinePart reach = reach_of(straight, line[piece - 1], line[piece], work.snap);
        const auto reaches = [&](double from, double to) { return from >= reach.begin && to <= reach.end; };
        for (MeshIndex edge = 0; edge < mesh.edge_count(); ++edge) {
            for (const PlanePoint<>& end : {line[piece - 1], line[piece]}) {
                if (work.is_stronger_along(edge, straight, joint)) {
                    put_vertex(mesh, edge, end, work.snap);
                }
            }
            count.along += work.weaken(edge, straight, joint, reaches) ? 1 : 0;
        }
        const std::size_t before = mesh.face_count();
        for (MeshIndex face = 0; face < before; ++face) {
            const FaceCutResult result = cut_face(mesh, face, straight, work.snap, joint, reaches);
            count.made += result.cut == FaceCut::made ? 1 : 0;
            count.dropped += result.cut == FaceCut::dropped && ends_in(mesh, face, straight, reach, work.snap) ? 1 : 0;
        }
    }
    return count;
}

}  // namespace

MeshIndex face_around(const SectionMesh& mesh, std::span<const MeshIndex> faces, const PlanePoint<>& point,
                      double snap) {
    for (const MeshIndex face : faces) {
        bool inside = mesh.alive(face);
        if (inside) {
            mesh.for_each_edge(face, [&](MeshIndex edge) {
                const PlanePoint<> along = mesh.end(edge) - mesh.start(edge);
                inside = inside && left_of(along).dot(point - mesh.start(edge)) > snap * along.norm();
            });
        }
        if (inside) {
            return face;
        }
    }
    return no_index;
}

MeshIndex divide_around(SectionMesh& mesh, MeshIndex face, const PlanePoint<>& point, const PlanePoint<>& direction,
                        double snap) {
    const MeshIndex beyond = divide_through(mesh, face, point, direction, snap);
    if (beyond == no_index) {
        return no_index;
    }
    std::vector<MeshIndex> edges;
    mesh.for_each_edge(beyond, [&](MeshIndex edge) { edges.push_back(edge); });
    for (const MeshIndex edge : edges) {
        if (put_vertex(mesh, edge, point, snap)) {
            break;
        }
    }
    return beyond;
}

StraightLine line_through(const PlanePoint<>& a, const PlanePoint<>& b) {
    const PlanePoint<> along = (b - a).normalized();
    const PlanePoint<> normal = left_of(along);
    // The mean of both ends' distances, which prefers neither.
    return {normal, along, (normal.dot(a) + normal.dot(b)) / 2};
}

void give_rocks(CuttingWork& work, const DrawnLine& line) {
    const Polyline& middle = line.middle;
    const double half_thickness = line.half_thickness;
    const RocksOfLine& rocks = line.rocks;
    if (half_thickness == 0 && rocks.above == no_index && rocks.below == no_index) {
        return;
    }
    SectionMesh& mesh = work.mesh;
    for (MeshIndex face = 0; face < mesh.face_count(); ++face) {
        if (half_thickness > 0) {
            bool between = true;
            mesh.for_each_edge(face, [&](MeshIndex edge) {
                // At a bend a mitre extends beyond the thickness.
                between = between && std::abs(signed_distance(middle, mesh.start(edge))) < 4 * half_thickness;
            });
            if (between && std::abs(signed_distance(middle, centroid_of(mesh, face))) < half_thickness) {
                mesh.set_rock(face, rocks.gouge);
                continue;
            }
        }
        if (rocks.above == no_index && rocks.below == no_index) {
            continue;
        }
        const bool above = signed_distance(middle, centroid_of(mesh, face)) > 0;
        const MeshIndex rock = above ? rocks.above : rocks.below;
        if (rock != no_index) {
            mesh.set_rock(face, rock);
        }
    }
}

CutCount cut_lines(CuttingWork& work, const std::vector<Polyline>& lines, MeshIndex joint) {
    CutCount sum;
    for (const Polyline& line : lines) {
        const CutCount one = cut_pieces(work, line, joint);
        sum = {sum.made + one.made, sum.dropped + one.dropped, sum.along + one.along};
    }
    return sum;
}

CutCount cut_line(CuttingWork& work, const SlopeCut& named, const LineCut& line, std::size_t number, MeshIndex joint,
                  const RocksOfLine& rocks, SlopeCheck& check) {
    CutCount count;
    SectionMesh& mesh = work.mesh;
    Polyline middle;
    for (const SectionPoint& point : line.vertex) {
        const PlanePoint<> at = PlanePoint<>(point.x, point.y) - work.origin;
        if (middle.empty() || (at - middle.back()).norm() > work.snap) {
            middle.push_back(at);
        }
    }
    remove_straight(middle, work.snap);
    if (middle.size() < 2) {
        check = SlopeCheck::line_too_short;
        return count;
    }
    const PlanePoint<> direction = middle.back() - middle.front();
    if (direction.x() < 0 || (direction.x() == 0 && direction.y() < 0)) {
        std::reverse(middle.begin(), middle.end());
    }
    work.line[named.name] = middle;
    const double half_thickness = line.thickness.value_or(0) / 2;
    const Faces faces = faces_of(middle, half_thickness);
    if (faces.folds_back) {
        check = SlopeCheck::line_folds_back;
        return count;
    }
    for (const Polyline& face_line : faces.line) {
        for (std::size_t bend = 1; bend + 1 < face_line.size(); ++bend) {
            divide_at_bend(mesh, face_line[bend], faces.halving[bend], work.snap);
        }
    }
    count = cut_lines(work, faces.line, joint);
    if (half_thickness > 0) {
        work.gouge.push_back(rocks.gouge);
    }
    work.drawn.push_back({number, middle, faces.line, half_thickness, joint, rocks});
    give_rocks(work, work.drawn.back());
    return count;
}

std::vector<Polyline> lines_to_finish(const CuttingWork& work, const DrawnLine& line) {
    if (line.half_thickness == 0) {
        return line.face;
    }
    std::vector<MeshIndex> all(work.mesh.face_count());
    std::iota(all.begin(), all.end(), MeshIndex{0});
    std::vector<Polyline> lines = line.face;
    for (Polyline& points : lines) {
        const auto run_on = [&](PlanePoint<>& end, const PlanePoint<>& before) {
            if (face_around(work.mesh, all, end, work.snap) != no_index) {
                end += 2 * line.half_thickness * (end - before).normalized();
            }
        };
        run_on(points.front(), points[1]);
        run_on(points.back(), points[points.size() - 2]);
    }
    return lines;
}

std::vector<UnfinishedPart> unfinished_parts(const CuttingWork& work, const DrawnLine& line) {
    std::vector<UnfinishedPart> unfinished;
    for (const Polyline& points : lines_to_finish(work, line)) {
        for (std::size_t piece = 1; piece < points.size(); ++piece) {
            const MeshSegment segment{points[piece - 1], points[piece]};
            const StraightLine straight = line_through(segment.first, segment.second);
            const LinePart reach = reach_of(straight, segment.first, segment.second, work.snap);
            for (MeshIndex face = 0; face < work.mesh.face_count(); ++face) {
                if (ends_in(work.mesh, face, straight, reach, work.snap)) {
                    unfinished.push_back({face, line.cut, segment});
                }
            }
        }
    }
    return unfinished;
}

}  // namespace delabole
