#include "cases/program/models/relaxation/figures.hpp"

#include "cases/program/case/model_cases.hpp"
#include "dynamic_relaxation/scene/water_table.hpp"
#include "dynamic_relaxation/study/cracks.hpp"
#include "dynamic_relaxation/study/strength_reduction.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/block_figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace delabole {

namespace {

constexpr std::size_t most_rows = 60;
// With more blocks, numbers would hide the picture.
constexpr std::size_t most_numbered_blocks = 80;

DrawnMode drawn(BlockMovement movement) {
    using enum DrawnMode;
    // In the order of BlockMovement; removed blocks and those that have left are plain.
    constexpr std::array modes{stays,           slides, slides, topples, slides_and_topples, slides_and_topples, moves,
                               held_by_corners, fixed,  plain,  plain};
    static_assert(modes.size() == enum_names(BlockMovement{}).size());
    return modes[static_cast<std::size_t>(movement)];
}

BlockDrawing drawing_of(const RelaxationRun& made, const std::vector<Motion>& motion, const Bodies& bodies, double tilt,
                        bool with_modes) {
    const Upright upright(tilt);
    BlockDrawing drawing;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (made.end->removed[block] != 0 && with_modes) {
            continue;
        }
        DrawnBlock shown;
        for (std::size_t corner = bodies.range[block].begin; corner < bodies.range[block].end; ++corner) {
            shown.outline.push_back(upright(moved_corner(bodies, motion, corner)));
        }
        const bool fixed = bodies.fixed[block] != 0;
        if (fixed || bodies.size() <= most_numbered_blocks) {
            shown.label = label_of(block, fixed);
        }
        shown.mode = fixed        ? DrawnMode::fixed
                     : with_modes ? drawn(made.result.block[block].movement)
                                  : DrawnMode::plain;
        drawing.blocks.push_back(std::move(shown));
    }
    return drawing;
}

Figure start_figure(const RelaxationRun& made, const Bodies& bodies) {
    BlockDrawing drawing = drawing_of(made, made.end->origin, bodies, made.scene.gravity.tilt, false);
    drawing.title = "At the start";
    return block_figure(drawing);
}

// Least opening, as a share of the median block size, at which a joint is shown as open.
constexpr double open_share = 0.03;

void add_cracks(BlockDrawing& drawing, const RelaxationRun& made, const Bodies& bodies, double tilt) {
    if (made.scene.bond.empty()) {
        return;
    }
    const Upright upright(tilt);
    for (const BrokenBond& bond : broken_bonds(made.scene, bodies, *made.end)) {
        drawing.broken.push_back({upright(carried(bodies, made.end->motion, bond.block, bond.from)),
                                  upright(carried(bodies, made.end->motion, bond.block, bond.to))});
    }
    std::vector<double> sizes = bodies.radius;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::ranges::nth_element(sizes, middle);
    for (const OpenJoint& joint : open_joints(made.scene, bodies, *made.end, open_share * *middle)) {
        drawing.open_joints.push_back({upright(joint.from), upright(joint.to)});
    }
}

Figure end_figure(const RelaxationRun& made, const Bodies& bodies) {
    BlockDrawing drawing = drawing_of(made, made.end->motion, bodies, made.result.tilt, true);
    drawing.title = "After " + value_in_words(made.result.time, Dimension::time);
    add_cracks(drawing, made, bodies, made.result.tilt);
    return block_figure(drawing);
}

Figure force_figure(const RelaxationRun& made, const Bodies& bodies) {
    const Upright upright(made.result.tilt);
    BlockDrawing drawing = drawing_of(made, made.end->motion, bodies, made.result.tilt, false);
    drawing.title = "Contact forces after " + value_in_words(made.result.time, Dimension::time);
    const std::vector<Bond> bonds = make_bonds(made.scene, bodies, made.settings.viscous_damping);
    for (const CornerForce& force : corner_forces(bonds, bodies, *made.end)) {
        const bool on_fixed = bodies.fixed[force.block] != 0;
        const bool by_fixed = bodies.fixed[force.other] != 0;
        drawing.forces.push_back({upright(force.at), (on_fixed ? -1 : 1) * upright(force.force),
                                  on_fixed || by_fixed ? ForceKind::base_reaction : ForceKind::interblock});
    }
    for (const BoltPull& bolt : bolt_pulls(made.scene, bodies, *made.end)) {
        const PlanePoint<> along = (bolt.other_at - bolt.at).normalized();
        drawing.forces.push_back({upright(bolt.at), bolt.force * upright(along), ForceKind::applied});
    }
    return block_figure(drawing);
}

