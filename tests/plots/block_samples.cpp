#include "samples.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace delabole::samples {

namespace {

Point turned(const Point& point, double angle) {
    return {point.x() * std::cos(angle) - point.y() * std::sin(angle),
            point.x() * std::sin(angle) + point.y() * std::cos(angle)};
}

Polyline rectangle(const Point& corner, double width, double height, double angle) {
    Polyline outline{{0, 0}, {width, 0}, {width, height}, {0, height}};
    for (Point& point : outline) {
        point = corner + turned(point, angle);
    }
    return outline;
}

// The blocks are those of Goodman & Bray's example, lengths in m, per metre run.
constexpr int block_count = 16;
constexpr double block_width = 10;
constexpr double step = 1;
constexpr double dip = degrees(30);
constexpr double friction = 0.7855;

double block_height(int block) {
    return block <= 10 ? 4.0 * block : 40.0 - 6.0 * (block - 10);
}

double weight(int block) {
    return 25e3 * block_width * block_height(block);
}

// Returns the height above the base at which the force from the block above acts on a block.
double height_of_upper_force(int block) {
    return block < 10 ? block_height(block) : block_height(block) - 5;
}

struct RowForces {
    std::vector<double> toppling;
    std::vector<double> sliding;
    std::vector<double> passed_on;  // to the block below
    std::vector<DrawnMode> modes;
};

RowForces goodman_bray() {
    RowForces result{std::vector<double>(block_count), std::vector<double>(block_count),
                     std::vector<double>(block_count), std::vector<DrawnMode>(block_count, DrawnMode::stays)};
    double from_above = 0;
    bool slides = false;
    for (int block = block_count; block >= 1; --block) {
        const auto index = static_cast<std::size_t>(block - 1);
        const double height = block_height(block);
        const double lower = block <= 10 ? height - 5 : height;
        const double topples = (from_above * (height_of_upper_force(block) - block_width * friction) +
                                0.5 * weight(block) * (height * std::sin(dip) - block_width * std::cos(dip))) /
                               lower;
        const double slips =
            from_above - weight(block) * (std::cos(dip) * friction - std::sin(dip)) / (1 - friction * friction);
        // The face of the lowest block is lower than the point at which the force from below would act.
        result.toppling[index] = lower > 0 ? topples : std::numeric_limits<double>::quiet_NaN();
        result.sliding[index] = slips;
        slides = slides || (from_above > 0 && !(lower > 0 && topples > slips));
        const double passed_on = std::max({lower > 0 ? topples : 0.0, slips, 0.0});
        result.passed_on[index] = passed_on;
        if (passed_on > 0 || from_above > 0) {
            result.modes[index] = slides ? DrawnMode::slides : DrawnMode::topples;
        }
        from_above = passed_on;
    }
    return result;
}

}  // namespace

ForceAlongSlope goodman_bray_forces() {
    const RowForces forces = goodman_bray();
    ForceAlongSlope data{.title = "Forces that each block passes on to the one below",
                         .toppling = forces.toppling,
                         .sliding = forces.sliding,
                         .acting = forces.passed_on,
                         .modes = forces.modes,
                         .printed_legend = "acting, printed by Goodman & Bray (1976)"};
    for (int block = 1; block <= block_count; ++block) {
        data.block.push_back(block);
    }
    double block = 13;
    for (const double kilonewtons :
         {292.5, 825.7, 1556.0, 2826.7, 3922.2, 4594.8, 4837.0, 4637.5, 3978.1, 2825.6, 1413.6, 472.2, 1.5}) {
        data.printed.emplace_back(block--, 1e3 * kilonewtons);
    }
    return data;
}

