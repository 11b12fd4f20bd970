#include "jointed_slope/jointed_section.hpp"

#include "jointed_slope/cutting_work.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace delabole {

namespace {

constexpr double least_snap = 4e-6;  // of the section's size: keeps the rounding of corners below straight_sine
constexpr double snap_of_spacing = 0.002;
constexpr double snap_of_section = 1e-4;
constexpr double greatest_snap_of_spacing = 0.25;

MeshIndex index_of(const std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? no_index : static_cast<MeshIndex>(found - names.begin());
}

double size_of(const Polygon<>& outline) {
    double greatest = 0;
    for (const PlanePoint<>& corner : outline) {
        greatest = std::max({greatest, std::abs(corner.x()), std::abs(corner.y())});
    }
    return greatest;
}

struct FinestSet {
    std::size_t cut;
    double spacing;
};

std::optional<FinestSet> finest_set(const SlopeGeometry& geometry) {
    std::optional<FinestSet> finest;
    for (std::size_t index = 0; index < geometry.cut.size(); ++index) {
        const auto* set = std::get_if<JointSetCut>(&geometry.cut[index].trace);
        if (set != nullptr && (!finest || set->spacing < finest->spacing)) {
            finest = {index, set->spacing};
        }
    }
    return finest;
}

// Returns too_many_blocks if a set is so fine that no snap distance suits both it and the section.
SlopeCheck choose_snap(const SlopeGeometry& geometry, double size, JointedSection& section) {
    const std::optional<FinestSet> finest = finest_set(geometry);
    const double least = least_snap * size;
    const double greatest = greatest_snap_of_spacing * std::min(finest ? finest->spacing : size, size);
    if (!(least <= greatest)) {
        section.index_at_fault = finest ? finest->cut : 0;
        return finest ? SlopeCheck::too_many_blocks : SlopeCheck::outline_too_short;
    }
    const double standard = finest ? snap_of_spacing * std::min(finest->spacing, size) : snap_of_section * size;
    section.snap_distance = geometry.snap_distance.value_or(std::max(standard, least));
    return section.snap_distance >= least && section.snap_distance <= greatest ? SlopeCheck::valid
                                                                               : SlopeCheck::snap_distance_out_of_range;
}

class Cutter {
  public:
    Cutter(CuttingWork& work, const std::vector<std::string>& rocks, const std::vector<std::string>& joints)
        : work_(work), rocks_(rocks), joints_(joints) {}

    SlopeCheck check() const { return check_; }

    CutCount make(const SlopeCut& cut, std::size_t number) {
        const MeshIndex joint = index_of(joints_, cut.joint);
        require(joint != no_index, SlopeCheck::unknown_joint);
        return std::visit([&](const auto& trace) { return make(cut, trace, number, joint); }, cut.trace);
    }

  private:
    CutCount make(const SlopeCut& cut, const JointSetCut& set, std::size_t number, MeshIndex joint) {
        require(set.persistence.value_or(1) >= 1 || set.trace_length, SlopeCheck::persistence_without_trace_length);
        require(set.ends_on.has_value() == set.side.has_value(), SlopeCheck::feature_and_side);
        require(set.staggered_by.has_value() == set.stagger_share.has_value(), SlopeCheck::stagger_without_set);
        require(!set.ends_on || work_.line.contains(*set.ends_on), SlopeCheck::unknown_line);
        require(!set.staggered_by || work_.set.contains(*set.staggered_by), SlopeCheck::unknown_set);
        require(set.region.empty() || set.region.size() > 2, SlopeCheck::region_too_short);
        require(!crosses_itself(polygon_of(set.region)), SlopeCheck::region_crosses_itself);
        const MeshIndex rock = rock_of(set.rock);
        return check_ == SlopeCheck::valid ? cut_set(work_, cut, set, number, joint, rock, check_) : CutCount{};
    }

    CutCount make(const SlopeCut& cut, const LineCut& line, std::size_t number, MeshIndex joint) {
        require(line.thickness.has_value() == line.gouge.has_value(), SlopeCheck::gouge_and_thickness);
        const RocksOfLine rocks{rock_of(line.gouge), rock_of(line.rock_above), rock_of(line.rock_below)};
        return check_ == SlopeCheck::valid ? cut_line(work_, cut, line, number, joint, rocks, check_) : CutCount{};
    }

    void require(bool holds, SlopeCheck otherwise) {
        if (check_ == SlopeCheck::valid && !holds) {
            check_ = otherwise;
        }
    }

    MeshIndex rock_of(const std::optional<std::string>& name) {
        const MeshIndex rock = name ? index_of(rocks_, *name) : no_index;
        require(!name || rock != no_index, SlopeCheck::unknown_rock);
        return rock;
    }

