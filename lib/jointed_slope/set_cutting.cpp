// Joint sets: positions of their joints, and the faces that they cut.
#include "jointed_slope/counted_random.hpp"
#include "jointed_slope/cutting_work.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace delabole {

namespace {

enum Stream : std::uint64_t { of_spacing = 1, of_traces = 2 };

struct Extent {
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -std::numeric_limits<double>::infinity();
    void include(double value) {
        lowest = std::min(lowest, value);
        highest = std::max(highest, value);
    }
};

// Unit vectors of a dip: `along` up-dip, `normal` downwards; for the opposite dip they are the mirror images.
StraightLine line_of_dip(double dip) {
    const double size = std::abs(dip);
    const double out = dip < 0 ? -1 : 1;
    return {{out * std::sin(size), -std::cos(size)}, {out * std::cos(size), std::sin(size)}, 0};
}

// Joints are numbered downwards from the one at the offset. Returns an empty list and too_many_blocks if there are too
// many.
std::vector<double> joint_positions(const JointSetCut& set, std::uint64_t seed, double first, const Extent& extent,
                                    std::int64_t& number_of_first, SlopeCheck& check) {
    const double scatter = set.scatter.value_or(0);
    const double farthest = std::max(std::abs(extent.lowest - first), std::abs(extent.highest - first));
    std::vector<double> positions;
    if (!(farthest / set.spacing < static_cast<double>(most_slope_blocks))) {
        check = SlopeCheck::too_many_blocks;
        return positions;
    }
    // The spacing between two joints has the number of the upper one.
    const auto spacing_after = [&](std::int64_t number) {
        return set.spacing * (1 + scatter * (2 * counted_uniform(seed, of_spacing, number) - 1));
    };
    // Staggering moves joints by up to one spacing in either direction.
    const double reach = 2 * set.spacing * (1 + scatter);
    number_of_first = 0;
    double position = first;
    while (position > extent.lowest - reach) {
        --number_of_first;
        position -= spacing_after(number_of_first);
    }
    for (std::int64_t number = number_of_first; position < extent.highest + reach; ++number) {
        positions.push_back(position);
        // The joint at the offset is exact, from whichever side the sum approaches it.
        position = number + 1 == 0 ? first : position + spacing_after(number);
    }
    return positions;
}

// The parts of a joint along which it may cut: its traces, limited to the region.
class Reach {
  public:
    Reach(const JointSetCut& set, std::uint64_t seed, Polygon<> region, double snap, double anchor)
        : persistence_(set.persistence.value_or(1)),
          trace_(set.trace_length.value_or(0)),
          seed_(seed),
          region_(std::move(region)),
          snap_(snap),
          anchor_(anchor) {}

    bool contains(const StraightLine& line, std::int64_t number, double first, double last) const {
        return in_trace(number, first, last) && in_region(line, first, last);
    }

  private:
    bool in_trace(std::int64_t number, double first, double last) const {
        if (persistence_ >= 1) {
            return true;
        }
        const double period = trace_ / persistence_;
        const double begin = anchor_ + period * counted_uniform(seed_, of_traces, number);
        const double trace = begin + period * std::floor((first + snap_ - begin) / period);
        return last - snap_ <= trace + trace_;
    }

    bool in_region(const StraightLine& line, double first, double last) const {
        if (region_.empty()) {
            return true;
        }
        std::vector<double> places;
        for (std::size_t index = 0; index < region_.size(); ++index) {
            const PlanePoint<>& a = region_[index];
            const PlanePoint<>& b = region_[(index + 1) % region_.size()];
            const double of_a = line.distance(a);
            const double of_b = line.distance(b);
            if ((of_a > 0) != (of_b > 0)) {
                places.push_back((line.place(a) * std::abs(of_b) + line.place(b) * std::abs(of_a)) /
                                 (std::abs(of_a) + std::abs(of_b)));
            }
        }
        std::sort(places.begin(), places.end());
        for (std::size_t index = 0; index + 1 < places.size(); index += 2) {
            if (first > places[index] - snap_ && last < places[index + 1] + snap_) {
                return true;
            }
        }
        return false;
    }

