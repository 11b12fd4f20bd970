#include "limit_equilibrium/stepped_path/path_lattice.hpp"

#include "limit_equilibrium/stepped_path/surface_strength.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole {

namespace {

constexpr double most_nodes = 1e5;

// Intersection of two lines that are not parallel.
Point crossing(const SectionLine& a, const SectionLine& b) {
    const double determinant = cross(a.normal, b.normal);
    return {(a.offset * b.normal.y() - b.offset * a.normal.y()) / determinant,
            (a.normal.x() * b.offset - b.normal.x() * a.offset) / determinant};
}

Point direction(double dip) {
    return {std::cos(dip), std::sin(dip)};
}

// The right normal of a line that rises into the slope points into the slope, the left one upwards.
Point right_of(const Point& along) {
    return {along.y(), -along.x()};
}

SectionLine line_through(const Point& point, const Point& normal) {
    return {normal, normal.dot(point)};
}

}  // namespace

PathLattice::PathLattice(const SteppedPath& path) {
    const SlopeSection<>& slope = path.slope;
    const bool slides = path.search.mechanism == SteppedPathMechanism::sliding;
    const bool with_risers = path.search.mechanism != SteppedPathMechanism::toppling;
    const auto refuse = [&](bool wrong, SteppedPathCheck reason) {
        if (wrong) {
            check = reason;
        }
        return wrong;
    };
    if (refuse(!in_range(path), SteppedPathCheck::input_out_of_range) ||
        refuse(slope.bench.has_value(), SteppedPathCheck::bench_not_covered) ||
        refuse(with_risers && !path.risers, SteppedPathCheck::risers_needed) ||
        refuse(!slides && !path.columns, SteppedPathCheck::columns_needed) ||
        refuse(!(slope.upper_surface_dip < slope.face_dip), SteppedPathCheck::ground_too_steep) ||
        refuse(!(path.steps.dip < slope.face_dip), SteppedPathCheck::steps_steeper_than_face) ||
        refuse(with_risers && !(slope.upper_surface_dip < path.risers->dip), SteppedPathCheck::ground_too_steep)) {
        return;
    }
    // Directions that differ by less than this belong to one set.
    const double least_angle = degrees(1);
    const double column_dip = path.columns && !slides ? -path.columns->dip : degrees(90);
    if (refuse(with_risers && path.risers->dip - path.steps.dip < least_angle, SteppedPathCheck::joints_too_close) ||
        refuse(!slides && (column_dip + path.steps.dip < least_angle ||
                           column_dip + path.steps.dip > degrees(180) - least_angle),
               SteppedPathCheck::joints_too_close) ||
        refuse(!slides && with_risers && degrees(180) - column_dip - path.risers->dip < least_angle,
               SteppedPathCheck::joints_too_close) ||
        refuse(!slides && !(column_dip + slope.upper_surface_dip > least_angle), SteppedPathCheck::ground_too_steep)) {
        return;
    }
    cot_face_ = std::cos(slope.face_dip) / std::sin(slope.face_dip);
    slope_upper_ = std::tan(slope.upper_surface_dip);
    crest = {slope.height * cot_face_, slope.height};
    face_ = line_through(Point(0, 0), left_of(direction(slope.face_dip)));
    upper_ = line_through(crest, left_of(direction(slope.upper_surface_dip)));
    tolerance_ = 1e-9 * slope.height;
    if (path.massive_rock) {
        // If a surface begins at a crossing above this plane, it stays above it further up.
        const double dip = path.massive_rock->boundary_dip;
        if (refuse(!(dip > path.steps.dip) || (with_risers && !(dip < path.risers->dip)),
                   SteppedPathCheck::boundary_not_between)) {
            return;
        }
        const double height = path.massive_rock->boundary_height;
        massive_ = line_through(Point(height * cot_face_, height), left_of(direction(dip)));
    }
    unit_weight_ = path.rock.unit_weight;
    step_along_ = direction(path.steps.dip);
    step_spacing_ = path.steps.spacing;
    // The last level that daylights below the crest.
    levels = 1 + static_cast<std::size_t>(
                     std::min(most_nodes, std::floor((level_line(0).normal.dot(crest) - tolerance_) / step_spacing_)));
    greatest_retreat = path.search.greatest_retreat.value_or(slope.height) + tolerance_;
    const double span = crest.x() + greatest_retreat;
    double risers = 0;
    double columns = 0;
    if (with_risers) {
        riser_along_ = direction(path.risers->dip);
        riser_spacing_ = path.risers->spacing;
        risers = greatest_retreat / riser_spacing_;
    }
    if (slides) {
        const double toe_to_crest = right_of(riser_along_).dot(crest);  // positive if risers are steeper than the face
        risers_in_front_ = std::floor(std::max(0.0, toe_to_crest) / riser_spacing_);
        risers += risers_in_front_;
    } else {
        column_up_ = {-std::cos(column_dip), std::sin(column_dip)};
        column_spacing_ = path.columns->spacing;
        columns = span / column_spacing_;
    }
    const double with_steps = std::max(risers, columns) * static_cast<double>(levels);
    const double wedges_at_most = risers * columns;
    if (refuse(!(with_steps < most_nodes && wedges_at_most < most_nodes), SteppedPathCheck::too_many_nodes)) {
        return;
    }
    const double whole_block = with_risers ? riser_spacing_ / riser_along_.y() : column_spacing_ / column_up_.y();
    least_width = path.search.least_width.value_or(whole_block) - tolerance_;
    check = SteppedPathCheck::valid;
    set_water(path);
    if (check != SteppedPathCheck::valid) {
        return;
    }
    if (slides) {
        set_risers();
    } else {
        set_columns(path);
    }
    if (!has_surface()) {
        check = SteppedPathCheck::no_path;
    }
}

