// Lines and joints of sets that end inside blocks: they are cut as far as they, together with others, part a block.
#include "jointed_slope/cutting_work.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace delabole {

namespace {

// The point at which two straight pieces cross, or at which one of them ends on the other.
std::optional<PlanePoint<>> meeting_point(const MeshSegment& one, const MeshSegment& other, double snap) {
    for (const auto& [ends, along] : {std::pair(one, other), std::pair(other, one)}) {
        const PlanePoint<> direction = (along.second - along.first).normalized();
        for (const PlanePoint<>& end : {ends.first, ends.second}) {
            const double place = direction.dot(end - along.first);
            if (std::abs(left_of(direction).dot(end - along.first)) < snap && place > -snap &&
                direction.dot(along.second - end) > -snap) {
                return end;
            }
        }
    }
    const StraightLine along_one = line_through(one.first, one.second);
    const StraightLine along_other = line_through(other.first, other.second);
    const double from_first = along_other.distance(one.first);
    const double from_second = along_other.distance(one.second);
    const bool cross = (from_first > 0) != (from_second > 0) &&
                       (along_one.distance(other.first) > 0) != (along_one.distance(other.second) > 0);
    return cross ? std::optional(point_between(one, std::abs(from_first), std::abs(from_second))) : std::nullopt;
}

// The direction from a point on a piece of a line, inside a face, to the side of the face that the piece reaches: its
// other end may lie just beyond the point. Where it reaches both sides or none, the longer way.
PlanePoint<> arm_of(const SectionMesh& mesh, MeshIndex face, const MeshSegment& piece, const PlanePoint<>& at,
                    double snap) {
    const StraightLine straight = line_through(piece.first, piece.second);
    const double first = straight.place(piece.first);
    const double last = straight.place(piece.second);
    bool forth = last - straight.place(at) > straight.place(at) - first;
    if (const std::optional<Chord> chord = find_chord(mesh, face, straight, snap)) {
        const double one = straight.place(chord->rising.at);
        const double other = straight.place(chord->falling.at);
        const bool reaches_back = first - 2 * snap <= std::min(one, other);
        const bool reaches_forth = last + 2 * snap >= std::max(one, other);
        forth = reaches_back == reaches_forth ? forth : reaches_forth;
    }
    return forth ? straight.along : PlanePoint<>(-straight.along);
}

// Pairs of parts of different cuts whose extents in both axes meet, the later part first.
std::vector<std::pair<std::size_t, std::size_t>> pairs_that_may_meet(const std::vector<UnfinishedPart>& parts,
                                                                     double snap) {
    std::vector<Eigen::AlignedBox2d> box;
    for (const UnfinishedPart& part : parts) {
        const auto& [first, second] = part.piece;
        box.emplace_back(first.cwiseMin(second).array() - snap, first.cwiseMax(second).array() + snap);
    }
    std::vector<std::size_t> upwards(parts.size());
    std::iota(upwards.begin(), upwards.end(), std::size_t{0});
    std::ranges::stable_sort(upwards, {}, [&](std::size_t index) { return box[index].min().y(); });
    std::vector<std::pair<std::size_t, std::size_t>> pairs;
    for (auto one = upwards.begin(); one != upwards.end(); ++one) {
        for (auto other = one + 1; other != upwards.end() && box[*other].min().y() <= box[*one].max().y(); ++other) {
            if (parts[*one].cut != parts[*other].cut && box[*one].intersects(box[*other])) {
                pairs.emplace_back(std::max(*one, *other), std::min(*one, *other));
            }
        }
    }
    std::ranges::sort(pairs);
    return pairs;
}

// Divides a face wherever two of the parts that end inside it meet, as at a bend from an arm of one to an arm of the
// other.
void divide_where_they_meet(CuttingWork& work, MeshIndex face, const std::vector<UnfinishedPart>& parts) {
    constexpr double least_turn = 0.1;  // rad; lines that differ by less run along each other
    std::vector<MeshIndex> divided{face};
    for (const auto& [later, earlier] : pairs_that_may_meet(parts, work.snap)) {
        const MeshSegment& one = parts[later].piece;
        const MeshSegment& other = parts[earlier].piece;
        const auto at = meeting_point(one, other, work.snap);
        const MeshIndex around = at ? face_around(work.mesh, divided, *at, work.snap) : no_index;
        if (around == no_index) {
            continue;
        }
        const PlanePoint<> turn =
            arm_of(work.mesh, around, one, *at, work.snap) - arm_of(work.mesh, around, other, *at, work.snap);
        if (turn.norm() > least_turn) {
            const MeshIndex beyond = divide_around(work.mesh, around, *at, left_of(turn.normalized()), work.snap);
            if (beyond != no_index) {
                divided.push_back(beyond);
            }
        }
    }
}

}  // namespace

std::optional<std::size_t> cut_as_far_as_others(CuttingWork& work, std::vector<CutCount>& count) {
    const auto ends_in_a_block = [&](const DrawnLine& line) { return count[line.cut].dropped > 0; };
    std::optional<std::size_t> too_fine;
    bool cut_any = false;  // in the last round
    const auto cut_again = [&](std::size_t cut, const CutCount& again) {
        count[cut] = {count[cut].made + again.made, again.dropped, count[cut].along + again.along};
        cut_any = cut_any || again.made > 0;
    };
    const auto cut_sets_again = [&] {
        for (const PlacedSet& set : work.bounded) {
            SlopeCheck check = SlopeCheck::valid;
            cut_again(set.cut, cut_placed_set(work, set, CutTime::once_more, check));
            too_fine = check == SlopeCheck::valid ? too_fine : set.cut;
        }
    };
    cut_sets_again();
    std::map<MeshIndex, std::vector<UnfinishedPart>> in_face;
    const auto add = [&](const std::vector<UnfinishedPart>& parts) {
        for (const UnfinishedPart& part : parts) {
            in_face[part.face].push_back(part);
        }
    };
    bool any_fault = false;
    for (const DrawnLine& line : work.drawn) {
        if (ends_in_a_block(line)) {
            add(unfinished_parts(work, line));
            any_fault = any_fault || line.half_thickness > 0;
        }
    }
    for (const PlacedSet& set : work.bounded) {
        add(unfinished_parts(work, set));
    }
    for (const auto& [face, parts] : in_face) {
        divide_where_they_meet(work, face, parts);
    }
    // Each may end on another one that is cut after it.
    constexpr int most_rounds = 10;
    bool rocks_change = cut_any || any_fault;
    for (int round = 0; round < most_rounds && !too_fine; ++round) {
        cut_any = false;
        for (const DrawnLine& line : work.drawn) {
            if (ends_in_a_block(line)) {
                cut_again(line.cut, cut_lines(work, lines_to_finish(work, line), line.joint));
            }
        }
        cut_sets_again();
        rocks_change = rocks_change || cut_any;
        if (!cut_any) {
            break;
        }
    }
    // Only the fault as drawn counts as ending inside a block, not what ran on beyond its ends.
    for (const DrawnLine& line : work.drawn) {
        if (line.half_thickness > 0 && ends_in_a_block(line)) {
            cut_again(line.cut, cut_lines(work, line.face, line.joint));
        }
    }
    // A boundary that ends inside a block parts rocks as far as later cuts part the block.
    for (const DrawnLine& line : work.drawn) {
        if (rocks_change || line.half_thickness == 0) {
            give_rocks(work, line);
        }
    }
    return too_fine;
}

}  // namespace delabole
