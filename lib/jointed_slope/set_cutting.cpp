// Joint sets: the faces that they cut.
#include "jointed_slope/cutting_work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace delabole {

namespace {

// The shift of the joints of the set at a point, in the column of another set that contains it.
double shift_at(const PlacedSet& set, const PlanePoint<>& point) {
    if (set.columns == nullptr) {
        return 0;
    }
    const std::vector<double>& columns = set.columns->position;
    const auto after = std::upper_bound(columns.begin(), columns.end(), set.columns->normal.dot(point));
    const double shift = static_cast<double>(after - columns.begin()) * set.stagger_share;
    return set.spacing * (shift - std::floor(shift));
}

// The joints of a set, from the first to before the last, that lie between two distances from its datum.
struct JointsInFace {
    MeshIndex face;
    double shift;
    std::ptrdiff_t begin;
    std::ptrdiff_t end;
};

JointsInFace joints_between(const PlacedSet& set, MeshIndex face, double shift, double lowest, double highest) {
    const auto begin = std::upper_bound(set.position.begin(), set.position.end(), lowest - shift);
    const auto end = std::lower_bound(begin, set.position.end(), highest - shift);
    return {face, shift, begin - set.position.begin(), end - set.position.begin()};
}

StraightLine line_of(const PlacedSet& set, std::ptrdiff_t joint, double shift) {
    return {set.upright.normal, set.upright.along, set.position[static_cast<std::size_t>(joint)] + shift};
}

DistanceRange extent_of(const SectionMesh& mesh, MeshIndex face, const StraightLine& upright) {
    DistanceRange own;
    mesh.for_each_edge(face, [&](MeshIndex edge) { own.include(upright.distance(mesh.start(edge))); });
    return own;
}

// The shift of the set's joints in a face; nothing if it has none there.
std::optional<double> shift_in(const CuttingWork& work, const PlacedSet& set, MeshIndex face) {
    if (set.rock != no_index && work.mesh.face(face).rock != set.rock) {
        return std::nullopt;
    }
    const bool needs_place = set.feature != nullptr || set.columns != nullptr;
    const PlanePoint<> centroid = needs_place ? centroid_of(work.mesh, face) : PlanePoint<>(0, 0);
    if (set.feature != nullptr && (signed_distance(*set.feature, centroid) > 0) != set.above) {
        return std::nullopt;
    }
    return shift_at(set, centroid);
}

// Cuts a face along the joints from `begin` to `end`, which cross it in order from above downwards. The part below the
// last joint lies above no later joint, and is returned.
//
// A face may have a corner on its side for every joint of the column beside it. Searching all of these corners again
// for each of many joints would cost the square of their number: many joints are first halved, few are cut one after
// the other.
template <class Cut>
MeshIndex cut_along_joints(MeshIndex face, std::ptrdiff_t begin, std::ptrdiff_t end, const Cut& cut) {
    constexpr std::ptrdiff_t few = 256;
    if (end - begin <= few) {
        for (std::ptrdiff_t joint = begin; joint < end; ++joint) {
            face = cut(face, joint).value_or(face);
        }
        return face;
    }
    const std::ptrdiff_t middle = begin + (end - begin) / 2;
    const std::optional<MeshIndex> below = cut(face, middle);
    const MeshIndex rest = cut_along_joints(face, begin, middle, cut);
    return cut_along_joints(below.value_or(rest), middle + 1, end, cut);
}

}  // namespace

