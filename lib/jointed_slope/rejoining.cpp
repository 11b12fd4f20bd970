// Joins again, after all cuts, the faces that were divided artificially, and merges slivers.
#include "jointed_slope/cutting_work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

bool same_rock(const SectionMesh& mesh, MeshIndex edge) {
    return mesh.face(mesh.edge(edge).face).rock == mesh.face(mesh.edge(mesh.edge(edge).twin).face).rock;
}

// Least distance between two parallel lines that enclose a convex polygon; one of them lies along an edge.
double width_of(const Polygon<>& outline) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t index = 0; index < outline.size(); ++index) {
        const PlanePoint<> along = outline[(index + 1) % outline.size()] - outline[index];
        const PlanePoint<> normal = PlanePoint<>(-along.y(), along.x()) / along.norm();
        double greatest = 0;
        for (const PlanePoint<>& corner : outline) {
            greatest = std::max(greatest, normal.dot(corner - outline[index]));
        }
        least = std::min(least, greatest);
    }
    return least;
}

bool is_gouge(const CuttingWork& work, MeshIndex face) {
    return std::find(work.gouge.begin(), work.gouge.end(), work.mesh.face(face).rock) != work.gouge.end();
}

// Merges a sliver into the neighbour with the longest common boundary among those with which it forms a convex block.
// Where the joint between them runs on, the merged block reaches across it like a key, and rigid blocks can no longer
// slide along it: such slivers are counted. To keep them instead lets each slip out by itself before the slope fails.
void merge_sliver(SectionMesh& mesh, MeshIndex face, JointedSection& section) {
    MeshIndex best = no_index;
    double longest = 0;
    mesh.for_each_edge(face, [&](MeshIndex edge) {
        const MeshIndex twin = mesh.edge(edge).twin;
        if (twin == no_index || !same_rock(mesh, edge) || !mesh.union_is_convex(twin)) {
            return;
        }
        const double length = mesh.shared_length(edge);
        if (length > longest) {
            longest = length;
            best = twin;
        }
    });
    if (best == no_index) {
        ++section.slivers_kept;
        return;
    }
    if (!mesh.shares_only(best, intact_rock) && mesh.joint_runs_on(best)) {
        ++section.slivers_locking;
    }
    mesh.merge(best);
    ++section.slivers_merged;
}

}  // namespace

void rejoin_intact(SectionMesh& mesh) {
    const auto edges = static_cast<MeshIndex>(mesh.edge_count());
    for (MeshIndex edge = 0; edge < edges; ++edge) {
        const HalfEdge& half = mesh.edge(edge);
        if (half.face != no_index && half.twin != no_index && half.joint == intact_rock && same_rock(mesh, edge) &&
            mesh.shares_only(edge, intact_rock) && mesh.union_is_convex(edge)) {
            mesh.merge(edge);
        }
    }
}

double typical_area(const CuttingWork& work) {
    std::vector<double> areas;
    for (MeshIndex face = 0; face < work.mesh.face_count(); ++face) {
        if (work.mesh.alive(face) && !is_gouge(work, face)) {
            areas.push_back(area_properties(work.mesh.outline_of(face)).area);
        }
    }
    if (areas.empty()) {
        return 0;
    }
    const auto middle = areas.begin() + static_cast<std::ptrdiff_t>(areas.size() / 2);
    std::nth_element(areas.begin(), middle, areas.end());
    return *middle;
}

void merge_slivers(CuttingWork& work, double share, JointedSection& section) {
    const double least_area = share * section.typical_area;
    const double least_width = share * std::sqrt(section.typical_area);
    for (MeshIndex face = 0; face < work.mesh.face_count(); ++face) {
        if (!work.mesh.alive(face) || is_gouge(work, face)) {
            continue;
        }
        const Polygon<> outline = work.mesh.outline_of(face);
        if (area_properties(outline).area < least_area || width_of(outline) < least_width) {
            merge_sliver(work.mesh, face, section);
        }
    }
}

}  // namespace delabole