// Whether any sufficiently wide surface daylights within the allowed retreat.
bool PathLattice::has_surface() const {
    if (std::ranges::any_of(step_outcrop, &std::optional<Point>::has_value)) {
        return true;
    }
    for (std::size_t riser = 0; riser < riser_node.size(); ++riser) {
        const auto& nodes = riser_node[riser];
        if (retreat(riser_outcrop[riser]) >= least_width &&
            std::ranges::any_of(nodes, &std::optional<Point>::has_value)) {
            return true;
        }
    }
    for (std::size_t column = 0; column < cells.size(); ++column) {
        const bool crack = retreat(column_outcrop[column]) >= least_width;
        for (const PathCell& cell : cells[column]) {
            const auto closes = [&](const PathWedge& wedge) { return wedge.depth <= cell.upper_reach; };
            if (cell.exists && (crack || std::ranges::any_of(wedges[column], closes))) {
                return true;
            }
        }
    }
    return false;
}

SectionLine PathLattice::level_line(std::size_t level) const {
    return {left_of(step_along_), static_cast<double>(level) * step_spacing_};
}

SectionLine PathLattice::riser_line(std::size_t riser) const {
    SectionLine line = line_through(crest, right_of(riser_along_));
    line.offset += (static_cast<double>(riser) - risers_in_front_) * riser_spacing_;
    return line;
}

SectionLine PathLattice::column_line(std::size_t joint) const {
    return {right_of(column_up_), static_cast<double>(joint) * column_spacing_};
}

double PathLattice::ground(double x) const {
    const double behind = crest.y() + (x - crest.x()) * slope_upper_;
    return x < crest.x() ? std::min(behind, cot_face_ > 0 ? x / cot_face_ : behind) : behind;
}

// The crest lies off the straight line between two points of the ground only if they are on either side of it. On a
// vertical face their x differ from that of the crest by rounding alone and would not tell.
bool PathLattice::crest_between(const Point& one, const Point& other) const {
    return std::abs(cross(crest - one, other - one)) > tolerance_ * (other - one).norm();
}

// The integral of the height of the ground from the toe to x.
double PathLattice::ground_integral(double x) const {
    const double in_face = std::min(x, crest.x());
    const double behind = x - in_face;
    const double face_part = cot_face_ > 0 ? in_face * in_face / cot_face_ / 2 : 0;
    return face_part + behind * (crest.y() + behind * slope_upper_ / 2);
}

double PathLattice::area_above(const Point& from, const Point& to) const {
    return ground_integral(to.x()) - ground_integral(from.x()) - (to.x() - from.x()) * (from.y() + to.y()) / 2;
}

bool PathLattice::inside(const Point& point) const {
    return face_.normal.dot(point) < face_.offset - tolerance_ &&
           upper_.normal.dot(point) < upper_.offset - tolerance_ && !in_massive_rock(point);
}

