#include "cases/program/models/stepped_base/drawing.hpp"

#include "limit_equilibrium/columns/base_profile.hpp"
#include "plots/drawing/polygon.hpp"
#include "plots/drawing/text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

namespace delabole {

namespace {

constexpr std::size_t most_named_columns = 200;
constexpr std::size_t most_rows = 60;

std::string in_cell(double value, Dimension dimension) {
    return std::isfinite(value) ? human_number(in_display_unit(value, dimension), 4) : "infinite";
}

std::string remark(const ColumnResult& column) {
    std::string text;
    if (column.mode != ColumnMode::topples && !column.reaction_inside_base) {
        text = "R outside the base: would turn";
    }
    if (!column.base_friction_holds) {
        text += text.empty() ? "" : "; ";
        text += "more than the base can bear";
    }
    return text;
}

}  // namespace

void append_column_outputs(Analysis& analysis, const std::vector<ColumnResult>& columns) {
    if (columns.size() > most_named_columns) {
        return;
    }
    for (const ColumnResult& column : columns) {
        append_outputs(analysis, column, "column[" + std::to_string(column.number) + "]", true);
    }
}

Table column_table(const std::string& caption, const std::vector<ColumnResult>& columns) {
    const auto force = [](double value) { return in_cell(value, Dimension::force_per_length); };
    const auto length = [](double value) { return in_cell(value, Dimension::length); };
    const auto ratio = [](double value) { return in_cell(value, Dimension::ratio); };
    std::size_t step = 1;
    for (const std::size_t factor : {2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000}) {
        step = columns.size() / step > most_rows ? factor : step;
    }
    const std::string unit = std::string(display_unit(Dimension::force_per_length).symbol);
    Table table{caption + (step > 1 ? " One column in " + std::to_string(step) + "; columns.csv has all." : ""),
                {{"column", true},
                 "mode",
                 {"height, m", true},
                 {"weight, " + unit, true},
                 {"P above, " + unit, true},
                 {"at, m", true},
                 {"P below, " + unit, true},
                 {"at, m", true},
                 {"R, " + unit, true},
                 {"S, " + unit, true},
                 {"S / R", true},
                 {"R at / width", true},
                 "remark"}};
    for (std::size_t index = 0; index < columns.size(); ++index) {
        const ColumnResult& column = columns[index];
        if (index > 0 && (index + 1) % step != 0) {
            continue;
        }
        table.rows.push_back({std::to_string(column.number), std::string(word_of(column.mode)), length(column.height),
                              force(column.weight), force(column.upper_force), length(column.upper_force_height),
                              force(column.lower_force), length(column.lower_force_height),
                              force(column.normal_reaction), force(column.shear_reaction), ratio(column.friction_ratio),
                              ratio(column.reaction_position), remark(column)});
    }
    return table;
}

std::string columns_csv(const std::vector<ColumnResult>& as_given, const std::vector<ColumnResult>& limiting) {
    std::vector<std::string> titles{"strength", "column", "mode"};
    append_titles<ColumnResult>(titles);
    titles.emplace_back("reaction_inside_base");
    titles.emplace_back("base_friction_holds");
    CsvTable csv(titles);
    const auto add = [&](const std::string& strength, const std::vector<ColumnResult>& columns) {
        for (const ColumnResult& column : columns) {
            std::vector<Cell> row{strength, static_cast<double>(column.number), std::string(word_of(column.mode))};
            append_cells(row, column);
            for (Cell& cell : row) {
                constexpr double rounding = 1e-11;  // of a position on the base: a share of its width
                auto* number = std::get_if<double>(&cell);
                if (number != nullptr && std::abs(*number) < rounding) {
                    *number = 0;
                }
            }
            row.emplace_back(column.reaction_inside_base ? "yes" : "no");
            row.emplace_back(column.base_friction_holds ? "yes" : "no");
            csv.add_row(row);
        }
    };
    add("as_given", as_given);
    add("limiting", limiting);
    return csv.text();
}

namespace {

constexpr std::size_t most_arrows = 30;

// Directions of the columns' own axes in the section.
struct Axes {
    Point along;  // u
    Point up;     // v