    double persistence_;
    double trace_;
    std::uint64_t seed_;
    Polygon<> region_;
    double snap_;
    double anchor_;
};

// The shift of the joints of the set at a point, in the column of another set that contains it.
double shift_at(const JointSetCut& set, const CutSet* columns, const PlanePoint<>& point) {
    if (columns == nullptr) {
        return 0;
    }
    const auto after = std::upper_bound(columns->position.begin(), columns->position.end(), columns->normal.dot(point));
    const auto column = static_cast<double>(after - columns->position.begin());
    const double shift = column * set.stagger_share.value_or(0);
    return set.spacing * (shift - std::floor(shift));
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

CutCount cut_set(CuttingWork& work, const SlopeCut& named, const JointSetCut& set, std::size_t number, MeshIndex joint,
                 MeshIndex rock, SlopeCheck& check) {
    CutCount count;
    SectionMesh& mesh = work.mesh;
    const StraightLine upright = line_of_dip(set.dip);
    const PlanePoint<> anchor =
        set.through ? PlanePoint<>(PlanePoint<>(set.through->x, set.through->y) - work.origin) : work.datum;
    const std::uint64_t seed = static_cast<std::uint64_t>(set.seed.value_or(static_cast<double>(number + 1)));
    Extent extent;
    for (const PlanePoint<>& point : mesh.points()) {
        extent.include(upright.distance(point));
    }
    std::int64_t first_number = 0;
    CutSet& made = work.set[named.name];
    made = {upright.normal,
            joint_positions(set, seed, upright.distance(anchor) + set.offset.value_or(0), extent, first_number, check),
            set.spacing};
    Polygon<> region;
    Extent in_region;
    for (const SectionPoint& point : set.region) {
        region.push_back(PlanePoint<>(point.x, point.y) - work.origin);
        in_region.include(upright.distance(region.back()));
    }
    if (region.empty()) {
        in_region = extent;
    }
    const Reach reach(set, seed, std::move(region), work.snap, upright.place(anchor));
    const Polyline* feature = set.ends_on ? &work.line.find(*set.ends_on)->second : nullptr;
    const CutSet* columns = set.staggered_by ? &work.set.find(*set.staggered_by)->second : nullptr;
    const bool above = set.side == SideOfLine::above;

    struct JointsInFace {
        MeshIndex face;
        double shift;
        std::ptrdiff_t begin;
        std::ptrdiff_t end;
    };
    std::vector<JointsInFace> to_cut;
    const std::size_t faces = mesh.face_count();
    std::size_t most_blocks = faces;
    for (MeshIndex face = 0; face < faces && check == SlopeCheck::valid; ++face) {
        if (rock != no_index && mesh.face(face).rock != rock) {
            continue;
        }
        const bool needs_place = feature != nullptr || columns != nullptr;
        const PlanePoint<> centroid = needs_place ? centroid_of(mesh, face) : PlanePoint<>(0, 0);
        if (feature != nullptr && (signed_distance(*feature, centroid) > 0) != above) {
            continue;
        }
        const double shift = shift_at(set, columns, centroid);
        Extent own;
        mesh.for_each_edge(face, [&](MeshIndex edge) { own.include(upright.distance(mesh.start(edge))); });
        const auto joints_between = [&](double lowest, double highest) {
            const auto begin = std::upper_bound(made.position.begin(), made.position.end(), lowest - shift);
            const auto end = std::lower_bound(begin, made.position.end(), highest - shift);
            return JointsInFace{face, shift, begin - made.position.begin(), end - made.position.begin()};
        };
        to_cut.push_back(joints_between(own.lowest, own.highest));
        mesh.for_each_edge(face, [&](MeshIndex edge) {
            const double at = (upright.distance(mesh.start(edge)) + upright.distance(mesh.end(edge))) / 2 - shift;
            const auto found = std::ranges::lower_bound(made.position, at - work.snap);
            if (found != made.position.end()) {
                const StraightLine line{upright.normal, upright.along, *found + shift};
                const bool weaker = work.weaken(edge, line, joint, [&](double first, double last) {
                    return reach.contains(line, first_number + (found - made.position.begin()), first, last);
                });
                count.along += weaker ? 1 : 0;
            }
        });
        // The joints are counted before any cut, so that a refusal takes less time than a section. No joint cuts beyond
        // its region.
        const JointsInFace allowed = joints_between(std::max(own.lowest, in_region.lowest - work.snap),
                                                    std::min(own.highest, in_region.highest + work.snap));
        most_blocks += static_cast<std::size_t>(allowed.end - allowed.begin);
        if (most_blocks > most_slope_blocks) {
            check = SlopeCheck::too_many_blocks;
        }
    }
    if (check != SlopeCheck::valid) {
        return count;
    }
    for (const JointsInFace& of_face : to_cut) {
        const auto cut = [&](MeshIndex face, std::ptrdiff_t index) -> std::optional<MeshIndex> {
            const double position = made.position[static_cast<std::size_t>(index)];
            const StraightLine line{upright.normal, upright.along, position + of_face.shift};
            const FaceCutResult result = cut_face(mesh, face, line, work.snap, joint, [&](double first, double last) {
                return reach.contains(line, first_number + index, first, last);
            });
            count.made += result.cut == FaceCut::made ? 1 : 0;
            count.dropped += result.cut == FaceCut::dropped ? 1 : 0;
            return result.cut == FaceCut::made ? std::optional(result.beyond) : std::nullopt;
        };
        cut_along_joints(of_face.face, of_face.begin, of_face.end, cut);
    }
    return count;
}

}  // namespace delabole
