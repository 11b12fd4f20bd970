// The common state of the steps of cutting a slope; see jointed_section.hpp.
#pragma once

#include "geometry/polyline.hpp"
#include "jointed_slope/face_cutting.hpp"
#include "jointed_slope/jointed_section.hpp"
#include "jointed_slope/placed_set.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace delabole {

// The joints of a set as they were cut, for other sets that refer to them.
struct CutSet {
    PlanePoint<> normal;
    std::vector<double> position;  // increasing
    double spacing;
};

// A joint set, to be cut again.
struct PlacedSet {
    std::size_t cut;  // its number among the cuts
    MeshIndex joint;
    MeshIndex rock;  // the only one that is cut, or no_index
    StraightLine upright;
    std::vector<double> position;  // of the joints, increasing
    std::int64_t first_number;     // of the first of them
    Reach reach;
    DistanceRange in_region;
    const Polyline* feature;  // the line that bounds the set; null: none
    bool above;               // that line
    const CutSet* columns;    // the set by which the joints are staggered; null: none
    double spacing;
    double stagger_share;
};

// A part of a joint that ends inside a face.
struct UnfinishedPart {
    MeshIndex face;
    std::size_t cut;
    MeshSegment piece;  // that part, or the straight piece of a line to which it belongs
};

struct RocksOfLine {
    MeshIndex gouge;  // each is no_index if there is none
    MeshIndex above;
    MeshIndex below;
};

// A line as it was cut.
struct DrawnLine {
    std::size_t cut;  // its number among the cuts
    Polyline middle;
    std::vector<Polyline> face;  // the line itself, or both faces of a fault
    double half_thickness;
    MeshIndex joint;
    RocksOfLine rocks;
};

// Coordinates are relative to the outline's first corner.
struct CuttingWork {
    SectionMesh mesh;
    PlanePoint<> origin;
    double snap;
    PlanePoint<> datum;  // from which the offsets of sets are measured, if they name no point
    std::vector<DrawnLine> drawn = {};
    std::vector<PlacedSet> bounded = {};                     // sets some of whose joints end inside blocks
    std::map<std::string, Polyline, std::less<>> line = {};  // towards +x
    std::map<std::string, CutSet, std::less<>> set = {};
    std::vector<MeshIndex> gouge = {};   // rocks that may be thin
    std::vector<std::size_t> rank = {};  // of joints, by strength
    // Joints of which one runs along the other, the lesser index first.
    std::set<std::pair<std::size_t, std::size_t>> along_each_other = {};

    // Rock between joints is stronger than they.
    std::size_t rank_of(MeshIndex joint) const { return joint < rank.size() ? rank[joint] : no_index; }
    bool runs_along(MeshIndex edge, const StraightLine& straight) const {
        const PlanePoint<> along = mesh.end(edge) - mesh.start(edge);
        return mesh.edge(edge).face != no_index && std::abs(straight.distance(mesh.start(edge))) <= snap &&
               std::abs(straight.distance(mesh.end(edge))) <= snap &&
               std::abs(straight.along.dot(along)) > along.norm() / 2;
    }
    // Whether an edge runs along a line whose joint is weaker than its own.
    bool is_stronger_along(MeshIndex edge, const StraightLine& straight, MeshIndex joint) const {
        return rank_of(joint) < rank_of(mesh.joint_at(edge)) && runs_along(edge, straight);
    }
    // Gives such an edge the line's joint; returns whether it has. `allowed(first, last)`: as in cut_face.
    template <class Allowed>
    bool weaken(MeshIndex edge, const StraightLine& straight, MeshIndex joint, Allowed&& allowed) {
        const double one = straight.place(mesh.start(edge));
        const double other = straight.place(mesh.end(edge));
        const MeshIndex own = mesh.joint_at(edge);
        if (own == joint || !runs_along(edge, straight) || !allowed(std::min(one, other), std::max(one, other))) {
            return false;
        }
        constexpr double long_enough = 10;  // snap distances: shorter edges have no direction
        if (own < rank.size() && (mesh.end(edge) - mesh.start(edge)).norm() > long_enough * snap) {
            along_each_other.insert(std::minmax<std::size_t>(own, joint));
        }
        const bool weaker = rank_of(joint) < rank_of(own);
        if (weaker) {
            mesh.set_joint(edge, joint);
        }
        return weaker;
    }
};

PlanePoint<> centroid_of(const SectionMesh& mesh, MeshIndex face);

// The outline's corners from the first one on, anticlockwise, without repetitions; faults and counts are stored in
// `section`.
Polygon<> prepared_outline(const SlopeGeometry& geometry, JointedSection& section);
// The first edge that crosses or touches another one, or is shorter than `snap`; nothing if none does.
std::optional<std::size_t> crossing_edge(const Polygon<>& outline, double snap);

// Divides faces that are not convex.
void divide_into_convex(SectionMesh& mesh, double snap);

// `number` of the cut seeds a set that has no seed of its own. `rock`: the only rock that is cut, or no_index.
CutCount cut_set(CuttingWork& work, const SlopeCut& named, const JointSetCut& set, std::size_t number, MeshIndex joint,
                 MeshIndex rock, SlopeCheck& check);
// The number of blocks that a set may make is estimated only when it is cut in the order of the list.
enum class CutTime { in_order, once_more };
CutCount cut_placed_set(CuttingWork& work, const PlacedSet& set, CutTime time, SlopeCheck& check);
std::vector<UnfinishedPart> unfinished_parts(const CuttingWork& work, const PlacedSet& set);

CutCount cut_line(CuttingWork& work, const SlopeCut& named, const LineCut& line, std::size_t number, MeshIndex joint,
                  const RocksOfLine& rocks, SlopeCheck& check);
// Cuts the blocks that these lines cross from side to side.
CutCount cut_lines(CuttingWork& work, const std::vector<Polyline>& lines, MeshIndex joint);
// The line, or both faces of a fault, which run on by its thickness where they end inside a block: where a fault ends
// on a joint at a sharp angle, one of its faces ends before it.
std::vector<Polyline> lines_to_finish(const CuttingWork& work, const DrawnLine& line);
std::vector<UnfinishedPart> unfinished_parts(const CuttingWork& work, const DrawnLine& line);
void give_rocks(CuttingWork& work, const DrawnLine& line);

// The one of some faces that contains a point well inside it; no_index if there is none.
MeshIndex face_around(const SectionMesh& mesh, std::span<const MeshIndex> faces, const PlanePoint<>& point,
                      double snap);
// Divides a face along a line through a point well inside it, and puts a vertex there. Returns the new face, or
// no_index if there is none.
MeshIndex divide_around(SectionMesh& mesh, MeshIndex face, const PlanePoint<>& point, const PlanePoint<>& direction,
                        double snap);
StraightLine line_through(const PlanePoint<>& a, const PlanePoint<>& b);

// Cuts again, after all cuts, lines and joints of sets that ended inside a block: as far as another cut that was made
// later, or as a point inside a block at which they meet or cross another one. `count` holds those of all cuts. Returns
// the cut by which there are too many blocks, if any.
std::optional<std::size_t> cut_as_far_as_others(CuttingWork& work, std::vector<CutCount>& count);

// Joins again the faces that were divided only to stay convex.
void rejoin_intact(SectionMesh& mesh);
// Median area of the faces that are not gouge.
double typical_area(const CuttingWork& work);
void merge_slivers(CuttingWork& work, double share, JointedSection& section);

}  // namespace delabole
