// Shapes of the columns that joints and a stepped base cut out of a slope.
//
// Turned axes: u up-dip along the bases, v normal to them, through the toe of the slope. The toe corners of the bases
// lie on the line v = u tan(base inclination - base dip), one spacing apart.
//
// `continuous`: tops are the ground itself. If the base continues to the ground, joints are counted from the toe, and a
// new column begins with zero area where base line and ground meet. If the end of the base is given, joints are counted
// from there, because the last one passes through it: the first column, at the toe, has the remaining width, and a new
// one begins there with zero area. So every shape and every contact height is a continuous function of height, dips,
// spacing and base end; only the number of columns jumps. (A narrow last column instead would move the thrust of a
// slide head from its own height to the top of a joint.) One exception remains: if the ground behind the crest is
// steeper than the bases, the last column may lose contact (ground below the corner of its base) while it has area; it
// stands by itself there, unless water or an earthquake moves it, and is left out.
//
// `classical` (Goodman & Bray 1976, eqs. 1-6): heights y_n = n (a1 - b) up to the crest column, then falling by a2 + b;
// a1 = spacing tan(face - base dip), a2 = spacing tan(base dip - upper surface dip), b = step. Base n lies at v = n b,
// so that tops of columns meet the face at their upper corners. The crest column is the whole number nearest to
// u of the crest / spacing: at half-way values it jumps (see classical_jump).
#pragma once

#include "geometry/polygon.hpp"
#include "limit_equilibrium/columns/column_check.hpp"
#include "limit_equilibrium/columns/column_parameters.hpp"
#include "plane_failure/wedge.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

namespace delabole {

constexpr std::size_t most_columns = 1'000'000;

template <class T = double>
struct ColumnShape {
    T base_u;
    T base_v;
    T width;
    T lower_contact;
    T upper_contact;
    T upper_edge;  // height of the upper joint above the base, 0 where the ground cuts the base
    bool has_upper_joint;
    std::vector<PlanePoint<T>> top;  // in turned axes, from the lower joint to the upper one
    std::optional<T> unit_weight;

    Polygon<T> outline() const {
        Polygon<T> polygon{PlanePoint<T>(base_u, base_v), PlanePoint<T>(T(base_u + width), base_v)};
        polygon.insert(polygon.end(), top.rbegin(), top.rend());
        return polygon;
    }
};

template <class T = double>
struct ColumnShapes {
    ColumnCheck check = ColumnCheck::no_columns;
    SineCosine<T> base{};
    std::vector<ColumnShape<T>> columns{};
    std::optional<PlanePoint<T>> base_end{};  // turned axes; the given end or the last corner
};

namespace detail {

template <class T>
PlanePoint<T> turned(const SineCosine<T>& base, const T& x, const T& y) {
    return {T(x * base.cosine + y * base.sine), T(y * base.cosine - x * base.sine)};
}

template <class T>
PlanePoint<T> turned_back(const SineCosine<T>& base, const PlanePoint<T>& point) {
    return {T(point.x() * base.cosine - point.y() * base.sine), T(point.x() * base.sine + point.y() * base.cosine)};
}

template <class T>
T cross(const PlanePoint<T>& a, const PlanePoint<T>& b) {
    return T(a.x() * b.y() - a.y() * b.x());
}

template <class T>
PlanePoint<T> difference(const PlanePoint<T>& a, const PlanePoint<T>& b) {
    return {T(a.x() - b.x()), T(a.y() - b.y())};
}

// The ground in turned axes: corners from the toe, then a line without end.
template <class T>
struct TurnedGround {
    std::vector<PlanePoint<T>> corners;
    PlanePoint<T> beyond;  // direction after the last corner
    std::size_t crest;     // index of the corner at the crest

    // Whether every joint meets the ground once.
    bool crosses_every_joint() const {
        for (std::size_t index = 1; index < corners.size(); ++index) {
            if (corners[index].x() < corners[index - 1].x()) {
                return false;
            }
        }
        return beyond.x() > 0;
    }
};

template <class T>
TurnedGround<T> turned_ground(const SlopeSection<T>& slope, const SineCosine<T>& base) {
    const SineCosine<T> face = sine_cosine(slope.face_dip);
    const SineCosine<T> upper = sine_cosine(slope.upper_surface_dip);
    PlanePoint<T> corner(T(slope.height * face.cosine / face.sine), slope.height);
    TurnedGround<T> ground{
        {PlanePoint<T>(T(0), T(0)), turned(base, corner.x(), corner.y())}, turned(base, upper.cosine, upper.sine), 1};
    if (slope.bench) {
        const SineCosine<T> bench = sine_cosine(slope.bench->dip);
        corner = {T(corner.x() + slope.bench->width), T(corner.y() + slope.bench->width * bench.sine / bench.cosine)};
        ground.corners.push_back(turned(base, corner.x(), corner.y()));
    }
    return ground;
}

// Follows the ground in the direction of growing u; linear cost over a whole slope.
template <class T>
class GroundWalk {
  public:
    explicit GroundWalk(const TurnedGround<T>& ground) : ground_(ground), here_(ground.corners.front()) {}