double speed(const Motion& motion) {
    return std::hypot(motion.vx, motion.vy);
}

// Adds the velocities of the centroids at the end; returns false if nothing moves. A sliver may fly off between blocks:
// since the scale must show the velocities of the blocks, its arrow is no longer than the longest of theirs.
bool add_velocities(BlockDrawing& drawing, const RelaxationRun& made, const Bodies& bodies) {
    constexpr double at_rest = 1e-6;
    constexpr double sliver_share = 0.1;  // of the median block's mass
    std::vector<std::size_t> blocks;      // the heaviest first
    double size = 0;
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (bodies.fixed[block] == 0 && made.end->removed[block] == 0) {
            blocks.push_back(block);
            size = std::max(size, bodies.radius[block]);
        }
    }
    std::ranges::sort(blocks, std::greater{}, [&](std::size_t block) { return bodies.mass[block]; });
    double longest = 0;
    double of_slivers = 0;
    for (const std::size_t block : blocks) {
        const bool sliver = bodies.mass[block] < sliver_share * bodies.mass[blocks[blocks.size() / 2]];
        double& greatest = sliver ? of_slivers : longest;
        greatest = std::max(greatest, speed(made.end->motion[block]));
    }
    longest = longest > at_rest ? longest : of_slivers;
    if (!(longest > at_rest)) {
        return false;
    }
    const Upright upright(made.result.tilt);
    Arrows& arrows = drawing.velocities;
    arrows.legend = "velocity, the longest " + value_in_words(longest, Dimension::speed);
    if (of_slivers > longest) {
        arrows.legend += "; slivers up to " + value_in_words(of_slivers, Dimension::speed);
    }
    arrows.colour = Colour::vermilion;
    for (const std::size_t block : blocks) {
        const Motion& motion = made.end->motion[block];
        if (speed(motion) > longest / 1000) {
            const PlanePoint<> centre = bodies.centroid[block] + PlanePoint<>(motion.x, motion.y);
            const double scale = size / std::max(longest, speed(motion));
            const PlanePoint<> movement(scale * motion.vx, scale * motion.vy);
            arrows.shafts.push_back({upright(centre), upright(PlanePoint<>(centre + movement))});
        }
    }
    return true;
}

std::optional<Figure> velocity_figure(const RelaxationRun& made, const Bodies& bodies) {
    BlockDrawing drawing = drawing_of(made, made.end->motion, bodies, made.result.tilt, false);
    drawing.title = "Velocities after " + value_in_words(made.result.time, Dimension::time);
    return add_velocities(drawing, made, bodies) ? std::optional(block_figure(drawing)) : std::nullopt;
}

Table block_table(const RelaxationRun& made) {
    std::vector<std::size_t> shown;
    for (std::size_t block = 0; block < made.result.block.size(); ++block) {
        if (made.result.block[block].movement != BlockMovement::fixed) {
            shown.push_back(block);
        }
    }
    std::string caption = "The blocks at the end; slip over the base is negative forward, towards the toe.";
    if (shown.size() > most_rows) {
        std::ranges::stable_sort(shown, std::greater{},
                                 [&](std::size_t block) { return made.result.block[block].displacement; });
        shown.resize(most_rows);
        caption += " The " + std::to_string(most_rows) + " that moved farthest, results.csv has all.";
    }
    Table table{std::move(caption),
                {"block"_number, "movement", "rotation, °"_number, "displacement"_number, "slip over the base"_number}};
    for (const std::size_t block : shown) {
        const BlockOutcome& outcome = made.result.block[block];
        table.rows.push_back({std::to_string(block + 1), human_name(word_of(outcome.movement)),
                              degrees_in_words(outcome.rotation), length_in_words(outcome.displacement),
                              length_in_words(outcome.base_slip)});
    }
    return table;
}

