// The ground left standing of a jointed slope, in the report of its run.
#include "cases/program/models/relaxation/figures.hpp"
#include "fitting/work/words.hpp"
#include "plots/drawing/text.hpp"
#include "plots/figures/block_figures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace delabole {

namespace {

// A length without its unit, which the title of the column has: one column, one unit.
std::string in_column(double length) {
    constexpr double unseen = 5e-7;  // m
    return std::abs(length) < unseen ? "0" : number_in_words(length / shown_unit(Dimension::length).si_per_unit);
}

TableColumn length_column(const std::string& title) {
    return {title + ", " + std::string(shown_unit(Dimension::length).symbol), true};
}

// The sets whose joints have the properties and the dip of a crack: several sets may share their properties.
std::string set_of(const CrestCrack& crack, const std::string& joint, const RelaxationSlope& slope) {
    std::string names;
    for (const SlopeCut& cut : slope.geometry.cut) {
        const auto* set = std::get_if<JointSetCut>(&cut.trace);
        // Upright joints dip 90 deg either way.
        const double apart = set != nullptr ? std::abs(std::sin(crack.dip - set->dip)) : 1;
        if (cut.joint == joint && apart < std::sin(degrees(0.5))) {
            names += (names.empty() ? "" : " or ") + cut.name;
        }
    }
    return names.empty() ? joint : names;
}

Table crack_table(const PostFailure& failure, const RelaxationSlope& slope) {
    Table table{"Open joints at the ground behind the crest of the slope.",
                {length_column("behind the crest"), "set", "dip, °"_number, "opening"_number}};
    for (const CrestCrack& crack : failure.crack) {
        table.rows.push_back({in_column(crack.position), set_of(crack, failure.answer.joint[crack.joint].joint, slope),
                              degrees_in_words(crack.dip), value_in_words(crack.opening, Dimension::length)});
    }
    return table;
}

Table crest_table(const PostFailure& failure) {
    Table table{"Blocks at the ground behind the crest: into the slope, upwards, and turning out of the slope.",
                {length_column("behind the crest"), "block"_number, "horizontal"_number, "vertical"_number,
                 "rotation, °"_number}};
    for (const CrestBlock& block : failure.block) {
        table.rows.push_back({in_column(block.position), std::to_string(block.block + 1),
                              value_in_words(block.movement.horizontal, Dimension::length),
                              value_in_words(block.movement.vertical, Dimension::length),
                              degrees_in_words(block.movement.rotation)});
    }
    return table;
}

void write_ground(const RelaxationRun& made, const PostFailure& failure, const ResultFolder& folder) {
    std::vector<std::string> titles{"x_m", "ground_m", "left_standing_m"};
    const std::vector<Polyline> after = left_standing_after(make_bodies(made.scene), made.stage);
    for (std::size_t stage = 1; stage <= after.size(); ++stage) {
        titles.push_back("after_stage_" + std::to_string(stage) + "_m");
    }
    CsvTable table(std::move(titles));
    const auto length = [](double value) { return in_display_unit(value, Dimension::length); };
    for (std::size_t index = 0; index < failure.ground.size(); ++index) {
        std::vector<Cell> row{length(failure.ground[index].x()), length(failure.ground[index].y()),
                              length(failure.left_standing[index].y())};
        for (const Polyline& ground : after) {
            row.emplace_back(length(ground[index].y()));
        }
        table.add_row(row);
    }
    folder.write("left_standing.csv", table.text());
}

void write_tables(const PostFailure& failure, const ResultFolder& folder) {
    const auto length = [](double value) { return in_display_unit(value, Dimension::length); };
    const auto angle = [](double value) { return in_display_unit(value, Dimension::angle); };
    CsvTable cracks({"position_m", "joint", "dip_deg", "opening_m"});
    for (const CrestCrack& crack : failure.crack) {
        cracks.add_row(
            {length(crack.position), failure.answer.joint[crack.joint].joint, angle(crack.dip), length(crack.opening)});
    }
    folder.write("crest_cracks.csv", cracks.text());
    CsvTable crest({"position_m", "block", "horizontal_m", "vertical_m", "rotation_deg"});
    for (const CrestBlock& block : failure.block) {
        crest.add_row({length(block.position), static_cast<double>(block.block + 1), length(block.movement.horizontal),
                       length(block.movement.vertical), angle(block.movement.rotation)});
    }
    folder.write("crest_blocks.csv", crest.text());
}

// Number of stages that are shown in different shades.
constexpr std::size_t most_shades = 4;

// The stage of retrogression in which each block failed, counted from 1; 0: it has not failed.
std::vector<std::size_t> stages_of_blocks(const RelaxationRun& made) {
    std::vector<std::size_t> stages(made.scene.block.size(), 0);
    for (std::size_t stage = 0; stage < made.stage.size(); ++stage) {
        for (const std::uint64_t block : made.stage[stage].block) {
            stages[block] = stage + 1;
        }
    }
    return stages;
}

Table stage_table(const RelaxationRun& made) {
    Table table{
        "Masses that failed one after the other, with the shares of their area in blocks that topple out of the "
        "slope, turn into it, and slide, and the share of rotation in their kinetic energy at onset: 25 % where "
        "rectangles turn about a corner.",
        {"stage"_number, "blocks"_number, "area, m²"_number, "topples, %"_number, "turns back, %"_number,
         "slides, %"_number, "energy of rotation, %"_number}};
    const RetrogressionAnswer answer = answer_of(make_bodies(made.scene), made.stage);
    constexpr double percent = 100;
    for (const RetrogressionStage& stage : answer.stage) {
        table.rows.push_back(
            {std::to_string(table.rows.size() + 1), human_number(stage.blocks, 6), human_number(stage.area, 4),
             human_number(percent * stage.toppling_share, 3), human_number(percent * stage.backward_share, 3),
             human_number(percent * stage.sliding_share, 3), human_number(percent * stage.rotation_share, 3)});
    }
    return table;
}

BlockDrawing slope_drawing(const RelaxationRun& made, const std::vector<Motion>& motion, double tilt,
                           const PostFailure& failure, const std::string& title,
                           const std::function<bool(std::size_t block)>& gone) {
    const Bodies bodies = make_bodies(made.scene);
    const Upright upright(tilt);
    BlockDrawing drawing{.title = title, .rocks = {"left standing"}};
    const std::vector<std::size_t> stage = stages_of_blocks(made);
    const std::size_t stages = std::min(made.stage.size(), most_shades);
    for (std::size_t shade = 1; shade <= stages; ++shade) {
        drawing.rocks.push_back(
            (shade < stages || made.stage.size() == stages ? "failed in stage " : "failed in later stages, from ") +
            std::to_string(shade));
    }
    if (stages == 0) {
        drawing.rocks.insert(drawing.rocks.end(), {"failed", "moving"});
    }
    for (std::size_t block = 0; block < bodies.size(); ++block) {
        if (gone(block)) {
            continue;
        }
        DrawnBlock shown;
        for (std::size_t corner = bodies.range[block].begin; corner < bodies.range[block].end; ++corner) {
            shown.outline.push_back(upright(moved_corner(bodies, motion, corner)));
        }
        constexpr double half = 0.5;
        shown.mode = bodies.fixed[block] != 0 ? DrawnMode::fixed : DrawnMode::plain;
        if (bodies.fixed[block] == 0) {
            shown.rock = 0;
            if (stage[block] > 0) {
                shown.rock = std::min(stage[block], most_shades);
            } else if (failure.share[block] >= half) {
                shown.rock = 1;
            } else if (made.stage.empty() && has_failed(made.result.block[block].movement)) {
                shown.rock = 2;
            }
        }
        drawing.blocks.push_back(std::move(shown));
    }
    return drawing;
}

}  // namespace