    const PlanePoint<T>& here() const { return here_; }

    // Advances to u, and appends every corner passed and the point reached.
    void advance(const T& u, std::vector<PlanePoint<T>>& passed) {
        while (next_ < ground_.corners.size() && ground_.corners[next_].x() <= u) {
            here_ = ground_.corners[next_++];
            passed.push_back(here_);
        }
        if (here_.x() < u) {
            here_ = at(u);
            passed.push_back(here_);
        }
    }

    // Advances to where the ground meets the ray from `origin` along `direction`, from its left to its right.
    bool advance_to_ray(const PlanePoint<T>& origin, const PlanePoint<T>& direction,
                        std::vector<PlanePoint<T>>& passed) {
        for (; next_ < ground_.corners.size(); ++next_) {
            const T start = cross(direction, difference(here_, origin));
            const T end = cross(direction, difference(ground_.corners[next_], origin));
            if (end < 0) {
                const T position = start / (start - end);
                here_ = {T(here_.x() + position * (ground_.corners[next_].x() - here_.x())),
                         T(here_.y() + position * (ground_.corners[next_].y() - here_.y()))};
                passed.push_back(here_);
                return true;
            }
            here_ = ground_.corners[next_];
            passed.push_back(here_);
        }
        const T closing = cross(direction, ground_.beyond);
        if (!(closing < 0)) {
            return false;
        }
        const T distance = -cross(direction, difference(here_, origin)) / closing;
        here_ = {T(here_.x() + distance * ground_.beyond.x()), T(here_.y() + distance * ground_.beyond.y())};
        passed.push_back(here_);
        return true;
    }

  private:
    PlanePoint<T> at(const T& u) const {
        if (next_ < ground_.corners.size()) {
            const PlanePoint<T>& start = ground_.corners[next_ - 1];
            const PlanePoint<T>& end = ground_.corners[next_];
            return {u, T(start.y() + (u - start.x()) * ((end.y() - start.y()) / (end.x() - start.x())))};
        }
        const PlanePoint<T>& start = ground_.corners.back();
        return {u, T(start.y() + (u - start.x()) * (ground_.beyond.y() / ground_.beyond.x()))};
    }

