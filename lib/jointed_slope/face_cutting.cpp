#include "jointed_slope/face_cutting.hpp"

namespace delabole {

namespace {

int side_of(double distance, double snap) {
    return distance > snap ? 1 : distance < -snap ? -1 : 0;
}

PlanePoint<> crossing(const MeshSegment& segment, const StraightLine& line) {
    return point_between(segment, std::abs(line.distance(segment.first)), std::abs(line.distance(segment.second)));
}

}  // namespace

std::optional<Chord> find_chord(const SectionMesh& mesh, MeshIndex face, const StraightLine& line, double snap) {
    double lowest = 0;
    double highest = 0;
    MeshIndex below = no_index;
    mesh.for_each_edge(face, [&](MeshIndex edge) {
        const double distance = line.distance(mesh.start(edge));
        if (distance < lowest) {
            lowest = distance;
            below = edge;
        }
        highest = std::max(highest, distance);
    });
    if (!(lowest < -snap) || !(highest > snap)) {
        return std::nullopt;
    }
    Chord chord{};
    int changes = 0;
    int last = -1;
    std::optional<ChordEnd> on_line;
    double nearest = 0;
    MeshIndex edge = below;
    do {
        const MeshIndex next = mesh.edge(edge).next;
        const double there = line.distance(mesh.start(next));
        const int side = side_of(there, snap);
        if (side == 0) {
            if (!on_line || std::abs(there) < nearest) {
                on_line = ChordEnd{next, true, mesh.start(next)};
                nearest = std::abs(there);
            }
        } else {
            if (side != last) {
                ChordEnd& end = side > 0 ? chord.rising : chord.falling;
                end = on_line ? *on_line : ChordEnd{edge, false, crossing(mesh.segment_of(edge), line)};
                ++changes;
            }
            last = side;
            on_line.reset();
        }
        edge = next;
    } while (edge != below);
    return changes == 2 ? std::optional(chord) : std::nullopt;
}

FaceCutResult cut_along(SectionMesh& mesh, const Chord& chord, MeshIndex joint) {
    const auto edge_from = [&](const ChordEnd& end) {
        return end.at_corner ? end.edge : mesh.split_edge(end.edge, end.at);
    };
    const MeshIndex rising = edge_from(chord.rising);
    const MeshIndex falling = edge_from(chord.falling);
    return {FaceCut::made, mesh.split_face(rising, falling, joint)};
}

}  // namespace delabole