// The point at which a ray from inside leaves the rock; the rock has no lower boundary.
Point PathLattice::exit(const Point& from, const Point& along) const {
    double distance = std::numeric_limits<double>::infinity();
    for (const SectionLine& side : {face_, upper_}) {
        const double closing = side.normal.dot(along);
        if (closing > 0) {
            distance = std::min(distance, (side.offset - side.normal.dot(from)) / closing);
        }
    }
    return from + distance * along;
}

std::optional<Point> PathLattice::face_point(std::size_t level) const {
    if (level == 0) {
        return Point(0, 0);
    }
    const Point point = crossing(level_line(level), face_);
    return point.y() < crest.y() - tolerance_ ? std::optional(point) : std::nullopt;
}

std::optional<Point> PathLattice::riser_in_face(std::size_t riser) const {
    constexpr double parallel = 1e-9;
    if (!(cross(riser_along_, Point(cot_face_, 1)) > parallel)) {
        return std::nullopt;
    }
    const Point point = crossing(riser_line(riser), face_);
    const bool in_face = point.y() >= -tolerance_ && point.y() < crest.y() - tolerance_;
    return in_face && !in_massive_rock(point) ? std::optional(point) : std::nullopt;
}

void PathLattice::add_part(PathLoad& load, double& area, const Point* corners, std::size_t count,
                           const Point& about) const {
    double twice = 0;
    double moment = 0;
    for (std::size_t index = 2; index < count; ++index) {
        const double part = cross(corners[index - 1] - corners[0], corners[index] - corners[0]);
        twice += part;
        moment += part * ((corners[index - 1].x() + corners[index].x() + corners[0].x()) / 3 - about.x());
    }
    area += twice / 2;
    load.force.y() -= unit_weight_ * twice / 2;
    load.moment -= unit_weight_ * moment / 2;
}

void PathLattice::add_push(PathLoad& load, const EdgeWater& water, const Point& from, const Point& along,
                           const Point& normal, const Point& about) const {
    const Point force = water.force * normal;
    load.force += force;
    load.moment += cross(from + water.position * along - about, force);
}

void PathLattice::set_riser_outcrops() {
    for (double from_crest = -risers_in_front_;; ++from_crest) {
        const SectionLine riser = riser_line(riser_outcrop.size());
        const Point outcrop = from_crest == 0 ? crest : crossing(riser, from_crest < 0 ? face_ : upper_);
        if (retreat(outcrop) > greatest_retreat) {
            break;
        }
        riser_outcrop.push_back(outcrop);
    }
}

void PathLattice::set_risers() {
    set_riser_outcrops();
    for (std::size_t riser = 0; riser < riser_outcrop.size(); ++riser) {
        std::vector<std::optional<Point>>& nodes = riser_node.emplace_back(levels);
        for (std::size_t level = 0; level < levels; ++level) {
            const Point node = crossing(riser_line(riser), level_line(level));
            const auto at_face = face_point(level);
            if (at_face && inside(node) && node.x() - at_face->x() >= least_width) {
                nodes[level] = node;
            }
        }
    }
    step_outcrop.resize(levels);
    for (std::size_t level = 0; level < levels && cross(Point(1, slope_upper_), step_along_) > 0; ++level) {
        const Point outcrop = crossing(level_line(level), upper_);
        if (face_point(level) && is_far_enough(outcrop) && !in_massive_rock(outcrop)) {
            step_outcrop[level] = outcrop;
        }
    }
}

