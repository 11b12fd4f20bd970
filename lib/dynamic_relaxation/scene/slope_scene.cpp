#include "dynamic_relaxation/scene/slope_scene.hpp"

#include "dynamic_relaxation/scene/scenes.hpp"
#include "dynamic_relaxation/scene/straight_vertices.hpp"
#include "dynamic_relaxation/scene/water_table.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>

namespace delabole {

namespace {

std::vector<std::string> names_of(const auto& list) {
    std::vector<std::string> names;
    names.reserve(list.size());
    for (const auto& entry : list) {
        names.push_back(entry.name);
    }
    return names;
}

std::optional<std::size_t> index_of(const std::vector<std::string>& names, const std::string& name) {
    const auto found = std::find(names.begin(), names.end(), name);
    return found == names.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - names.begin()));
}

// For each joint, how many are weaker: of two, the one with less shear strength, the rock that bonds it included, under
// an eighth of the weight of rock as high as the outline, or else with less tensile strength or less shear strength
// after slip. So much presses on average on the joints below a mass that is a quarter as thick as the slope is high,
// at most. Where more presses, friction is overrated by the ratio of two tangents at most; where less does, cohesion
// would be overrated without limit.
std::vector<std::size_t> ranks_of(const RelaxationSlope& slope) {
    const std::vector<SlopeJoint>& joints = slope.joint;
    double density = 0;
    for (const SlopeRock& rock : slope.rock) {
        density = std::max(density, rock.density);
    }
    Eigen::AlignedBox2d bounds;
    for (const SectionPoint& corner : slope.geometry.outline) {
        bounds.extend(PlanePoint<>(corner.x, corner.y));
    }
    const double pressure =
        density * RelaxationScene{}.gravity.acceleration * (bounds.isEmpty() ? 0 : bounds.sizes().y()) / 8;
    const auto strength = [&](const SlopeJoint& joint) {
        const RelaxationJoint& own = joint.strength;
        double shear = own.cohesion.value_or(0) + pressure * std::tan(own.friction_angle);
        double tension = own.tensile_strength.value_or(0);
        if (own.bond) {
            shear = std::max(shear, own.bond->cohesion + pressure * std::tan(own.bond->friction_angle));
            tension = std::max(tension, own.bond->tensile_strength);
        }
        const double residual = own.residual_cohesion.value_or(0) +
                                pressure * std::tan(own.residual_friction_angle.value_or(own.friction_angle));
        return std::tuple(shear, tension, residual);
    };
    std::vector<std::size_t> ranks;
    for (const SlopeJoint& joint : joints) {
        const auto is_weaker = [&](const SlopeJoint& other) { return strength(other) < strength(joint); };
        ranks.push_back(static_cast<std::size_t>(std::ranges::count_if(joints, is_weaker)));
    }
    return ranks;
}

std::vector<Polygon<>> polygons_of(const auto& areas) {
    std::vector<Polygon<>> polygons;
    polygons.reserve(areas.size());
    for (const auto& area : areas) {
        polygons.push_back(polygon_of(area.vertex));
    }
    return polygons;
}

// A section is needed several times in a row for the same geometry: to check a case, to name its outputs, for each run
// of a fit. Each thread keeps its last section.
const JointedSection& section_of(const SlopeGeometry& geometry, const std::vector<std::string>& rocks,
                                 const std::vector<std::string>& joints, const std::vector<std::size_t>& rank) {
    struct Kept {
        SlopeGeometry geometry;
        std::vector<std::string> rocks;
        std::vector<std::string> joints;
        std::vector<std::size_t> rank;
        JointedSection section;
    };
    thread_local std::optional<Kept> kept;
    if (!kept || kept->rocks != rocks || kept->joints != joints || kept->rank != rank || kept->geometry != geometry) {
        kept.reset();
        kept.emplace(Kept{geometry, rocks, joints, rank, cut_slope(geometry, rocks, joints, rank)});
    }
    return kept->section;
}

class SlopeSceneMaker {
  public:
    explicit SlopeSceneMaker(const RelaxationSlope& slope)
        : slope_(slope), joints_(names_of(slope.joint)), rocks_(names_of(slope.rock)), rank_(ranks_of(slope)) {}

