// Single joints, faults with gouge, boundaries of rocks: lines of straight pieces.
//
// At a bend inside a block the block is first divided along the bisector of the bend, so that both pieces of the line
// run from side to side of convex blocks; unnecessary parts of that division are removed at the end.
#include "jointed_slope/cutting_work.hpp"

#include <algorithm>
#include <cmath>
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

// The face that contains a point well inside it; no_index if there is none.
MeshIndex face_around(const SectionMesh& mesh, const PlanePoint<>& point, double snap) {
    for (MeshIndex face = 0; face < mesh.face_count(); ++face) {
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

void divide_at_bend(SectionMesh& mesh, const PlanePoint<>& bend, const PlanePoint<>& halving, double snap) {
    const MeshIndex face = face_around(mesh, bend, snap);
    if (face != no_index) {
        const PlanePoint<> normal = left_of(halving);
        const StraightLine line{normal, halving, normal.dot(bend)};
        cut_face(mesh, face, line, snap, intact_rock, [](double, double) { return true; });
    }
    // The bend lies on an edge: that of the division just made, of one made for the fault's other face, or of a joint.
    put_vertex(mesh, bend, snap);
}

StraightLine line_through(const PlanePoint<>& a, const PlanePoint<>& b) {
    const PlanePoint<> along = (b - a).normalized();
    const PlanePoint<> normal = left_of(along);
    // The mean of both ends' distances, which prefers neither.
    return {normal, along, (normal.dot(a) + normal.dot(b)) / 2};
}

void give_rocks(CuttingWork& work, const Polyline& middle, double half_thickness, const RocksOfLine& rocks) {
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

// Cuts the blocks that a line crosses from side to side.
CutCount cut_pieces(CuttingWork& work, const Polyline& line, MeshIndex joint) {
    CutCount count;
    SectionMesh& mesh = work.mesh;
    for (std::size_t piece = 1; piece < line.size(); ++piece) {
        const StraightLine straight = line_through(line[piece - 1], line[piece]);
        // A cut ends at the corner to which a bend has snapped.
        const double first = straight.place(line[piece - 1]) - 2 * work.snap;
        const double last = straight.place(line[piece]) + 2 * work.snap;
        const auto reaches = [&](double from, double to) { return from >= first && to <= last; };
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
            if (result.cut == FaceCut::dropped) {
                const Chord chord = *find_chord(mesh, face, straight, work.snap);
                const double one = straight.place(chord.rising.at);
                const double other = straight.place(chord.falling.at);
                const bool reached =
                    std::max(one, other) > first + 4 * work.snap && std::min(one, other) < last - 4 * work.snap;
                count.dropped += reached ? 1 : 0;
            }
        }
    }
    return count;
}

// The point at which two straight pieces cross, or at which one of them ends on the other.
std::optional<PlanePoint<>> meeting_point(const MeshSegment& one, const MeshSegment& other, double snap) {
    for (const auto& [ends, along] : {std::pair(one, other), std::pair(other, one)}) {
        const PlanePoint<> direction = (along.second - along.first).normalized();
        for (const PlanePoint<>& end : {ends.first, ends.second}) {
            const double place = direction.dot(end - along.first);
            if (std::abs(left_of(direction).dot(end - along.first)) < snap && place > -snap &&
                direction.dot(along.second - end) > -snap) {
                return end;
            }
        }
    }
    const StraightLine along_one = line_through(one.first, one.second);
    const StraightLine along_other = line_through(other.first, other.second);
    const double from_first = along_other.distance(one.first);
    const double from_second = along_other.distance(one.second);
    const bool cross = (from_first > 0) != (from_second > 0) &&
                       (along_one.distance(other.first) > 0) != (along_one.distance(other.second) > 0);
    return cross ? std::optional(point_between(one, std::abs(from_first), std::abs(from_second))) : std::nullopt;
}

// The direction from a point on a piece of a line, inside a face, to the side of the face that the piece reaches: its
// other end may lie just beyond the point. Where it reaches both sides or none, the longer way.
PlanePoint<> arm_of(const SectionMesh& mesh, MeshIndex face, const MeshSegment& piece, const PlanePoint<>& at,
                    double snap) {
    const StraightLine straight = line_through(piece.first, piece.second);
    const double first = straight.place(piece.first);
    const double last = straight.place(piece.second);
    bool forth = last - straight.place(at) > straight.place(at) - first;
    if (const std::optional<Chord> chord = find_chord(mesh, face, straight, snap)) {
        const double one = straight.place(chord->rising.at);
        const double other = straight.place(chord->falling.at);
        const bool reaches_back = first - 2 * snap <= std::min(one, other);
        const bool reaches_forth = last + 2 * snap >= std::max(one, other);
        forth = reaches_back == reaches_forth ? forth : reaches_forth;
    }
    return forth ? straight.along : PlanePoint<>(-straight.along);
}

// Divides the blocks inside which two lines meet, as at a bend from an arm of one to an arm of the other.
void divide_where_they_meet(CuttingWork& work, const Polyline& one, const Polyline& other) {
    constexpr double least_turn = 0.1;  // rad; lines that differ by less run along each other
    for (std::size_t index = 1; index < one.size(); ++index) {
        const MeshSegment piece{one[index - 1], one[index]};
        for (std::size_t second = 1; second < other.size(); ++second) {
            const MeshSegment other_piece{other[second - 1], other[second]};
            const auto at = meeting_point(piece, other_piece, work.snap);
            const MeshIndex face = at ? face_around(work.mesh, *at, work.snap) : no_index;
            if (face == no_index) {
                continue;
            }
            const PlanePoint<> turn =
                arm_of(work.mesh, face, piece, *at, work.snap) - arm_of(work.mesh, face, other_piece, *at, work.snap);
            if (turn.norm() > least_turn) {
                divide_at_bend(work.mesh, *at, left_of(turn.normalized()), work.snap);
            }
        }
    }
}

}  // namespace

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
    for (const Polyline& face_line : faces.line) {
        const CutCount of_face = cut_pieces(work, face_line, joint);
        count.made += of_face.made;
        count.along += of_face.along;
        count.dropped += of_face.dropped;
    }
    work.drawn.push_back({number, middle, half_thickness, joint, rocks});
    if (half_thickness > 0) {
        work.gouge.push_back(rocks.gouge);
    }
    give_rocks(work, middle, half_thickness, rocks);
    return count;
}

void cut_as_far_as_others(CuttingWork& work, std::vector<CutCount>& count) {
    const auto ends_in_a_block = [&](const DrawnLine& line) {
        return line.half_thickness == 0 && count[line.cut].dropped > 0;
    };
    for (std::size_t one = 0; one < work.drawn.size(); ++one) {
        for (std::size_t other = 0; other < one; ++other) {
            // A line that crosses all blocks from side to side needs no division for another one to end on it.
            if (ends_in_a_block(work.drawn[one]) && ends_in_a_block(work.drawn[other])) {
                divide_where_they_meet(work, work.drawn[one].middle, work.drawn[other].middle);
            }
        }
    }
    bool rocks_change = false;
    for (const DrawnLine& line : work.drawn) {
        if (ends_in_a_block(line)) {
            const CutCount again = cut_pieces(work, line.middle, line.joint);
            count[line.cut] = {count[line.cut].made + again.made, again.dropped, count[line.cut].along + again.along};
            rocks_change = rocks_change || again.made > 0;
        }
    }
    if (rocks_change) {
        for (const DrawnLine& line : work.drawn) {
            give_rocks(work, line.middle, line.half_thickness, line.rocks);
        }
    }
}

}  // namespace delabole
