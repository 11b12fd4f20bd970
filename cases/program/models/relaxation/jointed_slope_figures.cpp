#include "cases/program/models/relaxation/jointed_slope_figures.hpp"

#include "cases/program/case/model_cases.hpp"
#include "cases/program/models/relaxation/figures.hpp"
#include "dynamic_relaxation/scene/water_table.hpp"
#include "fitting/work/words.hpp"
#include "plots/figures/block_figures.hpp"

#include <algorithm>
#include <limits>

namespace delabole {

namespace {

// The water table within the width of the section.
Polyline drawn_table(const RelaxationSlope& slope, const std::vector<RelaxationBlock>& blocks) {
    Polyline table;
    if (!slope.water) {
        return table;
    }
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (const RelaxationBlock& block : blocks) {
        for (const PlanePoint<>& corner : block.outline) {
            left = std::min(left, corner.x());
            right = std::max(right, corner.x());
        }
    }
    const std::vector<SectionPoint>& points = slope.water->vertex;
    table.emplace_back(left, water_table_height(points, left));
    for (const SectionPoint& point : points) {
        if (point.x > left && point.x < right) {
            table.emplace_back(point.x, point.y);
        }
    }
    table.emplace_back(right, water_table_height(points, right));
    return table;
}

Table cut_table(const RelaxationSlope& slope, const JointedSection& section) {
    Table table{
        "The cuts in their order; not cut: blocks that a joint would have divided had it reached from side to side.",
        {"cut", "joint", "blocks divided"_number, "not cut"_number}};
    for (std::size_t index = 0; index < section.cut.size(); ++index) {
        const SlopeCut& cut = slope.geometry.cut[index];
        table.rows.push_back(
            {cut.name, cut.joint, std::to_string(section.cut[index].made), std::to_string(section.cut[index].dropped)});
    }
    return table;
}

}  // namespace

void append_cutting_warnings(const RelaxationSlope& slope, const SlopeScene& made, Analysis& analysis) {
    const JointedSection& section = made.section;
    if (made.beside_frame > 0) {
        analysis.warnings.push_back(value_in_words(made.beside_frame, Dimension::length) +
                                    " of scene.outline face the frame, but do not lie on it: they are free, since the "
                                    "frame runs along the lowest level and the rearmost upright of the outline");
    }
    for (std::size_t index = 0; index < section.cut.size(); ++index) {
        const SlopeCut& cut = slope.geometry.cut[index];
        const std::string name = indexed("scene.cut", index) + " (" + cut.name + ")";
        if (section.cut[index].made == 0) {
            analysis.warnings.push_back(name + " divides no block" +
                                        (section.cut[index].along == 0
                                             ? ""
                                             : ": it runs along other joints, of which the weaker counts, or along the "
                                               "outline, where it counts on the frame alone"));
        } else if (const std::size_t inside = section.cut[index].dropped; inside > 0) {
            const std::string places = inside == 1 ? " in one place" : " in " + std::to_string(inside) + " places";
            analysis.warnings.push_back(name + " ends inside a block" +
                                        (std::holds_alternative<LineCut>(cut.trace) ? "" : places) +
                                        ", which holds there like intact rock");
        }
    }
    if (section.outline_reversed) {
        analysis.warnings.emplace_back("scene.outline runs clockwise and was turned round");
    }
    if (section.slivers_kept > 0) {
        analysis.warnings.push_back(std::to_string(section.slivers_kept) +
                                    " slivers were kept: with none of their neighbours do they make a convex block "
                                    "that locks no joint, and they are too large to be taken away");
    }
}

void append_section_figure(const RelaxationSlope& slope, const SlopeScene& made, const ResultFolder& folder,
                           Report& report) {
    const JointedSection& section = made.section;
    report.blocks.emplace_back(Heading{"The section"});
    const Folded cutting{
        "How the section was cut",
        {cut_table(slope, section),
         Paragraph{"Slivers below the stated share of the median block, " +
                   value_in_words(section.typical_area, Dimension::area) + ": " +
                   std::to_string(section.slivers_merged) + " merged, " + std::to_string(section.slivers_crushed) +
                   " taken away as crushed (" + value_in_words(section.crushed_area, Dimension::area) +
                   " together; merged, they would lock a joint; blocks may have leaned on them, and with "
                   "scene.sliver_share = 0 all are kept), " +
                   std::to_string(section.slivers_kept) +
                   " kept. Faces in intact rock: " + std::to_string(section.intact_edges) + ". Cuts nearer than " +
                   value_in_words(section.snap_distance, Dimension::length) + " to a corner run through it."}}};
    if (made.block.size() > most_drawn_blocks) {
        report.blocks.emplace_back(cutting);
        return;
    }
    BlockDrawing drawing{.title = "The section"};
    const Upright upright(slope.tilt.value_or(0));
    for (const SlopeRock& rock : slope.rock) {
        drawing.rocks.push_back(rock.name);
    }
    for (std::size_t index = 0; index < made.block.size(); ++index) {
        DrawnBlock block;
        for (const PlanePoint<>& corner : made.block[index].outline) {
            block.outline.push_back(upright(corner));
        }
        if (made.block[index].fixed) {
            block.mode = DrawnMode::fixed;
            block.label = label_of(index, true);
        } else {
            block.rock = made.rock[index];
        }
        drawing.blocks.push_back(std::move(block));
    }
    drawing.water = drawn_table(slope, made.block);
    for (Point& point : drawing.water) {
        point = upright(point);
    }
    report.blocks.emplace_back(
        folder.draw(block_figure(drawing), "section", "The section and its blocks, shaded by rock; grey: fixed."));
    report.blocks.emplace_back(cutting);
}

}  // namespace delabole
