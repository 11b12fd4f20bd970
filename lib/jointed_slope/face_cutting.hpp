// Cutting one convex face of a section along a straight line.
//
// A corner nearer to the line than the snap distance counts as on it: the cut then runs through the corner, bent by no
// more than that. Both faces beside an edge find the same point on it, and no edge becomes shorter than the snap
// distance but by a stated repair, so that the blocks are ones that the engine takes.
#pragma once

#include "jointed_slope/section_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace delabole {

// The points p with normal . p = position. Of a mirrored section all parts are the mirrored ones to the last bit.
struct StraightLine {
    PlanePoint<> normal;
    PlanePoint<> along;
    double position;

    double distance(const PlanePoint<>& point) const {
        return normal.x() * point.x() + normal.y() * point.y() - position;
    }
    double place(const PlanePoint<>& point) const { return along.x() * point.x() + along.y() * point.y(); }
};

enum class FaceCut {
    missed,   // the line passes beside the face, or along one of its edges
    dropped,  // it would cut the face, but does not reach from side to side, or would cut off less than can be kept
    made,
};

struct FaceCutResult {
    FaceCut cut = FaceCut::missed;
    MeshIndex beyond = no_index;  // the part on the side of the normal
};

struct ChordEnd {
    MeshIndex edge;  // that begins at the end, or on which the end lies
    bool at_corner;
    PlanePoint<> at;
};

struct Chord {
    ChordEnd rising;  // where the outline, anticlockwise, comes over to the side of the normal
    ChordEnd falling;
};

// Returns nothing where the face does not lie on both sides of the line.
std::optional<Chord> find_chord(const SectionMesh& mesh, MeshIndex face, const StraightLine& line, double snap);

FaceCutResult cut_along(SectionMesh& mesh, const Chord& chord, MeshIndex joint);

// `allowed(first, last)` says whether the joint reaches along the line from one place to the other.
template <class Allowed>
FaceCutResult cut_face(SectionMesh& mesh, MeshIndex face, const StraightLine& line, double snap, MeshIndex joint,
                       Allowed&& allowed) {
    const std::optional<Chord> chord = find_chord(mesh, face, line, snap);
    if (!chord) {
        return {};
    }
    const double one = line.place(chord->rising.at);
    const double other = line.place(chord->falling.at);
    // Across the tip of a wedge a cut may be as short as it likes: too short for a face of a block.
    if (!(std::abs(one - other) >= snap) || !allowed(std::min(one, other), std::max(one, other))) {
        return {FaceCut::dropped, no_index};
    }
    return cut_along(mesh, *chord, joint);
}

}  // namespace delabole