    SlopeScene make() {
        scene_.section = section_of(slope_.geometry, rocks_, joints_, rank_);
        if (section().check != SlopeCheck::valid) {
            return refused(section().check, section().index_at_fault);
        }
        const SlopeCheck check = check_rest();
        if (check != SlopeCheck::valid) {
            return refused(check, index_at_fault_);
        }
        for (const PlanePoint<>& vertex : section().vertex) {
            bounds_.extend(vertex);
        }
        add_blocks();
        if (slope_.frame && !add_frame()) {
            return refused(SlopeCheck::frame_without_edge, 0);
        }
        scene_.beside_frame = slope_.frame ? length_beside_frame() : 0;
        for (std::size_t index = 0; index < used_.size(); ++index) {
            if (!used_[index]) {
                return refused(SlopeCheck::area_without_block, index);
            }
        }
        section().vertex.clear();
        section().block.clear();
        return std::move(scene_);
    }

  private:
    JointedSection& section() { return scene_.section; }

    static SlopeScene refused(SlopeCheck check, std::size_t index) {
        SlopeScene scene;
        scene.check = check;
        scene.index_at_fault = index;
        return scene;
    }

    SlopeCheck check_rest() {
        if (slope_.geometry.intact_joint) {
            intact_ = index_of(joints_, *slope_.geometry.intact_joint);
            if (!intact_) {
                return SlopeCheck::unknown_joint;
            }
        } else if (section().intact_edges > 0) {
            return SlopeCheck::intact_joint_missing;
        }
        if (slope_.frame) {
            frame_joint_ = index_of(joints_, slope_.frame->joint);
            if (!frame_joint_) {
                return SlopeCheck::unknown_joint;
            }
        }
        if (slope_.water) {
            const auto& points = slope_.water->vertex;
            if (points.size() < 2) {
                return SlopeCheck::water_table_too_short;
            }
            for (std::size_t index = 1; index < points.size(); ++index) {
                if (!(points[index].x > points[index - 1].x)) {
                    return SlopeCheck::water_table_not_increasing;
                }
            }
        }
        std::vector<Polygon<>> areas = polygons_of(slope_.fixed);
        std::ranges::move(polygons_of(slope_.stage), std::back_inserter(areas));
        used_.assign(areas.size(), false);
        for (index_at_fault_ = 0; index_at_fault_ < areas.size(); ++index_at_fault_) {
            if (areas[index_at_fault_].size() < 3) {
                return SlopeCheck::area_too_short;
            }
            if (crosses_itself(areas[index_at_fault_])) {
                return SlopeCheck::area_crosses_itself;
            }
        }
        return SlopeCheck::valid;
    }

    void add_blocks() {
        struct Place {
            bool fixed;
            double level;  // in snap distances: centres of one row differ by rounding
            double x;
            double y;
            std::size_t index;

            auto key() const { return std::tie(fixed, level, x, y, index); }
        };
        const std::vector<Polygon<>> fixed_areas = polygons_of(slope_.fixed);
        const std::vector<Polygon<>> stages = polygons_of(slope_.stage);
        std::vector<Place> order;
        for (std::size_t index = 0; index < section().block.size(); ++index) {
            const PlanePoint<> centre = area_properties(outline_of(section(), section().block[index])).centroid;
            bool fixed = false;
            for (std::size_t area = 0; area < slope_.fixed.size(); ++area) {
                if (inside(fixed_areas[area], centre)) {
                    fixed = used_[area] = true;
                }
            }
            const double level = std::round((centre.y() - bounds_.min().y()) / section().snap_distance);
            order.push_back({fixed, level, centre.x(), centre.y(), index});
        }
        std::sort(order.begin(), order.end(),
                  [](const Place& one, const Place& other) { return one.key() < other.key(); });
        for (const Place& place : order) {
            add_block(section().block[place.index], place.fixed);
            for (std::size_t stage = 0; stage < slope_.stage.size(); ++stage) {
                if (inside(stages[stage], {place.x, place.y})) {
                    used_[slope_.fixed.size() + stage] = true;
                    scene_.removal.push_back({scene_.block.size() - 1, slope_.stage[stage].time});
                }
            }
        }
    }