    const TurnedGround<T>& ground_;
    PlanePoint<T> here_;
    std::size_t next_ = 1;
};

// The common part of both layouts cut from a slope.
template <class T>
struct BaseLine {
    TurnedGround<T> ground;
    T rise;  // of the line through the toe corners, v per u
    std::optional<PlanePoint<T>> end;
};

template <class T, class Layout>
ColumnCheck set_base_line(const SlopeSection<T>& slope, const Layout& layout, ColumnShapes<T>& shapes,
                          BaseLine<T>& line) {
    if (!(layout.base_inclination < slope.face_dip)) {
        return ColumnCheck::base_does_not_daylight;
    }
    const SineCosine<T> base_line = sine_cosine(layout.base_inclination);
    const PlanePoint<T> direction = turned(shapes.base, base_line.cosine, base_line.sine);
    // cos(joint dip) = sin(base dip), which may differ from the inclination by rounding alone.
    if (direction.y() < -1e-12) {
        return ColumnCheck::base_flatter_than_joints_allow;
    }
    line.rise = direction.y() > 0 ? T(direction.y() / direction.x()) : T(0);
    line.ground = turned_ground(slope, shapes.base);
    if (!line.ground.crosses_every_joint()) {
        return ColumnCheck::joints_never_surface;
    }
    GroundWalk<T> walk(line.ground);
    std::vector<PlanePoint<T>> passed;
    walk.advance(line.ground.corners[1].x(), passed);
    const bool surfaces = walk.advance_to_ray(line.ground.corners[0], PlanePoint<T>(T(1), line.rise), passed);
    T end_u = walk.here().x();
    if (layout.base_end_height) {
        const T end_distance = *layout.base_end_height / base_line.sine;
        end_u = end_distance * direction.x();
        if (surfaces && end_u > walk.here().x()) {
            return ColumnCheck::base_end_outside_slope;
        }
        line.end = PlanePoint<T>(end_u, T(end_u * line.rise));
    } else if (!surfaces) {
        return ColumnCheck::base_never_surfaces;
    }
    return end_u > layout.spacing * static_cast<double>(most_columns) ? ColumnCheck::too_many_columns
                                                                      : ColumnCheck::valid;
}

// Shortens a column where the ground cuts its base; returns false if the ground is below the base from the start.
template <class T>
bool cut_by_ground(ColumnShape<T>& shape) {
    const std::vector<PlanePoint<T>>& top = shape.top;
    if (top.empty() || top.front().y() < shape.base_v) {
        return false;
    }
    for (std::size_t index = 1; index < top.size(); ++index) {
        const T below = shape.base_v - top[index].y();
        if (below > 0) {
            const T above = top[index - 1].y() - shape.base_v;
            const T u = top[index - 1].x() + (top[index].x() - top[index - 1].x()) * (above / (above + below));
            shape.top.resize(index + 1);
            shape.top[index] = {u, shape.base_v};
            shape.width = u - shape.base_u;
            shape.has_upper_joint = false;
            shape.upper_edge = T(0);
            return true;
        }
    }
    shape.upper_edge = top.back().y() - shape.base_v;
    return true;
}

template <class T>
ColumnCheck lay_out(const SlopeSection<T>& slope, const ContinuousColumns<T>& layout, ColumnShapes<T>& shapes) {
    BaseLine<T> line;
    const ColumnCheck check = set_base_line(slope, layout, shapes, line);
    if (check != ColumnCheck::valid) {
        return check;
    }
    GroundWalk<T> walk(line.ground);
    // Number of columns and width of the first one. A width below this part of the spacing is rounding.
    constexpr double narrowest = 1e-9;
    const double whole_count =
        line.end ? std::max(1.0, std::ceil(static_cast<double>(T(line.end->x() / layout.spacing)) - narrowest)) : 0;
    const T first_width = line.end ? T(line.end->x() - layout.spacing * T(whole_count - 1)) : layout.spacing;
    for (std::size_t index = 0;; ++index) {
        ColumnShape<T> shape{};
        shape.base_u = index > 0 ? T(first_width + layout.spacing * T(static_cast<double>(index - 1))) : T(0);
        shape.base_v = shape.base_u * line.rise;
        shape.width = index > 0 ? layout.spacing : first_width;
        shape.has_upper_joint = true;
        const bool last = line.end && static_cast<double>(index + 1) >= whole_count;
        shape.top = {walk.here()};
        walk.advance(T(shape.base_u + shape.width), shape.top);
        if (!(shape.width > 0) || !cut_by_ground(shape)) {
            break;
        }
        if (index > 0) {
            shape.lower_contact = shape.top.front().y() - shape.base_v;
            // Both columns end at the same ground, so that contact exists only above the upper base.
            shapes.columns.back().upper_contact = shapes.columns.back().upper_edge;
        }
        shapes.columns.push_back(std::move(shape));
        if (last || !shapes.columns.back().has_upper_joint || shapes.columns.size() > most_columns) {
            break;
        }
    }
    shapes.base_end = line.end;
    return ColumnCheck::valid;
}

// Contacts of rectangular columns: from the upper base to the lower of the two tops.
template <class T>
ColumnCheck set_block_contacts(std::vector<ColumnShape<T>>& columns) {
    for (std::size_t index = 0; index + 1 < columns.size(); ++index) {
        ColumnShape<T>& lower = columns[index];
        ColumnShape<T>& upper = columns[index + 1];
        const T step = upper.base_v - lower.base_v;
        if (step > lower.upper_edge) {
            return ColumnCheck::step_larger_than_block;
        }
        const T upper_top = step + upper.upper_edge;
        lower.upper_contact = lower.upper_edge < upper_top ? lower.upper_edge : upper_top;
        upper.lower_contact = lower.upper_contact - step;
    }
    return ColumnCheck::valid;
}

template <class T>
ColumnShape<T> rectangle(const T& base_u, const T& base_v, const T& width, const T& height) {
    ColumnShape<T> shape{};
    shape.base_u = base_u;
    shape.base_v = base_v;
    shape.width = width;
    shape.upper_edge = height;
    shape.has_upper_joint = true;
    shape.top = {PlanePoint<T>(base_u, T(base_v + height)), PlanePoint<T>(T(base_u + width), T(base_v + height))};
    return shape;
}

template <class T>
std::size_t nearest_whole(const T& value) {
    const double rounded = std::floor(static_cast<double>(value) + 0.5);
    return rounded < 1 ? 1 : static_cast<std::size_t>(rounded);
}

template <class T>
ColumnCheck lay_out(const SlopeSection<T>& slope, const ClassicalColumns<T>& layout, ColumnShapes<T>& shapes) {
    if (slope.bench) {
        return ColumnCheck::bench_needs_continuous;
    }
    BaseLine<T> line;
    const ColumnCheck check = set_base_line(slope, layout, shapes, line);
    if (check != ColumnCheck::valid) {
        return check;
    }
    const PlanePoint<T>& crest = line.ground.corners[1];
    const T rise = layout.spacing * line.rise;
    const T face_rise = layout.spacing * crest.y() / crest.x();
    const T upper_fall = -layout.spacing * line.ground.beyond.y() / line.ground.beyond.x();
    const std::size_t crest_column = nearest_whole(T(crest.x() / layout.spacing));
    const std::size_t last = line.end ? nearest_whole(T(line.end->x() / layout.spacing)) : most_columns + 1;
    for (std::size_t number = 1; number <= last; ++number) {
        const T count(static_cast<double>(number));
        const T to_crest(static_cast<double>(number < crest_column ? number : crest_column));
        const T beyond_crest = count - to_crest;
        const T height = to_crest * (face_rise - rise) - beyond_crest * (upper_fall + rise);
        if (!(height > 0)) {
            break;
        }
        shapes.columns.push_back(rectangle(T(layout.spacing * (count - 1)), T(rise * count), layout.spacing, height));
        if (shapes.columns.size() > most_columns) {
            return ColumnCheck::too_many_columns;
        }
    }
    if (line.end && !shapes.columns.empty()) {
        const ColumnShape<T>& end = shapes.columns.back();
        shapes.base_end = PlanePoint<T>(T(end.base_u + end.width), end.base_v);
    }
    return set_block_contacts(shapes.columns);
}

template <class T>
ColumnCheck lay_out(const BlockColumns<T>& layout, ColumnShapes<T>& shapes) {
    if (layout.block.size() > most_columns) {
        return ColumnCheck::too_many_columns;
    }
    T u(0);
    T v(0);
    for (const ColumnBlock<T>& block : layout.block) {
        shapes.columns.push_back(rectangle(u, v, block.width, block.height));
        shapes.columns.back().unit_weight = block.unit_weight;
        u += block.width;
        v += block.step_above;
    }
    return set_block_contacts(shapes.columns);
}

}  // namespace detail

// Shapes for any layout. The caller has to check the ranges of the fields.
template <class T>
ColumnShapes<T> make_shapes(const std::optional<SlopeSection<T>>& slope, const ColumnLayout<T>& layout) {
    ColumnShapes<T> shapes;
    const T joint_dip = std::visit([](const auto& kind) { return kind.joint_dip; }, layout);
    const SineCosine<T> joint = sine_cosine(joint_dip);
    shapes.base = {joint.cosine, joint.sine};
    if (const auto* blocks = std::get_if<BlockColumns<T>>(&layout)) {
        shapes.check = detail::lay_out(*blocks, shapes);
    } else if (!slope) {
        shapes.check = ColumnCheck::slope_needed;
    } else if (const auto* classical = std::get_if<ClassicalColumns<T>>(&layout)) {
        shapes.check = detail::lay_out(*slope, *classical, shapes);
    } else {
        shapes.check = detail::lay_out(*slope, std::get<ContinuousColumns<T>>(layout), shapes);
    }
    if (shapes.check == ColumnCheck::valid && shapes.columns.empty()) {
        shapes.check = ColumnCheck::no_columns;
    }
    return shapes;
}

// Slope heights between which the classical layout keeps its crest column; at either one the column nearest to the
// crest changes and all results jump. Used for the warning that goes with a classical layout.
struct ClassicalJump {
    double lower_height;
    double upper_height;
};

ClassicalJump classical_jump(const SlopeSection<>& slope, const ClassicalColumns<>& layout);

}  // namespace delabole