    explicit Axes(double base_dip)
        : along(std::cos(base_dip), std::sin(base_dip)), up(-std::sin(base_dip), std::cos(base_dip)) {}
    Point at(double u, double v) const { return u * along + v * up; }
    Point at(const Column<>& column, double u, double v) const { return at(column.base_u + u, column.base_v + v); }
};

// The ground from in front of the toe to a distance behind the crest.
Polyline ground_line(const SlopeSection<>& slope, double end) {
    Polyline ground{Point(-slope.height / 4, 0), Point(0, 0),
                    Point(slope.height / std::tan(slope.face_dip), slope.height)};
    if (slope.bench) {
        ground.push_back(ground.back() + slope.bench->width * Point(1, std::tan(slope.bench->dip)));
    }
    const double rest = std::max(end - ground.back().x(), slope.height / 20);
    ground.push_back(ground.back() + rest * Point(1, std::tan(slope.upper_surface_dip)));
    return ground;
}

double height_of(const Polyline& line, double x) {
    for (std::size_t index = 1; index < line.size(); ++index) {
        const Point& from = line[index - 1];
        const Point& to = line[index];
        if (x <= to.x() && to.x() > from.x()) {
            return from.y() + (to.y() - from.y()) * (x - from.x()) / (to.x() - from.x());
        }
    }
    return line.back().y();
}

double height_of(const WaterLevel<>& level, const std::optional<SlopeSection<>>& slope) {
    if (const auto* depth = std::get_if<WaterDepth<>>(&level)) {
        return depth->water_depth;
    }
    if (const auto* ratio = std::get_if<FilledRatio<>>(&level)) {
        return ratio->filled_ratio * slope.value().height;
    }
    return std::get<WaterElevation<>>(level).water_elevation - slope.value().toe_elevation.value_or(0);
}

// The part of a free surface below the ground; all of it if there is no ground.
Polyline below_ground(const Polyline& surface, const Polyline& ground, double end) {
    if (ground.empty()) {
        return surface;
    }
    constexpr int points = 200;
    Polyline line;
    for (int index = 0; index <= points; ++index) {
        const double x = end * index / points;
        const double y = height_of(surface, x);
        if (y <= height_of(ground, x) + 1e-9 * end) {
            line.emplace_back(x, y);
        }
    }
    return line;
}

Polyline water_line(const SteppedBase<>& problem, const ColumnSlope<>& slope, const Polyline& ground, double end) {
    const ColumnWater<>& water = problem.scene.water;
    if (const auto* table = std::get_if<WaterTable<>>(&water)) {
        const double height = height_of(table->level, problem.scene.slope);
        return below_ground({Point(0, height), Point(end, height)}, ground, end);
    }
    if (const auto* line = std::get_if<PiezometricLineWater<>>(&water)) {
        Polyline surface;
        for (const PiezometricPoint<>& point : line->point) {
            surface.emplace_back(point.x, point.y);
        }
        surface.insert(surface.begin(), Point(std::min(0.0, surface.front().x() - end), surface.front().y()));
        return below_ground(surface, ground, end);
    }
    if (const auto* drawn = std::get_if<DrawnDownWater<>>(&water)) {
        const Axes axes(slope.base_dip);
        const Column<>& last = slope.columns.back();
        const double upper_end = axes.at(last.base_u + last.width, slope.end_v.value_or(last.base_v)).x();
        const double level = height_of(drawn->level, problem.scene.slope);
        return below_ground({Point(0, 0), Point(upper_end, level), Point(std::max(end, upper_end), level)}, ground,
                            end);
    }
    Polyline tops;
    if (const auto* filled = std::get_if<FilledJointsWater<>>(&water)) {
        const Axes axes(slope.base_dip);
        for (const Column<>& column : slope.columns) {
            if (column.upper_contact > 0 && filled->filled_ratio > 0) {
                tops.push_back(axes.at(column, column.width, filled->filled_ratio * column.upper_contact));
            }
        }
    }
    return tops;
}

// The point at which the line of a cable enters its column. The joint on whose side the head is given may end below
// that height, as it does at a toe column.
Point entry_into(const Polyline& outline, const Point& head, const Point& direction) {
    const double clear_of_the_edge = 1e-6 * (outline[0] - outline[1]).norm();
    if (inside(outline, head + clear_of_the_edge * direction)) {
        return head;
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t index = 0; index < outline.size(); ++index) {
        const Point edge = outline[(index + 1) % outline.size()] - outline[index];
        const Point reach = outline[index] - head;
        const double place = cross(reach, direction) / cross(direction, edge);
        const double distance = cross(reach, edge) / cross(direction, edge);
        if (place >= 0 && place <= 1 && distance > 0) {
            nearest = std::min(nearest, distance);
        }
    }
    return std::isfinite(nearest) ? Point(head + nearest * direction) : head;
}

template <class Cable>
DrawnForce drawn_cable(const ColumnScene<>& scene, const ColumnSlope<>& slope, const Cable& cable, double force,
                       ForceKind kind) {
    const auto index = static_cast<std::size_t>(cable.block) - 1;
    const Point direction(std::cos(cable.plunge), -std::sin(cable.plunge));
    const Point head = Axes(slope.base_dip).at(slope.columns[index], 0, cable.height);
    return {entry_into(column_outlines(scene)[index], head, direction), force * direction, kind};
}

void add_forces(BlockDrawing& drawing, const SteppedBase<>& problem, const ColumnSlope<>& slope,
                const std::vector<ColumnResult>& columns, double factor) {
    const Axes axes(slope.base_dip);
    const double friction = std::tan(problem.joints.friction_angle) / factor;
    const std::size_t step = 1 + columns.size() / (most_arrows + 1);
    for (std::size_t index = 0; index < columns.size(); index += step) {
        const ColumnResult& result = columns[index];
        const Column<>& column = slope.columns[index];
        const bool last = index + 1 == columns.size();
        if (result.upper_force > 0 && !last) {
            drawing.forces.push_back({axes.at(column, column.width, result.upper_force_height),
                                      -result.upper_force * (axes.along + friction * axes.up), ForceKind::interblock});
        }
        if (std::isfinite(result.reaction_position)) {
            const double position = std::clamp(result.reaction_position, 0.0, 1.0);
            drawing.forces.push_back({axes.at(column, position * column.width, 0),
                                      result.normal_reaction * axes.up + result.shear_reaction * axes.along,
                                      ForceKind::base_reaction});
        }
    }
    const JointForce<> head = head_force(slope, strength_of(problem), factor);
    drawing.forces.push_back({axes.at(slope.columns.back(), slope.columns.back().width, head.height),
                              -head.normal * axes.along - head.shear * axes.up, ForceKind::thrust});
    for (const PointLoad<>& load : problem.scene.point_load) {
        const Column<>& column = slope.columns[static_cast<std::size_t>(load.block) - 1];
        drawing.forces.push_back({axes.at(column, 0.5 * column.width, load.height),
                                  load.force * Point(std::cos(load.plunge), -std::sin(load.plunge)),
                                  ForceKind::applied});
    }
    for (const ColumnBolt<>& bolt : problem.scene.bolt) {
        drawing.forces.push_back(drawn_cable(problem.scene, slope, bolt, bolt.force, ForceKind::applied));
    }
    const std::vector<std::vector<BoltRow>> support = support_rows(problem.scene);
    for (std::size_t index = 0; index < support.size(); ++index) {
        const double plunge = problem.scene.support[index].plunge;
        for (const BoltRow& row : support[index]) {
            drawing.forces.push_back(
                {row.head, row.force * Point(std::cos(plunge), -std::sin(plunge)), ForceKind::applied});
        }
    }
}

}  // namespace

DrawnMode drawn(ColumnMode mode) {
    return mode == ColumnMode::slides    ? DrawnMode::slides
           : mode == ColumnMode::topples ? DrawnMode::topples
                                         : DrawnMode::stays;
}

BlockDrawing column_drawing(const SteppedBase<>& problem, const ColumnSlope<>& slope,
                            const std::vector<ColumnResult>& columns, double factor, const std::string& title) {
    BlockDrawing drawing{.title = title};
    const Axes axes(slope.base_dip);
    double end = 0;
    const std::vector<Polyline> outlines = column_outlines(problem.scene);
    for (std::size_t index = 0; index < outlines.size(); ++index) {
        for (const Point& point : outlines[index]) {
            end = std::max(end, point.x());
        }
        const bool wedge = index >= columns.size();
        drawing.blocks.push_back({outlines[index], wedge ? "wedge" : std::to_string(index + 1),
                                  wedge ? DrawnMode::plain : drawn(columns[index].mode)});
    }
    end *= 1.1;
    drawing.base = {axes.at(0, 0) - Point(end / 8, 0)};
    for (const Column<>& column : slope.columns) {
        drawing.base.push_back(axes.at(column, 0, 0));
        drawing.base.push_back(axes.at(column, column.width, 0));
    }
    if (problem.scene.slope) {
        drawing.ground = ground_line(*problem.scene.slope, end);
        drawing.base.front() = drawing.ground.front();
        drawing.toe_elevation = problem.scene.slope->toe_elevation.value_or(0.0);
    }
    // Behind the columns the rock ends at the wedge's joint, or at the joint of the last column, which is extended up
    // to the ground.
    const Polyline& rear = outlines.back();
    if (drawing.ground.empty()) {
        drawing.base.emplace_back(drawing.base.back() + Point(end / 8, 0));
    } else {
        if (outlines.size() > columns.size()) {
            drawing.base.push_back(rear[0]);
            drawing.base.push_back(rear[1]);
        } else {
            drawing.base.push_back(rear[rear.size() > 3 ? 2 : 1]);
        }
        drawing.base.push_back(drawing.ground.back());
    }
    drawing.water = water_line(problem, slope, drawing.ground, end);
    add_forces(drawing, problem, slope, columns, factor);
    return drawing;
}

DrawnForce required_force(const ColumnScene<>& scene, const ColumnSlope<>& slope, const RequiredCable<>& cable,
                          double force) {
    return drawn_cable(scene, slope, cable, force, ForceKind::required);
}

ForceAlongSlope force_along_columns(const std::vector<ColumnResult>& columns, const std::string& title) {
    ForceAlongSlope data;
    data.title = title;
    for (const ColumnResult& column : columns) {
        data.block.push_back(column.number);
        data.toppling.push_back(column.against_toppling);
        data.sliding.push_back(column.against_sliding);
        data.acting.push_back(column.lower_force);
        data.modes.push_back(drawn(column.mode));
    }
    return data;
}

void add_profiles(Figure& figure, const Polyline& observed, const Polyline& predicted, double toe_elevation) {
    add_line(figure, {.points = raised(predicted, toe_elevation),
                      .legend = "predicted after the failure",
                      .colour = Colour::green,
                      .width = 6});
    const Polyline seen = raised(observed, toe_elevation);
    add_line(figure, {.points = seen, .dash = Dash::dotted});
    if (!seen.empty()) {
        figure.series.emplace_back(
            Points{.points = seen, .legend = "observed after the failure", .marker = Marker::circle});
    }
}

}  // namespace delabole