BlockDrawing goodman_bray_blocks() {
    const RowForces forces = goodman_bray();
    BlockDrawing drawing{.title = "Goodman & Bray's example: 16 blocks on a stepped base, friction angle 38.15 deg",
                         .base = {{-15, 0}, {0, 0}}};
    for (int block = 1; block <= block_count; ++block) {
        const auto index = static_cast<std::size_t>(block - 1);
        const Point corner = turned({block_width * (block - 1), step * (block - 1)}, dip);
        const Point along = turned({1, 0}, dip);
        const Point up = turned({0, 1}, dip);
        drawing.blocks.push_back({.outline = rectangle(corner, block_width, block_height(block), dip),
                                  .label = std::to_string(block),
                                  .mode = forces.modes[index]});
        drawing.base.push_back(corner);
        drawing.base.emplace_back(corner + block_width * along);
        const double from_above = block < block_count ? forces.passed_on[index + 1] : 0;
        const double taken = forces.passed_on[index] - from_above;
        if (from_above > 0) {
            drawing.forces.push_back({.at = corner + block_width * along + height_of_upper_force(block) * up,
                                      .force = from_above * (-along - friction * up),
                                      .kind = ForceKind::interblock});
        }
        drawing.forces.push_back(
            {.at = corner + (forces.modes[index] == DrawnMode::topples ? 0 : 0.4) * block_width * along,
             .force = (weight(block) * std::cos(dip) - friction * taken) * up +
                      (weight(block) * std::sin(dip) - taken) * along,
             .kind = ForceKind::base_reaction});
    }
    drawing.base.emplace_back(drawing.base.back() + Point(25, 1.75));
    return drawing;
}

BlockDrawing stepped_base() {
    constexpr double lean = degrees(15);
    constexpr double width = 7;
    constexpr double riser = 3;
    BlockDrawing drawing{.title = "Toppling on a stepped base, water behind the blocks",
                         .base = {{-15, 0}, {0, 0}},
                         .ground = {{-15, 0}, {0, 0}},
                         .toe_elevation = 107};
    for (int block = 0; block < 6; ++block) {
        const Point corner = turned({width * block, riser * block}, lean);
        const double height = block < 4 ? 14 + 5.0 * block : 39 - 4.5 * block;
        const DrawnMode mode = block == 0 ? DrawnMode::slides : block < 4 ? DrawnMode::topples : DrawnMode::stays;
        drawing.blocks.push_back(
            {.outline = rectangle(corner, width, height, lean), .label = std::to_string(block + 1), .mode = mode});
        Polyline& displaced = drawing.blocks.back().displaced;
        if (mode == DrawnMode::slides) {
            displaced = rectangle(corner - turned({3, 0}, lean), width, height, lean);
        } else if (mode == DrawnMode::topples) {
            displaced = rectangle(corner, width, height, lean + degrees(5));
        }
        drawing.base.push_back(corner);
        drawing.base.push_back(drawing.blocks.back().outline[1]);
        drawing.ground.push_back(drawing.blocks.back().outline[3]);
        drawing.ground.push_back(drawing.blocks.back().outline[2]);
    }
    const Point rear = drawing.ground.back();
    drawing.base.push_back(rear);
    drawing.base.emplace_back(65, rear.y() + 1);
    drawing.ground.emplace_back(65, rear.y() + 1);
    const Polyline& last = drawing.blocks[3].outline;
    const Point level = 0.5 * (last[1] + last[2]);
    drawing.tension_crack = {last[1], last[2]};
    drawing.water = {level, {65, level.y() + 3}};
    const Polyline& toe = drawing.blocks.front().outline;
    const Point push{9e5, -3e5};
    drawing.forces = {
        {.at = last[1] + (level - last[1]) / 3, .force = turned({-1.1e6, 0}, lean), .kind = ForceKind::thrust},
        {.at = 0.5 * (toe[0] + toe[3]) - 1e-5 * push, .force = push, .kind = ForceKind::applied}};
    return drawing;
}

BlockDrawing single_block() {
    constexpr double plane = degrees(20);
    const Polyline outline = rectangle({0, 0}, 1, 6, plane);
    return {.title = "Single block",
            .blocks = {{.outline = outline, .label = "1", .mode = DrawnMode::topples}},
            .base = {turned({-3, 0}, plane), turned({3, 0}, plane)},
            .forces = {{.at = outline[0], .force = {2e4, 1.5e5}, .kind = ForceKind::base_reaction}}};
}

