#include "limit_equilibrium/bound/block_assembly.hpp"

#include <algorithm>
#include <cmath>

namespace delabole {

namespace {

// Axes rotated by the base dip: u up-dip along the bases, v normal to them.
class TurnedAxes {
  public:
    explicit TurnedAxes(double base_dip) : cosine_(std::cos(base_dip)), sine_(std::sin(base_dip)) {}
    Point to_section(double u, double v) const { return {u * cosine_ - v * sine_, u * sine_ + v * cosine_}; }

  private:
    double cosine_;
    double sine_;
};

// A column, or its part between two cross joints; v is measured from the base of the column.
struct Piece {
    std::size_t body;
    double bottom;
    double top;
};

void add_interfaces(const TurnedAxes& axes, double u, const std::vector<Piece>& lower, const std::vector<Piece>& upper,
                    double friction_angle, Assembly& assembly) {
    auto left = lower.begin();
    auto right = upper.begin();
    while (left != lower.end() && right != upper.end()) {
        const double bottom = std::max(left->bottom, right->bottom);
        const double top = std::min(left->top, right->top);
        // A minute length comes from rounding of the heights and is not a face.
        if (top - bottom > 1e-9 * (left->top - left->bottom)) {
            assembly.contacts.push_back(
                {left->body, right->body, axes.to_section(u, bottom), axes.to_section(u, top), friction_angle, 0});
        }
        (left->top < right->top ? left : right)++;
    }
}

Body column_body(const TurnedAxes& axes, const Column<>& column) {
    Body body{};
    body.weight = column.weight;
    const Point corner = axes.to_section(column.base_u, column.base_v);
    body.centroid = corner + axes.to_section(column.width / 2, column.height / 2);
    const Point whole = axes.to_section(-column.down_dip_force, -column.normal_force);
    const Point weight(0, -column.weight);
    body.load.force = whole - weight;
    // The overturning moment is about the toe corner, anticlockwise with x into the slope and y up.
    body.load.moment = column.overturning_moment - cross(body.centroid - corner, whole);
    return body;
}

void add_slide_head(const TurnedAxes& axes, const ColumnSlope<>& slope, double interface_friction, Assembly& assembly) {
    const SlideHeadWedge<>& wedge = *slope.slide_head;
    const Column<>& last = slope.columns.back();
    const double u = last.base_u + last.width;
    const double v = last.base_v + wedge.face_base;
    const Point foot = axes.to_section(u, v);
    const Point along(std::cos(wedge.joint_dip), std::sin(wedge.joint_dip));
    Body body{};
    body.weight = wedge.weight;
    // The centroid is put on the line of the resultant, so that weight, water and loads have no moment about it.
    body.centroid = foot + wedge.reaction_position * along;
    body.load.force =
        Point(wedge.force_x, wedge.force_y + wedge.weight) + wedge.water_force * Point(-along.y(), along.x());
    const std::size_t index = assembly.bodies.size();
    assembly.bodies.push_back(body);
    assembly.contacts.push_back(
        {index, {}, foot, foot + wedge.joint_length * along, wedge.friction_angle, wedge.cohesion});
    assembly.contacts.push_back(
        {index - 1, index, foot, axes.to_section(u, v + wedge.face_length), interface_friction, 0});
}

bool carries_weight_alone(const TurnedAxes& axes, const Column<>& column) {
    const Body body = column_body(axes, column);
    const double rounding = 1e-9 * column.weight;
    return body.load.force.norm() <= rounding &&
           std::abs(body.load.moment) <= rounding * std::hypot(column.width, column.height);
}

std::vector<double> cuts(const Column<>& column, const CrossJoints& cross_joints, double stagger) {
    std::vector<double> heights{0};
    const double start = stagger > 0 ? stagger : cross_joints.spacing;
    for (std::size_t number = 0;; ++number) {
        const double height = start + cross_joints.spacing * static_cast<double>(number);
        if (!(height < column.height * (1 - 1e-9))) {
            break;
        }
        heights.push_back(height);
    }
    heights.push_back(column.height);
    return heights;
}

Assembly refused(AssemblyCheck check) {
    Assembly assembly;
    assembly.check = check;
    return assembly;
}

}  // namespace

Assembly assemble_row(const std::vector<RectangularBlock>& blocks, const BlockFriction& friction) {
    Assembly assembly;
    double x = 0;
    for (std::size_t index = 0; index < blocks.size(); ++index) {
        const RectangularBlock& block = blocks[index];
        if (!(block.width > 0 && block.height > 0)) {
            return refused(AssemblyCheck::block_without_size);
        }
        if (index > 0) {
            const double contact = std::min(block.height, blocks[index - 1].height);
            assembly.contacts.push_back({index - 1, index, {x, 0}, {x, contact}, friction.interface, 0});
        }
        assembly.bodies.push_back({block.weight, {x + block.width / 2, block.height / 2}, {}});
        assembly.contacts.push_back({index, {}, {x, 0}, {x + block.width, 0}, friction.base, 0});
        x += block.width;
    }
    assembly.check = AssemblyCheck::valid;
    assembly.check = check_assembly(assembly);
    return assembly;
}

Assembly assemble_columns(const ColumnSlope<>& slope, const BlockFriction& friction, double upper_part) {
    if (!(upper_part > 0 && upper_part <= whole_joint)) {
        return refused(AssemblyCheck::input_out_of_range);
    }
    if (slope.check != ColumnCheck::valid || slope.columns.empty()) {
        return refused(AssemblyCheck::columns_not_valid);
    }
    const TurnedAxes axes(slope.base_dip);
    Assembly assembly;
    for (std::size_t index = 0; index < slope.columns.size(); ++index) {
        const Column<>& column = slope.columns[index];
        if (!(column.width > 0 && column.height > 0)) {
            return refused(AssemblyCheck::block_without_size);
        }
        const double end = column.base_u + column.width;
        assembly.bodies.push_back(column_body(axes, column));
        assembly.contacts.push_back({index,
                                     {},
                                     axes.to_section(column.base_u, column.base_v),
                                     axes.to_section(end, column.base_v),
                                     friction.base,
                                     0});
        if (column.joint_length > 0 && index + 1 < slope.columns.size()) {
            const double top = column.base_v + column.upper_contact;
            assembly.contacts.push_back({index, index + 1, axes.to_section(end, top - upper_part * column.joint_length),
                                         axes.to_section(end, top), friction.interface, 0});
        }
    }
    if (slope.slide_head) {
        add_slide_head(axes, slope, friction.interface, assembly);
    }
    assembly.check = AssemblyCheck::valid;
    assembly.check = check_assembly(assembly);
    return assembly;
}

Assembly assemble_blocks(const ColumnSlope<>& slope, const CrossJoints& cross_joints, const BlockFriction& friction) {
    if (slope.check != ColumnCheck::valid || slope.columns.empty()) {
        return refused(AssemblyCheck::columns_not_valid);
    }
    if (slope.slide_head) {
        return refused(AssemblyCheck::loads_beyond_weight);
    }
    double blocks = 0;
    for (const Column<>& column : slope.columns) {
        blocks += column.height / cross_joints.spacing + 2;
    }
    if (!(cross_joints.spacing > 0 && cross_joints.stagger >= 0 && cross_joints.stagger < cross_joints.spacing &&
          blocks <= static_cast<double>(most_blocks))) {
        return refused(AssemblyCheck::cross_joints_too_near);
    }
    const TurnedAxes axes(slope.base_dip);
    Assembly assembly;
    std::vector<Piece> previous;
    for (std::size_t index = 0; index < slope.columns.size(); ++index) {
        const Column<>& column = slope.columns[index];
        if (!(column.width > 0 && column.height > 0)) {
            return refused(AssemblyCheck::block_without_size);
        }
        if (!carries_weight_alone(axes, column)) {
            return refused(AssemblyCheck::loads_beyond_weight);
        }
        const std::vector<double> heights = cuts(column, cross_joints, index % 2 == 1 ? cross_joints.stagger : 0);
        std::vector<Piece> pieces;
        for (std::size_t part = 0; part + 1 < heights.size(); ++part) {
            const Piece piece{assembly.bodies.size(), column.base_v + heights[part], column.base_v + heights[part + 1]};
            const bool on_base = part == 0;
            assembly.bodies.push_back(
                {column.weight * ((heights[part + 1] - heights[part]) / column.height),
                 axes.to_section(column.base_u + column.width / 2, (piece.bottom + piece.top) / 2),
                 {}});
            assembly.contacts.push_back({piece.body, on_base ? std::nullopt : std::optional(piece.body - 1),
                                         axes.to_section(column.base_u, piece.bottom),
                                         axes.to_section(column.base_u + column.width, piece.bottom),
                                         on_base ? friction.base : cross_joints.friction_angle, 0});
            pieces.push_back(piece);
        }
        add_interfaces(axes, column.base_u, previous, pieces, friction.interface, assembly);
        previous = std::move(pieces);
    }
    assembly.check = AssemblyCheck::valid;
    assembly.check = check_assembly(assembly);
    return assembly;
}

}  // namespace delabole