Figure moved_slope_figure(const RelaxationRun& made, const MotionFrame& frame, const PostFailure& end,
                          const std::string& title) {
    return block_figure(slope_drawing(made, frame.motion, frame.tilt, end, title,
                                      [&](std::size_t block) { return is_gone(frame.outcome[block].movement); }));
}

Figure left_standing_figure(const RelaxationRun& made, const PostFailure& failure, const std::string& title) {
    const Upright upright(made.scene.gravity.tilt);
    const std::vector<Motion> unmoved(made.scene.block.size());
    const BlockDrawing drawing =
        slope_drawing(made, unmoved, made.scene.gravity.tilt, failure, title, [](std::size_t) { return false; });
    Figure figure = block_figure(drawing);
    const auto drawn = [&](const std::vector<Point>& points) {
        Polyline line;
        for (const Point& point : points) {
            line.push_back(upright(PlanePoint<>(point)));
        }
        return line;
    };
    figure.series.emplace_back(
        Line{.points = drawn(failure.left_standing), .legend = "ground left standing", .colour = Colour::black});
    // If the ground lies nowhere below the line from foot to top, there is no knee: the model then puts it half way
    // along that line, where there may be no ground.
    std::vector<Point> ends = failure.surface;
    const bool has_knee = ends.size() != 3 || (ends[1] - (ends[0] + ends[2]) / 2).norm() > 0;
    if (!has_knee) {
        ends.erase(ends.begin() + 1);
    }
    figure.series.emplace_back(Points{.points = drawn(ends),
                                      .legend = has_knee ? "its foot, knee and top" : "its foot and top",
                                      .colour = Colour::blue,
                                      .marker = Marker::filled_square});
    std::vector<Point> cracks;
    for (const CrestCrack& crack : failure.crack) {
        const double x = failure.crest.x() + crack.position;
        const auto after = std::find_if(failure.ground.begin(), failure.ground.end(),
                                        [&](const Point& point) { return point.x() >= x; });
        cracks.emplace_back(x, after == failure.ground.end() ? failure.ground.back().y() : after->y());
    }
    if (!cracks.empty()) {
        figure.series.emplace_back(Points{.points = drawn(cracks),
                                          .legend = "open cracks at the crest",
                                          .colour = Colour::vermilion,
                                          .marker = Marker::filled_triangle});
    }
    return figure;
}

void append_post_failure(const RelaxationSlope* slope, const RelaxationRun& made, const Sheet& sheet) {
    if (slope == nullptr || !made.post_failure || made.post_failure->ground.empty()) {
        return;
    }
    const PostFailure& failure = *made.post_failure;
    sheet.add(Heading{"What failed and what is left standing"});
    if (made.scene.block.size() <= most_drawn_blocks) {
        sheet.draw(left_standing_figure(made, failure, "What failed, and the ground left standing"), "left_standing",
                   made.in_stages
                       ? "The blocks where they were at the start, those that failed marked by the stage in which they "
                         "did: each mass is taken away before the rest has to stand by itself."
                       : "The blocks where they were at the start, with those marked that had left their places at the "
                         "end of the run or were moving. The ground left standing lies lower by what has left.");
    }
    if (made.in_stages) {
        sheet.add(stage_table(made));
    }
    sheet.add(Folded{"Cracks and blocks at the crest", {crack_table(failure, *slope), crest_table(failure)}});
    write_ground(made, failure, sheet.folder);
    write_tables(failure, sheet.folder);
}

}  // namespace delabole
