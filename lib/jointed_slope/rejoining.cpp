// Joins again, after all cuts, the faces that were divided artificially; merges slivers or takes them away.
#include "jointed_slope/cutting_work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

// A sliver that cannot be merged is taken away as crushed if joints alone bound it and it is below both limits, which
// are shares of the typical block's area and size. Blocks that rested on so small a sliver still rest on others. If it
// were kept, it would slip out by itself before the slope fails.
constexpr double greatest_crushed_share = SlopeGeometry::standard_sliver_share;
constexpr double greatest_crushed_length = 0.5;

bool same_rock(const SectionMesh& mesh, MeshIndex edge) {
    return mesh.face(mesh.edge(edge).face).rock == mesh.face(mesh.edge(mesh.edge(edge).twin).face).rock;
}

// Least distance between two parallel lines that enclose a convex polygon, whose corners are in counterclockwise order;
// one of them lies along an edge. The corner farthest from an edge moves on with the edge (rotating calipers), so that
// the time grows as the number of corners, of which a side cut by thousands of joints has as many. Distances that fall
// by no more than `rounding` do not end the search: corners on one line are not quite so.
double width_of(const Polygon<>& outline, double rounding) {
    const std::size_t count = outline.size();
    double least = std::numeric_limits<double>::infinity();
    std::size_t farthest = 1;
    for (std::size_t index = 0; index < count; ++index) {
        const PlanePoint<> along = outline[(index + 1) % count] - outline[index];
        const PlanePoint<> normal = PlanePoint<>(-along.y(), along.x()) / along.norm();
        const auto distance = [&](std::size_t corner) { return normal.dot(outline[corner % count] - outline[index]); };
        farthest = std::max(farthest, index + 1);
        while (farthest + 1 < index + count && distance(farthest + 1) >= distance(farthest) - rounding) {
            ++farthest;
        }
        least = std::min(least, distance(farthest));
    }
    return least;
}

// Whether a face is a part of the rock beside it, divided from it only because blocks are convex.
bool is_part_of_a_block(const SectionMesh& mesh, MeshIndex face) {
    bool part = false;
    mesh.for_each_edge(
        face, [&](MeshIndex edge) { part = part || (mesh.edge(edge).joint == intact_rock && same_rock(mesh, edge)); });
    return part;
}

bool is_gouge(const CuttingWork& work, MeshIndex face) {
    return std::find(work.gouge.begin(), work.gouge.end(), work.mesh.face(face).rock) != work.gouge.end();
}

// Greatest distance between two corners.
double length_of(const Polygon<>& outline) {
    double greatest = 0;
    for (std::size_t index = 1; index < outline.size(); ++index) {
        for (std::size_t other = 0; other < index; ++other) {
            greatest = std::max(greatest, (outline[index] - outline[other]).norm());
        }
    }
    return greatest;
}

// Whether the block that a sliver and its neighbour at an edge would form reaches across a joint that runs on, like a
// key: rigid blocks could no longer slide along it.
bool locks_a_joint(const SectionMesh& mesh, MeshIndex edge) {
    return !mesh.shares_only(edge, intact_rock) && mesh.joint_runs_on(edge);
}

// Whether the weakest joint around a sliver is found only on its boundary with the neighbour at an edge: blocks could
// no longer slide along it if both became one block.
bool has_the_weakest_joint(const CuttingWork& work, MeshIndex face, MeshIndex edge) {
    const SectionMesh& mesh = work.mesh;
    const MeshIndex neighbour = mesh.edge(mesh.edge(edge).twin).face;
    std::size_t here = no_index;
    std::size_t elsewhere = no_index;
    bool has_others = false;
    mesh.for_each_edge(face, [&](MeshIndex of_sliver) {
        const MeshIndex twin = mesh.edge(of_sliver).twin;
        if (twin != no_index) {
            const bool other = mesh.edge(twin).face != neighbour;
            std::size_t& least = other ? elsewhere : here;
            least = std::min(least, work.rank_of(mesh.edge(of_sliver).joint));
            has_others = has_others || other;
        }
    });
    return here < elsewhere && has_others;
}