void append_warnings_of_joints_along_joints(const RelaxationSlope& slope, const JointedSection& section,
                                            const std::vector<JointMaterial>& materials,
                                            const std::optional<CriticalPlan>& plan, Analysis& analysis) {
    for (const auto& [one, other] : section.along_each_other) {
        if (!holds_at_least(materials[one], materials[other]) && !holds_at_least(materials[other], materials[one])) {
            analysis.warnings.push_back(
                "the joints " + slope.joint[one].name + " and " + slope.joint[other].name +
                " run along each other, and neither is the weaker one in every strength: the one with less shear "
                "strength under an eighth of the outline's height of rock counts, though the other may be the weaker "
                "under another stress or after slip; one joint with the lesser value of each strength in place of both "
                "is on the safe side");
        }
    }
    if (plan && !plan->joint.empty()) {
        std::vector<std::string> others = joints_reduced(slope, plan->joint);
        std::erase_if(
            others, [&](const std::string& name) { return std::ranges::find(plan->joint, name) != plan->joint.end(); });
        if (!others.empty()) {
            analysis.warnings.push_back("critical.joints does not name " + list_in_words(others, " and ") +
                                        ", but the strength of these joints is divided everywhere, too, since they "
                                        "run along joints that it names");
        }
    }
}

}  // namespace

std::string length_in_words(double length) {
    constexpr double metre = 1;
    constexpr double millimetre = 1e-3;
    constexpr double unseen = 5e-7;  // half a thousandth of a millimetre
    if (std::abs(length) < unseen) {
        return "0";
    }
    const DisplayUnit shown = shown_unit(Dimension::length);
    if (shown.symbol != display_unit(Dimension::length).symbol) {
        constexpr double inch = 0.0254;
        return std::abs(length) >= shown.si_per_unit ? value_in_words(length, Dimension::length)
                                                     : number_in_words(length / inch) + " in";
    }
    return std::abs(length) >= metre ? number_in_words(length) + " m" : number_in_words(length / millimetre) + " mm";
}

std::string degrees_in_words(double angle) {
    constexpr double unseen = 5e-4;  // deg
    const double shown = angle / degrees(1);
    return std::abs(shown) < unseen ? "0" : number_in_words(shown);
}

Figure mechanism_figure(const RelaxationRun& made, const std::string& title) {
    const Bodies bodies = make_bodies(made.scene);
    BlockDrawing drawing = drawing_of(made, made.end->motion, bodies, made.result.tilt, true);
    drawing.title = title;
    for (DrawnBlock& block : drawing.blocks) {
        block.label.clear();  // a label would hide the arrows
    }
    add_cracks(drawing, made, bodies, made.result.tilt);
    add_velocities(drawing, made, bodies);
    return block_figure(drawing);
}

void append_block_figures(const RelaxationRun& made, const Sheet& sheet) {
    if (!made.end) {
        return;
    }
    const Bodies bodies = make_bodies(made.scene);
    sheet.add(Heading{"The blocks"});
    const auto append_table = [&] { sheet.add(Folded{"Table of the blocks", {block_table(made)}}); };
    if (bodies.size() > most_drawn_blocks) {
        sheet.add(Paragraph{"There are " + std::to_string(bodies.size()) +
                            " blocks, too many to be told apart in a drawing."});
        append_table();
        return;
    }
    sheet.draw(start_figure(made, bodies), "start", "The blocks at the start, gravity downwards; F: fixed.");
    sheet.draw(end_figure(made, bodies), "end", "The blocks at the end of the run, and how each has moved.");
    if (const auto figure = velocity_figure(made, bodies)) {
        sheet.draw(*figure, "velocities", "Velocities of the centroids at the end of the run.");
    }
    sheet.draw(force_figure(made, bodies), "contact_forces",
               "Forces at the corners at the end of the run, those of cohesive and bonded faces at their ends: on free "
               "blocks by fixed ones, and on the block of the corner by its neighbour. The smallest have arrows of the "
               "least length that can be seen. Where there are too many for arrows, lines run along the forces, as "
               "thick as these are great.");
    append_table();
}