PathCell PathLattice::make_cell(std::size_t column, std::size_t level) const {
    PathCell cell;
    const SectionLine step = level_line(level);
    cell.base_to = crossing(column_line(column), step);
    const auto at_face = face_point(level);
    if (!at_face || !inside(cell.base_to) || !(cell.base_to.x() > at_face->x() + tolerance_)) {
        return cell;
    }
    cell.base_from = crossing(column_line(column - 1), step);
    cell.at_face = !(cell.base_from.x() > at_face->x() + tolerance_);
    if (cell.at_face) {
        cell.base_from = *at_face;
    }
    cell.exists = true;
    const Point& upper_top = column_outcrop[column - 1];
    std::array<Point, 5> corners{cell.base_from, cell.base_to, upper_top};
    std::size_t count = 3;
    const Point lower_top = cell.at_face ? cell.base_from : column > 1 ? column_outcrop[column - 2] : Point(0, 0);
    if (crest_between(lower_top, upper_top)) {
        corners[count++] = crest;
    }
    if (!cell.at_face) {
        corners[count++] = lower_top;
        cell.lower_contact = (lower_top - cell.base_from).dot(column_up_);
    }
    PathLoad load;
    add_part(load, cell.area, corners.data(), count, cell.base_from);
    const Point step_up = left_of(step_along_);
    const Point out = left_of(column_up_);  // of the slope, normal to the joints
    if (water_weight_ > 0) {
        add_push(load, water_on(cell.base_from, cell.base_to), cell.base_from, step_along_, step_up, cell.base_from);
        add_push(load, water_on(cell.base_to, upper_top), cell.base_to, column_up_, out, cell.base_from);
        if (!cell.at_face) {
            add_push(load, water_on(cell.base_from, lower_top), cell.base_from, column_up_, -out, cell.base_from);
        }
    }
    cell.down_dip = -step_along_.dot(load.force);
    cell.normal = -step_up.dot(load.force);
    cell.overturning = load.moment;
    cell.base_length = (cell.base_to - cell.base_from).norm();
    cell.upper_reach = (upper_top - cell.base_to).dot(column_up_);
    cell.push_arm = cross(upper_top - cell.base_from, out);
    cell.drag_arm = cross(upper_top - cell.base_from, -column_up_);
    return cell;
}

std::optional<PathWedge> PathLattice::make_wedge(const SteppedPath& path, std::size_t column, std::size_t riser) const {
    const Point corner = crossing(column_line(column), riser_line(riser));
    const Point& top = column_outcrop[column - 1];
    const double depth = (top - corner).dot(column_up_);
    if (!(depth > tolerance_) || !inside(corner)) {
        return std::nullopt;
    }
    PathWedge wedge{riser, depth, corner, riser_outcrop[riser], 0, {}};
    std::array<Point, 4> corners{corner, wedge.outcrop};
    std::size_t count = 2;
    if (crest_between(top, wedge.outcrop)) {
        corners[count++] = crest;
    }
    corners[count++] = top;
    PathLoad load;
    add_part(load, wedge.area, corners.data(), count, corner);
    add_push(load, water_on(corner, top), corner, column_up_, right_of(column_up_), corner);
    SlideHeadWedge<>& loads = wedge.loads;
    loads.weight = wedge.area * unit_weight_;
    loads.joint_dip = path.risers->dip;
    loads.joint_length = (wedge.outcrop - corner).norm();
    const SurfaceStrength strength(path);
    loads.friction_angle = path.rock_bridges ? std::atan(strength.riser_friction) : path.risers->friction_angle;
    loads.cohesion = strength.riser_cohesion;
    loads.water_force = water_on(corner, wedge.outcrop).force;
    loads.force_x = load.force.x();
    loads.force_y = load.force.y();
    const double into_joint = cross(riser_along_, load.force);
    loads.reaction_position =
        into_joint < 0 ? std::clamp(load.moment / into_joint, 0.0, loads.joint_length) : loads.joint_length / 2;
    loads.face_length = depth;
    loads.face_base = 0;
    return wedge;
}

void PathLattice::set_columns(const SteppedPath& path) {
    if (path.search.mechanism == SteppedPathMechanism::slide_head_toppling) {
        set_riser_outcrops();
    }
    for (std::size_t joint = 1;; ++joint) {
        const SectionLine line = column_line(joint);
        // The ray starts far below, where the line is in the rock.
        const Point foot = line.offset * line.normal;
        const Point deep = foot - (crest.y() + crest.x() + foot.norm()) * 4 * column_up_;
        const Point outcrop = exit(deep, column_up_);
        if (!(retreat(outcrop) <= greatest_retreat)) {
            break;
        }
        column_outcrop.push_back(outcrop);
        std::vector<PathCell>& column = cells.emplace_back(levels);
        for (std::size_t level = 0; level < levels; ++level) {
            column[level] = make_cell(joint, level);
        }
        std::vector<PathWedge>& behind = wedges.emplace_back();
        for (std::size_t riser = 0; riser < riser_outcrop.size(); ++riser) {
            if (is_far_enough(riser_outcrop[riser])) {
                if (auto made = make_wedge(path, joint, riser)) {
                    behind.push_back(*made);
                }
            }
        }
    }
}

}  // namespace delabole