    // The joint along an edge, to the next vertex; on the frame the weaker of the frame's and that of a cut along it.
    MeshIndex joint_of(const SlopeBlock& block, std::size_t edge) {
        const PlanePoint<>& from = section().vertex[block.vertex[edge]];
        const PlanePoint<>& to = section().vertex[block.vertex[(edge + 1) % block.vertex.size()]];
        if (block.joint[edge] != free_surface || !on_frame(from, to)) {
            return block.joint[edge];
        }
        const MeshIndex along = block.joint_along[edge];
        const std::size_t frame = *frame_joint_;
        if (along < rank_.size() && along != frame) {
            section().along_each_other.insert(std::minmax<std::size_t>(along, frame));
        }
        return along != free_surface && rank_[along] < rank_[frame] ? along : static_cast<MeshIndex>(frame);
    }

    void add_block(const SlopeBlock& block, bool fixed) {
        RelaxationBlock made{{}, slope_.rock[block.rock].density};
        made.fixed = fixed;
        const std::size_t count = block.vertex.size();
        std::vector<MeshIndex> joint_at;
        for (std::size_t edge = 0; edge < count; ++edge) {
            joint_at.push_back(joint_of(block, edge));
        }
        std::vector<MeshIndex> joints;
        for (std::size_t vertex = 0; vertex < count; ++vertex) {
            const std::size_t before = (vertex + count - 1) % count;
            const auto at = [&](std::size_t index) { return section().vertex[block.vertex[index % count]]; };
            const bool joint_changes = joint_at[before] != joint_at[vertex];
            const bool straight = goes_straight_on(at(before), at(vertex), at(vertex + 1));
            if (joint_changes || !straight) {
                made.outline.push_back(at(vertex));
                joints.push_back(joint_at[vertex]);
            }
            const bool framed = joint_at[before] != block.joint[before] && joint_at[vertex] != block.joint[vertex];
            if (joint_changes && straight && framed) {
                joint_change_.push_back(at(vertex));
            }
        }
        for (std::size_t edge = 0; edge < made.outline.size(); ++edge) {
            const PlanePoint<>& from = made.outline[edge];
            const PlanePoint<>& to = made.outline[(edge + 1) % made.outline.size()];
            const MeshIndex joint = joints[edge];
            made.joint.push_back(joint == free_surface ? 0 : joint == intact_rock ? *intact_ : joint);
            const double share = joint == free_surface ? 1 : slope_.joint[made.joint.back()].water_share.value_or(1);
            if (slope_.water && !fixed && joint != intact_rock && share > 0) {
                add_pressures(edge, share * slope_.water->unit_weight, depths_along(slope_.water->vertex, from, to));
            }
        }
        scene_.block.push_back(std::move(made));
        scene_.rock.push_back(block.rock);
    }

    // Adds the pressures on an edge of the block under construction.
    void add_pressures(std::size_t edge, double unit_weight, const std::vector<FaceDepth>& depths) {
        for (std::size_t piece = 1; piece < depths.size(); ++piece) {
            const FaceDepth& from = depths[piece - 1];
            const FaceDepth& to = depths[piece];
            if (from.depth > 0 || to.depth > 0) {
                const bool whole = depths.size() == 2;
                scene_.pressure.push_back({scene_.block.size(), edge, unit_weight * from.depth, unit_weight * to.depth,
                                           whole ? std::nullopt : std::optional(EdgePart{from.place, to.place}), true});
            }
        }
    }

    bool has(FrameSides side) const { return slope_.frame && slope_.frame->sides >= side; }

    bool on_frame(const PlanePoint<>& from, const PlanePoint<>& to) {
        if (!slope_.frame) {
            return false;
        }
        const double near = section().snap_distance;
        const auto along = [&](double one, double other, double side) {
            return std::abs(one - side) < near && std::abs(other - side) < near;
        };
        const bool below = along(from.y(), to.y(), bounds_.min().y());
        const bool behind = has(FrameSides::below_and_behind) && along(from.x(), to.x(), bounds_.max().x());
        const bool in_front = has(FrameSides::all_around) && along(from.x(), to.x(), bounds_.min().x());
        const auto note = [](Side& side, bool there, double top) {
            side.there = side.there || there;
            side.top = there ? std::max(side.top, top) : side.top;
        };
        const double top = std::max(from.y(), to.y());
        note(below_, below, top);
        note(behind_, behind, top);
        note(in_front_, in_front, top);
        return below || behind || in_front;
    }