void append_failure_figure(const RelaxationRun& failed, const std::string& title, const std::string& name,
                           const Sheet& sheet) {
    if (failed.scene.block.size() > most_drawn_blocks) {
        return;
    }
    sheet.draw(mechanism_figure(failed, title), name,
               failed.result.outcome == RelaxationOutcome::held_by_corners
                   ? "The blocks at rest, at the nearest value found not to stand: those that only corners hold."
                   : "The blocks at the onset of failure, at the nearest value found to fail: what each has begun to "
                     "do. One that stays with an arrow is under way, but not yet by a tenth of the farthest.");
}

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

void append_cutting_warnings(const RelaxationSlope& slope, const SlopeScene& made,
                             const std::vector<JointMaterial>& materials, const std::optional<CriticalPlan>& plan,
                             Analysis& analysis) {
    const JointedSection& section = made.section;
    if (slope.water && !slope.water->vertex.empty()) {
        const auto top = [](const std::vector<SectionPoint>& points) {
            return std::ranges::max_element(points, {}, &SectionPoint::y)->y;
        };
        if (const double above = top(slope.water->vertex) - top(slope.geometry.outline); above > 0) {
            analysis.warnings.push_back("the water table rises up to " + value_in_words(above, Dimension::length) +
                                        " above the highest point of scene.outline: there the ground stands under "
                                        "water");
        }
    }
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
    for (std::size_t index = 0; index < slope.joint.size() && !slope.water; ++index) {
        if (slope.joint[index].water_share) {
            analysis.warnings.push_back(indexed("scene.joint", index) + ".water_share (" + slope.joint[index].name +
                                        ") has no effect: there is no [scene.water]");
        }
    }
    append_warnings_of_joints_along_joints(slope, section, materials, plan, analysis);
    if (section.outline_reversed) {
        analysis.warnings.emplace_back("scene.outline runs clockwise and was turned round");
    }
    // The median of so few blocks tells little of them: a sliver may be what the case is about.
    constexpr std::size_t few_blocks = 10;
    if (section.slivers_merged > 0 && made.block.size() <= few_blocks) {
        analysis.warnings.push_back(
            (section.slivers_merged == 1 ? std::string("a small piece")
                                         : std::to_string(section.slivers_merged) + " small pieces") +
            " became part of a neighbour and cannot fail alone: scene.sliver_share = 0 keeps what is small");
    }
    if (section.slivers_kept > 0) {
        analysis.warnings.push_back(std::to_string(section.slivers_kept) +
                                    " slivers were kept: with none of their neighbours do they make a convex block "
                                    "that locks no joint, and they are too large to be taken away");
    }
}

void append_section_figure(const RelaxationSlope& slope, const SlopeScene& made, const Sheet& sheet) {
    const JointedSection& section = made.section;
    sheet.add(Heading{"The section"});
    const Folded cutting{
        "How the section was cut",
        {cut_table(slope, section),
         Paragraph{"Slivers below the stated share of a typical block, " +
                   value_in_words(section.typical_area, Dimension::area) + ": " +
                   std::to_string(section.slivers_merged) + " merged, " + std::to_string(section.slivers_crushed) +
                   " taken away as crushed (" + value_in_words(section.crushed_area, Dimension::area) +
                   " together; merged, they would lock a joint; blocks may have leaned on them, and with "
                   "scene.sliver_share = 0 all are kept), " +
                   std::to_string(section.slivers_kept) +
                   " kept. Faces in intact rock: " + std::to_string(section.intact_edges) + ". Cuts nearer than " +
                   value_in_words(section.snap_distance, Dimension::length) + " to a corner run through it."}}};
    if (made.block.size() > most_drawn_blocks) {
        sheet.add(cutting);
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
    sheet.draw(block_figure(drawing), "section", "The section and its blocks, shaded by rock; grey: fixed.");
    sheet.add(cutting);
}

}  // namespace delabole
