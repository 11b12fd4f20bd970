// A section divided into faces that share vertices and edges, so that rounding causes neither gaps nor overlaps.
//
// Half-edges: each edge between two faces is a pair of directed ones, each with its face on the left; an edge of the
// outline has no twin. Vertices are only ever added, and only on edges or as ends of chords between existing ones, so
// that the faces always fill the outline exactly and a convex face that is split leaves convex ones.
#pragma once

#include "geometry/polygon.hpp"

#include <cstdint>
#include <limits>
#include <vector>

namespace delabole {

using MeshIndex = std::uint32_t;
inline constexpr MeshIndex no_index = std::numeric_limits<MeshIndex>::max();

// Names for edges that are not joints.
inline constexpr MeshIndex free_surface = no_index;     // edge of the outline
inline constexpr MeshIndex intact_rock = no_index - 1;  // a division made only to keep blocks convex

struct HalfEdge {
    MeshIndex origin;
    MeshIndex twin;
    MeshIndex next;
    MeshIndex previous;
    MeshIndex face;
    MeshIndex joint;
    MeshIndex segment;
    MeshIndex joint_along;  // of an edge of the outline: the joint that was cut along it, or free_surface
};

// The line from which an edge was cut: its points are interpolated between these ends, whatever the order of divisions.
struct MeshSegment {
    PlanePoint<> first;
    PlanePoint<> second;
};

struct MeshFace {
    MeshIndex edge;  // one of its edges; no_index: merged into another face
    MeshIndex rock;
};

class SectionMesh {
  public:
    // Begins with one face; the outline is anticlockwise.
    SectionMesh(const Polygon<>& outline, MeshIndex rock);

    std::size_t face_count() const { return faces_.size(); }
    bool alive(MeshIndex face) const { return faces_[face].edge != no_index; }
    const MeshFace& face(MeshIndex index) const { return faces_[index]; }
    void set_rock(MeshIndex face, MeshIndex rock) { faces_[face].rock = rock; }
    // The joint of an edge between two faces, or else the one along the outline.
    MeshIndex joint_at(MeshIndex edge) const {
        return edges_[edge].twin == no_index ? edges_[edge].joint_along : edges_[edge].joint;
    }
    void set_joint(MeshIndex edge, MeshIndex joint) {
        if (edges_[edge].twin == no_index) {
            edges_[edge].joint_along = joint;
        } else {
            edges_[edge].joint = edges_[edges_[edge].twin].joint = joint;
        }
    }
    std::size_t edge_count() const { return edges_.size(); }
    const HalfEdge& edge(MeshIndex index) const { return edges_[index]; }
    const std::vector<PlanePoint<>>& points() const { return points_; }
    const MeshSegment& segment_of(MeshIndex edge) const { return segments_[edges_[edge].segment]; }
    const PlanePoint<>& start(MeshIndex edge) const { return points_[edges_[edge].origin]; }
    const PlanePoint<>& end(MeshIndex edge) const { return start(edges_[edge].next); }

    // Calls function(edge) for the edges of a face, anticlockwise.
    template <class Function>
    void for_each_edge(MeshIndex face, Function&& function) const {
        const MeshIndex first = faces_[face].edge;
        MeshIndex edge = first;
        do {
            function(edge);
            edge = edges_[edge].next;
        } while (edge != first);
    }
    Polygon<> outline_of(MeshIndex face) const;

    // Puts a vertex on an edge, in both its faces. The edge keeps its start; the part from the new vertex is returned.
    MeshIndex split_edge(MeshIndex edge, const PlanePoint<>& at);

    // Splits a face along the chord between the starts of two of its edges. The part from `from` to `to` becomes a new
    // face, which is returned.
    MeshIndex split_face(MeshIndex from, MeshIndex to, MeshIndex joint);

    // Whether the faces on both sides of an edge, which has a twin, form one convex face.
    bool union_is_convex(MeshIndex edge) const;
    // Whether the whole common boundary of the two faces at an edge is of one joint.
    bool shares_only(MeshIndex edge, MeshIndex joint) const;
    // Length of the common boundary of the two faces at an edge.
    double shared_length(MeshIndex edge) const;
    // Whether a joint goes on straight beyond an end of the common boundary of the two faces at an edge.
    bool joint_runs_on(MeshIndex edge) const;
    // Removes the common boundary of the two faces at an edge, which has a twin; the face on its left remains.
    void merge(MeshIndex edge);
    // Takes a face away; the edges of its neighbours become free surfaces.
    void remove(MeshIndex face);

  private:
    struct Chain {
        MeshIndex first;
        MeshIndex last;
    };
    Chain shared_chain(MeshIndex edge) const;
    // Whether a joint leaves the start of an edge in a direction.
    bool joint_leaves(MeshIndex edge, const PlanePoint<>& direction) const;

    std::vector<PlanePoint<>> points_ = {};
    std::vector<HalfEdge> edges_ = {};
    std::vector<MeshSegment> segments_ = {};
    std::vector<MeshFace> faces_ = {};
};

// Sine of the anticlockwise turn at b from the direction a-b to b-c: negative where a polygon is not convex.
double sine_of_turn(const PlanePoint<>& a, const PlanePoint<>& b, const PlanePoint<>& c);

// The point between the ends of a segment at these distances from them; neither end is preferred.
PlanePoint<> point_between(const MeshSegment& segment, double from_first, double from_second);

// A corner on a straight face may deviate from it by rounding, far below the tolerance of convexity in dynamic
// relaxation, 1e-9.
inline constexpr double straight_sine = 1e-10;

}  // namespace delabole