CutCount cut_placed_set(CuttingWork& work, const PlacedSet& set, CutTime time, SlopeCheck& check) {
    constexpr double to_a_corner = 2;  // a joint ends at the corner to which a point has snapped
    const double snaps = time == CutTime::in_order ? 1 : to_a_corner;
    CutCount count;
    SectionMesh& mesh = work.mesh;
    std::vector<JointsInFace> to_cut;
    const std::size_t faces = mesh.face_count();
    std::size_t blocks_at_most = faces;
    for (MeshIndex face = 0; face < faces; ++face) {
        const std::optional<double> shift = shift_in(work, set, face);
        if (!shift) {
            continue;
        }
        const DistanceRange own = extent_of(mesh, face, set.upright);
        to_cut.push_back(joints_between(set, face, *shift, own.lowest, own.highest));
        mesh.for_each_edge(face, [&](MeshIndex edge) {
            const double at =
                (set.upright.distance(mesh.start(edge)) + set.upright.distance(mesh.end(edge))) / 2 - *shift;
            const auto found = std::ranges::lower_bound(set.position, at - work.snap);
            if (found != set.position.end()) {
                const std::ptrdiff_t index = found - set.position.begin();
                const StraightLine line = line_of(set, index, *shift);
                const bool weaker = work.weaken(edge, line, set.joint, [&](double first, double last) {
                    return set.reach.contains(line, set.first_number + index, first, last);
                });
                count.along += weaker ? 1 : 0;
            }
        });
        // The joints are counted before any cut, so that a refusal takes less time than a section. No joint cuts beyond
        // its region.
        const JointsInFace allowed =
            joints_between(set, face, *shift, std::max(own.lowest, set.in_region.lowest - work.snap),
                           std::min(own.highest, set.in_region.highest + work.snap));
        blocks_at_most += static_cast<std::size_t>(allowed.end - allowed.begin);
        if (time == CutTime::in_order && blocks_at_most > most_slope_blocks) {
            check = SlopeCheck::too_many_blocks;
            return count;
        }
    }
    for (const JointsInFace& of_face : to_cut) {
        const auto cut = [&](MeshIndex face, std::ptrdiff_t index) -> std::optional<MeshIndex> {
            if (mesh.face_count() > most_slope_blocks) {
                check = SlopeCheck::too_many_blocks;
                return std::nullopt;
            }
            const StraightLine line = line_of(set, index, of_face.shift);
            const std::int64_t number = set.first_number + index;
            const FaceCutResult result =
                cut_face(mesh, face, line, work.snap, set.joint, [&](double first, double last) {
                    const bool crosses = set.reach.contains(line, number, first, last, snaps);
                    count.dropped += !crosses && !set.reach.parts(line, number, first, last).empty() ? 1 : 0;
                    return crosses;
                });
            count.made += result.cut == FaceCut::made ? 1 : 0;
            return result.cut == FaceCut::made ? std::optional(result.beyond) : std::nullopt;
        };
        cut_along_joints(of_face.face, of_face.begin, of_face.end, cut);
    }
    return count;
}

CutCount cut_set(CuttingWork& work, const SlopeCut& named, const JointSetCut& set, std::size_t number, MeshIndex joint,
                 MeshIndex rock, SlopeCheck& check) {
    const StraightLine upright = line_of_dip(set.dip);
    const PlanePoint<> anchor =
        set.through ? PlanePoint<>(PlanePoint<>(set.through->x, set.through->y) - work.origin) : work.datum;
    const std::uint64_t seed = static_cast<std::uint64_t>(set.seed.value_or(static_cast<double>(number + 1)));
    DistanceRange extent;
    for (const PlanePoint<>& point : work.mesh.points()) {
        extent.include(upright.distance(point));
    }
    Polygon<> region = polygon_of(set.region);
    DistanceRange in_region;
    for (PlanePoint<>& corner : region) {
        corner -= work.origin;
        in_region.include(upright.distance(corner));
    }
    std::int64_t first_number = 0;
    std::vector<double> position =
        joint_positions(set, seed, upright.distance(anchor) + set.offset.value_or(0), extent, first_number, check);
    work.set[named.name] = {upright.normal, position, set.spacing};
    PlacedSet placed{number,
                     joint,
                     rock,
                     upright,
                     std::move(position),
                     first_number,
                     Reach(set, seed, std::move(region), work.snap, upright.place(anchor)),
                     set.region.empty() ? extent : in_region,
                     set.ends_on ? &work.line.find(*set.ends_on)->second : nullptr,
                     set.side == SideOfLine::above,
                     set.staggered_by ? &work.set.find(*set.staggered_by)->second : nullptr,
                     set.spacing,
                     set.stagger_share.value_or(0)};
    if (check != SlopeCheck::valid) {
        return {};
    }
    const CutCount count = cut_placed_set(work, placed, CutTime::in_order, check);
    if (placed.reach.is_bounded() && count.dropped > 0) {
        work.bounded.push_back(std::move(placed));
    }
    return count;
}

std::vector<UnfinishedPart> unfinished_parts(const CuttingWork& work, const PlacedSet& set) {
    std::vector<UnfinishedPart> unfinished;
    for (MeshIndex face = 0; face < work.mesh.face_count(); ++face) {
        const std::optional<double> shift = shift_in(work, set, face);
        if (!shift) {
            continue;
        }
        const DistanceRange own = extent_of(work.mesh, face, set.upright);
        const JointsInFace joints = joints_between(set, face, *shift, own.lowest, own.highest);
        for (std::ptrdiff_t index = joints.begin; index < joints.end; ++index) {
            const StraightLine line = line_of(set, index, *shift);
            if (const std::optional<Chord> chord = find_chord(work.mesh, face, line, work.snap)) {
                const auto [first, last] = std::minmax({line.place(chord->rising.at), line.place(chord->falling.at)});
                for (const LinePart& part : set.reach.parts(line, set.first_number + index, first, last)) {
                    unfinished.push_back({face, set.cut, {line.at(part.begin), line.at(part.end)}});
                }
            }
        }
    }
    return unfinished;
}

}  // namespace delabole