BlockDrawing row_of_columns(int count) {
    BlockDrawing drawing{.title = "Row of columns"};
    for (int column = 0; column < count; ++column) {
        drawing.blocks.push_back({.outline = rectangle({1.0 * column, 0}, 1, 8 + 0.3 * column, degrees(10)),
                                  .label = std::to_string(column + 1),
                                  .mode = column < 3               ? DrawnMode::fixed
                                          : column < count * 2 / 3 ? DrawnMode::slides_and_topples
                                                                   : DrawnMode::plain});
    }
    return drawing;
}

ModeChart mode_chart() {
    constexpr double slenderness = degrees(18.435);
    constexpr double steepest = degrees(60);
    constexpr double roughest = degrees(50);
    const auto rotation_without_slip = [](double a) {
        const double excess = std::sin(a - slenderness);
        return std::atan2(4 * std::sin(a) - 3 * std::cos(slenderness) * excess,
                          4 * std::cos(a) + 3 * std::sin(slenderness) * excess);
    };
    NamedCurve dynamic{.legend = "dynamic boundary of toppling without sliding"};
    for (int index = 0; index <= 50; ++index) {
        const double a = slenderness + (steepest - slenderness) * index / 50;
        dynamic.points.emplace_back(a, rotation_without_slip(a));
    }
    Polyline both = dynamic.points;
    both.emplace_back(steepest, slenderness);
    Polyline topples = dynamic.points;
    topples.emplace_back(steepest, roughest);
    topples.emplace_back(slenderness, roughest);
    return {
        .title = "Single block, width / height = 1/3",
        .x = "plane.dip",
        .y = "friction_angle",
        .regions = {{DrawnMode::stays, {{0, 0}, {slenderness, slenderness}, {slenderness, roughest}, {0, roughest}}},
                    {DrawnMode::slides, {{0, 0}, {steepest, 0}, {steepest, slenderness}, {slenderness, slenderness}}},
                    {DrawnMode::topples, topples},
                    {DrawnMode::slides_and_topples, both}},
        .boundaries = {{"friction angle = dip", {{0, 0}, {slenderness, slenderness}}},
                       {"dip = atan(width / height)", {{slenderness, slenderness}, {slenderness, roughest}}},
                       {"friction angle = atan(width / height)", {{slenderness, slenderness}, {steepest, slenderness}}},
                       dynamic},
        .printed = {{"base friction model, slides and topples", {degrees(45), degrees(22)}},
                    {"base friction model, topples", {degrees(30), degrees(35)}}}};
}

BlockAnimation animation() {
    constexpr int frames = 60;
    BlockAnimation result{.blocks = {{{{0, 0}, {1, 0}, {1, 3}, {0, 3}}, "1"},
                                     {{{1, 0}, {2, 0}, {2, 4}, {1, 4}}, "2"},
                                     {{{-3, -1}, {5, -1}, {5, 0}, {-3, 0}}, "F", true}},
                          .frames = {},
                          .outcome = "collapse",
                          .colour = "speed",
                          .unit = "m/s",
                          .bar_unit = "kN/m",
                          .caption = "Columns that topple over their corners."};
    for (int index = 0; index < frames; ++index) {
        const double time = 0.05 * index;
        AnimationFrame frame{time, degrees(21.8), {}};
        for (const double height : {3.0, 4.0}) {
            // The block turns about its lower left corner, from which the centroid is at (0.5, height / 2).
            const double angle = 0.01 * std::exp(1.4 * time);
            const Point from_corner(0.5, height / 2);
            frame.poses.push_back({turned(from_corner, angle) - from_corner, angle, 1.4 * angle * from_corner.norm()});
        }
        frame.poses.emplace_back();
        frame.bars = {{{-0.1 * time, 2}, {4, 1}, std::min(40 * time, 60.0), 40 * time > 60}};
        result.frames.push_back(std::move(frame));
    }
    return result;
}

}  // namespace delabole::samples