    bool add_frame() {
        const SlopeFrame& frame = *slope_.frame;
        const bool behind = has(FrameSides::below_and_behind);
        const bool in_front = has(FrameSides::all_around);
        if (!below_.there || (behind && !behind_.there) || (in_front && !in_front_.there)) {
            return false;
        }
        const double reach = frame.reach.value_or(0);
        const double left = bounds_.min().x() - (in_front ? frame.thickness : reach);
        const double right = bounds_.max().x() + (behind ? frame.thickness : reach);
        add_frame_block(upright_rectangle(left, bounds_.min().y() - frame.thickness, right, bounds_.min().y()));
        if (behind) {
            add_frame_block(upright_rectangle(bounds_.max().x(), bounds_.min().y(), right, behind_.top));
        }
        if (in_front) {
            add_frame_block(upright_rectangle(left, bounds_.min().y(), bounds_.min().x(), in_front_.top));
        }
        return true;
    }

    // The frame has a vertex, too, where the joint along it changes, so that the corner of a block there bears half on
    // either joint.
    Polygon<> with_joint_changes(const Polygon<>& rectangle) const {
        Polygon<> outline;
        for (std::size_t side = 0; side < rectangle.size(); ++side) {
            const PlanePoint<>& from = rectangle[side];
            const PlanePoint<> whole = rectangle[(side + 1) % rectangle.size()] - from;
            const double length = whole.norm();
            const PlanePoint<> along = whole / length;
            const double near = scene_.section.snap_distance;
            std::set<double> places{0};
            for (const PlanePoint<>& point : joint_change_) {
                const double place = along.dot(point - from);
                if ((from + place * along - point).norm() < near && place > near && place < length - near) {
                    places.insert(place);
                }
            }
            for (const double place : places) {
                outline.emplace_back(from + place * along);
            }
        }
        return outline;
    }

    // Level edges with none below them, and upright ones no higher than the frame behind.
    double length_beside_frame() {
        const double cosine = std::cos(degrees(6));
        Polygon<> outline = polygon_of(slope_.geometry.outline);
        if (area_properties(outline).area < 0) {
            std::ranges::reverse(outline);
        }
        const std::size_t count = outline.size();
        const auto any_is_below = [&](const PlanePoint<>& point) {
            for (std::size_t edge = 0; edge < count; ++edge) {
                const PlanePoint<>& from = outline[edge];
                const PlanePoint<>& to = outline[(edge + 1) % count];
                if ((from.x() < point.x()) != (to.x() < point.x()) && std::max(from.y(), to.y()) < point.y()) {
                    return true;
                }
            }
            return false;
        };
        double length = 0;
        for (std::size_t edge = 0; edge < count; ++edge) {
            const PlanePoint<>& from = outline[edge];
            const PlanePoint<>& to = outline[(edge + 1) % count];
            const PlanePoint<> along = to - from;
            const bool level = along.x() > cosine * along.norm() && !any_is_below((from + to) / 2);
            const bool upright = has(FrameSides::below_and_behind) && along.y() > cosine * along.norm() &&
                                 (from.y() + to.y()) / 2 < behind_.top;
            length += (level || upright) && !on_frame(from, to) ? along.norm() : 0;
        }
        return length;
    }

    void add_frame_block(const Polygon<>& rectangle) {
        RelaxationBlock block{with_joint_changes(rectangle), slope_.rock.front().density};
        block.fixed = true;
        block.joint.assign(block.outline.size(), *frame_joint_);
        scene_.block.push_back(std::move(block));
        scene_.rock.push_back(slope_.rock.size());
    }

    struct Side {
        bool there = false;
        double top = -std::numeric_limits<double>::infinity();
    };

    const RelaxationSlope& slope_;
    std::vector<std::string> joints_;
    std::vector<std::string> rocks_;
    std::vector<std::size_t> rank_;  // of joints
    SlopeScene scene_ = {};
    Eigen::AlignedBox2d bounds_ = {};
    std::optional<std::size_t> intact_ = {};
    std::optional<std::size_t> frame_joint_ = {};
    std::size_t index_at_fault_ = 0;
    std::vector<bool> used_ = {};  // areas, then stages, that contain a block
    Side below_ = {};
    Side behind_ = {};
    Side in_front_ = {};
    Polygon<> joint_change_ = {};  // points on the frame between two joints
};

}  // namespace

SlopeScene slope_scene(const RelaxationSlope& slope) {
    return SlopeSceneMaker(slope).make();
}

}  // namespace delabole