// A joint between the outline and a boundary that goes, about as long as it: what slid along the boundary slides there.
void keep_joint_on_outline(CuttingWork& work, MeshIndex face, MeshIndex boundary, double length) {
    SectionMesh& mesh = work.mesh;
    const MeshIndex joint = mesh.edge(boundary).joint;
    const PlanePoint<> direction = (mesh.end(boundary) - mesh.start(boundary)).normalized();
    mesh.for_each_edge(face, [&](MeshIndex edge) {
        const bool on_outline = mesh.edge(edge).twin == no_index;
        if (on_outline && std::abs(direction.dot(mesh.end(edge) - mesh.start(edge))) > length / 2 &&
            work.rank_of(joint) < work.rank_of(mesh.joint_at(edge))) {
            mesh.set_joint(edge, joint);
        }
    });
}

// Merges a sliver into the neighbour with the longest common boundary among those with which it forms a convex block
// that locks no joint.
bool merge_sliver(CuttingWork& work, MeshIndex face) {
    SectionMesh& mesh = work.mesh;
    MeshIndex best = no_index;
    double longest = 0;
    mesh.for_each_edge(face, [&](MeshIndex edge) {
        const MeshIndex twin = mesh.edge(edge).twin;
        if (twin == no_index || !same_rock(mesh, edge) || !mesh.union_is_convex(twin) || locks_a_joint(mesh, twin) ||
            has_the_weakest_joint(work, face, edge)) {
            return;
        }
        const double length = mesh.shared_length(edge);
        if (length > longest) {
            longest = length;
            best = twin;
        }
    });
    if (best != no_index) {
        keep_joint_on_outline(work, face, best, longest);
        mesh.merge(best);
    }
    return best != no_index;
}

}  // namespace

// A division on which another one ends can go only after that one, so that this takes some rounds.
void rejoin_intact(SectionMesh& mesh) {
    const auto edges = static_cast<MeshIndex>(mesh.edge_count());
    for (bool any = true; any;) {
        any = false;
        for (MeshIndex edge = 0; edge < edges; ++edge) {
            const HalfEdge& half = mesh.edge(edge);
            if (half.face != no_index && half.twin != no_index && half.joint == intact_rock && same_rock(mesh, edge) &&
                mesh.shares_only(edge, intact_rock) && mesh.union_is_convex(edge)) {
                mesh.merge(edge);
                any = true;
            }
        }
    }
}

// The median of few blocks tells little: besides the blocks that a case is about there are large ones below and behind.
double typical_area(const CuttingWork& work) {
    constexpr double few_blocks = 30;
    std::vector<double> areas;
    double all = 0;
    for (MeshIndex face = 0; face < work.mesh.face_count(); ++face) {
        if (work.mesh.alive(face) && !is_gouge(work, face)) {
            areas.push_back(area_properties(work.mesh.outline_of(face)).area);
            all += areas.back();
        }
    }
    if (areas.empty()) {
        return 0;
    }
    const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
    std::nth_element(areas.begin(), middle, areas.end());
    return std::min(*middle, all / few_blocks);
}

void merge_slivers(CuttingWork& work, double share, JointedSection& section) {
    SectionMesh& mesh = work.mesh;
    const double size = std::sqrt(section.typical_area);
    const auto for_each_sliver = [&](auto&& function) {
        for (MeshIndex face = 0; face < mesh.face_count(); ++face) {
            if (mesh.alive(face) && !is_gouge(work, face)) {
                const Polygon<> outline = mesh.outline_of(face);
                const double area = area_properties(outline).area;
                if (area < share * section.typical_area || width_of(outline, 1e-9 * size) < share * size) {
                    function(face, outline, area);
                }
            }
        }
    };
    for_each_sliver(
        [&](MeshIndex face, const Polygon<>&, double) { section.slivers_merged += merge_sliver(work, face) ? 1 : 0; });
    for_each_sliver([&](MeshIndex face, const Polygon<>& outline, double area) {
        if (is_part_of_a_block(mesh, face)) {
            return;
        }
        if (area < greatest_crushed_share * section.typical_area &&
            length_of(outline) < greatest_crushed_length * size) {
            mesh.remove(face);
            ++section.slivers_crushed;
            section.crushed_area += area;
        } else {
            ++section.slivers_kept;
        }
    });
}

}  // namespace delabole
