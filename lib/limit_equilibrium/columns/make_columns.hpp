// Columns, ready for the recursion, from a described slope.
//
// Loads on the ground behind the crest count if they stand on a column (or on the wedge above the columns), and once.
// Behind the crest the flat tops of classical columns lie apart in plan where the ground is flatter than the bases, and
// overlap where it is steeper. Of the two columns beside such a place the upper one carries what stands there: the
// ground, which meets the upper corners of the tops, lies over it, and it is on the safe side, because the load leans
// further out of its base.
#pragma once

#include "limit_equilibrium/columns/slide_head.hpp"
#include "plane_failure/bolts_in_ground.hpp"
#include "support/bolt_pattern.hpp"

#include <cmath>

namespace delabole {

template <class T = double>
struct ColumnScene {
    std::optional<SlopeSection<T>> slope;
    ColumnLayout<T> columns;
    Rock<T> rock;
    ColumnWater<T> water;
    std::optional<SeismicLoad<T>> seismic;
    std::vector<Surcharge<T>> surcharge;
    std::vector<LineLoad<T>> line_load;
    std::vector<PointLoad<T>> point_load;
    std::vector<ColumnBolt<T>> bolt;
    std::vector<BoltPattern<T>> support;
    std::optional<SlideHead<T>> slide_head;

