// Cutting one convex face of a section along a straight line.
//
// A corner nearer to the line than the snap distance counts as on it: the cut then passes through the corner, and bends
// by no more than that distance. Both faces at an edge find the same point on it, and no edge becomes shorter than the
// snap distance except by a reported repair, so that dynamic relaxation accepts the blocks.
#pragma once

#include "jointed_slope/section_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace delabole {

// The points p with normal . p = position. For a mirrored section all parts are mirror images to the last bit.
struct StraightLine {
    PlanePoint<> normal;
    PlanePoint<> along;
    double position;

    double distance(const PlanePoint<>& point) const {
        return normal.x() * point.x() + normal.y() * point.y() - position;
    }
    double place(const PlanePoint<>& point) const { return along.x() * point.x() + along.y() * point.y(); }
    PlanePoint<> at(double place) const { return position * normal + place * along; }
};

enum class FaceCut {
    missed,   // the line passes beside the face, or along one of its edges
    dropped,  // the line crosses the face, but the joint does not reach from side to side, or would cut off too small a
              // part
    made,
};

struct FaceCutResult {
    FaceCut cut = FaceCut::missed;
    MeshIndex beyond = no_index;  // the part on the side of the normal
};

struct ChordEnd {
    MeshIndex edge;  // edge that begins at the end, or on which the end lies
    bool at_corner;
    PlanePoint<> at;
};

struct Chord {
    ChordEnd rising;  // where the outline, anticlockwise, crosses to the side of the normal
    ChordEnd falling;
};

// Returns nothing if the face does not lie on both sides of the line.
std::optional<Chord> find_chord(const SectionMesh& mesh, MeshIndex face, const StraightLine& line, double snap);

FaceCutResult cut_along(SectionMesh& mesh, const Chord& chord, MeshIndex joint);

// `allowed(first, last)` returns whether the joint extends along the line from one place to the other.
template <class Allowed>
FaceCutResult cut_face(SectionMesh& mesh, MeshIndex face, const StraightLine& line, double snap, MeshIndex joint,
                       Allowed&& allowed) {
    const std::optional<Chord> chord = find_chord(mesh, face, line, snap);
    if (!chord) {
        return {};
    }
    const double one = line.place(chord->rising.at);
    const double other = line.place(chord->falling.at);
    // Near the tip of a wedge a cut could be arbitrarily short; one shorter than a block's face may be is not made.
    if (!(std::abs(one - other) >= snap) || !allowed(std::min(one, other), std::max(one, other))) {
        return {FaceCut::dropped, no_index};
    }
    return cut_along(mesh, *chord, joint);
}

}  // namespace delabole
