#include "cases/program/thesis/chapter_5/relaxation_drawing.hpp"

#include "cases/program/models/relaxation/figures.hpp"
#include "plots/drawing/extent.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace delabole {

namespace {

// A long base is cut off near the columns; base blocks are drawn whole.
Polyline outline_of(const Chapter5Run& run, const HockingBlock& block, const HockingBlockState& state) {
    const auto corners = corners_of(block, state);
    Polyline outline(corners.begin(), corners.end());
    if (block.fixed && run.columns.base == HockingBase::one_block) {
        const double width = run.columns.width;
        const Point along = (corners[1] - corners[0]).normalized();
        const Point down = (corners[3] - corners[0]).normalized();
        const Point toe = corners[0] + run.columns.downhill_bases * width * along;
        const auto count = static_cast<double>(run.columns.heights.size());
        const Point first = toe - 1.5 * width * along;
        const Point last = toe + (count + 1) * width * along;
        outline = {first, last, last + 0.5 * width * down, first + 0.5 * width * down};
    }
    for (Point& corner : outline) {
        corner /= inch;
    }
    return outline;
}

}  // namespace

DrawnMode behaviour(const Chapter5Run& run, const HockingResult& result, const HockingPrint& print,
                    std::size_t column) {
    constexpr double turned = degrees(1);
    constexpr double moved = 0.02;  // of the width
    if (std::abs(rotation_in(run, print, column)) > turned) {
        return DrawnMode::topples;
    }
    // This is where the block would be had it only turned with its base, about the origin.
    const double turn = print.blocks[column].angle - rotation_in(run, print, column);
    const Point carried = Eigen::Rotation2Dd(turn) * result.prints.front().blocks[column].centroid;
    return (print.blocks[column].centroid - carried).norm() > moved * run.columns.width ? DrawnMode::slides
                                                                                        : DrawnMode::stays;
}

JointOpening widest_opening(const Chapter5Run& run, const HockingPrint& print) {
    const std::vector<HockingBlock> blocks = make_blocks(run.columns);
    JointOpening widest{0, -std::numeric_limits<double>::infinity()};
    // Includes the distance of a point from a side if the point is opposite the side and not beyond its ends.
    const auto include = [&](std::size_t column, const Point& from, const Point& to, const Point& point,
                             const Point& outward) {
        const Point side = to - from;
        const double share = side.dot(point - from) / side.squaredNorm();
        if (share >= 0 && share <= 1) {
            const double width = outward.dot(point - from);
            widest = width > widest.width ? JointOpening{column, width} : widest;
        }
    };
    for (std::size_t column = 0; column + 1 < run.columns.heights.size(); ++column) {
        const auto lower = corners_of(blocks[column], print.blocks[column]);
        const auto upper = corners_of(blocks[column + 1], print.blocks[column + 1]);
        const Point uphill = (lower[1] - lower[0]).normalized();
        const Point downhill = (upper[0] - upper[1]).normalized();
        for (const std::size_t corner : {0U, 3U}) {
            include(column, lower[1], lower[2], upper[corner], uphill);
        }
        for (const std::size_t corner : {1U, 2U}) {
            include(column, upper[0], upper[3], lower[corner], downhill);
        }
    }
    return widest;
}

const HockingPrint& print_at(const HockingResult& result, int cycle) {
    const auto after = std::ranges::upper_bound(result.prints, cycle, {}, &HockingPrint::cycle);
    return after == result.prints.begin() ? *after : *std::prev(after);
}

Figure frames_figure(const std::string& title, const Chapter5Run& run, const HockingResult& result,
                     const std::vector<int>& cycles) {
    const std::vector<HockingBlock> blocks = make_blocks(run.columns);
    const double gap = 0.7;  // in
    BlockDrawing drawing{.title = title};
    std::vector<Point> captions;
    double offset = 0;
    for (const int cycle : cycles) {
        const HockingPrint& print = print_at(result, cycle);
        std::vector<DrawnBlock> frame;
        Extent x;
        Extent y;
        for (std::size_t index = 0; index < blocks.size(); ++index) {
            const bool fixed = blocks[index].fixed;
            DrawnBlock block{.outline = outline_of(run, blocks[index], print.blocks[index]),
                             .label = label_of(index, fixed),
                             .mode = fixed ? DrawnMode::fixed : behaviour(run, result, print, index)};
            for (const Point& corner : block.outline) {
                x.include(corner.x());
                y.include(corner.y());
            }
            frame.push_back(block);
        }
        const double shift = offset - x.lowest;
        for (DrawnBlock& block : frame) {
            for (Point& corner : block.outline) {
                corner.x() += shift;
            }
            drawing.blocks.push_back(block);
        }
        captions.emplace_back(offset + (x.size()) / 2, y.highest);
        offset += x.size() + gap;
    }
    Figure figure = block_figure(drawing);
    figure.x.title = "distance";
    figure.y.title = "height";
    figure.x.unit = figure.y.unit = "in";
    Extent top;
    for (std::size_t index = 0; index < captions.size(); ++index) {
        top.include(captions[index].y());
        figure.labels.push_back({.at = captions[index],
                                 .text = "cycle " + std::to_string(print_at(result, cycles[index]).cycle),
                                 .align = Label::Align::centre,
                                 .raise = 0.8,
                                 .boxed = false,
                                 .size = 0.8});
    }
    if (figure.y.range) {
        figure.y.range->second = std::max(figure.y.range->second, top.highest + 0.15 * (top.highest + 1));
    }
    return figure;
}

void set_one_scale(std::vector<Figure>& figures) {
    Frame frame;
    int height = 0;
    for (const Figure& figure : figures) {
        frame.include(
            Polyline{{figure.x.range->first, figure.y.range->first}, {figure.x.range->second, figure.y.range->second}});
        height = std::max(height, figure.height);
    }
    for (Figure& figure : figures) {
        figure.x.range = std::pair{frame.x.lowest, frame.x.highest};
        figure.y.range = std::pair{frame.y.lowest, frame.y.highest};
        figure.height = height;
    }
}

Figure history_figure(const std::string& title, const std::string& y_title, const std::string& y_unit,
                      const std::vector<HistoryOf>& histories) {
    constexpr std::array colours{Colour::blue,   Colour::vermilion, Colour::green, Colour::orange,
                                 Colour::purple, Colour::sky,       Colour::black};
    Figure figure{.title = title, .x = {.title = "cycle"}, .y = {.title = y_title, .unit = y_unit}};
    std::size_t colour = 0;
    for (const HistoryOf& history : histories) {
        const bool dashed = history.clean && colour > 0;
        colour += dashed ? 0 : 1;
        Line line{.legend = history.legend,
                  .colour = colours[(colour - 1) % colours.size()],
                  .dash = dashed ? Dash::dashed : Dash::solid};
        for (const HockingPrint& print : history.result->prints) {
            line.points.emplace_back(print.cycle, history.value(print));
        }
        figure.series.emplace_back(line);
    }
    return figure;
}

}  // namespace delabole