    static constexpr auto fields() {
        return FieldTable{
            section<&ColumnScene::slope>("the ground surface; absent where blocks are given one by one"),
            section<&ColumnScene::columns>("joints and stepped base"),
            section<&ColumnScene::rock>("the rock mass"),
            section<&ColumnScene::water>("water in the joints and under the bases"),
            section<&ColumnScene::seismic>("pseudo-static earthquake load; absent: none"),
            section<&ColumnScene::surcharge>("strip loads behind the crest"),
            section<&ColumnScene::line_load>("line loads behind the crest"),
            section<&ColumnScene::point_load>("loads on single columns"),
            section<&ColumnScene::bolt>("bolts and cables in single columns"),
            section<&ColumnScene::support>("patterns of tensioned bolts: rows, spacing, length, capacity"),
            section<&ColumnScene::slide_head>("wedge sliding against the last column; absent: none")};
    }
};

namespace detail {

template <class T>
void set_loaded(Column<T>& column, const TurnedResultant<T>& resultant) {
    column.down_dip_force = -resultant.u;
    column.normal_force = -resultant.v;
    column.overturning_moment = resultant.moment;
}

// Adds point loads and bolts; they may name a column that does not exist.
template <class T, class Load>
ColumnCheck add_to_column(const std::vector<Load>& loads, const SineCosine<T>& base, bool on_toe_side,
                          const std::vector<ColumnShape<T>>& shapes, std::vector<TurnedResultant<T>>& resultants) {
    for (const Load& load : loads) {
        const auto number = static_cast<double>(load.block);
        if (number > static_cast<double>(shapes.size()) || number != std::floor(number)) {
            return ColumnCheck::load_outside_columns;
        }
        const std::size_t index = static_cast<std::size_t>(number) - 1;
        const ColumnShape<T>& shape = shapes[index];
        T highest = shape.base_v;
        for (const PlanePoint<T>& point : shape.top) {
            highest = point.y() > highest ? point.y() : highest;
        }
        // The given load on top of a column may deviate by rounding of its height.
        if (load.height > (highest - shape.base_v) * (1 + 1e-9)) {
            return ColumnCheck::load_outside_columns;
        }
        const SineCosine<T> plunge = sine_cosine(load.plunge);
        resultants[index].add_turned(base, on_toe_side ? T(0) : T(shape.width / 2), load.height,
                                     T(load.force * plunge.cosine), T(-load.force * plunge.sine));
    }
    return ColumnCheck::valid;
}

// A row of a bolt pattern: position of its heads, in turned axes, their column, and the length that holds them.
template <class T>
struct ColumnBoltRow {
    PlanePoint<T> head;
    std::size_t column;
    T length_in_columns;  // from the head to the base; negative if the bolt does not meet it
    T force;
};

// Returns nothing if the face has no column at that height.
template <class T>
std::optional<ColumnBoltRow<T>> bolt_row(const BoltPattern<T>& pattern, int row, const SlopeSection<T>& slope,
                                         const ColumnShapes<T>& shapes) {
    const T height = pattern.head_height(row);
    const SineCosine<T> face = sine_cosine(slope.face_dip);
    ColumnBoltRow<T> found{turned(shapes.base, T(height * face.cosine / face.sine), height), 0, T(-1), T(0)};
    const auto& columns = shapes.columns;
    while (found.column < columns.size() &&
           !(found.head.x() < columns[found.column].base_u + columns[found.column].width)) {
        ++found.column;
    }
    if (height > slope.height || found.column == columns.size() || found.head.x() < columns[found.column].base_u) {
        return std::nullopt;
    }
    const SineCosine<T> plunge = sine_cosine(pattern.plunge);
    const PlanePoint<T> along = turned(shapes.base, plunge.cosine, T(-plunge.sine));
    // A bolt steeper than the joints extends down to the base of its own column only.
    const std::size_t end = along.x() > 0 ? columns.size() : found.column + 1;
    for (std::size_t index = found.column; index < end; ++index) {
        const ColumnShape<T>& shape = columns[index];
        // The bolt passes through the riser of the base below this column, or reaches its base.
        if (index > found.column) {
            const T to_rise = (shape.base_u - found.head.x()) / along.x();
            if (found.head.y() + to_rise * along.y() <= shape.base_v) {
                found.length_in_columns = to_rise;
                break;
            }
        }
        const T to_base = along.y() < 0 ? T((shape.base_v - found.head.y()) / along.y()) : T(-1);
        const T base_at = found.head.x() + to_base * along.x();
        if (to_base >= 0 && base_at >= shape.base_u && base_at <= shape.base_u + shape.width) {
            found.length_in_columns = to_base;
            break;
        }
    }
    found.force = force_of_row(pattern, found.length_in_columns, length_in_ground(slope, height, pattern.plunge));
    return found;
}

// Adds bolts: each pulls at its head, on the column that stands there.
template <class T>
ColumnCheck add_support(const ColumnScene<T>& scene, const ColumnShapes<T>& shapes,
                        std::vector<TurnedResultant<T>>& resultants) {
    if (!scene.slope && !scene.support.empty()) {
        return ColumnCheck::load_needs_slope;
    }
    for (const BoltPattern<T>& pattern : scene.support) {
        for (int row = 0; T(row) < pattern.rows; ++row) {
            const std::optional<ColumnBoltRow<T>> bolts = bolt_row(pattern, row, *scene.slope, shapes);
            if (!bolts) {
                return ColumnCheck::load_outside_columns;
            }
            const ColumnShape<T>& shape = shapes.columns[bolts->column];
            const SineCosine<T> plunge = sine_cosine(pattern.plunge);
            resultants[bolts->column].add_turned(shapes.base, T(bolts->head.x() - shape.base_u),
                                                 T(bolts->head.y() - shape.base_v), T(bolts->force * plunge.cosine),
                                                 T(-bolts->force * plunge.sine));
        }
    }
    return ColumnCheck::valid;
}

template <class T>
T height_at(const ColumnShape<T>& shape, const T& u) {
    for (std::size_t index = 1; index < shape.top.size(); ++index) {
        const PlanePoint<T>& a = shape.top[index - 1];
        const PlanePoint<T>& b = shape.top[index];
        if (u <= b.x() && b.x() > a.x()) {
            return T(a.y() + (b.y() - a.y()) * ((u - a.x()) / (b.x() - a.x())) - shape.base_v);
        }
    }
    return T(0);
}

// Adds the loads on the ground: each column carries them from where the top below ends, or its own begins.
template <class T>
void add_loads_on_tops(const ColumnScene<T>& scene, const ColumnShapes<T>& shapes, const T& crest,
                       std::vector<TurnedResultant<T>>& resultants) {
    if (scene.surcharge.empty() && scene.line_load.empty()) {
        return;
    }
    std::vector<PlanePoint<T>> wedge_start;
    if (scene.slide_head && shapes.base_end) {
        const TurnedGround<T> ground = turned_ground(*scene.slope, shapes.base);
        GroundWalk<T> walk(ground);
        std::vector<PlanePoint<T>> passed;
        walk.advance(shapes.base_end->x(), passed);
        wedge_start = {walk.here()};
    }
    const auto in_plan = [&](const PlanePoint<T>& point) { return position_in_plan(shapes.base, point, crest); };
    T end_x = in_plan(wedge_start.empty() ? shapes.columns.back().top.back() : wedge_start.front());
    for (std::size_t index = shapes.columns.size(); index-- > 0;) {
        const ColumnShape<T>& shape = shapes.columns[index];
        const PlanePoint<T>& start = index > 0 ? shapes.columns[index - 1].top.back() : shape.top.front();
        std::vector<PlanePoint<T>> ground{start};
        ground.insert(ground.end(), shape.top.begin(), shape.top.end());
        if (index + 1 == shapes.columns.size()) {
            ground.insert(ground.end(), wedge_start.begin(), wedge_start.end());
        }
        add_ground_loads(resultants[index], ground, end_x, PlanePoint<T>(shape.base_u, shape.base_v), shapes.base,
                         crest, scene.surcharge, scene.line_load);
        for (const T& begin_x : {in_plan(start), in_plan(shape.top.front())}) {
            end_x = begin_x < end_x ? begin_x : end_x;
        }
    }
}

// Upper end of the base in section axes.
template <class T>
PlanePoint<T> end_of_base(const ColumnShapes<T>& shapes) {
    const ColumnShape<T>& last = shapes.columns.back();
    return turned_back(shapes.base,
                       shapes.base_end ? *shapes.base_end : PlanePoint<T>(T(last.base_u + last.width), last.base_v));
}

template <class T>
T crest_x(const std::optional<SlopeSection<T>>& slope) {
    if (!slope) {
        return T(0);
    }
    const SineCosine<T> face = sine_cosine(slope->face_dip);
    return T(slope->height * face.cosine / face.sine);
}

template <class T>
ColumnCheck set_slide_head(const ColumnScene<T>& scene, const ColumnShapes<T>& shapes, const WaterSurface<T>& water,
                           const T& crest, ColumnSlope<T>& slope) {
    if (!scene.slope || !shapes.base_end || !shapes.columns.back().has_upper_joint) {
        return ColumnCheck::slide_head_needs_base_end;
    }
    const ColumnShape<T>& last = shapes.columns.back();
    const PlanePoint<T>& end = *shapes.base_end;
    const T face_base = end.y() - last.base_v;
    const T wetted = water.height_in_joint(end.x(), last.base_v, last.upper_edge) - face_base;
    const HeadLoads<T> loads{scene.rock.unit_weight,     scene.seismic,   crest, scene.surcharge, scene.line_load,
                             wetted > 0 ? wetted : T(0), water.gradient()};
    SlideHeadWedge<T>& wedge = slope.slide_head.emplace();
    wedge.face_base = face_base;
    return make_wedge(*scene.slide_head, turned_ground(*scene.slope, shapes.base), shapes.base, end, loads, wedge);
}

}  // namespace detail

// `check` is `valid` if there are columns; otherwise the rest is unspecified. Linear in their number.
template <class T>
ColumnSlope<T> make_columns(const ColumnScene<T>& scene) {
    using std::atan2;
    ColumnSlope<T> slope;
    if (!in_range(scene)) {
        slope.check = ColumnCheck::input_out_of_range;
        return slope;
    }
    if (!scene.slope && !(scene.surcharge.empty() && scene.line_load.empty())) {
        slope.check = ColumnCheck::load_needs_slope;
        return slope;
    }
    const ColumnShapes<T> shapes = make_shapes(scene.slope, scene.columns);
    slope.check = shapes.check;
    if (slope.check != ColumnCheck::valid) {
        return slope;
    }
    detail::WaterSurface<T> water;
    slope.check = water.set(scene.water, scene.slope, shapes.base, detail::end_of_base(shapes));
    if (slope.check != ColumnCheck::valid) {
        return slope;
    }
    if (shapes.base_end) {
        slope.end_v = shapes.base_end->y();
    }
    slope.base_dip = atan2(shapes.base.sine, shapes.base.cosine);
    const T crest = detail::crest_x(scene.slope);
    const std::size_t count = shapes.columns.size();
    std::vector<detail::TurnedResultant<T>> resultants(count);
    slope.columns.resize(count);
    T water_top(0);  // v of the water in the joint below the column
    for (std::size_t index = 0; index < count; ++index) {
        const ColumnShape<T>& shape = shapes.columns[index];
        Column<T>& column = slope.columns[index];
        detail::TurnedResultant<T>& resultant = resultants[index];
        const PlanePoint<T> origin(shape.base_u, shape.base_v);
        column.width = shape.width;
        column.base_u = shape.base_u;
        column.base_v = shape.base_v;
        column.height = detail::height_at(shape, T(shape.base_u + shape.width / 2));
        column.lower_contact = shape.lower_contact;
        column.upper_contact = shape.upper_contact;
        column.joint_length = index + 1 < count ? shapes.columns[index + 1].lower_contact : T(0);
        column.weight = detail::add_weight(resultant, shape.outline(), origin, shapes.base,
                                           shape.unit_weight.value_or(scene.rock.unit_weight), scene.seismic);
        if (!water.dry()) {
            const T joint_height = index + 1 < count ? shape.upper_contact : shape.upper_edge;
            const T upper = water.height_in_joint(T(shape.base_u + shape.width), shape.base_v,
                                                  shape.has_upper_joint ? joint_height : T(0));
            const T lower = index > 0 && water_top > shape.base_v ? T(water_top - shape.base_v) : T(0);
            detail::add_column_water(resultant, water.gradient(), shape.width, lower, upper);
            water_top = shape.base_v + upper;
        }
    }
    detail::add_loads_on_tops(scene, shapes, crest, resultants);
    for (const ColumnCheck check :
         {detail::add_to_column(scene.point_load, shapes.base, false, shapes.columns, resultants),
          detail::add_to_column(scene.bolt, shapes.base, true, shapes.columns, resultants),
          detail::add_support(scene, shapes, resultants)}) {
        if (check != ColumnCheck::valid) {
            slope.check = check;
            return slope;
        }
    }
    for (std::size_t index = 0; index < count; ++index) {
        detail::set_loaded(slope.columns[index], resultants[index]);
    }
    if (scene.slide_head) {
        slope.check = detail::set_slide_head(scene, shapes, water, crest, slope);
    }
    return slope;
}

}  // namespace delabole
