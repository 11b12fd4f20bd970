#include "limit_equilibrium/columns/base_profile.hpp"

#include <algorithm>

namespace delabole {

namespace {

// The wedge's corners on the ground, from the columns' face to its joint, in turned axes.
std::optional<std::vector<PlanePoint<>>> wedge_top(const ColumnScene<>& scene, const ColumnShapes<>& shapes) {
    if (!scene.slide_head || !scene.slope || !shapes.base_end || !shapes.columns.back().has_upper_joint) {
        return std::nullopt;
    }
    const SineCosine<double> dip = sine_cosine(scene.slide_head->joint_dip);
    return detail::head_ground(detail::turned_ground(*scene.slope, shapes.base), *shapes.base_end,
                               detail::turned(shapes.base, dip.cosine, dip.sine));
}

// Adds the ground behind the profile's last point, to a third of the slope height beyond the ground's last corner.
void add_ground_behind(Polyline& profile, const SlopeSection<>& slope, const SineCosine<double>& base) {
    const detail::TurnedGround<double> ground = detail::turned_ground(slope, base);
    const double from = profile.back().x();
    double last_x = from;
    double last_y = profile.back().y();
    for (const PlanePoint<>& corner : ground.corners) {
        const Point point = detail::turned_back(base, corner);
        if (point.x() > from) {
            profile.push_back(point);
            last_x = point.x();
            last_y = point.y();
        }
    }
    const double further = slope.height / 3;
    profile.emplace_back(last_x + further, last_y + further * std::tan(slope.upper_surface_dip));
}

}  // namespace

Polyline ground_after_toppling(const ColumnScene<>& scene, std::size_t moving_columns, BaseOutline outline) {
    const ColumnShapes<> shapes = make_shapes(scene.slope, scene.columns);
    if (shapes.check != ColumnCheck::valid || moving_columns == 0) {
        return {};
    }
    const std::size_t count = std::min(moving_columns, shapes.columns.size());
    const auto section_point = [&](double u, double v) -> Point {
        return detail::turned_back(shapes.base, PlanePoint<>(u, v));
    };
    Polyline profile{section_point(0, 0)};
    const auto add = [&](const Point& point) {
        if (point != profile.back()) {
            profile.push_back(point);
        }
    };
    if (outline == BaseOutline::steps) {
        for (std::size_t index = 0; index < count; ++index) {
            const ColumnShape<>& shape = shapes.columns[index];
            add(section_point(shape.base_u, shape.base_v));
            add(section_point(shape.base_u + shape.width, shape.base_v));
        }
    }
    const ColumnShape<>& last = shapes.columns[count - 1];
    const auto head = count == shapes.columns.size() ? wedge_top(scene, shapes) : std::nullopt;
    if (head) {
        add(section_point(shapes.base_end->x(), shapes.base_end->y()));
        add(section_point(head->back().x(), head->back().y()));
    } else {
        const double base_end_v = outline == BaseOutline::envelope && count < shapes.columns.size()
                                      ? shapes.columns[count].base_v
                                      : last.base_v;
        add(section_point(last.base_u + last.width, base_end_v));
        add(section_point(last.top.back().x(), last.top.back().y()));
    }
    if (scene.slope) {
        add_ground_behind(profile, *scene.slope, shapes.base);
    }
    return profile;
}

std::vector<Point> joint_outcrops(const ColumnScene<>& scene) {
    const ColumnShapes<> shapes = make_shapes(scene.slope, scene.columns);
    if (shapes.check != ColumnCheck::valid || !scene.slope) {
        return {};
    }
    std::vector<Point> outcrops;
    for (const ColumnShape<>& shape : shapes.columns) {
        outcrops.push_back(detail::turned_back(shapes.base, shape.top.back()));
    }
    if (const auto head = wedge_top(scene, shapes)) {
        outcrops.push_back(detail::turned_back(shapes.base, head->back()));
    }
    return outcrops;
}

std::vector<std::vector<BoltRow>> support_rows(const ColumnScene<>& scene) {
    const ColumnShapes<> shapes = make_shapes(scene.slope, scene.columns);
    if (shapes.check != ColumnCheck::valid || !scene.slope) {
        return {};
    }
    std::vector<std::vector<BoltRow>> rows;
    for (const BoltPattern<>& pattern : scene.support) {
        rows.emplace_back();
        for (int row = 0; row < pattern.rows; ++row) {
            if (const auto found = detail::bolt_row(pattern, row, *scene.slope, shapes)) {
                rows.back().push_back({detail::turned_back(shapes.base, found->head), found->force});
            }
        }
    }
    return rows;
}

std::vector<Polyline> column_outlines(const ColumnScene<>& scene) {
    const ColumnShapes<> shapes = make_shapes(scene.slope, scene.columns);
    if (shapes.check != ColumnCheck::valid) {
        return {};
    }
    std::vector<Polyline> outlines;
    outlines.reserve(shapes.columns.size() + 1);
    const auto add = [&](const Polygon<>& polygon) {
        Polyline& closed = outlines.emplace_back();
        for (const PlanePoint<>& point : polygon) {
            closed.push_back(detail::turned_back(shapes.base, point));
        }
        closed.push_back(closed.front());
    };
    for (const ColumnShape<>& shape : shapes.columns) {
        add(shape.outline());
    }
    if (const auto head = wedge_top(scene, shapes)) {
        Polygon<> polygon{*shapes.base_end};
        polygon.insert(polygon.end(), head->rbegin(), head->rend());
        add(polygon);
    }
    return outlines;
}

}  // namespace delabole