    CuttingWork& work_;
    const std::vector<std::string>& rocks_;
    const std::vector<std::string>& joints_;
    SlopeCheck check_ = SlopeCheck::valid;
};

// Moves corners that lie nearer than `near` to the lowest, foremost or rearmost one on to the same level or upright: a
// frame is level and upright, and a gap before it would let blocks move.
void straighten_sides(Polygon<>& outline, double near) {
    Eigen::AlignedBox2d bounds;
    for (const PlanePoint<>& corner : outline) {
        bounds.extend(corner);
    }
    for (PlanePoint<>& corner : outline) {
        corner.y() = corner.y() < bounds.min().y() + near ? bounds.min().y() : corner.y();
        corner.x() = corner.x() < bounds.min().x() + near   ? bounds.min().x()
                     : corner.x() > bounds.max().x() - near ? bounds.max().x()
                                                            : corner.x();
    }
}

// The toe of an anticlockwise outline: the lowest corner of the ground from its front to its rear end; of several, to
// within `near`, the last.
PlanePoint<> toe_of(const Polygon<>& outline, double near) {
    const auto front = std::ranges::min_element(
        outline, {}, [](const PlanePoint<>& point) { return std::pair(point.x(), -point.y()); });
    const auto rear = std::ranges::max_element(
        outline, {}, [](const PlanePoint<>& point) { return std::pair(point.x(), point.y()); });
    PlanePoint<> toe = *front;
    for (auto corner = front; corner != rear; corner = std::prev(corner == outline.begin() ? outline.end() : corner)) {
        toe = corner->y() < toe.y() + near ? *corner : toe;
    }
    return toe;
}

// The origin of the section's coordinates, or the toe of an outline that does not reach there. Both are relative to its
// first corner, which lies at `first`.
PlanePoint<> datum_of(const Polygon<>& outline, const PlanePoint<>& first) {
    const PlanePoint<> origin = -first;
    const double near = least_snap * size_of(outline);
    const auto holds = [&](const auto& coordinate) {
        const auto [least, greatest] = std::ranges::minmax(outline, {}, coordinate);
        return coordinate(least) <= coordinate(origin) + near && coordinate(origin) <= coordinate(greatest) + near;
    };
    return holds([](const PlanePoint<>& point) { return point.x(); }) &&
                   holds([](const PlanePoint<>& point) { return point.y(); })
               ? origin
               : toe_of(outline, near);
}

void collect(const CuttingWork& work, JointedSection& section) {
    const SectionMesh& mesh = work.mesh;
    std::vector<MeshIndex> number(mesh.points().size(), no_index);
    for (MeshIndex face = 0; face < mesh.face_count(); ++face) {
        if (!mesh.alive(face)) {
            continue;
        }
        SlopeBlock block{{}, {}, mesh.face(face).rock, {}};
        mesh.for_each_edge(face, [&](MeshIndex edge) {
            const HalfEdge& half = mesh.edge(edge);
            MeshIndex& vertex = number[half.origin];
            if (vertex == no_index) {
                vertex = static_cast<MeshIndex>(section.vertex.size());
                section.vertex.emplace_back(work.origin + mesh.points()[half.origin]);
            }
            block.vertex.push_back(vertex);
            block.joint.push_back(half.joint);
            block.joint_along.push_back(half.joint_along);
            section.intact_edges += half.joint == intact_rock && half.twin < edge ? 1 : 0;
        });
        section.block.push_back(std::move(block));
    }
}

}  // namespace

JointedSection cut_slope(const SlopeGeometry& geometry, const std::vector<std::string>& rocks,
                         const std::vector<std::string>& joints, const std::vector<std::size_t>& rank) {
    JointedSection section;
    const auto refuse = [&](SlopeCheck check, std::size_t index = 0) {
        JointedSection refused;
        refused.check = check;
        refused.index_at_fault = index;
        return refused;
    };
    if (!in_range(geometry)) {
        return refuse(SlopeCheck::number_out_of_range);
    }
    if (rocks.empty() || joints.empty()) {
        return refuse(rocks.empty() ? SlopeCheck::unknown_rock : SlopeCheck::unknown_joint);
    }
    Polygon<> outline = prepared_outline(geometry, section);
    if (outline.size() < 3) {
        return refuse(SlopeCheck::outline_too_short);
    }
    const Polygon<> drawn = outline;
    const PlanePoint<> origin = outline.front();
    for (PlanePoint<>& corner : outline) {
        corner -= origin;
    }
    const SlopeCheck snap = choose_snap(geometry, size_of(outline), section);
    if (snap != SlopeCheck::valid) {
        return refuse(snap, section.index_at_fault);
    }
    straighten_sides(outline, section.snap_distance);
    if (const auto edge = crossing_edge(outline, section.snap_distance)) {
        const auto corner = std::ranges::find_if(geometry.outline, [&](const SectionPoint& point) {
            return PlanePoint<>(point.x, point.y) == drawn[*edge];
        });
        return refuse(SlopeCheck::outline_crosses_itself, static_cast<std::size_t>(corner - geometry.outline.begin()));
    }
    CuttingWork work{SectionMesh(outline, 0), origin, section.snap_distance, datum_of(outline, origin)};
    work.rank = rank;
    divide_into_convex(work.mesh, work.snap);
    Cutter cutter(work, rocks, joints);
    for (std::size_t index = 0; index < geometry.cut.size(); ++index) {
        section.cut.push_back(cutter.make(geometry.cut[index], index));
        if (cutter.check() != SlopeCheck::valid) {
            return refuse(cutter.check(), index);
        }
    }
    if (const std::optional<std::size_t> cut = cut_as_far_as_others(work, section.cut)) {
        return refuse(SlopeCheck::too_many_blocks, *cut);
    }
    rejoin_intact(work.mesh);
    section.typical_area = typical_area(work);
    merge_slivers(work, geometry.sliver_share.value_or(SlopeGeometry::standard_sliver_share), section);
    collect(work, section);
    section.along_each_other = std::move(work.along_each_other);
    return section;
}

Polygon<> polygon_of(const std::vector<SectionPoint>& corners) {
    Polygon<> polygon;
    polygon.reserve(corners.size());
    for (const SectionPoint& corner : corners) {
        polygon.emplace_back(corner.x, corner.y);
    }
    return polygon;
}

Polygon<> outline_of(const JointedSection& section, const SlopeBlock& block) {
    Polygon<> outline;
    outline.reserve(block.vertex.size());
    for (const MeshIndex vertex : block.vertex) {
        outline.push_back(section.vertex[vertex]);
    }
    return outline;
}

}  // namespace delabole
