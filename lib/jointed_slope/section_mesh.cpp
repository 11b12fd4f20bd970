#include "jointed_slope/section_mesh.hpp"

#include <cmath>

namespace delabole {

double sine_of_turn(const PlanePoint<>& a, const PlanePoint<>& b, const PlanePoint<>& c) {
    const PlanePoint<> in = b - a;
    const PlanePoint<> out = c - b;
    return (in.x() * out.y() - in.y() * out.x()) / (std::hypot(in.x(), in.y()) * std::hypot(out.x(), out.y()));
}

PlanePoint<> point_between(const MeshSegment& segment, double from_first, double from_second) {
    const double whole = from_first + from_second;
    return {(segment.first.x() * from_second + segment.second.x() * from_first) / whole,
            (segment.first.y() * from_second + segment.second.y() * from_first) / whole};
}

SectionMesh::SectionMesh(const Polygon<>& outline, MeshIndex rock) : points_(outline) {
    const auto count = static_cast<MeshIndex>(outline.size());
    edges_.reserve(count);
    for (MeshIndex index = 0; index < count; ++index) {
        edges_.push_back(
            {index, no_index, (index + 1) % count, (index + count - 1) % count, 0, free_surface, index, free_surface});
        segments_.push_back({outline[index], outline[(index + 1) % count]});
    }
    faces_.push_back({0, rock});
}

Polygon<> SectionMesh::outline_of(MeshIndex face) const {
    Polygon<> outline;
    for_each_edge(face, [&](MeshIndex edge) { outline.push_back(start(edge)); });
    return outline;
}

MeshIndex SectionMesh::split_edge(MeshIndex edge, const PlanePoint<>& at) {
    const auto vertex = static_cast<MeshIndex>(points_.size());
    points_.push_back(at);
    const auto insert_after = [&](MeshIndex before) {
        const auto made = static_cast<MeshIndex>(edges_.size());
        HalfEdge second = edges_[before];
        second.origin = vertex;
        second.previous = before;
        edges_[second.next].previous = made;
        edges_[before].next = made;
        edges_.push_back(second);
        return made;
    };
    const MeshIndex twin = edges_[edge].twin;
    const MeshIndex second = insert_after(edge);
    if (twin != no_index) {
        const MeshIndex twin_second = insert_after(twin);
        edges_[edge].twin = twin_second;
        edges_[twin_second].twin = edge;
        edges_[second].twin = twin;
        edges_[twin].twin = second;
    }
    return second;
}

MeshIndex SectionMesh::split_face(MeshIndex from, MeshIndex to, MeshIndex joint) {
    const MeshIndex old_face = edges_[from].face;
    const auto new_face = static_cast<MeshIndex>(faces_.size());
    const auto closing = static_cast<MeshIndex>(edges_.size());  // edge of the new face, back to the start of `from`
    const MeshIndex opposite = closing + 1;
    const MeshIndex before_from = edges_[from].previous;
    const MeshIndex before_to = edges_[to].previous;
    const auto segment = static_cast<MeshIndex>(segments_.size());
    segments_.push_back({start(from), start(to)});
    edges_.push_back({edges_[to].origin, opposite, from, before_to, new_face, joint, segment, free_surface});
    edges_.push_back({edges_[from].origin, closing, to, before_from, old_face, joint, segment, free_surface});
    edges_[before_to].next = closing;
    edges_[from].previous = closing;
    edges_[before_from].next = opposite;
    edges_[to].previous = opposite;
    faces_.push_back({closing, faces_[old_face].rock});
    faces_[old_face].edge = opposite;
    for (MeshIndex edge = from; edge != closing; edge = edges_[edge].next) {
        edges_[edge].face = new_face;
    }
    return new_face;
}

SectionMesh::Chain SectionMesh::shared_chain(MeshIndex edge) const {
    const MeshIndex other = edges_[edges_[edge].twin].face;
    const auto shared = [&](MeshIndex candidate) {
        const MeshIndex twin = edges_[candidate].twin;
        return twin != no_index && edges_[twin].face == other;
    };
    Chain chain{edge, edge};
    while (shared(edges_[chain.first].previous) && edges_[chain.first].previous != chain.last) {
        chain.first = edges_[chain.first].previous;
    }
    while (shared(edges_[chain.last].next) && edges_[chain.last].next != chain.first) {
        chain.last = edges_[chain.last].next;
    }
    return chain;
}

bool SectionMesh::union_is_convex(MeshIndex edge) const {
    const Chain chain = shared_chain(edge);
    const MeshIndex before_first = edges_[chain.first].previous;
    const MeshIndex after_last = edges_[chain.last].next;
    const MeshIndex leaving_first = edges_[edges_[chain.first].twin].next;
    const MeshIndex reaching_last = edges_[edges_[chain.last].twin].previous;
    return sine_of_turn(start(before_first), start(chain.first), end(leaving_first)) > -straight_sine &&
           sine_of_turn(start(reaching_last), start(after_last), end(after_last)) > -straight_sine;
}

bool SectionMesh::shares_only(MeshIndex edge, MeshIndex joint) const {
    const Chain chain = shared_chain(edge);
    for (MeshIndex shared = chain.first; shared != edges_[chain.last].next; shared = edges_[shared].next) {
        if (edges_[shared].joint != joint) {
            return false;
        }
    }
    return true;
}

double SectionMesh::shared_length(MeshIndex edge) const {
    const Chain chain = shared_chain(edge);
    return (end(chain.last) - start(chain.first)).norm();
}

bool SectionMesh::joint_leaves(MeshIndex edge, const PlanePoint<>& direction) const {
    constexpr double sine_of_bend = 0.1;  // a joint drawn with bends is one joint
    const PlanePoint<> at = start(edge);
    const auto runs_along = [&](MeshIndex candidate, const PlanePoint<>& other_end) {
        const MeshIndex joint = edges_[candidate].joint;
        return joint != free_surface && joint != intact_rock && (other_end - at).dot(direction) > 0 &&
               std::abs(sine_of_turn(at - direction, at, other_end)) < sine_of_bend;
    };
    // All edges that leave the vertex, clockwise from the given one; from the outline on the other way round.
    MeshIndex leaving = edge;
    do {
        if (runs_along(leaving, end(leaving))) {
            return true;
        }
        const MeshIndex twin = edges_[leaving].twin;
        if (twin == no_index) {
            break;
        }
        leaving = edges_[twin].next;
    } while (leaving != edge);
    if (leaving == edge) {
        return false;
    }
    for (MeshIndex arriving = edges_[edge].previous; arriving != no_index;) {
        if (runs_along(arriving, start(arriving))) {
            return true;
        }
        const MeshIndex twin = edges_[arriving].twin;
        arriving = twin == no_index ? no_index : edges_[twin].previous;
    }
    return false;
}

bool SectionMesh::joint_runs_on(MeshIndex edge) const {
    const Chain chain = shared_chain(edge);
    const PlanePoint<> along = end(chain.last) - start(chain.first);
    return joint_leaves(chain.first, -along) || joint_leaves(edges_[chain.last].next, along);
}

void SectionMesh::remove(MeshIndex face) {
    for_each_edge(face, [&](MeshIndex edge) {
        const MeshIndex twin = edges_[edge].twin;
        if (twin != no_index) {
            edges_[twin].twin = no_index;
            edges_[twin].joint = free_surface;
        }
        edges_[edge].face = no_index;
    });
    faces_[face].edge = no_index;
}

void SectionMesh::merge(MeshIndex edge) {
    const Chain chain = shared_chain(edge);
    const MeshIndex kept = edges_[edge].face;
    const MeshIndex gone = edges_[edges_[edge].twin].face;
    const MeshIndex before = edges_[chain.first].previous;
    const MeshIndex after = edges_[chain.last].next;
    const MeshIndex other_after = edges_[edges_[chain.first].twin].next;
    const MeshIndex other_before = edges_[edges_[chain.last].twin].previous;
    for (MeshIndex taken = chain.first; taken != after; taken = edges_[taken].next) {
        edges_[taken].face = no_index;
        edges_[edges_[taken].twin].face = no_index;
    }
    edges_[before].next = other_after;
    edges_[other_after].previous = before;
    edges_[other_before].next = after;
    edges_[after].previous = other_before;
    faces_[gone].edge = no_index;
    faces_[kept].edge = after;
    for (MeshIndex moved = other_after; moved != after; moved = edges_[moved].next) {
        edges_[moved].face = kept;
    }
}

}  // namespace delabole
